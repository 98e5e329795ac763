# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many jobs on one executor: none lost, none twice, and the order in which they end changes nothing of what
they write.

A process that dies (memory that ran out) breaks its pool, and takes along the jobs of the others. All that
have not ended run again in a new pool; where that breaks too, each of them alone, so that only the one to
blame fails.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait

from freecad_fiveaxis.core.base.crew import WORKERS, end_pool
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say

from .crews import work_in_crew
from .task import BatchJob, JobOutcome

TICK = 0.2
"""s between two calls of progress while no job ends."""
STAGE = "batch"

Again = Callable[[int | None], Executor]
"""A new executor of so many workers; None: as many as the first."""


def run_batch(
    jobs: Sequence[BatchJob],
    executor: Executor | None = None,
    progress: Progress = silent,
    again: Again | None = None,
) -> Iterator[JobOutcome]:
    """Yield the outcome of each job as it ends. ``executor`` None: one after the other, here. ``again``:
    makes a new executor where processes died; without it their jobs fail.

    Whatever progress raises, Ctrl-C, or closing the iterator cancels the jobs that have not begun. Raises
    SettingsError where an executor gives back anything but the job's own outcome.
    """
    done = _Done(len(jobs), progress)
    if executor is None:
        yield from _here(jobs, done)
        return
    left = yield from _in_pool(jobs, executor, done)
    if left and again is not None:
        left = yield from _in_new_pool(left, again, None, done)
        for job in left if len(left) > 1 else ():
            yield from _fail((yield from _in_new_pool([job], again, 1, done)), done)
        left = left if len(left) == 1 else []
    yield from _fail(left, done)


class _Done:
    """How many jobs have ended, told to progress."""

    def __init__(self, number: int, progress: Progress) -> None:
        self.number, self.progress, self.ended = number, progress, 0

    def tell(self, more: int = 0) -> None:
        self.ended += more
        self.progress(STAGE, self.ended / max(self.number, 1))


def _here(jobs: Sequence[BatchJob], done: _Done) -> Iterator[JobOutcome]:
    from .work import run_one

    for job in jobs:
        done.tell()
        yield run_one(job, lambda stage, fraction: done.tell())
        done.ended += 1
    done.tell()


def _in_pool(
    jobs: Sequence[BatchJob], executor: Executor, done: _Done
) -> Generator[JobOutcome, None, list[BatchJob]]:  # fmt: skip
    """Yield the outcomes; return the jobs whose processes died, or that the executor gave up."""
    todo, lost = dict[Future[JobOutcome], BatchJob](), list[BatchJob]()
    try:
        for job in jobs:
            try:
                todo[executor.submit(work_in_crew, job)] = job
            except BrokenExecutor:
                lost.append(job)
        while todo:
            ended, _ = wait(todo, TICK, FIRST_COMPLETED)
            for future in ended:
                job = todo.pop(future)
                outcome = _outcome(future, job)
                if outcome is None:
                    lost.append(job)
                else:
                    done.ended += 1
                    yield outcome
            done.tell()
    finally:
        for future in todo:
            future.cancel()
    return sorted(lost, key=jobs.index)


def _outcome(future: Future[JobOutcome], job: BatchJob) -> JobOutcome | None:
    """Return what came of a job; None where its process died. Raises SettingsError for what is not its
    own."""
    from .work import fail_job

    try:
        outcome = future.result()
    except (BrokenExecutor, CancelledError):
        return None
    except Cancelled:
        raise
    except Exception as error:  # of the executor: what the job itself raises is an outcome
        return fail_job(job, error)
    if not isinstance(outcome, JobOutcome) or outcome.stem != job.stem:
        given = outcome.stem if isinstance(outcome, JobOutcome) else type(outcome).__name__
        raise SettingsError(
            say(
                "the executor gave back {given} for the job {job}; choose another one",
                given=given,
                job=job.stem,
            ),
            given,
        )
    return outcome


def _in_new_pool(
    jobs: Sequence[BatchJob], again: Again, workers: int | None, done: _Done
) -> Generator[JobOutcome, None, list[BatchJob]]:
    pool = again(workers)
    try:
        return (yield from _in_pool(jobs, pool, done))
    finally:
        end_pool(pool, wait=False)


def _fail(jobs: Sequence[BatchJob], done: _Done) -> Iterator[JobOutcome]:
    from .work import fail_job

    for job in jobs:
        done.ended += 1
        yield fail_job(
            job,
            say(
                "its process died, as when memory runs out; give fewer {workers}, or a coarser part",
                workers=WORKERS,
            ),
        )
