# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter-location (CL) path: order, links, retracts.

motion    what the move that arrives at a row does: CUT cuts a facet, FILL closes a gap at a co-edge, LINK goes at feed
          away from or to the part along the tool axis, RAPID goes above the part.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from .findings import Finding
from .records import Bytes, Floats, Ints, freeze


class Motion(IntEnum):
    """What the move that arrives at a row does."""

    CUT = 0
    FILL = 1
    LINK = 2
    RAPID = 3


@dataclass(frozen=True, eq=False)
class CLPath:
    """The whole path of the tool in the work frame; row i is the end of move i, row 0 the first position.

    ``tip`` (n, 3) the point that the words drive, mm: the cutter's tip, or its centre where the control point is the
    centre; ``axis`` (n, 3) unit, tip to holder; ``motion`` (n,) of :class:`Motion`; ``feed`` (n,) mm/min of the tip over
    the part (0 for RAPID); ``contact`` (n, 3) mm (the tip itself in LINK and RAPID rows); ``normal`` (n, 3) unit, the
    offset's (the axis in LINK and RAPID rows); ``face``, ``coedge``, ``pass_`` (n,), -1 where there is none.
    """

    tip: Floats
    axis: Floats
    motion: Bytes
    feed: Floats
    contact: Floats
    normal: Floats
    face: Ints
    coedge: Ints
    pass_: Ints
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(
            self, None, tip="f3", axis="f3", motion="m", feed="f", contact="f3", normal="f3", face="i", coedge="i", pass_="i"
        )
