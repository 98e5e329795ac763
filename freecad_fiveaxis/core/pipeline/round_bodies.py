# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stage that lays links, retracts and rewinds round the bodies of the machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, join_sentences, say
from freecad_fiveaxis.core.gouge.body_pairs import REMEDY
from freecad_fiveaxis.core.gouge.machine_blocks import MachineBlocks
from freecad_fiveaxis.core.gouge.machine_check import InMachine
from freecad_fiveaxis.core.links.raise_links import Hits, Raised, raise_links, raising_axis
from freecad_fiveaxis.core.machine.kinematics import Chain, chain, joint_words
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.joint_path.plan import LINEAR_SLACK
from freecad_fiveaxis.core.motion.program import build_program
from freecad_fiveaxis.core.tool.stick_out import LONGER_BY, Stack, clamp_tool

from .context import MillContext
from .options import rapids_of, resolve_setup, tip_to_driven, tool_body
from .records import SolvedJoints


def keep_links_off_bodies(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Raise links, retracts and rewinds in which tool, spindle or a body of the machine would hit something,
    where the machine's file names bodies and the part is looked at."""
    settings, kinematics = context.settings, context.kinematics
    if not context.machine.bodies or settings.gouge.gouge == "off" or context.dialect.guide is not None:
        return solved
    given = _in_machine(context)
    raised = raise_links(solved.joints, kinematics, _hits(context, given), settings.links.clearance)
    if not len(raised.row):
        return solved
    found = (*_report_raised(raised), *_no_way_finding(context, given, raised))
    joints = raised.joints
    return replace(solved, joints=replace(joints, findings=(*joints.findings, *found)))


def _in_machine(context: MillContext) -> InMachine:
    """Return what is checked, as the finished program is."""
    settings = context.settings
    machine, setup, _ = resolve_setup(settings, context.machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    rapids = rapids_of(settings, machine, context.dialect)
    return InMachine(
        machine, setup, context.kinematics, tool_body(settings), length, tip_to_driven(settings), rapids,
        fixtures=context.fixtures,
    )  # fmt: skip


def _hits(context: MillContext, given: InMachine) -> Hits:
    """Return what tells of rows whether the way to them is proven, of the words as they are printed."""
    limit = context.settings.proof.tolerance
    blocks = MachineBlocks(given, context.mesh, context.obstacles, limit, context.progress)

    def hits(joints: JointPath, rows: Ints, tool: bool) -> Bools:
        """Rows that stand still are no blocks of the program: what leads to them hits nothing."""
        program = build_program(joints, given.kinematics, context.dialect, False)
        at = np.minimum(np.searchsorted(program.row, rows), len(program.row) - 1)
        moves = np.flatnonzero((program.row[at] == rows) & (at > 0))
        hit = np.zeros(len(rows), np.bool_)
        hit[moves] = blocks.which_hit(program, at[moves] - 1, tool)
        return hit

    return hits


def _report_raised(raised: Raised) -> tuple[Finding, ...]:
    """How many links were raised, and by how much at most."""
    if not raised.height.any():
        return ()
    worst, count = int(raised.height.argmax()), int(np.count_nonzero(raised.height))
    text = say(
        "{count} links or rewinds go round bodies of the machine, at most {height} higher than over the part "
        "alone.",
        count=count,
        height=Length(raised.height[worst], ".4g"),
    )
    return (_at(Code.LINKS_RAISED, raised, worst, text, float(raised.height[worst])),)


def _no_way_finding(context: MillContext, given: InMachine, raised: Raised) -> tuple[Finding, ...]:
    """Return what is missing where no height within the travel helps: travel, or length of the tool."""
    left = raised.height == 0.0
    if not left.any():
        return ()
    missing = np.where(left, raised.wanted - raised.room, 0.0)
    kinematics, up = context.kinematics, raising_axis(context.kinematics)
    limit = kinematics.high[up] if kinematics.direction[up, 2] > 0.0 else kinematics.low[up]
    worst = int(np.argmax(np.where(np.isnan(missing), np.inf, missing)))
    text = say(
        "In {count} links or rewinds something hits the machine, and within its travel {letter} cannot go "
        "round it.",
        count=int(np.count_nonzero(left)),
        letter=kinematics.letters[up],
    )
    if np.isfinite(missing[worst]):
        more = say(
            "{letter} would have to go {more} higher than its limit {limit}.",
            letter=kinematics.letters[up],
            more=Length(missing[worst], ".4g"),
            limit=Length(limit, ".6g"),
        )
    else:
        more = say("No height frees all of them: what hits there does so as it retracts or comes down.")
    value = float(missing[worst]) if np.isfinite(missing[worst]) else None
    text = join_sentences((text, more, _longer_tool(context, given, raised), REMEDY))
    return (_at(Code.NO_WAY_ROUND, raised, worst, text, value),)


def _longer_tool(context: MillContext, given: InMachine, raised: Raised) -> str:
    """Say by how much the tool would have to stick out farther; nothing where its length is not known, or
    where none does that is up to the last of LONGER_BY longer."""
    if given.length is None:
        return ""
    for more in LONGER_BY:
        longer = _stick_out(context, given, more)
        q = joint_words(longer.kinematics, raised.joints.path.tip, raised.joints.q[:, 3:])
        if not _is_within_travel(longer.kinematics, q):
            continue
        joints = replace(raised.joints, q=q)
        tried = raise_links(joints, longer.kinematics, _hits(context, longer), 0.0)
        if (tried.height > 0.0).all():
            return say("With a tool that sticks out {more} farther there is a way.", more=Length(more))
    return ""


def _is_within_travel(kinematics: Chain, q: Floats) -> bool:
    """Whether the linear words of joints (n, 5) lie within their limits."""
    low, high = kinematics.low[:3] - LINEAR_SLACK, kinematics.high[:3] + LINEAR_SLACK
    return bool(((q[:, :3] >= low) & (q[:, :3] <= high)).all())


def _stick_out(context: MillContext, given: InMachine, more: float) -> InMachine:
    """Return the same with a tool that sticks out ``more`` mm farther."""
    gouge = context.settings.gouge
    stack = Stack(context.settings.cutter.cutter, gouge.shank, gouge.holder)
    setup = replace(given.setup, tool_length=given.setup.tool_length + more)
    new, old = chain(given.machine, setup), given.kinematics
    low, high = np.append(new.low[:3], old.low[3:]), np.append(new.high[:3], old.high[3:])
    body = clamp_tool(stack, stack.stick_out + more).body
    kinematics, length = replace(new, low=low, high=high), (given.length or 0.0) + more
    return replace(given, setup=setup, kinematics=kinematics, body=body, length=length)


def _at(code: Code, raised: Raised, gap: int, text: str, value: float | None) -> Finding:
    """Return the finding at the row where a gap begins."""
    row = int(raised.row[gap])
    x, y, z = raised.joints.path.tip[row].tolist()
    return report_finding(code, text, value, block=row, place=(x, y, z))
