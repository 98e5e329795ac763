# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of one piece of work in two threads.

numpy lets Python go on while it works on a long column, so two threads gain where columns are long; two that both take short
steps only wait for one another. What the parts give must not depend on who comes first.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

P = TypeVar("P")
T = TypeVar("T")

THREADS = 2
"""More of them wait for Python more often than they gain."""


def side_by_side(work: Callable[[P], T], parts: Sequence[P], done: Callable[[float], None] = lambda share: None) -> list[T]:
    """What ``work`` gives for each of the parts, in their order. One after another where there is one core or one part.

    ``done(share)`` is called from this thread after each part with the share of the parts that are done, 0 to 1. What it or
    ``work`` raises is raised here; parts that have not begun by then are left.
    """
    if len(parts) < 2 or _cores() < 2:
        return [_told(work(part), number, parts, done) for number, part in enumerate(parts)]
    pool = ThreadPoolExecutor(THREADS)
    try:
        waiting = [pool.submit(work, part) for part in parts]
        return [_told(future.result(), number, parts, done) for number, future in enumerate(waiting)]
    finally:
        pool.shutdown(cancel_futures=True)


def _told(result: T, number: int, parts: Sequence[P], done: Callable[[float], None]) -> T:
    done((number + 1) / len(parts))
    return result


def _cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
