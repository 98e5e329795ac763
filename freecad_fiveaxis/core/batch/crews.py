# SPDX-License-Identifier: LGPL-2.1-or-later
"""The executors that the command line knows, and what their workers do with a job."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any, TypeVar

from freecad_fiveaxis.core.base.crew import Crew, look_for_stop, process_crew, thread_crew
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.base.terminal import complain

from .task import BatchJob, JobOutcome

T = TypeVar("T")
SERIAL, THREADS, PROCESSES, MPI, DASK = "serial", "threads", "processes", "mpi", "dask://"


def find_crew(name: str, workers: int) -> Crew | None:
    """Return the crew of that name; None: one job after the other, here. Raises SettingsError where there is
    none of it, or its package is missing."""
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


def work_in_crew(job: BatchJob) -> JobOutcome:
    """Do a job in a worker, which stops where its crew is told to. Raises Cancelled."""
    from .work import run_in_worker

    return run_in_worker(job, look_for_stop)


def _package(module: str, pip: str) -> Any:
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        missing = say(
            "this executor needs a package that is not installed: {install}", install=f"`pip install {pip}`"
        )
        raise SettingsError(missing, module) from error


def _executor(executor: Any) -> Executor:
    """Return an executor of another package, which we take at its word."""
    kept: Executor = executor
    return kept


def _dask(distributed: Any, address: str) -> Executor:
    try:
        client = distributed.Client(f"tcp://{address}")
    except (OSError, ValueError) as error:
        raise SettingsError(
            say(
                "no dask scheduler answers at {address}: {error}; start one, or name another",
                address=address,
                error=error,
            ),
            address,
        ) from error
    if not client.scheduler_info()["workers"]:  # one that begins workers on demand has none either
        complain(
            f"fiveaxis: the dask scheduler at {address} has no worker yet, and the jobs wait for one: "
            f"`dask worker {address}` starts one"
        )
    return DaskExecutor(client)


class DaskExecutor(Executor):
    """The workers of a dask client; the client's connection ends with the executor."""

    def __init__(self, client: Any) -> None:
        self.client, self.workers = client, client.get_executor()

    def submit(self, fn: Callable[..., T], /, *args: Any, **kwargs: Any) -> Future[T]:
        """Give the workers a task."""
        future: Future[T] = self.workers.submit(fn, *args, **kwargs)
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the connection, after all tasks or, unless ``wait``, at once; who gave them cancels them."""
        self.workers.shutdown(wait=wait)
        self.client.close()
