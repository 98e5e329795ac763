# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closes the gaps that offsetting leaves at co-edges (Lin & Ye, II.D and Fig. 6, 7)."""

from __future__ import annotations

from dataclasses import dataclass

from .findings import Finding
from .records import Bools, Floats, Ints, freeze


@dataclass(frozen=True, eq=False)
class OffsetPath:
    """Contact points with the ball centres that belong to them, gaps closed; one row a cutter location.

    ``point`` (n, 3) contact, mm; ``centre`` (n, 3) of the ball, mm; ``normal`` (n, 3) unit, of the offset at this row
    (facet normal or co-edge normal); ``before`` and ``after`` (n, 3) the facet normals on either side of the contact point
    (equal inside a facet); ``step_before`` and ``step_after`` (n,) lengths of the contact segments on either side, mm
    (S1 and S2 of eqs. 9 and 10; equal at the ends of an open polyline); ``face``, ``coedge``, ``segment``, ``polyline``,
    ``pass_`` (n,) as in ContactPath; ``fill`` (n,) True where the move that arrives here closes a gap and cuts no facet.
    """

    point: Floats
    centre: Floats
    normal: Floats
    before: Floats
    after: Floats
    step_before: Floats
    step_after: Floats
    face: Ints
    coedge: Ints
    segment: Ints
    polyline: Ints
    pass_: Ints
    fill: Bools
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(
            self, None, point="f3", centre="f3", normal="f3", before="f3", after="f3", step_before="f", step_after="f",
            face="i", coedge="i", segment="i", polyline="i", pass_="i", fill="b",
        )  # fmt: skip
