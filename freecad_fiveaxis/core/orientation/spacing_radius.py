# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far apart the passes of a cutter may stand that is no ball, and what scallop a stepover leaves: that
depends on its axes.

radius    of the ball whose passes may stand as far apart: in a plane across the passes, of the shadow of
          cutter and surface.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import away_from, row_dot
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes import compute_turn, facet_curvature
from freecad_fiveaxis.core.tool import Cutter

from .strategies import AxisOptions, lean_axis

SAME_STAND = 2.0
"""deg; facets whose normals differ by less stand alike under a fixed axis when the passes are spaced."""

FOREMOST_LEAD = 1e-3
"""rad: a bottom that stands square is taken to lean forward by this much: it then touches with its foremost
point, as it sits."""

MOST = 0.99
"""Share of the facets whose curvature along the passes counts; a few slivers bend by anything."""

SETTLED = 8
"""Rounds in which the scallop of a stepover and the radius at its height agree."""

STEEPEST = 0.02
"""Sine: a wall that is steeper to the axis, or faces the passes more squarely, does not count when the passes
are spaced."""


UPRIGHT = 1e-9
"""Sine by which rounding may make an upright wall lean over."""


def spacing_radius(
    cutter: Cutter, mesh: Mesh, keep: Bools, angle: float, strategy: str, options: AxisOptions, scallop: float
) -> float:
    """Return the radius, mm, of the ball whose passes along ``angle`` rad may stand as far apart as this
    cutter's.

    ``keep`` (f,): the facets that are cut. A tool that follows the surface stands alike everywhere; under a
    fixed axis the facet on which the cutter is narrowest counts for all. How the surface bends along the
    passes counts, too. A ball: its radius; a bull nose that leans freely: its corner's.
    """
    if cutter.touches_as_ball:
        return cutter.radius
    if strategy == "from_axis":
        return _radius_around(cutter, mesh, np.flatnonzero(keep), options, scallop)
    travel, normal = np.array((np.cos(angle), np.sin(angle), 0.0)), mesh.normal[keep]
    bend = _bend(facet_curvature(mesh)[:, keep], normal, travel)
    travel = travel if strategy == "fixed" else np.array((1.0, 0.0, 0.0))
    upright = np.array(options.fixed, float) / np.linalg.norm(options.fixed)
    normal = (
        _few(normal, travel, upright, _least_upright(cutter))
        if strategy == "fixed"
        else np.array([[0.0, 0.0, 1.0]])
    )
    axis = np.broadcast_to(upright, normal.shape) if strategy == "fixed" else normal
    radii = [
        np.array([np.inf]),
        *_radii(cutter, normal, axis, np.cross(normal, travel), options, scallop, bend),
    ]
    least = float(np.concatenate(radii).min())
    return max(least, 1.001 * scallop) if np.isfinite(least) else cutter.radius


def _radius_around(cutter: Cutter, mesh: Mesh, rows: Ints, options: AxisOptions, scallop: float) -> float:
    """Return the same of a tool that points at an axis, on the facets ``rows``, for passes around that axis
    and along it: where the surface slants to the axis, the cutter stands on it aslant."""
    about = np.array(options.about, float) / np.linalg.norm(options.about)
    outward, _ = away_from(mesh.vertex[mesh.face[rows]].mean(axis=1), np.array(options.through, float), about)
    radii = [np.array([np.inf])]
    for travel in (np.cross(about, outward), np.broadcast_to(about, outward.shape)):
        normal = mesh.normal[rows]
        way = travel - row_dot(normal, travel)[:, None] * normal
        length = np.linalg.norm(way, axis=1)
        stands = np.flatnonzero((length > STEEPEST) & (row_dot(normal, outward) > STEEPEST))
        if not len(stands):
            continue
        way, normal = way[stands] / length[stands, None], normal[stands]
        bend = float(
            np.quantile(row_dot(compute_turn(facet_curvature(mesh)[:, rows[stands]], way), way), MOST)
        )
        given = np.concatenate([normal, outward[stands], way], axis=1)
        few = np.unique(np.rint(np.degrees(given) / SAME_STAND), axis=0, return_index=True)[1]
        radii += _radii(
            cutter,
            normal[few],
            outward[stands][few],
            np.cross(normal, way)[few],
            options,
            scallop,
            max(bend, 0.0),
        )
    least = float(np.concatenate(radii).min())
    return max(least, 1.001 * scallop) if np.isfinite(least) else cutter.radius


def _radii(
    cutter: Cutter,
    normal: Floats,
    upright: Floats,
    side: Floats,
    options: AxisOptions,
    scallop: float,
    bend: float,
) -> list[Floats]:
    """Return the radii (k,), mm, of the balls that leave the scallop of the cutter, for travel in either
    sense across the unit ``side`` (n, 3), the tool ``upright`` (n, 3) before it is leaned. Where that
    stands along the side, it moves nowhere."""
    radii = []
    for sense in (1.0, -1.0):
        feed = np.cross(side, upright)
        length = np.linalg.norm(feed, axis=1)
        feed /= sense * np.where(length > UPRIGHT, length, np.inf)[:, None]
        axis = lean_axis(upright, feed, options.lead, options.tilt)
        square = np.linalg.norm(axis - normal, axis=1) < FOREMOST_LEAD
        axis[square] = lean_axis(axis[square], feed[square], FOREMOST_LEAD, 0.0)
        stands = (length > UPRIGHT) & (row_dot(axis, normal) > _least_upright(cutter))
        radii.append(cutter.equivalent_radius(normal[stands], axis[stands], side[stands], scallop, bend))
    return radii


def scallop_of(
    cutter: Cutter,
    mesh: Mesh,
    keep: Bools,
    angle: float,
    strategy: str,
    options: AxisOptions,
    stepover: float,
) -> float:
    """About the scallop, mm, that passes ``stepover`` mm apart leave on a flat; other arguments as for
    :func:`spacing_radius`."""
    half, scallop = 0.5 * stepover, 0.125 * stepover**2 / cutter.radius
    for _ in range(1 if cutter.touches_as_ball else SETTLED):
        radius = spacing_radius(cutter, mesh, keep, angle, strategy, options, scallop)
        scallop = radius - float(np.sqrt(max(radius**2 - half**2, 0.0)))
    return scallop


def _bend(tensor: Floats, normal: Floats, travel: Floats) -> float:
    """Return the curvature, 1/mm, along the passes that hardly any facet exceeds, 0 where none is convex."""
    way = travel - (normal @ travel)[:, None] * normal
    length = np.linalg.norm(way, axis=1)
    way = way[length > STEEPEST] / length[length > STEEPEST, None]
    if not len(way):
        return 0.0
    return max(float(np.quantile(row_dot(compute_turn(tensor[:, length > STEEPEST], way), way), MOST)), 0.0)


def _least_upright(cutter: Cutter) -> float:
    """Return the sine above which a wall is not too steep to count: with the flank of a barrel upright walls
    are cut."""
    return STEEPEST if cutter.barrel is None else -UPRIGHT


def _few(normal: Floats, travel: Floats, upright: Floats, least: float) -> Floats:
    """Return normals that stand for all alike, without those that look along the passes or away from the
    tool."""
    key = np.unique(np.rint(np.degrees(normal) / SAME_STAND), axis=0)
    few = key / np.linalg.norm(key, axis=1)[:, None]
    return np.asarray(
        few[(np.linalg.norm(np.cross(few, travel), axis=1) > STEEPEST) & (few @ upright > least)]
    )
