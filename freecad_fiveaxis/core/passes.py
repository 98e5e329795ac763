# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel vertical planes through a mesh (Lin & Ye, II.B and D). Intersects, nothing else.

pass      all that one plane cuts out of the mesh: one or more polylines.
polyline  an ordered run of facet segments, each going on where the one before it ended; open or closed.
segment   the straight piece that one plane cuts out of one facet; two rows of the path: entry and exit.
"""

from __future__ import annotations

from dataclasses import dataclass

from .findings import Finding
from .records import Floats, Ints, freeze


@dataclass(frozen=True, eq=False)
class ContactPath:
    """Ordered contact (CC) points: rows 2i and 2i + 1 are entry and exit of facet segment i.

    ``point`` (n, 3) mm; ``normal`` (n, 3) unit normal of the facet; ``face`` (n,) that facet; ``coedge`` (n,) the
    co-edge on which the point lies, -1 if none; ``segment`` (n,) = i; ``polyline`` (n,) counts the polylines of the whole
    path; ``pass_`` (n,) counts the planes. Consecutive segments of one polyline share the co-edge where they meet. In a
    closed polyline the last exit is the first entry again (same point, same co-edge).
    """

    point: Floats
    normal: Floats
    face: Ints
    coedge: Ints
    segment: Ints
    polyline: Ints
    pass_: Ints
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, point="f3", normal="f3", face="i", coedge="i", segment="i", polyline="i", pass_="i")
