# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the stages of :func:`.milling.mill` hand on, one record after the other; each holds all of the one
before it.

Whatever a stage has to say of what it did stands in the record's findings; what a later stage needs is a
field.
"""

from __future__ import annotations

from dataclasses import dataclass

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.toolpath.cl_path import CLPath
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath


@dataclass(frozen=True, eq=False)
class PlannedPasses:
    """The passes on the facets, and the frame (k,) of each, where the rotary axes are locked. ``findings``:
    sides that no pass touches, and what is to say of the passes."""

    contact: ContactPath
    frame: Ints | None
    findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class OffsetContacts(PlannedPasses):
    """The passes offset by the corner radius: ``offset``, with findings of its own."""

    offset: OffsetPath


@dataclass(frozen=True, eq=False)
class AssignedAxes(OffsetContacts):
    """``axis`` (n, 3): the strategy's tool axes, one for each row of ``offset``. ``corrected`` (m, 3): those
    after all corrections, one for each row of ``cut``, the rows that are left then. ``axis_findings``: of all
    that chose them."""

    axis: Floats
    cut: OffsetPath
    corrected: Floats
    axis_findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class LinkedPath(AssignedAxes):
    """The CL path, with findings of its own. ``cured``: whether rows were lifted or left out for the part's
    sake; ``entering``: how deep, mm, what that leaves of entries into the part may be."""

    path: CLPath
    cured: bool
    entering: float


@dataclass(frozen=True, eq=False)
class SolvedJoints(LinkedPath):
    """The joint path along the CL path."""

    joints: JointPath
