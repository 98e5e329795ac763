# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine file as a draft: plain values to be edited, and the objects of the file that they were read from.

values    mm, degrees, mm/min and degrees/min, whatever the file's unit is. A value that is not changed is
          written as it stood.
source    what the file held, an axis's own or the whole: every key that a draft knows nothing of stays in it.
unit      mm for one of the file's lengths.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.machine import Vector, load_machine, machine_path
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.file_objects import KINDS, UNITS, UNLIMITED, read_joint
from freecad_fiveaxis.core.machine.keys import JsonObject, parse_json
from freecad_fiveaxis.core.machine.older_layout import LIMITS, as_today

Side = Literal["table", "head"]


@dataclass(frozen=True)
class AxisDraft:
    """One axis. ``direction`` as given, of any length; ``point`` mm, of a rotary axis's line with all joints
    zero; ``low`` and ``high`` mm or degrees, infinite for no limit; ``max_rate`` mm/min or degrees/min, None
    while it is not known; ``max_acceleration`` mm/s^2 or degrees/s^2, or None likewise. Nothing of it is
    checked here (:mod:`.check`)."""

    letter: str
    rotary: bool
    side: Side
    direction: Vector
    point: Vector = (0.0, 0.0, 0.0)
    low: float = -math.inf
    high: float = math.inf
    max_rate: float | None = None
    wrap: str = "unwound"
    max_acceleration: float | None = None
    source: JsonObject = field(default_factory=dict, compare=False, repr=False)


@dataclass(frozen=True)
class MachineDraft:
    """A machine. ``axes`` from the work to the tool, the table's before the head's; ``units``: "metric" or
    "imperial", of its file; ``gauge_point`` and ``origin`` (3,) mm and ``table`` mm as of
    :class:`~..model.Machine`; ``bodies`` with the whole names of their files. ``order``: letters and sides of
    the axes as the file has them."""

    name: str
    description: str
    units: str
    controller: str
    gauge_point: Vector
    origin: Vector
    table: float | None
    axes: tuple[AxisDraft, ...]
    bodies: tuple[MachineBody, ...] = ()
    source: JsonObject = field(default_factory=dict, compare=False, repr=False)
    order: tuple[tuple[str, str], ...] = field(default=(), compare=False, repr=False)
    listed: tuple[MachineBody, ...] = field(default=(), compare=False, repr=False)
    """The bodies as the file lists them."""

    @property
    def unit(self) -> float:
        """The file's unit of length, mm."""
        return UNITS[self.units]

    def letters(self, side: Side | None = None) -> tuple[str, ...]:
        """Return the letters of the axes, of one side alone where that is given."""
        return tuple(axis.letter for axis in self.axes if side in (None, axis.side))


def read_draft(name_or_path: str | os.PathLike[str]) -> MachineDraft:
    """Read a machine by its shipped name or its file. Raises MachineError or FileError, as
    :func:`~..load_machine` does."""
    given = os.fspath(name_or_path)
    machine = load_machine(given)
    path = machine_path(given)
    if path is None:
        raise MachineError(given, given)  # load_machine has refused such a name
    source = parse_json(read_bytes(path, "machine file"))
    units = source["machine"]["units"]
    axes = as_today(source["machine"]["axes"])
    chained = tuple(
        read_axis_draft(one.letter, _today(axes[one.letter]), UNITS[units]) for one in machine.fitted
    )
    bodies = tuple(
        replace(one, file=str(Path(one.file).absolute()) if one.file else "") for one in machine.bodies
    )
    return MachineDraft(
        machine.name, machine.description, units, machine.controller, machine.gauge_point, machine.origin,
        machine.table, chained,
        bodies, source, tuple((axis.letter, axis.side) for axis in chained), bodies,
    )  # fmt: skip


def _today(axis: JsonObject) -> JsonObject:
    """Return an axis without the keys that stand under ``limits`` today."""
    return {key: value for key, value in axis.items() if key not in LIMITS}


def read_axis_draft(letter: str, axis: JsonObject, unit: float) -> AxisDraft:
    """Read one axis of a file that :func:`~..load_machine` takes, its lengths ``unit`` mm."""
    rotary = KINDS[axis["type"]]
    scale = 1.0 if rotary else unit
    direction, point = read_joint(axis, letter + ".", rotary, unit)
    low, high = (_limit(scale * axis["limits"][key]) for key in ("min", "max"))
    side: Side = "table" if axis["role"].startswith("table") else "head"
    wrap = axis.get("wrap_strategy", "unwound") if rotary else "unwound"
    given = axis.get("max_acceleration")
    return AxisDraft(
        letter, rotary, side, direction, point, low, high, scale * axis["max_velocity"], wrap,
        None if given is None else scale * given, axis,
    )  # fmt: skip


def _limit(value: float) -> float:
    return math.copysign(math.inf, value) if abs(value) >= UNLIMITED else float(value)
