# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``batch``: its arguments, and what it does with them."""

from __future__ import annotations

import argparse
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.files import check_readable, written
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import one_line, say

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.crew import Crew

    from .task import BatchJob, JobOutcome

NAMED_HERE = ("output", "cl", "report", "blocks")
"""Options of ``mill`` that name files of one job; a batch names its files itself."""
TEXT = (
    "mill many parts, or parts in many ways, side by side: a folder of STL, STEP or FreeCAD files, or "
    "a table (JSON)"
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the batch itself; those of its jobs are those of ``mill``."""
    parser.add_argument(
        "source",
        metavar="JOBS.json|FOLDER",
        nargs="?",
        help="a table of jobs, or a folder of parts (STL, STEP, IGES, BREP, FCStd)",
    )
    parser.add_argument(
        "--out", metavar="FOLDER", required=True, help="the folder to write to; made where it is missing"
    )
    parser.add_argument("--workers", metavar="N", help="so many jobs at a time [the processors]")
    parser.add_argument(
        "--executor", default="processes",
        help="who does the jobs: processes, threads, serial, dask://HOST:PORT or mpi [processes]",
    )  # fmt: skip
    parser.add_argument(
        "--shard",
        metavar="I/N",
        help="only every N-th job from the I-th on: the others are for other computers",
    )
    parser.add_argument(
        "--overwrite", action="store_true", help="replace files of the jobs' names that no batch wrote"
    )
    parser.add_argument(
        "--merge", metavar="FOLDER", nargs="+", help="no jobs: one report over folders that batches wrote"
    )


Ended = tuple[list[str], list[str], Sequence[Mapping[str, Any]]]
"""Some sentences, the report's files and its rows."""


def act(arguments: argparse.Namespace, options: Mapping[str, Any], progress: Progress) -> Ended:
    """Do the jobs, with these options of ``mill``, or merge reports. Raises FiveAxisError before the work."""
    return _merge(arguments) if arguments.merge else _batch(arguments, options, progress)


def line_of(row: Mapping[str, Any]) -> str:
    """Tell a row of the report on the terminal."""
    return one_line(f"{row['name']}: {row['verdict']}: {row['error'] or row['says']}")


def _merge(arguments: argparse.Namespace) -> Ended:
    from . import rank, sheet

    if arguments.source is not None:
        raise SettingsError(
            say("{merge} takes no jobs; leave {source} out", merge="--merge", source=arguments.source), ""
        )
    rows = rank.rank_rows(sheet.merge_reports(arguments.merge, arguments.out))
    files = _report_files(arguments, None)
    sheet.write_report(files, rows)
    return [sheet.count_outcomes(rows), *rank.best_lines(rows)], list(files), rows


def _batch(arguments: argparse.Namespace, options: Mapping[str, Any], progress: Progress) -> Ended:
    from . import rank, sheet, work

    jobs, shard, crew = _plan_batch(arguments, options)
    for job in jobs:
        work.check_own(job)
    files = _report_files(arguments, shard)
    ended = {job.stem: outcome for job in jobs if (outcome := work.read_finished(job)) is not None}
    kept = len(ended)
    ended |= _work_jobs([job for job in jobs if job.stem not in ended], crew, progress)
    rows = rank.rank_rows([ended[job.stem].row for job in jobs])
    sheet.write_report(files, rows)
    return [sheet.count_outcomes(rows, kept), *rank.best_lines(rows)], list(files), rows


def _plan_batch(
    arguments: argparse.Namespace, options: Mapping[str, Any]
) -> tuple[list[BatchJob], tuple[int, int] | None, Crew | None]:
    from freecad_fiveaxis.core.base.chunks import PROCESSORS
    from freecad_fiveaxis.core.base.crew import read_workers

    from . import plan
    from .crews import find_crew

    if arguments.source is None:
        raise SettingsError(say("no jobs given; name a folder of parts or a table (JSON)"), None)
    if not os.path.isdir(arguments.source):
        check_readable(arguments.source)
    crew = find_crew(
        arguments.executor, PROCESSORS if arguments.workers is None else read_workers(arguments.workers)
    )
    shard = plan.read_shard(arguments.shard) if arguments.shard else None
    jobs = plan.read_jobs(arguments.source, options, arguments.out, arguments.overwrite)
    jobs = plan.of_shard(jobs, shard) if shard else jobs
    plan.check_files_of(jobs, arguments.source)
    return jobs, shard, crew


def _report_files(arguments: argparse.Namespace, shard: tuple[int, int] | None) -> tuple[str, str, str]:
    """Its places, in a folder that is there now. Raises FiveAxisError."""
    from . import sheet

    try:
        os.makedirs(arguments.out, exist_ok=True)
    except OSError as error:
        raise FileError(
            say(
                "folder {folder} cannot be made: {strerror}; choose another one",
                folder=arguments.out,
                strerror=error.strerror,
            ),
            arguments.out,
        ) from error
    files = sheet.report_files(arguments.out, shard)
    sheet.check_report(files, arguments.overwrite)
    return files


def _work_jobs(jobs: Sequence[BatchJob], crew: Crew | None, progress: Progress) -> dict[str, JobOutcome]:
    """Return the outcomes by the jobs' stems."""
    from freecad_fiveaxis.core.base.crew import end_pool

    from .run import run_batch

    if crew is None or not jobs:
        return {outcome.stem: outcome for outcome in run_batch(jobs, None, progress)}
    pool = crew.open()
    ended: dict[str, JobOutcome] = {}
    try:
        for outcome in run_batch(jobs, pool, progress, crew.open):
            ended[outcome.stem] = outcome
            written.extend(path for path in outcome.files if path not in written)
    except BaseException:
        crew.stop()
        raise
    finally:
        end_pool(pool, wait=False)
    return ended
