# SPDX-License-Identifier: LGPL-2.1-or-later
"""The engines that the same work is given to, and who has them: of other packages, what is not installed is
skipped.

apart     an engine whose workers are other processes: they see nothing of what a test patches here.
"""

import concurrent.futures
import os
import shutil
import subprocess
import sys
from concurrent.futures import Executor
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from functools import cache

import pytest
from roofs import Inline

from freecad_fiveaxis.core.base import crew, workers

SPAWN = "from mpi4py.futures import MPIPoolExecutor as P; p = P(1); print(p.submit(abs, -3).result()); p.shutdown()"
"""What MPI has to be able to do: begin a process beside one that was begun without it."""


@dataclass(frozen=True)
class Engine:
    """``executor``: None where the work is done here, one task after the other."""

    name: str
    executor: Executor | None
    apart: bool


@contextmanager
def processes():
    with crew.at_work(crew.process_crew(2)) as pool:
        yield pool


@contextmanager
def plain_processes():
    """Those of FreeCAD's window, and some of the work in this process."""
    serving = workers.Command((sys.executable, "-c", workers.python_code("serve")))
    with workers.WorkerProcesses(lambda: serving, 2, 0.0) as pool:
        yield pool
        assert pool.died == 0


@contextmanager
def loky():
    with pytest.importorskip("loky").ProcessPoolExecutor(2) as pool:
        yield pool


@contextmanager
def dask():
    with dask_client() as client:
        yield client.get_executor()


UNWATCHED = {
    "distributed.worker.profile.enabled": False,
    "distributed.worker.memory.monitor-interval": "10s",
    "distributed.admin.system-monitor.interval": "10s",
    "distributed.admin.tick.interval": "5s",
}
"""How seldom dask looks at itself, which nobody reads here: a tenth of a processor goes into it otherwise."""


@contextmanager
def dask_client(workers=2):
    """A client of a scheduler in this process with so many workers; where one is killed, dask begins
    another."""
    distributed = pytest.importorskip("distributed")
    import dask

    with (
        dask.config.set(UNWATCHED),
        distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@contextmanager
def mpi():
    pytest.importorskip("mpi4py")
    with pytest.MonkeyPatch.context() as patch:
        for name, value in mpi_environment().items():
            patch.setenv(name, value)
        from mpi4py.futures import MPIPoolExecutor

        with MPIPoolExecutor(2, path=list(sys.path)) as pool:
            yield pool


def mpi_environment():
    """The environment in which MPI begins processes. Skips where it cannot: it would take this process
    along."""
    pytest.importorskip("mpi4py")
    more, problem = _try_mpi()
    if problem:
        pytest.skip(problem)
    return more


@cache
def _try_mpi():
    """The environment, and why MPI begins no processes in it."""
    beside = os.path.dirname(sys.executable)
    more = {
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
    }
    more["PATH"] = beside + os.pathsep + os.environ.get("PATH", "")
    if shutil.which("mpiexec", path=more["PATH"]) is None:
        return more, "no mpiexec here"
    try:
        tried = subprocess.run(
            [sys.executable, "-c", SPAWN], env=os.environ | more, capture_output=True, timeout=120, text=True
        )
        message = tried.stdout.strip()
    except subprocess.TimeoutExpired:
        message = "it hangs"
    works = message == "3"
    return more, "" if works else "this MPI begins no processes beside one that was begun without it"


OPEN = {
    "serial": nullcontext,
    "inline": Inline,
    "threads": lambda: crew.at_work(crew.thread_crew(2)),
    "foreign threads": lambda: concurrent.futures.ThreadPoolExecutor(2),
    "processes": processes,
    "plain processes": plain_processes,
    "loky": loky,
    "dask": dask,
    "mpi": mpi,
}
APART = ("processes", "loky", "dask", "mpi")
SHARED = ("processes", "loky", "dask")
"""Those of which one crew serves all tests of a file."""
ONCE_MORE = ("serial", "inline", "foreign threads", "plain processes")
"""Those that show the same as others."""
OF_OTHERS = ("loky", "dask", "mpi")
"""Of packages that this one does not need: the slow ring installs them."""


def _marked(name):
    marks = [pytest.mark.slow] * (name in OF_OTHERS) + [pytest.mark.thorough] * (name in ONCE_MORE)
    return pytest.param(name, marks=marks)


ENGINES = [_marked(name) for name in OPEN]
