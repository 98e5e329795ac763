# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the axes of a machine carry, as convex pieces at all joints zero: its bodies, part and fixtures, and
the tool.

hull      of an STL, part or fixture its convex hull is taken: what lies in its hollows counts as in it.
round     cylinders and cones get flat sides around them (:mod:`.solids`), spheres are what they are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.convex import Convex, convex_hull
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.solids import frustum_facets
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import (
    CONE,
    CYLINDER,
    FILE,
    SPHERE,
    SPINDLE,
    MachineBody,
    Vector,
    is_round,
)
from freecad_fiveaxis.core.machine.kinematics import Setup
from freecad_fiveaxis.core.tool.body import PARTS, Body, Piece

from .carried_motion import CarriedMotion, carriers_from_base, steps_between, work_carrier
from .fixtures import Fixture
from .machine_bodies import make_mesh
from .neighbours import Line, find_granted, find_unevenness, is_hollow, touches

PIECES = 128
"""Of bodies and tools, and pairs of them, that are kept for the next check: they are the same in each."""

TOOL, BODY, HELD = 0, 1, 2
"""Cutter, shank and holder; bodies of the machine's file; part and fixtures: it is always the first that
enters the last."""


class Carried(NamedTuple):
    """``name`` as it is told of, ``key`` as in a Hit; ``carrier``; ``kind``: TOOL, BODY or HELD;
    ``clearance`` mm of its own; ``stacked``: whether it goes with the tool wherever that is proven against
    what table and base carry; ``mesh``: what its hull is taken of, None for a plain solid; ``line``: what it
    is round about, if it got flat sides."""

    name: str
    key: str
    carrier: str
    piece: Convex
    kind: int
    clearance: float = 0.0
    stacked: bool = False
    mesh: Mesh | None = None
    line: Line | None = None


class CarriedPair(NamedTuple):
    """What is ``moved``, and how, seen from the carrier of what is ``standing``; ``enters`` and ``entered``:
    the same two as they are told of; ``granted`` mm: how deep neighbours may be in each other, None for what
    is no neighbour."""

    moved: Carried
    standing: Carried
    motion: CarriedMotion
    enters: Carried
    entered: Carried
    granted: float | None = None


def carry_bodies(machine: Machine, progress: Progress = silent) -> list[Carried]:
    """Give the bodies of a machine's file. Raises FiveAxisError for a file that is no mesh."""
    return [_carry_body(machine, body, progress) for body in machine.bodies]


def _carry_body(machine: Machine, body: MachineBody, progress: Progress) -> Carried:
    stacked = body.carrier == SPINDLE and is_round(body, machine.gauge_point)
    mesh = make_mesh(body, np.zeros(3), progress) if body.shape == FILE else None  # it may be another by now
    piece = _shape_piece(body) if mesh is None else convex_hull(mesh.vertex)
    line = (body.points[0], body.points[1], max(body.radii)) if body.shape in (CYLINDER, CONE) else None
    return Carried(body.name, body.name, body.carrier, piece, BODY, body.clearance, stacked, mesh, line)


@lru_cache(PIECES)
def _shape_piece(body: MachineBody) -> Convex:
    if body.shape == SPHERE:
        return convex_hull(np.array(body.points), body.radii[0])
    return convex_hull(make_mesh(body, np.zeros(3)).vertex)


def carry_work(
    machine: Machine, setup: Setup, part: Mesh | None, fixtures: Sequence[Fixture]
) -> list[Carried]:
    """Give the part (None: not known), and the fixtures, both with their vertices in the work frame."""
    carrier = work_carrier(machine)
    held: list[tuple[str, str, Mesh]] = [] if part is None else [(say("part"), "", part)]
    held += [(one.name, one.name, one.mesh) for one in fixtures]
    return [
        Carried(name, key, carrier, convex_hull(mesh.vertex + setup.origin), HELD, mesh=mesh)
        for name, key, mesh in held
    ]


def carry_tool(machine: Machine, tool: Body, length: float) -> list[Carried]:
    """Give the pieces of the ``tool``, whose tip stands ``length`` mm below the gauge point."""
    x, y, z = machine.gauge_point
    tip = (x, y, z - length)
    return [
        Carried(PARTS[one.part], PARTS[one.part], SPINDLE, _tool_piece(one, tip), TOOL, stacked=True)
        for one in tool.pieces
    ]


@lru_cache(PIECES)
def _tool_piece(piece: Piece, at: Vector) -> Convex:
    tip, up = np.array(at), np.array([0.0, 0.0, 1.0])
    low, high = tip + piece.low * up, tip + piece.high * up
    if max(piece.low_radius, piece.high_radius) <= 0.0:
        return convex_hull(np.unique([low, high], axis=0), piece.round)
    if piece.low == piece.high:
        disc = frustum_facets(low, low + up, piece.low_radius, piece.low_radius).reshape(-1, 3)
        return convex_hull(np.unique(disc * (1.0, 1.0, 0.0) + (0.0, 0.0, low[2]), axis=0), piece.round)
    wide = piece.high_radius if piece.bulge > 0.0 else piece.low_radius  # the cylinder about a barrel's arc
    return convex_hull(frustum_facets(low, high, wide, piece.high_radius).reshape(-1, 3), piece.round)


def pair_up(
    machine: Machine, carried: Sequence[Carried]
) -> tuple[list[CarriedPair], list[tuple[Carried, Carried]]]:
    """Give the pairs that move against each other and are proven nowhere else, and those neighbours that
    cannot be looked at (:mod:`.neighbours`)."""
    pairs, left = list[CarriedPair](), list[tuple[Carried, Carried]]()
    for one, other in combinations(carried, 2):
        if BODY not in (one.kind, other.kind) or _with_the_tool(machine, one, other):
            continue
        if not steps_between(machine, one.carrier, other.carrier):
            continue
        ways = sorted(_ways(machine, one, other), key=_lever)
        touching = _neighbours(machine, one, other) and touches(one.piece, other.piece)
        pair = _grant(ways) if touching else ways[0]
        if pair is None:
            left.append((one, other))
        else:
            pairs.append(pair)
    return pairs, left


def _grant(ways: Sequence[CarriedPair]) -> CarriedPair | None:
    """Give a pair of neighbours with what is granted to it, in the first of the ways to look at it that tells
    how deep it is; None where none does."""
    if any(is_hollow(one.mesh) for one in (ways[0].moved, ways[0].standing)):
        return None
    for pair in ways:
        granted = find_granted(pair.moved.piece, pair.standing.piece)
        if granted is not None:
            uneven = (find_unevenness(pair.motion, one.line) for one in (pair.moved, pair.standing))
            return pair._replace(granted=granted + sum(uneven))
    return None


def _with_the_tool(machine: Machine, one: Carried, other: Carried) -> bool:
    """Tell whether the pair is proven with the tool, or stands still to it: only bodies of the head are
    left."""
    head = [axis.letter for axis in machine.fitted if axis.side == "head"]
    pairs = ((one, other), (other, one))
    return any(a.stacked and (b.stacked or b.carrier not in (*head, SPINDLE)) for a, b in pairs)


def _neighbours(machine: Machine, one: Carried, other: Carried) -> bool:
    """Tell whether a pair can touch by construction: not across from table to head, which are anywhere at all
    joints zero; nor what is clamped and what passes it along a linear axis."""
    steps = steps_between(machine, one.carrier, other.carrier)
    if HELD in (one.kind, other.kind) and not all(step.axis.rotary for step in steps):
        return False
    (near, down), (far, up) = (carriers_from_base(machine, each.carrier) for each in (one, other))
    return not near or not far or down == up


def _ways(machine: Machine, one: Carried, other: Carried) -> Iterator[CarriedPair]:
    named = sorted((one, other), key=lambda each: each.kind)
    for standing, moved in ((one, other), (other, one)):
        motion = CarriedMotion(steps_between(machine, standing.carrier, moved.carrier), moved.piece)
        yield CarriedPair(moved, standing, motion, *(named if one.kind != other.kind else (moved, standing)))


def _lever(pair: CarriedPair) -> float:
    """How far a turn of all joints would move it: the less, the fewer cells are needed."""
    lines = pair.motion.lines(np.zeros((1, len(pair.motion.steps))))
    return float(lines.lever[pair.motion.rotary].sum())
