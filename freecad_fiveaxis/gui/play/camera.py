# SPDX-License-Identifier: LGPL-2.1-or-later
"""The camera of the view while the player is open: it can follow the tip or show the whole machine, and
stands where it stood afterwards."""

from __future__ import annotations

from typing import Any

import numpy as np


class Camera:
    """The camera of a 3D view."""

    def __init__(self, view: Any) -> None:
        self._view, self._before = view, None

    def follow(self, place: np.ndarray) -> None:
        """Bring ``place`` (3,) mm, as drawn, to the middle of the view, at the focal distance; the camera's
        direction stays."""
        node = self._view.getCameraNode()
        self._before = self._before or self._view.getCamera()
        position = place - node.focalDistance.getValue() * self._along(node)
        node.position.setValue(*(float(part) for part in position))

    def cover(self, low: np.ndarray, high: np.ndarray) -> None:
        """Show the whole box between two corners (3,) mm, as drawn; the camera's direction stays."""
        from pivy import coin

        self._before = self._before or self._view.getCamera()
        width, height = self._view.getSize()
        box = coin.SbBox3f(*(float(part) for part in (*low, *high)))
        self._view.getCameraNode().viewBoundingBox(box, width / max(height, 1), 1.0)

    def restore(self) -> None:
        """Where it stood before it first followed or covered; where it never did, it stays."""
        if self._before is not None:
            self._view.setCamera(self._before)
            self._before = None

    @staticmethod
    def _along(node: Any) -> np.ndarray:
        from pivy import coin

        return np.array(node.orientation.getValue().multVec(coin.SbVec3f(0.0, 0.0, -1.0)).getValue())
