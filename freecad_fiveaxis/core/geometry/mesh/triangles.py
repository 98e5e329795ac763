# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh and its co-edges.

facet      one triangle, counter-clockwise seen from outside.
half-edge  one side of a facet, in the facet's own sense.
co-edge    one edge of the mesh with the two facets that share it (Lin & Ye, Fig. 7); at a border it has one.

A facet without area is left out. Where more than two facets meet in an edge, or two facets run along it in
the same sense, nothing tells which of them belong together: each gets a border co-edge of its own. A closed
mesh whose volume is negative is turned outward. Each of these is a finding with its place.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import say

from .faults import CHANGES, FLAT_FACETS, INWARD_FACETS, INWARD_LUMPS, JOIN_FINDINGS, TURNED_FACETS, report_at
from .given_numbers import find_range, read_numbers
from .half_edges import HalfEdges, find_coedges, sort_half_edges
from .join import join_facets
from .lumps import find_inward, number_lumps
from .weld import Reals, separate, weld
from .winding import find_turned
from .words import T

S = TypeVar("S", np.float64, np.int64)

FLAT = (
    2.0**-50
    # height of a facet over the part's largest coordinate where the coordinates' own rounding (2**-53) makes
    # it up
)
HOLLOW = 1e-12  # volume over that of the box around the part where its sign is rounding


@dataclass(frozen=True, eq=False)
class Mesh:
    """A welded triangle mesh, mm.

    ``vertex`` (v, 3); ``face`` (f, 3) vertex rows; ``normal`` (f, 3) unit, by the right-hand rule from the
    vertices; ``area`` (f,) mm2; ``coedge_vertex`` (e, 2) the ends of each co-edge; ``coedge_face`` (e, 2) the
    facets on its two sides, the second -1 at a border; ``face_coedge`` (f, 3) the co-edges of each facet:
    column k joins vertices k and k + 1.

    The first facet of a co-edge runs along it from ``coedge_vertex[:, 0]`` to ``[:, 1]``, the second one
    back. ``allowance`` (f,) mm: so far a tool keeps off each facet; None: it may touch all of them.
    """

    vertex: Floats
    face: Ints
    normal: Floats
    area: Floats
    coedge_vertex: Ints
    coedge_face: Ints
    face_coedge: Ints
    findings: tuple[Finding, ...] = ()
    allowance: Floats | None = None

    def __post_init__(self) -> None:
        freeze(self, None, vertex="f3")
        freeze(self, None, face="i3", normal="f3", area="f", face_coedge="i3")
        freeze(self, None, coedge_vertex="i2", coedge_face="i2")
        if self.allowance is not None:
            freeze(self, len(self.face), allowance="f")

    @property
    def box(self) -> tuple[Floats, Floats]:
        """Low and high corner (3,) mm."""
        return self.vertex.min(axis=0), self.vertex.max(axis=0)


def from_triangles(corners: ArrayLike) -> Mesh:
    """Weld loose triangles into a mesh.

    ``corners`` (f, 3, 3) mm: facet, corner, x y z; float32 or float64. Raises MeshError for zero facets,
    coordinates that are not finite or beyond ``LARGEST``, all of them within ``LEAST``
    (:mod:`.given_numbers`), and where no facet has an area.
    """
    array = read_numbers(corners, say("triangle corners"), (3, 3))
    column = np.empty((3, 3, len(array)), dtype=np.float32 if array.dtype == np.float32 else np.float64)
    for part in cache_chunks(len(array)):
        column[:, :, part] = array[part].T
    return from_columns(column)


def from_columns(column: Reals) -> Mesh:
    """Return the same as :func:`from_triangles` for corners (3, 3, f) float32 or float64: x y z, corner,
    facet; -0 becomes 0 in them."""
    read_numbers(column.T, say("triangle corners"), (3, 3))
    vertex, face, shape, halves = _weld_corners(column)
    del column  # nobody needs it any more, and the rest needs room
    return _build(vertex, face, shape, halves)


def from_faces(vertex: ArrayLike, face: ArrayLike) -> Mesh:
    """Mesh of an indexed triangle set: ``vertex`` (v, 3) mm, ``face`` (f, 3) rows of it.

    Nothing is welded; vertices that no facet uses are left out. Raises MeshError as :func:`from_triangles`
    does, and for a vertex row that does not exist.
    """
    point = np.array(read_numbers(vertex, say("vertices"), (3,)), dtype=np.float64, order="F")
    row = read_numbers(face, say("facets"), (3,))
    if row.dtype.kind not in "iu":
        raise MeshError(
            say(
                "facets are given as {dtype} numbers: give integer rows of the vertex table", dtype=row.dtype
            ),
            str(row.dtype),
        )
    row = np.array(row, dtype=np.int64, order="F")
    low, high = int(row.min()), int(row.max())
    if low < 0 or high >= len(point):
        wrong = low if low < 0 else high
        raise MeshError(
            say(
                "a facet names vertex {wrong}, but the rows run from 0 to {count}: correct the facets",
                wrong=wrong,
                count=len(point) - 1,
            ),
            wrong,
        )
    find_range(point.T, len(point), say("vertex"))
    used = np.zeros(len(point), dtype=np.bool_)
    used[row] = True
    if not used.all():
        row = np.asfortranarray((np.cumsum(used, dtype=np.int64) - 1)[row])
        point = np.asfortranarray(point[used])

    def corner(k: int, part: slice) -> Floats:
        return point.T.take(row[part, k], axis=1)

    shape = _shape(corner, len(row), point.min(axis=0), point.max(axis=0))
    halves, _ = _half_edges(row, shape, len(point), lambda: None)
    return _build(point, row, shape, halves)


def _weld_corners(column: Reals) -> tuple[Floats, Ints, _Shape, HalfEdges]:
    """Vertices, facets, flat ones included, their shape, and the half-edges of those that stay, from corners
    (3, 3, f)."""
    facets = column.shape[2]
    # row k f + i is corner k of facet i, as in a Fortran-ordered ``face``
    corners = column.reshape(3, -1)
    low, high = find_range(corners, facets, say("facet"))

    def corner(k: int, part: slice) -> Floats:
        return column[:, k, part].astype(np.float64)

    vertex, row, shape = weld(corners, low, high, lambda: _shape(corner, facets, low, high))
    face = row.reshape(3, -1).T
    halves, separated = _half_edges(face, shape, vertex.shape[1], lambda: separate(corners, vertex, row))
    if separated is not vertex:  # the half-edges were those of strays on other vertices
        halves, _ = _half_edges(face, shape, separated.shape[1], lambda: None)
    return separated.astype(np.float64).T, face, shape, halves


def _build(vertex: Floats, face: Ints, shape: _Shape, halves: HalfEdges) -> Mesh:
    """Mesh of Fortran-ordered vertices and facets, flat ones included, their shape, and the half-edges of
    those that stay."""
    flat, findings = shape.flat, list[Finding]()
    if len(flat):
        first = face[flat[0]]
        findings = [report_at(Code.DEGENERATE_FACETS, FLAT_FACETS, vertex, first, count=len(flat))]
    face, normal, area = _without(face, flat), _without(shape.normal, flat), _without(shape.area, flat)
    edges = find_coedges(vertex, face, halves)
    mesh = Mesh(
        vertex, face, normal, area, edges.vertex, edges.face, edges.of_face, (*findings, *edges.findings)
    )
    return _flip_facets(mesh) if edges.closed and shape.inward else mesh


def join_loose(mesh: Mesh) -> Mesh:
    """Return the mesh with facets joined that ought to hang together, and those turned round that face the
    other way than their neighbours, or inward as a whole lump beside others; where there are none, the mesh
    itself."""
    return _turn_lumps(_turn_facets(_join_facets(mesh)))


def _join_facets(mesh: Mesh) -> Mesh:
    edge = mesh.coedge_face[:, 1] < 0
    rim = np.zeros(len(mesh.vertex), dtype=np.bool_)
    rim[mesh.coedge_vertex[edge]] = True
    found = join_facets(mesh.vertex, mesh.face, rim) if edge.any() else None
    if found is None:
        return mesh
    joined = from_faces(mesh.vertex, found.face)
    kept = [one for one in mesh.findings if one.code == Code.DEGENERATE_FACETS]
    findings = [
        report_at(*named, mesh.vertex, row[:1], count=len(row))
        for named, row in zip(JOIN_FINDINGS, found[1:], strict=True)
        if len(row)
    ]
    return replace(joined, findings=(*kept, *findings, *joined.findings))


def _turn_facets(mesh: Mesh) -> Mesh:
    """Return the mesh without facets that face the other way than their neighbours."""
    if not any(one.code == Code.INCONSISTENT_WINDING for one in mesh.findings):
        return mesh
    rows = np.flatnonzero(find_turned(mesh.face, mesh.area))
    if not len(rows):
        return mesh
    face = mesh.face.copy()
    face[rows] = face[rows, ::-1]
    found = report_at(Code.FACETS_TURNED, TURNED_FACETS, mesh.vertex, mesh.face[rows[0]], count=len(rows))
    kept = [one for one in mesh.findings if one.code in CHANGES]
    one_way = from_faces(mesh.vertex, face)
    return replace(one_way, findings=(*kept, found, *one_way.findings))


def _turn_lumps(mesh: Mesh) -> Mesh:
    """Return the mesh without lumps that are solids written inside out beside others."""
    lump = number_lumps(mesh.coedge_face, len(mesh.face))
    closed = np.ones(int(lump.max()) + 1, np.bool_)
    closed[lump[mesh.coedge_face[mesh.coedge_face[:, 1] < 0, 0]]] = False
    inward = find_inward(mesh.vertex, mesh.face, lump, closed & (len(closed) > 1))
    if not inward.any():
        return mesh
    face = mesh.face.copy()
    face[inward] = face[inward, ::-1]
    all_turned = any(one.code == Code.INWARD_FACETS for one in mesh.findings)
    turned = ~inward if all_turned else inward  # what was turned twice is as it was
    first = mesh.face[np.flatnonzero(turned)[0]]
    found = report_at(
        Code.INWARD_FACETS, INWARD_LUMPS, mesh.vertex, first, count=int(np.count_nonzero(turned))
    )
    kept = [one for one in mesh.findings if one.code != Code.INWARD_FACETS]
    right = from_faces(mesh.vertex, face)
    return replace(right, findings=(*kept, found))


def _half_edges(face: Ints, shape: _Shape, vertices: int, work: Callable[[], T]) -> tuple[HalfEdges, T]:
    """Return the half-edges of the facets that stay, and what ``work`` gives, done in the meantime."""
    if len(shape.flat) == len(face):
        raise MeshError(
            say("none of the {count} facets has an area: check the units and the export", count=len(face)),
            len(face),
        )
    return sort_half_edges(_without(face, shape.flat), vertices, work)


def _without(table: NDArray[S], rows: Ints) -> NDArray[S]:
    return np.asfortranarray(np.delete(table, rows, axis=0)) if len(rows) else table


def _flip_facets(mesh: Mesh) -> Mesh:
    """Return the same facets seen from the other side."""
    count = len(mesh.face)
    inward = report_at(Code.INWARD_FACETS, INWARD_FACETS, mesh.vertex, mesh.face[0], count=count)
    return replace(
        mesh,
        face=np.asfortranarray(mesh.face[:, ::-1]),
        normal=-mesh.normal,
        coedge_vertex=np.asfortranarray(mesh.coedge_vertex[:, ::-1]),
        face_coedge=np.asfortranarray(mesh.face_coedge[:, [1, 0, 2]]),
        findings=(*mesh.findings, inward),
    )


@dataclass(frozen=True)
class _Shape:
    """What the corners alone tell.

    ``normal`` (f, 3) unit; ``area`` (f,) mm2; ``flat`` rows of facets without area; ``inward`` True where the
    volume of a closed mesh is negative.
    """

    normal: Floats
    area: Floats
    flat: Ints
    inward: bool


def _shape(corner: Callable[[int, slice], Floats], facets: int, low: Reals, high: Reals) -> _Shape:
    """Shape of so many ``facets``: ``corner`` gives x y z of corner k of some of them, ``low`` and ``high``
    bound them all."""
    low, high = low.astype(np.float64), high.astype(np.float64)
    side, least = float((high - low).max()), FLAT * float(np.maximum(-low, high).max())
    normal, area = np.empty((3, facets)), np.empty(facets)
    flat = [np.empty(0, dtype=np.int64)]
    volume = 0.0
    for part in cache_chunks(facets):
        a = corner(0, part)
        bx, by, bz = corner(1, part) - a
        cx, cy, cz = corner(2, part) - a
        nx, ny, nz = normal[:, part]
        np.subtract(by * cz, bz * cy, out=nx)
        np.subtract(bz * cx, bx * cz, out=ny)
        np.subtract(bx * cy, by * cx, out=nz)
        length = np.sqrt(nx * nx + ny * ny + nz * nz)
        np.multiply(0.5, length, out=area[part])
        height = a[2] + ((bz + cz) / 3.0 - low[2])
        volume += float((height * nz).sum()) / 2.0  # the prism between the facet and the lowest point
        if length.min() <= 3.0 * least * side:  # no edge is longer than sqrt(3) sides
            edge = np.sqrt(np.maximum(bx * bx + by * by + bz * bz, cx * cx + cy * cy + cz * cz))
            thin = np.flatnonzero(length <= least * edge)
            flat.append(thin + part.start)
            length[thin] = 1.0
        normal[:, part] /= length
    return _Shape(normal.T, area, np.concatenate(flat), volume < -HOLLOW * side**3)
