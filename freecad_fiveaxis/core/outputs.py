# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that a job writes: each whole or not at all, and none before it is known that all can be written."""

from __future__ import annotations

import os
from pathlib import Path

from freecad_fiveaxis.core.report import as_html, as_json, as_text, blocks_csv, rates_csv
from freecad_fiveaxis.core.sentences import say

from .apt import write_apt
from .asked import cl_head, title_of
from .errors import SettingsError
from .files import check_writable, write_whole
from .job import Made, Posted, Result, figures
from .progress import Progress, silent
from .settings import Settings

REPORTS = {".json": as_json, ".html": as_html, ".htm": as_html, ".txt": as_text}


def check_outputs(settings: Settings) -> None:
    """Before the long work: every file can be written, has a known ending, and is not the source. Raises FiveAxisError."""
    output = settings.output
    named = (output.output, output.cl, output.blocks, settings.recover.machine_file, output.rates, *output.report)
    targets = [path for path in named if path]
    given = (settings.source, settings.recover.program, settings.audit.against, settings.faces.faces)
    reads = [read for read in given if read]
    for path in targets:
        check_writable(path)
        if os.path.realpath(path) in map(os.path.realpath, reads):
            raise SettingsError(say("{path} is the file that is read; name another output", path=path), path)
    if len({os.path.realpath(path) for path in targets}) < len(targets):
        raise SettingsError(say("two outputs have the same name; name each file apart"), targets)
    for path in output.report:
        if Path(path).suffix.lower() not in REPORTS:
            raise SettingsError(
                say("report {path} needs one of the endings {reports}", path=path, reports=", ".join(REPORTS)), path
            )


def write_outputs(result: Result, progress: Progress = silent) -> list[str]:
    """Write the files that the settings name, each whole or not at all; returns their names. Raises FileError."""
    files = {**_program_files(result.made), **_report_files(result, progress)}
    for path, data in files.items():
        write_whole(path, data)
    return list(files)


def _program_files(made: Made) -> dict[str, bytes]:
    output, files = made.settings.output, {}
    if isinstance(made, Posted) and output.output:
        files[output.output] = made.nc
    if isinstance(made, Posted) and output.cl:
        files[output.cl] = write_apt(
            made.path, made.settings.cutter.cutter, title_of(made.settings), head=cl_head(made.settings)
        )  # fmt: skip
    return files


def _report_files(result: Result, progress: Progress) -> dict[str, bytes]:
    output, files = result.made.settings.output, {}
    if output.blocks:
        files[output.blocks] = blocks_csv(result.made.program, result.deviation, result.singularity, progress, result.gouge)
    if (rates := output.rates) and result.audit is not None:
        files[rates] = rates_csv(result.made.links, result.made.program, result.audit, progress)
    if output.report:
        sheets = figures(result)
        files |= {path: REPORTS[Path(path).suffix.lower()](sheets).encode("utf-8", "backslashreplace") for path in output.report}
    return files
