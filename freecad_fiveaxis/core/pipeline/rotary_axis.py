# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis about which a part turns under the tool, where the settings leave it open.

own axis   of a machine of one rotary axis: that axis. Where a table turns, its line stands still in the
           part's frame; a head's line moves with the tool, so that only its direction counts.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes.radial_passes import MIDDLE, check_centre, unit_axis

from .settings import Settings
from .settings.tree import FROM_AXIS, ROTARY


def settle_rotary_axis(settings: Settings, kinematics: Chain, mesh: Mesh) -> Settings:
    """Give the settings the centre and the axis of passes or tool axes about a rotary axis as numbers: as
    asked; else the machine's only rotary axis; else through the middle of the part's box along its longest
    side. Raises SettingsError for a centre that is none and an axis of no direction."""
    passes = settings.passes
    if passes.passes != ROTARY and settings.tool_axis.tool_axis != FROM_AXIS:
        return settings
    check_centre(passes.pass_centre)
    line = own_axis(kinematics)
    about, through = passes.pass_axis, passes.pass_centre
    if through == MIDDLE:
        known = None if line is None or about is not None else line[1]
        through = _numbers(np.asarray(mesh.box).mean(axis=0)) if known is None else known
    if about is None:
        about = _longest_side(mesh) if line is None else line[0]
    about = _numbers(unit_axis(about))
    return replace(settings, passes=replace(passes, pass_axis=about, pass_centre=through))


def own_axis(kinematics: Chain) -> tuple[Vector, Vector | None] | None:
    """Find the direction of the machine's only rotary axis and a point of it, mm, in the work frame; no point
    where its line moves with the tool. None where the machine has no rotary axis, or two."""
    fitted = [i for i, axis in enumerate(kinematics.axes[3:]) if axis.fitted]
    if len(fitted) != 1:
        return None
    at = fitted[0]
    point = (kinematics.point1, kinematics.point2)[at]
    stands = all(slot > at for slot in kinematics.slot)
    return _numbers(kinematics.direction[3 + at]), _numbers(point) if stands else None


def turns_the_part(kinematics: Chain) -> bool:
    """Whether the machine's only rotary axis turns the part: then the tool stays above it, whichever side it
    cuts."""
    line = own_axis(kinematics)
    return line is not None and line[1] is not None


def _longest_side(mesh: Mesh) -> Vector:
    return _numbers(np.eye(3)[np.ptp(np.asarray(mesh.box), axis=0).argmax()])


def _numbers(vector: Floats) -> Vector:
    x, y, z = vector.tolist()
    return (x, y, z)
