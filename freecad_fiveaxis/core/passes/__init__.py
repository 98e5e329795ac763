# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes: where the planes lie, which facets they may cut, and what they cut out of the mesh."""

from .arc_curvature import arc_centre, arc_curvature, pass_curvature
from .passes import ContactPath, direction, slice_mesh
from .reach import axes_within_limits, reachable_facets
from .scallop import CREASE, facet_curvature, turned_along
from .spacing import place_planes

__all__ = [
    "CREASE", "ContactPath", "arc_centre", "arc_curvature", "axes_within_limits", "direction", "facet_curvature",
    "pass_curvature", "place_planes", "reachable_facets", "slice_mesh", "turned_along",
]  # fmt: skip
