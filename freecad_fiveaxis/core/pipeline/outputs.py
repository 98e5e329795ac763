# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that a job writes: all or none, and none before it is known that all can be written."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.curve_text import ENDING, is_inline
from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.files import check_writable, same_file, write_all
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.gouge.fixture_places import parse_fixture
from freecad_fiveaxis.core.machine import load_machine, machine_path
from freecad_fiveaxis.core.report import as_html, as_json, as_text, blocks_csv, rates_csv
from freecad_fiveaxis.core.toolpath.apt import write_apt

from .job import figures
from .options import cl_head, title_of
from .programs import PostedProgram, ProgramDraft, Result
from .settings import Settings, option_fields

REPORTS = {".json": as_json, ".html": as_html, ".htm": as_html, ".txt": as_text}


WRITTEN = ("output", "cl", "report", "blocks", "rates", "machine_file")
"""The options that name files to write; all others that hold a path name files that are read."""


def check_outputs(settings: Settings, read: Iterable[str] = ()) -> None:
    """Before the long work: every file can be written, has a known ending, and is none that the job reads.

    ``read``: what is read besides the settings' own files, as the job file. Raises FiveAxisError.
    """
    targets = [path for _, path in _paths(settings, True)]
    for path in targets:
        check_writable(path)
    for path in targets:
        if any(same_file(path, given) for given in (*files_read(settings), *read)):
            raise SettingsError(say("{path} is the file that is read; name another output", path=path), path)
    for one, other in combinations(targets, 2):
        if same_file(one, other):
            raise SettingsError(
                say("{path} is named for two outputs; name each file apart", path=other), targets
            )
    for path in settings.output.report:
        if Path(path).suffix.lower() not in REPORTS:
            raise SettingsError(
                say(
                    "report {path} needs one of the endings {reports}", path=path, reports=", ".join(REPORTS)
                ),
                path,
            )


def files_read(settings: Settings) -> list[str]:
    """Every file that the job reads: source, programs, parts, curves and machines."""
    machines = (settings.machine.machine, *settings.compare.machines)
    of_machines = [os.fspath(path) for name in machines if name and (path := machine_path(name)) is not None]
    read = (
        settings.source,
        *(path for _, path in list_paths_read(settings)),
        *curve_files(settings),
        *of_machines,
        *_body_files(of_machines),
    )
    return [name for name in read if name]


def _body_files(machines: Iterable[str]) -> Iterator[str]:
    """Yield the files of the machines' bodies; of a machine whose own file cannot be used none: whoever loads
    it says why."""
    for path in machines:
        try:
            yield from (body.file for body in load_machine(path).bodies)
        except FiveAxisError:
            continue


def curve_files(settings: Settings) -> list[str]:
    """Return the files of guide curves, and of the boundary."""
    return [path for _, path in name_curve_files(settings)]


def name_curve_files(settings: Settings) -> Iterator[tuple[str, str]]:
    """Yield the options that name these, and the files."""
    for name, one in (("from", settings.passes.from_), ("to", settings.passes.to)):
        if isinstance(one, str) and one.lower().endswith(ENDING):
            yield name, one
    boundary = settings.boundary.boundary
    if boundary is not None and not is_inline(boundary):
        yield "boundary", boundary


def list_paths_read(settings: Settings) -> Iterator[tuple[str, str]]:
    """Yield the options that hold paths of files to read, and these."""
    return _paths(settings, False)


def _paths(settings: Settings, written: bool) -> Iterator[tuple[str, str]]:
    """Yield the options and the files that they name, those to write or those to read."""
    for name, value in _values(settings):
        if (name in WRITTEN) == written and value:
            for one in (value,) if isinstance(value, str) else value:
                yield name, parse_fixture(one).path if name == "fixture" else one


def _values(settings: Settings) -> Iterator[tuple[str, Any]]:
    """Yield the options that hold paths, with their values."""
    groups = {type(group): group for group in vars(settings).values()}
    for cls, leaf in option_fields():
        if leaf.metadata["kind"] in ("path", "paths"):
            yield leaf.name, getattr(groups[cls], leaf.name)


def write_outputs(result: Result, progress: Progress = silent) -> list[str]:
    """Write the files that the settings name, all or none; returns their names. Raises FileError."""
    files = {**_program_files(result.draft), **_report_files(result, progress)}
    write_all(files)
    return list(files)


def _program_files(draft: ProgramDraft) -> dict[str, bytes]:
    output, files = draft.settings.output, {}
    if isinstance(draft, PostedProgram) and output.output:
        files[output.output] = draft.nc
    if isinstance(draft, PostedProgram) and output.cl:
        files[output.cl] = write_apt(
            draft.path, draft.settings.cutter.cutter, title_of(draft.settings), head=cl_head(draft.settings)
        )  # fmt: skip
    return files


def _report_files(result: Result, progress: Progress) -> dict[str, bytes]:
    output, files = result.draft.settings.output, {}
    if output.blocks:
        files[output.blocks] = blocks_csv(
            result.draft.program, result.deviation, result.singularity, progress, result.gouge, result.surface
        )
    if (rates := output.rates) and result.audit is not None:
        files[rates] = rates_csv(result.draft.kinematics, result.draft.program, result.audit, progress)
    if output.report:
        sheets = figures(result)
        files |= {
            path: REPORTS[Path(path).suffix.lower()](sheets).encode("utf-8", "backslashreplace")
            for path in output.report
        }
    return files
