# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where panels of FreeCAD 1.0 and later lie over the view (*overlays*): what is placed there would not be
seen."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, main_window

from .layout import NONE

NAMES = ("OverlayLeft", "OverlayRight", "OverlayTop", "OverlayBottom")
"""What FreeCAD calls them. Asked for by name, so that PySide makes no objects for other widgets, which may go
before these do."""


def find_covered_boxes(size: tuple[int, int]) -> np.ndarray:
    """Find the boxes (n, 4) pixels that panels cover of the active view, if it has ``size`` (width and
    height) pixels."""
    shown = [panel for panel in _overlays() if panel.isVisible()]
    viewport = _viewport() if shown else None
    if viewport is None:
        return NONE
    scale = size[0] / max(viewport.width(), 1)  # pixels of the screen for one of Qt's
    if abs(viewport.height() * scale - size[1]) > 2.0:
        return NONE
    return np.array([_box(panel, viewport) for panel in shown], float).reshape(-1, 4) * scale


@cache
def _overlays() -> list[Any]:
    """FreeCAD makes them with its window, and keeps them."""
    found = (main_window().findChild(QtWidgets.QTabWidget, name) for name in NAMES)
    return [one for one in found if one is not None]


def _viewport() -> Any:
    """Return the widget that draws the active view; None where another window is active."""
    area = main_window().findChild(QtWidgets.QMdiArea)
    window = area.currentSubWindow() if area is not None else None
    drawn = window.findChild(QtWidgets.QGraphicsView) if window is not None else None
    return drawn.viewport() if drawn is not None else None


def _box(panel: Any, viewport: Any) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of a panel, from the lower left corner of the view."""
    corner = viewport.mapFromGlobal(panel.mapToGlobal(QtCore.QPoint(0, 0)))
    top = viewport.height() - corner.y()
    return corner.x(), top - panel.height(), corner.x() + panel.width(), top
