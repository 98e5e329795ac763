# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which Python works beside FreeCAD. ``sys.executable`` is not one: there it is FreeCAD itself, or empty.

around     where this FreeCAD lies, asked for in the window's thread; the rest may be done in any.
candidate  a Python that by its place belongs to this FreeCAD: that of the system (Debian), of the bundle
           (macOS: ``Contents/Resources/bin``), of the mounted image (AppImage: ``usr/bin``), of the folder
           (Windows: ``bin``, conda: the prefix). What is elsewhere on PATH is somebody else's.
proven     run once, it has said the versions that compute here (``worker.identity``).

Where there is no such Python a FreeCAD without a window does; where there is none of that either, there is no
worker.
"""

from __future__ import annotations

import contextlib
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from freecad_fiveaxis.core.base.worker import MARK, identity
from freecad_fiveaxis.core.base.workers import Command, python_code, start

PROOF = 20.0
"""s that a candidate gets to say its versions: numpy and scipy come from a cold disk the first time."""
PYTHON = re.compile(r"python(\d+(\.\d+)?)?(\.exe)?", re.IGNORECASE)


@dataclass(frozen=True)
class Around:
    """``home``: FreeCAD's own folder. ``without_window``: a FreeCAD without a window, or empty. ``version``:
    of this Python."""

    home: str
    without_window: str = ""
    system: str = sys.platform
    executables: tuple[str, ...] = field(
        default_factory=lambda: (sys.executable or "", getattr(sys, "_base_executable", None) or "")
    )
    prefixes: tuple[str, ...] = field(default_factory=lambda: (sys.prefix, sys.base_prefix, sys.exec_prefix))
    version: tuple[int, int] = (sys.version_info[0], sys.version_info[1])


def candidates(around: Around) -> list[Path]:
    """Return the Pythons there are, the likeliest first; each once, and never a FreeCAD."""
    beside = [Path(one) for one in around.executables if one]
    found = [one for one in beside if PYTHON.fullmatch(one.name)]
    found += [folder / name for folder in _folders(around, beside) for name in _names(around)]
    return [one for one in dict.fromkeys(found) if one.is_file() and os.access(one, os.X_OK)]


def _names(around: Around) -> tuple[str, ...]:
    major, minor = around.version
    return (
        ("python.exe",)
        if around.system == "win32"
        else (f"python{major}.{minor}", f"python{major}", "python")
    )


def _folders(around: Around, beside: list[Path]) -> list[Path]:
    roots = [Path(one) for one in (*around.prefixes, around.home) if one]
    own = [one.parent for one in beside]
    if around.system == "win32":
        return [*roots, *(root / "bin" for root in roots), *own]
    bundles = [folder.parent / "Resources" / "bin" for folder in own] if around.system == "darwin" else []
    return [*(root / "bin" for root in roots), *bundles, *own]


def find_worker(around: Around, folder: str) -> Command | None:
    """How a worker is started, or None. ``folder``: for what a FreeCAD without a window reads and writes; it
    stays as long as the workers do. Takes a second or two the first time; not for the window's thread."""
    if around not in _proven:
        _proven[around] = next(filter(None, map(_prove_python, candidates(around))), "") or _prove_freecad(
            around
        )
    program = _proven[around]
    if not program:
        return None
    return (
        freecad_command(program, folder, "serve")
        if program == around.without_window
        else python_command(program, "serve")
    )


def has_no_worker(around: Around) -> bool:
    """Whether it is known that there is none."""
    return _proven.get(around) == ""


_proven: dict[Around, str] = {}
"""The program that was proven, empty: none. It does not change while FreeCAD runs."""


def python_command(python: str, call: str) -> Command:
    """``call``: a function of ``core.base.worker``."""
    return Command((python, "-c", python_code(call)))


def freecad_command(program: str, folder: str, call: str) -> Command:
    """Return the same of a FreeCAD, which wants a file, and is told that it is a new user's: no other add-on
    is loaded."""
    script = Path(folder) / f"{call}.py"
    script.write_text(python_code(call), encoding="utf-8")
    return Command((program, str(script)), {"FREECAD_USER_HOME": folder, "QT_QPA_PLATFORM": "offscreen"})


def _prove_python(python: Path) -> str:
    return str(python) if is_proven(python_command(str(python), "show_identity")) else ""


def _prove_freecad(around: Around) -> str:
    if not around.without_window:
        return ""
    with scratch() as folder:
        proof = freecad_command(around.without_window, folder, "show_identity")
        return around.without_window if is_proven(proof) else ""


def is_proven(command: Command, limit: float = PROOF) -> bool:
    """Whether what is started so says in time the versions that are ours; it has ended then."""
    try:
        process = start(command)
    except OSError:
        return False
    try:
        output, _ = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        return False
    finally:
        process.kill()
        process.communicate()
    return MARK + identity().encode() + MARK in output


@contextlib.contextmanager
def scratch() -> Iterator[str]:
    """Yield a folder that is gone afterwards; Windows may keep what a process that was just killed had
    open."""
    with tempfile.TemporaryDirectory(prefix="fiveaxis", ignore_cleanup_errors=True) as folder:
        yield folder
