# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of one part that overlap: what of the one lies inside the other is no surface of the part.

Just over a facet of the part's skin there is no solid; over one that lies inside another solid there is that
one. The facets above a place, each counted with the sense in which it looks, tell in how many solids it lies.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Number, Point, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.mesh.lumps import find_boxes, number_lumps, pair_boxes
from freecad_fiveaxis.core.gouge import count_solids, is_closed
from freecad_fiveaxis.core.gouge.rest_material import surface_samples
from freecad_fiveaxis.core.passes.within_limits import measure_facets

OVER = 1e-5
"""Of the part's size: so far over a facet is looked."""

SPACING = 0.01
"""Of the part's size: so far apart facets are looked at that lie inside another solid in part."""

LEAST = 1e-4
"""Of the surface: that less of it lies inside another solid on facets that reach out of it is not told."""

NEAR_CORNERS = 0.9 * np.eye(3) + 0.1 / 3.0
"""Where on a facet is looked besides its middle, in shares of its corners."""


def find_buried_facets(mesh: Mesh) -> Bools:
    """Find the facets (f,) of a closed mesh that lie inside another of its solids, with their middle and near
    all of their corners; none where no two solids have room in common."""
    buried = np.zeros(len(mesh.face), np.bool_)
    if not is_closed(mesh):
        return buried
    rows = np.flatnonzero(_find_overlapping(mesh))
    for share in (np.full(3, 1.0 / 3.0), *NEAR_CORNERS):
        corner = mesh.vertex[mesh.face[rows]]
        over = np.einsum("c,fcx->fx", share, corner) + OVER * _size(mesh) * mesh.normal[rows]
        rows = rows[count_solids(facet_tree(mesh), over) > 0.5]
    buried[rows] = True
    return buried


def make_buried_test(mesh: Mesh) -> Callable[[Floats, Ints], Bools] | None:
    """Return what tells of places (k, 3) mm on facets (k,) of a closed mesh whether they lie inside
    another of its solids; None where no two solids have room in common."""
    overlapping = _find_overlapping(mesh) if is_closed(mesh) else np.zeros(len(mesh.face), np.bool_)
    if not overlapping.any():
        return None

    def is_buried(point: Floats, facet: Ints) -> Bools:
        found = overlapping[facet]
        over = point[found] + OVER * _size(mesh) * mesh.normal[facet[found]]
        found[found] = count_solids(facet_tree(mesh), over) > 0.5
        return found

    return is_buried


def measure_partly_buried(mesh: Mesh, facets: Bools) -> float:
    """Measure how much, mm2, of the ``facets`` (f,) lies inside another solid, by places on them."""
    is_buried = make_buried_test(mesh)
    if is_buried is None:
        return 0.0
    point, facet, area = surface_samples(mesh, SPACING * _size(mesh), facets & _find_overlapping(mesh))
    return float(area[is_buried(point, facet)].sum())


def report_buried(mesh: Mesh, buried: Bools, partly: float = 0.0) -> tuple[Finding, ...]:
    """Say how much of the part's surface lies inside another of its solids, ``partly`` mm2 of it on facets
    that reach out of it; nothing where none does."""
    if not buried.any() and partly < LEAST * float(mesh.area.sum()):
        return ()
    area, place = measure_facets(mesh, buried if buried.any() else _find_overlapping(mesh))
    area = partly + (area if buried.any() else 0.0)
    text = say(
        "{area} ({share} % of the mesh) at {place} lie inside another solid of the part and are not "
        "machined. Unite the solids in CAD, so that passes end at the seam.",
        area=Area(area, ".4g"),
        share=Number(100.0 * area / float(mesh.area.sum()), ".3g"),
        place=Point(place),
    )
    return (report_finding(Code.FACETS_INSIDE, text, area, 0.0, place=place, within=partly or None),)


def _find_overlapping(mesh: Mesh) -> Bools:
    """Find the facets (f,) of solids whose boxes overlap with that of another one."""
    solid = number_lumps(mesh.coedge_face, len(mesh.face))
    pairs = pair_boxes(*find_boxes(mesh.vertex, mesh.face, solid))
    return np.asarray(np.isin(solid, pairs))


def _size(mesh: Mesh) -> float:
    return float(np.ptp(mesh.vertex, axis=0).max())
