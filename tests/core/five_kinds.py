# SPDX-License-Identifier: LGPL-2.1-or-later
"""One machine of each kind of chain, random blocks for them, and their real path by dense sampling: for the
tests of the trajectory, the deviation and its bound."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, linear_words, words_to_q
from freecad_fiveaxis.core.motion.trajectory import at, frames, motion, tip

HALF = 0.5**0.5
SAMPLES = 2001
FARTHEST = 3000.0  # mm: beyond, a table's linear axis has turned parallel to another one
POINT = 1e-5  # mm: a shorter chord is a point, as docs/deviation.md says

_X, _Y, _Z = (
    Axis(letter, False, "head", tuple(row)) for letter, row in zip("XYZ", np.eye(3).tolist(), strict=True)
)
_C = Axis("C", True, "table", (0, 0, 1), (5, 6, 0))
_TABLE_X, _TABLE_Y = Axis("X", False, "table", (1, 0, 0)), Axis("Y", False, "table", (0, 1, 0))

KINDS = {
    "table_table": (_C, Axis("A", True, "table", (1, 0, 0), (0, -49.934, 119.999)), _X, _Y, _Z),
    "nutating": (_C, Axis("B", True, "table", (0, HALF, HALF), (3, 4, -40)), _X, _Y, _Z),
    "head_table": (_C, _X, _Y, _Z, Axis("B", True, "head", (0, 1, 0), (0, 0, 200))),
    "head_head": (
        _X,
        _Y,
        _Z,
        Axis("C", True, "head", (0, 0, 1)),
        Axis("B", True, "head", (0, 1, 0), (0, 0, 200)),
    ),
    "linear_axes_everywhere": (_TABLE_X, _C, _TABLE_Y, Axis("A", True, "head", (1, 0, 0), (0, 3, 150)), _Z),
}

NUTATIONS = (5.0, 15.0, 29.0, 29.9, 31.0, 60.0)


def nutating(degrees: float, side: str) -> Chain:
    """A table-table or head-head machine whose second rotary axis leans by so much from the spindle, in a
    plane of its own; the two rotary axes do not meet."""
    lean, about = np.deg2rad(degrees), 0.7
    direction = (np.sin(lean) * np.cos(about), np.sin(lean) * np.sin(about), np.cos(lean))
    first, second = Axis("C", True, side, (0, 0, 1), (5, 6, 0)), Axis("B", True, side, direction, (3, 4, 150))
    axes = (first, second, _X, _Y, _Z) if side == "table" else (_X, _Y, _Z, first, second)
    return chain(Machine(f"nutating {degrees:g}", axes), Setup((10.0, 20.0, 30.0), 150.0))


def kinematics_of(kind: str) -> Chain:
    """The chain of one of the machines."""
    return chain(Machine(kind, KINDS[kind]), Setup((10.0, 20.0, 30.0), 150.0))


def random_blocks(kinematics: Chain, count: int, seed: int) -> tuple[Floats, Floats]:
    """Start and end words (count, 5), mm and deg: turns of 1e-4 to 180 deg or none, of each axis by itself;
    chords of 1e-3 to 300 mm or none on the part, and for a quarter of the blocks such moves of the linear
    axes instead."""
    rng = np.random.default_rng(seed)
    start = rng.uniform(-1, 1, (count, 5)) * (200, 200, 200, 180, 110)
    turns = (
        10 ** rng.uniform(-4, np.log10(180), (count, 2))
        * rng.choice((-1, 1), (count, 2))
        * (rng.random((count, 2)) > 0.1)
    )
    move = rng.normal(size=(count, 3))
    move *= (
        10 ** rng.uniform(-3, np.log10(300), count) * (rng.random(count) > 0.1) / np.linalg.norm(move, axis=1)
    )[:, None]
    end = start + np.concatenate([move, turns], axis=1)
    linear = linear_words(
        kinematics, forward(kinematics, words_to_q(start))[0] + move, words_to_q(end)[:, 3:]
    )
    on_part = (rng.random(count) > 0.25) & (np.abs(linear).max(axis=1) < FARTHEST)
    end[on_part, :3] = linear[on_part]
    return start, end


def interleaved(start: Floats, end: Floats) -> Floats:
    """Words (2 m, 5) of which every odd row ends one of the blocks."""
    return np.stack([start, end], axis=1).reshape(-1, 5)


def sampled_deviation(
    kinematics: Chain, start: Floats, end: Floats, samples: int = SAMPLES
) -> tuple[Floats, Floats]:
    """Segment and line deviation (m,) mm by samples of each block and a parabola through the largest and its
    neighbours."""
    frame = frames(kinematics)
    segment, line = np.empty(len(start)), np.empty(len(start))
    for first in range(0, len(start), 8):
        part = slice(first, first + 8)
        move = motion(frame, start[part], end[part]).take((slice(None), None))
        u = np.linspace(0.0, 1.0, samples)[None]
        path = tip(frame, at(move, u))
        x = [p - p[:, :1] for p in path]
        chord = [p[:, -1:] for p in x]
        length2 = sum(d * d for d in chord)
        foot = sum(p * d for p, d in zip(x, chord, strict=True)) / np.maximum(length2, POINT**2)
        share = np.where(length2 > POINT**2, foot, u)
        for result, k in ((segment, np.clip(share, 0.0, 1.0)), (line, share)):
            result[part] = _peak(np.sqrt(sum((p - k * d) ** 2 for p, d in zip(x, chord, strict=True))))
    return segment, line


def _peak(distance: Floats) -> Floats:
    top = np.clip(distance.argmax(axis=1), 1, distance.shape[1] - 2)
    low, mid, high = (np.take_along_axis(distance, top[:, None] + step, 1)[:, 0] for step in (-1, 0, 1))
    bend = 2.0 * mid - low - high
    rise = np.where(
        (mid >= low) & (mid >= high) & (bend > 0),
        (high - low) ** 2 / (8.0 * np.where(bend > 0, bend, 1.0)),
        0.0,
    )
    return np.maximum(distance.max(axis=1), mid + rise)


# So et al. 2008, Table 2, in word order X Y Z C A, mm and degrees
TABLE_2 = np.array(
    [[-90.9595, 7.3103, 227.6341, 148.9685, 1.0664], [-82.0656, -34.8175, 228.3975, 121.5477, 1.1793]]
)


def mikron_links():
    """The chain of the machine that Table 2 is for."""
    machine = load_machine("mikron_ucp710")
    return chain(machine, Setup(machine.origin))
