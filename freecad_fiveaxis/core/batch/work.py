# SPDX-License-Identifier: LGPL-2.1-or-later
"""One job from its part to its files, whatever happens: what fails becomes a row of the report.

key     the hash of all that a job is made of: the bytes of the files that it reads, its options, the version
        of the program.
own     a file that a batch wrote and nobody has changed since: NAME.json keeps the hash of each.
"""

from __future__ import annotations

import hashlib
import json
import os
import threading
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from freecad_fiveaxis import __version__
from freecad_fiveaxis.core.base.chunks import keep_to_one_thread
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import read_bytes, write_all
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import one_line
from freecad_fiveaxis.core.pipeline import job as pipeline
from freecad_fiveaxis.core.pipeline.options import read_scallop
from freecad_fiveaxis.core.pipeline.outputs import files_read
from freecad_fiveaxis.core.pipeline.programs import PostedProgram, Result
from freecad_fiveaxis.core.pipeline.settings import Settings, build_settings, flat_options
from freecad_fiveaxis.core.report import Figures, as_html, as_json, summary
from freecad_fiveaxis.core.report.verdict import find_largest_judged, verdict
from freecad_fiveaxis.core.studies.setup_map.sheet import json_text

from .solids import mesh_solid, read_part
from .task import COLUMNS, FAILED, BatchJob, JobOutcome, not_of_batch

MARK = "batch"
"""The key of NAME.json under which a batch keeps what it needs to know its own files again."""

_drawing = threading.Lock()
"""matplotlib's settings are those of the whole process: one page at a time."""


def run_one(job: BatchJob, progress: Progress = silent) -> JobOutcome:
    """Do a job, or read what it is known to have written already; an error is an outcome. Raises Cancelled
    from progress."""
    try:
        return read_finished(job) or _mill(job, progress)
    except Cancelled:
        raise
    except Exception as error:
        return fail_job(job, error)


def run_in_worker(job: BatchJob, progress: Progress = silent) -> JobOutcome:
    """As run_one, on this thread alone: the other processors have jobs of their own."""
    with keep_to_one_thread():
        return run_one(job, progress)


def fail_job(job: BatchJob, error: BaseException | str) -> JobOutcome:
    """Return the outcome of a job that has no program. An error that is not ours is told with its kind."""
    ours = isinstance(error, FiveAxisError | str)
    message = one_line(" ".join(str(error).split()) if ours else f"{type(error).__name__}: {error}".strip())
    row = dict.fromkeys(COLUMNS) | _name_job(job) | {"verdict": FAILED, "error": message}
    return JobOutcome(job.stem, row, error=message)


def read_finished(job: BatchJob) -> JobOutcome | None:
    """Tell how a job ended that is done already, from its NAME.json; None where anything that it is made of
    has changed, or one of its files."""
    mark = _mark(job)
    if mark is None or foreign_files(job) or not all(map(os.path.exists, job.files)):
        return None
    try:
        same = mark["key"] == key_of(job, _settings(job))
        return JobOutcome(job.stem, {**mark["row"], **_name_job(job)}, job.files) if same else None
    except (FiveAxisError, KeyError, TypeError):
        return None


def foreign_files(job: BatchJob) -> list[str]:
    """Name the files in a job's places that are not its own: no batch wrote them, or somebody has changed
    them."""
    mark = _mark(job)
    hashes = (mark or {}).get("files", {})
    there = [path for path in (job.nc, job.html) if os.path.lexists(path)]
    foreign = [path for path in there if hashes.get(os.path.basename(path)) != _hash_of(path)]
    return foreign + ([job.json] if mark is None and os.path.lexists(job.json) else [])


def check_own(job: BatchJob) -> None:
    """Refuse a job whose files would replace others. Raises SettingsError that names the first."""
    foreign = [] if job.overwrite else foreign_files(job)
    if foreign:
        raise not_of_batch(foreign[0])


def key_of(job: BatchJob, settings: Settings) -> str:
    """Return the hash of all that the job is made of. Raises FileError where a file cannot be read."""
    facts = flat_options(settings) | {"version": __version__, "ending": job.suffix}
    files = [read_part(path).file if path == settings.source else path for path in files_read(settings)]
    hashes = [hashlib.sha256(read_bytes(path, "file")).hexdigest() for path in files]
    return hashlib.sha256(json.dumps([facts, hashes], sort_keys=True).encode()).hexdigest()


def _settings(job: BatchJob) -> Settings:
    return build_settings(job.task, job.part, job.options)


def _mill(job: BatchJob, progress: Progress) -> JobOutcome:
    settings = _settings(job)
    check_own(job)
    key = key_of(job, settings)
    part = read_part(job.part)
    mesh = {"mesh": mesh_solid(part, progress)} if part.is_meshed_first else {}
    result = pipeline.run(settings, progress, **mesh)
    figures = pipeline.figures(result)
    finish = {"scallop_mm": read_scallop(settings), "stepover_mm": settings.passes.stepover}
    row = _name_job(job) | _numbers(figures) | finish
    files = _files(job, result, figures, progress)
    mark = {
        "key": key,
        "files": {os.path.basename(path): _sha(data) for path, data in files.items()},
        "row": row,
    }
    report = json_text(json.loads(as_json(figures)) | {MARK: mark})
    _make_folder(job.stem)
    write_all(files | {job.json: report.encode("utf-8", "backslashreplace")})
    return JobOutcome(job.stem, row, job.files)


def _make_folder(stem: str) -> None:
    """Make the folder of a job's files where it is not there. What cannot be made, the files say."""
    with suppress(OSError):
        os.makedirs(os.path.dirname(stem) or ".", exist_ok=True)


def _files(job: BatchJob, result: Result, figures: Figures, progress: Progress) -> dict[str, bytes]:
    assert isinstance(result.draft, PostedProgram)
    with _drawing:
        page = as_html(figures, progress)
    return {job.nc: result.draft.nc, job.html: page.encode("utf-8", "backslashreplace")}


def _name_job(job: BatchJob) -> dict[str, Any]:
    machine = str(job.options.get("machine") or "")
    named = Path(machine).stem if machine.lower().endswith(".fcm") else machine
    return {
        "name": os.path.basename(job.stem),
        "part": job.label or os.path.basename(job.part),
        "machine": named,
    }


def _numbers(figures: Figures) -> dict[str, Any]:
    """Return the rest of a row; a number that is not known is None."""
    numbers = summary(figures)
    facts = verdict(figures, numbers)
    deviation, bound = find_largest_judged(numbers)
    share = numbers.get("unfinished_share")
    return {
        "verdict": facts.light.value,
        "deviation_mm": deviation, "bound_mm": bound,
        "cut_mm": numbers["cut_length"], "links_mm": numbers["link_length"],
        "rapids_mm": numbers["rapid_length"],
        "minutes": numbers["time_s"] / 60.0,
        "unfinished_percent": None if share is None else 100.0 * share,
        "errors": numbers["findings"][Severity.ERROR.name.lower()],
        "says": str(facts.text), "error": "",
    }  # fmt: skip


def _mark(job: BatchJob) -> Mapping[str, Any] | None:
    """Return what a batch keeps in NAME.json; None where there is no such file, or it is none of a batch."""
    try:
        report = json.loads(read_bytes(job.json, "report"))
    except (FileError, ValueError, RecursionError):
        return None
    mark = report.get(MARK) if isinstance(report, dict) else None
    return mark if isinstance(mark, dict) and isinstance(mark.get("files"), dict) else None


def _hash_of(path: str) -> str | None:
    try:
        return _sha(read_bytes(path, "file"))
    except FiveAxisError:  # a folder, or no right to read it
        return None


def _sha(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
