# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the axes go, one after the other, and why nothing can be hit, whatever the signs.

mark   a place of the work frame at the height of the highest part or clamp: nothing stands above the level
       through it.
stop   a pose at which the program waits and the operator compares what he sees with the sheet.
clear  the tip is never nearer than the gap to the level through the mark, on the machine as its file says
       **and** on each of the machines that it might be instead (:mod:`wrong`). All moves are at feed, none is
       a rapid.

Single moves start from a pose above the mark, high enough for this. The last stop puts the tip on the line
through the mark along the tool, both rotary axes turned; its distance from the mark is the least that keeps
the wrong machines clear too.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Angle, Length, Option, Sentence, measure, say
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, joint_words

from .seen import linear_seen, rotary_seen
from .wrong import Wrong, wrong_machines

PIECES = 33
"""Poses looked at along each move."""
RAISES, STEP = 200, 5.0
"""mm; heights and distances are raised in whole steps, so that they are easy to measure."""
USUAL_MARK = (30.0, 20.0, 0.0)
"""mm; at the height of the work zero: with nothing on the table that is higher."""
VISIBLE = 3.0
"""mm that nobody overlooks at the last stop."""


@dataclass(frozen=True)
class Wishes:
    """``mark`` (3,) mm in the work frame, None: nobody has said where, so nothing may stand above the work
    zero; ``gap``, ``travel`` mm; ``angle`` rad; ``feed`` mm/min and deg/min."""

    mark: Vector | None = None
    gap: float = 20.0
    travel: float = 20.0
    angle: float = math.radians(10.0)
    feed: float = 200.0

    @property
    def place(self) -> Vector:
        """The mark, or the usual one."""
        return USUAL_MARK if self.mark is None else self.mark


@dataclass(frozen=True, eq=False)
class Stop:
    """``q`` (n, 5) mm and rad: the poses driven to, the last being where the program waits; ``title``,
    ``see`` and ``bad`` (what a wrong sign looks like) as on the sheet. An empty ``see``: the program only
    drives on."""

    title: str
    q: Floats
    see: str = ""
    bad: str = ""


@dataclass(frozen=True, eq=False)
class Plan:
    """``height`` mm of the tip over the mark in the single moves, ``distance`` mm at the last stop;
    ``predicted_errors``: what is wrong, and where (3,) mm the tip of such a machine stands there, counted
    from where it should."""

    machine: Machine
    kinematics: Chain
    wishes: Wishes
    stops: tuple[Stop, ...]
    height: float
    distance: float
    predicted_errors: tuple[tuple[str, Floats], ...]
    findings: tuple[Finding, ...]

    @property
    def poses(self) -> Floats:
        """All poses (n, 5) in order."""
        return np.concatenate([stop.q for stop in self.stops])


def make_plan(machine: Machine, setup: Setup, wishes: Wishes) -> Plan:
    """Return the moves and stops. Raises SettingsError where an axis would leave its limits, with the
    remedy."""
    kinematics, wrong = chain(machine, setup), wrong_machines(machine, setup)
    angles = np.array([_turn(kinematics, k, wishes.angle) for k in (3, 4)])
    both = angles * (_unlike(kinematics, angles), 1.0)
    distance = _distance(kinematics, wrong, wishes, both)
    height = _height(kinematics, wrong, wishes, angles, both, distance)
    stops = tuple(_stops(machine, kinematics, wishes, angles, both, height, distance))
    _check_limits(kinematics, np.concatenate([stop.q for stop in stops]))
    last = _last_pose(kinematics, wishes, both, distance)[None]
    right = forward(kinematics, last)[0][0]
    predicted_errors = tuple((one.text, one.reach(last)[0][0] - right) for one in wrong)
    findings = (*_report_missing_mark(wishes), *_findings(predicted_errors))
    return Plan(machine, kinematics, wishes, stops, height, distance, predicted_errors, findings)


def _turn(kinematics: Chain, k: int, angle: float) -> float:
    """Return the angle, positive where the limits allow it."""
    for turn in (angle, -angle):
        if kinematics.low[k] <= turn <= kinematics.high[k]:
            return turn
    low, high = (math.degrees(value) for value in (kinematics.low[k], kinematics.high[k]))
    text = say(
        "{letter} cannot turn by {angle} within its limits {low} to {high}",
        letter=kinematics.letters[k],
        angle=Angle(math.degrees(angle)),
        low=Angle(low, bare=True),
        high=Angle(high),
    )
    raise SettingsError(
        say("{text}; give a smaller {angle}", text=text, angle=Option("angle")), math.degrees(angle)
    )


def _unlike(kinematics: Chain, angles: Floats) -> float:
    """By what the first angle is multiplied at the last stop, so that two exchanged letters show: 2, or 1/2
    where that is beyond its limits."""
    return 2.0 if kinematics.low[3] <= 2.0 * angles[0] <= kinematics.high[3] else 0.5


def _base(wishes: Wishes, height: float) -> Floats:
    x, y, z = wishes.place
    return np.array([x, y, z + height, 0.0, 0.0])


def _last_pose(kinematics: Chain, wishes: Wishes, angles: Floats, distance: float) -> Floats:
    """Return the tip on the line through the mark along the tool, ``distance`` from it, both rotary axes
    turned."""
    axis = forward(kinematics, np.array([[0.0, 0.0, 0.0, *angles]]))[1]
    tip = np.array([wishes.place]) + distance * axis
    return np.asarray(joint_words(kinematics, tip, angles[None])[0])


def _over(kinematics: Chain, wrong: tuple[Wrong, ...], wishes: Wishes, q: Floats) -> float:
    """How high over the mark's level the lowest tip of all machines stands, mm."""
    tips = [forward(kinematics, q)[0], *(one.reach(q)[0] for one in wrong)]
    return float(min(tip[:, 2].min() for tip in tips)) - wishes.place[2]


def _distance(kinematics: Chain, wrong: tuple[Wrong, ...], wishes: Wishes, angles: Floats) -> float:
    for count in range(RAISES):
        distance = wishes.gap + count * STEP
        if (
            _over(kinematics, wrong, wishes, _last_pose(kinematics, wishes, angles, distance)[None])
            >= wishes.gap
        ):
            return distance
    text = say(
        "no distance up to {raises} keeps a machine with wrong signs clear of the mark",
        raises=Length(RAISES * STEP),
    )
    raise SettingsError(
        say(
            "{text}; give a smaller {angle}, or a {mark} nearer to the rotary axes",
            text=text,
            angle=Option("angle"),
            mark=Option("mark"),
        ),
        wishes.angle,
    )


def _height(
    kinematics: Chain, wrong: tuple[Wrong, ...], wishes: Wishes, angles: Floats, both: Floats, distance: float
) -> float:  # fmt: skip
    """Return the least height over the mark from which every single move is clear."""
    for count in range(RAISES):
        height = max(wishes.gap + wishes.travel, distance) + count * STEP
        base = _base(wishes, height)
        turned = base + np.array(
            [[0.0, 0.0, 0.0, *turn] for turn in ((angles[0], 0.0), (0.0, angles[1]), both)]
        )
        moves = np.concatenate([_between(base, pose) for pose in turned])
        if _over(kinematics, wrong, wishes, moves) >= wishes.gap:
            return float(height)
    raise SettingsError(
        say(
            "no height up to {raises} keeps a machine with wrong signs clear; give a smaller {angle}",
            raises=Length(RAISES * STEP),
            angle=Option("angle"),
        ),
        wishes.angle,
    )


def _between(start: Floats, end: Floats) -> Floats:
    return np.asarray(start + np.linspace(0.0, 1.0, PIECES)[:, None] * (end - start))


def _stops(
    machine: Machine, kinematics: Chain, wishes: Wishes, angles: Floats, both: Floats, height: float,
    distance: float
) -> list[Stop]:  # fmt: skip
    base, low = _base(wishes, height), _base(wishes, wishes.gap)
    stops = [_first_stop(base, kinematics), _mark_stop(low, wishes), Stop("up", base[None])]
    axes = {axis.letter: axis for axis in machine.axes}
    lines = (kinematics.point1, kinematics.point2)  # with the tip at zero
    for k in range(5):
        letter, change = kinematics.letters[k], np.zeros(5)
        change[k] = _travel(kinematics, k, base, wishes.travel) if k < 3 else angles[k - 3]
        other = kinematics.letters[7 - k] if k >= 3 else ""
        sentence = (
            linear_seen(axes[letter], change[k])
            if k < 3
            else rotary_seen(axes[letter], other, change[k], -lines[k - 3])
        )
        amount = Length(change[k], "+g") if k < 3 else Angle(math.degrees(change[k]), "+g")
        stops.append(
            Stop(
                say("{letter} alone, {amount}", letter=letter, amount=amount),
                (base + change)[None],
                *sentence,
            )
        )
        stops.append(Stop(say("{letter} back", letter=letter), base[None]))
    last, turned = _last_pose(kinematics, wishes, both, distance), base + np.array([0.0, 0.0, 0.0, *both])
    stops.append(
        Stop(
            say("both rotary axes turned, tip over the mark"),
            np.array([turned, last]),
            *_last_seen(kinematics, both, distance),
        )
    )
    return [*stops, Stop(say("back"), np.array([turned, base]))]


def _travel(kinematics: Chain, k: int, base: Floats, travel: float) -> float:
    """To the positive side, or to the other one where that leaves the limits."""
    return travel if base[k] + travel <= kinematics.high[k] or k == 2 else -travel


def _first_stop(base: Floats, kinematics: Chain) -> Stop:
    place = ", ".join(
        f"{letter} {value:g}" for letter, value in zip(kinematics.letters, base.tolist(), strict=True)
    )
    see = say(
        "The display shows {place}. The tool stands upright, the table level. Nothing is near the tool.",
        place=place,
    )
    bad = say("A display or pose that differs: work offset, tool length or zero positions are not set.")
    return Stop(say("start"), base[None], see, bad)


def _mark_stop(low: Floats, wishes: Wishes) -> Stop:
    see = say(
        "The tip stands {gap} over the highest place of part and clamps (a gauge block fits). Draw a cross "
        "on part or plate straight below the tip: this is the mark.",
        gap=Length(wishes.gap),
    )
    bad = say(
        "More or less room than {gap}: tool length, work offset or {mark} are wrong. Do not go on.",
        gap=Length(wishes.gap),
        mark=Option("mark"),
    )
    return Stop(say("the mark"), np.array([low]), see, bad)


def _last_seen(kinematics: Chain, angles: Floats, distance: float) -> tuple[Sentence, Sentence]:
    first, second = (Angle(math.degrees(angle)) for angle in angles.tolist())
    see = say(
        "With {letter} at {first} and {other} at {second} the tool points at the cross: its tip is "
        "{distance} from it, measured along the tool.",
        letter=kinematics.letters[3],
        first=first,
        other=kinematics.letters[4],
        second=second,
        distance=Length(distance),
    )
    bad = say(
        "The tool points elsewhere: see the table below for what that means. Signs seen right: pivot offsets "
        "are wrong."
    )
    return see, bad


def _check_limits(kinematics: Chain, q: Floats) -> None:
    over = np.maximum(q - kinematics.high, kinematics.low - q).max(axis=0)
    k = int(np.argmax(over))
    if over[k] > 1e-9:
        unit, factor = ("mm", 1.0) if k < 3 else ("deg", 180.0 / math.pi)
        text = say(
            "{letter} would leave its limits by {over}",
            letter=kinematics.letters[k],
            over=measure(over[k] * factor, unit, ".4g"),
        )
        raise SettingsError(
            say(
                "{text}; give another {origin} or {mark}, or less {gap}, {travel} or {angle}",
                text=text,
                origin=Option("origin"),
                mark=Option("mark"),
                gap=Option("gap"),
                travel=Option("travel"),
                angle=Option("angle"),
            ),
            float(over[k]),
        )


def _report_missing_mark(wishes: Wishes) -> list[Finding]:
    """Return what must be true where nobody has said how high part and clamps reach."""
    if wishes.mark is not None:
        return []
    z = wishes.place[2]
    text = say(
        "Nothing may stand above Z {z} of the work zero: remove the part, or give {mark} as high as part and "
        "clamps reach.",
        z=Length(z, bare=True),
        mark=Option("mark"),
    )
    return [report_finding(Code.MARK_NOT_GIVEN, text, z)]


def _findings(predicted_errors: tuple[tuple[str, Floats], ...]) -> list[Finding]:
    found = []
    for text, moved in predicted_errors:
        size = float(np.linalg.norm(moved))
        if size < VISIBLE:
            sentence = say(
                "If {text}, the tip is off by {size} only at the last stop, which is easily overlooked: rely "
                "on the stops",
                text=text,
                size=Length(size, ".2g"),
            )
            sentence += " before it, or give a --mark farther from the rotary axes or a larger --angle."
            found.append(report_finding(Code.WRONG_SIGN_HARDLY_SEEN, sentence, size, VISIBLE))
    return found
