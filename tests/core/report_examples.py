# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs with figures for the tests of the reports; the deviation by plain dense sampling, so that nothing
else is needed."""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, inverse
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.singularity import Singularity
from freecad_fiveaxis.core.report.figures import Figures
from freecad_fiveaxis.core.report.judgement import judge
from freecad_fiveaxis.core.toolpath.cl_path import Motion

X, Y, Z = (
    Axis(name, False, "head", tuple(row), max_rate=20e3)
    for name, row in zip("XYZ", np.eye(3).tolist(), strict=True)
)
C = Axis("C", True, "table", (0, 0, 1), max_rate=math.radians(14400))
A = Axis(
    "A",
    True,
    "table",
    (1, 0, 0),
    (0, -49.934, 119.999),
    math.radians(-30),
    math.radians(120),
    math.radians(7200),
)
B = Axis("B", True, "table", (0, 1, 0), (0, 0, 50))
TRUNNION = Machine("mikron_ucp710", (C, A, X, Y, Z))
TRUNNION_BC = Machine("trunnion_bc", (C, B, X, Y, Z))

TABLE2 = np.array(
    [[-90.9595, 7.3103, 227.6341, 148.9685, 1.0664], [-82.0656, -34.8175, 228.3975, 121.5477, 1.1793]]
)
"""So et al. 2008, Table 2: the two NC rows of the MIKRON UCP-710."""


def sampled(kinematics: Chain, words: np.ndarray, steps: int = 401) -> tuple[Deviation, Singularity]:
    """Both records by sampling every block; the bound is the maximum and a little."""
    u = np.linspace(0.0, 1.0, steps)
    inner = np.concatenate([words[:, :3], np.radians(words[:, 3:])], axis=1)
    start = np.concatenate([inner[:1], inner[:-1]])
    q = start[:, None] + u[None, :, None] * (inner - start)[:, None]
    tip, axis = (part.reshape(len(words), steps, 3) for part in forward(kinematics, q.reshape(-1, 5)))
    chord = tip[:, -1] - tip[:, 0]
    length = np.maximum(np.linalg.norm(chord, axis=1), 1e-12)
    share = np.einsum("mki,mi->mk", tip - tip[:, :1], chord) / length[:, None] ** 2
    line = np.linalg.norm(tip - tip[:, :1] - share[..., None] * chord[:, None], axis=2)
    segment = np.linalg.norm(tip - tip[:, :1] - np.clip(share, 0, 1)[..., None] * chord[:, None], axis=2)
    rows, at = np.arange(len(words)), segment.argmax(axis=1)
    worst = segment[rows, at]
    side = np.cross(axis[:, 0], axis[:, -1])
    side /= np.maximum(np.linalg.norm(side, axis=1), 1e-12)[:, None]
    aside = np.arcsin(np.clip(np.abs(np.einsum("mki,mi->mk", axis, side)).max(axis=1), 0, 1))
    lean = np.arccos(np.clip((axis[:, 0] * axis[:, -1]).sum(axis=1), -1, 1))
    deviation = Deviation(
        line.max(axis=1),
        u[line.argmax(axis=1)],
        worst,
        u[at],
        worst * 1.0001 + 1e-7 * (rows > 0),
        aside,
        tip[rows, at],
    )
    sine = np.linalg.norm(np.cross(axis, kinematics.direction[3]), axis=2).min(axis=1)
    turned = np.abs(inner - start)[:, 3:].max(axis=1)
    singular = (sine < math.sin(math.radians(5.0))) & (turned > 4.0 * lean) & (turned > math.radians(1.0))
    return deviation, Singularity(sine, turned, lean, singular)


def program_of(
    kinematics: Chain, words: np.ndarray, motion: np.ndarray | None = None, feed: float = 1000.0
) -> Program:
    """A program of rounded words with two lines before its first; the slowest axis or the feed gives the
    time."""
    count = len(words)
    motion = np.zeros(count, np.int8) if motion is None else motion
    inner = np.concatenate([words[:, :3], np.radians(words[:, 3:])], axis=1)
    moved, tip = np.abs(np.diff(inner, axis=0)), forward(kinematics, inner)[0]
    minutes = np.maximum(
        (moved / kinematics.rate).max(axis=1), np.linalg.norm(np.diff(tip, axis=0), axis=1) / feed
    )
    seconds = 60.0 * np.concatenate([[0.0], minutes])
    rapid = motion == Motion.RAPID
    return Program(
        kinematics.letters,
        np.round(words, 4),
        np.where(rapid, 0.0, feed),
        ~rapid,
        motion,
        seconds,
        np.arange(count),
        np.arange(count) + 3,
    )


def figures_of(
    machine: Machine, words: np.ndarray, motion: np.ndarray | None = None, tolerance: float = 0.01, **more
) -> Figures:
    """The whole record, judged."""
    kinematics = chain(machine, Setup())
    program = program_of(kinematics, words, motion)
    deviation, singularity = sampled(kinematics, program.words)
    found = judge(kinematics, program, deviation, singularity, tolerance)
    given = {
        "title": "part.stl",
        "kind": "mill",
        "findings": found,
        "inputs": {"machine": machine.name},
    } | more
    return Figures(
        machine=machine,
        kinematics=kinematics,
        program=program,
        deviation=deviation,
        singularity=singularity,
        tolerance=tolerance,
        **given,
    )


def table2(**more) -> Figures:
    """The paper's block: one block, 2.126 mm off its chord."""
    return figures_of(TRUNNION, TABLE2, **({"title": "table2.ngc", "kind": "audit"} | more))


def dome(machine: Machine = TRUNNION, passes: int = 20, points: int = 60, **more) -> Figures:
    """Zigzag over a dome R 60, the tool along its normal; the middle passes go close by the pole."""
    across = np.linspace(-18.0, 18.0, passes)
    along = np.linspace(-30.0, 30.0, points)
    x = np.concatenate([along if i % 2 == 0 else along[::-1] for i in range(passes)])
    y = np.repeat(across, points)
    normal = np.column_stack([x, y, np.sqrt(60.0**2 - x**2 - y**2)]) / 60.0
    kinematics = chain(machine, Setup())
    tip = 60.0 * normal - (0.0, 0.0, 60.0)
    motion = np.zeros(len(x), np.int8)
    motion[::points] = Motion.LINK
    motion[1::points] = Motion.CUT
    lifted = tip.copy()
    lifted[:, 2] += 10.0
    both = [np.concatenate([[lifted[i * points]], tip[i * points : (i + 1) * points]]) for i in range(passes)]
    axes = [
        np.concatenate([[normal[i * points]], normal[i * points : (i + 1) * points]]) for i in range(passes)
    ]
    kinds = [np.concatenate([[Motion.RAPID], motion[i * points : (i + 1) * points]]) for i in range(passes)]
    q = inverse(kinematics, np.concatenate(both), np.concatenate(axes))[0][0]
    q[:, 3] = np.unwrap(q[:, 3])
    words = np.concatenate([q[:, :3], np.degrees(q[:, 3:])], axis=1)
    return figures_of(machine, words, np.concatenate(kinds).astype(np.int8), **({"title": "dome.stl"} | more))


def by_hand(tolerance: float = 0.01, **more) -> Figures:
    """Seven blocks whose figures are set by hand; two leave the tolerance of 0.01 mm, one is not proven, one
    rapid is far off."""
    words = np.zeros((7, 5))
    words[:, 0] = np.arange(7.0)
    words[4:, 3] = 90.0
    motion = np.array([3, 2, 0, 3, 0, 1, 0], np.int8)
    kinematics = chain(TRUNNION, Setup())
    program = program_of(kinematics, words, motion)
    segment = np.array([0.0, 0.005, 0.02, 0.5, 0.03, 0.0099, 0.01])
    bound = np.array([0.0, 0.006, 0.021, 0.51, 0.031, 0.0101, 0.01])
    place = np.column_stack([np.arange(7.0), np.full(7, 2.0), np.full(7, 3.0)])
    deviation = Deviation(
        segment / 2, np.full(7, 0.25), segment, np.full(7, 0.5), bound, np.full(7, 0.001), place
    )
    singular = np.array([False, False, False, True, True, False, False])
    singularity = Singularity(np.full(7, 0.1), np.full(7, 0.2), np.full(7, 0.01), singular)
    found = judge(kinematics, program, deviation, singularity, tolerance)
    given = {"title": "hand.stl", "kind": "mill", "findings": found, "inputs": {}} | more
    return Figures(
        machine=TRUNNION,
        kinematics=kinematics,
        program=program,
        deviation=deviation,
        singularity=singularity,
        tolerance=tolerance,
        **given,
    )


def empty() -> Figures:
    """A program without a block."""
    kinematics = chain(TRUNNION, Setup())
    none = np.zeros(0)
    program = Program(
        kinematics.letters,
        np.zeros((0, 5)),
        none,
        none.astype(bool),
        none.astype(np.int8),
        none,
        none.astype(int),
        none.astype(int),
    )
    deviation = Deviation(none, none, none, none, none, none, np.zeros((0, 3)))
    singularity = Singularity(none, none, none, none.astype(bool))
    return Figures("empty.ngc", "audit", TRUNNION, kinematics, program, deviation, singularity, 0.01)
