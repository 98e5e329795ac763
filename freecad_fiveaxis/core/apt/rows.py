# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of the path made of the moves of a CL file: each move is one, arcs are as many as they have chords."""

from __future__ import annotations

from dataclasses import dataclass, replace

from freecad_fiveaxis.core.cl_path import Motion
from freecad_fiveaxis.core.findings import Finding
from freecad_fiveaxis.core.records import Bytes, Floats, Insertion

from .arc_reading import arc_findings, fitting, read_arcs, refuse_too_many
from .arcs import chord_counts, course, inner_ends
from .said import Said
from .source import Source


@dataclass(frozen=True, eq=False)
class Rows:
    """``tip`` (n, 3) mm, ``axis`` (n, 3) unit, ``motion`` (n,) of Motion, ``speed`` (n,) mm/min, 0 for rapids."""

    tip: Floats
    axis: Floats
    motion: Bytes
    speed: Floats


def with_arcs(source: Source, said: Said, rows: Rows, scale: Floats, sagitta: float) -> tuple[Rows, tuple[Finding, ...]]:
    """The rows with those of the arcs' chords put in, and what is wrong about arcs. ``scale`` (n,) mm of the unit at each row;
    ``sagitta`` mm. Raises ProgramError."""
    arcs, lost = read_arcs(said, rows.tip, scale)
    if not len(arcs.row) and not len(lost):
        return rows, ()
    ways = course(arcs, rows.tip)
    straight = rows.motion != Motion.RAPID
    straight[arcs.row] = False
    found = tuple(arc_findings(source, arcs, ways, rows.tip, straight, lost))
    arcs = arcs.take(fitting(arcs, ways))
    ways = course(arcs, rows.tip)
    count = chord_counts(arcs, ways, sagitta)
    refuse_too_many(source, arcs, count)
    at, tip, axis = inner_ends(arcs, ways, count, rows.axis)
    if not len(at):
        return rows, found
    put = Insertion(len(rows.tip), at)
    return replace(
        rows, tip=put.woven(rows.tip, tip), axis=put.woven(rows.axis, axis), motion=put.woven(rows.motion, rows.motion[at]),
        speed=put.woven(rows.speed, rows.speed[at]),
    ), found  # fmt: skip
