# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which facets a tool reaches that stands square to an axis and points at it, as the part turns under it.

outward   the way from the axis to the middle of a facet: there the tool's own axis.
across    a facet that does not face outward: an end of the part, a shoulder, a bore.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, Number, say
from freecad_fiveaxis.core.base.vectors import away_from, row_dot
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain

from .within_limits import axes_within_limits, least_up, report_beyond, report_too_steep

ACROSS = math.sin(math.radians(1.0))
"""Cosine between a facet's normal and the way outward up to which the facet lies across: the tool would only
pass along it."""


def facets_outward(mesh: Mesh, through: Floats, about: Floats) -> tuple[Bools, Floats]:
    """Find which facets (f,) face away from the axis ``through`` a point (3,), mm, along unit ``about`` (3,),
    and the unit way outward (f, 3) at their middles."""
    outward, _ = away_from(mesh.vertex[mesh.face].mean(axis=1), through, about)
    return row_dot(mesh.normal, outward) > ACROSS, outward


def facets_around(
    mesh: Mesh, kinematics: Chain, through: Floats, about: Floats, most: float, wanted: Bools | None = None
) -> tuple[Bools, tuple[Finding, ...]]:
    """Find the facets (f,) of the ``wanted`` (f,), None: all, that a tool square to the axis reaches on the
    machine, leaning from +Z by ``most`` rad at most, and say what is left out. Raises ReachError where no
    facet is left."""
    wanted = np.ones(len(mesh.face), np.bool_) if wanted is None else wanted
    faces, outward = facets_outward(mesh, through, about)
    across = wanted & ~faces
    steep = wanted & faces & (outward[:, 2] < least_up(most))
    rest = wanted & faces & ~steep
    beyond = rest.copy()
    beyond[rest] = ~axes_within_limits(kinematics, outward[rest])
    keep = rest & ~beyond
    if not keep.any():
        raise ReachError(_nothing_left(mesh, wanted, across, beyond), None)
    found = (
        report_across(mesh, across), report_too_steep(mesh, mesh.area, steep, most),
        report_beyond(mesh, mesh.area, beyond, kinematics),
    )  # fmt: skip
    return keep, tuple(finding for finding in found if finding is not None)


def report_across(mesh: Mesh, across: Bools) -> Finding | None:
    """Say how much area the facets (f,) have that lie across the axis; its place is the middle of the
    largest."""
    rows = np.flatnonzero(across)
    if not len(rows):
        return None
    lost = float(mesh.area[rows].sum())
    x, y, z = (float(v) for v in mesh.vertex[mesh.face[rows[np.argmax(mesh.area[rows])]]].mean(axis=0))
    text = say(
        "{count} facets of {area} ({share} % of the part) lie across the axis of the passes or face it, and "
        "are left out: a tool square to that axis does not reach them. Cut them with other passes.",
        count=len(rows), area=Area(lost, ".6g"), share=Number(100.0 * lost / float(mesh.area.sum()), ".3g"),
    )  # fmt: skip
    return report_finding(Code.FACETS_ACROSS_AXIS, text, lost, place=(x, y, z))


def _nothing_left(mesh: Mesh, wanted: Bools, across: Bools, beyond: Bools) -> str:
    whole = float(mesh.area[wanted].sum()) or 1.0
    shares = [Number(100.0 * float(mesh.area[mask].sum()) / whole, ".3g") for mask in (across, beyond)]
    return say(
        "no facet can be cut: {across} % of the area lie across the axis of the passes or face it, {beyond} "
        "% need a tool axis beyond the machine's rotary limits; give the axis about which the part is "
        "turned, or take another machine",
        across=shares[0], beyond=shares[1],
    )  # fmt: skip
