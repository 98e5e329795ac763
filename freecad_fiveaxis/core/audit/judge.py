# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an audit says of a program beyond its deviation: limits, axis rates, feed, and where it leaves a path
or enters a part."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, body_of
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .against_cl import AgainstPath, against_path
from .against_part import AgainstPart, against_part
from .limits import Limits, check_limits
from .rates import Rates, compute_commanded_rates, feed_findings, rate_findings
from .tool_in_part import is_ball, tool_in_part
from .units import units_against


@dataclass(frozen=True)
class AuditOptions:
    """``tolerance`` mm, of overcuts too, and ``axis_tolerance`` rad against the CL path; the ``cutter``;
    ``body``: cutter, shank and holder where all of them, and rapids, are held against the part, None: a ball
    cutter's ball alone; ``above`` mm: so far over the driven point lies the one that is held against a CL
    path; ``rapids``: how the controller drives them; ``inverse_time``: its word for it, "" where it has
    none."""

    tolerance: float
    axis_tolerance: float
    cutter: Cutter
    body: Body | None = None
    above: float = 0.0
    rapids: str = INTERPOLATED
    inverse_time: str = "G93"


@dataclass(frozen=True, eq=False)
class Audit:
    """All of it, one row a block; ``path`` or ``part``: what it was compared with, None where with none."""

    rates: Rates
    limits: Limits
    path: AgainstPath | None = None
    part: AgainstPart | None = None
    findings: tuple[Finding, ...] = ()

    def off(self) -> tuple[Floats, Floats]:
        """Distance off the path, or depth in the part, and its proven bound (m,) mm of every block; 0 in
        rapids."""
        value, bound = np.zeros((2, len(self.rates.ratio)))
        if self.path is not None:
            value[self.path.block], bound[self.path.block] = self.path.off, self.path.bound
        if self.part is not None:
            value[self.part.block], bound[self.part.block] = self.part.depth, self.part.bound
        return value, bound


def audit_program(
    kinematics: Chain, program: Program, deviation: Deviation, against: CLPath | Mesh | None,
    options: AuditOptions,
    progress: Progress = silent,
) -> Audit:  # fmt: skip
    """Return the audit of a program whose deviation is measured, against a CL path, a part, or neither."""
    rates, limits = compute_commanded_rates(kinematics, program, progress), check_limits(kinematics, program)
    found = (
        *limits.findings,
        *rate_findings(kinematics, program, rates),
        *feed_findings(kinematics, program, rates, options.inverse_time),
    )
    path = part = None
    if against is not None:
        found += units_against(kinematics, program, against)
    if isinstance(against, CLPath):
        above = options.above if program.guided is None else 0.0
        path = against_path(
            kinematics,
            program,
            deviation,
            against,
            options.tolerance,
            options.axis_tolerance,
            progress,
            above,
        )
        found += path.findings
    elif against is not None:
        part = _in_part(kinematics, program, against, options, progress)
        found += part.findings
    return Audit(rates, limits, path, part, found)


def _in_part(
    kinematics: Chain, program: Program, mesh: Mesh, options: AuditOptions, progress: Progress
) -> AgainstPart:
    cutter, body, tolerance = options.cutter, options.body, options.tolerance
    if body is None and is_ball(cutter):
        return against_part(kinematics, program, mesh, cutter.radius, tolerance, progress)
    return tool_in_part(
        kinematics, program, mesh, cutter, body or body_of(cutter), tolerance, progress, options.rapids
    )
