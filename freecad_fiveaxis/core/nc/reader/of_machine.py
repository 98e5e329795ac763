# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the reader must know of the machine while a text is brought to plain words."""

from __future__ import annotations

from dataclasses import dataclass

from freecad_fiveaxis.core.machine.kinematics import Chain


@dataclass(frozen=True, eq=False)
class OfMachine:
    """``kinematics``: how its rotary axes take up a plane; None where no machine is known. ``no_motion``: names of its functions
    that move nothing."""

    kinematics: Chain | None = None
    no_motion: tuple[str, ...] = ()


NO_MACHINE = OfMachine()
