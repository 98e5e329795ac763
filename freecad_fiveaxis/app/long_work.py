# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who listens while long work goes on, and how it is stopped.

listener  a function ``(stage, fraction)`` that shows how far the work is; it raises Cancelled to stop it.
bar       FreeCAD's own progress bar in the status line: the listener where nobody else listens and there is a window.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD

from freecad_fiveaxis.core.errors import Cancelled
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.sentences import say

_STEPS = 100
_Indicator = FreeCAD.Base.ProgressIndicator
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
    """The listener of one piece of work: the given one, else the current one, else FreeCAD's bar for as long as it lasts."""
    if listener is not None:
        with reporting(listener):
            yield listener
        return
    shown = progress()
    try:
        yield shown
    finally:
        if isinstance(shown, _Bar):
            shown.close()


def progress() -> Progress:
    """The current listener. Without one: FreeCAD's bar where there is a window, else nobody."""
    if _listeners:
        return _listeners[-1]
    return _Bar() if _has_window() else silent


def _has_window() -> bool:
    return bool(FreeCAD.GuiUp)


class _Bar:
    """FreeCAD's progress bar, begun anew at each stage; Esc stops the work."""

    def __init__(self) -> None:
        self._bar, self._stage, self._done = None, "", 0

    def __call__(self, stage: str, fraction: float) -> None:
        if self._bar is None or stage != self._stage:
            self.close()
            self._bar, self._stage, self._done = _Indicator(), stage, 0
            self._bar.start(f"Five-axis: {stage}", _STEPS)
        try:
            while self._done < min(_STEPS - 1, round(_STEPS * fraction)):
                self._done += 1
                self._bar.next(True)
        except FreeCAD.Base.FreeCADAbort as stopped:  # a BaseException: nobody else would catch it
            self.close()
            raise Cancelled(say("stopped; nothing was changed")) from stopped

    def close(self) -> None:
        """Take the bar away."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None
