# SPDX-License-Identifier: LGPL-2.1-or-later
"""The only place that imports Qt: one set of names for PySide2 (FreeCAD 0.20) and PySide6 (1.1).

translate      FreeCAD's own: ``translate("FiveAxis", "text")`` in the user's language.
QT_TRANSLATE_NOOP   marks a text that FreeCAD itself translates later (menu texts, tool tips).
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import FreeCAD
from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:  # 0.20: FreeCAD's PySide has the widgets in QtGui
    QtWidgets = QtGui

__all__ = ["QT_TRANSLATE_NOOP", "QtCore", "QtGui", "QtWidgets"]

translate = FreeCAD.Qt.translate

TRIES = 1000
"""More widgets than any panel that was closed can have had."""


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Return the text itself; lupdate finds it by this name."""
    return text


_window: list[Any] = []


def main_window() -> Any:
    """FreeCAD's main window, always the same Python object: what is made with it as parent lives as long as
    that object does."""
    if not _window:
        import FreeCADGui

        _window.append(FreeCADGui.getMainWindow())
    return _window[0]


def execute(dialog: Any) -> int:
    """Run a dialog until it is closed. PySide2 spells it ``exec_``, PySide6 ``exec``."""
    return int((getattr(dialog, "exec", None) or dialog.exec_)())


def flags(value: Any) -> int:
    """Qt flags as the whole number that FreeCAD's task view asks for."""
    return int(getattr(value, "value", value))


def create(name: str) -> Any:
    """Return a widget of FreeCAD's own, as ``Gui::QuantitySpinBox``. Raises RuntimeError where this FreeCAD
    has none.

    FreeCAD deletes the widgets of a closed panel without PySide's knowledge, and PySide knows widgets by
    their address: a new one may come as the old Python object of one that stood there, dead or soon to be. It
    is left in its place, unused, so that the next one comes to stand elsewhere.
    """
    import FreeCADGui

    loader = FreeCADGui.UiLoader()
    for _ in range(TRIES):
        widget = loader.createWidget(name)
        if widget is not None and _is_new(widget):
            widget.already_created = True
            return widget
    raise RuntimeError(f"this FreeCAD makes no widget {name}")


def _is_new(widget: Any) -> bool:
    try:
        widget.objectName()
    except RuntimeError:  # PySide: already deleted
        return False
    return not hasattr(widget, "already_created")


def later(work: Callable[[], Any]) -> None:
    """Do it when the window is idle again: a dialog must not close while one of its own signals is on the
    way."""
    QtCore.QTimer.singleShot(0, work)


def resource(*parts: str) -> str:
    """Return the path of a file in ``resources``: in the package when it is installed, beside it in the
    source tree."""
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    inside = os.path.join(package, "resources")
    return os.path.join(
        inside if os.path.isdir(inside) else os.path.join(os.path.dirname(package), "resources"), *parts
    )


def icon(name: str) -> str:
    """Return the path of an icon; the workbench's own where that one is not there."""
    path = resource("icons", name + ".svg")
    return path if os.path.isfile(path) else resource("icons", "fiveaxis.svg")
