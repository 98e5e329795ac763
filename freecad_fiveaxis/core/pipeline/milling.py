# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid to a program: :data:`STAGES`, in the order of the process.

A stage is ``stage(context, record) -> record``: a function named by what it does, in the module that bears
its part of the process. The first takes the region that is cut, the last gives the program.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .begin_rings import TO_JOINTS, begin_rings_within_limits
from .context import MillContext
from .mill_context import find_region
from .plan_passes import plan_passes
from .programs import MilledProgram
from .round_bodies import keep_links_off_bodies
from .solve_joints import keep_rapids_clear, write_program

Stage = Callable[[MillContext, Any], Any]

STAGES: tuple[Stage, ...] = (
    plan_passes,
    *TO_JOINTS,
    begin_rings_within_limits,
    keep_links_off_bodies,
    keep_rapids_clear,
    write_program,
)


def mill(context: MillContext) -> MilledProgram:
    """Make the program: every stage, one after the other."""
    record: Any = find_region(context.settings, context.mesh, context.keep, context.progress, context.frames)
    for stage in STAGES:
        record = stage(context, record)
    program: MilledProgram = record
    return program
