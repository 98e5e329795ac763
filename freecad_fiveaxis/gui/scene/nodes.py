# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes from arrays.

The arrays go to Coin as float32 of shape (n, 3): pivy takes them whole. (It crashes on flat ones.)
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

Colour = tuple[float, float, float]

WHITE = (1.0, 1.0, 1.0)


def vertices(points: np.ndarray, colours: np.ndarray | None = None) -> Any:
    """Points (n, 3), each with its colour 0xRRGGBBAA (n,) where given."""
    made = coin.SoVertexProperty()
    made.vertex.setValues(0, len(points), np.ascontiguousarray(points, np.float32))
    if colours is not None:
        made.orderedRGBA.setValues(0, len(colours), np.ascontiguousarray(colours, np.uint32))
        made.materialBinding = coin.SoVertexProperty.PER_VERTEX
    return made


def lines(points: np.ndarray, each: int = 2, colours: np.ndarray | None = None) -> Any:
    """Lines of ``each`` points; an empty group where there are none."""
    if not len(points):
        return coin.SoGroup()
    made = coin.SoLineSet()
    made.vertexProperty = vertices(points, colours)
    made.numVertices.setValues(0, len(points) // each, np.full(len(points) // each, each, np.int32))
    return made


def points(places: np.ndarray, colours: np.ndarray | None = None) -> Any:
    """Points; their size is that of the draw style before them."""
    made = coin.SoPointSet()
    made.vertexProperty = vertices(places, colours)
    return made


def style(line: float = 1.0, point: float = 1.0, pattern: int = 0xFFFF) -> Any:
    """Width of lines and size of points in pixels; the pattern makes dashes."""
    made = coin.SoDrawStyle()
    made.lineWidth, made.pointSize, made.linePattern = line, point, pattern
    return made


def colour(rgb: Colour, transparency: float = 0.0) -> Any:
    """The colour of what follows."""
    made = coin.SoMaterial()
    made.diffuseColor.setValue(*rgb)
    made.emissiveColor.setValue(*rgb)
    made.transparency = transparency
    return made


def flat() -> Any:
    """What follows is drawn in its own colour, without light."""
    made = coin.SoLightModel()
    made.model = coin.SoLightModel.BASE_COLOR
    return made


def unpickable() -> Any:
    """The mouse does not see what follows: searching a million lines would hold the view up."""
    made = coin.SoPickStyle()
    made.style = coin.SoPickStyle.UNPICKABLE
    return made


def on_top_for_picking() -> Any:
    """The mouse takes what follows before what lies nearer: a marker stands in the part's surface."""
    made = coin.SoPickStyle()
    made.style = coin.SoPickStyle.SHAPE_ON_TOP
    return made


def separate(*children: Any) -> Any:
    """A group whose properties stay within."""
    made = coin.SoSeparator()
    for child in children:
        made.addChild(child)
    return made


def switch(child: Any, on: bool = True) -> Any:
    """A group that can be switched off."""
    made = coin.SoSwitch()
    made.addChild(child)
    turn(made, on)
    return made


def turn(node: Any, on: bool) -> None:
    """Switch a switch."""
    node.whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE


def without_box(child: Any) -> Any:
    """A group that "fit all" does not look at."""
    made = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    made.set("mode EXCLUDE_BBOX")
    made.addChild(child)
    return made


def nearer(depth: float, covers: bool = True) -> Any:
    """What follows is drawn as if it lay nearer by this share of the scene's depth; 1: before everything.

    A path lies in the part's surface, and the picture of that surface is coarser than the path; a tip that leaves its line may
    lie below the surface. ``covers``: whether it hides what is drawn later.
    """
    made = coin.SoDepthBuffer()
    made.write = covers
    made.range.setValue(0.0, 1.0 - depth)
    return made
