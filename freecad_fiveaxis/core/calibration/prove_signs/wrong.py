# SPDX-License-Identifier: LGPL-2.1-or-later
"""What could be wrong: the machine turns an axis the other way than its file says, or takes one letter for
the other.

Each such machine is a chain of its own, with the lines where they are. The words of the program given to it
lead the tip elsewhere: that is what the sheet foretells, and what the plan keeps clear of the part.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward


@dataclass(frozen=True, eq=False)
class Wrong:
    """``text``: what is wrong, as a clause; ``kinematics``: the machine that has it so; ``swapped``: it takes
    each rotary word for the other."""

    text: str
    kinematics: Chain
    swapped: bool = False

    def reach(self, q: Floats) -> tuple[Floats, Floats]:
        """Tip (n, 3) and axis (n, 3) that this machine reaches with the words ``q`` (n, 5) mm and rad."""
        q = np.asarray(q, float)
        return forward(self.kinematics, q[:, [0, 1, 2, 4, 3]] if self.swapped else q)


def wrong_machines(machine: Machine, setup: Setup) -> tuple[Wrong, ...]:
    """Each rotary axis reversed, both, and the letters exchanged."""
    first, second = (axis.letter for axis in machine.rotary)
    reversed_ = (
        (first, say("{letter} turns the wrong way", letter=first)),
        (second, say("{letter} turns the wrong way", letter=second)),
    )
    both = (first + second, say("{first} and {second} both turn the wrong way", first=first, second=second))
    turned = tuple(
        Wrong(text, chain(_reverse_axes(machine, letters), setup)) for letters, text in (*reversed_, both)
    )
    return (
        *turned,
        Wrong(
            say("{first} and {second} are exchanged", first=first, second=second), chain(machine, setup), True
        ),
    )


def _reverse_axes(machine: Machine, letters: str) -> Machine:
    def reverse_axis(axis: Axis) -> Axis:
        x, y, z = axis.direction
        return replace(axis, direction=(-x + 0.0, -y + 0.0, -z + 0.0)) if axis.letter in letters else axis

    return replace(machine, axes=tuple(reverse_axis(axis) for axis in machine.axes))
