# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a Python that was started to work beside another one does: the other end of :mod:`.workers`.

Tasks come in by stdin and answers go out by stdout, each as a length and a pickle. Once stdin ends the
process ends at once, in the middle of a task too: that is how it learns that its work is not wanted any more,
or that nobody is there to want it.
"""

from __future__ import annotations

import os
import pickle
import signal
import struct
import sys
import threading
import time
from queue import SimpleQueue
from typing import IO, Any

from . import crew

MARK = b"\0freecad-fiveaxis worker\0"
"""The first that a worker says itself; what was printed before, as FreeCAD's greeting, is not for us."""
LENGTH = struct.Struct("<Q")
FRACTION, RESULT, ERROR = range(3)
"""What an answer is: how far the task is, and last its result or what it raised."""
OFTEN = 0.1
"""s between two words about how far the task is."""


def identity() -> str:
    """Return what a worker must have in common with whoever starts it: the versions of Python and of all that
    computes."""
    import numpy as np
    import scipy

    from freecad_fiveaxis import __version__

    return f"{__version__} {sys.version_info[0]}.{sys.version_info[1]} {np.__version__} {scipy.__version__}"


def show_identity() -> None:
    """Print it after MARK, and end the process: FreeCAD would go on."""
    sys.stdout.flush()
    os.write(1, MARK + identity().encode() + MARK)
    os._exit(0)


def serve() -> None:
    """Do one task after the other, for as long as stdin is open; never returns."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for whoever started us
    inward, outward = _take_pipes()
    tasks = SimpleQueue[bytes]()
    threading.Thread(target=_read_tasks, args=(inward, tasks), daemon=True).start()
    outward.write(MARK)
    outward.flush()
    try:
        crew.begin(threading.Event(), _Telling(outward))
        while True:
            send(outward, pickle.dumps(_answer(tasks.get()), pickle.HIGHEST_PROTOCOL))
    finally:
        os._exit(1)


def send(pipe: IO[bytes], data: bytes) -> None:
    """Write one message. Raises OSError where nobody reads."""
    pipe.write(LENGTH.pack(len(data)))
    pipe.write(data)
    pipe.flush()


def receive(pipe: IO[bytes]) -> bytes:
    """Read one message. Raises EOFError where there is no whole one any more."""
    return _whole(pipe, LENGTH.unpack(_whole(pipe, LENGTH.size))[0])


def _whole(pipe: IO[bytes], length: int) -> bytes:
    data = pipe.read(length)
    if len(data) < length:
        raise EOFError
    return data


def _take_pipes() -> tuple[IO[bytes], IO[bytes]]:
    """Stdin and stdout, for messages alone: what anything else prints from now on goes nowhere."""
    sys.stdout.flush()
    pipes = os.dup(0), os.dup(1)
    if sys.platform == "win32":
        import msvcrt

        for pipe in pipes:
            msvcrt.setmode(pipe, os.O_BINARY)
    nothing = os.open(os.devnull, os.O_RDWR)
    os.dup2(nothing, 0)
    os.dup2(nothing, 1)
    return os.fdopen(pipes[0], "rb"), os.fdopen(pipes[1], "wb")


def _read_tasks(inward: IO[bytes], tasks: SimpleQueue[bytes]) -> None:
    try:
        while True:
            tasks.put(receive(inward))
    finally:
        os._exit(0)


def _answer(packed: bytes) -> tuple[int, Any]:
    """Return what a task gives or raises. A process that cannot read it, or has no memory for it, ends:
    others do the task then."""
    work, given, named = pickle.loads(packed)
    try:
        return RESULT, work(*given, **named)
    except MemoryError:
        raise
    except Exception as error:
        return ERROR, error


class _Telling:
    """Says how far a task is, not too often."""

    def __init__(self, outward: IO[bytes]) -> None:
        self._outward, self._due = outward, 0.0

    def __call__(self, fraction: float) -> None:
        now = time.monotonic()
        if now >= self._due:
            self._due = now + OFTEN
            send(self._outward, pickle.dumps((FRACTION, fraction)))
