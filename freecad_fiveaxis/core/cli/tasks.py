# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands do. The core is imported where it is used."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.files import check_readable, check_writable
from freecad_fiveaxis.core.base.sentences import one_line, say
from freecad_fiveaxis.core.base.terminal import bars, complain, show

if TYPE_CHECKING:
    from freecad_fiveaxis.core.base.findings import Finding
    from freecad_fiveaxis.core.pipeline.settings import Settings

DONE, DONE_WITH_ERRORS = 0, 1


def run_task(arguments: argparse.Namespace) -> int:
    """Do a task with the options that were given. Returns the exit code."""
    from freecad_fiveaxis.core.pipeline.settings import build_settings

    settings = build_settings(arguments.task, getattr(arguments, "source", ""), _options_given(arguments))
    return _run(settings, arguments.quiet, workers=_workers(arguments))


def _workers(arguments: argparse.Namespace) -> int:
    """How many processes are asked for. Raises SettingsError."""
    from freecad_fiveaxis.core.base.crew import read_workers

    given = getattr(arguments, "workers", None)
    return 1 if given is None else read_workers(given)


def _options_given(arguments: argparse.Namespace) -> dict[str, Any]:
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    names = {leaf.name for _, leaf in option_fields(arguments.task)}
    return {
        name.rstrip("_"): value
        for name, value in vars(arguments).items()
        if name in names and value is not None
    }


def run_batch(arguments: argparse.Namespace) -> int:
    """Mill many parts, or do many jobs. Returns the exit code."""
    from freecad_fiveaxis.core.batch import command

    with bars(arguments.quiet) as progress:
        remarks, files, rows = command.act(arguments, _options_given(arguments), progress)
    if not arguments.quiet:
        _show_report([*map(command.line_of, rows), *map(one_line, remarks)], files)
    return DONE_WITH_ERRORS if any(row["error"] or row["errors"] for row in rows) else DONE


def run_file(arguments: argparse.Namespace) -> int:
    """Do what a job file says. Returns the exit code."""
    from freecad_fiveaxis.core.pipeline.job_file import read_job

    check_readable(arguments.source)
    return _run(read_job(arguments.source), arguments.quiet, (arguments.source,))


def _run(settings: Settings, quiet: bool, read: Sequence[str] = (), workers: int = 1) -> int:
    """Do what is asked; ``read``: files that are read already, which no output may be; ``workers``: processes
    for trials."""
    from freecad_fiveaxis.core.pipeline import job, outputs
    from freecad_fiveaxis.core.pipeline.inputs import check_inputs
    from freecad_fiveaxis.core.pipeline.settings import TRIALS, WORKSHOP
    from freecad_fiveaxis.core.report import as_text

    outputs.check_outputs(settings, read)
    if settings.task in WORKSHOP:
        return _work(settings, quiet)
    if settings.task in TRIALS:
        return _try(settings, quiet, workers)
    if settings.task != "audit" and not settings.output.output:
        raise SettingsError(say("no NC file named; give one with -o OUT.ngc"), None)
    check_inputs(settings)
    if not quiet:
        _complain_unused(settings)
    with bars(quiet) as progress:
        result = job.run(settings, progress)
        files = outputs.write_outputs(result, progress)
    if not quiet:
        _show_report([as_text(job.figures(result))], files)
    return _exit_code(result.findings)


def _complain_unused(settings: Settings) -> None:
    from freecad_fiveaxis.core.pipeline.unused_options import find_unused

    for sentence in find_unused(settings):
        complain(f"fiveaxis: {sentence}")


def _try(settings: Settings, quiet: bool, workers: int) -> int:
    from freecad_fiveaxis.core.base.crew import at_work, process_crew
    from freecad_fiveaxis.core.pipeline.inputs import check_inputs
    from freecad_fiveaxis.core.studies import study as trials

    check_inputs(settings)
    if not quiet:
        _complain_unused(settings)
    with bars(quiet) as progress, at_work(process_crew(workers) if workers > 1 else None) as executor:
        trial = trials.run(settings, progress, executor)
        files = trials.write_outputs(trial)
    if not quiet:
        _show_report([trials.as_text(trial)], files)
    return _exit_code(trial.findings)


def _work(settings: Settings, quiet: bool) -> int:
    from freecad_fiveaxis.core.calibration import tasks as workshop
    from freecad_fiveaxis.core.pipeline.inputs import check_inputs

    check_inputs(settings)
    with bars(quiet) as progress:
        done = workshop.run(settings, progress)
        files = workshop.write_outputs(done)
    if not quiet:
        _show_report([workshop.as_text(done)], files)
    return _exit_code(done.findings)


def _exit_code(findings: Sequence[Finding]) -> int:
    errors = any(finding.severity is Severity.ERROR for finding in findings)
    return DONE_WITH_ERRORS if errors else DONE


def _show_report(parts: Sequence[str], written: Sequence[str]) -> None:
    try:
        show("\n".join([*parts, *(f"wrote {one_line(path)}" for path in written)]), sys.stdout)
    except FileError as error:
        raise FileError(
            say(
                "{error}; these files are written: {written}",
                error=error,
                written=", ".join(written) or say("none asked for"),
            ),
            error.value,
        ) from error


def import_file(arguments: argparse.Namespace) -> int:
    """Make a machine file from another program's. Returns the exit code."""
    from freecad_fiveaxis.core.machine.importing import as_text, import_machine, save_imported

    if not arguments.output.lower().endswith(".fcm"):
        raise SettingsError(
            say("machine file {output} needs the ending .fcm", output=arguments.output), arguments.output
        )
    for source in filter(None, (arguments.source, arguments.bodies)):
        check_readable(source)
    check_writable(arguments.output)
    imported = import_machine(arguments.source, arguments.bodies or "")
    written = save_imported(imported, arguments.output)
    if not arguments.quiet:
        _show_report([as_text(imported), *_untaken_model(arguments)], written)
    return _exit_code(imported.findings)


def _untaken_model(arguments: argparse.Namespace) -> Iterator[str]:
    """Name the vismach model that a LinuxCNC configuration starts, where nobody has asked for its bodies. It
    is not taken unasked: what it draws is proven against from then on, and models draw more than machines."""
    from pathlib import Path

    from freecad_fiveaxis.core.machine.importing import find_model

    if arguments.bodies or Path(arguments.source).suffix.lower() != ".ini":
        return
    model = find_model(Path(arguments.source))
    if model is not None:
        yield f"The configuration shows its machine by {model}: --bodies {model} takes its bodies."


def list_machines(arguments: argparse.Namespace) -> int:
    """Show the machines that come with the program. Returns the exit code."""
    from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine

    return _list((name, load_machine(name).description) for name in list_shipped_machines())


def list_controllers(arguments: argparse.Namespace) -> int:
    """Show the controllers. Returns the exit code."""
    from freecad_fiveaxis.core.controllers import DIALECTS

    return _list((name, dialect.description) for name, dialect in DIALECTS.items())


def list_strategies(arguments: argparse.Namespace) -> int:
    """Show the strategies of tool axes and of passes. Returns the exit code."""
    from freecad_fiveaxis.core.orientation.strategies import STRATEGIES
    from freecad_fiveaxis.core.passes import PASS_STRATEGIES

    descriptions = {
        name: (strategy.__doc__ or "").strip() for name, strategy in STRATEGIES.items()
    }  # none where Python left them out (-OO)
    rows = [(name, text.partition("\n")[0]) for name, text in descriptions.items()]
    return _list(
        [*rows, *((f"--passes {name}", strategy.text) for name, strategy in PASS_STRATEGIES.items())]
    )


def _list(rows: Iterable[tuple[str, str]]) -> int:
    show("\n".join(f"{name:24} {text}" for name, text in rows), sys.stdout)
    return DONE
