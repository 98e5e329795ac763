# SPDX-License-Identifier: LGPL-2.1-or-later
"""The objects of a machine file, and the machine that they say.

unit      lengths are mm, or inches where ``machine.units`` says imperial; angles are degrees; rates are per
          minute.
parent    the axis that carries this one, null for the base. The axes of the table, from the base outwards,
          end at the work, those of the head at the tool. Linear axes that stand beside a rotary one on the
          same parent are taken to lie nearer to the base; two rotary ones side by side leave the chain open
          and are refused.
acceleration ``max_acceleration`` of an axis, mm/s^2 (inches with imperial units) or degrees/s^2, is ours:
          FreeCAD drops it when it saves. It may be missing.
unlimited a limit of 99999 mm or degrees or beyond means that the axis has none (JSON knows no infinity).
fiveaxis  one extra top-level key for what the format lacks: ``gauge_point`` and ``origin`` (machine frame),
          ``singular_cone`` (degrees), ``controller``, ``rapids`` (interpolated, independent or unknown; the
          controller's own where it is missing), ``safe_start`` (an object: ``retract`` and, for a retract to
          a machine coordinate, ``Z``), ``table`` (height of its face, machine frame), ``bodies`` (what the
          tool must not hit, :mod:`.bodies`) and ``no_motion`` (a list of functions that move nothing,
          :mod:`.no_motion`). FreeCAD drops it when it saves; each has a default.
older     files from before the editor's release have keys of their own (:mod:`.older_layout`).

output    ``output.units``: whether NC programs are in mm or inches.

What the program does not use (tool heads, other output, post-processor, base frame) is not read.
Every key that it uses must be there and make sense: a guess about a machine is worse than a question.
"""

from __future__ import annotations

import difflib
import math
import reprlib
from collections.abc import Callable, Mapping
from typing import Any, Literal

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.rapids import RAPIDS
from freecad_fiveaxis.core.base.sentences import Sentence, say

from .bodies_file import read_bodies, write_bodies
from .keys import (
    JsonObject,
    as_number,
    as_vector,
    fail,
    get_choice,
    get_key,
    get_names,
    get_number,
    get_object,
    get_text,
)
from .model import LINEAR_LETTERS, ROTARY_LETTERS, Axis, Machine, Vector
from .older_layout import as_today
from .safe_start import BY_MACHINE, RETRACTS, SafeStart

VERSION = 1
UNLIMITED = 99999.0
INCH = 25.4

UNITS = {"metric": 1.0, "imperial": INCH}
KINDS = {"linear": False, "rotary": True, "angular": True}  # "angular" is how older files spell it
ROLES = ("table_linear", "table_rotary", "head_linear", "head_rotary")
FREECAD_VERSION = "26.3.0"
"""The first version with a Machine editor; its format is what is written."""
LIKE = 0.8
"""How much alike two keys are (difflib's ratio) of which one is taken as the other misspelt."""
KEYS = ("type", "role", "parent", "joint", "limits", "max_velocity")
"""What every axis must have."""


def read_machine(data: Any) -> Machine:
    """Read the objects of a machine file, as JSON has them. Raises MachineError, with the key."""
    if not isinstance(data, dict):
        raise MachineError(
            say('the file holds {data} instead of an object with the key "machine"', data=reprlib.repr(data)),
            data,
        )
    version = get_key(data, "", "version")
    if isinstance(version, bool) or version != VERSION:
        raise fail(
            "version",
            say(
                "{version} cannot be read; only version {known} can",
                version=reprlib.repr(version),
                known=VERSION,
            ),
            version,
        )
    machine = get_object(data, "", "machine")
    unit = UNITS[get_choice(machine, "machine.", "units", UNITS)]
    name = get_text(machine, "machine.", "name").strip()
    if not name:
        raise fail("machine.name", say("the name is empty; give the machine one"), name)
    axes = as_today(get_object(machine, "machine.", "axes"))
    _check_whole(axes)
    found = {letter: read_axis(letter, axes, unit) for letter in axes}
    order = _work_to_tool(found, {letter: _parent(letter, axes) for letter in axes})
    description = get_text(machine, "machine.", "description") if "description" in machine else ""
    return Machine(
        name, tuple(found[letter] for letter in order), description=description,
        output_inch=_writes_inches(data), **_extra(data, unit),
    )  # fmt: skip


def _writes_inches(data: JsonObject) -> bool:
    """Whether the machine's NC programs are in inches (``output.units``)."""
    output = get_object(data, "", "output") if "output" in data else {}
    return "units" in output and UNITS[get_choice(output, "output.", "units", UNITS)] == INCH


def _check_whole(axes: JsonObject) -> None:
    """One line for all keys that the axes lack, where they are several; a single one is named where it is
    read."""
    lacking = [
        f"{letter}.{key}"
        for letter, axis in axes.items()
        if isinstance(axis, dict)
        for key in KEYS
        if key not in axis
    ]
    if len(lacking) > 1:
        problem = say(
            "the keys {lacking} are missing; add them (role: one of {roles}; parent: the axis that carries "
            "this one, or null)",
            lacking=", ".join(lacking),
            roles=", ".join(ROLES),
        )
        raise fail("machine.axes", problem, lacking)


def _extra(data: JsonObject, unit: float) -> dict[str, Any]:
    """Return what stands under ``fiveaxis``, as fields of Machine; what does not keeps its default."""
    where = "fiveaxis."
    extra = get_object(data, "", "fiveaxis") if "fiveaxis" in data else {}
    readers: dict[str, Callable[[str], Any]] = {
        "gauge_point": lambda key: as_vector(extra[key], where + key, unit),
        "origin": lambda key: as_vector(extra[key], where + key, unit),
        "singular_cone": lambda key: math.radians(get_number(extra, where, key)),
        "controller": lambda key: get_text(extra, where, key),
        "safe_start": lambda key: _safe_start(get_object(extra, where, key), f"{where}{key}.", unit),
        "rapids": lambda key: get_choice(extra, where, key, RAPIDS),
        "table": lambda key: unit * get_number(extra, where, key),
        "bodies": lambda key: read_bodies(extra[key], where + key, unit),
        "no_motion": lambda key: get_names(extra, where, key),
    }
    _check_spelling(extra, tuple(readers), where)
    return {key: read(key) for key, read in readers.items() if key in extra}


def _check_spelling(extra: JsonObject, known: tuple[str, ...], where: str) -> None:
    """Refuse a key that is nearly a known one: dropped in silence, a ``safestart`` would leave the program to
    begin otherwise than its writer thinks. What resembles none is somebody else's and stays unread."""
    for key in extra:
        near = difflib.get_close_matches(key.lower(), known, n=1, cutoff=LIKE) if key not in known else []
        if near and near[0] not in extra:
            raise fail(where + key, say("no such key; did you mean {near}?", near=near[0]), extra[key])


def _safe_start(given: JsonObject, where: str, unit: float) -> SafeStart:
    retract = get_choice(given, where, "retract", RETRACTS)
    spare = [key for key in given if key not in ("retract", *(("Z",) if retract == BY_MACHINE else ()))]
    if spare:
        raise fail(
            where + spare[0],
            say("retract {retract} takes no such key; leave it out", retract=retract),
            given[spare[0]],
        )
    return SafeStart(retract, unit * get_number(given, where, "Z") if retract == BY_MACHINE else None)


def read_axis(letter: str, axes: JsonObject, unit: float) -> Axis:
    """Read one of the ``axes`` of a file whose lengths are ``unit`` mm. Raises MachineError, with the key."""
    if letter not in LINEAR_LETTERS + ROTARY_LETTERS:
        raise fail(
            "machine.axes",
            say("{letter} names no axis; use X Y Z and up to two of A B C", letter=reprlib.repr(letter)),
            letter,
        )
    axis, where = get_object(axes, "machine.axes.", letter), f"machine.axes.{letter}."
    rotary = KINDS[get_choice(axis, where, "type", KINDS)]
    role = get_choice(axis, where, "role", ROLES)
    if rotary != role.endswith("rotary"):
        raise fail(
            where + "role", say("{role} contradicts the type of the axis; make them agree", role=role), role
        )
    side: Literal["table", "head"] = "table" if role.startswith("table") else "head"
    direction, point = read_joint(axis, where, rotary, unit)
    if "limits" not in axis:
        raise fail(where + "limits", _say_no_limits(rotary), None)
    limits = get_object(axis, where, "limits")
    low, high = (_limit(get_number(limits, where + "limits.", key), rotary, unit) for key in ("min", "max"))
    rate = _rate(axis, where, "max_velocity", rotary, unit)
    wrap = get_text(axis, where, "wrap_strategy") if rotary and "wrap_strategy" in axis else "unwound"
    acceleration = math.inf
    if "max_acceleration" in axis:
        acceleration = _rate(axis, where, "max_acceleration", rotary, unit)
    return Axis(letter, rotary, side, direction, point, low, high, rate, wrap, acceleration)


def _say_no_limits(rotary: bool) -> Sentence:
    example = '"limits": {"min": -30, "max": 110}' if rotary else '"limits": {"min": -200, "max": 200}'
    if not rotary:
        return say("the key is missing; add {example} with the axis' own limits", example=example)
    return say(
        "the key is missing; add {example} with the axis' own limits; -99999 and 99999 for one that turns "
        "without end",
        example=example,
    )


def _rate(axis: JsonObject, where: str, key: str, rotary: bool, unit: float) -> float:
    """Return mm or rad a minute, or mm/s^2 or rad/s^2."""
    given = get_number(axis, where, key)
    return as_number(math.radians(given) if rotary else given * unit, where + key)


def _limit(value: float, rotary: bool, unit: float) -> float:
    value = value if rotary else value * unit
    if abs(value) >= UNLIMITED:
        return math.copysign(math.inf, value)
    return math.radians(value) if rotary else value


def read_joint(axis: JsonObject, where: str, rotary: bool, unit: float) -> tuple[Vector, Vector]:
    """Read direction and point from {"origin", "axis"} or [[origin], [axis]]; old files have a linear axis's
    swapped."""
    joint, where = get_key(axis, where, "joint"), where + "joint"
    if isinstance(joint, list):
        if len(joint) != 2:
            raise fail(where, say("{joint} is not [[origin], [axis]]", joint=reprlib.repr(joint)), joint)
        joint = {"origin": joint[0], "axis": joint[1]}
        if not rotary and joint["axis"] == [0, 0, 0]:
            joint = {"origin": joint["axis"], "axis": joint["origin"]}
    elif not isinstance(joint, dict):
        raise fail(
            where,
            say('{joint} is not {{"origin": [x, y, z], "axis": [x, y, z]}}', joint=reprlib.repr(joint)),
            joint,
        )
    origin, direction = (get_key(joint, where + ".", key) for key in ("origin", "axis"))
    return as_vector(direction, where + ".axis"), as_vector(origin, where + ".origin", unit)


def _parent(letter: str, axes: JsonObject) -> str | None:
    where = f"machine.axes.{letter}."
    parent = get_key(axes[letter], where, "parent")
    if parent is not None and (not isinstance(parent, str) or parent not in axes):
        problem = say(
            "{parent} is no axis of this machine; name one, or null for the base", parent=reprlib.repr(parent)
        )
        raise fail(where + "parent", problem, parent)
    return parent


def _work_to_tool(axes: Mapping[str, Axis], parent: Mapping[str, str | None]) -> list[str]:
    """Return the letters from the work over the base to the tool, from the links alone."""
    for letter, carrier in parent.items():
        if carrier is not None and axes[carrier].side != axes[letter].side:
            sides = say(
                "a {side} axis cannot stand on the {other} axis {carrier}",
                side=axes[letter].side,
                other=axes[carrier].side,
                carrier=carrier,
            )
            raise fail(
                f"machine.axes.{letter}.parent",
                say("{sides}; name another, or null for the base", sides=sides),
                carrier,
            )
    outwards = _outwards(None, axes, parent)
    lost = [letter for letter in axes if letter not in outwards]
    if lost:
        raise fail(
            "machine.axes",
            say("{lost} carry one another in a circle; give one the parent null", lost=", ".join(lost)),
            lost,
        )
    table = [letter for letter in outwards if axes[letter].side == "table"]
    return table[::-1] + [letter for letter in outwards if axes[letter].side == "head"]


def _outwards(carrier: str | None, axes: Mapping[str, Axis], parent: Mapping[str, str | None]) -> list[str]:
    """Return the letters from ``carrier`` (itself left out) away from the base; chains of linear axes only
    come first."""
    chains = [
        [letter, *_outwards(letter, axes, parent)] for letter in sorted(axes) if parent[letter] == carrier
    ]
    turning = [chain for chain in chains if any(axes[letter].rotary for letter in chain)]
    for side in ("table", "head"):
        rivals = [chain[0] for chain in turning if axes[chain[0]].side == side]
        if len(rivals) > 1:
            problem = say(
                '{rivals} both stand on {carrier}; say by "parent" which carries which',
                rivals=" and ".join(rivals),
                carrier=carrier or say("the base"),
            )
            raise fail("machine.axes", problem, rivals)
    plain = [chain for chain in chains if chain not in turning]
    return [letter for chain in plain + turning for letter in chain]


def write_objects(machine: Machine) -> dict[str, Any]:
    """Return the objects of a machine file. Raises MachineError for an axis without a maximum rate."""
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
        "output": {"units": "imperial" if machine.output_inch else "metric"},
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
            **({"bodies": write_bodies(machine.bodies)} if machine.bodies else {}),
            **({"no_motion": list(machine.no_motion)} if machine.no_motion else {}),
        },
    }


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
