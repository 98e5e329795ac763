# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy of a part that turns under the tool about a fourth axis: rings around that axis, or lines
along it.

around    level planes across the axis: closed rings, the one beside the other, which become a helix where
          spirals are asked for.
along     half planes through the axis, the one after the other around it.
Either way the levels are as close as the widest place asks for (:mod:`.even_steps`). What lies across the
axis or faces it has no pass: a tool square to the axis does not reach it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import say

from .around_axis import facets_outward, report_across
from .even_steps import count_in_steps
from .field import PassField, PassOptions, Region
from .radial_passes import angle_about, centre_of, divide_at_seam, seam_normal, unit_axis
from .scallop_passes import OverSurface, copy_region, lay_passes, make_surface, measure_copy, survey_region
from .sources import BORDER
from .untouched import report_untouched

ALONG = "along"


class Rotary(OverSurface):
    """Level sets of the way along an axis, or of the angle about it."""

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for an axis and a scallop that cannot be used, for a region of which nothing
        faces away from the axis, and for more passes than any job can want."""
        survey_region(_outward(region, options), replace(options, source=BORDER))

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return steps along the axis; or about it, the two sides of a seam one after the other."""
        region.progress("placing passes", 0.0)
        faces = _outward(region, options)
        ground = survey_region(faces, replace(options, source=BORDER))
        about = unit_axis(options.axis)
        if options.by != ALONG:
            surface = make_surface(faces, ground)
            value = surface.copy.mesh.vertex @ about
        else:
            centre, across = centre_of(region, options.centre), seam_normal(about, options.direction)
            copy, side = divide_at_seam(copy_region(faces, ground), region.mesh, centre, across)
            surface = measure_copy(faces, ground, copy)
            value = angle_about(copy, side, centre, about, across)
        region.progress("placing passes", 0.7)
        return lay_passes(faces, surface, count_in_steps(surface, value))

    def report_untouched(
        self, region: Region, options: PassOptions, field: PassField, touched: Ints
    ) -> tuple[Finding, ...]:
        """Return what lies across the axis, and what no pass touches of the rest."""
        faces = _outward(region, options)
        across = report_across(region.mesh, region.keep & ~faces.keep)
        return field.findings + (() if across is None else (across,)) + report_untouched(faces, touched)


def _outward(region: Region, options: PassOptions) -> Region:
    """Return the region without what does not face away from the axis. Raises SettingsError where nothing
    does."""
    about, centre = unit_axis(options.axis), centre_of(region, options.centre)
    keep: Bools = region.keep & facets_outward(region.mesh, centre, about)[0]
    if not keep.any():
        text = say(
            "nothing that is to be cut faces away from the axis of the passes; give the axis about which the "
            "part is turned"
        )
        raise SettingsError(text, tuple(np.round(centre, 6).tolist()))
    return replace(region, keep=keep)
