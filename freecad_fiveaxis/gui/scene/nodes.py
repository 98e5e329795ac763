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
    properties = coin.SoVertexProperty()
    properties.vertex.setValues(0, len(points), np.ascontiguousarray(points, np.float32))
    if colours is not None:
        properties.orderedRGBA.setValues(0, len(colours), np.ascontiguousarray(colours, np.uint32))
        properties.materialBinding = coin.SoVertexProperty.PER_VERTEX
    return properties


def lines(points: np.ndarray, each: int = 2, colours: np.ndarray | None = None) -> Any:
    """Lines of ``each`` points; an empty group where there are none."""
    if not len(points):
        return coin.SoGroup()
    line_set = coin.SoLineSet()
    line_set.vertexProperty = vertices(points, colours)
    line_set.numVertices.setValues(0, len(points) // each, np.full(len(points) // each, each, np.int32))
    return line_set


def points(places: np.ndarray, colours: np.ndarray | None = None) -> Any:
    """Points; their size is that of the draw style before them."""
    point_set = coin.SoPointSet()
    point_set.vertexProperty = vertices(places, colours)
    return point_set


def style(line: float = 1.0, point: float = 1.0, pattern: int = 0xFFFF) -> Any:
    """Width of lines and size of points in pixels; the pattern makes dashes."""
    draw_style = coin.SoDrawStyle()
    draw_style.lineWidth, draw_style.pointSize, draw_style.linePattern = line, point, pattern
    return draw_style


def colour(rgb: Colour, transparency: float = 0.0) -> Any:
    """Return the colour of what follows."""
    material = coin.SoMaterial()
    material.diffuseColor.setValue(*rgb)
    material.emissiveColor.setValue(*rgb)
    material.transparency = transparency
    return material


def flat() -> Any:
    """Return what follows is drawn in its own colour, without light."""
    light_model = coin.SoLightModel()
    light_model.model = coin.SoLightModel.BASE_COLOR
    return light_model


def unpickable() -> Any:
    """Return the mouse does not see what follows: searching a million lines would hold the view up."""
    pick_style = coin.SoPickStyle()
    pick_style.style = coin.SoPickStyle.UNPICKABLE
    return pick_style


def on_top_for_picking() -> Any:
    """Return the mouse takes what follows before what lies nearer: a marker stands in the part's surface."""
    pick_style = coin.SoPickStyle()
    pick_style.style = coin.SoPickStyle.SHAPE_ON_TOP
    return pick_style


def separate(*children: Any) -> Any:
    """Return a group whose properties stay within."""
    separator = coin.SoSeparator()
    for child in children:
        separator.addChild(child)
    return separator


def switch(child: Any, on: bool = True) -> Any:
    """Return a group that can be switched off."""
    node = coin.SoSwitch()
    node.addChild(child)
    turn(node, on)
    return node


def turn(node: Any, on: bool) -> None:
    """Switch a switch."""
    node.whichChild = coin.SO_SWITCH_ALL if on else coin.SO_SWITCH_NONE


def choice(*children: Any) -> Any:
    """Return a group of which one child is drawn, the first to begin with."""
    node = coin.SoSwitch()
    for child in children:
        node.addChild(child)
    choose(node, 0)
    return node


def choose(node: Any, child: int) -> None:
    """Draw another child of a choice. A choice that stays is not touched: what is cached of it stays too."""
    if get_choice(node) != child:
        node.whichChild = child


def get_choice(node: Any) -> int:
    """Return which child of a choice is drawn."""
    return int(node.whichChild.getValue())


def without_box(child: Any) -> Any:
    """Return a group that "fit all" does not look at."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    group.set("mode EXCLUDE_BBOX")
    group.addChild(child)
    return group


def nearer(depth: float, covers: bool = True) -> Any:
    """Return what follows is drawn as if it lay nearer by this share of the scene's depth; 1: before
    everything.

    A path lies in the part's surface, and the picture of that surface is coarser than the path; a tip that
    leaves its line may lie below the surface. ``covers``: whether it hides what is drawn later.
    """
    depth_buffer = coin.SoDepthBuffer()
    depth_buffer.write = covers
    depth_buffer.range.setValue(0.0, 1.0 - depth)
    return depth_buffer
