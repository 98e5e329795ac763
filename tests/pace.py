# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine's pace: a limit of time holds where it was set, a slower machine is given as much more."""

import statistics
import time

SET_AT = 6e-3
"""s of the work below where the limits of time were set."""


def pace() -> float:
    """How many times slower than there Python runs here and now; at least 1. It takes 0.1 s."""
    spent = []
    for _ in range(9):
        began = time.thread_time()
        sum(i * i for i in range(100_000))
        spent.append(time.thread_time() - began)
    return max(1.0, statistics.median(spent) / SET_AT)
