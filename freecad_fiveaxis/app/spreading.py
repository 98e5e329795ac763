# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processes for work of many trials: *Compare*, *Where to clamp* and the reach map, in the window and without
one.

The block that has them stands around :func:`.long_work.run`, in the thread that asked for the work: so they
are gone once that goes on, whether the work has ended, was stopped, or was abandoned in one long call.
"""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager

import FreeCAD

from freecad_fiveaxis.core.base.chunks import PROCESSORS
from freecad_fiveaxis.core.base.workers import PATIENCE, WorkerProcesses

from . import meshing, preferences
from .interpreters import Around, find_worker, has_no_worker, scratch

patience = PATIENCE
"""s of work before processes are started; tests have none."""


@contextmanager
def processes(least: int = 2) -> Iterator[Executor | None]:
    """Who does the trials, as many at a time as the user prefers; None: this process, as where fewer than
    ``least`` are preferred or no Python can work beside this FreeCAD. Whatever happens in the block, no
    process is left after it."""
    count, around = preferences.processes() or PROCESSORS, Around(FreeCAD.getHomePath(), meshing.command())
    if count < max(least, 2) or has_no_worker(around):
        yield None
        return
    with scratch() as folder:
        pool = WorkerProcesses(lambda: find_worker(around, folder), count, patience)
        try:
            yield pool
        finally:
            pool.stop()
    if pool.died:
        FreeCAD.Console.PrintLog(
            f"Five-axis: {pool.died} processes ended before their work; it was done here\n"
        )
