# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a batch gains by a second process, as a ratio in the same run, and what it costs a job beside doing it
here.

Run: ``python benchmarks/bench_batch.py [jobs]``; half a minute for 64. The targets: on two idle processors at
least 1.8 times as fast by two processes as by one, and no more than 20 ms a job beyond the job.

The jobs are small, and their pages left blank, which are nearly all that they take: what is spent beside them
shows the more. They are done in turns: some here, the same by one process, the same by two, then the next
ones. Beside the seconds on the wall stand those of the processor, this process's and its workers', which
other work on the computer changes less.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from timing import print_table

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from freecad_fiveaxis.core.batch.task import BatchJob

ROOT = Path(__file__).parents[1]

WAY = {
    "machine": "trunnion_ac",
    "passes": "planes",
    "tool_axis": "facet_mean",
    "stepover": 9,
    "gouge": "off",
    "tolerance": 10,
}
RATIO = 1.8
OVERHEAD = 0.020
"""s a job."""
TURN = 8
"""Jobs that are done before another has its turn."""
WAYS = ("here", "one process", "two")


def spent() -> tuple[int, float]:
    """Return this process and the s of a processor that it has taken."""
    return os.getpid(), time.process_time()


def of_workers(pool: Executor | None, workers: int) -> dict[int, float]:
    """s of a processor that each worker has taken, all of which have begun."""
    reported = dict[int, float]()
    while pool is not None and len(reported) < workers:
        reported |= dict(future.result() for future in [pool.submit(spent) for _ in range(20)])
    return reported


def timed(jobs: Sequence[BatchJob], pool: Executor | None, workers: int) -> tuple[float, float]:
    """s on the wall and s of all processors of a batch in which no job fails."""
    from contextlib import nullcontext

    from roofs import Instead, blank_pages, work_with_blank_pages

    from freecad_fiveaxis.core.batch.run import run_batch

    wanted = None if pool is None else Instead(pool, work_with_blank_pages)
    before, mine, start = of_workers(pool, workers), time.process_time(), time.perf_counter()
    with blank_pages() if pool is None else nullcontext():
        if any(outcome.error for outcome in run_batch(jobs, wanted)):
            sys.exit("a job failed")
    wall, own, after = time.perf_counter() - start, time.process_time() - mine, of_workers(pool, workers)
    return wall, own + sum(after[worker] - before[worker] for worker in before)


@contextmanager
def pools(warm: Sequence[Sequence[BatchJob]]) -> Iterator[list[Executor | None]]:
    """None, one process and two, which have each done a job before, as has this one."""
    from freecad_fiveaxis.core.batch.crews import process_crew

    with process_crew(1).open() as one, process_crew(2).open() as two:
        for jobs, (workers, pool) in zip(warm, enumerate((None, one, two)), strict=True):
            timed(jobs[: max(workers, 1)], pool, workers)
        yield [None, one, two]


def jobs_in(folder: str, out: str) -> list[list[BatchJob]]:
    """Return the same jobs for each way, each into a folder of its own."""
    from freecad_fiveaxis.core.batch import plan

    result = [os.path.join(out, str(way)) for way in range(len(WAYS))]
    for path in result:
        os.makedirs(path)
    return [plan.read_jobs(folder, WAY, path) for path in result]


def main(count: int = 64) -> float:
    """Print the table; returns how many times as fast two processes are as one."""
    sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "core")]
    from roofs import write_roof

    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as out:
        for number in range(count):
            write_roof(Path(folder) / f"part{number:03}.stl", 16.0 + number / 50)
        jobs = jobs_in(folder, os.path.join(out, "made"))
        with pools(jobs_in(folder, os.path.join(out, "warm"))) as result:
            turns = [
                [
                    timed(own[at : at + TURN], pool, way)
                    for way, (own, pool) in enumerate(zip(jobs, result, strict=True))
                ]
                for at in range(0, count, TURN)
            ]
    return show(np.array(turns), count)


def show(turns: np.ndarray, count: int) -> float:
    """Print what was measured: ``turns`` (turns, ways, 2) s on the wall and of the processor."""
    wall, work = turns.sum(axis=0).T
    rows = [
        (name, f"{wall[way]:.1f}", *(f"{1e3 * one[way] / count:.0f}" for one in (wall, work)))
        for way, name in enumerate(WAYS)
    ]
    print_table(f"batch of {count} jobs", ("done", "s", "ms a job", "ms of processors a job"), rows)
    ratio, each = wall[1] / wall[2], turns[:, 1, 0] / turns[:, 2, 0]
    more = (turns[:, 1] - turns[:, 0]) / TURN * 1e3
    print(
        f"  two processes are {ratio:.2f} times as fast as one ({np.min(each):.2f} to {np.max(each):.2f} in "
        "its turns)"
    )
    print(
        "  a job in one process takes {:+.0f} ms more than here, {:+.0f} ms of processors (medians)".format(
            *np.median(more, axis=0)
        )
    )
    print(f"  way of a task to a process and back: {1e3 * overhead():.2f} ms")
    enough = (os.cpu_count() or 1) >= 2
    print(
        f"  target {RATIO}: {'reached' if ratio >= RATIO else 'MISSED' if enough else 'needs two processors'}"
    )
    print(
        f"  target {1e3 * OVERHEAD:.0f} ms: "
        f"{'reached' if np.median(more[:, 0]) <= 1e3 * OVERHEAD else 'MISSED'}"
    )
    return float(ratio)


def overhead(count: int = 500) -> float:
    """s that a task takes which does nothing."""
    from freecad_fiveaxis.core.batch.crews import process_crew

    with process_crew(1).open() as pool:
        pool.submit(os.getpid).result()
        start = time.perf_counter()
        for future in [pool.submit(os.getpid) for _ in range(count)]:
            future.result()
        return (time.perf_counter() - start) / count


if __name__ == "__main__":
    main(*(int(argument) for argument in sys.argv[1:]))
