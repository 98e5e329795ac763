# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rapids on controllers that may drive each axis at a rate of its own: every way between their ends against
the part.

A rapid of one axis has one way only, and the check of the program's own motion has looked at it; so it has
where that found an entry. Row 0 is no block: where the machine comes from is not known.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INDEPENDENT, INTERPOLATED, UNKNOWN
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import Choice, Length, Point, Template, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.motion.program import Program, find_unknown_ways
from freecad_fiveaxis.core.tool.body import PARTS, Body
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .joint_box import JointSpace
from .rapid_ways import WayEntries, find_way_entries
from .spots import MOST_SPOTS, deepest_of, spots

ENTERS = {
    INDEPENDENT: Template(
        "The {part} goes at least {depth} into the part at {at} in a rapid whose axes run independently; it "
        "is clear only if they are interpolated."
    ),
    UNKNOWN: Template(
        "The {part} goes at least {depth} into the part at {at} if the axes of this rapid run independently; "
        "it is clear if they "
        "are interpolated. Which of the two this controller does is not known."
    ),
}
REMEDY = say(
    "Drive one group of axes after the other, or, where the controller interpolates rapids, say so in the "
    "machine file or by {rapids}.",
    rapids=Choice("rapids", (INTERPOLATED,), flag=True),
)


def check_rapids(
    mesh: Mesh, body: Body, space: JointSpace, program: Program, tolerance: float, accuracy: float,
    known: Bools,
    progress: Progress = silent,
) -> WayEntries:  # fmt: skip
    """Find what the body enters deeper than ``tolerance`` mm on any way of a program's rapids; ``known`` (m -
    1,): blocks that are told to enter anyway. Depths are known to ``accuracy`` mm."""
    blocks = independent_rapids(program)
    blocks = blocks[~known[blocks]]
    return find_way_entries(
        body, facet_tree(mesh), space, program.words, blocks, tolerance, accuracy, progress
    )


def independent_rapids(program: Program) -> Ints:
    """Pick the rapids that move several axes on a way that is known; block i leads to row i + 1."""
    several = (np.diff(program.words, axis=0) != 0.0).sum(axis=1) > 1
    known = ~find_unknown_ways(program)
    return np.flatnonzero(several & known & (program.motion[1:] == Motion.RAPID))


def rapid_findings(ways: WayEntries, program: Program, tolerance: float, rapids: str) -> tuple[Finding, ...]:
    """Tell the deepest block of each of the deepest spots, and how many blocks there are; then what is not
    proven."""
    worst, blocks = spots(ways.depth)
    found = []
    for k, block in enumerate(worst[:MOST_SPOTS].tolist()):
        x, y, z = ways.place[block].tolist()
        depth, line = float(ways.depth[block]), int(program.line[block + 1])
        text = ENTERS[rapids].say(
            part=PARTS[int(ways.part[block])], depth=Length(depth, ".3g"), at=Point((x, y, z), ".4g")
        )
        if k == 0 and blocks > 1:
            text += deepest_of(blocks, len(worst))
        text = join_sentences((text, REMEDY))
        found.append(
            report_finding(Code.INDEPENDENT_RAPID, text, depth, tolerance, block + 1, line, (x, y, z))
        )
    return (*found, *_unproven(ways, program, tolerance))


def unproven_blocks(ways: WayEntries, tolerance: float) -> Ints:
    """Pick the blocks that are not known to enter, and not proven to stay out by ``tolerance`` mm."""
    return np.flatnonzero((ways.depth == 0.0) & (ways.bound > tolerance * (1.0 + 1e-9)))


def _unproven(ways: WayEntries, program: Program, tolerance: float) -> tuple[Finding, ...]:
    rows = unproven_blocks(ways, tolerance)
    if not len(rows):
        return ()
    line, bound = int(program.line[rows[0] + 1]), float(ways.bound[rows].max())
    text = say(
        "In {count} rapids it is not proven that the tool stays out of the part on every way of independent "
        "axes, the first in NC line {line}; it enters by no more than {bound}.",
        count=len(rows), line=line, bound=Length(bound, ".3g"),
    )  # fmt: skip
    text = join_sentences((text, REMEDY))
    return (report_finding(Code.RAPID_UNPROVEN, text, bound, tolerance, int(rows[0]) + 1, line),)
