# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the part's size speaks for another unit than the mm in which its file is read: an STL does not say
its unit."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool import Cutter

INCH, METRE = 25.4, 1000.0
"""mm."""


def unit_suspected(mesh: Mesh, cutter: Cutter) -> tuple[Finding, ...]:
    """Return a warning where the whole part is smaller than the cutter's diameter: its longest side in mm,
    and in other units."""
    size = float(np.ptp(mesh.vertex, axis=0).max())
    if size >= cutter.diameter:
        return ()
    text = say(
        "The whole part is {size} long, less than the cutter's diameter of {diameter}: its file may be in "
        "metres ({metres}) or inches ({inches}). Export the part in mm, scale it, or name the units of STL "
        "files on the command line: {option}.",
        size=Length(size, ".4g"),
        diameter=Length(cutter.diameter, ".4g"),
        metres=Length(METRE * size, ".4g"),
        inches=Length(INCH * size, ".4g"),
        option=Option("stl_units"),
    )
    return (report_finding(Code.UNIT_SUSPECTED, text, size, cutter.diameter, unit="mm"),)
