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
from freecad_fiveaxis.core.geometry.mesh.lumps import number_apart, number_lumps

from .within_limits import LEVEL, measure_facets

NEAR = 1e-12
"""Of the size of what the part stands on: so near to its border a place is within it."""

FLAT = 0.9999
"""Of -Z in the normal, at least: of a facet on which a part stands."""


def standing_facets(mesh: Mesh) -> Bools:
    """Mask (f,) of the facets on which the part stands; none where they do not surround the middle of its
    surface from below. Of a closed part in several lumps that do not touch each may stand by itself."""
    height, size = mesh.vertex[mesh.face, 2].max(axis=1), float(np.ptp(mesh.vertex, axis=0).max())
    flat = (mesh.normal[:, 2] < -FLAT) & (height <= float(mesh.box[0][2]) + LEVEL * size)
    whole = np.ones(len(flat), np.bool_)
    if not flat.any() or _stands(mesh, flat, whole):
        return np.asarray(flat)
    lump = number_lumps(mesh.coedge_face, len(mesh.face))
    if not lump.any() or (mesh.coedge_face[:, 1] < 0).any():
        return np.zeros(len(flat), np.bool_)
    apart = number_apart(mesh.vertex, mesh.face, lump)
    low = np.unique(apart[flat])
    standing = low[[_stands(mesh, flat & (apart == one), apart == one) for one in low]]
    return np.asarray(flat & np.isin(apart, standing))


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


def _stands(mesh: Mesh, flat: Bools, lump: Bools) -> bool:
    """Tell whether the facets ``flat`` (f,) surround the middle of the facets ``lump`` (f,)."""
    return _surround(mesh.vertex[mesh.face[flat]].reshape(-1, 3)[:, :2], _middle(mesh, lump))


def _middle(mesh: Mesh, lump: Bools) -> Floats:
    """Return the middle (2,) of the surface of these facets (f,), mm, seen from above."""
    place = mesh.vertex[mesh.face[lump]].mean(axis=1)[:, :2]
    return np.asarray(np.average(place, axis=0, weights=mesh.area[lump]))


def _surround(corner: Floats, middle: Floats) -> bool:
    """Whether the place ``middle`` (2,) lies within the hull of the corners (k, 2)."""
    try:
        side = scipy.spatial.ConvexHull(corner).equations
        return bool((side[:, :2] @ middle + side[:, 2] <= NEAR * np.ptp(corner)).all())
    except (scipy.spatial.QhullError, ValueError):  # too few corners, or all on one line
        return False
