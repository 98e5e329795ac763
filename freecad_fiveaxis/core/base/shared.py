# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tasks of a job share: pickled once, carried to each computer as seldom as can be, and made again
once in each process.

file      of the system's folder for temporary files: what is not small is written there once, and tasks carry
          its name and the hash of what is in it. Workers of the same computer read it, whatever engine they
          are of.
lost      what a worker answers that cannot read the file: it is on another computer, or the file is gone.
          From the first such answer on tasks carry the bytes themselves.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import tempfile
import threading
from typing import Any, Generic, TypeVar

C = TypeVar("C")

Packed = tuple[str, str, bytes]
"""What find_shared is given: a hash, and the name of a file or the bytes."""
NOTHING: Packed = ("", os.devnull, b"")
SMALL = 1 << 16
"""Bytes that are sent with each task: a file would gain nothing."""


class Shared(Generic[C]):
    """``value``: what is common. ``stopped``: the work is; only threads of the same process see it."""

    def __init__(self, value: C) -> None:
        self.value, self.stopped = value, False
        self._packed: Packed | None = None
        self._file, self._lock = "", threading.Lock()

    def __reduce__(self) -> tuple[Any, ...]:
        with self._lock:  # executors pickle on threads of their own
            if self._packed is None:
                data = _pickle_value(self.value)
                self._file = _write(data) if len(data) > SMALL else ""
                self._packed = _hash(data), self._file, b"" if self._file else data
            return find_shared, self._packed

    def send_bytes(self) -> None:
        """Let the tasks that are not pickled yet carry all that is common."""
        with self._lock:
            if self._packed is None or self._packed[1]:
                data = _pickle_value(self.value)
                self._packed = _hash(data), "", data

    def close(self) -> None:
        """Remove the file, if there is one. A task that is pickled after this finds nothing, and nobody waits
        for it."""
        with self._lock:
            if self._file:
                _remove(self._file)
            self._packed = NOTHING


class Lost:
    """In a worker: the place of what is common, which it could not read."""


def find_shared(key: str, file: str, data: bytes) -> Shared[Any] | Lost:
    """Return what is common: what this process has of this ``key``, else made from ``file``, or from ``data``
    where no file is named."""
    shared = _kept.get(key)
    if shared is None:
        packed = data if not file else _read(key, file)
        if packed is None:
            return Lost()
        shared = Shared(pickle.loads(packed))
        _kept.clear()
        _kept[key] = shared
    return shared


_kept: dict[str, Shared[Any]] = {}
"""Of a process: the last that it made, by its hash."""


def _pickle_value(value: Any) -> bytes:
    return pickle.dumps(value, pickle.HIGHEST_PROTOCOL)


def _hash(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _write(data: bytes) -> str:
    """Return a new file that only this user may read; nothing where there is no room for it."""
    try:
        number, file = tempfile.mkstemp(prefix="fiveaxis-", suffix=".pickle")
    except OSError:
        return ""
    try:
        with os.fdopen(number, "wb") as stream:
            stream.write(data)
    except OSError:
        _remove(file)
        return ""
    return file


def _read(key: str, file: str) -> bytes | None:
    """Return the bytes of that hash; None where they are not there: of a file that others could write nothing
    is unpickled."""
    try:
        with open(file, "rb") as stream:
            data = stream.read()
    except OSError:
        return None
    return data if _hash(data) == key else None


def _remove(file: str) -> None:
    with contextlib.suppress(OSError):  # Windows keeps what a worker that was stopped still reads
        os.remove(file)
