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

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Length, Point, Template, say

from .half_edges import HalfEdges, partners, sort_half_edges
from .join import join_facets
from .weld import Reals, separate, weld
from .words import T, Words

S = TypeVar("S", np.float64, np.int64)

LARGEST = 1e6  # mm; no machine reaches a kilometre, so the units are wrong
# mm; a part that is smaller is a slip of the units too, and squares of its sides would be no numbers
LEAST = 1e-6
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
    coordinates that are not finite or beyond ``LARGEST``, all of them within ``LEAST``, and where no facet
    has an area.
    """
    array = _numbers(corners, say("triangle corners"), (3, 3))
    column = np.empty((3, 3, len(array)), dtype=np.float32 if array.dtype == np.float32 else np.float64)
    for part in cache_chunks(len(array)):
        column[:, :, part] = array[part].T
    return from_columns(column)


def from_columns(column: Reals) -> Mesh:
    """Return the same as :func:`from_triangles` for corners (3, 3, f) float32 or float64: x y z, corner,
    facet; -0 becomes 0 in them."""
    _numbers(column.T, say("triangle corners"), (3, 3))
    vertex, face, shape, halves = _weld_corners(column)
    del column  # nobody needs it any more, and the rest needs room
    return _build(vertex, face, shape, halves)


def from_faces(vertex: ArrayLike, face: ArrayLike) -> Mesh:
    """Mesh of an indexed triangle set: ``vertex`` (v, 3) mm, ``face`` (f, 3) rows of it.

    Nothing is welded; vertices that no facet uses are left out. Raises MeshError as :func:`from_triangles`
    does, and for a vertex row that does not exist.
    """
    point = np.array(_numbers(vertex, say("vertices"), (3,)), dtype=np.float64, order="F")
    row = _numbers(face, say("facets"), (3,))
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
    _range(point.T, len(point), say("vertex"))
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


# ------------------------------------------------------------------------------------------------ input


def _numbers(given: ArrayLike, what: str, row: tuple[int, ...]) -> NDArray[Any]:
    """``given`` as an array of numbers with at least one row of shape ``row``, or MeshError."""
    try:
        array = np.asarray(given)
    except ValueError as problem:
        raise MeshError(
            say("the {what} form no regular table: {problem}", what=what, problem=problem), None
        ) from problem
    if array.size == 0:
        raise MeshError(
            say("the mesh has no facets: export a solid or a surface with at least one triangle"), 0
        )
    if array.dtype.kind not in "iuf" or array.shape[1:] != row:
        form = f"{array.dtype} of shape {array.shape}"
        wanted = f"(n, {', '.join(map(str, row))})"
        raise MeshError(
            say("the {what} are {form}: give numbers of shape {wanted}", what=what, form=form, wanted=wanted),
            form,
        )
    return array


def _range(column: Reals, rows: int, what: str) -> tuple[Reals, Reals]:
    """Least and largest of each of the three columns, or MeshError where one holds a coordinate that no part
    can have, or all of them together a size that none has."""
    with np.errstate(invalid="ignore"):
        low, high = column.min(axis=1), column.max(axis=1)
        if np.maximum(-low, high).max() <= LARGEST:  # no NaN: it would come out of all three
            _check_size(float((high - low).max()))
            return low, high
        axis, entry = (int(i[0]) for i in np.nonzero(~(np.abs(column) <= LARGEST)))
    value = float(column[axis, entry])
    given = {"what": what, "number": entry % rows + 1, "rows": rows, "axis": "xyz"[axis]}
    if not np.isfinite(value):
        raise MeshError(
            say(
                "{what} {number} of {rows} has {axis} = {value}: coordinates must be finite numbers; export "
                "the mesh again",
                value=value,
                **given,
            ),
            value,
        )
    raise MeshError(
        say(
            "{what} {number} of {rows} has {axis} = {value}, and no part exceeds {most}: check the units of "
            "the export",
            value=Length(value),
            most=Length(LARGEST),
            **given,
        ),
        value,
    )


def _check_size(size: float) -> None:
    """Raise MeshError for a part that is ``size`` mm long, less than any; where it is but a point, no facet
    has an area."""
    if 0.0 < size < LEAST:
        raise MeshError(
            say(
                "the whole part is {size} long, and none is less than {least}: check the units of the export",
                size=Length(size, ".4g"),
                least=Length(LEAST),
            ),
            size,
        )


# ------------------------------------------------------------------------------------------------ facets


def _weld_corners(column: Reals) -> tuple[Floats, Ints, _Shape, HalfEdges]:
    """Vertices, facets, flat ones included, their shape, and the half-edges of those that stay, from corners
    (3, 3, f)."""
    facets = column.shape[2]
    # row k f + i is corner k of facet i, as in a Fortran-ordered ``face``
    corners = column.reshape(3, -1)
    low, high = _range(corners, facets, say("facet"))

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
    findings = [_flat_finding(vertex, face, shape.flat)] if len(shape.flat) else []
    face, normal, area = (
        _without(face, shape.flat),
        _without(shape.normal, shape.flat),
        _without(shape.area, shape.flat),
    )
    edges = _coedges(vertex, face, halves)
    mesh = Mesh(
        vertex, face, normal, area, edges.vertex, edges.face, edges.of_face, (*findings, *edges.findings)
    )
    return _flip_facets(mesh) if edges.closed and shape.inward else mesh


def join_loose(mesh: Mesh) -> Mesh:
    """Return the mesh with facets joined that ought to hang together; where there are none, the mesh
    itself."""
    edge = mesh.coedge_face[:, 1] < 0
    rim = np.zeros(len(mesh.vertex), dtype=np.bool_)
    rim[mesh.coedge_vertex[edge]] = True
    found = join_facets(mesh.vertex, mesh.face, rim) if edge.any() else None
    if found is None:
        return mesh
    joined = from_faces(mesh.vertex, found.face)
    kept = [one for one in mesh.findings if one.code == Code.DEGENERATE_FACETS]
    findings = [
        _join_finding(mesh.vertex, *one) for one in zip(_JOIN_FINDINGS, found[1:], strict=True) if len(one[1])
    ]
    return replace(joined, findings=(*kept, *findings, *joined.findings))


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


def _flat_finding(vertex: Floats, face: Ints, flat: Ints) -> Finding:
    place = _place(vertex, face[flat[0]])
    text = say(
        "{count} facets without area were left out, the first at {at}; passes end where that leaves a crack.",
        count=len(flat),
        at=_at(place),
    )
    return report_finding(Code.DEGENERATE_FACETS, text, float(len(flat)), 0.0, place=place)


def _flip_facets(mesh: Mesh) -> Mesh:
    """Return the same facets seen from the other side."""
    place = _place(mesh.vertex, mesh.face[0])
    text = say(
        "All {count} facets looked inward and were turned outward; check the export if only some of them "
        "should.",
        count=len(mesh.face),
    )
    finding = report_finding(Code.INWARD_FACETS, text, float(len(mesh.face)), 0.0, place=place)
    return Mesh(
        mesh.vertex,
        np.asfortranarray(mesh.face[:, ::-1]),
        -mesh.normal,
        mesh.area,
        np.asfortranarray(mesh.coedge_vertex[:, ::-1]),
        mesh.coedge_face,
        np.asfortranarray(mesh.face_coedge[:, [1, 0, 2]]),
        (*mesh.findings, finding),
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


# ------------------------------------------------------------------------------------------------ co-edges


@dataclass(frozen=True)
class _Coedges:
    """The co-edge columns of a Mesh (``vertex``, ``face``, ``of_face``), findings, and whether the mesh is
    closed."""

    vertex: Ints
    face: Ints
    of_face: Ints
    findings: list[Finding]
    closed: bool


def _coedges(vertex: Floats, face: Ints, halves: HalfEdges) -> _Coedges:
    findings: list[Finding] = []
    number, alone, closed = len(halves.word) // 2, np.empty(0, dtype=np.int64), True
    pairs: Iterator[tuple[slice | Ints, slice | Ints]]
    if halves.is_paired():
        pairs = (
            (slice(2 * at.start, 2 * at.stop, 2), slice(2 * at.start + 1, 2 * at.stop, 2))
            for at in chunks(number)
        )
    else:
        first, alone = partners(halves.keys(slice(None)))
        number = len(first)
        pairs = ((first[at], first[at] + 1) for at in chunks(number))
        findings, closed = _edge_findings(halves.keys(alone), halves.numbers(alone), halves.low, vertex, face)
    width, facet = int(len(vertex) - 1).bit_length(), (1 << halves.low) - 1
    ends, sides = np.empty((2, 2, number + len(alone)), dtype=np.int64)
    of_face = np.empty(
        3 << halves.low, dtype=np.int64
    )  # as wide as half-edge numbers are, so that they address it

    def fill(at: slice, there: slice | Ints, back: slice | Ints) -> None:
        _put_ends(halves.keys(there), width, ends[:, at])
        one, two = halves.numbers(there), halves.numbers(back)
        np.bitwise_and(one, facet, out=sides[0, at])
        np.bitwise_and(two, facet, out=sides[1, at])
        of_face[one] = of_face[two] = np.arange(at.start, at.stop)

    in_threads(
        lambda rows: fill(*rows), [(at, *pair) for at, pair in zip(chunks(number), pairs, strict=True)]
    )
    edge, one = halves.keys(alone), halves.numbers(alone)
    _put_ends(edge, width, ends[:, number:])
    against = number + np.flatnonzero(edge & np.uint64(1))
    ends[:, against] = ends[::-1, against]
    sides[0, number:], sides[1, number:] = one & facet, -1
    of_face[one] = np.arange(number, number + len(alone))
    return _Coedges(ends.T, sides.T, of_face.reshape(3, -1)[:, : len(face)].T, findings, closed)


def _put_ends(edge: Words, width: int, out: Ints) -> None:
    """Lower and upper vertex of edges with sense into the two rows of ``out``; ``width`` bits a vertex."""
    lower, upper = out.view(np.uint64)
    np.right_shift(edge, np.uint64(width + 1), out=lower)
    np.right_shift(edge, np.uint64(1), out=upper)
    upper &= np.uint64((1 << width) - 1)


# ------------------------------------------------------------------------------------------------ findings

_JOIN_FINDINGS = (
    (
        Code.DOUBLED_FACETS,
        Template("{count} facets were there twice, the first at {at}; one of each was kept."),
    ),
    (
        Code.CORNERS_JOINED,
        Template("{count} corners next to others, the first at {at}, were joined with them."),
    ),
    (
        Code.T_JUNCTIONS_JOINED,
        Template(
            "{count} corners lie on a side of another facet, the first at {at}; that facet was divided there."
        ),
    ),
)


def _join_finding(vertex: Floats, named: tuple[Code, Template], row: Ints) -> Finding:
    (code, template), place = named, _place(vertex, row[:1])
    text = template.say(count=len(row), at=_at(place))
    return report_finding(code, text, float(len(row)), 0.0, place=place)


_EDGE_FINDINGS = (
    (
        Code.OPEN_SHELL,
        Template(
            "{edges} edges leave the mesh open, the first at {at}; passes end there. Close the shell in CAD "
            "if it is meant to be solid."
        ),
    ),
    (
        Code.INCONSISTENT_WINDING,
        Template(
            "{edges} edges have two facets that run along them in the same sense, the first at {at}; passes "
            "end there. Unify the facet normals."
        ),
    ),
    (
        Code.NON_MANIFOLD_EDGES,
        Template(
            "{edges} edges have more than two facets, the first at {at}; passes end there. Separate or "
            "unite the bodies that meet there."
        ),
    ),
)


def _edge_findings(
    key: Words, half: Ints, low: int, vertex: Floats, face: Ints
) -> tuple[list[Finding], bool]:
    """Return findings on the half-edges without a partner, and whether the mesh is closed all the same.

    It is closed when every edge is run along as often in one sense as in the other.
    """
    _, group, count = np.unique(key >> np.uint64(1), return_inverse=True, return_counts=True)
    group = group.reshape(-1)
    forward = np.bincount(group, weights=(key & np.uint64(1)) == 0)
    kind = np.minimum(count, 3)[group]
    facet = half & ((1 << low) - 1)
    findings = []
    for number, (code, template) in enumerate(_EDGE_FINDINGS, start=1):
        at = np.flatnonzero(kind == number)
        if len(at):
            worst = at[np.argmin(facet[at])]
            corner = half[worst] >> low
            place = _place(vertex, face[facet[worst], [corner, (corner + 1) % 3]])
            edges = int(np.count_nonzero(np.minimum(count, 3) == number))
            text = template.say(edges=edges, at=_at(place))
            findings.append(report_finding(code, text, float(edges), 0.0, place=place))
    return findings, bool((2 * forward == count).all())


def _place(vertex: Floats, row: Ints) -> tuple[float, float, float]:
    x, y, z = vertex[row].mean(axis=0)
    return float(x), float(y), float(z)


def _at(place: tuple[float, float, float]) -> Point:
    return Point(place, "g")
