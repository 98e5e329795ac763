# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs into chords within a tolerance (ISO 6983-1: G2 clockwise, G3 counter-clockwise, in the plane of G17,
G18 or G19).

centre    by I J K from the arc's start (or absolute: G90.1, a klartext CC), or by the radius R: above 0 the
          shorter arc.
chord     of an angle d leaves a circle of radius r by r (1 - cos(d/2)); the rotary words and the third axis
          go evenly with it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

ARC_TOLERANCE = 0.001
"""mm; a tenth of the usual tolerance of a program."""
MISMATCH = 0.02
"""Start and end of an arc that lie by more than this share of the radius at different distances from its
centre make no arc."""
AXES = np.array([[0, 1, 2], [2, 0, 1], [1, 2, 0]])
"""By plane: the two axes of the circle, right-handed about the third."""
MOST = 5_000_000
"""Chords of a whole program: more would fill the memory."""
HEIGHT_MISMATCH = 0.05
"""Share of the height of an arc by which that told for its turn may differ: posts round it to few digits."""
FULL = 1e-7
"""rad; an arc that ends where it begins is a full circle."""


@dataclass(frozen=True, eq=False)
class Arcs:
    """One row an arc, (n,): ``row`` of the moves; ``plane`` 0 XY, 1 ZX, 2 YZ; ``counter``: G3; ``offset`` (n,
    3) I J K, NaN where not given; ``absolute``: they are the centre's place; ``radius`` R, NaN where not
       given; ``centre`` (n, 3) the centre
    told before, NaN where none; ``turns`` full turns made besides, None: none."""

    row: Ints
    plane: Ints
    counter: Bools
    offset: Floats
    absolute: Bools
    radius: Floats
    centre: Floats
    turns: Floats | None = None


@dataclass(frozen=True, eq=False)
class Chords:
    """The moves with chords for arcs: ``row`` (m',) of the moves that each belongs to, ``count`` (m,) of
    pieces of each move, and the words ``before`` and ``programmed`` (m', 5)."""

    row: Ints
    count: Ints
    before: Floats
    programmed: Floats


def divide_arcs(arcs: Arcs, before: Floats, programmed: Floats, line: Ints) -> tuple[Chords, list[Finding]]:
    """Return the moves (m, 5) with their arcs divided; one without a centre stays straight, with a finding.
    ``line`` (m,) is for that.

    Raises ProgramError where the arcs would need more than :data:`MOST` chords.
    """
    rows = np.arange(len(arcs.row))
    u, v = AXES[arcs.plane, 0], AXES[arcs.plane, 1]
    start = np.stack([before[arcs.row, u], before[arcs.row, v]])
    end = np.stack([programmed[arcs.row, u], programmed[arcs.row, v]])
    centre = _centres(arcs, start, end, np.stack([u, v]), rows)
    r0, r1 = (np.hypot(*(place - centre)) for place in (start, end))
    with np.errstate(invalid="ignore"):
        good = (np.abs(r0 - r1) <= MISMATCH * np.maximum(r0, r1) + ARC_TOLERANCE) & (r0 > 0.0) & (r1 > 0.0)
    sweep, count = np.zeros(len(rows)), np.ones(len(rows), np.int64)
    a0, a1 = (np.arctan2(*(place - centre)[::-1]) for place in (start, end))
    turn = np.where(arcs.counter, 1.0, -1.0)
    sweep[good] = _sweep((turn * (a1 - a0))[good])
    unlike = good & _differs_in_height(arcs, sweep, before, programmed)
    if arcs.turns is not None:
        sweep[good] += 2.0 * np.pi * np.nan_to_num(arcs.turns[good])
    step = 2.0 * np.arccos(1.0 - np.minimum(ARC_TOLERANCE / np.maximum(r0[good], r1[good]), 1.0))
    count[good] = np.maximum(np.ceil(sweep[good] / step), 1.0).astype(np.int64)
    if count.sum() > MOST:
        raise ProgramError(
            say(
                "the arcs need {count} chords, more than {most}; is it a program in inches read as mm?",
                count=count.sum(),
                most=MOST,
            ),
            int(count.sum()),
        )
    pieces = np.ones(len(programmed), np.int64)
    pieces[arcs.row] = count
    chords = _divide_moves(before, programmed, pieces)
    at = np.flatnonzero(np.repeat(_of(arcs.row, good, len(programmed)), pieces))
    arc = np.searchsorted(arcs.row, chords.row[at])
    first = np.cumsum(pieces) - pieces
    share = (at - first[chords.row[at]] + 1.0) / count[arc]
    inner = share < 1.0
    at, arc, share = at[inner], arc[inner], share[inner]
    radius, angle = r0[arc] + share * (r1 - r0)[arc], a0[arc] + (turn * sweep)[arc] * share
    chords.programmed[at, u[arc]] = centre[0, arc] + radius * np.cos(angle)
    chords.programmed[at, v[arc]] = centre[1, arc] + radius * np.sin(angle)
    _chain(chords, pieces)
    return chords, [*_findings(arcs, good, line), *_report_heights(arcs, unlike, line)]


def _sweep(angle: Floats) -> Floats:
    """Angles in (0, 2 pi]."""
    sweep = np.mod(angle, 2.0 * np.pi)
    return np.where((sweep < FULL) | (sweep > 2.0 * np.pi - FULL), 2.0 * np.pi, sweep)


def _differs_in_height(arcs: Arcs, sweep: Floats, before: Floats, programmed: Floats) -> Bools:
    """Whether arcs (n,) tell by a word across their plane another height for each turn, or for each radian,
    than they have, and no turns."""
    rows, across = np.arange(len(arcs.row)), AXES[arcs.plane, 2]
    given = np.abs(np.nan_to_num(arcs.offset[rows, across]))
    height = np.abs(programmed[arcs.row, across] - before[arcs.row, across])
    near = HEIGHT_MISMATCH * height + ARC_TOLERANCE * 10.0
    fits = (np.abs(given * sweep - height) <= near) | (np.abs(given * sweep / (2.0 * np.pi) - height) <= near)
    turned = np.zeros(len(rows), np.bool_) if arcs.turns is None else ~np.isnan(arcs.turns)
    return np.asarray((given > 0.0) & ~fits & ~turned & ~arcs.absolute)


def _of(row: Ints, chosen: Bools, count: int) -> Bools:
    mask = np.zeros(count, np.bool_)
    mask[row[chosen]] = True
    return mask


def _divide_moves(before: Floats, programmed: Floats, pieces: Ints) -> Chords:
    """Every move in equal pieces of all its words."""
    row = np.repeat(np.arange(len(programmed)), pieces)
    first = np.cumsum(pieces) - pieces
    share = ((np.arange(len(row)) - first[row] + 1.0) / pieces[row])[:, None]
    places = np.where(share < 1.0, before[row] + share * (programmed[row] - before[row]), programmed[row])
    return Chords(row, pieces, before[row], places)


def _chain(chords: Chords, pieces: Ints) -> None:
    """Each piece but the first of its move begins where the one before it ends."""
    inner = np.flatnonzero(chords.row[1:] == chords.row[:-1]) + 1
    chords.before[inner] = chords.programmed[inner - 1]


def _centres(arcs: Arcs, start: Floats, end: Floats, axes: Ints, rows: Ints) -> Floats:
    """Return the centres (2, n) in the arcs' planes, NaN where none is told."""
    offset = np.stack([arcs.offset[rows, axis] for axis in axes])
    modal = np.stack([arcs.centre[rows, axis] for axis in axes])
    given = ~np.isnan(offset).all(axis=0)
    offset = np.where(np.isnan(offset) & given, np.where(arcs.absolute, start, 0.0), offset)
    by_offset = np.where(arcs.absolute, offset, start + offset)
    by_radius = _by_radius(arcs, start, end)
    return np.where(given, by_offset, np.where(np.isnan(arcs.radius), modal, by_radius))


def _by_radius(arcs: Arcs, start: Floats, end: Floats) -> Floats:
    """Return the centre at distance R: to the left of the chord for G3 and R above 0."""
    chord = end - start
    length = np.hypot(*chord)
    with np.errstate(invalid="ignore", divide="ignore"):
        rest = arcs.radius**2 - 0.25 * length**2
        height = np.sqrt(np.where(rest > -MISMATCH * arcs.radius**2, np.maximum(rest, 0.0), np.nan))
        side = np.where(arcs.counter, 1.0, -1.0) * np.sign(arcs.radius) * height / length
        return np.asarray(0.5 * (start + end) + side * np.stack([-chord[1], chord[0]]))


def _findings(arcs: Arcs, good: Bools, line: Ints) -> list[Finding]:
    bad = np.flatnonzero(~good)
    if not len(bad):
        return []
    text = say(
        "{count} arcs have no centre that fits their start and end; they are taken as straight. Post "
        "straight moves.",
        count=len(bad),
    )
    return [report_finding(Code.ARC_WITHOUT_CENTRE, text, float(len(bad)), line=int(line[arcs.row[bad[0]]]))]


def _report_heights(arcs: Arcs, unlike: Bools, line: Ints) -> list[Finding]:
    at = np.flatnonzero(unlike)
    if not len(at):
        return []
    text = say(
        "{count} arcs tell by I, J or K across their plane a height for each turn that is not theirs: they "
        "are taken without more turns than one. Give the plane (G17, G18, G19), or post helices turn by "
        "turn.",
        count=len(at),
    )
    return [report_finding(Code.ARC_NOT_INTERPRETED, text, float(len(at)), line=int(line[arcs.row[at[0]]]))]
