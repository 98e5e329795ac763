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
from collections.abc import Sequence
from typing import Any, NoReturn

from freecad_fiveaxis import __version__
from freecad_fiveaxis.core.base import signals
from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.base.files import written
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.base.sentences import Option, one_line
from freecad_fiveaxis.core.base.terminal import complain, show_error

from . import tasks

UNUSABLE, FAULT, STOPPED = 2, 3, 130
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
        parser = _parser()
        parser.words = words
        arguments = parser.parse_args(words)
        return int(arguments.act(arguments))
    except (KeyboardInterrupt, Cancelled) as stop:
        return _report_stop(stop)
    except FiveAxisError as error:
        complain(f"fiveaxis: {error.name_file()}")
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
    complain(f"stopped; written before: {', '.join(written)}" if written else "stopped; nothing was written")


def _without(missing: ModuleNotFoundError) -> int:
    """Return a package that is needed is not installed for this Python: what to type, in one line."""
    complain(
        f"fiveaxis: {missing.name} is not installed for {sys.executable}: "
        f"`{os.path.basename(sys.executable)} -m pip install "
        f"{' '.join(REQUIRED)}`, or Debian's python3-{missing.name}"
    )
    return UNUSABLE


def _report_fault(fault: Exception) -> int:
    """Return a fault of ours, in one line."""
    if os.environ.get(TRACEBACK):
        show_error("".join(traceback.format_exception(fault)).rstrip())
    place = traceback.extract_tb(fault.__traceback__)[-1]
    kind = "out of memory" if isinstance(fault, MemoryError) else "fault of the program"
    what = ": ".join(part for part in (type(fault).__name__, str(fault)) if part)
    complain(
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
                complain(f"fiveaxis: {flag} is called {now[flag]} now; the old name is taken as before")
    return words


def _with_bare_options(argv: Sequence[str]) -> list[str]:
    """Options that may stand without a value, followed by something that is none: with the value that they
    then mean."""
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    bare = {flag_of(leaf.name): leaf.metadata for _, leaf in option_fields() if leaf.metadata["bare"]}
    following = [*argv, ""][1:]
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


class _Parser(argparse.ArgumentParser):
    """Whose message is one line, whatever ``words`` were given, and names what was meant; how it is used is
    shown where no word was given at all."""

    words: Sequence[str] = ()

    def error(self, message: str) -> NoReturn:
        if not self.words and "COMMAND" in message:
            super().error(one_line(message))
        from .mistyped import correct, find_commands  # only who mistypes waits for it

        meant = correct(message, find_commands(self), self.words)
        complain(f"{self.prog}: error: {one_line(message)}{meant}")
        self.exit(UNUSABLE)


def _parser() -> _Parser:
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
    again.set_defaults(act=tasks.run_file)
    _add_batch(commands)
    _add_import(commands)
    for name, act in (
        ("machines", tasks.list_machines),
        ("controllers", tasks.list_controllers),
        ("strategies", tasks.list_strategies),
    ):
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
    parser.set_defaults(act=tasks.import_file)


def _add_batch(commands: Any) -> None:
    from freecad_fiveaxis.core.batch import command

    parser = commands.add_parser("batch", help=command.TEXT, description=command.TEXT)
    command.add_arguments(parser)
    _add_options(parser, "mill", without=command.NAMED_HERE)
    parser.set_defaults(act=tasks.run_batch, task="mill")


def _add_task(parser: argparse.ArgumentParser, task: str, what: str) -> None:
    from freecad_fiveaxis.core.pipeline.settings import TRIALS

    if what:
        parser.add_argument("source", metavar=what)
    if task in TRIALS:
        parser.add_argument(
            "--workers", metavar="N", help="so many processes work on it; the result is the same [1]"
        )
    _add_options(parser, task)
    parser.set_defaults(act=tasks.run_task, task=task)


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
