# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open surfaces: which of their two sides is machined is what their normals say, and nothing else."""

from __future__ import annotations

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Area, Number, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .within_limits import measure_facets

ALL = 0.99
"""Of the area: where so much of an open surface looks down its normals are most likely turned round."""


def report_far_side(mesh: Mesh) -> tuple[Finding, ...]:
    """Say that an open surface looks down nearly everywhere, so that its underside is machined; nothing of a
    closed mesh, whose facets are turned outward when it is read."""
    down = mesh.normal[:, 2] < 0.0
    (area, place), whole = measure_facets(mesh, down), float(mesh.area.sum())
    if area < ALL * whole or not (mesh.coedge_face[:, 1] < 0).any():
        return ()
    text = say(
        "{share} % of this open surface ({area}) look down, so its underside is machined. If its upper side "
        "is meant, turn its normals round (in FreeCAD: Flip normals of a mesh, Reverse shapes of a face).",
        share=Number(100.0 * area / whole, ".3g"),
        area=Area(area, ".6g"),
    )
    return (report_finding(Code.SURFACE_LOOKS_DOWN, text, area, 0.0, place=place),)
