# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving the view to a place."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import FreeCADGui
from pivy import coin


def look_at(doc: Any, place: Sequence[float], reach: float) -> None:
    """Put a place of the document into the middle of its 3D view, with ``reach`` mm to be seen about it.

    The direction of the view stays. Nothing happens where the document shows no 3D view.
    """
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    if not hasattr(view, "getCameraNode"):
        return
    camera = view.getCameraNode()
    forward = camera.orientation.getValue().multVec(coin.SbVec3f(0.0, 0.0, -1.0))
    if isinstance(camera, coin.SoPerspectiveCamera):
        camera.focalDistance = 0.5 * reach / math.tan(0.5 * camera.heightAngle.getValue())
    else:
        camera.height = reach
    camera.position = coin.SbVec3f(*place) - forward * camera.focalDistance.getValue()
