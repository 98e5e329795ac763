# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spread the tasks of one job over the workers of an executor: whoever does which, and in whatever order they
end, the results are the same and in the same order.

task      a small frozen value that pickles; what is done with it is a function of a module, which processes
          find by its name.
common    what all tasks of a job share, as a path: pickled once, and made again once in each process
          (:mod:`.shared`).
weight    how long a task takes, in any unit: for the progress only.

A worker keeps to one thread, for the others have the other processors. Tasks that were not begun are
cancelled where the work is stopped. Those that run hear of it at their next step in threads of any pool; in
processes where they are those of a :class:`~freecad_fiveaxis.core.base.crew.Crew` that is told to stop, as in
:func:`~freecad_fiveaxis.core.base.crew.at_work`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future
from contextlib import nullcontext
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from typing import Any, Generic, TypeVar

from .chunks import keep_to_one_thread
from .crew import WORKERS, look_for_stop, works_alone
from .errors import Cancelled, SettingsError
from .progress import Progress
from .sentences import say
from .shared import Lost, Shared

C = TypeVar("C")
T = TypeVar("T")
R = TypeVar("R")

KILLED = ("KilledWorker",)
"""Exceptions, of packages that we do not import, by which an executor says that its workers died: dask's."""
TICK = 0.1
"""s between two calls of progress while no task ends."""

Work = Callable[[C, T, Progress], R]
"""From what is common, a task, and the progress to tell, whose fraction is that of the task."""


def spread(
    work: Work[C, T, R], common: C, tasks: Sequence[T], executor: Executor | None, progress: Progress,
    stage: str,
    weights: Sequence[float] = (),
) -> list[R]:  # fmt: skip
    """Return what ``work`` gives for each task, in their order. ``executor`` None: one after the other, here,
    with all threads.

    ``progress`` gets ``stage`` and the share that is done, by ``weights`` (none: all alike). Raises what a
    task or progress raises, and SettingsError where the executor gives back anything but a task's own result
    or its workers die.
    """
    overall = _TaskProgress(progress, stage, weights or [1.0] * len(tasks))
    overall(0.0)
    if executor is None:
        return [overall.end(at, work(common, task, overall.within(at))) for at, task in enumerate(tasks)]
    results: dict[int, R] = {}
    shared = Shared(common)
    given = _Given(executor, work, shared, tasks)
    try:
        for at in range(len(tasks)):
            given.submit(at)
            overall(0.0)
        while given.todo:
            future = given.next_ended()
            if future is None:
                overall.hear(given.todo)
                continue
            result = _own_result(future, at := given.todo.pop(future))
            if isinstance(result, Lost):
                shared.send_bytes()
                given.submit(at)
            else:
                results[at] = overall.end(at, result)
    finally:
        shared.stopped = bool(given.todo)
        shared.close()
        given.cancel()
    return [results[at] for at in range(len(tasks))]


class _Given(Generic[C, T, R]):
    """What an executor is to do; ``todo``: the tasks' places by the futures of those that have not been
    looked at."""

    def __init__(
        self, executor: Executor, work: Work[C, T, R], shared: Shared[C], tasks: Sequence[T]
    ) -> None:
        self.todo = dict[Future[Any], int]()
        self._executor, self._work, self._shared, self._tasks = executor, work, shared, tasks
        self._ended = SimpleQueue[Future[Any]]()

    def submit(self, at: int) -> None:
        """Give it a task. Raises SettingsError where its workers have died."""
        try:
            future = self._executor.submit(_do, self._work, self._shared, at, self._tasks[at])
        except BrokenExecutor as error:
            raise _explain_death() from error
        self.todo[future] = at
        future.add_done_callback(self._ended.put)

    def next_ended(self) -> Future[Any] | None:
        """One that has ended; None where none does for a while."""
        try:
            return self._ended.get(timeout=TICK)
        except Empty:
            return None

    def cancel(self) -> None:
        """Cancel what has not begun."""
        for future in self.todo:
            future.cancel()


class _TaskProgress:
    """How much is done, told to progress."""

    def __init__(self, progress: Progress, stage: str, weights: Sequence[float]) -> None:
        self._progress, self._stage, self._weights = progress, stage, weights
        self._all, self._done, self._reported = sum(weights), 0.0, 0.0

    def __call__(self, more: float) -> None:
        self._reported = max(self._reported, min((self._done + more) / self._all, 1.0) if self._all else 1.0)
        self._progress(self._stage, self._reported)

    def hear(self, todo: Mapping[Future[Any], int]) -> None:
        """Tell how far the tasks are that have not ended, as far as their futures know it."""
        self(sum(self._weights[at] * getattr(future, "fraction", 0.0) for future, at in todo.items()))

    def within(self, at: int) -> Progress:
        """Return the progress of one task as that of the whole."""
        return lambda stage, fraction: self(self._weights[at] * fraction)

    def end(self, at: int, result: R) -> R:
        """Return the result, told."""
        self._done += self._weights[at]
        self(0.0)
        return result


@dataclass(frozen=True)
class _Result(Generic[R]):
    """``at``: the task's place among all."""

    at: int
    result: R


def _do(work: Work[C, T, R], shared: Shared[C] | Lost, at: int, task: T) -> _Result[R | Lost]:
    """Return what a worker does; it answers Lost where what is common has not come to it."""
    if isinstance(shared, Lost):
        return _Result(at, shared)

    def listen(stage: str, fraction: float) -> None:
        look_for_stop(stage, fraction)
        if shared.stopped:
            raise Cancelled(say("stopped"))

    with nullcontext() if works_alone() else keep_to_one_thread():
        listen("", 0.0)
        return _Result(at, work(shared.value, task, listen))


def _own_result(future: Future[Any], at: int) -> Any:
    try:
        given = future.result()
    except (BrokenExecutor, CancelledError) as error:
        raise _explain_death() from error
    except Exception as error:
        if type(error).__name__ in KILLED:
            raise _explain_death() from error
        raise
    if not isinstance(given, _Result) or given.at != at:
        what = f"{given.at + 1}" if isinstance(given, _Result) else type(given).__name__
        raise SettingsError(
            say(
                "the executor gave back {given} for the job {job}; choose another one", given=what, job=at + 1
            ),
            what,
        )
    return given.result


def _explain_death() -> SettingsError:
    return SettingsError(
        say("a process died, as when memory runs out; give fewer {workers}", workers=WORKERS), None
    )
