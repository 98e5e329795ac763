# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which facets the machine can cut with the tool along the facet normal.

axis angle    angle between the facet normal and +Z of the work frame; the tool axis leans by it.
looking down  an axis angle over 90 deg: the part stands on such facets, or hangs over.
within reach  one branch of the inverse kinematics has both rotary words within their limits, whole turns
              added where needed.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cache_chunks, dot
from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Angle, Area, Length, Number, Sentence, Template, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import BEYOND, Chain, inverse_axis

LEVEL = 1e-4
"""rad: STL files keep coordinates to 1e-7 of their size, so the normals of small facets, those of walls too,
are this far off."""

WORD_ERROR = 1e-9
"""rad: a word that misses its limit by less is on it; rounding of the inverse, far below any controller's
step."""

FLAT = 1e-8
"""Where a cosine is so near to 1 or -1, its rounding (1e-16) is worth more than WORD_ERROR / 100 of angle."""

TURN = 2.0 * math.pi

ROOM = math.radians(2.0)
"""To the rotary limits, where axes are chosen freely."""

SHARES = (0.25, 0.5, 0.75)
"""Of the way between two axes: where it is asked whether they are within the limits, too."""

NEARLY = 0.99
"""Of the area that faces away: where so much is the level underside, the rest is not worth a word."""


_DOWN = Template(
    "{count} facets of {area} ({share} % of the part) face away from the spindle and are left out; turn the "
    "part over to cut them, or raise the largest axis angle."
)
_STEEP = Template(
    "{count} facets of {area} ({share} % of the part) lean more than {most} from Z and are left out; raise "
    "the largest axis angle to cut them."
)
_BEYOND = Template(
    "{count} facets of {area} ({share} % of the part) need {limits} beyond its limits and are left out; "
    "turn the part or take another machine to cut them."
)
_NO_AXIS = Template(
    "{count} facets of {area} ({share} % of the part) need a tool axis to which no rotary axis of the "
    "machine turns and are left out; turn the part or take another machine to cut them."
)


def facets_within_limits(
    mesh: Mesh, kinematics: Chain | None, max_axis_angle: float, wanted: Bools | None = None
) -> tuple[Bools, tuple[Finding, ...]]:
    """Mask (f,) of the facets that can be cut with the tool along their normal, and what of the wanted ones
    is left out.

    ``max_axis_angle`` rad: the largest axis angle that is wanted, over 0 and at most pi; beyond pi / 2 facets
    that look down are cut up to it. Vertical walls count as 90 deg.
    ``kinematics`` None: the tool axis does not follow the facets. ``wanted`` (f,): the facets that were
    chosen, None: all. Raises SettingsError for another angle, ReachError where no facet is left.
    """
    if not 0.0 < max_axis_angle <= math.pi:
        angle = math.degrees(max_axis_angle)
        raise SettingsError(
            say(
                "largest axis angle {angle} is out of range; give more than 0 and at most 180 deg",
                angle=Angle(angle),
            ),
            max_axis_angle,
        )
    up = mesh.normal[:, 2]
    wanted = np.ones(len(up), np.bool_) if wanted is None else wanted
    down = (up < (-math.sin(LEVEL) if max_axis_angle <= math.pi / 2 else least_up(max_axis_angle))) & wanted
    steep = (up < least_up(max_axis_angle)) & wanted & ~down
    rest = np.flatnonzero(wanted & ~(down | steep))
    beyond = np.zeros(len(up), dtype=np.bool_)

    def check(part: slice) -> None:
        rows = rest[part]
        beyond[rows] = (
            ~axes_within_limits(kinematics, mesh.normal.T.take(rows, axis=1).T)
            if kinematics is not None
            else False
        )

    in_threads(check, chunks(len(rest)))
    keep: Bools = wanted & ~(down | steep | beyond)
    if np.array_equal(keep, wanted) and keep.any():
        return keep, ()
    area = mesh.area
    if not keep.any():
        raise ReachError(
            _nothing_left(area, down, steep, beyond, max_axis_angle), math.degrees(max_axis_angle)
        )
    found = (
        _looking_down(mesh, area, down),
        report_too_steep(mesh, area, steep, max_axis_angle),
        report_beyond(mesh, area, beyond, kinematics),
    )
    return keep, tuple(finding for finding in found if finding is not None)


def facets_under_axes(mesh: Mesh, max_axis_angle: float) -> Bools:
    """Mask (f,) of the facets over which an axis within ``max_axis_angle`` rad of +Z can lean: on others no
    tool stands."""
    lean = max_axis_angle + 0.5 * math.pi - LEVEL
    return np.asarray(mesh.normal[:, 2] > (math.cos(lean) if lean < math.pi else -math.inf))


def least_up(max_axis_angle: float) -> float:
    """Give the least z of unit vectors that lean no more than ``max_axis_angle``, rad, from +Z."""
    return math.cos(min(max_axis_angle + LEVEL, math.pi))


def axes_within_limits(kinematics: Chain, axis: Floats) -> Bools:
    """Return True (n,) where the machine can take up the unit tool axis (n, 3) with both rotary words within
    their limits."""
    ends = _second_alone(kinematics)
    if ends is not None:
        least, most = ends
        along = np.asarray(dot(kinematics.direction[3].tolist(), list(axis.T)))
        return (along >= least) & (along <= most)
    within = np.empty(len(axis), dtype=np.bool_)
    for part in cache_chunks(len(axis)):
        words, sine = inverse_axis(kinematics, axis[part])
        first = _is_within_turns(words[:, :, 0], kinematics.low[3], kinematics.high[3])
        first |= sine == 0.0  # at the pole any first word will do
        second = _is_within_turns(words[:, :, 1], kinematics.low[4], kinematics.high[4])
        within[part] = (first & second).any(axis=0)
    return within


def with_room(kinematics: Chain, room: float = ROOM) -> Chain:
    """Narrow the rotary limits by ``room`` rad at either end, a quarter of the range at most: between axes
    that are within them the machine then stays within its own."""
    by = np.minimum(room, 0.25 * (kinematics.high[3:] - kinematics.low[3:]))
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[3:] += by
    high[3:] -= by
    return replace(kinematics, low=low, high=high)


def turns_within_limits(kinematics: Chain, one: Floats, other: Floats) -> Bools:
    """Return True (n,) where the machine can take up what lies between unit tool axes ``one`` and ``other``
    (n, 3), too, when the axis turns straight: between two at its limits it would go beyond them. It is asked
    at some places and at the extremes of the turn."""
    chord = other - one
    angle = 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(chord, axis=1), 0.0, 1.0))
    ahead = chord - (chord * one).sum(axis=1)[:, None] * one
    length = np.linalg.norm(ahead, axis=1)
    ahead /= np.where(length > 0.0, length, 1.0)[:, None]
    within: Bools = (length > 0.0) | (angle < 1.0)
    for turn in (*(share * angle for share in SHARES), *_find_extremes(kinematics.direction[3], one, ahead)):
        turned = np.clip(turn, 0.0, angle)[:, None]
        within &= axes_within_limits(kinematics, np.cos(turned) * one + np.sin(turned) * ahead)
    return within


def _find_extremes(first: Floats, one: Floats, ahead: Floats) -> tuple[Floats, ...]:
    """Tell after which turns (n,) rad, from unit axes ``one`` towards unit ``ahead`` (n, 3), the axis leans
    most and least against the ``first`` rotary axis: there the second one has most to do."""
    most = np.arctan2(ahead @ first, one @ first)
    return most, most + math.pi, most - math.pi


def _second_alone(kinematics: Chain) -> tuple[float, float] | None:
    """Least and largest component along the first rotary axis that the second one can give the tool axis
    within its limits.

    Where the first axis turns all the way, an axis with such a component is within reach, and no other: the
    first never changes the component, and turns the rest anywhere. By Rodrigues it is ``mean + reach cos(word
    - top)``. None where the first axis is limited, or the second one's limit lies where the cosine is too
      flat to tell.
    """
    if kinematics.high[3] - kinematics.low[3] < TURN or kinematics.low[4] > kinematics.high[4]:
        return None
    first, second = kinematics.direction[3], kinematics.direction[4]
    mean = float(first @ second) * float(second[2])
    cosine, sine = float(first[2]) - mean, float(first[0] * second[1] - first[1] * second[0])
    reach, top = math.hypot(cosine, sine), math.atan2(sine, cosine)
    low, high = kinematics.low[4] - WORD_ERROR - top, kinematics.high[4] + WORD_ERROR - top
    if high - low >= TURN:
        return mean - (1.0 + BEYOND) * reach, mean + (1.0 + BEYOND) * reach
    at_top = math.floor(high / TURN) >= low / TURN  # a whole turn lies between
    at_bottom = math.floor(high / TURN - 0.5) >= low / TURN - 0.5
    ends = math.cos(low), math.cos(high)
    most, least = 1.0 if at_top else max(ends), -1.0 if at_bottom else min(ends)
    if (not at_top and abs(most) > 1.0 - FLAT) or (not at_bottom and abs(least) > 1.0 - FLAT):
        return None
    return mean + (least - BEYOND) * reach, mean + (most + BEYOND) * reach


def _is_within_turns(word: Floats, low: float, high: float) -> Bools:
    """Return True where the word, rad, lies between the limits after whole turns; NaN never does."""
    if high - low >= TURN:
        return np.isfinite(word)
    first = word + TURN * np.ceil((low - WORD_ERROR - word) / TURN)  # the lowest that is not below ``low``
    within: Bools = first <= high + WORD_ERROR
    return within


def _looking_down(mesh: Mesh, area: Floats, out: Bools) -> Finding | None:
    found = _report_left_out(Code.FACETS_LOOKING_DOWN, _DOWN, mesh, area, out)
    low, size = float(mesh.vertex[:, 2].min()), float(np.ptp(mesh.vertex))
    level = out & (mesh.vertex[mesh.face, 2].max(axis=1) <= low + LEVEL * size)
    if found is None or area[level].sum() < NEARLY * area[out].sum():
        return found
    lost, share = float(area[out].sum()), 100.0 * float(area[out].sum() / area.sum())
    text = say(
        "The underside at Z {height} is not machined: {area} ({share} % of the part) face away from the "
        "spindle. Turn the part over to cut it.",
        height=Length(round(low, 3) + 0.0, bare=True),
        area=Area(lost, ".6g"),
        share=Number(share, ".3g"),
    )
    return replace(found, text=text)


def report_too_steep(mesh: Mesh, area: Floats, out: Bools, most: float) -> Finding | None:
    """Say how much area the facets ``out`` (f,) have that lean more than ``most`` rad."""
    angle = Angle(math.degrees(most))
    return _report_left_out(Code.FACETS_BEYOND_AXIS_ANGLE, _STEEP, mesh, area, out, most=angle)


def report_beyond(mesh: Mesh, area: Floats, out: Bools, kinematics: Chain | None) -> Finding | None:
    """Say how much area the facets ``out`` (f,) have that need rotary words beyond the limits."""
    if kinematics is None:
        return None
    limits = _limits(kinematics)
    if limits is None:
        return _report_left_out(Code.FACETS_BEYOND_MACHINE, _NO_AXIS, mesh, area, out)
    return _report_left_out(Code.FACETS_BEYOND_MACHINE, _BEYOND, mesh, area, out, limits=limits)


def _limits(kinematics: Chain) -> Sentence | None:
    """Name the rotary axes that have limits, with these; None where none has: one that turns all the way
    keeps the tool off nowhere."""
    spans = np.degrees([kinematics.low[3:], kinematics.high[3:]]).T.tolist()
    one, other = (
        say("{letter} ({low} to {high})", letter=letter, low=Angle(low, bare=True), high=Angle(high))
        for letter, (low, high) in zip(kinematics.letters[3:], spans, strict=True)
    )
    first, second = (kinematics.high[3:] - kinematics.low[3:] < TURN).tolist()
    if not kinematics.axes[4].fitted:
        return one if first else None
    if first and second:
        return say("{one} or {other}", one=one, other=other)
    return one if first else other if second else None


def _report_left_out(
    code: Code, text: Template, mesh: Mesh, area: Floats, out: Bools, **values: Any
) -> Finding | None:
    """Return the finding that says how much area is left out; its place is the centre of the largest such
    facet."""
    rows = np.flatnonzero(out)
    if not len(rows):
        return None
    lost, total = float(area[rows].sum()), float(area.sum())
    largest = rows[np.argmax(area[rows])]
    x, y, z = (float(v) for v in mesh.vertex[mesh.face[largest]].mean(axis=0))
    share = Number(100.0 * lost / total, ".3g")
    sentence = text.say(count=len(rows), area=Area(lost, ".6g"), share=share, **values)
    return report_finding(code, sentence, lost, place=(x, y, z))


def measure_facets(mesh: Mesh, chosen: Bools) -> tuple[float, tuple[float, float, float]]:
    """Return the area, mm2, of the ``chosen`` facets (f,), one at least, and the middle of the largest."""
    area = np.where(chosen, mesh.area, 0.0)
    x, y, z = mesh.vertex[mesh.face[int(area.argmax())]].mean(axis=0).tolist()
    return float(mesh.area[chosen].sum()), (x, y, z)


def _nothing_left(area: Floats, down: Bools, steep: Bools, beyond: Bools, most: float) -> Sentence:
    down_share, steep_share, beyond_share = (
        Number(100.0 * float(area[mask].sum() / area.sum()), ".3g") for mask in (down, steep, beyond)
    )
    return say(
        "no facet can be cut: {down} % look down, {steep} % lean more than {most}, {beyond} % lie beyond the "
        "machine's rotary "
        "limits of the area; turn the part, raise the largest axis angle or take another machine",
        down=down_share,
        steep=steep_share,
        most=Angle(math.degrees(most)),
        beyond=beyond_share,
    )
