# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviation with its proven bound against plain numpy at 100 samples a block, both in one run and in turns.

The blocks are those of a milling program: chords of about 1 mm, turns of 0.1 to 2 deg, 60 to 250 mm from the
rotary axes.
"""

from __future__ import annotations

import statistics
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import print_table, run_seconds
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, linear_words, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure, quick_bound

BLOCKS = 200_000
SAMPLED = 20_000  # blocks that numpy samples: its time grows with their number
SAMPLES = 100
ROUNDS = 5
AT_LEAST = 8.0


def milling_program(kinematics: Chain, count: int, seed: int = 1) -> Floats:
    """Words (count, 5), mm and deg, of a smooth path: chords of about 1 mm, each rotary axis turning by 0.1
    to 2 deg a block."""
    rng = np.random.default_rng(seed)
    sign = np.where(np.arange(count) // 60 % 2, 1, -1)[:, None]
    angles = np.radians((20.0, 35.0)) + np.cumsum(
        np.radians(rng.uniform(0.1, 2.0, (count, 2))) * sign * (1.0, 0.5), axis=0
    )
    way = 0.02 * np.arange(count)
    heading = np.stack([np.cos(way), np.sin(way), 0.3 * np.sin(3.0 * way)], axis=1)
    tips = np.cumsum(rng.uniform(0.7, 1.3, (count, 1)) * heading, axis=0) + (60.0, 0.0, 80.0)
    return np.concatenate([linear_words(kinematics, tips, angles), np.degrees(angles)], axis=1)


def sampled(kinematics: Chain, words: Floats, samples: int = SAMPLES) -> Floats:
    """Segment deviation (m - 1,) mm of a trunnion machine (C on A) by plain numpy: sin and cos at every
    sample, in cache."""
    _, y0, z0 = kinematics.point2
    u, q = np.linspace(0.0, 1.0, samples), words_to_q(words)
    result = np.empty(len(words) - 1)
    for first in range(0, len(result), 128):
        start, end = q[first : first + 129][:-1, :, None], q[first : first + 129][1:, :, None]
        x, y, z, c, a = np.moveaxis(start + u * (end - start), 1, 0)
        cos_a, sin_a, cos_c, sin_c = np.cos(a), np.sin(a), np.cos(c), np.sin(c)
        y, z = cos_a * (y - y0) - sin_a * (z - z0) + y0, sin_a * (y - y0) + cos_a * (z - z0) + z0
        x, y = cos_c * x - sin_c * y, sin_c * x + cos_c * y
        x, y, z = (p - p[:, :1] for p in (x, y, z))
        dx, dy, dz = (p[:, -1:] for p in (x, y, z))
        k = np.clip((x * dx + y * dy + z * dz) / (dx * dx + dy * dy + dz * dz), 0.0, 1.0)
        result[first : first + 128] = np.sqrt((x - k * dx) ** 2 + (y - k * dy) ** 2 + (z - k * dz) ** 2).max(
            axis=1
        )
    return result


def main() -> float:
    """Print the table; returns how many times as fast the deviation is."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    words = milling_program(kinematics, BLOCKS + 1)
    few = words[: SAMPLED + 1]
    calls = {
        f"numpy, {SAMPLES} samples": (lambda: sampled(kinematics, few), SAMPLED),
        "deviation and bound": (lambda: measure(kinematics, words), BLOCKS),
        "quick bound alone": (lambda: quick_bound(kinematics, words), BLOCKS),
    }
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(ROUNDS):  # in turns: a busy machine slows all of them alike
        for name, (call, count) in calls.items():
            seconds[name].append(run_seconds(call, repeat=1)[0] / count)
    rate = {name: 1.0 / statistics.median(times) for name, times in seconds.items()}
    base = rate[f"numpy, {SAMPLES} samples"]
    rows = [(name, f"{value / 1e6:.2f} M", f"{value / base:.1f}") for name, value in rate.items()]
    print_table(f"Deviation of {BLOCKS} blocks of a milling program", ("", "blocks/s", "times numpy"), rows)
    _print_accuracy(kinematics, few)
    return rate["deviation and bound"] / base


def _print_accuracy(kinematics: Chain, words: Floats) -> None:
    found = measure(kinematics, words[:2001])
    fine = sampled(kinematics, words[:2001], 4001)
    off = np.abs(found.segment[1:] - fine) / fine
    over = (found.bound - found.segment)[1:]
    print(
        f"largest difference from 4001 samples {off.max():.1e} of the deviation; bound at most "
        f"{over.max():.1e} mm above it"
    )
    print(
        "quick bound over proven bound, median "
        f"{np.median(quick_bound(kinematics, words)[1:2001] / found.bound[1:]):.2f}"
    )


if __name__ == "__main__":
    ratio = main()
    print(f"deviation: {ratio:.1f} times numpy at {SAMPLES} samples (at least {AT_LEAST:g} is asked)")
