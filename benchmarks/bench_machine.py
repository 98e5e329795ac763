# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proven check of tool and spindle against ten bodies of a machine, beside dense samples of the joints'
way with python-fcl (where that is installed), else with numpy: blocks a second of both, in one run and in
turns.

The samples tell of single moments, and of nothing between them; the check proves the whole way of each block.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import print_table
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.gouge.machine_bodies import make_mesh, spindle_body
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine, lock_words
from freecad_fiveaxis.core.machine import Machine, load_machine
from freecad_fiveaxis.core.machine.bodies import BASE, BOX, CYLINDER, SPINDLE, MachineBody
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import Body, frustum_piece, round_piece

try:
    import fcl
except ImportError:
    fcl = None

LENGTH, TOLERANCE = 120.0, 0.01
BLOCKS, SAMPLED = 40_000, 40
"""Blocks of the check; those of the samples, whose time grows with their number."""
SAMPLES, ROUNDS = 200, 3
WANTED = 20_000.0
TOOL = Body(
    (
        round_piece(0.0, 3.0, 3.0),
        frustum_piece(3.0, 3.0, 40.0, 3.0),
        frustum_piece(40.0, 15.0, LENGTH, 15.0, 2),
    )
)


def bodies() -> tuple[MachineBody, ...]:
    """Ten bodies of a trunnion: what stands, cradle, platter with a chuck and clamps, and the spindle."""

    def box(name: str, carrier: str, low: tuple[float, ...], high: tuple[float, ...]) -> MachineBody:
        return MachineBody(name, carrier, BOX, (low, high))  # type: ignore[arg-type]

    def round_one(name: str, carrier: str, low: float, high: float, radius: float) -> MachineBody:
        return MachineBody(name, carrier, CYLINDER, ((0.0, 0.0, low), (0.0, 0.0, high)), (radius,))

    return (
        box("column", BASE, (-400.0, 300.0, -500.0), (400.0, 500.0, 600.0)),
        box("bed", BASE, (-400.0, -300.0, -600.0), (400.0, 300.0, -400.0)),
        box("left cheek", "A", (-260.0, -60.0, -180.0), (-200.0, 60.0, 40.0)),
        box("right cheek", "A", (200.0, -60.0, -180.0), (260.0, 60.0, 40.0)),
        box("cradle", "A", (-200.0, -60.0, -180.0), (200.0, 60.0, -140.0)),
        round_one("platter", "C", -130.0, -100.0, 100.0),
        round_one("chuck", "C", -100.0, -60.0, 60.0),
        box("left clamp", "C", (-75.0, -10.0, -100.0), (-62.0, 10.0, -20.0)),
        box("right clamp", "C", (62.0, -10.0, -100.0), (75.0, 10.0, -20.0)),
        MachineBody("nose", SPINDLE, CYLINDER, ((0.0, 0.0, 0.0), (0.0, 0.0, 80.0)), (40.0,)),
    )


def words_of(kinematics: Chain, count: int) -> Floats:
    """Words (count, 5), mm and degrees, of passes to and fro over a hill about the table's middle, both
    rotary axes turning."""
    along = np.linspace(-45.0, 45.0, 200)
    lines = -(-count // len(along))
    x = np.tile(np.concatenate([along, along[::-1]]), -(-lines // 2))[:count]
    y = np.repeat(np.linspace(-45.0, 45.0, lines), len(along))[:count]
    z = 50.0 - (x * x + y * y) / 200.0
    lean, turn = np.degrees(np.hypot(x, y) / 130.0), np.degrees(np.arctan2(y, x + 60.0))
    rotary = {"A": lean, "C": turn}
    return np.stack([x, y, z, *(rotary[letter] for letter in kinematics.letters[3:])], axis=1)


def program_of(kinematics: Chain, words: Floats) -> Program:
    """Return a program of feed moves to these words."""
    count = len(words)
    zero = np.zeros(count)
    return Program(
        kinematics.letters, words, zero + 1000.0, np.zeros(count, bool), np.zeros(count, np.int8), zero + 0.1,
        np.arange(count),
        1 + np.arange(count),
    )  # fmt: skip


def sampled_poses(
    machine: Machine, setup: Setup, kinematics: Chain, words: Floats, body: MachineBody
) -> tuple[Floats, Floats]:
    """Tips (n, 3) mm and axes (n, 3) at SAMPLES moments of each block, as the axis that carries a body sees
    them."""
    from freecad_fiveaxis.core.gouge.machine_check import find_locked_letters

    locked = lock_words(machine, setup, kinematics, words, find_locked_letters(machine, body))
    share = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    dense = (locked[:-1, None] + share * np.diff(locked, axis=0)[:, None]).reshape(-1, 5)
    return forward(kinematics, words_to_q(dense))


def fcl_check(meshes: list[Any], poses: list[tuple[Floats, Floats]], stack: Body) -> int:
    """How many samples collide with python-fcl: cylinders of the stack against the triangles of each body."""
    tools = [(piece, fcl.CollisionObject(fcl.Cylinder(*_cylinder(piece)[:2]))) for piece in stack.pieces]
    request, hits = fcl.CollisionRequest(), 0
    for mesh, (tips, axes) in zip(meshes, poses, strict=True):
        model = fcl.BVHModel()
        model.beginModel(len(mesh.vertex), len(mesh.face))
        model.addSubModel(mesh.vertex, mesh.face)
        model.endModel()
        body = fcl.CollisionObject(model)
        turns = upright(axes)
        for piece, tool in tools:
            middle = tips + _cylinder(piece)[2] * axes
            for turn, place in zip(turns, middle, strict=True):
                tool.setTransform(fcl.Transform(turn, place))
                hits += fcl.collide(tool, body, request, fcl.CollisionResult()) > 0
    return hits


def numpy_check(meshes: list[Any], poses: list[tuple[Floats, Floats]], stack: Body) -> int:
    """How many samples have a corner of a body in the stack's cylinders: less than fcl looks at, in
    columns."""
    hits = 0
    for mesh, (tips, axes) in zip(meshes, poses, strict=True):
        off = mesh.vertex[None] - tips[:, None]
        height = np.einsum("nvk,nk->nv", off, axes)
        across = np.linalg.norm(off - height[..., None] * axes[:, None], axis=2)
        for piece in stack.pieces:
            radius, tall, middle = _cylinder(piece)
            hits += int(((across < radius) & (np.abs(height - middle) < 0.5 * tall)).any(axis=1).sum())
    return hits


def upright(axes: Floats) -> Floats:
    """Rotations (n, 3, 3) that turn Z to each of the unit axes (n, 3)."""
    side = np.cross(np.eye(3)[np.abs(axes).argmin(axis=1)], axes)
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    return np.ascontiguousarray(np.stack([side, np.cross(axes, side), axes], axis=2))


def _cylinder(piece: Any) -> tuple[float, float, float]:
    """Radius, height and the height of the middle, mm, of the cylinder about a piece."""
    low, high = piece.low - piece.round, piece.high + piece.round
    return max(piece.low_radius, piece.high_radius) + piece.round, high - low, 0.5 * (low + high)


def timed(call: Callable[[], object]) -> tuple[float, float]:
    """Wall-clock and processor seconds of a call."""
    wall, processor = time.perf_counter(), time.process_time()
    call()
    return time.perf_counter() - wall, time.process_time() - processor


def main() -> None:
    """Print the rates, and how the check stands beside the samples."""
    machine = replace(load_machine("trunnion_ac"), bodies=bodies())
    setup = Setup((0.0, 0.0, 0.0), LENGTH)
    kinematics = chain(machine, setup)
    words = words_of(kinematics, BLOCKS + 1)
    given, program = InMachine(machine, setup, kinematics, TOOL, LENGTH), program_of(kinematics, words)
    stack = Body((*TOOL.pieces, *spindle_body(machine, LENGTH).pieces))
    others = [body for body in machine.bodies if body.carrier != SPINDLE]
    meshes = [make_mesh(body, np.zeros(3)) for body in others]
    few = words[np.linspace(0, BLOCKS - 1, SAMPLED).astype(int)]
    few = np.stack(
        [few, few + np.diff(words, axis=0)[np.linspace(0, BLOCKS - 1, SAMPLED).astype(int)]], axis=1
    )

    def samples() -> None:
        peer = numpy_check if fcl is None else fcl_check
        for pair in few:
            poses = [sampled_poses(machine, setup, kinematics, pair, body) for body in others]
            peer(meshes, poses, stack)

    found: tuple[Any, ...] = ()

    def check() -> None:
        nonlocal found
        found = check_machine(given, program, None, TOLERANCE)

    check()
    ours, theirs = [], []
    for _ in range(ROUNDS):
        ours.append(timed(check))
        theirs.append(timed(samples))
    name = "numpy, corners alone" if fcl is None else "python-fcl"
    rates = [
        (what, *(count / np.median(seconds, axis=0)))
        for what, count, seconds in (
            ("proven check", BLOCKS, ours),
            (f"{SAMPLES} samples, {name}", SAMPLED, theirs),
        )
    ]
    print_table(
        f"{len(others)} bodies and the spindle, {BLOCKS} blocks; findings "
        f"{sorted({one.code for one in found}) or 'none'}",
        ("", "blocks/s", "blocks/s of processor"),
        [(what, f"{wall:,.0f}", f"{processor:,.0f}") for what, wall, processor in rates],
    )
    print(
        f"\nratio {rates[0][1] / rates[1][1]:,.0f}; asked for: {WANTED:,.0f} blocks/s, found "
        f"{rates[0][1]:,.0f}"
    )


if __name__ == "__main__":
    main()
