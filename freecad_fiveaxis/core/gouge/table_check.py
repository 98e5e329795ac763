# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool against the machine's table, on the way that the machine really goes.

The table's face is the top of a level slab in the part's frame: there it stands still as the part does,
whichever of both the machine moves."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import PARTS, Body, body_support

from .check import check_program, program_motion
from .known_depths import Entries
from .rapid_ways import WayEntries
from .swept_motion import SweptMotion

BEYOND = 1000.0
"""mm that the slab goes beyond the places of the tip on all sides, and down."""


def check_table(
    height: float, body: Body, kinematics: Chain, program: Program, tolerance: float, back: float = 0.0,
    progress: Progress = silent, rapids: str = INTERPOLATED,
) -> tuple[Finding, ...]:  # fmt: skip
    """Find whether the ``body`` goes more than ``tolerance`` mm below the table's face, whose ``height`` in
    the work frame is in mm, on any block; see :func:`.check.check_program`. None deeper is missed; told is
    how deep the face is in the tool, which may be farther below it."""
    if rapids == INTERPOLATED and stays_above(height, body, program_motion(kinematics, program, back)):
        return ()
    slab = table_slab(height, kinematics, program)
    check = check_program(slab, body, kinematics, program, tolerance, back, progress, "", rapids)
    kinds: list[Entries | WayEntries] = [
        check.cutter,
        check.above,
        *([] if check.ways is None else [check.ways]),
    ]
    worst = max(kinds, key=lambda one: float(one.depth.max(initial=0.0)))
    return () if not worst.depth.any() else (_below(worst, program, tolerance),)


def stays_above(height: float, body: Body, swept: SweptMotion) -> bool:
    """Tell whether bounds of the whole way show that the ``body`` stays above ``height`` mm: then no block
    needs to be searched.

    At the ends of blocks its lowest point is known; between them it goes no lower than the lower one of both,
    but for what the way leaves the straight one by, as in :mod:`.swept_motion`.
    """

    def lowest(blocks: slice) -> float:
        block = np.arange(blocks.start, blocks.stop)
        ends = [swept.pose(block, np.full(len(block), u)) for u in (0.0, 1.0)]
        low = np.minimum(*(end.tip[2] - body_support(body, -end.axis[2]) for end in ends))
        return float((low - 0.125 * (swept.bend_tip[blocks] + body.reach * swept.bend_axis[blocks])).min())

    return bool(body.pieces) and all(low > height for low in in_threads(lowest, chunks(len(swept))))


def table_slab(height: float, kinematics: Chain, program: Program) -> Mesh:
    """Make a slab whose top is the table's face, mm, wide enough for all of the program."""
    tip, _ = forward(kinematics, words_to_q(program.words))
    low, high = tip.min(axis=0) - BEYOND, tip.max(axis=0) + BEYOND
    low[2], high[2] = min(low[2], height) - BEYOND, height
    return from_triangles(box_facets(low, high))


def _below(entries: Entries | WayEntries, program: Program, tolerance: float) -> Finding:
    """Return the finding of the deepest block, which says how many there are."""
    block, count = int(entries.depth.argmax()), int(np.count_nonzero(entries.depth))
    depth, line, (x, y, z) = (
        float(entries.depth[block]),
        int(program.line[block + 1]),
        entries.place[block].tolist(),
    )
    text = say(
        "The {part} goes at least {depth} below the table's face at {at}, deepest of {count} blocks. Clamp "
        "the part higher, use a longer tool, or lean it less ({max_axis_angle}).",
        part=PARTS[int(entries.part[block])], depth=Length(depth, ".4g"), at=Point((x, y, z)), count=count,
        max_axis_angle=Option("max_axis_angle"),
    )  # fmt: skip
    return report_finding(Code.TABLE_COLLISION, text, depth, tolerance, block + 1, line, (x, y, z))
