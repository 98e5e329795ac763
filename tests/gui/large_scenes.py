# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path of a million blocks and a map of many facets, for tests of the 3D view and for its benchmarks."""

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge import RestMaterial
from freecad_fiveaxis.core.report import draw
from freecad_fiveaxis.core.report.drawing import STROKES, _pair_ends, _stroke_ends
from freecad_fiveaxis.core.report.thinning import COATS
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.gui.scene import marks, nodes, path_nodes, words


class Frames:
    """Counts how often the view is really drawn while its ``node`` is in it: Coin comes once for the scene,
    and where something is drawn over everything else, once more."""

    def __init__(self):
        self.node, self.count = nodes.coin.SoCallback(), 0
        self.node.setCallback(self._drawn)

    def _drawn(self, _data, action):
        if action.isOfType(nodes.coin.SoGLRenderAction.getClassTypeId()):
            drawing = (
                action
                if hasattr(action, "isRenderingDelayedPaths")
                else nodes.coin.cast(action, "SoGLRenderAction")
            )
            self.count += not drawing.isRenderingDelayedPaths()


def long_path(count):
    """The strokes of a path of so many blocks, as the core thins them, and their levels: a spiral, every
    thousandth block over the tolerance."""
    turn = np.linspace(0.0, 400.0 * np.pi, count + 1)
    radius = 60.0 * np.linspace(1.0, 0.02, count + 1)
    points = np.column_stack([radius * np.cos(turn), radius * np.sin(turn), 0.01 * (60.0**2 - radius**2)])
    start, end = _stroke_ends(np.arange(1, count + 1), np.full(count + 1, Motion.CUT), STROKES)
    level = 0.5 * np.abs(np.sin(turn[end] * 3.0))
    level[::1000] = 0.9
    return _pair_ends(points[start - 1], points[end]), level


def _all_cut(level):
    """All strokes cut, and are drawn at any size."""
    return {"cut": np.ones(len(level), bool), "coat": np.full(len(level), COATS)}


def picture_of_long(figures, look, pairs, level):
    """The whole picture of these strokes: with the axes, curves and legend of the figures, and 1000 marks."""
    drawing = replace(
        draw(figures),
        stroke=pairs,
        level=level,
        block=np.arange(len(level)),
        deviation=level,
        **_all_cut(level),
    )
    picture = path_nodes.PathNodes()
    picture.show(drawing, look)
    places = np.resize(pairs, (1000, 3))
    picture.marks.show(places, [marks.OVER, marks.SINGULAR] * 500, look.bad, look.bad, look.singular, 7.0)
    picture.legend.show(words.legend_of("Path", figures, look, ""))
    return picture


def surface(side):
    """A bumpy surface of 2 x side x side facets, and heights over it."""
    x, y = np.meshgrid(np.linspace(0.0, 100.0, side + 1), np.linspace(0.0, 100.0, side + 1), indexing="ij")
    vertex = np.stack([x, y, 5.0 * np.sin(x / 14.0) * np.cos(y / 20.0)], axis=-1).reshape(-1, 3)
    corner = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    face = np.concatenate([corner[:, None] + [0, side + 1, side + 2], corner[:, None] + [0, side + 2, 1]])
    mesh = from_triangles(vertex[face])
    middle = vertex[face].mean(axis=1)
    height = 0.2 * np.sin(middle[:, 0] / 5.0)
    return mesh, RestMaterial(
        middle, np.arange(len(face)), np.ones(len(face)), height, np.zeros(len(face), np.int64), 1e3
    )
