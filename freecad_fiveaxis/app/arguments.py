# SPDX-License-Identifier: LGPL-2.1-or-later
"""What macros give, looked at before any work: a value of another type is refused by an error that says what
is meant.

Every function gives back what it was given, and raises SelectionError, or FileError for the name of a file.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.quantity import ANGLES, LENGTHS, parse, parse_length, parse_triple
from freecad_fiveaxis.core.base.sentences import Number, say

from .selection import SelectionError


def document(given: Any) -> Any:
    """Return a document."""
    return _with(given, "addObject", say("a document, as FreeCAD.ActiveDocument"))


def setup_map(given: Any) -> Any:
    """Return a map of setups."""
    return _with(given, "RecommendedTurn", say("a setup map"))


def cam_job(given: Any) -> Any:
    """Return a CAM job, or None."""
    return given if given is None else _with(given, "Tools", say("a CAM job"))


def file_name(given: Any) -> Any:
    """Return the name of a file."""
    if isinstance(given, str) or (isinstance(given, os.PathLike) and isinstance(os.fspath(given), str)):
        return given
    raise FileError(
        say("{value} is no name of a file: give a text or a path", value=_show_given(given)), given
    )


def file_name_or_none(given: Any) -> Any:
    """Return the name of a file, or None."""
    return given if given is None else file_name(given)


def objects(given: Any) -> list[Any]:
    """Return objects of a document; a single one may stand by itself, None is none."""
    several = [] if given is None else list(given) if isinstance(given, (tuple, list)) else [given]
    return [_with(one, "Document", say("solids or meshes of the document")) for one in several]


def place(given: Any, name: str) -> tuple[float, float, float]:
    """Return the three numbers (mm) of a place, which are given as such or as a text. Raises
    SettingsError."""
    if not isinstance(given, str) and not hasattr(given, "__len__"):
        raise SettingsError(
            say("{name} {given} needs three numbers, as 0,0,50", name=name, given=repr(given)), given
        )
    return parse_triple(given if isinstance(given, str) else tuple(given), LENGTHS, name)


def deflections(settings: Mapping[str, Any]) -> dict[str, float]:
    """Return the mesher's deflections, mm and **degrees**, as far as given. Raises SettingsError."""
    read = {}
    if settings.get("linear_deflection") is not None:
        read["linear"] = parse_length(settings["linear_deflection"], "linear deflection")
    if settings.get("angular_deflection") is not None:
        read["angular"] = parse(settings["angular_deflection"], ANGLES, "angular deflection") / ANGLES["deg"]
    for name, value in read.items():
        if value <= 0.0:
            raise SettingsError(
                say(
                    "{name} deflection {value} is out of range; it must be above 0",
                    name=name,
                    value=Number(value),
                ),
                value,
            )
    return read


def names(given: Any) -> tuple[str, ...]:
    """Names; a single one may stand by itself."""
    if isinstance(given, str):
        return (given,)
    if isinstance(given, (tuple, list)) and all(isinstance(one, str) for one in given):
        return tuple(given)
    raise refuse(given, say("a list of names"))


def base(given: Any) -> Any:
    """Return an object, by itself or with the names of its faces. What it is is looked at later."""
    if isinstance(given, (tuple, list)) and len(given) == 2:
        names(given[1])
    return given


def files(given: Any) -> Any:
    """Contents of further files by their names, or None."""
    if given is not None and not (
        isinstance(given, Mapping) and all(isinstance(data, bytes) for data in given.values())
    ):
        raise refuse(given, say("file names with their contents as bytes"))
    for name in given or ():
        file_name(name)
    return given


def _with(given: Any, name: str, wanted: str) -> Any:
    try:
        fits = hasattr(given, name)
    except ReferenceError:  # a document that is closed, an object that is deleted
        fits = False
    if not fits:
        raise refuse(given, wanted)
    return given


def refuse(given: Any, wanted: str) -> SelectionError:
    """Return what to say of an argument that is not what is ``wanted``."""
    return SelectionError(
        say("{value} is not what is meant: give {wanted}", value=_show_given(given), wanted=wanted), given
    )


def _show_given(given: Any) -> str:
    label = getattr(given, "Label", None)
    return label if isinstance(label, str) else repr(given)[:60]
