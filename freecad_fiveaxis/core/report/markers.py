# SPDX-License-Identifier: LGPL-2.1-or-later
"""The markers for the 3D view: where on the part something is worth a look."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.gouge import GOUGES, Entries, GougeCheck, WayEntries
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.tool.body import PARTS

from .figures import Figures, travel, worst_first

MARKERS = 500
"""At most so many markers of a kind: more hide the part and slow the view down."""


@dataclass(frozen=True)
class Marker:
    """Something to show on the part: ``place`` mm in the work frame, ``kind`` a code, ``label`` a few words;
    ``block`` a row of the Program."""

    place: Vector
    kind: str
    label: str
    finding: Finding | None = None
    block: int | None = None


def markers(figures: Figures) -> tuple[Marker, ...]:
    """Return what the 3D view shows: places over tolerance, near the pole, and those of the other findings.

    A run of neighbouring blocks has one marker, at its worst block; the first marker is the largest deviation
    of all.
    """
    program, deviation = figures.program, figures.judged
    over, near = np.zeros(len(program.words), bool), np.zeros(len(program.words), bool)
    over[figures.feeds] = ~(deviation.segment[figures.feeds] <= figures.tolerance)
    near[figures.feeds] = figures.singularity.singular[figures.feeds]
    near &= ~figures.at_pole
    turned = np.abs(travel(program)[:, 3:]).max(axis=1, initial=0.0)
    return (
        *_mark_rows(figures, "largest-deviation", figures.worst[:1], deviation.segment, "{:.4g} mm"),
        *_mark_rows(
            figures,
            Code.DEVIATION_OVER_TOLERANCE,
            _run_peaks(over, deviation.segment),
            deviation.segment,
            "{:.4g} mm",
        ),
        *_mark_rows(figures, Code.SINGULAR_BLOCK, _run_peaks(near, turned), turned, "turns {:.4g} deg"),
        *_mark_rows(
            figures, Code.TURNS_AT_POLE, _run_peaks(figures.at_pole, turned), turned, "turns {:.4g} deg"
        ),
        *_mark_entries(figures),
        *_mark_placed_findings(figures),
    )


def _run_peaks(chosen: Bools, values: Floats) -> Ints:
    """Return the row of the largest value in each run of ``chosen`` rows (m,), the worst first, at most
    MARKERS."""
    rows = np.flatnonzero(chosen)
    run = np.cumsum(np.diff(rows, prepend=rows[:1]) > 1)
    worst = worst_first(rows, values)
    _, first = np.unique(run[np.searchsorted(rows, worst)], return_index=True)
    return worst[np.sort(first)][:MARKERS]


def _mark_rows(figures: Figures, kind: str, rows: Ints, values: Floats, label: str) -> list[Marker]:
    code = Code.DEVIATION_OVER_TOLERANCE if kind == "largest-deviation" else kind
    by_block = {one.block: one for one in reversed(figures.findings) if one.code == code}
    marks = []
    for row in rows.tolist():
        x, y, z = figures.judged.place[row].tolist()
        words = f"{label.format(values[row])}, line {figures.program.line[row]}"
        marks.append(Marker((x, y, z), kind, words, by_block.get(row), row))
    return marks


def _mark_entries(figures: Figures) -> list[Marker]:
    """Where the tool enters the part: in each run of blocks the deepest, at the point that is entered
    most."""
    if figures.gouge is None:
        return []
    by_block, marks = {(one.code, one.block): one for one in reversed(figures.findings)}, []
    for code, entries, depth in _depths(figures.gouge, figures.program.motion[1:]):
        for block in _run_peaks(depth > 0.0, depth).tolist():
            x, y, z = entries.place[block].tolist()
            label = (
                f"{PARTS[int(entries.part[block])]} {depth[block]:.4g} mm in the part, line "
                f"{figures.program.line[block + 1]}"
            )
            marks.append(Marker((x, y, z), code, label, by_block.get((code, block + 1)), block + 1))
    return marks


def _depths(gouge: GougeCheck, motion: Bytes) -> list[tuple[str, Entries | WayEntries, Floats]]:
    """Return the cases of the check, and the rapids that are clear only if interpolated."""
    ways = gouge.ways
    return [*gouge.cases(motion), *([] if ways is None else [(Code.INDEPENDENT_RAPID, ways, ways.depth)])]


def _mark_placed_findings(figures: Figures) -> list[Marker]:
    marked = (
        Code.DEVIATION_OVER_TOLERANCE,
        Code.SINGULAR_BLOCK,
        Code.TURNS_AT_POLE,
        *((*GOUGES, Code.INDEPENDENT_RAPID) if figures.gouge else ()),
    )
    others = [one for one in figures.findings if one.place is not None and one.code not in marked]
    return [Marker(one.place, one.code, _words(one), one, one.block) for one in others[:MARKERS] if one.place]


def _words(one: Finding) -> str:
    """Return what is in what or near what, and how far, of a collision or a near miss; of any other finding
    its code in words."""
    if one.hit is not None and one.value:
        return f"{one.hit.enters} {one.value:.4g} mm in {one.hit.entered or 'the part'}, line {one.line}"
    if one.near is not None:
        return f"{one.near.enters} within {one.value:.4g} mm of {one.near.entered}, line {one.line}"
    return one.code.replace("-", " ")
