# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the machine itself is in the way of a tool that stands somewhere: what a tool axis is chosen by,
and a branch.

free      on one branch within the rotary limits no body of table or base is in cutter, shank, holder or what
          the spindle carries, no body in another one, in the part or in a fixture, and the spindle in neither
          of these: all that :mod:`.machine_check` looks for, in this one pose. Without the tool's length what
          depends on it is not asked, as there.
pole      where any first rotary word will do, the tool has to be free on all of SAMPLES: its neighbours
          decide which one it gets.
parted    a piece of the stack and a body, where along one of WAYS the one ends before the other begins: that
          is a proof, and only what is not parted is searched.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.convex import Convex, find_met_poses
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    chain,
    forward,
    inverse_axis,
    joint_words,
    q_to_words,
    words_to_q,
)
from freecad_fiveaxis.core.motion.joint_path.branches import POLE_ANGLE, within_limits
from freecad_fiveaxis.core.tool.body import CUTTER, SPINDLE, Body, Piece, extend_way_out, support

from .body_pairs import PARED
from .body_search import Pair, free_cells
from .carried_motion import CarriedMotion
from .carried_pieces import Carried, CarriedPair, carry_bodies, carry_tool, carry_work, pair_up
from .inside import inside, is_closed
from .machine_bodies import make_mesh, spindle_body
from .machine_check import InMachine, find_locked_letters, is_held, lock_words, needs_length, zero_words
from .rest_material import surface_samples
from .search import which_enter
from .swept_motion import still_positions

SAMPLES = 8
"""First rotary words of a pole."""

POINTS = 16
"""Samples of a body's surface, about."""

CELLS = 32
"""Into which the range of each rotary axis is divided, to prove once where two bodies that it turns never
meet."""

BATCH = 16384
"""Poses at a time."""

WAYS = np.array(
    sorted(
        (way for way in product((-1.0, 0.0, 1.0), repeat=3) if any(way)),
        key=lambda way: np.count_nonzero(way),
    )
)
WAYS /= np.linalg.norm(WAYS, axis=1)[:, None]
"""Unit directions (26, 3), those of the sides of a box first."""


class HeldBody(NamedTuple):
    """A body that table or base carry: the axes that are ``locked`` seen from it, its ``mesh``, mm, in the
    work frame that stands still to it, how far it goes along WAYS, (26,) mm, and some points (k, 3) of its
    surface."""

    locked: str
    mesh: Mesh
    reach: Floats
    sample: Floats


@dataclass(frozen=True, eq=False)
class PairInPose:
    """Two pieces, as they move (``motion``) by the joints ``at`` (k,) of X Y Z and the rotary axes: they meet
    no farther apart than ``within`` mm from the ``standing`` one. ``low``, ``high`` (2,) rad: the rotary
    words between which cells are proven."""

    motion: CarriedMotion
    standing: Convex
    at: Ints
    within: float
    low: Floats
    high: Floats

    @staticmethod
    def of(pair: CarriedPair, at: Ints, pared: float, margin: float, low: Floats, high: Floats) -> PairInPose:
        """Give the pair of which ``pared`` mm may be in each other, thicker by ``margin`` mm; neighbours are
        not, but may be in each other by what is granted to them."""
        pared, margin = pared + (pair.granted or 0.0), margin if pair.granted is None else 0.0
        standing, rounds = pair.standing.piece, pair.moved.piece.round + pair.standing.piece.round
        if rounds:
            return PairInPose(pair.motion, standing, at, margin - min(pared, 0.99 * rounds), low, high)
        return PairInPose(
            pair.motion, standing.pare(min(pared, 0.99 * standing.inmost[1])), at, margin, low, high
        )

    @property
    def turned(self) -> bool:
        """Whether no linear axis moves the one against the other."""
        return bool((self.at >= 3).all())

    @cached_property
    def free(self) -> Bools:
        """Which cells of the rotary words, CELLS along each, are proven to be free."""
        ends = [np.linspace(self.low[k - 3], self.high[k - 3], CELLS + 1) for k in self.at]
        low, high = (
            np.stack(np.meshgrid(*(one[part] for one in ends), indexing="ij"), -1).reshape(-1, len(ends))
            for part in (slice(None, -1), slice(1, None))
        )
        return free_cells(Pair(self.motion, self.standing, self.within), low, high)

    def meet(self, off: Floats) -> Bools:
        """Tell where (n,) they do, all joints (n, 5) in mm and rad."""
        joints, met = off[:, self.at], np.zeros(len(off), np.bool_)
        rows = np.flatnonzero(~self._is_proven(joints)) if self.turned else np.arange(len(off))
        met[rows] = find_met_poses(
            self.motion.moved, self.standing, self.motion.place(joints[rows]), self.within
        )
        return met

    def _is_proven(self, joints: Floats) -> Bools:
        """Which joints (n, k) lie in a free cell."""
        low, high = self.low[self.at - 3], self.high[self.at - 3]
        cell = np.minimum(((joints - low) / (high - low) * CELLS).astype(np.int64), CELLS - 1)
        within = ((joints >= low) & (joints <= high)).all(axis=1)
        found = np.zeros(len(joints), np.bool_)
        found[within] = self.free[np.ravel_multi_index(tuple(cell[within].T), (CELLS,) * len(self.at))]
        return found


@dataclass(frozen=True, eq=False)
class MachineInPose:
    """``given``: machine, setup, chain with the limits that count, and the tool; ``held``: what the stack
    must not hit; ``carried``: bodies, part and fixtures as convex pieces; ``tolerance`` mm that may be
    entered; ``margin`` mm by which all but the cutter is thicker where axes are chosen, for they are to be
    free between, too."""

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
        return spindle_body(self.given.machine, self.given.length + self.given.back)

    @cached_property
    def pairs(self) -> tuple[PairInPose, ...]:
        """What moves against each other, of what is known without the tool's length if there is none."""
        given, letters = self.given, self.given.kinematics.letters
        tool = (
            [] if given.length is None else carry_tool(given.machine, given.body, given.length + given.back)
        )
        found, _ = pair_up(given.machine, [*self.carried, *tool])
        rise = np.linalg.solve(given.kinematics.direction[:3].T, (0.0, 0.0, 1.0))
        known = np.concatenate([np.abs(rise) < 1e-9, (True, True)]) | (given.length is not None)
        columns = [
            np.array([letters.index(step.axis.letter) for step in pair.motion.steps]) for pair in found
        ]
        pared = PARED * self.tolerance
        low, high = _all_words(given.kinematics)
        pairs = (
            PairInPose.of(pair, at, pared, self.margin, low, high)
            for pair, at in zip(found, columns, strict=True)
            if known[at].all()
        )
        return tuple(pair for pair in pairs if not (pair.turned and pair.free.all()))

    def longer(self, more: float, body: Body) -> MachineInPose:
        """Put in a tool that is ``more`` mm longer, of this ``body``."""
        old = self.given
        if old.length is None:
            return replace(self, given=replace(old, body=body))
        setup = replace(old.setup, tool_length=old.setup.tool_length + more)
        new = chain(old.machine, setup)
        low, high = (
            np.append(new.low[:3], old.kinematics.low[3:]),
            np.append(new.high[:3], old.kinematics.high[3:]),
        )
        kinematics = replace(new, low=low, high=high)
        return replace(
            self, given=replace(old, setup=setup, kinematics=kinematics, body=body, length=old.length + more)
        )

    def hits(
        self, tool: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float, far: float = 0.0
    ) -> Bools:
        """Tell in which poses (n,) of the ``tool``, with its tip (n, 3) mm and unit axis (n, 3) there, the
        machine is in the way on all branches, or the spindle in what the ``tree`` holds, by more than
        ``limit`` mm; ``far`` mm as of a Reacher."""
        parts = [
            self._hits(tool, tree, tip[first : first + BATCH], axis[first : first + BATCH], limit, far)
            for first in range(0, len(tip), BATCH)
        ]
        return np.concatenate(parts) if parts else np.zeros(0, np.bool_)

    def _hits(
        self, tool: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float, far: float
    ) -> Bools:
        spindle = extend_way_out(self.spindle, far) if far else self.spindle
        stack, kinematics = self._thicken_pieces((*tool.pieces, *spindle.pieces)), self.given.kinematics
        angles, sine = inverse_axis(kinematics, axis)
        low, high = kinematics.low[3:], kinematics.high[3:]
        fits, pole, met = within_limits(angles, low, high), sine <= POLE_ANGLE, np.ones(len(tip), np.bool_)
        fits |= ~fits.any(axis=0)  # limits are asked by others
        held = _enters(spindle, tree, tip, axis, limit)
        self._add_hits(held, "", stack, tip, axis, limit)
        for branch in range(2):
            rows = np.flatnonzero(met & fits[branch] & ~pole & ~held)
            met[rows] = self._at(stack, tip[rows], axis[rows], angles[branch, rows], limit)
        rows = np.flatnonzero(pole & ~held)
        met[rows] = self._at_pole(stack, tip[rows], axis[rows], angles[0, rows], limit)
        return met

    def _thicken_pieces(self, pieces: Iterable[Piece]) -> Body:
        """Shank, holder and spindle thicker by the margin; the cutter as it is, for it may work close to a
        body."""
        return Body(
            tuple(one._replace(round=one.round + self.margin * (one.part != CUTTER)) for one in pieces)
        )

    def _at_pole(self, stack: Body, tip: Floats, axis: Floats, angles: Floats, limit: float) -> Bools:
        """Return the same of poses at the pole, where the first word is free."""
        words = _spread_words(float(self.given.kinematics.low[3]), float(self.given.kinematics.high[3]))
        row = np.repeat(np.arange(len(tip)), len(words))
        turned = np.column_stack([np.tile(words, len(tip)), angles[row, 1]])
        met = self._at(stack, tip[row], axis[row], turned, limit)
        return np.asarray(met.reshape(-1, len(words)).any(axis=1))

    def is_blocked(self, driven: Floats, axis: Floats, angles: Floats) -> Bools:
        """Tell where (n,) the machine is in the way with the driven point (n, 3) mm and unit axis (n, 3)
        there at rotary words ``angles`` (n, 2) rad."""
        stack = Body((*self.given.body.pieces, *self.spindle.pieces))
        tip, met = driven - self.given.back * axis, np.zeros(len(driven), np.bool_)
        for first in range(0, len(tip), BATCH):
            rows = slice(first, first + BATCH)
            met[rows] = self._at(stack, tip[rows], axis[rows], angles[rows], self.tolerance)
            self._add_hits(met[rows], "", stack, tip[rows], axis[rows], self.tolerance)
        return met

    def _add_hits(
        self, met: Bools, locked: str, stack: Body, tip: Floats, axis: Floats, limit: float
    ) -> None:
        """Add to ``met`` (n,) what hits a body from which on these axes are locked, tips and axes (n, 3) as
        it sees them."""
        for body in self.held:
            if body.locked == locked:
                rows = np.flatnonzero(~met)
                met[rows] = _in_body(stack, body, tip[rows], axis[rows], limit)

    def _at(self, stack: Body, tip: Floats, axis: Floats, angles: Floats, limit: float) -> Bools:
        """Whether (n,) something is hit at these rotary words (n, 2), of all that depends on them."""
        given = self.given
        words = q_to_words(joint_words(given.kinematics, tip + given.back * axis, angles))
        met = np.asarray(np.isnan(words).any(axis=1))
        for locked in sorted({one.locked for one in self.held} - {""}):
            self._add_hits(met, locked, stack, *self._view_from_body(locked, words), limit)
        off = words - zero_words(given.machine, given.setup, given.kinematics)
        off[:, 3:], (first, which) = np.deg2rad(off[:, 3:]), _different(angles)
        for pair in self.pairs:
            if pair.turned:  # what turns alone is the same wherever the tool stands
                met |= pair.meet(off[first])[which]
            else:
                rows = np.flatnonzero(~met)
                met[rows] = pair.meet(off[rows])
        return met

    def _view_from_body(self, locked: str, words: Floats) -> tuple[Floats, Floats]:
        """Tips (n, 3) and axes (n, 3) as a body sees them from which on these axes are locked."""
        given = self.given
        words = lock_words(given.machine, given.setup, given.kinematics, words, locked)
        driven, axis = forward(given.kinematics, words_to_q(words))
        return driven - given.back * axis, axis


def machine_in_pose(
    given: InMachine, part: Mesh | None, tolerance: float, progress: Progress = silent, margin: float = 0.0
) -> MachineInPose | None:
    """Prepare a machine, with the ``part`` on it, to be asked; None where its file names no bodies. Raises
    FiveAxisError for the file of a body that cannot be used."""
    machine = given.machine
    if not machine.bodies:
        return None
    held = _find_held_bodies(given, progress)
    carried = [*carry_bodies(machine, progress), *carry_work(machine, given.setup, part, given.fixtures)]
    return MachineInPose(given, tuple(held), tuple(carried), tolerance, margin)


def _find_held_bodies(given: InMachine, progress: Progress) -> Iterator[HeldBody]:
    for body in given.machine.bodies:
        if is_held(given.machine, body) and not (given.length is None and needs_length(given.machine, body)):
            mesh = make_mesh(body, -np.array(given.setup.origin), progress)
            sample, _, _ = surface_samples(mesh, math.sqrt(float(mesh.area.sum()) / POINTS))
            yield HeldBody(
                find_locked_letters(given.machine, body), mesh, (mesh.vertex @ WAYS.T).max(axis=0), sample
            )


def _in_body(stack: Body, body: HeldBody, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Whether (n,) the stack is in a body by more than ``limit`` mm, or its cutter or the
    spindle all in it."""
    met, tree = np.zeros(len(tip), np.bool_), facet_tree(body.mesh)
    near = np.flatnonzero(_is_not_parted(_around(stack), body, tip, axis))
    if not len(near):
        return met
    for piece in sorted(stack.pieces, key=lambda one: -one.widest):  # what is wide hits most of what is hit
        rows = near[~met[near]]
        rows = rows[_is_not_parted(piece, body, tip[rows], axis[rows])]
        met[rows] = _holds_sample(piece, body, tip[rows], axis[rows], limit)
        rows = rows[~met[rows]]
        met[rows] = _enters(Body((piece,)), tree, tip[rows], axis[rows], limit)
    if is_closed(body.mesh):
        for piece in (stack.pieces[0], *(one for one in stack.pieces[1:] if one.part == SPINDLE)):
            rows = near[~met[near]]
            rows = rows[_is_not_parted(piece, body, tip[rows], axis[rows])]
            met[rows] = inside(tree, tip[rows] + piece.low * axis[rows])
    return met


def _holds_sample(piece: Piece, body: HeldBody, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Tell where (n,) a sample of the body is surely deeper than ``limit`` mm in a piece, which then need not
    be searched."""
    least, held = min(piece.low_radius, piece.high_radius) - limit, np.zeros(len(tip), np.bool_)
    if least <= 0.0:
        return held
    low, high = (tip * axis).sum(axis=1) + piece.low + limit, (tip * axis).sum(axis=1) + piece.high - limit
    for place in body.sample:
        rows = np.flatnonzero(~held)
        height = axis[rows] @ place
        rows = rows[(height > low[rows]) & (height < high[rows])]
        arm = place - tip[rows]
        along = (arm * axis[rows]).sum(axis=1)
        held[rows] = (arm * arm).sum(axis=1) - along * along < least * least
    return held


def _around(stack: Body) -> Piece:
    """Return a cylinder about all of a stack."""
    low, high = (
        min(one.low - one.round for one in stack.pieces),
        max(one.high + one.round for one in stack.pieces),
    )
    wide = max(piece.widest for piece in stack.pieces)
    return Piece(low, wide, high, wide, 0.0)


def _is_not_parted(piece: Piece, body: HeldBody, tip: Floats, axis: Floats) -> Bools:
    """Tell where (n,) a piece and a body are not parted by any of WAYS."""
    rows, found = np.arange(len(tip)), np.zeros(len(tip), np.bool_)
    for way, reach in zip(WAYS, body.reach, strict=True):
        rows = rows[tip[rows] @ way - support(piece, -(axis[rows] @ way)) <= reach]
    found[rows] = True
    return found


def _different(angles: Floats) -> tuple[Ints, Ints]:
    """Return the first rows (k,) of different ones of angles (n, 2), and which of them each is (n,)."""
    _, first, which = np.unique(angles[:, 0] + 1j * angles[:, 1], return_index=True, return_inverse=True)
    return first, which.reshape(-1)


def _enters(body: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Whether (n,) a body that stands there enters by more than ``limit`` mm."""
    if not body.pieces or not len(tip):
        return np.zeros(len(tip), np.bool_)
    return which_enter(body, tree, still_positions(tip, axis), limit, np.arange(len(tip)))


def _all_words(kinematics: Chain) -> tuple[Floats, Floats]:
    """Between which rotary words (2,) rad all poses are that are asked for: a turn or the limits, whatever is
    less."""
    turn = 2.0 * math.pi
    return np.maximum(kinematics.low[3:], -turn), np.minimum(kinematics.high[3:], turn)


def _spread_words(low: float, high: float) -> Floats:
    """First rotary words, rad, all round or between limits."""
    if high - low >= 2.0 * math.pi:
        return np.asarray(2.0 * math.pi * np.arange(SAMPLES) / SAMPLES)
    return np.linspace(low, high, SAMPLES + 1)
