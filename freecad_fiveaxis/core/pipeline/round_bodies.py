# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stage that lays links, retracts and rewinds round the bodies of the machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.gouge.lift import AIM
from freecad_fiveaxis.core.gouge.machine_blocks import MachineBlocks
from freecad_fiveaxis.core.gouge.machine_check import InMachine
from freecad_fiveaxis.core.links.raise_links import Raised, raise_links
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import build_program

from .context import MillContext
from .options import rapids_of, resolve_setup, tip_to_driven, tool_body
from .records import SolvedJoints


def keep_links_off_bodies(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Raise links, retracts and rewinds in which tool, spindle or a body of the machine would hit something,
    where the machine's file names bodies and the part is looked at."""
    settings = context.settings
    if not context.machine.bodies or settings.gouge.gouge == "off" or context.dialect.guide is not None:
        return solved
    blocks = MachineBlocks(
        _in_machine(context),
        context.mesh,
        context.obstacles,
        AIM * settings.proof.tolerance,
        context.progress,
    )

    def hits(joints: JointPath, rows: Ints) -> Bools:
        """Rows that stand still are no blocks of the program: what leads to them hits nothing."""
        program = build_program(joints, context.kinematics, context.dialect, False)
        at = np.minimum(np.searchsorted(program.row, rows), len(program.row) - 1)
        moves = np.flatnonzero((program.row[at] == rows) & (at > 0))
        hit = np.zeros(len(rows), np.bool_)
        hit[moves] = blocks.which_hit(program, at[moves] - 1)
        return hit

    raised = raise_links(solved.joints, context.kinematics, hits, settings.links.clearance)
    if not len(raised.row):
        return solved
    joints = raised.joints
    return replace(solved, joints=replace(joints, findings=(*joints.findings, *_findings(raised))))


def _in_machine(context: MillContext) -> InMachine:
    """What is checked, as the finished program is."""
    settings = context.settings
    machine, setup, _ = resolve_setup(settings, context.machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    rapids = rapids_of(settings, machine, context.dialect)
    return InMachine(
        machine, setup, context.kinematics, tool_body(settings), length, tip_to_driven(settings), rapids,
        fixtures=context.fixtures,
    )  # fmt: skip


def _findings(raised: Raised) -> tuple[Finding, ...]:
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
    row = int(raised.row[worst])
    x, y, z = raised.joints.path.tip[row].tolist()
    return (report_finding(Code.LINKS_RAISED, text, float(raised.height[worst]), block=row, place=(x, y, z)),)
