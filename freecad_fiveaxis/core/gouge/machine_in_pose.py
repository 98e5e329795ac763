# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the machine itself is in the way of a tool that stands somewhere: what a tool axis is chosen by, and a branch.

free      on one branch within the rotary limits no body of table or base is in cutter, shank, holder or what the spindle carries,
          no body in another one, in the part or in a fixture, and the spindle in neither of these: all that
          :mod:`.machine_check` looks for, in this one pose. Without the tool's length what depends on it is not asked, as there.
pole      where any first rotary word will do, the tool has to be free on all of SAMPLES: its neighbours decide
          which one it gets.
near      a body is asked only about poses in which the stack reaches beyond all six sides of the body's box.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import groupby
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.convex import find_gaps
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import chain, forward, inverse_axis, joint_words, q_to_words, words_to_q
from freecad_fiveaxis.core.motion.joint_path.branches import POLE_ANGLE, within_limits
from freecad_fiveaxis.core.tool.body import Body, body_support, extend_way_out, grow_body

from .body_pairs import PARED
from .carried_pieces import Carried, CarriedPair, carry_bodies, carry_tool, carry_work, pair_up
from .inside import inside, is_closed
from .machine_bodies import make_mesh, spindle_body
from .machine_check import InMachine, is_held, lock_words, locked_letters, needs_length, zero_words
from .search import which_enter
from .swept_motion import still_positions

SAMPLES = 8
"""First rotary words of a pole."""

BATCH = 16384
"""Poses at a time."""


class HeldBody(NamedTuple):
    """A body that table or base carry: the axes that are ``locked`` seen from it, and its ``mesh``, mm, in the work frame that
    stands still to it."""

    locked: str
    mesh: Mesh


@dataclass(frozen=True, eq=False)
class MachineInPose:
    """``given``: machine, setup, chain with the limits that count, and the tool; ``held``: what the stack must not hit;
    ``carried``: bodies, part and fixtures as convex pieces; ``tolerance`` mm that may be entered; ``margin`` mm by which all that
    the spindle carries is thicker."""

    given: InMachine
    held: tuple[HeldBody, ...]
    carried: tuple[Carried, ...]
    tolerance: float
    margin: float = 0.0

    @cached_property
    def spindle(self) -> Body:
        """What the spindle carries, heights from the tip; nothing where the tool's length is not known."""
        if self.given.length is None:
            return Body(())
        return grow_body(spindle_body(self.given.machine, self.given.length + self.given.back), self.margin)

    @cached_property
    def pairs(self) -> tuple[CarriedPair, ...]:
        """What moves against each other, of what is known without the tool's length if there is none."""
        given = self.given
        tool = [] if given.length is None else carry_tool(given.machine, given.body, given.length + given.back)
        found, _ = pair_up(given.machine, [*self.carried, *tool])
        rise = np.linalg.solve(given.kinematics.direction[:3].T, (0.0, 0.0, 1.0))
        known = np.concatenate([np.abs(rise) < 1e-9, (True, True)]) | (given.length is not None)
        return tuple(pair for pair in found if known[self._columns(pair)].all())

    def longer(self, more: float, body: Body) -> MachineInPose:
        """Put in a tool that is ``more`` mm longer, of this ``body``."""
        old = self.given
        if old.length is None:
            return replace(self, given=replace(old, body=body))
        setup = replace(old.setup, tool_length=old.setup.tool_length + more)
        new = chain(old.machine, setup)
        low, high = np.append(new.low[:3], old.kinematics.low[3:]), np.append(new.high[:3], old.kinematics.high[3:])
        kinematics = replace(new, low=low, high=high)
        return replace(self, given=replace(old, setup=setup, kinematics=kinematics, body=body, length=old.length + more))

    def hits(self, tool: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float, far: float = 0.0) -> Bools:
        """Tell in which poses (n,) of the ``tool``, with its tip (n, 3) mm and unit axis (n, 3) there, the machine is in the way
        on all branches, or the spindle in what the ``tree`` holds, by more than ``limit`` mm; ``far`` mm as of a Reacher."""
        parts = [
            self._hits(tool, tree, tip[first : first + BATCH], axis[first : first + BATCH], limit, far)
            for first in range(0, len(tip), BATCH)
        ]
        return np.concatenate(parts) if parts else np.zeros(0, np.bool_)

    def _hits(self, tool: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float, far: float) -> Bools:
        spindle = extend_way_out(self.spindle, far) if far else self.spindle
        stack, kinematics = Body((*tool.pieces, *spindle.pieces)), self.given.kinematics
        angles, sine = inverse_axis(kinematics, axis)
        low, high = kinematics.low[3:], kinematics.high[3:]
        fits, pole, met = within_limits(angles, low, high), sine <= POLE_ANGLE, np.ones(len(tip), np.bool_)
        fits |= ~fits.any(axis=0)  # limits are asked by others
        for branch in range(2):
            rows = np.flatnonzero(met & fits[branch] & ~pole)
            met[rows] = self._at(stack, tip[rows], axis[rows], angles[branch, rows], limit)
        rows = np.flatnonzero(pole)
        met[rows] = self._at_pole(stack, tip[rows], axis[rows], angles[0, rows], limit)
        rows = np.flatnonzero(~met)
        met[rows] = _enters(spindle, tree, tip[rows], axis[rows], limit)
        return met

    def _at_pole(self, stack: Body, tip: Floats, axis: Floats, angles: Floats, limit: float) -> Bools:
        """The same of poses at the pole, where the first word is free."""
        met = np.zeros(len(tip), np.bool_)
        for word in _spread_words(float(self.given.kinematics.low[3]), float(self.given.kinematics.high[3])):
            rows = np.flatnonzero(~met)
            turned = np.column_stack([np.full(len(rows), word), angles[rows, 1]])
            met[rows] = self._at(stack, tip[rows], axis[rows], turned, limit)
        return met

    def blocked(self, driven: Floats, axis: Floats, angles: Floats) -> Bools:
        """Tell where (n,) the machine is in the way with the driven point (n, 3) mm and unit axis (n, 3) there at rotary words
        ``angles`` (n, 2) rad."""
        stack = Body((*self.given.body.pieces, *self.spindle.pieces))
        tip, met = driven - self.given.back * axis, np.zeros(len(driven), np.bool_)
        for first in range(0, len(tip), BATCH):
            rows = slice(first, first + BATCH)
            met[rows] = self._at(stack, tip[rows], axis[rows], angles[rows], self.tolerance)
        return met

    def _at(self, stack: Body, tip: Floats, axis: Floats, angles: Floats, limit: float) -> Bools:
        """Whether (n,) something is hit at these rotary words (n, 2), but for the spindle in the part."""
        given = self.given
        words = q_to_words(joint_words(given.kinematics, tip + given.back * axis, angles))
        met = np.isnan(words).any(axis=1)
        for locked, bodies in groupby(self.held, key=lambda one: one.locked):
            seen = self._seen_from(locked, words, tip, axis)
            for body in bodies:
                rows = np.flatnonzero(~met)
                met[rows] = _in_body(stack, body.mesh, seen[0][rows], seen[1][rows], limit)
        off = words - zero_words(given.machine, given.setup, given.kinematics)
        for pair in self.pairs:
            rows = np.flatnonzero(~met)
            met[rows] = self._meet(pair, off[rows][:, self._columns(pair)])
        return met

    def _seen_from(self, locked: str, words: Floats, tip: Floats, axis: Floats) -> tuple[Floats, Floats]:
        """Tips (n, 3) and axes (n, 3) as a body sees them from which on these axes are locked."""
        if not locked:
            return tip, axis
        given = self.given
        words = lock_words(given.machine, given.setup, given.kinematics, words, locked)
        driven, axis = forward(given.kinematics, words_to_q(words))
        return driven - given.back * axis, axis

    def _columns(self, pair: CarriedPair) -> Ints:
        return np.array([self.given.kinematics.letters.index(step.axis.letter) for step in pair.motion.steps], np.int64)

    def _meet(self, pair: CarriedPair, off: Floats) -> Bools:
        """Whether (n,) two pieces are in each other, joints (n, k) in mm and degrees."""
        joints, which = off, np.arange(len(off))
        if pair.motion.rotary.all():
            joints, which = np.unique(off, axis=0, return_inverse=True)
        joints = np.where(pair.motion.rotary, np.deg2rad(joints), joints)
        moved, standing, level = pair.moved.piece, pair.standing.piece, PARED * self.tolerance
        if rounds := moved.round + standing.round:
            within = self.margin - min(level, 0.99 * rounds)
        else:
            within, standing = self.margin, standing.pared(min(level, 0.99 * standing.inmost[1]))
        poses = pair.motion.lines(joints).poses
        away = np.linalg.norm(poses.turn @ moved.middle + poses.shift - standing.middle, axis=1)
        met = away <= moved.reach + standing.reach + within
        rows = np.flatnonzero(met)
        guess = np.tile((0.0, 0.0, 1.0), (len(rows), 1))
        met[rows] = ~(find_gaps(moved, standing, poses.take(rows), within, np.zeros(len(rows)), guess).least > 0.0)
        return np.asarray(met[which.reshape(-1)])


def machine_in_pose(given: InMachine, part: Mesh | None, tolerance: float, progress: Progress = silent) -> MachineInPose | None:
    """Prepare a machine, with the ``part`` on it, to be asked; None where its file names no bodies. Raises FiveAxisError for the
    file of a body that cannot be used."""
    machine = given.machine
    if not machine.bodies:
        return None
    held = sorted(_held_bodies(given, progress), key=lambda one: one.locked)
    carried = [*carry_bodies(machine, progress), *carry_work(machine, given.setup, part, given.fixtures)]
    return MachineInPose(given, tuple(held), tuple(carried), tolerance)


def _held_bodies(given: InMachine, progress: Progress) -> Iterator[HeldBody]:
    for body in given.machine.bodies:
        if is_held(given.machine, body) and not (given.length is None and needs_length(given.machine, body)):
            mesh = make_mesh(body, -np.array(given.setup.origin), progress)
            yield HeldBody(locked_letters(given.machine, body), mesh)


def _in_body(stack: Body, mesh: Mesh, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Whether (n,) the stack is in a body by more than ``limit`` mm, or its cutter all in it."""
    met, tree = np.zeros(len(tip), np.bool_), facet_tree(mesh)
    rows = np.flatnonzero(_reaches_box(stack, tip, axis, *mesh.box))
    met[rows] = _enters(stack, tree, tip[rows], axis[rows], limit)
    if is_closed(mesh):
        rows = rows[~met[rows]]
        met[rows] = inside(tree, tip[rows] + stack.pieces[0].low * axis[rows])
    return met


def _reaches_box(stack: Body, tip: Floats, axis: Floats, low: Floats, high: Floats) -> Bools:
    """Which stacks (n,) no side of a box from ``low`` to ``high`` (3,) mm parts from it: a side that does is a proof."""
    rows = np.arange(len(tip))
    for k in range(3):
        for sign, side in ((1.0, high[k]), (-1.0, -low[k])):
            least = sign * tip[rows, k] - body_support(stack, -sign * axis[rows, k])
            rows = rows[least <= side]
    reaches = np.zeros(len(tip), np.bool_)
    reaches[rows] = True
    return reaches


def _enters(body: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Whether (n,) a body that stands there enters by more than ``limit`` mm."""
    if not body.pieces or not len(tip):
        return np.zeros(len(tip), np.bool_)
    return which_enter(body, tree, still_positions(tip, axis), limit, np.arange(len(tip)))


def _spread_words(low: float, high: float) -> Floats:
    """First rotary words, rad, all round or between limits."""
    if high - low >= 2.0 * math.pi:
        return np.asarray(2.0 * math.pi * np.arange(SAMPLES) / SAMPLES)
    return np.linspace(low, high, SAMPLES + 1)
