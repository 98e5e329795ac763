# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in which the controller itself guides the tip (RTCP): the model of this package, evenly moving axes,
is none for them.

The controller keeps the tip on the segment, as well as it can; that is its own affair, and neither measured
nor proven here. Such a block has no deviation of ours: its columns are zero, and whoever reports them says so
(``guided_blocks`` of the summary). It is the same with blocks whose way is not known.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats

from .measurement import Deviation


def without_guided(deviation: Deviation, on: Bools, tip: Floats) -> Deviation:
    """Return the same with zeros in the blocks ``on`` (m,); their place is the ``tip`` (m, 3) mm at their
    ends."""
    given = (
        deviation.line,
        deviation.u_line,
        deviation.segment,
        deviation.u_segment,
        deviation.bound,
        deviation.axis,
    )
    line, u_line, segment, u_segment, bound, axis = (np.where(on, 0.0, column) for column in given)
    place = np.where(on[:, None], tip, deviation.place)
    return Deviation(line, u_line, segment, u_segment, bound, axis, place, deviation.findings, deviation.lift)
