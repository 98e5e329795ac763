# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a batch gains by a second process, as a ratio in the same run, and what it costs a job beside doing it here.

Run: ``python benchmarks/bench_batch.py [jobs]``. The target: on two idle processors at least 1.6 times as fast by two as by one.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

from timing import print_table

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from freecad_fiveaxis.core.batch.task import BatchJob

ROOT = Path(__file__).parents[1]

WAY = {"machine": "trunnion_ac", "passes": "planes", "tool_axis": "facet_mean", "stepover": 0.5}
TARGET = 1.6
ROUNDS = 3


def seconds(folder: str, workers: int) -> float:
    """Of all jobs of a folder, by processes that have each done one before; 0: here."""
    from freecad_fiveaxis.core.batch import plan
    from freecad_fiveaxis.core.batch.crews import process_crew

    with tempfile.TemporaryDirectory() as out, tempfile.TemporaryDirectory() as warm:
        jobs = plan.read_jobs(folder, WAY, out)
        if not workers:
            return timed(jobs, None)
        with process_crew(workers).open() as pool:
            while len({one.result() for one in [pool.submit(os.getpid) for _ in range(50)]}) < workers:
                pass  # one of them is still beginning
            timed(plan.read_jobs(folder, WAY, warm)[:workers], pool)
            return timed(jobs, pool)


def timed(jobs: list[BatchJob], pool: Executor | None) -> float:
    """The seconds of a batch in which no job fails."""
    from freecad_fiveaxis.core.batch.run import run_batch

    start = time.perf_counter()
    if any(outcome.error for outcome in run_batch(jobs, pool)):
        sys.exit("a job failed")
    return time.perf_counter() - start


def main(count: int = 6) -> float:
    """Print the table; returns how many times as fast two processes are as one."""
    sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "core")]
    from roofs import write_roof

    with tempfile.TemporaryDirectory() as folder:
        for number in range(count):
            write_roof(Path(folder) / f"part{number}.stl", 16.0 + number / 10)
        seconds(folder, 0)
        rounds = [[seconds(folder, workers) for workers in (0, 1, 2)] for _ in range(ROUNDS)]
    here, one, two = (min(taken) for taken in zip(*rounds, strict=True))
    ratio = one / two
    rows = [(name, f"{took:.2f}", f"{took / count:.3f}") for name, took in (("here", here), ("1", one), ("2", two))]
    print_table(f"batch of {count} jobs, the quickest of {ROUNDS} rounds", ("processes", "s", "s a job"), rows)
    print(f"  two processes are {ratio:.2f} times as fast as one; in one a job takes {one / here:.2f} times what it takes here")
    print(f"  way of a job to a process and back: {1e3 * overhead():.2f} ms")
    enough = (os.cpu_count() or 1) >= 2
    print(f"  target {TARGET}: {'reached' if ratio >= TARGET else 'MISSED' if enough else 'needs two processors'}")
    return ratio


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
