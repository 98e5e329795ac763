# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays that a 3D view draws, and the numbers behind one block that somebody points at.

stroke  a straight line of the picture: the chord of a feed block, or of several neighbouring ones where a
        program has more than STROKES; it has the deviation of the worst of its blocks. Of a ball that leans
        it joins the contacts: what is cut.
cut     a stroke that cuts: of a cut or a fill whose ends lie at the part. Where the tool was lifted off the
        part, and on links, it cuts nothing. Of a foreign program without its part every feed block may cut.
coat    ``thinning``: fewer passes, for a small picture. What is over the tolerance is in every coat.
level   where the deviation stands on the scale of the path (``deviation_scale``): 0.5 is the tolerance.
curve   the way that the judged point, the tip or a ball's centre, really takes in a block, beside its own
        chord; spoke: from the chord to the curve where they are farthest apart.
spot    one block that is worth a look, in numbers.

All places are in the work frame, mm.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze
from freecad_fiveaxis.core.gouge import GOUGES
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.motion.program import find_unknown_ways
from freecad_fiveaxis.core.motion.trajectory import tip_at
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .deviation_scale import level_of, scale_end
from .figures import Figures
from .markers import Marker, markers
from .playback import segment_foot
from .thinning import COATS, coats, distances

STROKES = 600_000
"""Beyond this many a view without a graphics card no longer follows the mouse."""
CURVE_POINTS = 129
RAPID_POINTS = 17
RAPIDS = 5_000
"""At most so many rapids are drawn, evenly chosen."""
AXES_ACROSS = 26
"""At most one tool axis is drawn in each cube of the part's longest side divided by this: more hide each
other."""
LARGEST = "largest-deviation"
"""The kind of the first marker."""


@dataclass(frozen=True, eq=False)
class Drawing:
    """What a view shows of a program.

    ``stroke`` (2k, 3): start and end of every stroke in turn; ``block`` (k,) the worst of its blocks,
    ``deviation`` (k,) mm and ``level`` (k,) of that, ``cut`` (k,) whether it cuts, ``coat`` (k,) the widest
    coat that it belongs to; ``apart`` (COATS,) mm between the passes of each coat. ``rapid`` (2r, 3): strokes
    along the real way of the rapids. ``foot``, ``axis`` (a, 3): tip (or contact) and unit axis of the tools
    drawn, which cut there and stand ``axis_length`` mm high. ``curve`` (w CURVE_POINTS, 3), ``chord`` (2w, 3)
    and ``spoke`` (2w, 3) of the worst blocks ``worst`` (w,). ``low``, ``high`` (3,) the box of the feed
    blocks.
    """

    tolerance: float
    stroke: Floats
    block: Ints
    deviation: Floats
    level: Floats
    cut: Bools
    coat: Ints
    apart: Floats
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
        freeze(self, k, block="i", deviation="f", level="f", cut="b", coat="i")
        freeze(self, 2 * k, stroke="f3")
        freeze(self, None, apart="f")
        freeze(self, None, rapid="f3")
        freeze(self, None, foot="f3", axis="f3")
        freeze(self, w, worst="i")
        freeze(self, 2 * w, chord="f3", spoke="f3")
        freeze(self, CURVE_POINTS * w, curve="f3")
        freeze(self, 3, low="f", high="f")


@dataclass(frozen=True)
class Spot:
    """One feed block in numbers: mm and degrees. ``turns``: the letters of the rotary axes and how far each
    turns in the block; ``lean`` how far the tool axis leans meanwhile; ``step`` the length of the tip's
    chord; ``place`` the real tip when the judged point is farthest from its chord; ``ball``: that point is a
    ball's centre."""

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
    ball: bool = False


def draw(figures: Figures, strokes: int = STROKES) -> Drawing:
    """Return the picture of a program; at most about ``strokes`` strokes."""
    start, end = _stroke_ends(figures.feeds, figures.program.motion, strokes)
    block = _worst_between(figures.judged.segment, start, end)
    deviation = figures.judged.segment[block]
    low, high = _box(figures.tip[figures.feeds])
    length = float((high - low).max()) / AXES_ACROSS
    worst = figures.worst[figures.judged.segment[figures.worst] > 0.0]
    curve, spoke = _curves(figures, worst)
    stroke = _pair_ends(figures.place_drawn_ends(start - 1), figures.place_drawn_ends(end))
    level, cut = level_of(deviation, figures.tolerance, scale_end(figures)), _cutting(figures, start, end)
    diagonal = float(np.linalg.norm(high - low))
    tool = _apart(figures.tip, end[cut], low, length)
    return Drawing(
        tolerance=figures.tolerance, stroke=stroke, block=block, deviation=deviation, level=level, cut=cut,
        coat=_coats(stroke, cut, level, diagonal), apart=distances(diagonal),
        rapid=_rapids(figures), foot=figures.place_drawn_ends(tool), axis=figures.axis[tool],
        axis_length=1.5 * length, worst=worst, curve=curve.reshape(-1, 3),
        chord=curve[:, [0, -1]].reshape(-1, 3), spoke=spoke,
        low=low, high=high, markers=markers(figures),
    )  # fmt: skip


def spot(figures: Figures, block: int) -> Spot:
    """Return the numbers of one block (1 to m - 1)."""
    program, deviation, row = figures.program, figures.judged, block
    first, second = np.abs(program.words[row, 3:] - program.words[row - 1, 3:]).tolist()
    x, y, z = deviation.place[row].tolist()
    return Spot(
        block=row, line=int(program.line[row]), deviation=float(deviation.segment[row]),
        bound=float(deviation.bound[row]),
        tolerance=figures.tolerance, singular=bool(figures.singularity.singular[row]),
        turns=tuple((program.letters[k],
            (first, second)[k - 3]) for k in find_physical_columns(program.letters)[3:]),
        lean=math.degrees(figures.singularity.axis_travel[row]),
        step=math.dist(figures.tip[row - 1], figures.tip[row]),
        place=(x, y, z), ball=figures.surface is not None,
    )  # fmt: skip


class Row(NamedTuple):
    """A line of a list of findings. ``kind``: a finding's code or a marker's kind; ``whole``: it tells of
    several blocks, of which ``finding`` names the worst."""

    kind: str
    finding: Finding
    whole: bool = False


def list_findings(figures: Figures) -> tuple[tuple[Row, ...], tuple[int, ...]]:
    """All that a list of findings shows, the gravest first; then the row of each of ``markers(figures)``.

    A marker that no finding tells of has a row of its own, with a finding made of its numbers.
    """
    codes = [one.code for one in figures.findings]
    whole = {
        codes.index(code)
        for code in (Code.DEVIATION_OVER_TOLERANCE, Code.BOUND_OVER_TOLERANCE, Code.SINGULAR_BLOCK)
        if codes.count(code) > 1
    }
    rows = [Row(one.code, one, at in whole) for at, one in enumerate(figures.findings)]
    by_mark: dict[object, Row] = {(one.kind, one.finding.block): one for one in rows if not one.whole}
    by_mark |= {id(one.finding): one for one in rows if one.finding.block is None}
    marked = []
    for mark in markers(figures):
        row = by_mark.get((mark.kind, mark.block) if mark.block is not None else id(mark.finding))
        if row is None:
            row = Row(mark.kind, _finding_of(figures, mark))
            rows.append(row)
        marked.append(row)
    rows.sort(key=lambda row: -row.finding.severity)
    place = {id(row): at for at, row in enumerate(rows)}
    return tuple(rows), tuple(place[id(row)] for row in marked)


def _finding_of(figures: Figures, mark: Marker) -> Finding:
    """Return what is known of a marker, as a finding."""
    if mark.block is None or mark.kind not in (LARGEST, Code.DEVIATION_OVER_TOLERANCE, Code.SINGULAR_BLOCK):
        severity = Severity.ERROR if mark.kind in GOUGES else Severity.NOTE
        line = None if mark.block is None else int(figures.program.line[mark.block])
        return mark.finding or Finding(
            severity, mark.kind, mark.label, block=mark.block, line=line, place=mark.place
        )
    there = spot(figures, mark.block)
    if mark.kind == Code.SINGULAR_BLOCK:
        value, unit, severity = max((turn for _, turn in there.turns), default=0.0), "deg", Severity.WARNING
    else:
        value, unit, severity = (
            there.deviation,
            "mm",
            Severity.ERROR if mark.kind == Code.DEVIATION_OVER_TOLERANCE else Severity.NOTE,
        )
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


def _cutting(figures: Figures, start: Ints, end: Ints) -> Bools:
    """Which strokes, of blocks ``start`` to ``end`` (k,), cut."""
    return np.asarray(
        (figures.program.motion[end] != Motion.LINK) & figures.at_part[start - 1] & figures.at_part[end]
    )


def _coats(stroke: Floats, cut: Bools, level: Floats, diagonal: float) -> Ints:
    """Return the widest coat (k,) of each stroke; links are in all."""
    widest = np.full(len(cut), COATS)
    widest[cut] = coats(stroke[0::2][cut], stroke[1::2][cut], diagonal)
    widest[level > 0.5] = COATS
    return widest


def _worst_between(values: Floats, start: Ints, end: Ints) -> Ints:
    """Return the row of the largest of ``values`` (m,) in each stroke of rows ``start`` to ``end`` (k,)."""
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


def _pair_ends(start: Floats, end: Floats) -> Floats:
    return np.stack([start, end], axis=1).reshape(-1, 3)


def _curves(figures: Figures, rows: Ints) -> tuple[Floats, Floats]:
    """Return the real way (w, CURVE_POINTS, 3) mm of the judged point in the blocks ``rows`` (w,), and its
    spokes (2w, 3) mm."""
    if not len(rows):
        return np.zeros((0, CURVE_POINTS, 3)), np.zeros((0, 3))
    deviation, words = figures.judged, figures.program.words
    kinematics, start = deviation.raise_words(figures.kinematics, words[rows - 1])
    end = deviation.raise_words(figures.kinematics, words[rows])[1]
    way = tip_at(kinematics, start, end, np.linspace(0.0, 1.0, CURVE_POINTS)[None])
    place = tip_at(kinematics, start, end, deviation.u_segment[rows])
    return way, _pair_ends(segment_foot(place, way[:, 0], way[:, -1]), place)


def _rapids(figures: Figures) -> Floats:
    rows = np.flatnonzero(figures.program.motion == Motion.RAPID)
    rows = rows[rows > 0]
    rows = rows[~find_unknown_ways(figures.program)[rows - 1]]
    if len(rows) > RAPIDS:
        rows = rows[np.linspace(0, len(rows) - 1, RAPIDS).astype(np.int64)]
    if not len(rows):
        return np.zeros((0, 3))
    words, u = figures.program.words, np.linspace(0.0, 1.0, RAPID_POINTS)[None]
    way = tip_at(figures.kinematics, words[rows - 1], words[rows], u)
    return _pair_ends(way[:, :-1].reshape(-1, 3), way[:, 1:].reshape(-1, 3))
