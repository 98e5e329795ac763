# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading a CL file against splitting its lines and converting its numbers in plain Python: the same
positions, both in one run.

Run: ``python benchmarks/bench_apt.py [lines]``. The target is at most 10 times the plain way's time; it is
about twice.
"""

from __future__ import annotations

import sys

import numpy as np
from timing import median_seconds, print_table

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.toolpath.apt import read_apt

TARGET = 10.0


def big(lines: int) -> bytes:
    """Return a CL file as chatty as they come: a feed and a remark of its own at every place."""
    numbers = np.random.default_rng(1).uniform(-100, 100, (lines // 3, 3))
    rows = [
        f"PPRINT MOVE {k}\nFEDRAT/{500 + k % 7},MMPM\nGOTO/{x:.4f},{y:.4f},{z:.4f},0,0.6,0.8"
        for k, (x, y, z) in enumerate(numbers)
    ]
    return "\n".join(rows).encode()


def in_plain_python(text: bytes) -> Floats:
    """Return the positions, and nothing else, of a file of GOTO lines."""
    rows = [
        [float(part) for part in line[5:].split(b",")]
        for line in text.split(b"\n")
        if line.startswith(b"GOTO/")
    ]
    return np.array(rows)[:, :3]


def main(lines: int = 99_000) -> float:
    """Print the table of times; returns how many times the plain way's time reading takes."""
    text = big(lines)
    if not np.array_equal(in_plain_python(text), read_apt(text).tip):
        sys.exit("the ways give different positions")
    ours, plain = median_seconds(lambda: read_apt(text)), median_seconds(lambda: in_plain_python(text))
    rows = [("read_apt", f"{ours:.3f}", f"{ours / plain:.1f}"), ("plain Python", f"{plain:.3f}", "1.0")]
    print_table(f"{lines} lines of a CL file, {len(text) / 1e6:.1f} MB", ("way", "s", "times plain"), rows)
    print(f"  target at most {TARGET:.0f} times: {'reached' if ours <= TARGET * plain else 'MISSED'}")
    return ours / plain


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:]))
