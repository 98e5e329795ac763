# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, its options made from :mod:`.pipeline.settings`.

exit 0    done.
exit 1    done, with findings of severity error.
exit 2    the input cannot be used: a message on stderr, no output file; or the report cannot be shown: the
          message says which files are written.
exit 3    a fault of the program or of its surroundings (memory that ran out): one line says where to report
          it. With FIVEAXIS_TRACEBACK in the environment, Python's traceback comes before it.
exit 130  stopped by SIGINT (Ctrl-C); 143 by SIGTERM, 129 by SIGHUP. The message says whether the outputs are
          written.

The core is imported where it is used: numpy takes its time to load, and the user may stop that as well.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import sys
import traceback
import warnings
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, Any, NoReturn

from freecad_fiveaxis import __version__
from freecad_fiveaxis.core.base import signals
from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.files import check_readable, check_writable, written
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.base.sentences import Option, one_line, say
from freecad_fiveaxis.core.base.terminal import bars, show

if TYPE_CHECKING:
    from freecad_fiveaxis.core.pipeline.settings import Settings

DONE, DONE_WITH_ERRORS, UNUSABLE, FAULT, STOPPED = 0, 1, 2, 3, 130
REQUIRED = ("numpy", "scipy")
"""Packages without which nothing is computed."""
REPORT_TO = "https://github.com/freecad-fiveaxis/freecad-fiveaxis/issues"
"""Where faults are told, as package.xml says."""
TRACEBACK = "FIVEAXIS_TRACEBACK"
"""The environment variable that asks for tracebacks; empty is as good as not set."""
ABOUT = {
    "mill": ("PART.stl", "mill a part: from an STL file to a proven NC program"),
    "post": ("PATH.apt", "post a CL file (APT) to a proven NC program"),
    "audit": ("PROGRAM.ngc", "audit a finished NC program of any origin"),
    "setup": ("PART.stl|PATH.apt", "find out where on the table the part should stand"),
    "compare": ("PART.stl|PATH.apt", "compare machines and cures on one and the same path"),
    "reach": ("PART.stl", "map where on a part the tool gets at all, and what is in the way elsewhere"),
    "recover": (
        "PATH.apt",
        "recover a machine's offsets and signs from a CL file and the program posted from it",
    ),
    "prove-signs": ("", "make a short safe program and a sheet that show a wrong sign before it cuts"),
}
SHORT = {"output": ("-o", "--output"), "machine_file": ("-o", "--output")}
SECOND = {"program": "PROGRAM.ngc"}
"""Options that are given as a second file, without a name."""
NEGATIVE = re.compile(r"-\.?\d")
"""How a value begins that is less than 0; no option does."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit code."""
    if argv is not None:
        return _run_command(argv)
    try:  # a process of its own
        signals.watch(_complain_stopped)
        keep_freed_memory()
        if not sys.warnoptions:  # warnings are for developers; findings say what a user should know
            warnings.simplefilter("ignore")
        return _run_command(sys.argv[1:])
    except KeyboardInterrupt as stop:  # while the outcome was told
        return signals.exit_code(stop)
    finally:
        signals.unwatch()


def _run_command(argv: Sequence[str]) -> int:
    """Return the exit code; what went wrong is told in one line."""
    written.clear()
    try:
        words = _with_negative_values(_with_bare_options(_with_current_flags(argv)))
        arguments = _parser().parse_args(words)
        return int(arguments.act(arguments))
    except (KeyboardInterrupt, Cancelled) as stop:
        return _report_stop(stop)
    except FiveAxisError as error:
        _complain(f"fiveaxis: {error}")
        return UNUSABLE
    except Exception as fault:
        signal = (
            signals.find_signal()
        )  # what a module that is being loaded makes of a signal may be an ImportError
        if signal is not None:
            return _report_stop(signal)
        return (
            _without(fault)
            if isinstance(fault, ModuleNotFoundError) and fault.name in REQUIRED
            else _report_fault(fault)
        )


def _report_stop(stop: BaseException) -> int:
    signals.tell(_complain_stopped)
    return signals.exit_code(stop)


def _complain_stopped() -> None:
    _complain(f"stopped; written before: {', '.join(written)}" if written else "stopped; nothing was written")


def _without(missing: ModuleNotFoundError) -> int:
    """Return a package that is needed is not installed for this Python: what to type, in one line."""
    _complain(
        f"fiveaxis: {missing.name} is not installed for {sys.executable}: "
        f"`{os.path.basename(sys.executable)} -m pip install "
        f"{' '.join(REQUIRED)}`, or Debian's python3-{missing.name}"
    )
    return UNUSABLE


def _report_fault(fault: Exception) -> int:
    """Return a fault of ours, in one line."""
    if os.environ.get(TRACEBACK):
        _show_error("".join(traceback.format_exception(fault)).rstrip())
    place = traceback.extract_tb(fault.__traceback__)[-1]
    kind = "out of memory" if isinstance(fault, MemoryError) else "fault of the program"
    what = ": ".join(part for part in (type(fault).__name__, str(fault)) if part)
    _complain(
        f"fiveaxis: {kind}: {what} ({os.path.basename(place.filename)} line {place.lineno}); "
        + (f"written before: {', '.join(written)}; " if written else "nothing was written; ")
        + f"please report it with the command and its files at {REPORT_TO} ({TRACEBACK}=1 shows more)"
    )
    return FAULT


def _with_current_flags(argv: Sequence[str]) -> list[str]:
    """Return the words, former names of options replaced by those of today; one line on stderr says so,
    unless all is to be quiet."""
    from freecad_fiveaxis.core.pipeline.settings import RENAMED

    now, words = {flag_of(old): flag_of(new) for old, new in RENAMED.items()}, list(argv)
    for at, word in enumerate(argv):
        flag, sign, value = word.partition("=")
        if flag in now:
            words[at] = now[flag] + sign + value
            if "--quiet" not in argv:
                _complain(f"fiveaxis: {flag} is called {now[flag]} now; the old name is taken as before")
    return words


def _with_bare_options(argv: Sequence[str]) -> list[str]:
    """Options that may stand without a value, followed by something that is none: with the value that they
    then mean."""
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    bare = {flag_of(leaf.name): leaf.metadata for _, leaf in option_fields() if leaf.metadata["bare"]}
    following = [*argv[1:], ""]
    return [
        f"{word}={bare[word]['bare']}" if word in bare and after not in bare[word]["choices"] else word
        for word, after in zip(argv, following, strict=True)
    ]


def _with_negative_values(argv: Sequence[str]) -> list[str]:
    """Return the words, values that begin with a minus joined to the option before them: argparse takes a
    single number for a value, and ``-30,0,5`` or ``-2deg`` for an option."""
    words = list[str]()
    for word in argv:
        before = words[-1] if words else ""
        if NEGATIVE.match(word) and before.startswith("--") and "=" not in before:
            words[-1] = f"{before}={word}"
        else:
            words.append(word)
    return words


def flag_of(name: str) -> str:
    """Return the flag of a field of the settings."""
    return str(Option(name))


def _complain(line: str) -> None:
    _show_error(one_line(line))


def _show_error(text: str) -> None:
    with suppress(FileError):  # where stderr cannot be written, the exit code is all that is left
        show(text, sys.stderr)


class _Parser(argparse.ArgumentParser):
    """Whose message is one line, whatever words were given."""

    def error(self, message: str) -> NoReturn:
        super().error(one_line(message))


def _parser() -> argparse.ArgumentParser:
    top = _Parser(
        prog="fiveaxis", description="Five-axis tool paths with a proven deviation for every block.",
        epilog="Lengths in mm, angles in deg, or with a unit: 0.5in, 2deg. Feeds in mm/min.",
    )  # fmt: skip
    top.add_argument("--version", action="version", version=__version__)
    commands = top.add_subparsers(required=True, metavar="COMMAND")
    for task, (what, text) in ABOUT.items():
        _add_task(commands.add_parser(task, help=text, description=text), task, what)
    again = commands.add_parser(
        "run", help="run a job file (JSON)", description="run a job file: the options of a task as JSON"
    )
    again.add_argument("source", metavar="JOB.json")
    again.add_argument("--quiet", action="store_true", help="no progress, no report on the terminal")
    again.set_defaults(act=_run_file)
    _add_batch(commands)
    _add_import(commands)
    for name, act in (("machines", _machines), ("controllers", _controllers), ("strategies", _strategies)):
        commands.add_parser(name, help=f"list the {name}").set_defaults(act=act)
    return top


def _add_import(commands: Any) -> None:
    text = (
        "make a machine file from a LinuxCNC configuration, a URDF file or a file of FreeCAD's Machine editor"
    )
    parser = commands.add_parser("import-machine", help=text, description=text)
    parser.add_argument("source", metavar="CONFIG.ini|ROBOT.urdf|MACHINE.fcm")
    parser.add_argument(
        "-o",
        "--output",
        metavar="OUT.fcm",
        required=True,
        help="the machine file to write; no file is overwritten",
    )
    parser.add_argument(
        "--bodies",
        metavar="MODEL.py",
        help="bodies from the vismach model of the configuration; it is read, never run",
    )
    parser.add_argument("--quiet", action="store_true", help="no table on the terminal")
    parser.set_defaults(act=_import_machine)


def _add_batch(commands: Any) -> None:
    from freecad_fiveaxis.core.batch import command

    parser = commands.add_parser("batch", help=command.TEXT, description=command.TEXT)
    command.add_arguments(parser)
    _add_options(parser, "mill", without=command.NAMED_HERE)
    parser.set_defaults(act=_batch, task="mill")


def _add_task(parser: argparse.ArgumentParser, task: str, what: str) -> None:
    from freecad_fiveaxis.core.pipeline.settings import TRIALS

    if what:
        parser.add_argument("source", metavar=what)
    if task in TRIALS:
        parser.add_argument(
            "--workers", metavar="N", help="so many processes work on it; the result is the same [1]"
        )
    _add_options(parser, task)
    parser.set_defaults(act=_run_task, task=task)


def _add_options(parser: argparse.ArgumentParser, task: str, without: Sequence[str] = ()) -> None:
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    for cls, leaf in option_fields(task):
        if leaf.name in without:
            continue
        title = (
            cls.__name__ if sys.flags.optimize > 1 else (cls.__doc__ or "").strip().rstrip(".")
        )  # -OO: no docstrings
        if leaf.name in SECOND:
            parser.add_argument(leaf.name, metavar=SECOND[leaf.name])
            continue
        box = next((g for g in parser._action_groups if g.title == title), None) or parser.add_argument_group(
            title
        )
        flags = SHORT.get(leaf.name, (flag_of(leaf.name),))
        many = leaf.metadata["kind"] in ("paths", "names")
        extra = {"action": "append"} if many else {"choices": leaf.metadata["choices"] or None}
        box.add_argument(*flags, dest=leaf.name, metavar=_metavar(leaf), help=_help(leaf), **extra)
    parser.add_argument("--quiet", action="store_true", help="no progress, no report on the terminal")


def _metavar(leaf: Any) -> str | None:
    rules = leaf.metadata
    if rules["choices"]:
        return None
    marks = {
        "length": "MM",
        "height": "MM",
        "angle": "DEG",
        "feed": "MM/MIN",
        "point": "X,Y,Z",
        "lengths": "X,Y,Z",
        "vector": "I,J,K",
        "counts": "NX,NY,NZ",
        "place": f"{leaf.default}|X,Y,Z" + ("|CURVE.csv" if leaf.default == "border" else ""),
        "stack": "DxL,...",
    }
    return marks.get(rules["kind"], str(rules["kind"]).upper())


CUTTERS = (
    "KIND:SIZES, as ball:10, flat:0.5in, bull:10:2 (corner), taperball:6:5deg, taperbull:10:2:5deg, "
    "lollipop:10:6 (neck) or barrel:10:85:2 (flank, tip); :LENGTH may follow"
)


def _help(leaf: Any) -> str:
    text = str(leaf.metadata["text"]).replace("%", "%%")
    default = leaf.default
    if default in (None, "", ()) or "[" in text:
        return text
    if leaf.metadata["kind"] == "angle":
        default = f"{math.degrees(default):g}"
    elif leaf.metadata["kind"] == "cutter":
        text, default = CUTTERS, f"ball:{default.diameter:g}"
    elif isinstance(default, tuple):
        default = ",".join(f"{part:g}" for part in default)
    return f"{text} [{default}]"


def _run_task(arguments: argparse.Namespace) -> int:
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


def _batch(arguments: argparse.Namespace) -> int:
    from freecad_fiveaxis.core.batch import command

    with bars(arguments.quiet) as progress:
        remarks, files, rows = command.act(arguments, _options_given(arguments), progress)
    if not arguments.quiet:
        _show_report([*map(command.line_of, rows), *map(one_line, remarks), *_wrote(files)], files)
    return DONE_WITH_ERRORS if any(row["error"] or row["errors"] for row in rows) else DONE


def _run_file(arguments: argparse.Namespace) -> int:
    from freecad_fiveaxis.core.pipeline.job_file import read_job

    return _run(read_job(arguments.source), arguments.quiet, (arguments.source,))


def _run(settings: Settings, quiet: bool, read: Sequence[str] = (), workers: int = 1) -> int:
    """Do what is asked; ``read``: files that are read already, which no output may be; ``workers``: processes
    for trials."""
    from freecad_fiveaxis.core.pipeline import job, outputs
    from freecad_fiveaxis.core.pipeline.settings import TRIALS, WORKSHOP
    from freecad_fiveaxis.core.report import as_text

    outputs.check_outputs(settings, read)
    if settings.task in WORKSHOP:
        return _work(settings, quiet)
    if settings.task in TRIALS:
        return _try(settings, quiet, workers)
    if settings.task != "audit" and not settings.output.output:
        raise SettingsError(say("no NC file named; give one with -o OUT.ngc"), None)
    check_readable(settings.source)
    with bars(quiet) as progress:
        result = job.run(settings, progress)
        files = outputs.write_outputs(result, progress)
    if not quiet:
        _show_report([as_text(job.figures(result)), *_wrote(files)], files)
    return (
        DONE_WITH_ERRORS if any(finding.severity is Severity.ERROR for finding in result.findings) else DONE
    )


def _try(settings: Settings, quiet: bool, workers: int) -> int:
    from freecad_fiveaxis.core.base.crew import at_work, process_crew
    from freecad_fiveaxis.core.studies import study as trials

    check_readable(settings.source)
    with bars(quiet) as progress, at_work(process_crew(workers) if workers > 1 else None) as executor:
        trial = trials.run(settings, progress, executor)
        files = trials.write_outputs(trial)
    if not quiet:
        _show_report([trials.as_text(trial), *_wrote(files)], files)
    return DONE_WITH_ERRORS if any(finding.severity is Severity.ERROR for finding in trial.findings) else DONE


def _work(settings: Settings, quiet: bool) -> int:
    from freecad_fiveaxis.core.calibration import tasks as workshop

    with bars(quiet) as progress:
        done = workshop.run(settings, progress)
        files = workshop.write_outputs(done)
    if not quiet:
        _show_report([workshop.as_text(done), *_wrote(files)], files)
    return DONE_WITH_ERRORS if any(finding.severity is Severity.ERROR for finding in done.findings) else DONE


def _wrote(files: Iterable[str]) -> Iterator[str]:
    return (f"wrote {one_line(path)}" for path in files)


def _show_report(parts: Sequence[str], written: Sequence[str]) -> None:
    try:
        show("\n".join(parts), sys.stdout)
    except FileError as error:
        raise FileError(
            say(
                "{error}; these files are written: {written}",
                error=error,
                written=", ".join(written) or say("none asked for"),
            ),
            error.value,
        ) from error


def _import_machine(arguments: argparse.Namespace) -> int:
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
        _show_report([as_text(imported), *_untaken_model(arguments), *_wrote(written)], written)
    return (
        DONE_WITH_ERRORS if any(finding.severity is Severity.ERROR for finding in imported.findings) else DONE
    )


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


def _machines(arguments: argparse.Namespace) -> int:
    from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine

    return _list((name, load_machine(name).description) for name in list_shipped_machines())


def _controllers(arguments: argparse.Namespace) -> int:
    from freecad_fiveaxis.core.controllers import DIALECTS

    return _list((name, dialect.description) for name, dialect in DIALECTS.items())


def _strategies(arguments: argparse.Namespace) -> int:
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
