# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters out of FreeCAD's own tools: from a tool bit's file (``.fctb``) and from the tools of a CAM Job.

shape           what FreeCAD calls a tool's kind: ``ballend``, ``endmill``, ``bullnose`` ... In a file it is
                the key ``shape-type`` or the name of the shape file; on a tool in a document the property
                ShapeType (from 1.1), BitShape or ShapeName.
corner radius   of a bull nose. Its files give ``CornerRadius``, older ones ``FlatRadius``, the radius of the
                flat in the middle: corner radius = D/2 - flat radius. A corner radius of D/2 is a ball end.
taper           of a tapered ball nose. ``TaperAngle`` is the angle that both flanks include: twice the
                core's; ``Diameter`` is the ball's.
cutting edge    ``CuttingEdgeHeight``: how far up from the tip the tool cuts; the core's ``Cutter.length``.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path, PureWindowsPath
from typing import Any

from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.tool import Cutter

SUFFIX = ".fctb"
BALLS, FLATS, BULLS, TAPERED = (
    ("ballend", "ballendmill"),
    ("endmill",),
    ("bullnose", "torus"),
    ("taperedballnose",),
)
"""The shapes that are of use here, under all their names; ``ballendmill`` is how the oldest tools spell
it."""
EQUAL_RADIUS_MM = 1e-3
"""mm; a corner radius this near to the radius makes a ball: files give four decimals."""
REMEDY = say(
    "ball ends, end mills, bull noses and tapered ball noses are of use here: choose one, or give the cutter "
    "by hand"
)

LENGTH = say("length; write it as 6 mm or 0.25 in")

Sizes = Callable[[str], "float | None"]
"""A size of the tool, mm or deg, by its name; None where the tool has none of that name."""


@dataclass(frozen=True)
class JobTool:
    """A tool of a CAM Job. ``cutter`` is None where it is of no use here; ``error`` then says why and what
    helps.

    ``feed`` and ``plunge_feed`` mm/min, ``spindle`` 1/min: 0 where the job gives none; ``number`` the tool
    number.
    """

    label: str
    number: int
    cutter: Cutter | None
    error: str = ""
    feed: float = 0.0
    plunge_feed: float = 0.0
    spindle: float = 0.0


def cutter_of_file(path: str | os.PathLike[str]) -> Cutter:
    """Return the cutter of a tool bit's file, mm. Raises FileError for a missing file, SettingsError for one
    of no use here."""
    name = Path(path).name
    bit = _parse_bit(read_bytes(path, "tool bit"), name)
    sizes = bit.get("parameter")
    if not isinstance(sizes, dict):
        raise SettingsError(
            say("{name} lists no sizes; save the tool once more in FreeCAD's tool editor", name=name), path
        )
    shape = bit.get("shape-type") or bit.get("shape") or bit.get("template") or ""
    return _cutter(name, str(shape), lambda key: _size(sizes[key], key, name) if key in sizes else None)


def cutter_of_tool(tool: Any) -> Cutter:
    """Return the cutter of a tool in a document (``job.Tools.Group[i].Tool``), mm. Raises SettingsError for
    one of no use here."""
    shape = next(
        (
            getattr(tool, key)
            for key in ("ShapeType", "BitShape", "ShapeName", "ToolType")
            if getattr(tool, key, "")
        ),
        "",
    )
    label = getattr(tool, "Label", "") or getattr(tool, "Name", "the tool")
    return _cutter(label, shape, lambda key: _number(getattr(tool, key)) if hasattr(tool, key) else None)


def cutters_of_job(job: Any) -> list[JobTool]:
    """Return the tools of a CAM Job in its order, those of no use here with the reason."""
    return [_job_tool(controller) for controller in job.Tools.Group]


def _job_tool(controller: Any) -> JobTool:
    cutter, error = None, ""
    try:
        cutter = cutter_of_tool(controller.Tool)
    except FiveAxisError as unfit:
        error = str(unfit)
    return JobTool(
        label=controller.Label, number=int(controller.ToolNumber), cutter=cutter, error=error,
        feed=_feed(controller.HorizFeed), plunge_feed=_feed(controller.VertFeed),
        spindle=float(controller.SpindleSpeed),
    )  # fmt: skip


def _parse_bit(content: bytes, name: str) -> dict[str, Any]:
    try:
        bit = json.loads(content.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        raise SettingsError(
            say(
                "{name} is no tool bit ({error}); choose a {suffix} file of FreeCAD",
                name=name,
                error=error,
                suffix=SUFFIX,
            ),
            name,
        ) from None
    if not isinstance(bit, dict):
        raise SettingsError(
            say("{name} is no tool bit; choose a {suffix} file of FreeCAD", name=name, suffix=SUFFIX), name
        )
    return bit


def _cutter(name: str, shape: str, size: Sizes) -> Cutter:
    kind = _kind(shape)
    if kind not in BALLS + FLATS + BULLS + TAPERED:
        raise SettingsError(
            say(
                "{name} is a tool of the shape {shape}; {remedy}",
                name=name,
                shape=shape or "(none)",
                remedy=REMEDY,
            ),
            shape,
        )
    if (diameter := size("Diameter")) is None:
        raise SettingsError(
            say("{name} has no diameter; give it one in FreeCAD's tool editor", name=name), name
        )
    given: dict[str, Any] = {"length": edge} if (edge := size("CuttingEdgeHeight")) is not None else {}
    if kind in FLATS:
        given["corner"] = 0.0
    elif kind in BULLS:
        given["corner"] = _corner(name, diameter, size)
    elif kind in TAPERED:
        given["taper"] = _taper(name, size)
    return Cutter(diameter, **given)


def _kind(shape: str) -> str:
    r"""``ballend`` of ``Ballend``, ``ballend.fcstd``, ``C:\shapes\ballend.fcstd`` or ``Ball End``."""
    name = PureWindowsPath(shape).name.lower()  # of the other systems' paths too
    return "".join(letter for letter in name.removesuffix(".fcstd") if letter.isalnum())


def _corner(name: str, diameter: float, size: Sizes) -> float:
    corner, flat = size("CornerRadius"), size("FlatRadius")
    if corner is None:
        if flat is None:
            raise SettingsError(
                say("{name} has no corner radius; give it one in FreeCAD's tool editor", name=name), name
            )
        corner = diameter / 2 - flat
    return diameter / 2 if abs(corner - diameter / 2) <= EQUAL_RADIUS_MM else corner


def _taper(name: str, size: Sizes) -> float:
    """rad, from the axis to the flank."""
    included = size("TaperAngle")
    if included is None:
        raise SettingsError(
            say("{name} has no taper angle; give it one in FreeCAD's tool editor", name=name), name
        )
    return math.radians(included / 2)


def _size(given: Any, key: str, name: str) -> float:
    """mm or deg of a text with a unit, as FreeCAD's own parser reads it (6.0000 mm, 0.25 in, 1/4", 10.0000
    °)."""
    import FreeCAD

    units = FreeCAD.Units
    unit, what = (
        (units.Angle, say("angle; write it as 10 deg")) if key.endswith("Angle") else (units.Length, LENGTH)
    )
    message = say("{name}: {key} {given} is no {what}", name=name, key=key, given=repr(given), what=what)
    try:
        text = (
            given.strip() or "?" if isinstance(given, str) else float(given)
        )  # FreeCAD takes no text at all for 2e-308
        size = units.Quantity(text)
    except (ValueError, TypeError, OSError, ArithmeticError):
        raise SettingsError(message, given) from None
    if size.Unit not in (unit, units.Unit()):
        raise SettingsError(message, given)
    return float(size.Value)


def _number(given: Any) -> float:
    return float(getattr(given, "Value", given))


def _feed(given: Any) -> float:
    """mm/min of FreeCAD's mm/s."""
    return round(60 * _number(given), 9)  # 1000 mm/min is no whole number of mm/s: what was typed comes back
