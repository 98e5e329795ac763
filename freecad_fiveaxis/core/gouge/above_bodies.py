# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high Z must stand so that tool and spindle are above the machine's bodies, part and fixtures, wherever
all other axes stand: nobody knows that when a program is started.

span      the box in the machine frame that a piece never leaves, its Z at zero: over all pairs of rotary
          joints within their limits in steps, grown by the proven bend between them, as
          :mod:`..motion.program.retract` does it; linear axes move it by the ends of their travel.
lifted    what Z carries, seen from what it does not. A piece that stays beside another one in X or Y,
          wherever both go, need not be above it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.convex import AT_ONCE, convex_hull
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import BASE, SPINDLE
from freecad_fiveaxis.core.motion.program.retract import LEAST_LIFT, STEP

from .carried_motion import CarriedMotion, Step, carriers_from_base, steps_between, work_carrier
from .carried_pieces import HELD, Carried, carry_bodies, carry_tool
from .machine_check import InMachine, zero_words

VERTICAL = 1e-9
"""Z that leans less moves nothing aside."""


class Clearing(NamedTuple):
    """What is to be passed above: its ``name``, the height ``z`` (mm, a word of Z, with the other sign where
    Z counts downwards) from which on all that Z lifts is above it, inf where Z does not do that; ``still``:
    nothing carries it."""

    name: str
    z: float
    still: bool


class AbovePlane(NamedTuple):
    """The word of Z, mm, at which a program begins and ends, with all that Z lifts above all that the axes
    carry; ``but_for``: bodies of the base that are higher than Z can go."""

    z: float
    but_for: tuple[str, ...] = ()


class Span(NamedTuple):
    """A piece, and the corners (3,) mm of the box that it never leaves; ``lifted``: Z carries it."""

    piece: Carried
    low: Floats
    high: Floats
    lifted: bool


def find_clearings(given: InMachine, box: tuple[Floats, Floats], margin: float) -> tuple[Clearing, ...]:
    """Find how high Z must stand above each body of base and table, and above the ``box``, (3,) and (3,) mm,
    work frame, of part and fixtures, with ``margin`` mm to spare. Nothing is found where the machine's file
    names no bodies. Raises FiveAxisError for the file of a body that cannot be used."""
    machine = given.machine
    if not machine.bodies:
        return ()
    head = {axis.letter for axis in machine.fitted if axis.side == "head"}
    spans = [_span(machine, one) for one in _carry_all(given, box)]
    over = [one for one in spans if one.piece.carrier in head or one.piece.carrier == SPINDLE]
    over = [one for one in over if one.lifted or "Z" not in head]
    under = [one for one in spans if one.piece.carrier not in head and one.piece.carrier != SPINDLE]
    rise, aside = _rise(machine)
    zero = math.copysign(1.0, rise) * float(zero_words(machine, given.setup, given.kinematics)[2])
    found = []
    for held in under:
        z = max((_need(held, one, rise, aside) for one in over), default=-math.inf)
        if z > -math.inf:
            found.append(Clearing(held.piece.name, z + margin / max(abs(rise), LEAST_LIFT) + zero,
                held.piece.carrier == BASE))  # fmt: skip
    return tuple(found)


def _carry_all(given: InMachine, box: tuple[Floats, Floats]) -> Iterator[Carried]:
    """Yield bodies, the box of part and fixtures, and the tool; without the tool's length, against which the
    words of Z count, nothing of the head but the tool."""
    machine, length = given.machine, given.setup.tool_length
    head = [axis.letter for axis in machine.fitted if axis.side == "head"]
    for one in carry_bodies(machine):
        if given.length is not None or one.carrier not in (*head, SPINDLE):
            yield one
    corner = box_facets(*box).reshape(-1, 3) + given.setup.origin
    yield Carried(say("part and fixtures"), "", work_carrier(machine), convex_hull(corner), HELD)
    yield from carry_tool(machine, given.body, length + given.back)


def _rise(machine: Machine) -> tuple[float, bool]:
    """Tell how far a millimetre of Z lifts what it carries, 0 where that turns or is too little, and whether
    it moves it aside."""
    way, _ = carriers_from_base(machine, "Z")
    rise, turned = way[-1].direction[2], any(axis.rotary for axis in way)
    return 0.0 if turned or abs(rise) < LEAST_LIFT else rise, abs(abs(rise) - 1.0) > VERTICAL


def _need(held: Span, over: Span, rise: float, aside: bool) -> float:
    """Return the height of Z, mm, as a joint, from which on the one is above the other."""
    apart = (held.low[:2] >= over.high[:2]) | (held.high[:2] <= over.low[:2])
    if apart.any() and not aside:
        return -math.inf
    if not rise or held.lifted == over.lifted:
        return math.inf
    return float(held.high[2] - over.low[2]) / abs(rise)


def _span(machine: Machine, one: Carried) -> Span:
    steps = steps_between(machine, BASE, one.carrier)
    lifted = any(step.axis.letter == "Z" for step in steps)
    first = next((k for k, step in enumerate(steps) if step.axis.rotary), len(steps))
    joints = np.meshgrid(*(_joints(step, k > first) for k, step in enumerate(steps)), indexing="ij")
    q = np.column_stack([column.ravel() for column in joints]) if steps else np.zeros((1, 0))
    if not np.isfinite(q).all():  # a linear axis without limits that a rotary one carries
        return Span(one, np.full(3, -np.inf), np.full(3, np.inf), lifted)
    low, high = _box_of_poses(CarriedMotion(steps, one.piece), q)
    by = one.piece.round + _bend(steps[first:], one)
    ways = [_shift(step) for step in steps[:first] if step.axis.letter != "Z"]
    return Span(one, low - by + sum(way[0] for way in ways), high + by + sum(way[1] for way in ways), lifted)


def _joints(step: Step, turned: bool) -> Floats:
    """Return the joints of an axis that are looked at: of a rotary one its limits, or a whole turn, in steps;
    of a linear one that a rotary one carries both ends."""
    low, high = step.axis.low, step.axis.high
    if not step.axis.rotary:
        return np.array([low, high]) if turned and step.axis.letter != "Z" else np.zeros(1)
    low, high = (low, high) if high - low < 2.0 * math.pi else (-math.pi, math.pi)
    return np.linspace(low, high, math.ceil((high - low) / STEP) + 1)


def _shift(step: Step) -> tuple[Floats, Floats]:
    """Tell how far (3,) and (3,) mm a linear axis that nothing turns moves a piece, downwards and upwards."""
    way = step.sign * np.array(step.axis.direction)
    ends = np.zeros((2, 3))
    moves = np.abs(way) > VERTICAL
    ends[:, moves] = np.multiply.outer((step.axis.low, step.axis.high), way[moves])
    return ends.min(axis=0), ends.max(axis=0)


def _box_of_poses(motion: CarriedMotion, joints: Floats) -> tuple[Floats, Floats]:
    """Find the corners (3,) mm of the box about a moved piece at all joints (n, k), without its round."""
    corner, step = motion.moved.corner, max(1, AT_ONCE // (3 * len(motion.moved.corner)))
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for first in range(0, len(joints), step):
        poses = motion.place(joints[first : first + step])
        places = poses.turn @ corner.T + poses.shift[:, :, None]
        low, high = np.minimum(low, places.min(axis=(0, 2))), np.maximum(high, places.max(axis=(0, 2)))
    return low, high


def _bend(steps: Sequence[Step], one: Carried) -> float:
    """Bound how much farther, mm, a point may go between the rotary joints that are looked at; ``steps`` from
    the first that turns. Its lever is no longer than the way from axis to axis and on to the point."""
    points = [np.array(step.axis.point) for step in steps if step.axis.rotary]
    if not points:
        return 0.0
    lever = float(np.linalg.norm(one.piece.corner - points[-1], axis=1).max())
    lever += sum(float(np.linalg.norm(b - a)) for a, b in pairwise(points))
    lever += sum(
        max(-step.axis.low, step.axis.high)
        for step in steps
        if not step.axis.rotary and step.axis.letter != "Z"
    )
    return 0.5 * lever * (0.5 * STEP * len(points)) ** 2
