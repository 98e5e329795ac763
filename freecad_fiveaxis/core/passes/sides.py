# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides of the part that no pass touches, because the planes stand along them; what would cut them.

across      horizontal direction from plane to plane, as in :mod:`.spacing`.
along       a facet whose normal leans little from ``across``: the planes stand along it, so that few of them
            cut it, or none.
side        facets along the planes that no pass touches and that hang together. It is told where it is wider
            than passes may lie apart, and no strip.
strip       what lies between two passes over one and the same surface, however steep that is.
width       of a side: its area by its length, along the travel or upwards, whichever is larger.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import (
    Angle,
    Area,
    Length,
    Point,
    Sentence,
    Template,
    beginning,
    join_sentences,
    say,
)
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .scallop import CREASE

ALONG = math.cos(math.radians(30.0))
"""Least cosine between normal and ``across`` of a facet along the planes: passes over it lie two intervals
apart, or more."""

UP = np.array((0.0, 0.0, 1.0))

WIDE = 2.0
"""A side is wider than so many intervals of a flat."""

PLUMB = math.cos(math.radians(10.0))
"""Least cosine, likewise, of facets that a direction is not proposed for."""

BETTER = 0.5
"""A direction is proposed that leaves at most this share of the area along its planes that the present one
has."""

STRIP = 0.3
"""Of the planes' distance: a strip reaches over more of it."""

SHARE = 0.002
"""Of the area to be cut: sides that are smaller are not told."""

MOST = 6
"""So many sides are told, the largest first."""

STRAIGHT = math.cos(math.radians(5.0))
"""Least cosine of a direction that is told as that of an axis."""

TURNS = (90.0, 45.0, 135.0, 60.0, 120.0, 30.0, 150.0)
"""deg from the present direction: those that are proposed, in this order where they cut equally much."""

DECIMALS = 3
"""Of coordinates and directions that are told."""

OUTER = 0.01
"""Of the part's size: a side no farther than that from its end is its outer side."""

BESIDE = 3.0
"""Least intervals; a pass that is nearer to a side is beside it."""


class Side(NamedTuple):
    """``area`` mm2; ``normal`` (3,) unit; ``place`` (3,) mm on it; ``low`` and ``high`` mm: where it lies
    along ``across``; ``leans``: most of it does, so that planes near enough to each other cut it."""

    area: float
    normal: Floats
    place: Floats
    low: float
    high: float
    leans: bool


def find_untouched_sides(
    mesh: Mesh, keep: Bools, touched: Ints, planes: Floats, angle: float, interval: float
) -> tuple[Side, ...]:
    """Return the sides that passes along ``angle`` rad leave out, the largest first.

    ``keep`` (f,): the facets that are to be cut; ``touched`` (n,): those that passes touch; ``planes`` (k,)
    mm, ascending; ``interval`` mm of a flat.
    """
    travel, across = _directions(angle)
    out = keep & (np.abs(mesh.normal @ across) > ALONG)
    out[touched] = False
    rows = np.flatnonzero(out)
    if not len(rows):
        return ()
    number = number_connected(mesh, out, rows)
    area = np.bincount(number, mesh.area[rows])
    length = np.maximum(*(_extent((mesh.vertex @ way)[mesh.face[rows]], number) for way in (travel, UP)))
    wide = (area > SHARE * mesh.area[keep].sum()) & (area > WIDE * interval * length)
    order = np.argsort(-area, kind="stable")
    parts = [rows[number == one] for one in order[wide[order]].tolist()]
    sides = [(part, _side(mesh, part, across)) for part in parts]
    return tuple(side for part, side in sides if not _is_strip(mesh, keep, part, side, planes, across))[:MOST]


def _directions(angle: float) -> tuple[Floats, Floats]:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array((cosine, sine, 0.0)), np.array((-sine, cosine, 0.0))


def _extent(value: Floats, number: Ints) -> Floats:
    """Largest less least value of each side; ``value`` (k, 3) at the corners of the facets, ``number`` (k,)
    their sides."""
    low, high = np.full(number.max() + 1, np.inf), np.full(number.max() + 1, -np.inf)
    np.minimum.at(low, number, value.min(axis=1))
    np.maximum.at(high, number, value.max(axis=1))
    extent: Floats = high - low
    return extent


def number_connected(mesh: Mesh, out: Bools, rows: Ints) -> Ints:
    """Return the number (k,) of the side that each of the facets ``rows`` (k,), where ``out`` (f,) is True,
    belongs to."""
    pair = mesh.coedge_face[mesh.coedge_face[:, 1] >= 0]
    pair = pair[out[pair].all(axis=1)]
    at = np.full(len(out), -1)
    at[rows] = np.arange(len(rows))
    one, other = at[pair].T
    graph = scipy.sparse.coo_matrix((np.ones(len(pair)), (one, other)), shape=(len(rows), len(rows)))
    number: Ints = scipy.sparse.csgraph.connected_components(graph, directed=False)[1].astype(np.int64)
    return number


def _side(mesh: Mesh, rows: Ints, across: Floats) -> Side:
    area, corner = mesh.area[rows], mesh.vertex[mesh.face[rows]]
    middle = corner.mean(axis=1)
    normal = area @ mesh.normal[rows]
    nearest = np.linalg.norm(middle - area @ middle / area.sum(), axis=1).argmin()
    normal /= np.linalg.norm(normal)
    offset = corner @ across
    leaning = float(area[np.ptp(offset, axis=1) > 10.0**-DECIMALS].sum())
    whole, low, high = float(area.sum()), float(offset.min()), float(offset.max())
    return Side(whole, normal, middle[nearest], low, high, leaning > 0.5 * whole)


def _is_strip(mesh: Mesh, keep: Bools, rows: Ints, side: Side, planes: Floats, across: Floats) -> bool:
    """Whether these facets fill much of the way between two planes, and to both sides the surface goes on
    without an edge."""
    at = int(np.searchsorted(planes, 0.5 * (side.low + side.high)))
    if (
        not side.leans
        or not 0 < at < len(planes)
        or side.high - side.low < STRIP * (planes[at] - planes[at - 1])
    ):
        return False
    inside = np.zeros(len(keep), np.bool_)
    inside[rows] = True
    pair = mesh.coedge_face[(mesh.coedge_face[:, 1] >= 0) & keep[mesh.coedge_face].all(axis=1)]
    pair = pair[inside[pair[:, 0]] != inside[pair[:, 1]]]
    one, other = mesh.normal[pair[:, 0]], mesh.normal[pair[:, 1]]
    pair = pair[(one * other).sum(axis=1) > math.cos(CREASE)]
    offset = (mesh.vertex @ across)[mesh.face[pair[~inside[pair]]]].mean(axis=1) - 0.5 * (
        side.low + side.high
    )
    return bool((offset < 0.0).any() and (offset > 0.0).any())


# --------------------------------------------------------------------------------------- what is said of them


def side_findings(
    sides: tuple[Side, ...],
    mesh: Mesh,
    keep: Bools,
    angle: float,
    spacing: tuple[Finding, ...],
    least: float,
    finer: str,
) -> tuple[Finding, ...]:
    """``spacing``, what was poor about the planes, with a warning for each side and its remedy. A least
    interval, ``least`` mm, that binds beside a side binds because of it, and is told there. ``finer``: the
    setting that brings more planes."""
    beside = [one for one in spacing if _is_beside(one, sides, angle, BESIDE * least)]
    others = tuple(one for one in spacing if one not in beside)
    return (*others, *(_finding(side, mesh, keep, angle, beside, finer) for side in sides))


def _is_beside(one: Finding, sides: tuple[Side, ...], angle: float, near: float) -> bool:
    if one.code != Code.LEAST_INTERVAL or one.place is None:
        return False
    offset = float(_directions(angle)[1] @ one.place)
    return any(side.low - near <= offset <= side.high + near for side in sides)


def _finding(side: Side, mesh: Mesh, keep: Bools, angle: float, beside: list[Finding], finer: str) -> Finding:
    x, y, z = side.place.tolist()
    name = side_name(mesh, side.normal, side.place)
    lost = say("{side} is not machined: {area}.", side=beginning(name), area=Area(side.area, ".4g"))
    text = join_sentences((lost, _remedy(side, mesh, keep, angle, finer)))
    if beside and beside[0].value is not None:
        text += say(
            " Beside it up to {height} is left between the passes.", height=Length(beside[0].value, ".4g")
        )
    return report_finding(Code.SIDE_NOT_MACHINED, text, side.area, 0.0, place=(x, y, z))


def side_name(mesh: Mesh, normal: Floats, place: Floats) -> Sentence:
    """Return what a side is called by its normal (3,) and a place (3,) mm on it: the side, or a wall, at a
    coordinate, or the way it faces."""
    axis = int(np.abs(normal[:2]).argmax())
    if abs(normal[axis]) < STRAIGHT:
        facing = math.degrees(math.atan2(normal[1], normal[0])) % 360.0
        x, y, z = place.tolist()
        return say(
            "the side that faces {way} at {place}", way=Angle(facing, ".0f"), place=Point((x, y, z), ".4g")
        )
    at = round(float(place[axis]), DECIMALS) + 0.0
    outermost = float(mesh.vertex[:, axis].max() if normal[axis] > 0.0 else mesh.vertex[:, axis].min())
    outer = abs(outermost - at) <= OUTER * float(np.ptp(mesh.vertex[:, axis]))
    values = {"letter": "XY"[axis], "at": Length(at, bare=True)}
    return say("the side at {letter} {at}", **values) if outer else say("the wall at {letter} {at}", **values)


ALONG_X = Template("passes along X, in direction {angle}")
ALONG_Y = Template("passes along Y, in direction {angle}")
SLANTING = Template("passes in direction {angle}")


def _remedy(side: Side, mesh: Mesh, keep: Bools, angle: float, finer: str) -> Sentence:
    """Return the direction of passes that cuts the side and has the least area along its planes, the first of
    TURNS among equals, where that is a gain or nothing else helps; nearer planes, where those cut it."""
    turned = [(math.degrees(angle) + turn) % 180.0 for turn in TURNS]
    able = [one for one in turned if abs(side.normal @ _directions(math.radians(one))[1]) < ALONG]
    lost = [_area_along(mesh, keep, math.radians(one)) for one in able]
    best, rest = min(zip(able, lost, strict=True), key=lambda pair: round(pair[1], DECIMALS))
    named = {0.0: ALONG_X, 90.0: ALONG_Y}.get(round(best, DECIMALS), SLANTING)
    turn = not side.leans or rest <= BETTER * _area_along(mesh, keep, angle)
    ways: list[str] = [named.say(angle=Angle(best, ".4g"))] * turn + [finer] * side.leans
    either = say("{one} or {other}", one=ways[0], other=ways[1]) if len(ways) > 1 else ways[0]
    if rest == 0.0 or not turn:
        return say("{ways} would cut it.", ways=beginning(either))
    return say(
        "{ways} would cut it; cut the {area} that lie along those passes with another path.",
        ways=beginning(either),
        area=Area(rest, ".4g"),
    )


def _area_along(mesh: Mesh, keep: Bools, angle: float) -> float:
    return float(mesh.area[keep & (np.abs(mesh.normal @ _directions(angle)[1]) > PLUMB)].sum())
