# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with an object, said in the report view in one sentence.

FreeCAD prints an error of ``execute`` with Python's trace of calls, and shows it at the object: in the
words of the window, which has fields and no options of a command line. Of an error that was foreseen, as of a
part that was deleted, that trace says nothing to a user; an error that nobody foresaw keeps it.
"""

from __future__ import annotations

import copy
import functools
import sys
from collections.abc import Callable
from typing import Any

from freecad_fiveaxis.core.base.errors import FiveAxisError

from . import wording

LIMIT = "tracebacklimit"
"""Python's own switch: FreeCAD has Python print the trace, which then prints none."""


_living: list[int] = []
_before: list[int | None] = []


class _Traceless:
    """While one of these lives, Python prints no trace. Its error keeps it, which FreeCAD drops as soon as
    that is printed."""

    def __init__(self) -> None:
        if not _living:
            _before[:] = [getattr(sys, LIMIT, None)]
        _living.append(1)
        setattr(sys, LIMIT, 0)

    def __del__(self) -> None:
        _living.pop()
        if not _living and _before[0] is not None:
            setattr(sys, LIMIT, _before[0])
        elif not _living and hasattr(sys, LIMIT):
            delattr(sys, LIMIT)


def hide_trace(execute: Callable[[Any, Any], None]) -> Callable[[Any, Any], None]:
    """Decorate a proxy's ``execute``: what was foreseen is raised as before, and printed without a
    trace."""

    @functools.wraps(execute)
    def call(proxy: Any, obj: Any) -> None:
        failed: list[FiveAxisError] = []
        try:
            execute(proxy, obj)
        except FiveAxisError as error:
            failed.append(_traceless(error))
        if failed:
            # from no variable: this call, in the error's own trace, would keep the error alive
            raise failed.pop()

    return call


def _traceless(error: FiveAxisError) -> FiveAxisError:
    """Return the same error in the words of the window, which nothing else holds."""
    copied = copy.copy(error)
    copied.args = (wording.localize(error), *error.args[1:])
    copied.__dict__["traceless"] = _Traceless()
    return copied
