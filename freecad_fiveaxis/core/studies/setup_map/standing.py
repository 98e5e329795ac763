# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine as it stands in one setup of a map, with part, fixtures and table, and what of the tool meets
which of them on the real way of every block.

more      mm by which the tool sticks out farther than it does: holder and spindle stand as much higher above
          the tip, and a tool whose length is known is as much longer, with the words that come of that.
above     of the tool what a longer stick-out lifts, or takes the place of: shank, holder and spindle. What
          the cutter meets it meets whatever its stick-out; the program's own check tells that.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Choice
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces
from freecad_fiveaxis.core.gouge.check import program_motion
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_bodies import spindle_body
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine, is_held
from freecad_fiveaxis.core.gouge.search import find_entries
from freecad_fiveaxis.core.gouge.swept_motion import SweptMotion
from freecad_fiveaxis.core.gouge.table_check import stays_above, table_slab
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.joint_path.plan import LINEAR_SLACK
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import HOLDER, PARTS, SHANK, SPINDLE, Body
from freecad_fiveaxis.core.tool.stick_out import Stack, clamp_tool
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .driven import turn_path, turn_points

PART, TABLE, LIMITS = "part", "table", "limits"
"""What is met, beside fixtures and bodies of the machine, which have names of their own."""

ROUGHLY = 0.1
"""mm; so well is known how deep something is met. Whether it is, is known to the tolerance."""

HARDLY = 1.0 + 1e-9
"""Of the tolerance: bounds above it are no rounding."""

SUSPECTS = 512
"""Blocks that were met at another stick-out, the deepest of them: these are looked at first."""

SAMPLES = 256
"""Blocks that are looked at next, evenly over the program: where one of these meets something, the others
need no look."""


Post = Callable[[Chain, CLPath, Stack, float, Progress], tuple[JointPath, Program]]
"""Joints and program of a path that is turned by so much, rad, for this tool on this chain, blocks divided as
the settings ask."""


class Met(NamedTuple):
    """``enters``: shank, holder or spindle, or a body of the machine; ``entered``: PART, TABLE, LIMITS, or
    the name of a fixture or a body. ``depth`` mm: at least so deep, of LIMITS so far beyond them; 0.0 where
    it is only not proven that nothing is met, or where something only comes ``near``er than the clearance.
    ``place`` (3,) mm in the program's coordinates, None where the axes leave their limits or bodies of the
    machine meet."""

    enters: str
    entered: str
    depth: float
    place: Vector | None = None
    near: bool = False


@dataclass(frozen=True, eq=False)
class Standing:
    """``path`` and ``base`` as of :func:`~.mapping.setup_map`; ``origin`` mm and ``turn`` rad: the setup.
    ``post``: how the path becomes the program of ``mill``. ``part`` (None: not known) and ``fixtures`` as
    they lie at turn 0; ``table`` mm, machine frame.
    ``stack``: the tool; ``known``: whether its length is, that of ``base``; ``back`` mm from the tip up to
    the point that the words drive. ``clearance`` mm: holder and spindle keep so far off; ``tolerance``
    mm. ``axes_by``: the option by which ``mill`` would give another tool other axes than those of the path,
    None where it would not."""

    path: CLPath
    machine: Machine
    base: Setup
    post: Post
    origin: Vector
    turn: float
    part: Mesh | None
    fixtures: tuple[Fixture, ...]
    table: float | None
    stack: Stack
    known: bool
    back: float
    clearance: float
    tolerance: float
    axes_by: Choice | None = None

    def run(self, more: float = 0.0, progress: Progress = silent) -> Run:
        """Post the program of the setup, of a tool that sticks out ``more`` mm farther. Raises ReachError,
        SettingsError."""
        stack = clamp_tool(self.stack, self.stack.stick_out + more) if more else self.stack
        length = self.base.tool_length + (more if self.known else 0.0)  # else the words do not depend on it
        x, y, z = self.origin
        setup = Setup((x, y, z), length)
        kinematics, path = chain(self.machine, setup), turn_path(self.path, self.turn)
        joints, program = self.post(kinematics, path, stack, self.turn, progress)
        low, high = kinematics.low[:3] - joints.q[:, :3], joints.q[:, :3] - kinematics.high[:3]
        over = float(np.maximum(low, high).max(initial=0.0))
        return Run(
            self, stack, setup, kinematics, program, program_motion(kinematics, program, self.back), over,
            joints.rewinds,
        )  # fmt: skip

    @property
    def table_in_work(self) -> float | None:
        """The height of the table's face in the program's coordinates, mm; None where it is not known."""
        return None if self.table is None else self.table - self.origin[2]

    @property
    def turned_part(self) -> Mesh | None:
        """The part as it lies in the setup, in the program's coordinates."""
        return None if self.part is None else turn_mesh(self.part, self.turn)

    @property
    def turned_fixtures(self) -> tuple[Fixture, ...]:
        """The fixtures as they lie in the setup."""
        return tuple(replace(one, mesh=turn_mesh(one.mesh, self.turn)) for one in self.fixtures)


def turn_mesh(mesh: Mesh, turn: float) -> Mesh:
    """Turn a mesh counter-clockwise by ``turn`` rad about Z through the work zero."""
    return from_faces(turn_points(mesh.vertex, turn), mesh.face) if turn else mesh


@dataclass(frozen=True, eq=False)
class Run:
    """The program of a setup with one tool: ``swept`` its way, ``over`` mm: so far the linear axes leave
    their limits; ``rewinds``: how often the rotary axes turn back, and the whole tool retracts."""

    stand: Standing
    stack: Stack
    setup: Setup
    kinematics: Chain
    program: Program
    swept: SweptMotion
    over: float
    rewinds: int = 0

    def with_tool(self, more: float) -> Run:
        """Return the same program of a tool whose length nobody knows, ``more`` mm longer than that of the
        setup."""
        stack = self.stand.stack
        return replace(self, stack=clamp_tool(stack, stack.stick_out + more) if more else stack)

    @property
    def spindle(self) -> Body:
        """What is round of the spindle; nothing where the tool's length is not known."""
        stand = self.stand
        return spindle_body(stand.machine, self.setup.tool_length + stand.back) if stand.known else Body(())

    @property
    def above(self) -> Body:
        """As in the head of the module."""
        return Body((*self.stack.body.only(SHANK, HOLDER).pieces, *self.spindle.pieces))

    @property
    def apart(self) -> Body:
        """Shank, holder and spindle, the latter two grown by the clearance."""
        return Body(
            tuple(
                piece._replace(round=piece.round + self.stand.clearance * (piece.part in (HOLDER, SPINDLE)))
                for piece in self.above.pieces
            )
        )

    def bodies_beside(self, name: str) -> tuple[Body, Body]:
        """Return :attr:`above` and :attr:`apart`, as far as they are looked at beside what is called so. The
        table's face is a plane as wide as the machine: where the machine's file says what table and base are,
        the spindle is proven against these bodies, as by ``mill``, and not against the plane."""
        held = any(is_held(self.stand.machine, one) for one in self.stand.machine.bodies)
        parts = (SHANK, HOLDER) if name == TABLE and held else (SHANK, HOLDER, SPINDLE)
        return self.above.only(*parts), self.apart.only(*parts)

    @property
    def leaves_limits(self) -> Met | None:
        """How far the linear axes leave their limits, if they do."""
        return Met("", LIMITS, self.over) if self.over > LINEAR_SLACK else None

    def meets_machine(self, progress: Progress = silent, cutter: bool = False) -> Met | None:
        """Return the deepest that shank, holder, spindle or bodies of the machine go into a body of it, or of
        them into part or fixtures, and the ``cutter`` if asked; None where it is proven that nothing does."""
        stand, length = self.stand, self.setup.tool_length if self.stand.known else None
        given = InMachine(
            stand.machine, self.setup, self.kinematics,
            self.stack.body if cutter else self.stack.body.only(SHANK, HOLDER), length, stand.back,
            clearance=stand.clearance, fixtures=stand.turned_fixtures,
        )  # fmt: skip
        found = check_machine(given, self.program, stand.turned_part, stand.tolerance, progress)
        return max(map(_find_met, filter(_counts, found)), key=lambda met: met.depth, default=None)

    def table_tree(self, height: float) -> FacetTree | None:
        """Return the table, whose face is at ``height`` mm in the program's coordinates; None where bounds
        show that nothing comes near it."""
        if stays_above(height, self.bodies_beside(TABLE)[1], self.swept):
            return None
        return facet_tree(table_slab(height, self.kinematics, self.program))


def _counts(finding: Finding) -> bool:
    """Whether a finding of the machine's check says that a block meets something, or may."""
    return finding.code in (Code.MACHINE_COLLISION, Code.MACHINE_NEAR) or (
        finding.code == Code.MACHINE_UNPROVEN and finding.block is not None
    )


def _find_met(finding: Finding) -> Met:
    hit = finding.hit or finding.near
    depth, near = float(finding.value or 0.0) if finding.hit is not None else 0.0, finding.near is not None
    return Met(hit.enters if hit else "", (hit.entered if hit else "") or PART, depth, near=near)


def first_entries(
    tree: FacetTree, body: Body, swept: SweptMotion, tolerance: float, suspects: Ints,
    progress: Progress = silent,
) -> Ints:  # fmt: skip
    """Return the blocks (k,) that are found to go more than ``tolerance`` mm into a mesh, or of which the
    contrary is not proven; none: **every** block of the way is proven to stay out. Where some of the
    ``suspects`` go in, or of samples over the whole way, the others are not looked at."""
    m = len(swept)
    samples = np.unique(np.linspace(0, m - 1, min(SAMPLES, m)).astype(np.int64))
    others = np.setdiff1d(np.arange(m), samples, assume_unique=True)
    for blocks in (suspects, samples, others):
        if len(blocks):
            found = find_entries(body, tree, swept, tolerance, np.inf, blocks, progress)
            rows = np.flatnonzero(found.bound > tolerance * HARDLY)
            if len(rows):
                return rows[np.argsort(-found.bound[rows], kind="stable")][:SUSPECTS]
    return np.empty(0, np.int64)


def deepest_met(name: str, tree: FacetTree, run: Run, blocks: Ints) -> Met:
    """Return the deepest of these ``blocks`` (k,), as it is told: how deep shank, holder or spindle go in, or
    that they only come nearer than the clearance."""
    tolerance = run.stand.tolerance
    for body, near in zip(run.bodies_beside(name), (False, True), strict=True):
        found = find_entries(body, tree, run.swept, tolerance, ROUGHLY, blocks)
        block = int(found.depth.argmax())
        deep = float(found.depth[block])
        if near or deep > 0.0 or not run.stand.clearance:
            break
    return Met(PARTS[int(found.part[block])], name, 0.0 if near else deep, vector(found.place[block]), near)


def vector(point: Floats) -> Vector:
    """Return a point (3,) as three plain numbers."""
    x, y, z = point.tolist()
    return x, y, z
