# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where fixtures stand, as it is written behind the file: ``vise.stl@X,Y,Z`` or ``vise.stl@X,Y,Z,RX,RY,RZ``.

place     of the file's zero, mm in the work frame, and its right-handed turns about the X, then the Y, then
          the Z of the work frame, degrees: the order of a URDF file's rpy. A point p of the file stands at
          ``turn @ p + shift``.
name      may hold an ``@`` itself: a text that is the name of a file there is, and what ends in ``.stl`` or
          goes on to another folder, has no place behind it.
"""

from __future__ import annotations

import math
import os
import re
from typing import NamedTuple

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.quantity import parse_angle, parse_length
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Option, say
from freecad_fiveaxis.core.base.vectors import turn_about_fixed_axes
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces

MARK = "@"
"""Between a fixture's file and its place."""
FARTHEST = 1e5
"""mm; no fixture stands farther from the work zero."""
WIDEST = 2.0 * math.pi
"""rad; more than a whole turn is a slip of the pen."""
NAME_GOES_ON = re.compile(r"[/\\]|\.stl$", re.IGNORECASE)
"""In what follows an ``@``: it belongs to the name."""


class FixtureFile(NamedTuple):
    """``path`` of the STL file; ``place``: what is written of where it stands, without blanks, "" for
    nothing; ``shift`` mm and ``turns`` rad about X, Y and Z."""

    path: str
    place: str = ""
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turns: tuple[float, float, float] = (0.0, 0.0, 0.0)

    @property
    def name(self) -> str:
        """The file's name, with the place that tells two of one file apart."""
        return os.path.basename(self.path) + (f"{MARK}{self.place}" if self.place else "")


def parse_fixture(text: str) -> FixtureFile:
    """Return file and place of a fixture. Raises SettingsError that names what is no place."""
    path, mark, place = text.rpartition(MARK)
    if not (mark and path) or NAME_GOES_ON.search(place) or os.path.exists(text):
        return FixtureFile(text)
    parts = place.split(",")
    try:
        numbers = [*map(parse_length, parts[:3]), *map(parse_angle, parts[3:])]
    except SettingsError:
        numbers = []
    if len(numbers) not in (3, 6):
        raise _no_place(text, place)
    _check_range(text, numbers)
    x, y, z, about_x, about_y, about_z = (numbers + [0.0, 0.0, 0.0])[:6]
    return FixtureFile(path, "".join(place.split()), (x, y, z), (about_x, about_y, about_z))


def _no_place(text: str, place: str) -> SettingsError:
    return SettingsError(
        say(
            "{option} {text}: {place} is no place; write X,Y,Z in mm behind the @, or X,Y,Z,RX,RY,RZ in mm "
            "and degrees, as vise.stl@10,0,-20 or vise.stl@10,0,-20,0,0,90",
            option=Option("fixture"), text=repr(text), place=repr(place),
        ),
        text,
    )  # fmt: skip


def _check_range(text: str, numbers: list[float]) -> None:
    """Raise SettingsError for what is no place of a machine: ``numbers`` (3,) or (6,) mm and rad."""
    if max(map(abs, numbers[:3])) > FARTHEST or max(map(abs, numbers[3:]), default=0.0) > WIDEST:
        raise SettingsError(
            say(
                "{option} {text}: the place is out of range; give X,Y,Z of at most 100000 mm and angles of "
                "at most 360 degrees",
                option=Option("fixture"), text=repr(text),
            ),
            text,
        )  # fmt: skip


def place_mesh(mesh: Mesh, file: FixtureFile) -> Mesh:
    """Return the mesh, mm as in its file, where it stands in the work frame; the very one where no place is
    given. Raises MeshError for what ends up beyond what a mesh can hold."""
    if not any((*file.shift, *file.turns)):
        return mesh
    turn: Floats = turn_about_fixed_axes(*file.turns)
    return from_faces(mesh.vertex @ turn.T + file.shift, mesh.face)
