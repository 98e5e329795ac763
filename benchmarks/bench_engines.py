# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a task costs beside its work on each engine, and what that means for up to ten thousand workers:
docs/scale.md.

Run: ``python benchmarks/bench_engines.py [tasks]``. Measured with two workers, the engines in turns; what is
not installed is left out. Then simulated: a queue that one process keeps, and that spends the measured time
on each task.
"""

from __future__ import annotations

import os
import pickle
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor, Future
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import print_table
from freecad_fiveaxis.core.base.crew import at_work, process_crew
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.spread import spread
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.studies import study

ROUNDS = 5
MEGABYTE = 1_000_000
WORKERS = (1, 2, 8, 64, 512, 1_000, 10_000)
SECONDS = (0.1, 1.0, 10.0, 60.0)
"""s of a task."""
TASKS_EACH = 10
"""Tasks for each worker that are simulated."""
UNEVEN = 0.3
"""Standard deviation of the logarithm of a task's time."""
STUDIES = {
    "setup": {
        "passes": "planes",
        "tool_axis": "facet_mean",
        "stepover": 4.0,
        "region": (40, 40, 20),
        "grid": (3, 3, 3),
    },
    "compare": {
        "passes": "planes",
        "tool_axis": "facet_mean",
        "stepover": 20.0,
        "machines": "trunnion_ac,mikron_ucp710",
    },
    "reach": {"holder": ((40.0, 30.0),), "tool_length": 120.0},
}


def nothing(common: bytes, task: int, progress: Progress) -> int:
    """Return a task that costs nothing."""
    return task


@contextmanager
def dask_executor() -> Iterator[Executor]:
    """Of a scheduler on this computer. Raises ImportError."""
    import distributed

    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client.get_executor()


def loky_executor() -> Any:
    """Raise ImportError."""
    import loky

    return loky.ProcessPoolExecutor(2)


ENGINES: Mapping[str, Callable[[], Any]] = {
    "processes": lambda: at_work(process_crew(2)),
    "loky": loky_executor,
    "dask": dask_executor,
}


def measured(tasks: int) -> dict[str, tuple[float, float, float]]:
    """Of each engine that is here: s a task, more s a megabyte that goes with each task, and s from a task's
    submission to its result where nothing else is at work. Medians of ROUNDS, the engines in turns."""
    with ExitStack() as stack:
        pools = {}
        for name, make in ENGINES.items():
            try:
                pools[name] = stack.enter_context(make())
            except ImportError:
                print(f"  {name} is not installed")
        for pool in pools.values():
            spread(nothing, b"", range(50), pool, silent, "")
        rounds = [{name: _once(pool, tasks) for name, pool in pools.items()} for _ in range(ROUNDS)]
    return {name: tuple(np.median([one[name] for one in rounds], axis=0)) for name in rounds[0]}  # type: ignore[misc]


def _once(pool: Executor, tasks: int) -> tuple[float, float, float]:
    each = _seconds(pool, b"", tasks) / tasks
    heavy = _seconds(pool, os.urandom(MEGABYTE), tasks // 4) / (tasks // 4)
    start = time.perf_counter()
    for _ in range(20):
        pool.submit(abs, -1).result()
    return each, max(heavy - each, 0.0), (time.perf_counter() - start) / 20


def _seconds(pool: Executor, common: bytes, tasks: int) -> float:
    start = time.perf_counter()
    spread(nothing, common, range(tasks), pool, silent, "")
    return time.perf_counter() - start


class Weighing(Executor):
    """Does each task here, and weighs what would go to a worker and come back, bytes."""

    def __init__(self) -> None:
        self.tasks, self.results, self.seconds = list[int](), list[int](), list[float]()

    def submit(self, work: Any, /, *given: Any, **named: Any) -> Future[Any]:
        """Do it."""
        start = time.perf_counter()
        result = work(*given, **named)
        self.seconds.append(time.perf_counter() - start)
        self.tasks.append(len(pickle.dumps((work, given, named))))
        self.results.append(len(pickle.dumps(result)))
        future = Future[Any]()
        future.set_result(result)
        return future


def weigh(facets: int = 1_000) -> None:
    """Print what a task of each study weighs."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        part = str(Path(folder) / "part.stl")
        write_stl(bumpy(facets), part)
        for task, more in STUDIES.items():
            scale = Weighing()
            machine = {} if task == "compare" else {"machine": "trunnion_ac"}
            study.run(build_settings(task, part, machine | {"cutter": "ball:6"} | more), executor=scale)
            middle = (f"{np.median(one):,.0f}" for one in (scale.tasks, scale.results))
            rows.append([task, len(scale.tasks), *middle, f"{np.median(scale.seconds):.3f}"])
    print_table(
        f"tasks of studies of {facets:,} facets, medians",
        ("study", "tasks", "bytes there", "and back", "s a task"),
        rows,
    )


def speed_up(workers: int, seconds: float, cost: float, delay: float, uneven: float = UNEVEN) -> float:
    """How many times as fast so many workers are as one without a queue. ``seconds`` of a task in the mean,
    ``cost`` s that the queue spends on each task, one after the other; ``delay`` s on the way to a worker and
    back.

    Each worker does TASKS_EACH tasks: who is free first gets the next, no sooner than the queue has come to
    it.
    """
    rng, free, last = np.random.default_rng(workers), np.zeros(workers), 0.0
    place = np.arange(1, workers + 1)
    work = seconds * np.exp(rng.normal(-0.5 * uneven**2, uneven, (TASKS_EACH, workers)))
    for took in work:
        free.sort()
        given = last + _queued(free - last, cost, place)
        last = float(given[-1])
        free = given + delay + took
    return float(work.sum() / free.max())


def _queued(wanted: Any, cost: float, place: Any) -> Any:
    """When a queue that spends ``cost`` s on each is done with what is ``wanted`` (w,) at these times, in
    their order."""
    ready = np.maximum(wanted, 0.0) - cost * (place - 1)
    return np.maximum.accumulate(ready) + cost * place


def least_seconds(workers: int, cost: float, delay: float, share: float = 0.9) -> float:
    """s that a task has to take, all alike, for so many workers to be worth that share of them."""
    low, high = 1e-6, 1e6
    while high / low > 1.01:
        middle = (low * high) ** 0.5
        low, high = (
            (low, middle)
            if speed_up(workers, middle, cost, delay, 0.0) >= share * workers
            else (middle, high)
        )
    return high


def _row(workers: int, cost: float, delay: float) -> list[str]:
    ups = [f"{speed_up(workers, seconds, cost, delay):,.1f}" for seconds in SECONDS]
    return [f"{workers:,}", *ups, f"{least_seconds(workers, cost, delay):.2g}"]


def main(tasks: int = 400) -> None:
    """Print all tables."""
    found = measured(tasks)
    rows = [
        (name, *(f"{1e3 * one:.2f}" for one in found[name]), f"{1.0 / found[name][0]:,.0f}") for name in found
    ]
    print_table(
        "two workers, ms", ("engine", "a task", "and a MB with it", "alone, there and back", "tasks/s"), rows
    )
    weigh()
    for name, (cost, _, delay) in found.items():
        table = [_row(workers, cost, delay) for workers in WORKERS]
        heads = ("workers", *(f"{s:g} s" for s in SECONDS), "s a task for 90 %")
        print_table(f"{name}: times as fast as one worker, by the length of a task", heads, table)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
