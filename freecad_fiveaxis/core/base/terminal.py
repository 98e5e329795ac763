# SPDX-License-Identifier: LGPL-2.1-or-later
"""The terminal: text that always comes out, and progress as a bar a stage, by tqdm or by a plain line where
tqdm is missing."""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any, TextIO

from .errors import FileError
from .progress import Progress, silent
from .sentences import one_line, say

GONE = (errno.EPIPE, errno.EINVAL) if sys.platform == "win32" else (errno.EPIPE,)
"""How a system says that the reader of a pipe has gone away; Windows takes it for an invalid argument."""


def show(text: str, stream: TextIO | None) -> None:
    """Print a text at once; a character that the stream cannot take (a file name that is no Unicode) comes as
    an escape.

    A reader that has gone away, or no stream at all, is no error. Raises FileError where the text cannot be
    written.
    """
    if stream is None:
        return
    encoding = getattr(stream, "encoding", None) or "utf-8"
    try:
        print(text.encode(encoding, "backslashreplace").decode(encoding), file=stream, flush=True)
    except OSError as error:
        _silence(stream)
        if isinstance(error, BrokenPipeError) or error.errno in GONE:
            return
        raise FileError(
            say("the text cannot be shown: {strerror}", strerror=error.strerror or error), text
        ) from error


def complain(line: str) -> None:
    """Show one line on stderr, as :func:`show_error`."""
    show_error(one_line(line))


def show_error(text: str) -> None:
    """Show a text on stderr; where that cannot be written, the exit code is all that is left."""
    with suppress(FileError):
        show(text, sys.stderr)


def _silence(stream: TextIO) -> None:
    """Silence the stream: what is still in its buffer would fail again when Python ends."""
    with suppress(OSError, ValueError, AttributeError):  # a stream without a file number has no such end
        away = os.open(os.devnull, os.O_WRONLY)
        os.dup2(away, stream.fileno())
        os.close(away)


@contextmanager
def bars(quiet: bool) -> Iterator[Progress]:
    """Yield a progress function for as long as the work lasts; silent where nobody looks."""
    if quiet or not sys.stderr.isatty():
        yield silent
        return
    shown = _tqdm_bar() or _PlainLine()
    try:
        yield shown.show
    finally:
        shown.close()


class _Bar:
    """One tqdm bar, begun anew at each stage."""

    def __init__(self, tqdm: Any) -> None:
        self._tqdm, self._bar, self._stage = tqdm, None, ""

    def show(self, stage: str, fraction: float) -> None:
        if stage != self._stage:
            self.close()
            self._bar = self._tqdm(
                total=100,
                desc=f"{stage:24}",
                leave=False,
                bar_format="{desc} {bar} {percentage:3.0f}% {elapsed}",
            )
            self._stage = stage
        self._bar.n = round(100 * fraction)  # type: ignore[attr-defined]
        self._bar.refresh()  # type: ignore[attr-defined]

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
            self._bar = None


class _PlainLine:
    """The same without tqdm: one line, rewritten."""

    def show(self, stage: str, fraction: float) -> None:
        print(f"\r{stage:24} {100 * fraction:3.0f} %", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        print("\r" + " " * 40 + "\r", end="", file=sys.stderr, flush=True)


def _tqdm_bar() -> _Bar | None:
    try:
        from tqdm import tqdm
    except ImportError:
        return None
    return _Bar(tqdm)
