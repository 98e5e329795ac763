# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes led through or around the pole, pass by pass, where that makes the machine turn less.

change     the angle between the axis that a strategy gives and the axis that is led; at most what the user
           allows.
lead       to change the axis of a pass near the pole such that the first rotary axis turns little and evenly;
           after the idea of Affouard et al. (Avoiding 5-axis singularities using tool path deformation,
           2004), which moves the axis' path off a fixed cone. Here the way is found by :mod:`.rerouting`, and
           kept only where driving it on the machine proves it better (:mod:`.choice`).

Only the axis moves. Contact points and ball centres stay what they are, so a ball-end cutter cuts the same
surface; any other cutter sits anew on its contact (:mod:`~freecad_fiveaxis.core.toolpath.cl_offset`).
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.ranges import LARGEST_CHANGE, LEAST_CHANGE
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Angle, Turn, say
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .choice import ReroutedAxes, near_polylines, reroute_axes
from .drive import starts
from .meridian import Globe, angle_between

STEADY = math.radians(0.1)
"""rad/mm; a first word that turns no faster needs no leading, and no finding where there was none."""


def deform_axes(
    offset: OffsetPath, axis: Floats, kinematics: Chain, max_change: float, progress: Progress = silent
) -> tuple[Floats, tuple[Finding, ...]]:
    """Return unit tool axes (n, 3) led past the pole, and what there is to say about them.

    ``axis`` (n, 3) unit, one for each row of ``offset``, all within the machine's reach
    (:func:`~.feasible.feasible_rows` first); ``max_change`` rad: the largest angle between the given and the
    led axis. Rows of one contact point keep one axis between them; rows of passes that do not come near the
    pole, or that do not get better, keep the given axis to the last bit. Raises SettingsError for an angle
    out of range, ReachError for axes beyond the machine's limits.
    """
    check_change(max_change)
    found = reroute_axes(offset, np.asarray(axis, float), kinematics, max_change, progress)
    if found is None:
        return axis, ()
    return found.axis, _findings(offset, axis, kinematics, found, max_change)


def check_change(change: float) -> None:
    """Raise SettingsError for an allowed change (rad) that is none."""
    if not LEAST_CHANGE <= change <= LARGEST_CHANGE:
        raise SettingsError(
            say(
                "the axis may change by {change}; give an angle from {least_change} to {largest_change}",
                change=Angle(math.degrees(change)),
                least_change=Angle(math.degrees(LEAST_CHANGE), bare=True),
                largest_change=Angle(math.degrees(LARGEST_CHANGE)),
            ),
            change,
        )


def _findings(
    offset: OffsetPath, axis: Floats, kinematics: Chain, found: ReroutedAxes, change: float
) -> tuple[Finding, ...]:
    """Return what was led, and what still turns fast near the pole."""
    globe, letter, limit = Globe.of(kinematics), kinematics.letters[3], math.degrees(change)
    findings = []
    if found.rerouted.any():
        most = math.degrees(float(angle_between(found.axis, axis).max()))
        before, after = (
            math.degrees(float(part.peak[found.rerouted].max())) for part in (found.before, found.after)
        )
        turned, turns = (
            math.degrees(float(part.first[found.rerouted].sum())) for part in (found.before, found.after)
        )
        text = say(
            "{count} passes are turned past the pole: {letter} turns at most {after} instead of {before} on "
            "them, and {turns} instead of {turned} in all, for an axis changed by up to {most}.",
            count=int(found.rerouted.sum()),
            letter=letter,
            after=Turn(after, ".3g", bare=True),
            before=Turn(before, ".3g"),
            turns=Angle(turns, ".0f", bare=True),
            turned=Angle(turned, ".0f"),
            most=Angle(most, ".3f"),
        )
        worst = np.flatnonzero(found.rerouted)[found.before.peak[found.rerouted].argmax()]
        place = _nearest_place(offset, axis, globe, int(worst))
        findings.append(report_finding(Code.AXIS_LED_PAST_POLE, text, most, limit, place=place))
    left = np.flatnonzero(
        near_polylines(offset, axis, globe, change) & ~found.rerouted & (found.after.peak > STEADY)
    )
    if len(left):
        worst = left[found.after.peak[left].argmax()]
        rate = math.degrees(float(found.after.peak[worst]))
        text = say(
            "{count} passes come within {limit} of the pole and could not be turned past it any better: "
            "{letter} "
            "turns up to {rate} there. A larger angle, wider rotary limits or another setup may help.",
            count=len(left),
            limit=Angle(limit),
            letter=letter,
            rate=Turn(rate, ".3g"),
        )
        place = _nearest_place(offset, axis, globe, int(worst))
        findings.append(report_finding(Code.AXIS_LEFT_NEAR_POLE, text, rate, place=place))
    return tuple(findings)


def _nearest_place(
    offset: OffsetPath, axis: Floats, globe: Globe, polyline: int
) -> tuple[float, float, float]:
    """Return the contact point at which the axis of a polyline is nearest to the pole."""
    begin = starts(offset.polyline)
    rows = slice(int(begin[polyline]), int(np.append(begin, len(axis))[polyline + 1]))
    x, y, z = offset.point[
        rows.start + int(np.linalg.norm(globe.across(axis[rows]), axis=1).argmin())
    ].tolist()
    return x, y, z
