# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a part stands on: its lowest facets where they look straight down and lie under its middle on all
sides.

How a part is held is not known. A flat underside on which it can stand is where it most likely lies on
something, so that nobody expects a tool there unless he asks for it; a part without one is held otherwise,
and all of it is free.
"""

from __future__ import annotations

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, Length, Number, Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .within_limits import LEVEL, measure_facets

NEAR = 1e-12
"""Of the size of what the part stands on: so near to its border a place is within it."""

FLAT = 0.9999
"""Of -Z in the normal, at least: of a facet on which a part stands."""


def standing_facets(mesh: Mesh) -> Bools:
    """Mask (f,) of the facets on which the part stands; none where they do not surround the middle of its
    surface from below."""
    height, size = mesh.vertex[mesh.face, 2].max(axis=1), float(np.ptp(mesh.vertex, axis=0).max())
    flat = (mesh.normal[:, 2] < -FLAT) & (height <= float(mesh.box[0][2]) + LEVEL * size)
    corner = mesh.vertex[mesh.face[flat]].reshape(-1, 3)[:, :2]
    return np.asarray(flat & _surround(corner, _middle(mesh)))


def report_standing(mesh: Mesh, standing: Bools) -> tuple[Finding, ...]:
    """Say how much of the part it stands on; nothing where there is no such facet."""
    if not standing.any():
        return ()
    area, (x, y, z) = measure_facets(mesh, standing)
    text = say(
        "The underside at Z {height} is not machined: the part stands on these {area} ({share} %). Cut "
        "them in another setup; with the part held off the table, {max_axis_angle} has them cut in this one.",
        height=Length(round(z, 3) + 0.0, bare=True), area=Area(area, ".6g"),
        share=Number(100.0 * area / float(mesh.area.sum()), ".3g"), max_axis_angle=Option("max_axis_angle"),
    )  # fmt: skip
    return (report_finding(Code.FACETS_LOOKING_DOWN, text, area, 0.0, place=(x, y, z)),)


def _middle(mesh: Mesh) -> Floats:
    """Return the middle (2,) of the surface, mm, seen from above."""
    return np.asarray(np.average(mesh.vertex[mesh.face].mean(axis=1)[:, :2], axis=0, weights=mesh.area))


def _surround(corner: Floats, middle: Floats) -> bool:
    """Whether the place ``middle`` (2,) lies within the hull of the corners (k, 2)."""
    try:
        side = scipy.spatial.ConvexHull(corner).equations
        return bool((side[:, :2] @ middle + side[:, 2] <= NEAR * np.ptp(corner)).all())
    except (scipy.spatial.QhullError, ValueError):  # too few corners, or all on one line
        return False
