# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, its options made from :mod:`settings`.

exit 0    done.    exit 1    done, with findings of severity error.    exit 2    the input cannot be used: a message on
stderr, no output file.    exit 130    stopped by the user, no output file.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from freecad_fiveaxis import __version__

from . import job
from .errors import Cancelled, FiveAxisError, SettingsError
from .files import read_bytes
from .findings import Severity
from .machine_file import load_machine, shipped_machines
from .post import DIALECTS
from .report import as_text
from .settings import AUDIT, MILL, POST, TASKS, Settings, build_settings, option_fields
from .terminal import bars
from .tool_axis import STRATEGIES

DONE, DONE_WITH_ERRORS, UNUSABLE, STOPPED = 0, 1, 2, 130
ABOUT = {
    MILL: ("PART.stl", "mill a part: from an STL file to a proven NC program"),
    POST: ("PATH.apt", "post a CL file (APT) to a proven NC program"),
    AUDIT: ("PROGRAM.ngc", "audit a finished NC program of any origin"),
}
SHORT = {"output": ("-o", "--output")}


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit code."""
    arguments = _parser().parse_args(argv)
    try:
        return int(arguments.act(arguments))
    except (KeyboardInterrupt, Cancelled):
        print("stopped; nothing was written", file=sys.stderr)
        return STOPPED
    except FiveAxisError as error:
        print(f"fiveaxis: {error}", file=sys.stderr)
        return UNUSABLE
    except BrokenPipeError:  # the reader of our text went away: no error of ours
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE


def _parser() -> argparse.ArgumentParser:
    top = argparse.ArgumentParser(
        prog="fiveaxis", description="Five-axis tool paths with a proven deviation for every block.",
        epilog="Lengths in mm, angles in deg, or with a unit: 0.5in, 2deg. Feeds in mm/min.",
    )  # fmt: skip
    top.add_argument("--version", action="version", version=__version__)
    commands = top.add_subparsers(required=True, metavar="COMMAND")
    for task, (what, text) in ABOUT.items():
        _add_task(commands.add_parser(task, help=text, description=text), task, what)
    again = commands.add_parser("run", help="run a job file (JSON)", description="run a job file: the options of a task as JSON")
    again.add_argument("source", metavar="JOB.json")
    again.add_argument("--quiet", action="store_true", help="no progress, no report on the terminal")
    again.set_defaults(act=_run_file)
    for name, act in (("machines", _machines), ("controllers", _controllers), ("strategies", _strategies)):
        commands.add_parser(name, help=f"list the {name}").set_defaults(act=act)
    return top


def _add_task(parser: argparse.ArgumentParser, task: str, what: str) -> None:
    parser.add_argument("source", metavar=what)
    for cls, leaf in option_fields(task):
        title = (cls.__doc__ or "").strip().rstrip(".")
        box = next((g for g in parser._action_groups if g.title == title), None) or parser.add_argument_group(title)
        flags = SHORT.get(leaf.name, ("--" + leaf.name.replace("_", "-"),))
        extra = {"action": "append"} if leaf.metadata["kind"] == "paths" else {"choices": leaf.metadata["choices"] or None}
        box.add_argument(*flags, dest=leaf.name, metavar=_metavar(leaf.metadata), help=_help(leaf), **extra)
    parser.add_argument("--quiet", action="store_true", help="no progress, no report on the terminal")
    parser.set_defaults(act=_run_task, task=task)


def _metavar(rules: Any) -> str | None:
    if rules["choices"]:
        return None
    marks = {"length": "MM", "angle": "DEG", "feed": "MM/MIN", "point": "X,Y,Z", "vector": "I,J,K"}
    return marks.get(rules["kind"], str(rules["kind"]).upper())


def _help(leaf: Any) -> str:
    text = str(leaf.metadata["text"]).replace("%", "%%")
    default = leaf.default
    if default in (None, "", ()) or "[" in text:
        return text
    if leaf.metadata["kind"] == "angle":
        default = f"{math.degrees(default):g}"
    elif leaf.metadata["kind"] == "cutter":
        default = f"ball:{default.diameter:g}"
    elif isinstance(default, tuple):
        default = ",".join(f"{part:g}" for part in default)
    return f"{text} [{default}]"


def _run_task(arguments: argparse.Namespace) -> int:
    names = {leaf.name for _, leaf in option_fields(arguments.task)}
    options = {name: value for name, value in vars(arguments).items() if name in names and value is not None}
    return _run(build_settings(arguments.task, arguments.source, options), arguments.quiet)


def _run_file(arguments: argparse.Namespace) -> int:
    return _run(read_job(arguments.source), arguments.quiet)


def read_job(path: str) -> Settings:
    """A job file: ``{"task": "mill", "source": "part.stl", "machine": ..., ...}``; its paths are relative to the file.

    Raises SettingsError where it is no such thing. A report's ``inputs`` are a job file too.
    """
    try:
        given = json.loads(read_bytes(path, "job file"))
    except (ValueError, RecursionError) as error:
        raise SettingsError(f"job file {path} is not JSON: {error}", path) from error
    if not isinstance(given, dict) or given.get("task") not in TASKS or not isinstance(given.get("source"), str):
        raise SettingsError(f'job file {path} needs "task" (one of {", ".join(TASKS)}) and "source", the file to read', path)
    options = {name.replace("-", "_"): value for name, value in given.items() if name not in ("task", "source")}
    settings_paths = {leaf.name for _, leaf in option_fields() if leaf.metadata["kind"] in ("path", "paths")}
    beside = {name: _beside(path, value) if name in settings_paths else value for name, value in options.items()}
    if str(beside.get("machine", "")).endswith(".fcm"):
        beside["machine"] = _beside(path, beside["machine"])
    return build_settings(given["task"], _beside(path, given["source"]), beside)


def _beside(job_file: str, value: Any) -> Any:
    if isinstance(value, list):
        return [_beside(job_file, item) for item in value]
    return os.path.join(os.path.dirname(job_file), value) if isinstance(value, str) else value


def _run(settings: Settings, quiet: bool) -> int:
    job.check_outputs(settings)
    if settings.task != AUDIT and not settings.output.output:
        raise SettingsError("no NC file named; give one with -o OUT.ngc", None)
    if not Path(settings.source).is_file():
        raise SettingsError(f"{settings.source} does not exist; name the file to read", settings.source)
    with bars(quiet) as progress:
        result = job.run(settings, progress)
        written = job.write_outputs(result, progress)
    if not quiet:
        print(as_text(job.figures(result)))
        for path in written:
            print(f"wrote {path}")
    return DONE_WITH_ERRORS if any(finding.severity is Severity.ERROR for finding in result.findings) else DONE


def _machines(arguments: argparse.Namespace) -> int:
    for name in shipped_machines():
        print(f"{name:24} {load_machine(name).description}")
    return DONE


def _controllers(arguments: argparse.Namespace) -> int:
    for name, dialect in DIALECTS.items():
        print(f"{name:24} {dialect.description}")
    return DONE


def _strategies(arguments: argparse.Namespace) -> int:
    for name, strategy in STRATEGIES.items():
        print(f"{name:24} {(strategy.__doc__ or '').strip().splitlines()[0]}")
    return DONE
