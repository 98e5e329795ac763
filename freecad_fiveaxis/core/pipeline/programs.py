# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a job makes: a program on its way, and the proven one."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from freecad_fiveaxis.core.audit import Audit
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Sentence
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import GougeCheck, RestMaterial
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.singularity import Singularity
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.passes.boundary import Boundary
from freecad_fiveaxis.core.passes.keep_off import KeepOff
from freecad_fiveaxis.core.toolpath.cl_path import CLPath
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .context import MillContext, obstacles_of
from .settings import Settings
from .start_plane import StartPlane


@dataclass(frozen=True, eq=False)
class ProgramDraft:
    """A program of rounded words, not yet proven, with the machine that it is for, and the fixtures that the
    tool is to keep out of; ``assumed``: what is taken for granted because the NC text does not say it."""

    settings: Settings
    machine: Machine
    kinematics: Chain
    dialect: Dialect
    program: Program
    findings: tuple[Finding, ...]
    fixtures: tuple[Fixture, ...] = field(default=(), kw_only=True)
    assumed: tuple[Sentence, ...] = field(default=(), kw_only=True)


@dataclass(frozen=True, eq=False)
class PostedProgram(ProgramDraft):
    """A program made here: the CL path, the joints and the NC file's bytes; ``plane``: on which it begins and
    ends."""

    path: CLPath
    joints: JointPath
    nc: bytes
    plane: StartPlane = field(default=StartPlane(None), kw_only=True)


class MillSource(NamedTuple):
    """What a program was to be made of: settings, the part, the facets (f,) of it that were chosen, None:
    all, and the fixtures."""

    settings: Settings
    mesh: Mesh
    faces: Bools | None
    fixtures: tuple[Fixture, ...]


@dataclass(frozen=True, eq=False)
class MilledProgram(PostedProgram):
    """A program made from a mesh. ``axis`` (n, 3): the strategy's tool axes, before any cure, one for each
    row of ``offset``; ``keep`` (f,): the facets that are machined; ``boundary``: within which, where there is
    one; ``keep_off``: faces to avoid on which there is an allowance; ``entering``: as of a LinkedPath;
    ``given``: what it was to be made of."""

    mesh: Mesh
    contact: ContactPath
    offset: OffsetPath
    axis: Floats
    keep: Bools
    boundary: Boundary | None = field(default=None, kw_only=True)
    keep_off: KeepOff | None = field(default=None, kw_only=True)
    entering: float = field(default=0.0, kw_only=True)
    given: MillSource | None = field(default=None, kw_only=True)

    def context(self, progress: Progress) -> MillContext:
        """Return what the stages took that made it, with another progress to tell."""
        joined, box = obstacles_of(self.mesh, self.fixtures, self.keep_off)
        return MillContext(
            self.settings,
            self.machine,
            self.kinematics,
            self.dialect,
            box,
            progress,
            self.mesh,
            self.keep,
            None,
            joined,
            boundary=self.boundary,
            keep_off=self.keep_off,
            fixtures=self.fixtures,
        )


@dataclass(frozen=True, eq=False)
class Result:
    """A proven program. ``findings`` of every stage, in the order of the pipeline. ``surface``: the deviation
    of the point that makes the surface (a ball's centre) where that is not the driven one, with the driven
    one's place there. ``audit``: only of a program not made here; ``gouge`` and ``rest``: what enters the
    part on the real way, and what stays on it, where the settings ask for that."""

    draft: ProgramDraft
    deviation: Deviation
    singularity: Singularity
    findings: tuple[Finding, ...]
    audit: Audit | None = None
    gouge: GougeCheck | None = None
    rest: RestMaterial | None = None
    surface: Deviation | None = None
