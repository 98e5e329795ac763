# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes through all stages of a job: stages take it and the last record, and give the next one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture, box_with, join_obstacles
from freecad_fiveaxis.core.gouge.machine_in_pose import MachineInPose
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.orientation.facets_with_axis import AxisField
from freecad_fiveaxis.core.passes.boundary import Boundary
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.passes.keep_off import KeepOff

from .settings import Settings

Box = tuple[Floats, Floats]
"""Low and high corner (3,) mm, work frame."""


def obstacles_of(mesh: Mesh, fixtures: Sequence[Fixture], keep_off: KeepOff | None) -> tuple[Mesh, Box]:
    """Join what the tool keeps out of, the part's facets first, and find the box that rapids stay off."""
    joined, box = join_obstacles(mesh, fixtures), box_with(mesh.box, fixtures)
    return (joined, box) if keep_off is None else (keep_off.obstacle(joined), keep_off.box_with(box))


@dataclass(frozen=True, eq=False)
class JobContext:
    """``kinematics``: the machine's, with the part where it stands; ``dialect``: as it is to be written;
    ``box``: what rapids stay off: the part's, or, where no part is known, that of the feed moves."""

    settings: Settings
    machine: Machine
    kinematics: Chain
    dialect: Dialect
    box: Box
    progress: Progress


@dataclass(frozen=True, eq=False)
class PostContext(JobContext):
    """Without the part: ``cuts``: the box of the cutting points, which stands for the part where the program
    begins and ends; ``fixtures``: that stand beside it."""

    cuts: Box
    fixtures: tuple[Fixture, ...] = ()


@dataclass(frozen=True, eq=False)
class MillContext(JobContext):
    """With the part: ``keep`` (f,) are the facets of ``mesh`` that are cut; the others are kept clear of.
    ``field``: of the tool axes on them, where the strategy chooses these by what is free; ``joined``: part
    and fixtures, where there are some; ``chosen`` (f,): the facets that may be machined at all, where not all
    may; ``boundary``: within which the passes are kept; ``frames``: of passes with locked rotary axes;
    ``keep_off``: faces to avoid on which there is an allowance; ``bodies``: of the machine, which axes are
    chosen to keep out of, None: there are none, or axes are not chosen;
    ``fixtures``: that stand beside the part; ``unreached``: whether facets are left out because nothing
    reaches them; ``floors``: as of a Reacher, for what the part stands on."""

    mesh: Mesh
    keep: Bools
    field: AxisField | None = None
    joined: Mesh | None = None
    chosen: Bools | None = None
    boundary: Boundary | None = None
    frames: Frames | None = None
    keep_off: KeepOff | None = None
    bodies: MachineInPose | None = None
    fixtures: tuple[Fixture, ...] = ()
    unreached: bool = False
    floors: tuple[float, ...] = ()

    @property
    def obstacles(self) -> Mesh:
        """What the tool is kept out of; the part's facets come first in it."""
        return self.mesh if self.joined is None else self.joined
