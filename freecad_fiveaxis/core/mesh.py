# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh and its co-edges.

facet     one triangle, counter-clockwise seen from outside.
co-edge   one edge of the mesh with the two facets that share it (Lin & Ye, Fig. 7); at a border it has one.
"""

from __future__ import annotations

from dataclasses import dataclass

from .findings import Finding
from .records import Floats, Ints, freeze


@dataclass(frozen=True, eq=False)
class Mesh:
    """A welded triangle mesh, mm.

    ``vertex`` (v, 3); ``face`` (f, 3) vertex rows; ``normal`` (f, 3) unit, by the right-hand rule from the vertices;
    ``coedge_vertex`` (e, 2) the ends of each co-edge; ``coedge_face`` (e, 2) the facets on its two sides, the second
    -1 at a border; ``face_coedge`` (f, 3) the co-edges of each facet: column k joins vertices k and k + 1.
    """

    vertex: Floats
    face: Ints
    normal: Floats
    coedge_vertex: Ints
    coedge_face: Ints
    face_coedge: Ints
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, vertex="f3")
        freeze(self, None, face="i3", normal="f3", face_coedge="i3")
        freeze(self, None, coedge_vertex="i2", coedge_face="i2")
