# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress on a terminal: a bar a stage, by tqdm where it is installed and by a plain line where it is not."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from .progress import Progress, silent


@contextmanager
def bars(quiet: bool) -> Iterator[Progress]:
    """A progress function for as long as the work lasts; silent where nobody looks."""
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
                total=100, desc=f"{stage:24}", leave=False, bar_format="{desc} {bar} {percentage:3.0f}% {elapsed}"
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
