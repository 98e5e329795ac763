# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine files: FreeCAD's own ``.fcm`` (JSON, version 1), in and out, and the machines that come with the
program. What stands in them: :mod:`.file_objects`.
"""

from __future__ import annotations

import json
import os
import re
import reprlib
from collections.abc import Mapping
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.base.files import read_bytes, write_whole
from freecad_fiveaxis.core.base.sentences import ask_for_near, say

from .model import Machine

SUFFIX = ".fcm"
VECTOR = re.compile(r"\[\s*\n([^\[\]{}\"]*)\n\s*\]")
"""A list of numbers that json has spread over lines; a line break never stands inside a string."""


@cache
def list_shipped_machines() -> tuple[str, ...]:
    """Return the names of the machines that come with the program, sorted."""
    return tuple(sorted(path.stem for path in machine_folder().glob("*" + SUFFIX)))


@cache
def machine_folder() -> Path:
    """Where those machines are: in the package when it is installed, beside it in the source tree."""
    package = Path(__file__).resolve().parents[2]
    inside = package / "resources" / "machines"
    return inside if inside.is_dir() else package.parent / "resources" / "machines"


def load_machine(name_or_path: str | os.PathLike[str]) -> Machine:
    """Return the machine of that shipped name, or of that ``.fcm`` file (anything with a folder or the suffix
    is a file).

    Raises MachineError with file, key and remedy for an unknown name or an unusable file, FileError for a
    missing one.
    """
    given = os.fspath(name_or_path)
    if (path := machine_path(given)) is not None:
        return _load_file(path)
    names = list_shipped_machines()
    beside = [given + SUFFIX] if os.path.isfile(given + SUFFIX) else []
    hint = ask_for_near(given + SUFFIX, beside) or ask_for_near(given.lower().replace("-", "_"), names)
    known = say("known: {names}, or give a {suffix} file", names=", ".join(names), suffix=SUFFIX)
    raise MachineError(
        say("no machine is called {given}; {hint}{known}", given=reprlib.repr(given), hint=hint, known=known),
        given,
    )


def machine_path(given: str) -> Path | None:
    """Return the file of a shipped name, or what is given as a file; None for a name that is not known."""
    if given in list_shipped_machines():
        return machine_folder() / (given + SUFFIX)
    return Path(given) if Path(given).suffix.lower() == SUFFIX or os.sep in given or "/" in given else None


def _load_file(path: Path) -> Machine:
    content = read_bytes(_usable(path), "machine file")
    try:
        return _beside(_read(content), path)
    except MachineError as error:
        raise MachineError(say("{path}: {error}", path=path, error=error), error.value) from None


def _beside(machine: Machine, path: Path) -> Machine:
    """Return the machine, the files of its bodies beside its own."""
    if not any(body.file for body in machine.bodies):
        return machine
    return replace(
        machine,
        bodies=tuple(
            replace(body, file=str(path.parent / body.file) if body.file else "") for body in machine.bodies
        ),
    )


@lru_cache(maxsize=64)
def _read(content: bytes) -> Machine:
    """Return a window reads the same few files with every letter that is typed (1.5 ms each); what a file
    says now counts."""
    from .file_objects import read_machine  # here, for lists are to come at once
    from .keys import parse_json

    return read_machine(parse_json(content))


def _usable(path: Path) -> Path:
    if "\0" in str(path):
        raise FileError(
            say("{path} is no file name: it holds a null character", path=repr(str(path))), str(path)
        )
    return path


def save_machine(machine: Machine, path: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Write the machine as a ``.fcm`` file that FreeCAD's Machine editor loads too.

    What FreeCAD needs and a Machine does not hold gets FreeCAD's default. Raises FileError where the file
    exists already (unless ``overwrite``) or cannot be written, MachineError for an axis without a maximum
    rate; then no file is left.
    """
    target = _usable(Path(path))
    data = machine_bytes(machine)
    if not overwrite:
        check_new(target)
    write_whole(target, data)


def machine_bytes(machine: Machine) -> bytes:
    """Return the machine as the text of a ``.fcm`` file. Raises MachineError for an axis without a maximum
    rate."""
    from .file_objects import write_objects

    return file_bytes(write_objects(machine))


def file_bytes(data: Mapping[str, Any]) -> bytes:
    """Return the objects of a machine file as its text, each vector in one line."""
    text = VECTOR.sub(lambda found: "[" + " ".join(found[1].split()) + "]", json.dumps(data, indent=4)) + "\n"
    return text.encode()


def check_new(path: str | os.PathLike[str]) -> None:
    """No machine is lost: raises FileError where the file exists already."""
    if os.path.exists(path):
        raise FileError(say("{target} exists already; choose another name", target=path), os.fspath(path))
