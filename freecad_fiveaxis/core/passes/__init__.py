# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes: the strategies that say where to cut, which facets may be cut, and what that cuts out of the
mesh."""

from .arc_curvature import arc_centre, arc_curvature, pass_curvature
from .around_axis import facets_around
from .contact_path import ContactPath, direction, slice_field, slice_mesh
from .field import PassField, PassOptions, PassStrategy, Region, cut
from .high_scallops import report_high_scallops
from .open_surface import report_far_side
from .scallop import CREASE, compute_turn, facet_curvature, flat_interval
from .sides import find_untouched_sides, side_findings
from .spacing import prepare_planes
from .standing import report_standing, standing_facets
from .steep_and_shallow import Division, lay_by_slope, lay_whole
from .strategies import PASS_STRATEGIES, find_pass_strategy
from .within_limits import (
    axes_within_limits,
    facets_under_axes,
    facets_within_limits,
    least_up,
    turns_within_limits,
    with_room,
)

__all__ = [
    "CREASE",
    "PASS_STRATEGIES",
    "ContactPath",
    "Division",
    "PassField",
    "PassOptions",
    "PassStrategy",
    "Region",
    "arc_centre",
    "arc_curvature",
    "axes_within_limits",
    "compute_turn",
    "cut",
    "direction",
    "facet_curvature",
    "facets_around",
    "facets_under_axes",
    "facets_within_limits",
    "find_pass_strategy",
    "find_untouched_sides",
    "flat_interval",
    "lay_by_slope",
    "lay_whole",
    "least_up",
    "pass_curvature",
    "prepare_planes",
    "report_far_side",
    "report_high_scallops",
    "report_standing",
    "side_findings",
    "slice_field",
    "slice_mesh",
    "standing_facets",
    "turns_within_limits",
    "with_room",
]  # fmt: skip
