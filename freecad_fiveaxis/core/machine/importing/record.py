# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the import knows of one of LinuxCNC's kinematics modules: a record, and what a configuration gives it.

pin      an input of the module in HAL, called ``prefix.name``; where nothing sets it, the module's own value
         holds.
turn     a rotary axis: on which side it is, its direction (ISO 841: tool relative to the work) and a point of
         its line.
J, P, k  in formulas: the joints, the tip in the work, the tool axis; ez is the unit vector of Z, Rx(A) the
         turn about X.
tool     P counts the tool length t in: with all rotary joints zero P = J, and the tip stands at J - t ez. The
         machine's gauge point is therefore 0,0,0 for every module, and t is the setup's tool length.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.machine import Vector

X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Pin:
    """An input. ``default``: the module's own value; ``length``: in the machine's units, else in degrees or a
    bit.

    ``required``: a finding says so where nothing sets it."""

    name: str
    default: float = 0.0
    required: bool = True
    length: bool = True


@dataclass(frozen=True)
class Turn:
    """A rotary axis: letter, side, unit direction, and a point of its line with all joints zero, mm."""

    letter: str
    side: Literal["table", "head"]
    direction: Vector
    point: Vector


@dataclass(frozen=True)
class Given:
    """What a configuration gives a module.

    ``module``: prefix of its pins. ``letters``: of the axes that it has. ``values``: of the pins by name,
    lengths in mm, the others as they are. ``where``: the place of the line that names the module.
    ``follows_tool``: whether the tool length comes from motion.tooloffset.z."""

    module: str
    letters: str
    values: Mapping[str, float]
    where: str
    follows_tool: bool


@dataclass(frozen=True)
class Kinematics:
    """One of LinuxCNC's modules.

    ``joints``: letters in the order of the joints where the line does not say ``coordinates=``; ``fixed``: it
    cannot say so. ``needs``: letters that must be there; ``spare``: those that may stand beside them.
    ``turns``: the rotary axes from the work to the tool. ``remarks``: what is to be said besides. ``tool``:
    the pin that takes motion.tooloffset.z, alone or, with ``tool_in``, in a sum with a length of the machine.
    ``unused``: pins that the module has and does not use.
    """

    name: str
    joints: str
    needs: str
    turns: Callable[[Given], tuple[Turn, ...]]
    remarks: Callable[[Given], tuple[Finding, ...]] = lambda given: ()
    pins: tuple[Pin, ...] = ()
    prefix: str = ""
    spare: str = ""
    tool: str = ""
    tool_in: bool = False
    unused: tuple[str, ...] = ()
    fixed: bool = False

    def pin(self, name: str) -> str:
        """Give the whole name of a pin in HAL."""
        return f"{self.prefix or self.name}.{name}"


def apply_sense(direction: Vector, sense: float) -> Vector:
    """Give the direction (3,) as it is for ``sense`` 1, reversed for -1."""
    x, y, z = direction
    return sense * x + 0.0, sense * y + 0.0, sense * z + 0.0
