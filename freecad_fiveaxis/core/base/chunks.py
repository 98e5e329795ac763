# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work on long columns by several threads: the one place of the core that knows threads.

portion   some rows of long columns, worked on by themselves: nothing that is done to them depends on other
          portions, so the result is the same to the last bit with one thread or many, whoever does which.
helper    a thread beside the calling one, as many as there are processors. It lives as long as the call, and
          never longer.

numpy lets Python go on in another thread during each of its calls, but not between them. So threads are
faster only where calls are long, with tens of thousands of rows; with short ones each only waits for the
others.
"""

from __future__ import annotations

import math
import os
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np

P = TypeVar("P")
R = TypeVar("R")

PORTION = 98304
"""Rows of a portion: long enough for two threads to work side by side, short enough for its columns to stay
in the cache."""

PROCESSORS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
"""That this process may use."""

ALONE = PROCESSORS < 2
"""True where a second thread has no processor to run on."""

_inside = threading.local()


def chunks(count: int, most: int | None = None) -> list[slice]:
    """Slices of nearly the same length, at most ``most`` rows (None: PORTION), that make up ``count`` rows:
    one for up to PORTION rows, else an even number, so that two threads have as much to do. It does not
    depend on the processors that there are."""
    if not count:
        return []
    number = 2 * math.ceil(count / (2 * (most or PORTION))) if count > PORTION else 1
    ends = [count * part // number for part in range(number + 1)]
    return [slice(*pair) for pair in pairwise(ends)]


def batches(count: int, rows: int) -> list[slice]:
    """Slices of ``rows`` rows, the last one shorter, that make up ``count``: for work whose progress is to be
    told between them, and that may be stopped there."""
    return [slice(start, min(start + rows, count)) for start in range(0, count, rows)]


def in_threads(
    work: Callable[[P], R], parts: Sequence[P], progress: Callable[[float], None] | None = None
) -> list[R]:
    """Return what ``work`` gives for each of ``parts``, in their order; as many of them at a time as there
    are processors.

    ``progress`` gets the share that is done, always on the calling thread. An exception in ``work`` or from
    ``progress`` (:class:`~freecad_fiveaxis.core.base.errors.Cancelled` too) passes through once all threads
    have ended the part they are at. Within ``work`` another on_all keeps to its thread.
    """
    results: dict[int, R] = {}
    todo = deque(enumerate(parts))

    def take_share(tell: Callable[[float], None] | None) -> None:
        outer, _inside.work = getattr(_inside, "work", False), True
        try:
            while todo:
                try:
                    place, part = todo.popleft()
                except IndexError:  # another one was faster
                    break
                results[place] = work(part)
                if tell is not None:
                    tell(len(results) / len(parts))
        finally:
            todo.clear()  # all is taken, or what is left is not wanted any more
            _inside.work = outer

    if ALONE or len(parts) < 2 or getattr(_inside, "work", False):
        take_share(progress)
    else:
        helpers = max(min(PROCESSORS, len(parts)) - 1, 1)
        _beside([lambda: take_share(None)] * helpers, lambda: take_share(progress))
    return [results[place] for place in range(len(parts))]


@contextmanager
def keep_to_one_thread() -> Iterator[None]:
    """Do all that comes meanwhile on the calling thread alone: where other jobs have the other processors."""
    outer = getattr(_inside, "work", False), getattr(_inside, "alone", False)
    _inside.work = _inside.alone = True
    try:
        yield
    finally:
        _inside.work, _inside.alone = outer


def meanwhile(second: Callable[[], Any], work: Callable[[], R]) -> R:
    """Return what ``work`` gives, done while the helper does ``second``, under the same rules for
    floating-point errors; one after the other where all is kept to one thread."""
    if getattr(_inside, "alone", False):
        second()
        return work()
    return _beside([second], work)


def _beside(others: Sequence[Callable[[], Any]], work: Callable[[], R]) -> R:
    """Return what ``work`` gives, done while a helper does each of the others, under the same rules for
    floating-point errors."""
    rules = np.geterr()

    def help_with(other: Callable[[], Any]) -> None:
        with np.errstate(**rules):
            other()

    with ThreadPoolExecutor(len(others)) as threads:
        helping = [threads.submit(help_with, other) for other in others]
        done = work()
        for one in helping:
            one.result()
    return done
