# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which window shows long work that nobody else listens to. Nothing is imported here: FreeCAD's start-up
comes by."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any

windows: list[Callable[[], AbstractContextManager[Any]]] = []
"""None, or the one that was named last."""


def show_progress_in(window: Callable[[], AbstractContextManager[Any]]) -> None:
    """From now on long work that nobody else listens to, as that of a recompute, is shown by ``window()``."""
    windows[:] = [window]
