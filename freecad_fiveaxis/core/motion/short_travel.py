# SPDX-License-Identifier: LGPL-2.1-or-later
"""What helps where a linear axis is driven beyond a limit: another work zero, where its travel is long
enough, or where the part stands far from the axes about which the table turns."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, say
from freecad_fiveaxis.core.machine.kinematics import Chain

FAR = 2.0
"""Farther from a table's axis than so many times its own half diagonal a path stands beside it."""


class Aside(NamedTuple):
    """A path that stands beside an axis of the table: the axis' ``letter``, its ``distance`` from the path's
    middle, mm, and by how much (3,) mm the work zero has to be moved to bring the middle to the axes."""

    letter: str
    distance: float
    move: Floats


def find_aside(kinematics: Chain, tip: Floats) -> Aside | None:
    """Find whether the tips (n, 3) mm stand far beside an axis of the table; None where they do not, or where
    no axis carries the part."""
    low, high = tip.min(axis=0), tip.max(axis=0)
    middle, half = (low + high) / 2.0, float(np.linalg.norm(high - low)) / 2.0
    points = (kinematics.point1, kinematics.point2)
    rotary = kinematics.axes[3:]
    table = [k for k in (0, 1) if rotary[k].side == "table" and rotary[k].fitted]
    across = [np.eye(3) - np.outer(kinematics.direction[3 + k], kinematics.direction[3 + k]) for k in table]
    ways = [one @ (points[k] - middle) for one, k in zip(across, table, strict=True)]
    distance = [float(np.linalg.norm(way)) for way in ways]
    if not table or max(distance) <= FAR * half:
        return None
    move = np.linalg.pinv(np.sum(across, axis=0)) @ np.sum(ways, axis=0)
    worst = int(np.argmax(distance))
    return Aside(kinematics.letters[3 + table[worst]], distance[worst], move)


def say_remedy_beyond_limit(
    letter: str, words: Floats, low: float, high: float, aside: Aside | None = None
) -> Sentence:
    """Say what helps where ``words`` (n,) mm of a linear axis leave ``low`` to ``high`` mm: to move the work
    zero, unless they span more than the axis has, and then by how much it is too short and, where the path
    stands ``aside``, where it should."""
    span, travel = float(words.max() - words.min()), high - low
    if span <= travel:
        return say("move the work zero ({origin}) or take a larger machine.", origin=Option("origin"))
    if aside is None:
        return say(
            "the program needs {span} of {letter}, whose travel is {travel}, {short} too short. Take a "
            "larger machine, or mill less of the part at once.",
            span=Length(span, ".6g"), letter=letter, travel=Length(travel, ".6g"),
            short=Length(span - travel, ".6g"),
        )  # fmt: skip
    x, y, z = (Length(value, ".4g", bare=True) for value in aside.move.tolist())
    return say(
        "the program needs {span} of {letter}, whose travel is {travel}, for what is milled stands "
        "{distance} from the axis of {axis} and swings with it. Stand it near the axes: the work zero moved "
        "by about X {x} Y {y} Z {z} ({origin}) does.",
        span=Length(span, ".6g"), letter=letter, travel=Length(travel, ".6g"),
        distance=Length(aside.distance, ".4g"), axis=aside.letter, x=x, y=y, z=z, origin=Option("origin"),
    )  # fmt: skip
