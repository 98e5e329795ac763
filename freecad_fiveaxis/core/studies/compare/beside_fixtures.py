# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs of a comparison against fixtures: each row's own, on the way that its machine goes.

rapids    are taken as they are interpolated: where they may not be, ``mill`` divides them until every way is
          free.
guided    where the controller guides the tip this goes straight, and the axis turns on great arcs, as
          :func:`~.check.check_program` takes it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

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


class Meeting(NamedTuple):
    """The worst that a program does to a ``fixture``: ``room`` mm that is left, below 0: so deep it enters,
    -inf: the whole cutter is in it; ``found`` says it."""

    fixture: str
    room: float
    found: Finding


def find_worst_meeting(findings: Sequence[Finding] | None) -> Meeting | None:
    """Return what is deepest in a fixture, else what is nearest to one; None where all keep the clearance."""
    met = [_meeting(one) for one in findings or () if one.code in (Code.FIXTURE_COLLISION, Code.FIXTURE_NEAR)]
    return min(met, key=lambda one: one.room, default=None)


def hits_fixture(findings: Sequence[Finding] | None) -> bool:
    """Whether something enters a fixture."""
    return any(one.code == Code.FIXTURE_COLLISION for one in findings or ())


def _meeting(found: Finding) -> Meeting:
    hit, value = found.hit or found.near, found.value or 0.0
    room = value if found.code == Code.FIXTURE_NEAR else -value if found.unit == "mm" else -math.inf
    return Meeting(hit.entered if hit else "", room, found)
