# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes at the machine's pole itself instead of near it.

pole      the tool axis along the first rotary axis: there that may stand as it likes, and does not turn.
near      a stretch of a pass on which the tool axis comes within CONE of the pole, as far as it stays within
          WIDE of it. Small turns of the tool axis are large ones of the first rotary axis there (So et al.
          2008, section 1).

On a flat across the pole the axes of a field all lean a little, each to another side. Where the pole is free,
it is taken instead, and what leaves it goes past the singular cone in one step, along which the first rotary
axis stays.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain

CONE, WIDE = math.radians(7.0), math.radians(12.0)
"""rad from the pole. The first is more than the singular cone of most machines; the second is farther, so
that a pass along which the axis stays about the first does not jump to the pole and back again and again."""


def take_pole(
    axis: Floats,
    contact: Ints,
    polyline: Ints,
    kinematics: Chain,
    free_with: Callable[[Floats, Bools], Bools],
) -> Floats:
    """Give the unit axes (k, 3) of contacts with those near the pole on it, wherever it is free.

    ``contact`` (n,) and ``polyline`` (n,) of each row of the passes; ``free_with`` tells of axes (k, 3) and
    the contacts asked (k,) at which of these the tool is as free as with the axis given.
    """
    along = axis @ kinematics.direction[3]
    pole = np.where(along < 0.0, -1.0, 1.0)[:, None] * kinematics.direction[3]
    lean = np.arccos(np.clip(np.abs(along), 0.0, 1.0))
    near = np.zeros(len(axis), np.bool_)
    near[contact[find_near_rows(lean[contact], polyline)]] = True
    good = free_with(pole, near) if near.any() else near
    return np.where(good[:, None], pole, axis)


def find_near_rows(lean: Floats, polyline: Ints) -> Bools:
    """Find the rows (n,) of stretches on which ``lean`` (n,) rad from the pole stays within WIDE and comes
    within CONE."""
    within = lean < WIDE
    begins = np.ones(len(lean), np.bool_)
    begins[1:] = (within[1:] != within[:-1]) | (polyline[1:] != polyline[:-1])
    stretch = np.cumsum(begins) - 1
    comes = np.bincount(stretch, within & (lean < CONE)) > 0
    return np.asarray(within & comes[stretch])
