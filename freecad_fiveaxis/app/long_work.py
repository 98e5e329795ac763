# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who listens while long work goes on, and how it is stopped.

listener  a function ``(stage, fraction)`` that shows how far the work is; it raises Cancelled to stop it.
window    a listener that shows a dialog and handles the window's events (``pump``). For it the core works in
          a thread of its own, while this one, which FreeCAD's documents belong to, keeps the window alive.
          Nothing of FreeCAD's is touched in there.

Cancel reaches the worker at its next word of progress, a little later between any two steps of Python. Where
it sits in one long call of numpy it is abandoned: it ends after that call, and nobody takes what it made.
"""

from __future__ import annotations

import ctypes
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from typing import Any, Generic, TypeVar

import FreeCAD

from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say

from .progress_window import windows

T = TypeVar("T")

TICK = 0.03
"""s between two looks at the window's events."""
TURN = 0.001
"""s after which Python leaves the worker for this thread when it wants to go on: it does so several times in
each look."""
POLITE, PATIENCE = 0.15, 0.25
"""s that a stopped worker gets to the next word of progress, and then to the next step of Python; after both
it is abandoned."""

_listeners: list[Progress] = []


@contextmanager
def reporting(listener: Progress) -> Iterator[Progress]:
    """All long work inside the ``with`` tells ``listener``, recomputes of documents too."""
    _listeners.append(listener)
    try:
        yield listener
    finally:
        _listeners.pop()


@contextmanager
def listening(listener: Progress | None = None) -> Iterator[Progress]:
    """Yield the listener of one piece of work: the given one, else the current one, else the window's for as
    long as it lasts."""
    if listener is not None:
        with reporting(listener):
            yield listener
    elif _listeners or not windows or not _is_main():
        yield progress()
    else:
        with windows[-1]() as shown, reporting(shown):
            yield shown


def progress() -> Progress:
    """Return the current listener, or nobody."""
    return _listeners[-1] if _listeners else silent


def is_running() -> bool:
    """Whether long work runs now, and the document is on its way from one state to another."""
    return bool(_listeners)


def run(work: Callable[[Progress], T], listener: Progress | None = None, doc: Any = None) -> T:
    """Return what ``work(progress)`` gives; ``work`` must touch nothing of FreeCAD's.

    Raises what the work raises, and Cancelled where the listener stops it or ``doc``, if one is given, is
    closed meanwhile.
    """
    with listening(listener) as current:
        if not hasattr(current, "pump") or not _is_main():
            return work(current)
        return _follow_worker(Worker(work), current, doc)


def is_open(doc: Any) -> bool:
    """Whether a document is still open."""
    return any(one is doc for one in FreeCAD.listDocuments().values())


def _float_rules() -> AbstractContextManager[None]:
    """Return what numpy does here at an overflow and the like, for another thread."""
    import numpy as np

    return np.errstate(**np.geterr())


def take_back(doc: Any, *objects: Any) -> None:
    """Remove what work that failed had made, unless the document was closed meanwhile."""
    if is_open(doc):
        for obj in reversed(objects):
            doc.removeObject(obj.Name)


@contextmanager
def as_before(obj: Any, names: Iterable[str]) -> Iterator[None]:
    """Give an object back these properties, and whether it waits to be computed, where work with it fails."""
    doc, touched = obj.Document, "Touched" in obj.State
    values = {name: getattr(obj, name) for name in names}
    try:
        yield
    except BaseException:
        if is_open(doc):
            for name, value in values.items():
                setattr(obj, name, value)
            if not touched:
                obj.purgeTouched()
        raise


def check_open(doc: Any) -> None:
    """Raise Cancelled where the document (None: there is none) was closed while the window's events were
    handled."""
    if doc is not None and not is_open(doc):
        raise Cancelled(say("the document was closed; nothing was changed"))


def _is_main() -> bool:
    return threading.current_thread() is threading.main_thread()


def _follow_worker(worker: Worker[T], listener: Any, doc: Any) -> T:
    """Return the worker's result. Meanwhile the listener hears all news and handles the window's events."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(TURN)
    worker.start()
    try:
        while not worker.done.wait(TICK):
            for news in worker.news():
                listener(*news)
            listener.pump()
            check_open(doc)
        for news in worker.news():
            listener(*news)
        check_open(doc)
    except BaseException:
        worker.stop()
        raise
    finally:
        sys.setswitchinterval(before)
    return worker.result()


class Worker(threading.Thread, Generic[T]):
    """A thread that does one piece of work of the core, under the same rules for floating-point errors.

    ``done`` is set when it has ended, whichever way.
    """

    def __init__(self, work: Callable[[Progress], T]) -> None:
        super().__init__(
            name="FiveAxis", daemon=True
        )  # FreeCAD quits without waiting for one that was abandoned
        self.done = threading.Event()
        self._work, self._rules = work, _float_rules()
        self._heard: deque[tuple[str, float]] = deque()
        self._stopped = self._left = False
        self._leaving = threading.Lock()
        self._results: list[T] = []
        self._error: BaseException | None = None

    def run(self) -> None:
        """Do the work."""
        with suppress(Cancelled):  # a second stop may arrive while the first is taken down
            self._do()
        self._leave()

    def _do(self) -> None:
        try:
            with self._rules:
                self._results.append(self._work(self._tell))
        except BaseException as error:
            self._error = error

    def news(self) -> list[tuple[str, float]]:
        """Return what was said since the last call: each stage once, with its last fraction."""
        latest = {}
        while self._heard:
            stage, fraction = self._heard.popleft()
            latest[stage] = fraction
        return list(latest.items())

    def result(self) -> T:
        """Return what the work gave, or the error it raised."""
        if self._error is not None:
            raise self._error
        return self._results[0]

    def stop(self) -> None:
        """End the work as soon as that can be; returns within POLITE + PATIENCE seconds, with the worker
        ended or abandoned."""
        self._stopped = True
        if self.done.wait(POLITE):
            return
        end = time.monotonic() + PATIENCE
        while not self.done.wait(TICK) and time.monotonic() < end:
            with self._leaving:
                if not self._left:
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(
                        ctypes.c_ulong(self.ident or 0), ctypes.py_object(Cancelled)
                    )

    def _tell(self, stage: str, fraction: float) -> None:
        if self._stopped:
            raise Cancelled
        self._heard.append((stage, fraction))

    def _leave(self) -> None:
        """Let a stop that is still on its way arrive here at the latest."""
        while not self.done.is_set():
            try:
                with self._leaving:
                    self._left = True
                self.done.set()
            except Cancelled:
                continue
