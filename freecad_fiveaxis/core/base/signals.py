# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals that ask a process to end: SIGINT (Ctrl-C), SIGTERM (``kill``, a service that stops), SIGHUP (the
terminal is gone).

A command line turns each into an exception, so that what is half done is tidied up; while files take their
place, they wait. A signal that is ignored (``nohup``) stays so, and one that another program handles
(FreeCAD) stays its own.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
"""Those that this system has: Windows has no SIGHUP."""


class Stopped(KeyboardInterrupt):
    """A signal came. ``number`` is the signal's."""

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number


def exit_code(stop: BaseException) -> int:
    """128 + the signal's number, as shells have it: 130 SIGINT, 143 SIGTERM, 129 SIGHUP; 130 for any other
    way to stop."""
    return 128 + (stop.number if isinstance(stop, Stopped) else signal.SIGINT)


def _nothing_written() -> None:
    if sys.stderr is not None:
        print("stopped; nothing was written", file=sys.stderr, flush=True)


class _Watch:
    """What a command line does about signals; one for each process, as the signals are."""

    def __init__(self) -> None:
        self.first: Stopped | None = None
        self.last_words: Callable[[], None] = _nothing_written
        self.telling = False

    def take(self, number: int, frame: FrameType | None) -> None:
        """Raise an exception at the first signal; end the process at once at the second: the user is in a
        hurry."""
        if self.first is None:
            self.first = Stopped(number)
            raise self.first
        if self.telling:  # and then it ends
            return
        try:
            self.last_words()
        finally:  # whatever the words met with: the stream may be in use just now
            os._exit(exit_code(self.first))

    def leave_at_once(self, number: int, frame: FrameType | None) -> None:
        """Nothing is left to tidy up, and an exception in Python's own last steps would be shown to the
        user."""
        os._exit(128 + number)


_watch = _Watch()


def watch(last_words: Callable[[], None] = _nothing_written) -> None:
    """From now on the first signal raises :class:`Stopped` in the main thread; for a command line, not for a
    library.

    ``last_words`` are said where a second signal comes before the first is told."""
    _watch.last_words = last_words
    sys.unraisablehook = _keep_quiet_of_signals
    for number in ENDING:
        if signal.getsignal(number) in (signal.SIG_DFL, signal.default_int_handler):
            signal.signal(number, _watch.take)


def _keep_quiet_of_signals(ignored: sys.UnraisableHookArgs) -> None:
    """Show what Python had to ignore, but a signal, which is told of when the work ends
    (:func:`raise_received`)."""
    if not isinstance(ignored.exc_value, Stopped):
        sys.__unraisablehook__(ignored)


def tell(last_words: Callable[[], None] = _nothing_written) -> None:
    """Say the last words before the end; signals that come now are too late to matter."""
    _watch.telling = True
    last_words()


def unwatch() -> None:
    """Let a signal that comes now end the process at once: the work is done."""
    for number in ENDING:
        if signal.getsignal(number) == _watch.take:
            signal.signal(number, _watch.leave_at_once)


def find_signal() -> Stopped | None:
    """Return the signal that came, also where other code has made another exception of it (as numpy does
    while it is loaded)."""
    return _watch.first


def raise_received() -> None:
    """Raise the signal that came but did not end the work: Python ignores exceptions in what runs when an
    object is deleted."""
    if _watch.first is not None:
        raise _watch.first


@contextmanager
def defer_signals() -> Iterator[None]:
    """Signals that come meanwhile are delivered at the end. Only Python's main thread gets signals; elsewhere
    nothing is done."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    waiting: list[int] = []
    before = {number: signal.getsignal(number) for number in ENDING}
    deferrable = [
        number for number in ENDING if before[number] not in (None, signal.SIG_IGN)
    ]  # None: not Python's to restore
    try:
        for number in deferrable:
            signal.signal(number, lambda came, frame: waiting.append(came))
        yield
    finally:
        for number in deferrable:
            signal.signal(number, before[number])
        if waiting:
            signal.raise_signal(waiting[0])
