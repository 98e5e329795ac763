# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of an offset path the tool can take up once its axis is chosen; the rest is left out, with findings.

leaning in   the axis points below the surface at the contact: the shank would stand in the part.
undercut     of a lollipop: so far the axis may point below the surface, where its neck has been asked for.
flank        the cone of a tapered cutter would stand in the part: the axis leans further from the normal than
             90 deg - taper.
beyond       no branch of the machine takes up the axis within its rotary limits (lead and tilt may lead
             there, though the facet's own normal is within reach).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, take_rows
from freecad_fiveaxis.core.base.sentences import Length, Point, Template
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes import axes_within_limits

from .coedge import OffsetPath, lasting_rows, take_path_rows

LEAN = 1e-6
"""rad below the surface that rounding may make of an axis that lies in it."""


_LEANING = Template(
    "The tool leans into the part over {length} of the passes, the first at {at}; they are left out. Choose "
    "another tool axis, lead or tilt, or cut these places in another set-up."
)
_FLANK = Template(
    "The flank of the tapered cutter leans into the part over {length} of the passes, the first at {at}; "
    "they are left out. Choose another tool axis, lead or tilt, or a cutter of less taper."
)
_BEYOND = Template(
    "The tool axis is beyond the rotary limits over {length} of the passes, the first at {at}; they are "
    "left out. Use less lead or tilt, clamp the part in another position, or take another machine."
)


def feasible_rows(
    path: OffsetPath, axis: Floats, kinematics: Chain, taper: float = 0.0, undercut: float = 0.0
) -> tuple[OffsetPath, Floats]:
    """Return the rows that can be cut with their axis (n, 3), and their axes; the path's findings say what is
    left out. ``taper`` rad of the cutter's flank; ``undercut`` rad by which the axis may lean below the
    surface."""
    rise = np.empty(len(axis))
    in_threads(lambda rows: (path.normal[rows] * axis[rows]).sum(axis=1, out=rise[rows]), chunks(len(axis)))
    lowest = -np.sin(undercut) - LEAN
    leaning = rise < lowest
    leaning[path.beside] |= (path.wall * axis[path.beside]).sum(
        axis=1
    ) < lowest  # it would retract through that wall
    flank = ~leaning & (rise < (np.sin(taper) - LEAN if taper > 0.0 else lowest))
    beyond = ~(leaning | flank) & ~axes_within_limits(kinematics, axis)
    out = leaning | flank | beyond
    if not out.any():
        return path, axis
    found = (
        _report_left_out(path, leaning, Code.AXIS_INTO_PART, _LEANING),
        _report_left_out(path, flank, Code.FLANK_INTO_PART, _FLANK),
        _report_left_out(path, beyond, Code.AXIS_BEYOND_LIMITS, _BEYOND),
    )  # fmt: skip
    rows = lasting_rows(path, np.flatnonzero(~out))
    left = take_path_rows(path, rows)
    findings = path.findings + tuple(finding for finding in found if finding is not None)
    return replace(left, findings=findings), take_rows(axis, rows)


def _report_left_out(path: OffsetPath, out: Bools, code: Code, text: Template) -> Finding | None:
    first = int(out.argmax())
    if not out[first]:
        return None
    steps = np.linalg.norm(np.diff(path.point, axis=0), axis=1)
    length = float(steps[(out[1:] | out[:-1]) & (np.diff(path.polyline) == 0)].sum())
    x, y, z = path.point[first].tolist()
    sentence = text.say(length=Length(length, ".1f"), at=Point((x, y, z), "g"))
    return report_finding(code, sentence, length, 0.0, place=(x, y, z))
