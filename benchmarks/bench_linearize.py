# SPDX-License-Identifier: LGPL-2.1-or-later
"""Division of blocks over tolerance against bisection, both in one run and in turns.

The peer is what posts do, written plainly in numpy, all blocks of a level at once: the tip half way along the
chord, the tool axis half way along its great arc, the branch next to the words' own middle, every half proven
by ``measure``, and halved again until all hold. Blocks of half a turn about the pole itself, where that comes
to no end, are left out of the comparison.

Two kinds of programs of blocks that are all over tolerance: cuts of a milling program whose rotary axes turn
by some degrees a block, and random blocks, among them turns of half a turn about levers of many hundred
millimetres, and ways by the pole.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "core"))

from five_kinds import interleaved, kinematics_of, random_blocks

from benchmarks.timing import print_table
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    Setup,
    chain,
    forward,
    inverse_axis,
    joint_words,
    q_to_words,
    words_to_q,
)
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.linearize import linearize_words

BLOCKS = 10_000
DECIMALS = 4
TOLERANCE = 0.01
ROUNDS = 3
AT_LEAST = 100_000
DEPTH = 12
"""Halvings of the peer; a block that needs more is given up."""


def milling_cuts(kinematics: Chain, count: int, seed: int = 3) -> Floats:
    """Words (count, 5), mm and deg, of a path of chords of about 4 mm, turning by 2 to 10 deg about each axis
    in a block."""
    rng = np.random.default_rng(seed)
    sign = np.where(np.arange(count) // 12 % 2, 1.0, -1.0)[:, None]
    angles = np.radians(
        (20.0, 40.0) + np.cumsum(rng.uniform(2.0, 10.0, (count, 2)) * sign * (1.0, 0.3), axis=0) * (1.0, 0.5)
    )
    way = 0.05 * np.arange(count)
    heading = np.stack([np.cos(way), np.sin(way), 0.3 * np.sin(3.0 * way)], axis=1)
    tips = np.cumsum(rng.uniform(2.0, 6.0, (count, 1)) * heading, axis=0) + (60.0, 0.0, 80.0)
    return np.round(q_to_words(joint_words(kinematics, tips, angles)), DECIMALS)


def bisected(kinematics: Chain, start: Floats, end: Floats) -> Ints:
    """How many pieces (b,) bisection makes of blocks from words ``start`` to ``end`` (b, 5); 0 where it comes
    to no end."""
    q = np.stack([words_to_q(start), words_to_q(end)])
    (tip, axis), way = forward(kinematics, q.reshape(-1, 5)), q[:, :, 3:]
    tip, axis = tip.reshape(2, -1, 3), axis.reshape(2, -1, 3)
    count, block, low, width = (
        np.zeros(len(start), np.int64),
        np.arange(len(start)),
        np.zeros(len(start)),
        1.0,
    )
    for _ in range(DEPTH):
        ends = np.stack([_half_way(kinematics, tip, axis, way, block, low + u) for u in (0.0, width)])
        for u, own, k in ((0.0, start, 0), (1.0, end, 1)):
            ends[k][low + k * width == u] = own[block[low + k * width == u]]
        good = _holds(kinematics, ends, tip[:, block])
        count += np.bincount(block[good], minlength=len(start))
        width, block, low = 0.5 * width, np.repeat(block[~good], 2), np.repeat(low[~good], 2)
        low[1::2] += width
        if not len(block):
            break
    count[block] = 0
    return count


def _half_way(kinematics: Chain, tip: Floats, axis: Floats, way: Floats, block: Ints, u: Floats) -> Floats:
    """Return rounded words at a share ``u`` of each block: the tip on the chord, the axis on the great
    arc."""
    share = u[:, None]
    middle = (1.0 - share) * way[0, block] + share * way[1, block]
    angle = np.arccos(np.clip((axis[0, block] * axis[1, block]).sum(1), -1.0, 1.0))[:, None]
    a, b = (
        np.where(angle > 1e-9, np.sin(s * angle) / np.maximum(np.sin(angle), 1e-12), s)
        for s in (1.0 - share, share)
    )
    arc = a * axis[0, block] + b * axis[1, block]
    both = inverse_axis(kinematics, arc / np.linalg.norm(arc, axis=1)[:, None])[0]
    both += 2.0 * np.pi * np.rint((middle - both) / (2.0 * np.pi))
    near = np.abs(both - middle).sum(2).argmin(0)
    angles = np.radians(np.round(np.degrees(both[near, np.arange(len(block))]), DECIMALS))
    tips = (1.0 - share) * tip[0, block] + share * tip[1, block]
    return np.round(q_to_words(joint_words(kinematics, tips, angles)), DECIMALS)


def _holds(kinematics: Chain, ends: Floats, tip: Floats) -> Bools:
    """Which pieces between words ``ends`` (2, n, 5) are proven to stay within tolerance of the segments
    ``tip`` (2, n, 3)."""
    bound = measure(kinematics, interleaved(*ends)).bound[1::2]
    chord = tip[1] - tip[0]
    off = []
    for words in ends:
        aside = forward(kinematics, words_to_q(words))[0] - tip[0]
        share = np.clip((aside * chord).sum(1) / np.maximum((chord**2).sum(1), 1e-18), 0.0, 1.0)
        off.append(np.linalg.norm(aside - share[:, None] * chord, axis=1))
    return np.asarray(bound + np.maximum(*off) <= TOLERANCE)


def compare(name: str, kinematics: Chain, words: Floats, feeds: Ints) -> tuple[list[object], float]:
    """Return a row of the table, and output blocks a second."""
    rows = feeds[measure(kinematics, words).segment[feeds] > TOLERANCE]
    wanted = np.zeros(len(words), bool)
    wanted[rows] = True
    _, row, _ = linearize_words(kinematics, words, (DECIMALS, DECIMALS), TOLERANCE, wanted)
    count, halves = (
        np.bincount(row, minlength=len(words))[rows],
        bisected(kinematics, words[rows - 1], words[rows]),
    )
    calls = (
        lambda: linearize_words(kinematics, words, (DECIMALS, DECIMALS), TOLERANCE, wanted),
        lambda: bisected(kinematics, words[rows - 1], words[rows]),
    )
    ours, peers = np.min(
        [[_seconds(call) for call in calls] for _ in range(ROUNDS)], axis=0
    )  # both are warm; least disturbed
    many, rate, other = halves > 4, count.sum() / ours, halves.sum() / peers
    ratio = statistics.median((count[many] / halves[many]).tolist())
    more = f"{int((count > halves)[halves > 0].sum())} of {int((halves > 0).sum())}"
    rates = [f"{rate / 1e3:.0f} k", f"{other / 1e3:.0f} k", f"{rate / other:.1f}"]
    return [name, len(rows), count.sum(), *rates, f"{ratio:.2f}", more], rate


def _seconds(call: Callable[[], object]) -> float:
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


HEADS = ("blocks", "over", "made", "made/s", "peer made/s", "ratio", "made/peer made", "worse than the peer")
KINDS = ("table_table", "nutating", "head_table", "head_head")


def main() -> float:
    """Print the table; returns output blocks a second on the milling program."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    words = milling_cuts(kinematics, BLOCKS + 1)
    table, rates = zip(
        compare("milling, trunnion", kinematics, words, np.arange(1, len(words))),
        *map(_random, KINDS),
        strict=True,
    )
    print_table(
        f"Blocks divided for {TOLERANCE:g} mm, words of {DECIMALS} decimals, and bisection", HEADS, table
    )
    return float(rates[0])


def _random(kind: str) -> tuple[list[object], float]:
    kinematics = kinematics_of(kind)
    words = np.round(interleaved(*random_blocks(kinematics, BLOCKS // 5, 41)), DECIMALS)
    return compare(f"random, {kind}", kinematics, words, np.arange(1, len(words), 2))


if __name__ == "__main__":
    speed = main()
    print(f"linearize: {speed / 1e3:.0f} k blocks a second (at least {AT_LEAST / 1e3:.0f} k is asked)")
