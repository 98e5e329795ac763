# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finding room for a view's labels: twelve crowded labels and a legend, as a share of the 5 ms that a frame
has for all labels.

Run: ``python benchmarks/bench_labels.py``. The target is less than the whole of it.
"""

from __future__ import annotations

import numpy as np
from timing import print_table, run_seconds

from freecad_fiveaxis.gui.scene import layout

FRAME = 5e-3
"""s, for all labels of a view."""
VIEW = (1200, 700)


def main() -> float:
    """Print the table of times; returns the quickest run's share of a frame: other work only ever slows."""
    anchor = np.random.default_rng(5).normal((600.0, 350.0), 30.0, (12, 2))
    taken = np.array([[12.0, 150.0, 320.0, 560.0]])
    size, before = np.broadcast_to((150.0, 23.0), anchor.shape), np.full(len(anchor), -1)
    best = min(run_seconds(lambda: layout.label_places(anchor, size, VIEW, taken, before), repeat=20))
    print_table(
        "twelve labels of one view",
        ("ms", "share of a frame"),
        [(f"{1e3 * best:.2f}", f"{best / FRAME:.2f}")],
    )
    print(f"  target below 1: {'reached' if best < FRAME else 'MISSED'}")
    return best / FRAME


if __name__ == "__main__":
    main()
