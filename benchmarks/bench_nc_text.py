# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text: the table writer against ``%`` row by row, byte for byte the same, both in one run.

Run: ``python benchmarks/bench_nc_text.py [rows]``. The target is 12 times the loop ``form % tuple(row)``.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import numpy as np

from freecad_fiveaxis.core.base.number_text import Column, table
from freecad_fiveaxis.core.base.records import Floats

LETTERS, FORM = (b"X", b" Y", b" Z", b" A", b" C"), "X%.4f Y%.4f Z%.4f A%.4f C%.4f\n"
TARGET = 12.0
REPEATS = 4


def some_words(rows: int) -> Floats:
    """Words as a program has them: rounded to 4 decimals, columns contiguous."""
    random = np.random.default_rng(0)
    return np.asfortranarray(np.round(random.uniform(-200.0, 200.0, (rows, 5)), 4))


def by_table(words: Floats) -> bytes:
    return table([Column(letter, words[:, k], 4) for k, letter in enumerate(LETTERS)])


def by_percent(words: Floats) -> bytes:
    return "".join([FORM % tuple(row) for row in words]).encode()


def by_percent_of_lists(words: Floats) -> bytes:
    """Return the same with Python floats, which ``%`` prints faster than numpy's."""
    return "".join([FORM % tuple(row) for row in words.tolist()]).encode()


def main(rows: int = 500_000) -> float:
    """Print the table of times; returns the ratio against the plain loop.

    The ways take turns and the fastest of each counts, because other work on the machine only ever slows.
    """
    words, best, texts = some_words(rows), dict.fromkeys(WAYS, float("inf")), {}
    for _ in range(REPEATS):
        for name, way in WAYS.items():
            start = time.perf_counter()
            texts[name] = way(words)
            best[name] = min(best[name], time.perf_counter() - start)
    assert len(set(texts.values())) == 1, "the ways give different bytes"
    print(f"{rows} blocks of five words, {len(texts['table']) / 1e6:.1f} MB, all byte for byte the same")
    for name, seconds in best.items():
        ratio = seconds / best["table"]
        print(
            f"  {name:12} {seconds:7.3f} s {rows / seconds / 1e6:6.2f} M blocks/s   {ratio:5.1f} times the "
            "table's time"
        )
    ratio = best["% per row"] / best["table"]
    print(f"  target {TARGET:.0f} times: {'reached' if ratio >= TARGET else 'MISSED'}")
    return ratio


WAYS: dict[str, Callable[[Floats], bytes]] = {
    "table": by_table,
    "% per row": by_percent,
    "% per list": by_percent_of_lists,
}

if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:]))
