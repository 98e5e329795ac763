# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a job's machine, as axes and branches are chosen to keep out of them."""

from __future__ import annotations

from collections.abc import Sequence

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_check import InMachine
from freecad_fiveaxis.core.gouge.machine_in_pose import MachineInPose, machine_in_pose
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain

from .options import resolve_setup, tip_to_driven, tool_body
from .settings import Settings


def bodies_in_pose(
    settings: Settings,
    machine: Machine,
    kinematics: Chain,
    mesh: Mesh,
    fixtures: Sequence[Fixture],
    progress: Progress,
    margin: float = 0.0,
) -> MachineInPose | None:
    """Prepare the bodies of a machine with part and fixtures on it, ``kinematics`` with the limits that
    count, ``margin`` as of :class:`MachineInPose`; None where its file names none. Raises FiveAxisError for
    the file of a body that cannot be used."""
    if not machine.bodies:
        return None
    _, setup, _ = resolve_setup(settings, machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    given = InMachine(
        machine,
        setup,
        kinematics,
        tool_body(settings),
        length,
        tip_to_driven(settings),
        fixtures=tuple(fixtures),
    )
    return machine_in_pose(given, mesh, settings.proof.tolerance, progress, margin)
