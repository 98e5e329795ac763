# SPDX-License-Identifier: LGPL-2.1-or-later
"""The executors that the command line knows, and what a worker does before and while it works.

Processes are begun anew (spawn), never forked: a copy of threads and locks that are in use is no beginning. They leave
Ctrl-C to the process that began them, which tells them to stop; and they end where that has ended.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from typing import Any, Protocol

from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.base.sentences import say

from .task import BatchJob, JobOutcome

SERIAL, THREADS, PROCESSES, MPI, DASK = "serial", "threads", "processes", "mpi", "dask://"
MOST_ON_WINDOWS = 61
"""Processes: Windows waits for no more."""
ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""What libraries below numpy read when they are loaded."""

_here = threading.local()


class Stop(Protocol):
    """An event of threads or of processes."""

    def set(self) -> None: ...

    def is_set(self) -> bool: ...


class Crew:
    """How an executor is made. ``make``: of so many workers; None instead of a crew: one job after the other, here."""

    def __init__(self, make: Callable[[int], Executor], workers: int, stop: Stop) -> None:
        self._make, self._workers, self._stop = make, workers, stop

    def open(self, workers: int | None = None) -> Executor:
        """A new executor, of so many workers or of all."""
        return self._make(workers or self._workers)

    def stop(self) -> None:
        """Tell the workers to leave what they are at."""
        self._stop.set()


def find_crew(name: str, workers: int) -> Crew | None:
    """The crew of that name. Raises SettingsError where there is none of it, or its package is missing."""
    if name == SERIAL:
        return None
    if name == THREADS:
        return thread_crew(workers)
    if name == PROCESSES:
        return process_crew(workers)
    if name == MPI:
        futures = _package("mpi4py.futures", "mpi4py")
        return Crew(lambda number: _executor(futures.MPIPoolExecutor(number)), workers, threading.Event())
    if name.startswith(DASK) and name != DASK:
        distributed = _package("distributed", '"dask[distributed]"')
        return Crew(lambda number: _dask(distributed, name.removeprefix(DASK)), workers, threading.Event())
    known = f"{PROCESSES}, {THREADS}, {SERIAL}, {DASK}HOST:PORT, {MPI}"
    raise SettingsError(say("unknown executor {name}; known: {known}", name=repr(name), known=known), name)


def thread_crew(workers: int) -> Crew:
    """Threads of this process."""
    stop = threading.Event()
    return Crew(lambda number: ThreadPoolExecutor(number, initializer=begin, initargs=(stop,)), workers, stop)


def process_crew(workers: int) -> Crew:
    """Processes of this computer."""
    context = multiprocessing.get_context("spawn")
    stop = context.Event()
    workers = min(workers, MOST_ON_WINDOWS) if sys.platform == "win32" else workers
    return Crew(lambda number: ProcessPoolExecutor(number, context, begin_process, (stop,)), workers, stop)


def work_in_crew(job: BatchJob) -> JobOutcome:
    """Do a job in a worker, which stops where its crew is told to. Raises Cancelled."""
    from .work import run_in_worker

    return run_in_worker(job, _look_for_stop)


def begin(stop: Stop) -> None:
    """What a worker of a crew does first: it remembers where to look."""
    _here.stop = stop


def begin_process(stop: Stop) -> None:
    """The same of a worker that is a process."""
    begin(stop)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for name in ONE_THREAD:
        os.environ.setdefault(name, "1")
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _look_for_stop(stage: str, fraction: float) -> None:
    stop = getattr(_here, "stop", None)
    if stop is not None and stop.is_set():
        raise Cancelled(say("stopped"))


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _package(module: str, pip: str) -> Any:
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        missing = say("this executor needs a package that is not installed: {install}", install=f"`pip install {pip}`")
        raise SettingsError(missing, module) from error


def _executor(made: Any) -> Executor:
    """An executor of another package, which we take at its word."""
    kept: Executor = made
    return kept


def _dask(distributed: Any, address: str) -> Executor:
    try:
        return _executor(distributed.Client(f"tcp://{address}").get_executor())
    except (OSError, ValueError) as error:
        raise SettingsError(
            say("no dask scheduler answers at {address}: {error}; start one, or name another", address=address, error=error),
            address,
        ) from error
