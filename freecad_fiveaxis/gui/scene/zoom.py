# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large the scene is seen: a node that tells it before each frame, so that less is drawn where there is
no room."""

from __future__ import annotations

import weakref
from typing import Any

import numpy as np
from pivy import coin

from . import layout
from .on_screen import clip_from_place

_STEPS = np.concatenate([np.zeros((1, 3)), np.eye(3)])


class Zoom:
    """Calls ``watcher.zoom_to(pixels_per_mm)`` before each frame; ``root`` stands in the scene before what
    depends on it.

    ``middle`` (3,) mm: where it is measured. What the watcher changes must not ask for the next frame
    (``enableNotify``).
    """

    def __init__(self, watcher: Any) -> None:
        self.watcher, self.middle, self.root = weakref.ref(watcher), np.zeros(3), coin.SoCallback()
        self.root.setCallback(_measure, weakref.ref(self))


def _measure(zoom: Any, action: Any) -> None:
    """Coin comes here whenever anything goes through the scene."""
    found = zoom()
    watcher = None if found is None else found.watcher()
    if watcher is None or not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        return
    drawing = action if hasattr(action, "getViewportRegion") else coin.cast(action, "SoGLRenderAction")
    pixels = drawing.getViewportRegion().getViewportSizePixels()
    spots = layout.project_places(
        found.middle + _STEPS, clip_from_place(drawing.getState()), (int(pixels[0]), int(pixels[1]))
    )
    watcher.zoom_to(largest_scale(spots))


def largest_scale(spots: np.ndarray) -> float:
    """Pixels for a millimetre across the view, from where a place and those 1 mm beside it along x, y and z
    are seen (4, 2); infinite where that is behind the eye."""
    steps = spots[1:] - spots[0]
    return float(np.linalg.norm(steps, 2)) if np.isfinite(steps).all() else np.inf
