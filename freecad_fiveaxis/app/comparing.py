# SPDX-License-Identifier: LGPL-2.1-or-later
"""A toolpath's path on several machines: computed when somebody asks, and kept by whoever asked. The document
holds none of it.

stand    on each machine the work zero is where that machine's file says; a place that the toolpath has on its
         own machine means nothing on another one.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.pipeline.settings import COMPARE, CureSettings, Settings, build_settings
from freecad_fiveaxis.core.studies import study as trials
from freecad_fiveaxis.core.studies.corrections import CURES

from . import compared, results
from .long_work import listening, run
from .reports import write_report
from .selection import SelectionError
from .spreading import processes
from .toolpath import Toolpath, check_fixtures


def cures() -> tuple[str, ...]:
    """Return the names of the cures there are."""
    return tuple(CURES)


def settings_of(
    toolpath: Any, machines: Sequence[str], cures: Sequence[str] = (), tool_length: float | None = None,
    fixtures: Sequence[Any] | None = None,
) -> Settings:  # fmt: skip
    """Return what is asked of the core: the toolpath's settings without its own cure, on other machines,
    beside these ``fixtures``; None: its own. Raises FiveAxisError."""
    return _settings_of(_task_of(toolpath, fixtures), machines, cures, tool_length)


def _task_of(toolpath: Any, fixtures: Sequence[Any] | None) -> results.Task:
    """Return what the toolpath asks of the core, beside other fixtures where some are given."""
    if not isinstance(getattr(toolpath, "Proxy", None), Toolpath):
        raise SelectionError(say("machines are compared on a toolpath: select a toolpath"), toolpath)
    old = results.say_old_base(toolpath)
    if old is not None:
        raise SelectionError(old, toolpath)
    task: results.Task = toolpath.Proxy.task(toolpath)
    if fixtures is None:
        return task
    held = check_fixtures(toolpath, fixtures)
    solids = compared.find_held_parts(held, tuple(toolpath.WorkZero), toolpath.Proxy.seen)
    named = tuple(compared.fixture_names(held).get("fixture", ()))
    settings = replace(task.settings, gouge=replace(task.settings.gouge, fixture=named))
    return replace(task, settings=settings, fixtures=solids)


def _settings_of(
    task: results.Task, machines: Sequence[str], cures: Sequence[str], tool_length: float | None
) -> Settings:
    path = task.settings
    given = {
        "machines": list(machines),
        "cures": list(cures),
        "tool_length": tool_length or path.machine.tool_length,
    }
    own = build_settings(COMPARE, path.source, given)
    machine = replace(path.machine, origin=None, controller=None, tool_length=own.machine.tool_length)
    cure = CureSettings(max_axis_change=path.cure.max_axis_change)
    return replace(path, task=COMPARE, machine=machine, cure=cure, compare=own.compare)


def compare(
    toolpath: Any, machines: Sequence[str], cures: Sequence[str] = (), tool_length: float | None = None,
    progress: Progress | None = None, fixtures: Sequence[Any] | None = None,
) -> trials.Comparison:  # fmt: skip
    """See :func:`freecad_fiveaxis.app.compare`; this gives the core's whole Comparison."""
    task = _task_of(toolpath, fixtures)
    settings = _settings_of(task, machines, cures, tool_length)

    def work(progress: Progress) -> trials.Comparison:
        mesh, faces = whole.mesh_and_mask(progress)
        return trials.try_machines(settings, progress, mesh, faces, executor, whole.mesh_fixtures(progress))

    with listening(progress) as listener, processes() as executor:
        whole = task.with_fixtures_meshed(listener)
        return run(work, listener, toolpath.Document)


def write(comparison: trials.Comparison, file: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Write the table as a web page (.html), for scripts (.json) or as text (.txt). Raises FileError for a
    file that is there."""
    write_report(trials.REPORTS, lambda: comparison, file, overwrite)
