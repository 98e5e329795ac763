# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs of a CL file, divided into chords.

arc       from the row before to its own row, right-handed about ``normal``; a helix where the heights along
          the normal differ.
sagitta   the largest distance of a chord from its arc: ``r (1 - cos(angle / 2))``.

The printed digits leave the ends a little off the circle. The radius therefore goes evenly from that of the
start to that of the end, so that the first chord starts and the last one ends exactly on the rows of the
file.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze, run_ids
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM, NO_DIRECTION, slerp

FIT = 0.01
"""mm by which an end may be off its circle: several times what four printed decimals of a centre and a
radius, in inches, leave open."""
NEAR = 0.002
"""mm; ends that are nearer than this, and not the same, may mean next to nothing or a whole turn."""
LEAST_RADIUS = 10.0 * NEAR
"""mm; for smaller circles near ends are nothing unusual."""
MOST_ANGLE = np.pi / 2.0
"""rad; no chord spans more, however small the circle."""
AGAINST = -0.9
"""Cosine of two directions that run against each other."""


@dataclass(frozen=True, eq=False)
class Arcs:
    """``row`` (a,) where each ends, ascending; ``centre`` (a, 3) mm; ``normal`` (a, 3) unit, ``radius`` (a,)
    mm as said; ``statement`` (a,) its number; ``turns`` (a,) whole ones beyond the way to its end."""

    row: Ints
    centre: Floats
    normal: Floats
    radius: Floats
    statement: Ints
    turns: Floats

    def __post_init__(self) -> None:
        freeze(self, None, row="i", centre="f3", normal="f3", radius="f", statement="i", turns="f")

    def take(self, which: Ints | Bools) -> Arcs:
        """Return some of them."""
        names = ("row", "centre", "normal", "radius", "statement", "turns")
        return Arcs(*(getattr(self, name)[which] for name in names))


@dataclass(frozen=True, eq=False)
class ArcSpans:
    """How each arc runs: ``start``, ``end`` (a, 3) mm from the axis of the circle, in its plane; ``height``
    (a, 2) mm of both over the centre; ``sweep`` (a,) rad, above 0: at most a whole turn, and the further
    ones."""

    start: Floats
    end: Floats
    height: Floats
    sweep: Floats


def arc_spans(arcs: Arcs, tip: Floats) -> ArcSpans:
    """Return the arcs between the rows of ``tip`` (n, 3)."""
    both = tip[arcs.row[:, None] - (1, 0)] - arcs.centre[:, None]
    height = (both * arcs.normal[:, None]).sum(axis=2)
    start, end = np.moveaxis(both - height[..., None] * arcs.normal[:, None], 1, 0)
    sine = (np.cross(start, end) * arcs.normal).sum(axis=1)
    sweep = np.mod(np.arctan2(sine, (start * end).sum(axis=1)), 2.0 * np.pi)
    same = np.linalg.norm(end - start, axis=1) <= COINCIDENT_MM
    return ArcSpans(
        start, end, height, np.where(same | (sweep <= 0.0), 2.0 * np.pi, sweep) + 2.0 * np.pi * arcs.turns
    )


def misfit(arcs: Arcs, spans: ArcSpans) -> Floats:
    """mm (a,) by which the worse end of each arc is off its circle."""
    radii = np.linalg.norm(np.stack([spans.start, spans.end]), axis=2)
    worst: Floats = np.abs(radii - arcs.radius).max(axis=0)
    return worst


def ambiguous(arcs: Arcs, spans: ArcSpans) -> Bools:
    """Which arcs may mean next to nothing as well as a whole turn."""
    apart = np.linalg.norm(spans.end - spans.start, axis=1)
    near: Bools = (apart > COINCIDENT_MM) & (apart <= NEAR) & (arcs.radius >= LEAST_RADIUS)
    return near


def runs_back(arcs: Arcs, spans: ArcSpans, tip: Floats, straight: Bools) -> tuple[Bools, Bools]:
    """Which arcs (a,) set out against the straight move before them, and arrive against the one after;
    ``straight`` (n,) the rows that straight feed moves end at. One of both is enough where the other is no
    straight feed move. And which do not."""
    against, along = np.zeros(len(arcs.row), np.bool_), np.zeros(len(arcs.row), np.bool_)
    for place, row in ((spans.start, arcs.row - 1), (spans.end, arcs.row + 1)):
        there = (row > 0) & (row < len(tip))
        at = np.where(there, row, 1)
        way = tip[at] - tip[at - 1]
        length = np.linalg.norm(way, axis=1)
        tangent = np.cross(arcs.normal, place)
        cosine = (way * tangent).sum(axis=1) / np.maximum(length * np.linalg.norm(tangent, axis=1), 1e-300)
        judged = there & straight[at] & (length > NEAR)
        against |= judged & (cosine < AGAINST)
        along |= judged & (cosine >= AGAINST)
    return against & ~along, along


def chord_counts(arcs: Arcs, spans: ArcSpans, sagitta: float) -> Ints:
    """Into how many chords (a,) each arc is divided, so that none is off by more than ``sagitta`` mm."""
    radius = np.maximum(np.linalg.norm(spans.start, axis=1), np.linalg.norm(spans.end, axis=1))
    half = np.arcsin(
        np.sqrt(np.minimum(sagitta / np.maximum(2.0 * radius, 1e-300), 1.0))
    )  # of a half chord's angle
    count = np.ceil(spans.sweep / np.minimum(4.0 * half, MOST_ANGLE) - 1e-9)
    whole: Ints = np.maximum(count, 1.0).astype(np.int64)
    return whole


def inner_ends(arcs: Arcs, spans: ArcSpans, count: Ints, axis: Floats) -> tuple[Ints, Floats, Floats]:
    """Return the chords' ends but the last of each arc: the row (m,) before which each stands, its place (m,
    3) mm and its tool axis (m, 3), turned evenly from that of the row before, of ``axis`` (n, 3), to that of
       its
    own."""
    inner = count - 1
    arc = np.flatnonzero(inner > 0)
    of = arc[run_ids(inner[arc])] if len(arc) else arc
    step = np.arange(len(of)) - (np.cumsum(inner) - inner)[of] + 1
    share = (step / count[of])[:, None]
    radius = np.linalg.norm(spans.start, axis=1), np.linalg.norm(spans.end, axis=1)
    out = spans.start / np.maximum(radius[0], 1e-300)[:, None]
    ahead = np.cross(arcs.normal, out)
    angle = share * spans.sweep[of, None]
    here = radius[0][of, None] * (1.0 - share) + radius[1][of, None] * share
    height = spans.height[of, :1] * (1.0 - share) + spans.height[of, 1:] * share
    place = (
        arcs.centre[of]
        + height * arcs.normal[of]
        + here * (np.cos(angle) * out[of] + np.sin(angle) * ahead[of])
    )
    row = arcs.row[of]
    return row, place, _turn_evenly(axis[row - 1], axis[row], share)


def _turn_evenly(first: Floats, last: Floats, share: Floats) -> Floats:
    """Return the axes (m, 3) at ``share`` (m, 1) of the great arc between ``first`` and ``last`` (m, 3);
    opposite ones stay first."""
    opposite = np.linalg.norm(first + last, axis=1, keepdims=True) <= NO_DIRECTION
    return np.where(opposite, first, slerp(first, last, share[:, 0]))
