# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high Z must stand so that the rotary axes may turn: above the part, wherever they stand.

height    of a point: along the machine's Z, which is a fixed direction of the machine and in the work frame
          turns with the table.
plane     the word of Z at which the tip is higher than the part's box by a margin, at every pair of rotary
          words within the limits. X and Y do not matter; where their axes lie between the work and a rotary
          axis, those of the first block count.
"""

from __future__ import annotations

import math
from itertools import product

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cos_sin
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.machine.kinematics.serial_chain import turn

STEP = math.radians(2.0)
"""Between the rotary words that are looked at."""
WHOLE = 1.0
"""mm; the plane is raised to a whole number of them."""
LEAST_LIFT = 0.5
"""mm that a millimetre of Z lifts the tool at least, where Z is an axis to retract with."""


def plane_above(kinematics: Chain, low: Floats, high: Floats, margin: float, words: Floats) -> float:
    """Return the word of Z (mm) of the plane ``margin`` mm above the part's box ``low``, ``high`` (3,) mm;
    not below the words (m, 5) of the blocks with which the program begins and ends. Raises SettingsError
    where Z does not lift the tool.

    The highest of all pairs of rotary words is not found but bounded: where it lies between those looked at,
    its slope is zero, and the nearest of them is lower by no more than the bend over half a step.
    """
    lift = float(kinematics.direction[2, 2])
    if abs(lift) < LEAST_LIFT or kinematics.slot[2] < _tables(kinematics):
        raise SettingsError(
            say("Z of this machine does not lift the tool: give its file another safe_start than clearance"),
            None,
        )
    corners, angles = np.array(list(product(*zip(low, high, strict=True)))), _angles(kinematics)
    q = np.column_stack([np.tile(words[0, :2], (len(angles), 1)), np.zeros(len(angles)), angles])
    tip, up = forward(kinematics, q)[0], upwards(kinematics, angles)
    above = float(((up @ corners.T).max(axis=1) - (tip * up).sum(axis=1)).max())
    lever = sum(
        float(np.linalg.norm(point, axis=-1).max())
        for point in (corners, kinematics.point1, kinematics.point2, words[0, :2])
    )
    z = (above + margin + 0.5 * STEP**2 * 2.0 * lever) / abs(lift)
    z = max(z, float((math.copysign(1.0, lift) * words[[0, -1], 2]).max()))
    return math.copysign(1.0, lift) * math.ceil(z / WHOLE) * WHOLE


def _tables(kinematics: Chain) -> int:
    """How many rotary axes carry the work."""
    return sum(axis.side == "table" for axis in kinematics.axes[3:])


def _angles(kinematics: Chain) -> Floats:
    """Pairs of rotary words (n, 2) rad: the limits, or one whole turn, in steps."""
    columns = []
    for low, high in zip(kinematics.low[3:].tolist(), kinematics.high[3:].tolist(), strict=True):
        low, high = (low, high) if high - low < 2.0 * math.pi else (-math.pi, math.pi)
        columns.append(np.linspace(low, high, math.ceil((high - low) / STEP) + 1))
    first, second = np.meshgrid(*columns, indexing="ij")
    return np.column_stack([first.ravel(), second.ravel()])


def upwards(kinematics: Chain, angles: Floats) -> Floats:
    """Return the machine's Z (n, 3) in the work frame: turned by the axes of the table alone."""
    up = np.tile((0.0, 0.0, 1.0), (len(angles), 1))
    for k in (1, 0):
        if kinematics.axes[3 + k].side == "table":
            up = turn(up, kinematics.direction[3 + k], *cos_sin(angles[:, k]))
    return up


def within_travel(kinematics: Chain, height: float, words: Floats) -> tuple[float, tuple[Finding, ...]]:
    """Return the height, or the limit of Z where that is lower, and what there is to say of it; never a
    height below the words (m, 5) with which the program begins and ends, for from there Z would come down
    into the part."""
    low, high = float(kinematics.low[2]), float(kinematics.high[2])
    if low <= height <= high:
        return height, ()
    ends = words[[0, -1], 2].tolist()
    limit = high if height > high else low
    reached = max(high, *ends) if height > high else min(low, *ends)
    text = _say_beyond_travel(height, limit) if reached == limit else _say_ends_beyond(height, limit, reached)
    return reached, (report_finding(Code.SAFE_START_BEYOND_LIMIT, text, height, limit),)


def _say_beyond_travel(height: float, limit: float) -> Sentence:
    return say(
        "The plane above the part at which the rotary axes turn lies at Z {height}, beyond the limit {limit}:"
        " the program begins and ends at that limit. Watch the first moves, or set the machine file's "
        "safe_start to machine or reference.",
        height=Length(height, bare=True),
        limit=Length(limit, ".4g", bare=True),
    )


def _say_ends_beyond(height: float, limit: float, reached: float) -> Sentence:
    return say(
        "The plane above the part at which the rotary axes turn lies at Z {height}, beyond the limit {limit},"
        " and the first or the last place of the path too: the program begins and ends at Z {reached}. Move "
        "the work zero ({origin}) so that Z reaches the part.",
        height=Length(height, bare=True),
        limit=Length(limit, ".4g", bare=True),
        reached=Length(reached, ".4f", bare=True),
        origin=Option("origin"),
    )
