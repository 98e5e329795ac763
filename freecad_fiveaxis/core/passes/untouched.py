# SPDX-License-Identifier: LGPL-2.1-or-later
"""The area that no pass touches, of passes of any kind but upright planes (:mod:`.sides` has those).

rim     where facets that passes touch end: a ball that touches there stands as near to what lies beyond as
        any that the passes lead.
swept   an untouched place of which a ball at the rim leaves no more than passes two steps apart would: it
        lies between two passes. Places are asked, not facets, for a large face may consist of slivers, each
        of them narrow and with a corner at the rim.
"""

from __future__ import annotations

import math

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import chunks
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Area, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .field import Region
from .sides import number_connected

BESIDE = 3.0
"""Intervals of a flat: small facets so near to a pass may lie between two."""

SHARE = 0.002
"""Of the area to be cut: what no pass touches is told where it is more."""

NEAREST = 4
"""Places of the rim that are asked for each place: where facets meet in a corner each has a normal of its
own."""

MOSTLY = 0.5
"""Of an area that hangs together: where more of it is left, its rim is left as well, for it is one side."""

FINE = 0.5
"""Intervals between the places that are asked."""


def report_untouched(region: Region, touched: Ints) -> tuple[Finding, ...]:
    """Return a warning where facets to be cut that no pass touches or sweeps are more than a little;
    ``touched`` (n,) by one."""
    rows = find_untouched(region, touched)
    lost, whole = float(region.mesh.area[rows].sum()), float(region.mesh.area[region.keep].sum())
    if lost <= SHARE * whole:
        return ()
    largest = rows[region.mesh.area[rows].argmax()]
    x, y, z = region.mesh.vertex[region.mesh.face[largest]].mean(axis=0).tolist()
    text = say(
        "Passes touch none of {count} facets of {area} that are to be cut: they lie along the passes or "
        "between two of them. Choose other passes, or a smaller stepover or scallop, for those.",
        count=len(rows),
        area=Area(lost, ".4g"),
    )
    return (report_finding(Code.SIDE_NOT_MACHINED, text, lost, 0.0, place=(x, y, z)),)


def find_untouched(region: Region, touched: Ints) -> Ints:
    """Find the facets (k,) to be cut that passes touching ``touched`` (n,) leave: large ones, small ones far
    from them, and those of which the cutter sweeps not all."""
    mesh, out = region.mesh, region.keep.copy()
    out[touched] = False
    rows, there = np.flatnonzero(out), np.unique(touched)
    if not len(rows) or not len(there):
        return rows
    apart = max(region.interval, 2.0 * (region.covered or 0.0))
    narrow = rows[_are_narrow(mesh, rows, apart) & _are_beside(mesh, rows, there, apart)]
    if mesh.area[rows].sum() <= SHARE * mesh.area[region.keep].sum():  # too little to be told
        return np.setdiff1d(rows, narrow)
    left = _with_rim(mesh, narrow, ~_are_swept(mesh, narrow, there, region.radius, apart))
    return np.setdiff1d(rows, narrow[~left])


def _with_rim(mesh: Mesh, rows: Ints, left: Bools) -> Bools:
    """Tell of narrow facets ``rows`` (k,) which are left, where it is known which ``left`` (k,) are by
    themselves: of those that hang together all, where most of the area is."""
    if not left.any():
        return left
    out = np.zeros(len(mesh.face), np.bool_)
    out[rows] = True
    number, area = number_connected(mesh, out, rows), mesh.area[rows]
    mostly = np.bincount(number, area * left) > MOSTLY * np.bincount(number, area)
    return np.asarray(left | mostly[number])


def _are_narrow(mesh: Mesh, rows: Ints, apart: float) -> Bools:
    """Tell which facets ``rows`` (k,) are narrower than passes are ``apart``, mm."""
    corner = mesh.vertex[mesh.face[rows]]
    longest = np.linalg.norm(corner - corner[:, [1, 2, 0]], axis=2).max(axis=1)
    return np.asarray(2.0 * mesh.area[rows] < apart * longest)


def _are_beside(mesh: Mesh, rows: Ints, there: Ints, apart: float) -> Bools:
    """Tell which facets ``rows`` (k,) have a corner of the touched ones ``there`` (n,) or a middle near
    theirs."""
    beside = np.zeros(len(mesh.vertex), np.bool_)
    beside[mesh.face[there]] = True
    tree = scipy.spatial.cKDTree(mesh.vertex[mesh.face[there]].mean(axis=1))
    off = tree.query(mesh.vertex[mesh.face[rows]].mean(axis=1))[0]
    return np.asarray(beside[mesh.face[rows]].any(axis=1) | (off < BESIDE * apart))


def _are_swept(mesh: Mesh, rows: Ints, there: Ints, radius: float, apart: float) -> Bools:
    """Tell of which narrow facets ``rows`` (k,) a ball of ``radius`` mm leaves hardly anything where it
    touches the rim of the facets ``there`` (n,)."""
    if not len(rows):
        return np.zeros(0, np.bool_)
    rim, normal = _sample_rim(mesh, there, FINE * apart)
    if not len(rim):
        return np.zeros(len(rows), np.bool_)
    place, of = _sample_inside(mesh, rows, FINE * apart)
    radius = max(radius, apart)
    centre, tree = rim + radius * normal, scipy.spatial.cKDTree(rim)
    allowed = radius - math.sqrt(radius**2 - apart**2)
    parts = [_stands_over(place[part], tree, centre, radius, allowed) for part in chunks(len(place))]
    return np.asarray(np.bincount(of, np.concatenate(parts), len(rows)) == 0)


def _stands_over(
    place: Floats, tree: scipy.spatial.cKDTree, centre: Floats, radius: float, allowed: float
) -> Bools:
    """Tell which places (m, 3) stand more than ``allowed`` mm over the balls of ``radius`` mm with these
    centres (n, 3) that touch the nearest points of the rim, which the ``tree`` holds. No ball of a point
    farther off reaches a place, and to compare all of them would take longest in the middle of a disc."""
    reach, count = (2.0 * radius + allowed) * (1.0 + 1e-9), min(NEAREST, len(centre))
    near = tree.query(place, k=count, distance_upper_bound=reach)[1].reshape(len(place), -1)
    balls = np.append(centre, [[np.inf] * 3], axis=0)[near]  # what is not found has the number after the last
    return np.asarray(np.linalg.norm(place[:, None] - balls, axis=2).min(axis=1) - radius > allowed)


def _sample_rim(mesh: Mesh, there: Ints, step: float) -> tuple[Floats, Floats]:
    """Return points (m, 3) along the edges where the facets ``there`` (n,) end, and the normals (m, 3) of the
    facets."""
    inside = np.zeros(len(mesh.face), np.bool_)
    inside[there] = True
    sides = mesh.coedge_face
    has = inside[sides] & (sides >= 0)
    edge = np.flatnonzero(has.any(axis=1) & ~has.all(axis=1))
    facet = np.where(has[edge, 0], sides[edge, 0], sides[edge, 1])
    ends = mesh.vertex[mesh.coedge_vertex[edge]]
    point, of = sample_lines(ends[:, 0], ends[:, 1], step)
    return point, mesh.normal[facet[of]]


def _sample_inside(mesh: Mesh, rows: Ints, step: float) -> tuple[Floats, Ints]:
    """Return points (m, 3) along the median of the shortest side of each of the facets ``rows`` (k,), and
    whose they are, by the number of its row (m,)."""
    corner = mesh.vertex[mesh.face[rows]]
    length = np.linalg.norm(corner - corner[:, [1, 2, 0]], axis=2)
    first, each = length.argmin(axis=1), np.arange(len(rows))
    middle = 0.5 * (corner[each, first] + corner[each, (first + 1) % 3])
    return sample_lines(middle, corner[each, (first + 2) % 3], step)


def sample_lines(start: Floats, end: Floats, step: float) -> tuple[Floats, Ints]:
    """Return points (m, 3) at most ``step`` mm apart along lines from ``start`` to ``end`` (n, 3), one at
    least on each, and their lines (m,)."""
    count = np.maximum(np.ceil(np.linalg.norm(end - start, axis=1) / step), 1.0).astype(np.int64)
    of, part = number_runs(count)
    share = ((part + 0.5) / count[of])[:, None]
    return start[of] + share * (end - start)[of], of
