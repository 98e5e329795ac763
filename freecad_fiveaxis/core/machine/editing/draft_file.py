# SPDX-License-Identifier: LGPL-2.1-or-later
"""A draft as a new machine file: what was changed is written anew, all else stands as it stood.

parents   where order or side of an axis was changed, or one is new, each axis of a side is carried by the one
          before it, from the base outwards.
files     STL files of bodies are named relative to the machine's file where they lie in its folder, else by
          their whole names.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.machine.bodies import FILE, MachineBody
from freecad_fiveaxis.core.machine.bodies_file import write_bodies
from freecad_fiveaxis.core.machine.file_objects import UNLIMITED
from freecad_fiveaxis.core.machine.machine_file import file_bytes

from .draft import AxisDraft, MachineDraft, read_axis_draft

TURNING = {"solution_preference": "shortest", "allow_flip": True, "wrap_strategy": "unwound"}
"""What FreeCAD's Machine editor asks of a rotary axis besides."""
ENDS = {"low": "min", "high": "max"}
"""The limits of an axis, and their keys."""
OPEN = {"max_rate": "max_velocity", "max_acceleration": "max_acceleration"}
"""Values that need not be known, and the keys that an axis then lacks."""


def draft_bytes(draft: MachineDraft, folder: Path | None = None) -> bytes:
    """Return the text of the draft's file in a ``folder``; None: in none that is known."""
    return file_bytes(draft_data(draft, folder))


def draft_data(draft: MachineDraft, folder: Path | None = None) -> dict[str, Any]:
    """Return the objects of the draft's file."""
    data = copy.deepcopy(dict(draft.source))
    machine = data["machine"]
    if machine["name"].strip() != draft.name:
        machine["name"] = draft.name
    if machine.get("description", "") != draft.description:
        machine["description"] = draft.description
    machine["axes"] = _axes_data(draft)
    _write_controller(data, draft.controller)
    extra = data.get("fiveaxis", {})
    extra |= _places(draft, extra)
    if draft.table is None:
        extra.pop("table", None)
    if draft.bodies or extra.get("bodies"):
        extra["bodies"] = _bodies_data(draft, folder)
    if extra:
        data["fiveaxis"] = extra
    return data


def _places(draft: MachineDraft, extra: Mapping[str, Any]) -> dict[str, Any]:
    """Return what of gauge point, origin and table was changed, in the file's unit."""
    found: dict[str, Any] = {}
    for key in ("gauge_point", "origin"):
        new = getattr(draft, key)
        if new != tuple(draft.unit * one for one in extra.get(key, (0.0, 0.0, 0.0))):
            found[key] = [_number(one / draft.unit) for one in new]
    table = extra.get("table")
    if draft.table is not None and (table is None or draft.unit * table != draft.table):
        found["table"] = _number(draft.table / draft.unit)
    return found


def _write_controller(data: dict[str, Any], controller: str) -> None:
    """Name the controller; FreeCAD's post-processor goes with it where it was that of the one before."""
    old = data.get("fiveaxis", {}).get("controller", "")
    if old == controller:
        return
    data.setdefault("fiveaxis", {})["controller"] = controller
    post = data.get("postprocessor")
    if controller and isinstance(post, dict) and post.get("file_name") == old:
        post["file_name"] = controller


def _axes_data(draft: MachineDraft) -> dict[str, Any]:
    found = {axis.letter: axis_data(axis, draft.unit) for axis in draft.axes}
    chained = tuple((axis.letter, axis.side) for axis in draft.axes)
    if chained != draft.order or not all("parent" in axis for axis in found.values()):
        for side in (draft.letters("table")[::-1], draft.letters("head")):
            for place, letter in enumerate(side):
                found[letter] |= {"parent": side[place - 1] if place else None, "sequence": place}
    before = list(draft.source["machine"]["axes"])
    return {
        letter: found[letter]
        for letter in sorted(found, key=lambda one: (before.index(one) if one in before else 9, one))
    }


def axis_data(axis: AxisDraft, unit: float) -> dict[str, Any]:
    """Return the object of an axis, its lengths ``unit`` mm; what carries it is not said."""
    before = read_axis_draft(axis.letter, axis.source, unit) if axis.source else None
    if before is not None and before.rotary != axis.rotary:
        before = None
    data = copy.deepcopy(
        {key: value for key, value in axis.source.items() if axis.rotary or key not in TURNING}
    )
    scale = 1.0 if axis.rotary else unit

    def is_changed(*names: str) -> bool:
        return before is None or any(getattr(before, name) != getattr(axis, name) for name in names)

    if before is None:
        data |= {
            "type": "rotary" if axis.rotary else "linear",
            "limits": {},
            **(TURNING if axis.rotary else {}),
        }
    if is_changed("side"):
        data["role"] = f"{axis.side}_{'rotary' if axis.rotary else 'linear'}"
    if is_changed("direction", "point"):
        data["joint"] = {
            "origin": [_number(one / unit) for one in axis.point],
            "axis": [_number(one) for one in axis.direction],
        }
    _write_numbers(data, axis, [name for name in (*ENDS, *OPEN) if is_changed(name)], scale)
    if axis.rotary and is_changed("wrap"):
        data["wrap_strategy"] = axis.wrap
    return {key: value for key, value in data.items() if key not in OPEN.values() or value is not None}


def _write_numbers(data: dict[str, Any], axis: AxisDraft, names: Sequence[str], scale: float) -> None:
    """Write limits, rate and acceleration of these ``names``, None for what is not known."""
    for name in names:
        value = getattr(axis, name)
        if name in ENDS:
            data["limits"][ENDS[name]] = _limit(value, scale)
        else:
            data[OPEN[name]] = None if value is None else _number(value / scale)


def _limit(value: float, scale: float) -> float:
    return math.copysign(UNLIMITED, value) if math.isinf(value) else _number(value / scale)


def _number(value: float) -> float:
    """Return a number without a sign where it is 0."""
    return value + 0.0


def _bodies_data(draft: MachineDraft, folder: Path | None) -> list[dict[str, Any]]:
    objects = draft.source.get("fiveaxis", {}).get("bodies", [])
    return [_body_data(body, draft, objects, folder) for body in draft.bodies]


def _body_data(
    body: MachineBody, draft: MachineDraft, objects: list[dict[str, Any]], folder: Path | None
) -> dict[str, Any]:
    if body in draft.listed:
        data = copy.deepcopy(objects[draft.listed.index(body)])
    else:
        (data,) = write_bodies([_in_unit(body, draft.unit)])
    return data | ({FILE: file_name(body.file, folder)} if body.shape == FILE else {})


def _in_unit(body: MachineBody, unit: float) -> MachineBody:
    points = tuple((x / unit, y / unit, z / unit) for x, y, z in body.points)
    return replace(
        body, points=points, radii=tuple(one / unit for one in body.radii), clearance=body.clearance / unit
    )


def file_name(file: str, folder: Path | None) -> str:
    """How a machine file in a ``folder`` names the STL ``file`` of a body."""
    path = Path(file)
    if folder is not None and path.is_relative_to(folder.absolute()):
        return path.relative_to(folder.absolute()).as_posix()
    return file
