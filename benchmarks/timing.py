# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the benchmarks take time: the median of a few runs of a callable, in one process, and a plain table of
the results."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Sequence


def run_seconds(call: Callable[[], object], repeat: int = 5) -> list[float]:
    """Return the wall-clock seconds of each of ``repeat`` runs of ``call``, after one run that is not
    counted."""
    call()
    seconds = []
    for _ in range(repeat):
        start = time.perf_counter()
        call()
        seconds.append(time.perf_counter() - start)
    return seconds


def median_seconds(call: Callable[[], object], repeat: int = 5) -> float:
    """Return the median of :func:`run_seconds`."""
    return statistics.median(run_seconds(call, repeat))


def print_table(title: str, heads: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print ``rows`` under ``heads`` in right-aligned columns."""
    text = [[str(cell) for cell in row] for row in (heads, *rows)]
    width = [max(map(len, column)) for column in zip(*text, strict=True)]
    print(f"\n{title}")
    for row in text:
        print("  ".join(cell.rjust(w) for cell, w in zip(row, width, strict=True)))
