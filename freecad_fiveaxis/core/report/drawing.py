# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays that a 3D view draws, and the numbers behind one block that somebody points at.

stroke  a straight line of the picture: the chord of a feed block, or of several neighbouring ones where a program has more
        than STROKES; it has the deviation of the worst of its blocks.
level   the deviation on a logarithmic scale about the tolerance: 0.5 is the tolerance, 0 a hundredth of it, 1 a hundred
        times it; what lies beyond is at the end of the scale.
curve   the way that the tip really takes in a block, beside its chord; spoke: from the chord to the curve where they are
        farthest apart.
spot    one block that is worth a look, in numbers.

All places are in the work frame, mm.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.cl.cl_path import Motion
from freecad_fiveaxis.core.collision import GOUGES
from freecad_fiveaxis.core.machine import fitted_columns
from freecad_fiveaxis.core.motion.trajectory import tip_at

from .figures import Figures
from .judgement import OVER, SINGULAR, UNPROVEN
from .markers import Marker, markers

STROKES = 600_000
"""Beyond this many a view without a graphics card no longer follows the mouse."""
CURVE_POINTS = 129
RAPID_POINTS = 17
RAPIDS = 5_000
"""At most so many rapids are drawn, evenly chosen."""
AXES_ACROSS = 26
"""At most one tool axis is drawn in each cube of the part's longest side divided by this: more hide each other."""
LARGEST = "largest-deviation"
"""The kind of the first marker."""
DECADES = 2.0
"""Powers of ten from the tolerance to either end of the scale."""


@dataclass(frozen=True, eq=False)
class Drawing:
    """What a view shows of a program.

    ``stroke`` (2k, 3): start and end of every stroke in turn; ``block`` (k,) the worst of its blocks, ``deviation`` (k,) mm
    and ``level`` (k,) of that. ``rapid`` (2r, 3): strokes along the real way of the rapids. ``foot``, ``axis`` (a, 3): tip
    and unit axis of the tools drawn, which stand ``axis_length`` mm high. ``curve`` (w CURVE_POINTS, 3), ``chord`` (2w, 3) and
    ``spoke`` (2w, 3) of the worst blocks ``worst`` (w,). ``low``, ``high`` (3,) the box of the feed blocks.
    """

    tolerance: float
    stroke: Floats
    block: Ints
    deviation: Floats
    level: Floats
    rapid: Floats
    foot: Floats
    axis: Floats
    axis_length: float
    worst: Ints
    curve: Floats
    chord: Floats
    spoke: Floats
    low: Floats
    high: Floats
    markers: tuple[Marker, ...]

    def __post_init__(self) -> None:
        k, w = len(self.block), len(self.worst)
        freeze(self, k, block="i", deviation="f", level="f")
        freeze(self, 2 * k, stroke="f3")
        freeze(self, None, rapid="f3")
        freeze(self, None, foot="f3", axis="f3")
        freeze(self, w, worst="i")
        freeze(self, 2 * w, chord="f3", spoke="f3")
        freeze(self, CURVE_POINTS * w, curve="f3")
        freeze(self, 3, low="f", high="f")


@dataclass(frozen=True)
class Spot:
    """One feed block in numbers: mm and degrees. ``turns``: the letters of the rotary axes and how far each turns in the
    block; ``lean`` how far the tool axis leans meanwhile; ``step`` the length of the chord; ``place`` the real tip where it is
    farthest from the chord."""

    block: int
    line: int
    deviation: float
    bound: float
    tolerance: float
    singular: bool
    turns: tuple[tuple[str, float], ...]
    lean: float
    step: float
    place: tuple[float, float, float]


def draw(figures: Figures, strokes: int = STROKES) -> Drawing:
    """The picture of a program; at most about ``strokes`` strokes."""
    start, end = _stroke_ends(figures.feeds, figures.program.motion, strokes)
    block = _worst_between(figures.deviation.segment, start, end)
    deviation = figures.deviation.segment[block]
    low, high = _box(figures.tip[figures.feeds])
    length = float((high - low).max()) / AXES_ACROSS
    tool = _apart(figures.tip, figures.feeds, low, length)
    worst = figures.worst[figures.deviation.segment[figures.worst] > 0.0]
    return Drawing(
        tolerance=figures.tolerance, stroke=_paired(figures.tip[start - 1], figures.tip[end]), block=block, deviation=deviation,
        level=level_of(deviation, figures.tolerance), rapid=_rapids(figures), foot=figures.tip[tool], axis=figures.axis[tool],
        axis_length=1.5 * length, worst=worst, curve=_real_ways(figures, worst, CURVE_POINTS).reshape(-1, 3),
        chord=_paired(figures.tip[worst - 1], figures.tip[worst]), spoke=_spokes(figures, worst), low=low, high=high,
        markers=markers(figures),
    )  # fmt: skip


def level_of(deviation: Floats, tolerance: float) -> Floats:
    """Where deviations (k,) mm stand on the scale, 0 to 1; NaN counts as the largest."""
    share = np.nan_to_num(np.asarray(deviation, float) / tolerance, nan=np.inf)
    with np.errstate(divide="ignore"):
        return np.asarray(np.clip(0.5 + np.log10(share) / (2.0 * DECADES), 0.0, 1.0))


def scale_values(tolerance: float) -> tuple[tuple[float, float], ...]:
    """The marks of the scale: level and deviation, mm, lowest first."""
    powers = range(-int(DECADES), int(DECADES) + 1)
    return tuple((0.5 + power / (2.0 * DECADES), tolerance * 10.0**power) for power in powers)


def spot(figures: Figures, block: int) -> Spot:
    """The numbers of one block (1 to m - 1)."""
    program, deviation, row = figures.program, figures.deviation, block
    first, second = np.abs(program.words[row, 3:] - program.words[row - 1, 3:]).tolist()
    x, y, z = deviation.place[row].tolist()
    return Spot(
        block=row, line=int(program.line[row]), deviation=float(deviation.segment[row]), bound=float(deviation.bound[row]),
        tolerance=figures.tolerance, singular=bool(figures.singularity.singular[row]),
        turns=tuple((program.letters[k], (first, second)[k - 3]) for k in fitted_columns(program.letters)[3:]),
        lean=math.degrees(figures.singularity.axis_travel[row]), step=math.dist(figures.tip[row - 1], figures.tip[row]),
        place=(x, y, z),
    )  # fmt: skip


class Row(NamedTuple):
    """A line of a list of findings. ``kind``: a finding's code or a marker's kind; ``whole``: it tells of several blocks, of
    which ``finding`` names the worst."""

    kind: str
    finding: Finding
    whole: bool = False


def listed(figures: Figures) -> tuple[tuple[Row, ...], tuple[int, ...]]:
    """All that a list of findings shows, the gravest first; then the row of each of ``markers(figures)``.

    A marker that no finding tells of has a row of its own, with a finding made of its numbers.
    """
    codes = [one.code for one in figures.findings]
    whole = {codes.index(code) for code in (OVER, UNPROVEN, SINGULAR) if codes.count(code) > 1}
    rows = [Row(one.code, one, at in whole) for at, one in enumerate(figures.findings)]
    told: dict[object, Row] = {(one.kind, one.finding.block): one for one in rows if not one.whole}
    told |= {id(one.finding): one for one in rows if one.finding.block is None}
    marked = []
    for mark in markers(figures):
        row = told.get((mark.kind, mark.block) if mark.block is not None else id(mark.finding))
        if row is None:
            row = Row(mark.kind, _told(figures, mark))
            rows.append(row)
        marked.append(row)
    rows.sort(key=lambda row: -row.finding.severity)
    place = {id(row): at for at, row in enumerate(rows)}
    return tuple(rows), tuple(place[id(row)] for row in marked)


def _told(figures: Figures, mark: Marker) -> Finding:
    """What is known of a marker, as a finding."""
    if mark.block is None or mark.kind not in (LARGEST, OVER, SINGULAR):
        severity = Severity.ERROR if mark.kind in GOUGES else Severity.NOTE
        line = None if mark.block is None else int(figures.program.line[mark.block])
        return mark.finding or Finding(severity, mark.kind, mark.label, block=mark.block, line=line, place=mark.place)
    there = spot(figures, mark.block)
    if mark.kind == SINGULAR:
        value, unit, severity = max((turn for _, turn in there.turns), default=0.0), "deg", Severity.WARNING
    else:
        value, unit, severity = there.deviation, "mm", Severity.ERROR if mark.kind == OVER else Severity.NOTE
    return Finding(severity, mark.kind, mark.label, value, None, unit, there.block, there.line, mark.place)


def _stroke_ends(feeds: Ints, motion: np.ndarray, most: int) -> tuple[Ints, Ints]:
    """First and last block of every stroke. One stroke never spans a rapid or two kinds of motion."""
    if not len(feeds):
        return feeds, feeds
    new = np.ones(len(feeds), bool)
    new[1:] = (np.diff(feeds) > 1) | (motion[feeds[1:]] != motion[feeds[:-1]])
    if len(feeds) > most:
        first = np.flatnonzero(new)
        since = np.arange(len(feeds)) - np.repeat(first, np.diff(first, append=len(feeds)))
        new = since % -(-len(feeds) // most) == 0
    else:
        new[:] = True
    first = np.flatnonzero(new)
    return feeds[first], feeds[np.append(first[1:], len(feeds)) - 1]


def _worst_between(values: Floats, start: Ints, end: Ints) -> Ints:
    """The row of the largest of ``values`` (m,) in each stroke of rows ``start`` to ``end`` (k,)."""
    worst, known = start.copy(), np.nan_to_num(values, nan=np.inf)
    for step in range(1, int((end - start).max(initial=0)) + 1):
        row = np.minimum(start + step, end)
        worst = np.where(known[row] > known[worst], row, worst)
    return worst


def _box(points: Floats) -> tuple[Floats, Floats]:
    return (points.min(axis=0), points.max(axis=0)) if len(points) else (np.zeros(3), np.zeros(3))


def _apart(points: Floats, rows: Ints, low: Floats, side: float) -> Ints:
    """One of ``rows`` for each cube of this ``side``: that nearest to the cube's middle."""
    if not side > 0.0:
        return rows[:1]
    cell = (points[rows] - low) / side
    index = np.minimum(cell.astype(np.int64), AXES_ACROSS)
    off = ((cell - index - 0.5) ** 2).sum(axis=1)
    key = index @ np.array([1, AXES_ACROSS + 1, (AXES_ACROSS + 1) ** 2])
    order = np.lexsort((off, key))
    first = np.flatnonzero(np.diff(key[order], prepend=-1))
    return np.sort(rows[order[first]])


def _paired(start: Floats, end: Floats) -> Floats:
    return np.stack([start, end], axis=1).reshape(-1, 3)


def _real_ways(figures: Figures, rows: Ints, points: int) -> Floats:
    """The real tip (w, points, 3) at even shares of the blocks ``rows`` (w,)."""
    if not len(rows):
        return np.zeros((0, points, 3))
    words = figures.program.words
    return tip_at(figures.kinematics, words[rows - 1], words[rows], np.linspace(0.0, 1.0, points)[None])


def _rapids(figures: Figures) -> Floats:
    rows = np.flatnonzero(figures.program.motion == Motion.RAPID)
    rows = rows[rows > 0]
    if len(rows) > RAPIDS:
        rows = rows[np.linspace(0, len(rows) - 1, RAPIDS).astype(np.int64)]
    way = _real_ways(figures, rows, RAPID_POINTS)
    return _paired(way[:, :-1].reshape(-1, 3), way[:, 1:].reshape(-1, 3))


def _spokes(figures: Figures, rows: Ints) -> Floats:
    start, place = figures.tip[rows - 1], figures.deviation.place[rows]
    along = figures.tip[rows] - start
    squared = np.maximum((along * along).sum(axis=1), 1e-24)
    share = np.clip(((place - start) * along).sum(axis=1) / squared, 0.0, 1.0)
    return _paired(start + share[:, None] * along, place)
