# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a check of one body comes to, for what is told of it once: the deepest block, what is not proven of
rapids, and where nothing enters the block that comes nearest."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, Hit, report_finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import PARTS, Body, grow_body

from .check import GougeCheck, check_program
from .known_depths import Entries
from .rapid_check import unproven_blocks
from .rapid_ways import WayEntries


class Worst(NamedTuple):
    """``row`` of the program to which the deepest block leads; ``line`` of the NC file; ``depth`` mm, 0 where
    only whole cutters are in the body: then it is the first such block; ``part`` of the tool, ``place`` mm,
    work frame; ``blocks``: how many enter; ``u``: when within the block, 0 to 1, None where that is not
    known."""

    row: int
    line: int
    depth: float
    part: str
    place: Vector
    blocks: int
    u: float | None


class Unproven(NamedTuple):
    """``rapids``: how many; ``row`` and ``line`` of the first; ``bound`` mm: none of them enters by more."""

    rapids: int
    row: int
    line: int
    bound: float


def find_worst(check: GougeCheck, program: Program) -> Worst | None:
    """Find the deepest block of cutter, shank, holder and rapids; None where nothing enters."""
    kinds: list[Entries | WayEntries] = [
        check.cutter,
        check.above,
        *([] if check.ways is None else [check.ways]),
    ]
    depth = np.max([one.depth for one in kinds], axis=0, initial=0.0)
    count = int(np.count_nonzero((depth > 0.0) | check.buried))
    if not count:
        return None
    block = int(depth.argmax()) if depth.any() else int(check.buried.argmax())
    worst = max(kinds, key=lambda one: float(one.depth[block]))
    x, y, z = worst.place[block].tolist()
    line, part = int(program.line[block + 1]), PARTS[int(worst.part[block])]
    u = float(worst.u[block]) if isinstance(worst, Entries) and depth[block] else None
    return Worst(block + 1, line, float(depth[block]), part, (x, y, z), count, u)


def find_unproven(ways: WayEntries | None, program: Program, tolerance: float) -> Unproven | None:
    """Find the rapids of which it is not proven, on every way of independent axes, that nothing enters deeper
    than ``tolerance`` mm; None where there are none."""
    rows = np.empty(0, np.int64) if ways is None else unproven_blocks(ways, tolerance)
    if ways is None or not len(rows):
        return None
    return Unproven(
        len(rows), int(rows[0]) + 1, int(program.line[rows[0] + 1]), float(ways.bound[rows].max())
    )


def find_nearest(
    body: Body, clearance: float, mesh: Mesh, kinematics: Chain, program: Program, tolerance: float,
    back: float,
    progress: Progress, rapids: str,
) -> Worst | None:  # fmt: skip
    """Find where a ``body`` that enters nothing comes nearer to a ``mesh`` than ``clearance`` mm, by more
    than ``tolerance``: there the body, grown by as much, enters. None where it comes no nearer, or no
    clearance is asked for."""
    if clearance <= tolerance:
        return None
    check = check_program(
        mesh, grow_body(body, clearance), kinematics, program, tolerance, back, progress, "", rapids
    )
    return find_worst(check, program)


def near_finding(
    code: Code, name: str, worst: Worst, clearance: float, at: object, key: str | None = None
) -> Finding:
    """Tell what comes nearer to a body of this ``name`` than the ``clearance``, mm, and ``at`` which place;
    ``key`` as in a Hit, None: its name."""
    distance = max(clearance - worst.depth, 0.0)
    text = say(
        "The {part} comes nearer than {distance} to {name} at {at}, nearest of {count} blocks; {clearance} "
        "are asked for.",
        part=worst.part, distance=Length(distance, ".3g"), name=name, at=at, count=worst.blocks,
        clearance=Length(clearance),
    )  # fmt: skip
    row, line, near = worst.row, worst.line, Hit(worst.part, name if key is None else key, worst.u)
    return report_finding(code, text, distance, clearance, row, line, worst.place, near=near)
