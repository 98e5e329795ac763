# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the reader must know of the machine while a text is brought to plain words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freecad_fiveaxis.core.machine.kinematics import Chain


@dataclass(frozen=True, eq=False)
class OfMachine:
    """``kinematics``: how its rotary axes take up a plane; None where no machine is known. ``no_motion``:
    names of its functions that move nothing. ``diameters`` mm of the tools that a text names beside their
    calls, by the index of the line of the call. ``search``: folders with the programs that a text calls."""

    kinematics: Chain | None = None
    no_motion: tuple[str, ...] = ()
    diameters: Mapping[int, float] = field(default_factory=dict)
    search: tuple[str, ...] = ()


NO_MACHINE = OfMachine()
