# SPDX-License-Identifier: LGPL-2.1-or-later
"""Workers: how they are begun, how they are told to stop, and that none is left behind.

crew      makes executors of threads or processes, and can tell all of their workers to stop.
worker    does one task after the other; between two steps of a task it looks whether it is to stop.

Processes are begun anew (spawn), never forked: a copy of threads and locks that are in use is no beginning.
They leave Ctrl-C to the process that began them, which tells them to stop; and they end where that has ended.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, Protocol

from .errors import Cancelled, SettingsError
from .sentences import say

WORKERS = "--workers"
"""Of the command line, which alone knows it: no window has a name for it."""
MOST_WORKERS = 4096
"""More than one computer has processors: a slip of the pen."""
MOST_ON_WINDOWS = 61
"""Processes: Windows waits for no more."""
ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""What libraries below numpy read when they are loaded."""

_here = threading.local()


class Stop(Protocol):
    """An event of threads or of processes."""

    def set(self) -> None:
        """Ask all who look at it to stop."""

    def is_set(self) -> bool:
        """Say whether they are asked to."""


class Crew:
    """How an executor is made. ``make``: of so many workers."""

    def __init__(self, make: Callable[[int], Executor], workers: int, stop: Stop) -> None:
        self._make, self._workers, self._stop = make, workers, stop

    def open(self, workers: int | None = None) -> Executor:
        """Return a new executor, of so many workers or of all."""
        return self._make(workers or self._workers)

    def stop(self) -> None:
        """Tell the workers to leave what they are at."""
        self._stop.set()


def read_workers(given: str) -> int:
    """How many workers a word of the command line asks for. Raises SettingsError."""
    if not (given.isascii() and given.isdigit() and 1 <= int(given) <= MOST_WORKERS):
        raise SettingsError(
            say("{workers} {given} is no count; give a whole number from 1 on", workers=WORKERS, given=given),
            given,
        )
    return int(given)


def thread_crew(workers: int) -> Crew:
    """Threads of this process."""
    stop = threading.Event()
    return Crew(lambda number: ThreadPoolExecutor(number, initializer=begin, initargs=(stop,)), workers, stop)


def process_crew(workers: int) -> Crew:
    """Return processes of this computer."""
    context = multiprocessing.get_context("spawn")
    stop = context.Event()
    workers = min(workers, MOST_ON_WINDOWS) if sys.platform == "win32" else workers
    return Crew(lambda number: _open_processes(number, context, stop), workers, stop)


def _open_processes(number: int, context: Any, stop: Any) -> ProcessPoolExecutor:
    """Return processes that find ONE_THREAD in their environment: one that imports ``__main__`` may import
    numpy with it, before begin_process is heard, and OpenBLAS then spins on every processor. What the user
    has set stays."""
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")
    return ProcessPoolExecutor(number, context, begin_process, (stop,))


@contextmanager
def at_work(crew: Crew | None) -> Iterator[Executor | None]:
    """Yield the executor of a crew, which ends with the block, after all that its workers were at; None for
    none. Where the block is left by an exception, they are told to stop first."""
    if crew is None:
        yield None
        return
    pool = crew.open()
    try:
        yield pool
    except BaseException:
        crew.stop()
        raise
    finally:
        end_pool(pool, wait=True)


def end_pool(pool: Executor, wait: bool) -> None:
    """End an executor, and cancel what waits in it; ``wait`` for what its workers are at."""
    try:
        pool.shutdown(wait=wait, cancel_futures=True)
    except TypeError:  # dask's and loky's know no such argument; who gave them work has cancelled it
        pool.shutdown(wait=wait)


def begin(stop: Stop, tell: Callable[[float], None] | None = None, alone: bool = False) -> None:
    """Begin a worker: remember where to look, whom to ``tell`` how far its task is, and whether it works
    ``alone``, so that it may use all threads."""
    _here.stop, _here.tell, _here.alone = stop, tell, alone


def works_alone() -> bool:
    """Whether no other worker has the other processors."""
    return getattr(_here, "alone", False)


def begin_process(stop: Stop) -> None:
    """Begin a worker that is a process."""
    begin(stop)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")
    threading.Thread(target=_end_with_parent, daemon=True).start()


def look_for_stop(stage: str, fraction: float) -> None:
    """Raise Cancelled where the crew is told to stop; else tell whoever wants to hear the progress of a
    worker."""
    stop, tell = getattr(_here, "stop", None), getattr(_here, "tell", None)
    if stop is not None and stop.is_set():
        raise Cancelled(say("stopped"))
    if tell is not None:
        tell(fraction)


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
