# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of a target: what a spoilt file comes to, with a limit of time."""

from __future__ import annotations

import contextlib
import random
import signal
import traceback
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from mutations import spoilt
from targets import Target

from freecad_fiveaxis.core.base.errors import FiveAxisError

LIMIT = 20.0
"""s for one small file, on a slow machine."""


class TooLong(BaseException):
    """The limit is over; no except of the core's catches it."""


@dataclass(frozen=True)
class Flaw:
    """A file that is neither taken nor refused, and what came instead."""

    data: bytes
    message: str


@contextlib.contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Raise TooLong after so many seconds; only in the main thread. Windows has no such alarm: there nothing
    is limited."""
    if not hasattr(signal, "SIGALRM"):
        yield
        return

    def over(*_: object) -> None:
        raise TooLong

    before = signal.signal(signal.SIGALRM, over)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def tried(target: Target, data: bytes, folder: Path, seconds: float = LIMIT) -> Flaw | None:
    """The flaw that this file brings to light, if it does."""
    path = folder / f"fuzz{target.ending}"
    path.write_bytes(data)
    try:
        with warnings.catch_warnings(), limited(seconds):
            warnings.simplefilter("error")
            target.read(path)
    except FiveAxisError as refused:
        return Flaw(data, f"several lines: {refused!r}") if "\n" in str(refused) or not str(refused) else None
    except TooLong:
        return Flaw(data, f"more than {seconds:g} s")
    except BaseException:  # a SystemExit or a MemoryError is a flaw too
        return Flaw(data, traceback.format_exc())
    return None


def hunt(target: Target, seed: int, runs: int, folder: Path) -> Iterator[Flaw | None]:
    """One result a run; the same ones for the same seed."""
    dice = random.Random(seed)
    for _ in range(runs):
        yield tried(target, spoilt(dice.choice(target.seeds), dice), folder)
