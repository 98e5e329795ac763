# SPDX-License-Identifier: LGPL-2.1-or-later
"""An executor for programs that Python lives in, as FreeCAD: its workers are Pythons that it starts by
themselves.

multiprocessing would not do there. It starts ``sys.executable``, which is FreeCAD with its window; to name
another program (``set_executable``) is to name it for every add-on of the same FreeCAD; each process imports
``__main__`` anew, which may be anybody's macro; and what it keeps beside its processes lives until FreeCAD
ends. Here a worker is a plain process with two pipes (:mod:`.worker`): the same on every system, nothing is
forked, nothing is shared with others, and it ends where we do.

here     this process. The first tasks are done here, so that short work never waits for a process; only work
         that lasts longer than a patience gets workers, no more than tasks are waiting. Once one of them is
         ready no other task is begun here.
died     a worker whose pipe ended before its answer. Its task is done here, and so is what its thread takes
         from then on.

Which task is done where changes no result, as long as the workers compute with the same versions
(``worker.identity``).
"""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import BrokenExecutor, Executor, Future
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any, Generic, ParamSpec, TypeVar

from . import crew
from .errors import Cancelled
from .sentences import say
from .worker import ERROR, FRACTION, MARK, receive, send

P = ParamSpec("P")
T = TypeVar("T")

PATIENCE = 2.0
"""s of work before workers are started: about what it takes until they pay (they are ready 0.5 to 1 s
later)."""
READY = 60.0
"""s that a process gets until it says that it is ready; what hangs is killed then."""
GREETING = 1 << 16
"""Bytes that a process may say before MARK."""


@dataclass(frozen=True)
class Command:
    """How a worker is started: ``words``, and what its environment has besides ours."""

    words: tuple[str, ...]
    environment: Mapping[str, str] = field(default_factory=dict)


def python_code(call: str) -> str:
    """Return what a worker's Python runs: ``call``, a function of :mod:`.worker`, of the package that is at
    work here, in a folder or a zip. No module is looked for where FreeCAD was started; numpy and scipy are
    found where ours are."""
    import numpy as np
    import scipy

    package, *engines = (
        str(Path(str(file)).parents[1]) for file in (_package_file(), np.__file__, scipy.__file__)
    )
    path = f"[{package!r}, *filter(None, sys.path), *{engines!r}]"
    return (
        f"import sys\nsys.path[:] = {path}\nfrom freecad_fiveaxis.core.base import worker\nworker.{call}()\n"
    )


def _package_file() -> str:
    import freecad_fiveaxis

    return str(freecad_fiveaxis.__file__)


def start(command: Command, code: str = "") -> subprocess.Popen[bytes]:
    """Return a process of that command, without a window, whose libraries keep to one thread. Raises
    OSError."""
    flags = 0
    if sys.platform == "win32":
        flags = subprocess.CREATE_NO_WINDOW
    environment = {**dict.fromkeys(crew.ONE_THREAD, "1"), **os.environ, **command.environment}
    pipe, nothing = subprocess.PIPE, subprocess.DEVNULL
    words = [*command.words, *([code] if code else [])]
    return subprocess.Popen(
        words, stdin=pipe, stdout=pipe, stderr=nothing, env=environment, creationflags=flags
    )


class TaskFuture(Future[T]):
    """``fraction`` of the task that is done, as far as its worker has said."""

    fraction = 0.0


@dataclass(frozen=True, eq=False)
class _Task(Generic[T]):
    future: TaskFuture[T]
    work: Callable[..., T]
    given: tuple[Any, ...]
    named: dict[str, Any]

    def do_here(self) -> None:
        try:
            self.future.set_result(self.work(*self.given, **self.named))
        except BaseException as error:
            self.future.set_exception(error)

    def pack(self) -> bytes | None:
        """None where it cannot go to another process."""
        try:
            return pickle.dumps((self.work, self.given, self.named), pickle.HIGHEST_PROTOCOL)
        except Exception:
            return None

    def tell(self, fraction: float) -> None:
        self.future.fraction = fraction


class _Worker:
    """A process at work. Raises EOFError or OSError where it does not get ready, or dies."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdin is not None and process.stdout is not None
        self._process, self._inward, self._outward = process, process.stdin, process.stdout

    def wait_until_ready(self) -> None:
        hangs = threading.Timer(READY, self._process.kill)
        hangs.daemon = True
        hangs.start()
        try:
            skip_greeting(self._outward)
        finally:
            hangs.cancel()

    def do(self, task: _Task[Any], packed: bytes) -> None:
        send(self._inward, packed)
        kind, answer = pickle.loads(receive(self._outward))
        while kind == FRACTION:
            task.tell(answer)
            kind, answer = pickle.loads(receive(self._outward))
        if kind == ERROR:
            task.future.set_exception(answer)
        else:
            task.future.set_result(answer)

    def kill(self) -> None:
        """End it at once."""
        self._process.kill()
        self._process.wait()

    def close(self) -> None:
        """End it; for the thread that speaks with it."""
        self.kill()
        for pipe in (self._inward, self._outward):
            with contextlib.suppress(OSError):  # what could not be sent any more
                pipe.close()


def _without_sigpipe(act: Callable[..., None], *given: Any) -> None:
    """Do something on a thread whose broken pipes are errors. FreeCAD 1.1 leaves this signal of POSIX as it
    is, so that one who writes to a worker that has died would take FreeCAD along."""
    if sys.platform != "win32":
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGPIPE})
    act(*given)


def skip_greeting(pipe: IO[bytes]) -> None:
    """Read up to MARK. Raises EOFError where that does not come."""
    seen = b""
    while not seen.endswith(MARK):
        byte = pipe.read(1)
        if not byte or len(seen) > GREETING:
            raise EOFError
        seen += byte


class WorkerProcesses(Executor):
    """See the module. ``find`` gives the command of a worker, or None: it is asked once, in a thread, when
    the patience is over. ``count``: the most processes at a time; ``patience`` s. ``ready`` and ``died``
    count workers. No program waits to end."""

    def __init__(self, find: Callable[[], Command | None], count: int, patience: float = PATIENCE) -> None:
        self.ready = self.died = 0
        self._find, self._count, self._due = find, count, time.monotonic() + patience
        self._changed, self._stop = threading.Condition(), threading.Event()
        self._tasks, self._workers = deque[_Task[Any]](), set[_Worker]()
        self._threads = list[threading.Thread]()
        self._hired = self._free = 0
        self._manned = self._closed = False

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> TaskFuture[T]:
        """See :class:`concurrent.futures.Executor`. The future tells its ``fraction``."""
        task = _Task(TaskFuture[T](), fn, args, kwargs)
        with self._changed:
            if self._closed:
                raise BrokenExecutor("no task is taken any more")
            self._tasks.append(task)
            if not self._threads:
                self._begin(self._work_here)
                self._begin(self._hire)
            self._changed.notify_all()
        return task.future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """See :class:`concurrent.futures.Executor`."""
        with self._changed:
            self._closed = True
            if cancel_futures:
                self._cancel_waiting()
            self._changed.notify_all()
        for thread in self._threads if wait else ():  # what the second one still begins is joined after it
            thread.join()

    def stop(self) -> None:
        """Leave everything at once: what waits is cancelled, every process has ended when this returns, and a
        task that is done here ends at its next word of progress."""
        self._stop.set()
        self.shutdown(wait=False, cancel_futures=True)
        with self._changed:
            workers = list(self._workers)
        for worker in workers:
            worker.kill()

    def _begin(self, act: Callable[..., None], *given: Any) -> None:
        thread = threading.Thread(
            target=_without_sigpipe, args=(act, *given), name="FiveAxisTasks", daemon=True
        )
        self._threads.append(thread)
        thread.start()

    def _cancel_waiting(self) -> None:
        while self._tasks:
            self._tasks.popleft().future.cancel()

    def _next(self, here: bool = False) -> _Task[Any] | None:
        """Return the next task for a thread that works ``here`` or has a worker; None where there is none to
        come for it."""
        with self._changed:
            while True:
                self._changed.wait_for(lambda: self._tasks or self._closed or (here and self._manned))
                if not self._tasks or (here and self._manned):
                    return None
                task = self._tasks.popleft()
                if task.future.set_running_or_notify_cancel():
                    return task

    def _work_here(self) -> None:
        crew.begin(self._stop, None, alone=True)
        while (task := self._next(here=True)) is not None:
            task.do_here()

    def _hire(self) -> None:
        with self._changed:
            if self._changed.wait_for(
                lambda: self._closed and not self._tasks, max(self._due - time.monotonic(), 0.0)
            ):
                return
        command = self._find_once()
        while True:
            with self._changed:
                self._changed.wait_for(
                    lambda: self._closed or (len(self._tasks) > self._free and self._hired < self._count)
                )
                if not self._tasks:
                    return
                if self._hired == self._count:
                    return
                self._hired, self._free = self._hired + 1, self._free + 1
                self._begin(self._employ, command)

    def _find_once(self) -> Command | None:
        with self._changed:
            self._changed.wait_for(lambda: self._tasks or self._closed)
            if not self._tasks:
                return None
        return self._find()

    def _employ(self, command: Command | None) -> None:
        """One worker, from its start to its end; where there is none any more this thread does its tasks
        here."""
        crew.begin(self._stop)
        worker = self._start_worker(command)
        with self._changed:
            self._manned = True
            self.ready += worker is not None
            self._changed.notify_all()
        while (task := self._next()) is not None:
            with self._changed:
                self._free -= 1
            worker = self._do(worker, task)
            with self._changed:
                self._free += 1
        if worker is not None:
            self._dismiss(worker)

    def _start_worker(self, command: Command | None) -> _Worker | None:
        if command is None:
            return None
        try:
            worker = _Worker(start(command))
        except OSError:
            return None
        with self._changed:
            self._workers.add(worker)
        try:
            if not self._stop.is_set():  # else nobody will kill it but us
                worker.wait_until_ready()
                return worker
        except (EOFError, OSError):
            self.died += not self._stop.is_set()
        self._dismiss(worker)
        return None

    def _do(self, worker: _Worker | None, task: _Task[Any]) -> _Worker | None:
        """Do a task; gives the worker if it lives."""
        packed = None if worker is None else task.pack()
        if worker is not None and packed is not None:
            try:
                worker.do(task, packed)
                return worker
            except Exception:  # whatever came through the pipe was no answer
                self._dismiss(worker)
                worker = None
                self.died += not self._stop.is_set()
        if self._stop.is_set():
            task.future.set_exception(Cancelled(say("stopped")))
        else:
            crew.begin(self._stop, task.tell)
            task.do_here()
        return worker

    def _dismiss(self, worker: _Worker) -> None:
        with self._changed:
            self._workers.discard(worker)
        worker.close()
