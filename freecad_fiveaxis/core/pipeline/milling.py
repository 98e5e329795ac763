# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid to a program: :data:`STAGES`, in the order of the process.

A stage is ``stage(context, record) -> record``: a function named by what it does, in the module that bears
its part of the process. The first takes the region that is cut, the last gives the program.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from freecad_fiveaxis.core.passes import Region

from .assign_axes import assign_axes
from .begin_rings import TO_JOINTS, begin_rings_within_limits
from .context import MillContext
from .mill_context import find_region
from .plan_passes import plan_passes
from .programs import MilledProgram
from .round_bodies import keep_links_off_bodies
from .solve_joints import keep_rapids_clear, write_program

Stage = Callable[[MillContext, Any], Any]

UNCORRECTED = TO_JOINTS.index(assign_axes) + 1
TO_AXES: tuple[Stage, ...] = (plan_passes, *TO_JOINTS[:UNCORRECTED])
"""The stages up to the strategy's tool axes, which no correction changes."""
TO_PATH: tuple[Stage, ...] = TO_JOINTS[UNCORRECTED:-1]
"""Those from there to the CL path, corrections first."""
FROM_JOINTS: tuple[Stage, ...] = (begin_rings_within_limits, keep_links_off_bodies, keep_rapids_clear)
"""Those behind the joints."""

STAGES: tuple[Stage, ...] = (plan_passes, *TO_JOINTS, *FROM_JOINTS, write_program)


Seen = Callable[[MillContext, Any], None]
"""Whoever is to see the records of the stages, with the context that they were made in."""


def mill(context: MillContext, seen: Seen | None = None) -> MilledProgram:
    """Make the program: every stage, one after the other; ``seen`` gets the record of each."""
    program: MilledProgram = run_stages(STAGES, context, begin(context), seen)
    return program


def begin(context: MillContext) -> Region:
    """Return what the first stage takes: the region that is cut."""
    return find_region(
        context.settings, context.mesh, context.keep, context.progress, context.frames, field=context.field
    )


def run_stages(stages: Sequence[Stage], context: MillContext, record: Any, seen: Seen | None = None) -> Any:
    """Hand the record through these stages; ``seen`` gets that of each."""
    for stage in stages:
        record = stage(context, record)
        if seen is not None:
            seen(context, record)
    return record
