# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine files: FreeCAD's own ``.fcm`` (JSON, version 1), in and out, and the machines that come with the
program. What stands in them: :mod:`.file_objects`.
"""

from __future__ import annotations

import difflib
import json
import math
import os
import re
import reprlib
from collections.abc import Callable
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.base.files import read_bytes, write_whole
from freecad_fiveaxis.core.base.sentences import say

from .file_objects import UNLIMITED, VERSION, read_machine
from .keys import JsonObject, parse_json
from .model import Machine
from .safe_start import SafeStart

SUFFIX = ".fcm"
VECTOR = re.compile(r"\[\s*\n([^\[\]{}\"]*)\n\s*\]")
"""A list of numbers that json has spread over lines; a line break never stands inside a string."""

FREECAD_VERSION = "26.3.0"
"""The first version with a Machine editor; its format is what is written."""


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
    near = difflib.get_close_matches(given.lower().replace("-", "_"), names, n=1)
    hint = say("did you mean {near}? ", near=near[0]) if near else ""
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
    return file_bytes(_data(machine))


def file_bytes(data: JsonObject) -> bytes:
    """Return the objects of a machine file as its text, each vector in one line."""
    text = VECTOR.sub(lambda found: "[" + " ".join(found[1].split()) + "]", json.dumps(data, indent=4)) + "\n"
    return text.encode()


def check_new(path: str | os.PathLike[str]) -> None:
    """No machine is lost: raises FileError where the file exists already."""
    if os.path.exists(path):
        raise FileError(say("{target} exists already; choose another name", target=path), os.fspath(path))


def _data(machine: Machine) -> dict[str, Any]:
    return {
        "freecad_version": FREECAD_VERSION,
        "machine": {
            "name": machine.name,
            "manufacturer": "",
            "description": machine.description,
            "units": "metric",
            "kinematics": {
                "base_frame": {"origin": [0, 0, 0], "orientation_quaternion": [0, 0, 0, 1]},
                "tcp_supported": False,
            },
            "axes": {
                letter: _axis_data(machine, letter)
                for letter in sorted(axis.letter for axis in machine.fitted)
            },
            "toolheads": [{"id": "toolhead1", "name": "Spindle", "toolhead_type": "rotary"}],
        },
        "output": {"units": "metric"},
        "postprocessor": {"file_name": machine.controller or "linuxcnc", "properties": {}},
        "processing": {"tool_change": True},
        "version": VERSION,
        "fiveaxis": {
            "gauge_point": list(machine.gauge_point),
            "origin": list(machine.origin),
            "singular_cone": _degrees(machine.singular_cone),
            "controller": machine.controller,
            "safe_start": _safe_start_data(machine.safe_start),
            **({"rapids": machine.rapids} if machine.rapids else {}),
            **({} if machine.table is None else {"table": machine.table}),
            **({"bodies": _bodies_data(machine)} if machine.bodies else {}),
            **({"no_motion": list(machine.no_motion)} if machine.no_motion else {}),
        },
    }


def _bodies_data(machine: Machine) -> list[dict[str, Any]]:
    from .bodies_file import write_bodies

    return write_bodies(machine.bodies)


def _safe_start_data(start: SafeStart) -> dict[str, Any]:
    return {"retract": start.retract} | ({} if start.z is None else {"Z": start.z})


def _axis_data(machine: Machine, letter: str) -> dict[str, Any]:
    axis = machine.axes[machine.letters.index(letter)]
    if math.isinf(axis.max_rate):
        raise MachineError(
            say("axis {letter} has no maximum rate; give one, the machine file needs it", letter=letter),
            letter,
        )
    outwards = [other.letter for other in machine.fitted if other.side == axis.side]
    outwards = outwards[::-1] if axis.side == "table" else outwards
    place = outwards.index(letter)
    in_file: Callable[[float], float] = _degrees if axis.rotary else float
    data = {
        "type": "rotary" if axis.rotary else "linear",
        "role": f"{axis.side}_{'rotary' if axis.rotary else 'linear'}",
        "parent": outwards[place - 1] if place else None,
        "sequence": place,
        "joint": {"origin": list(axis.point), "axis": list(axis.direction)},
        "limits": {"min": max(in_file(axis.low), -UNLIMITED), "max": min(in_file(axis.high), UNLIMITED)},
        "max_velocity": in_file(axis.max_rate),
    }
    if not math.isinf(axis.max_acceleration):
        data["max_acceleration"] = in_file(axis.max_acceleration)
    if axis.rotary:
        data.update(solution_preference="shortest", allow_flip=True, wrap_strategy=axis.wrap)
    return data


def _degrees(radians: float) -> float:
    """Return the shortest number of degrees that is read back as exactly these radians, where there is
    one."""
    degrees = math.degrees(radians)
    if math.isinf(degrees):
        return degrees
    beside = [math.nextafter(degrees, way) for way in (-math.inf, math.inf)]
    for candidate in (*(round(degrees, digits) for digits in range(15)), degrees, *beside):
        if math.radians(candidate) == radians:
            return candidate
    return degrees
