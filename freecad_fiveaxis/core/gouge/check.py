# SPDX-License-Identifier: LGPL-2.1-or-later
"""The check: what enters the part, in which blocks, how deep and where.

overcut     the cutter enters the part on a cut: too much is taken off there.
collision   shank or holder enter the part at all, or the cutter on a rapid or a link.
spot        blocks that follow one another and all enter. Each of the deepest spots is a finding.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats
from freecad_fiveaxis.core.base.sentences import (
    Choice,
    Length,
    Point,
    Sentence,
    Template,
    join_sentences,
    say,
)
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program, find_unknown_ways
from freecad_fiveaxis.core.tool.body import CUTTER, HOLDER, PARTS, SHANK, SPINDLE, Body
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .inside import crossing_depth, find_buried_blocks, is_closed
from .joint_box import JointSpace
from .known_depths import Entries
from .rapid_check import check_rapids, rapid_findings
from .rapid_ways import WayEntries
from .search import find_entries
from .spots import MOST_SPOTS, deepest_of, spots
from .swept_motion import SweptMotion, real_motion, straight_motion, without_ways

ROUGHLY = 0.1
"""mm; so well is known of most blocks how deep shank and holder are in the part. Whether they are is known to
the tolerance all the same."""

CLOSER = 512
"""Blocks, those that may be deepest, of which it is known as well as of the cutter."""

GOUGES = (Code.OVERCUT, Code.RAPID_COLLISION, Code.HOLDER_COLLISION)
"""The codes of the findings."""

LIFT, TILT = Choice("gouge", ("lift", "leave-out")), Choice("gouge", ("tilt", "leave-out"))
DIVIDE = Choice("linearize", ("on",))
"""What helps, as the user asks for it."""
WITH_REMEDY = {
    Code.OVERCUT: Template("The cutter goes {depth} too deep into the part at {at}."),
    Code.RAPID_COLLISION: Template(
        "The cutter goes {depth} into the part at {at} on its way between passes. Use a larger clearance; "
        "where the part is over the tool, let it be lifted there or leave such places out ({lift})."
    ),
    Code.HOLDER_COLLISION: Template("The {part} goes {depth} into the part at {at}."),
}

PLAIN = {
    Code.OVERCUT: WITH_REMEDY[Code.OVERCUT],
    Code.RAPID_COLLISION: Template("The cutter goes {depth} into the part at {at}, not cutting."),
    Code.HOLDER_COLLISION: WITH_REMEDY[Code.HOLDER_COLLISION],
}
"""The same of a program that is only looked at: what helps is not ours to do."""

CURES = say(
    "Let the tool be lifted there or leave such places out ({lift}), or use a smaller cutter; where the "
    "machine leaves the path by as much, let blocks be divided ({divide}).",
    lift=LIFT,
    divide=DIVIDE,
)
"""What is said against an overcut where nothing has been done yet."""

FREEING = say(
    "Let the tool be tilted free or leave these places out ({tilt}), use a longer tool, or more lead or "
    "tilt.",
    tilt=TILT,
)
"""What is said against an entry of shank or holder where nothing has been done yet."""

Where = Callable[[int], tuple[int | None, int | None]]
"""From a block of the swept motion to the block of the program and the line of the NC file."""


@dataclass(frozen=True, eq=False)
class GougeCheck:
    """``cutter`` and ``above`` (shank, holder and spindle): their entries, a row a block of the swept motion;
    ``buried`` (m,) blocks that are wholly in the part; ``findings``. ``ways``: what the tool enters on rapids
    whose axes may run independently, None where they are interpolated."""

    cutter: Entries
    above: Entries
    buried: Bools
    findings: tuple[Finding, ...]
    ways: WayEntries | None = None

    def cases(self, motion: Bytes) -> tuple[tuple[Code, Entries, Floats], ...]:
        """Return the three kinds of entries: code, entries, and their depths (m,) mm, 0 in blocks that have
        none of this kind; ``motion`` (m,) what each block does."""
        return _cases(self.cutter, self.above, motion)


def _cases(cutter: Entries, above: Entries, motion: Bytes) -> tuple[tuple[Code, Entries, Floats], ...]:
    cuts = (motion == Motion.CUT) | (motion == Motion.FILL)
    return (
        (Code.OVERCUT, cutter, cutter.depth * cuts),
        (Code.RAPID_COLLISION, cutter, cutter.depth * ~cuts),
        (Code.HOLDER_COLLISION, above, above.depth),
    )


def check_motion(
    mesh: Mesh, body: Body, swept: SweptMotion, motion: Bytes, tolerance: float, where: Where | None = None,
    progress: Progress = silent, remedy: str = CURES, freeing: str = FREEING,
) -> GougeCheck:  # fmt: skip
    """Check every block of a swept motion against the whole mesh.

    ``motion`` (m,) of Motion, what each block does; ``tolerance`` mm: entries up to it are no findings, and
    none deeper is missed. ``where`` tells blocks and lines of the findings; ``remedy``: what the findings
    advise against overcuts, empty where nothing can be changed here; ``freeing``: likewise against entries of
    shank and holder.
    """
    tree = facet_tree(mesh)
    cutter = find_entries(body.only(CUTTER), tree, swept, tolerance, progress=progress)
    above = _find_above(body.only(SHANK, HOLDER, SPINDLE), tree, swept, tolerance, progress)
    buried = np.zeros(len(swept), np.bool_)
    if is_closed(mesh):
        buried = find_buried_blocks(tree, body.only(CUTTER), swept, cutter.depth)
    whole = crossing_depth(body.only(CUTTER)) if is_closed(mesh) else np.inf
    findings = _findings(
        cutter,
        above,
        buried,
        motion,
        tolerance,
        where or (lambda block: (block, None)),
        swept,
        whole,
        remedy,
        freeing,
    )
    return GougeCheck(cutter, above, buried, findings)


def _find_above(
    above: Body, tree: FacetTree, swept: SweptMotion, tolerance: float, progress: Progress
) -> Entries:
    """Find the entries of what is ``above`` the cutter: roughly, then closely in the blocks of which some may
    be deepest."""
    rough = find_entries(above, tree, swept, tolerance, ROUGHLY, progress=progress)
    blocks = np.flatnonzero(rough.depth)
    blocks = blocks[np.argsort(-rough.bound[blocks], kind="stable")[:CLOSER]]
    if len(blocks):
        rough.replace_rows(find_entries(above, tree, swept, tolerance, None, blocks, progress), blocks)
    return rough


def program_motion(kinematics: Chain, program: Program, back: float = 0.0) -> SweptMotion:
    """Return the way that the machine really goes: block i of the swept motion leads to row i + 1 of the
    program; one whose way is not known stands at its end.

    ``back`` mm: how far above the tip the point lies that the words drive. Where the controller guides the
    tip, its way is taken to be straight and the axis to turn on great arcs.
    """
    unknown = find_unknown_ways(program)
    if program.guided is None:
        return without_ways(real_motion(kinematics, program.words, back), unknown)
    tips, axes = forward(kinematics, words_to_q(program.words))
    return without_ways(straight_motion(tips - back * axes, axes), unknown)


def check_program(
    mesh: Mesh, body: Body, kinematics: Chain, program: Program, tolerance: float, back: float = 0.0,
    progress: Progress = silent,
    remedy: str = CURES, rapids: str = INTERPOLATED, freeing: str = FREEING,
) -> GougeCheck:  # fmt: skip
    """Check every block of a program, along the way that the machine really goes; see :func:`check_motion`
    and :func:`program_motion`. ``rapids``: one of :data:`~.base.rapids.RAPIDS`; where the axes may run
    independently, rapids are checked on every way between their ends, too."""
    swept = program_motion(kinematics, program, back)

    def where(block: int) -> tuple[int | None, int | None]:
        return block + 1, int(program.line[block + 1])

    check = check_motion(
        mesh,
        body,
        swept,
        program.motion[1:],
        tolerance,
        where,
        progress=progress,
        remedy=remedy,
        freeing=freeing,
    )
    if rapids == INTERPOLATED:
        return check
    known = (check.cutter.depth > 0.0) | (check.above.depth > 0.0)
    ways = check_rapids(
        mesh, body, JointSpace.of(kinematics, back), program, tolerance, ROUGHLY, known, progress
    )
    return replace(
        check, ways=ways, findings=check.findings + rapid_findings(ways, program, tolerance, rapids)
    )


def _findings(
    cutter: Entries, above: Entries, buried: Bools, motion: Bytes, tolerance: float, where: Where,
    swept: SweptMotion,
    whole: float, remedy: str, freeing: str,
) -> tuple[Finding, ...]:  # fmt: skip
    found: list[Finding] = []
    advice = {Code.OVERCUT: remedy, Code.HOLDER_COLLISION: freeing if remedy else ""}
    for code, entries, depth in _cases(cutter, above, motion):
        found += _spots(
            code,
            WITH_REMEDY if remedy else PLAIN,
            advice.get(code, ""),
            entries,
            depth,
            tolerance,
            where,
            whole if entries is cutter else np.inf,
        )
    return (*found, *_report_buried(buried, where, swept))


def _spots(
    code: Code, words: Mapping[Code, Template], remedy: str, entries: Entries, depth: Floats,
    tolerance: float, where: Where, whole: float,
) -> list[Finding]:  # fmt: skip
    """Return the deepest block of each of the deepest spots; the first one says how many there are. From a
    depth of ``whole`` mm on more than the depth may be in the part. ``words``: what is said of each code,
    before its ``remedy``."""
    worst, blocks = spots(depth)
    found = []
    for k, block in enumerate(worst[:MOST_SPOTS].tolist()):
        x, y, z = entries.place[block].tolist()
        amount: Length | Sentence = Length(depth[block], ".4g")
        amount = say("at least {depth}", depth=amount) if depth[block] >= whole else amount
        sentence = words[code].say(
            depth=amount, at=Point((x, y, z)), part=PARTS[int(entries.part[block])], lift=LIFT
        )
        sentence = join_sentences((sentence, remedy))
        if k == 0 and blocks > 1:
            sentence += deepest_of(blocks, len(worst))
        row, line = where(block)
        found.append(report_finding(code, sentence, float(depth[block]), tolerance, row, line, (x, y, z)))
    return found


def _report_buried(buried: Bools, where: Where, swept: SweptMotion) -> tuple[Finding, ...]:
    rows = np.flatnonzero(buried)
    if not len(rows):
        return ()
    x, y, z = swept.pose(rows[:1], np.zeros(1)).tip[:, 0].tolist()
    row, line = where(int(rows[0]))
    text = say(
        "In {count} blocks the whole cutter is inside the part, the first at {place}. Check the work zero and"
        " the units of the part.",
        count=len(rows),
        place=Point((x, y, z), ".6g"),
    )
    return (report_finding(Code.BURIED, text, float(len(rows)), 0.0, row, line, (x, y, z)),)
