# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs of a comparison against fixtures: each row's own, on the way that its machine goes.

rapids    are taken as they are interpolated: where they may not be, ``mill`` divides them until every way is
          free.
guided    where the controller guides the tip this goes straight, and the axis turns on great arcs, as
          :func:`~.check.check_program` takes it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.gouge.fixtures import Fixture, check_fixtures
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.program.guided import Guided, standing
from freecad_fiveaxis.core.tool.body import Body


@dataclass(frozen=True, eq=False)
class Beside:
    """The ``fixtures`` of a station, work frame; ``body``: the tool, and what the spindle carries over it;
    ``rapid``: what of it keeps off the box of part and fixtures where the tool retracts, heights from the
    driven point, ``back`` mm above the tip. ``tolerance`` mm may be entered, nearer than ``clearance`` mm is
    told."""

    fixtures: tuple[Fixture, ...]
    body: Body
    rapid: Body
    back: float
    tolerance: float
    clearance: float = 0.0


def find_hits(
    beside: Beside, kinematics: Chain, program: Program, progress: Progress = silent
) -> tuple[Finding, ...]:
    """Find what of tool and spindle goes into a fixture, or comes too near to one."""
    return check_fixtures(
        beside.fixtures, beside.body, kinematics, program, beside.tolerance, beside.back, progress,
        clearance=beside.clearance,
    )  # fmt: skip


def guide_tip(kinematics: Chain, program: Program, tip: Floats) -> Program:
    """Return the program as it is where the controller guides the tip, ``tip`` (m, 3) mm in its blocks."""
    stands = standing(kinematics, tip, program.words[:, 3:])
    return replace(program, words=stands, guided=Guided(np.ones(len(tip), np.bool_), tip))


def find_deepest(findings: Sequence[Finding] | None) -> Finding | None:
    """Return the deepest entry into a fixture; None where nothing enters one."""
    found = [one for one in findings or () if one.code == Code.FIXTURE_COLLISION]
    return max(found, key=_depth_of) if found else None


def find_nearest(findings: Sequence[Finding] | None) -> Finding | None:
    """Return what comes nearest to a fixture; None where all keep the clearance."""
    found = [one for one in findings or () if one.code == Code.FIXTURE_NEAR]
    return min(found, key=lambda one: one.value or 0.0) if found else None


def _depth_of(found: Finding) -> float:
    """mm; of a cutter that is wholly in a fixture it is not known, and more than any."""
    return found.value if found.unit == "mm" and found.value is not None else np.inf
