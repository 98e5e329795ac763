# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes: where the planes lie, which facets they may cut, what they cut out of the mesh, and which sides they leave out."""

from .arc_curvature import arc_centre, arc_curvature, pass_curvature
from .passes import ContactPath, direction, slice_mesh
from .scallop import CREASE, facet_curvature, flat_interval, turned_along
from .sides import side_findings, untouched_sides
from .spacing import place_planes
from .within_limits import axes_within_limits, facets_within_limits

__all__ = [
    "CREASE",
    "ContactPath",
    "arc_centre",
    "arc_curvature",
    "axes_within_limits",
    "direction",
    "facet_curvature",
    "facets_within_limits",
    "flat_interval",
    "pass_curvature",
    "place_planes",
    "side_findings",
    "slice_mesh",
    "turned_along",
    "untouched_sides",
]  # fmt: skip
