# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangle mesh and its co-edges.

facet      one triangle, counter-clockwise seen from outside.
half-edge  one side of a facet, in the facet's own sense.
co-edge    one edge of the mesh with the two facets that share it (Lin & Ye, Fig. 7); at a border it has one.
weld       corners with equal coordinates (-0.0 equals 0.0) become one vertex; corners that merely lie close do not.

A facet without area is left out. Where more than two facets meet in an edge, or two facets run along it in the same
sense, nothing tells which of them belong together: each gets a border co-edge of its own. A closed mesh whose volume
is negative is turned outward. Each of these is a finding with its place.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import MeshError
from .findings import Finding, Severity
from .records import Floats, Ints, freeze

LARGEST = 1e6  # mm; no machine reaches a kilometre, so the units are wrong
FLAT = 2.0**-46  # area over squared edge length where rounding of the coordinates' products (2**-53) drowns the normal
CHUNK = 16384  # rows; a few columns of it stay in the second-level cache

Words = NDArray[np.uint64]
Reals = NDArray[np.floating]

_CELLS = 255.0  # cells of the bounding box along x and y that number the vertices
_FACTORS = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0xD6E8FEB86659FD93)  # odd, with well mixed bits


@dataclass(frozen=True, eq=False)
class Mesh:
    """A welded triangle mesh, mm.

    ``vertex`` (v, 3); ``face`` (f, 3) vertex rows; ``normal`` (f, 3) unit, by the right-hand rule from the vertices;
    ``coedge_vertex`` (e, 2) the ends of each co-edge; ``coedge_face`` (e, 2) the facets on its two sides, the second
    -1 at a border; ``face_coedge`` (f, 3) the co-edges of each facet: column k joins vertices k and k + 1.

    The first facet of a co-edge runs along it from ``coedge_vertex[:, 0]`` to ``[:, 1]``, the second one back.
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


def from_triangles(corners: ArrayLike) -> Mesh:
    """Weld loose triangles into a mesh.

    ``corners`` (f, 3, 3) mm: facet, corner, x y z; float32 or float64. Raises MeshError for zero facets, coordinates
    that are not finite or beyond ``LARGEST``, and where no facet has an area.
    """
    array = _numbers(corners, "triangle corners", (3, 3))
    # one contiguous column each for x, y, z; row k f + i is corner k of facet i, as in a Fortran-ordered ``face``
    column = np.empty((3, 3 * len(array)), dtype=np.float32 if array.dtype == np.float32 else np.float64)
    for part in _chunks(len(array)):
        for axis, k in np.ndindex(3, 3):
            first = k * len(array) + part.start
            # adding zero turns -0.0 into 0.0, so that equal coordinates have equal bits
            np.add(array[part, k, axis], 0.0, out=column[axis, first : first + part.stop - part.start])
    _check_range(column, len(array), "facet")
    vertex, corner = _weld(column)
    return _build(vertex, corner.reshape(3, -1).T)


def from_faces(vertex: ArrayLike, face: ArrayLike) -> Mesh:
    """Mesh of an indexed triangle set: ``vertex`` (v, 3) mm, ``face`` (f, 3) rows of it.

    Nothing is welded; vertices that no facet uses are left out. Raises MeshError as :func:`from_triangles` does, and
    for a vertex row that does not exist.
    """
    point = _numbers(vertex, "vertices", (3,)).astype(np.float64, order="F")
    row = _numbers(face, "facets", (3,))
    if row.dtype.kind not in "iu":
        raise MeshError(f"facets are given as {row.dtype} numbers: give integer rows of the vertex table", str(row.dtype))
    row = row.astype(np.int64, order="F")
    low, high = int(row.min()), int(row.max())
    if low < 0 or high >= len(point):
        wrong = low if low < 0 else high
        raise MeshError(f"a facet names vertex {wrong}, but the rows run from 0 to {len(point) - 1}: correct the facets", wrong)
    _check_range(point.T, len(point), "vertex")
    used = np.zeros(len(point), dtype=np.bool_)
    used[row] = True
    if not used.all():
        row = np.asfortranarray((np.cumsum(used) - 1)[row])
        point = np.asfortranarray(point[used])
    return _build(point, row)


# ------------------------------------------------------------------------------------------------ input


def _numbers(given: ArrayLike, what: str, row: tuple[int, ...]) -> NDArray[np.generic]:
    """``given`` as an array of numbers with at least one row of shape ``row``, or MeshError."""
    try:
        array = np.asarray(given)
    except ValueError as problem:
        raise MeshError(f"the {what} form no regular table: {problem}", None) from problem
    if array.size == 0:
        raise MeshError("the mesh has no facets: export a solid or a surface with at least one triangle", 0)
    if array.dtype.kind not in "iuf" or array.shape[1:] != row:
        form = f"{array.dtype} of shape {array.shape}"
        raise MeshError(f"the {what} are {form}: give numbers of shape {('n', *row)}".replace("'", ""), form)
    return array


def _check_range(column: Reals, rows: int, what: str) -> None:
    """Raise MeshError where one of the three columns holds a coordinate that no part can have."""
    with np.errstate(invalid="ignore"):
        worst = max(float(np.maximum(-c.min(), c.max())) for c in column)
        if worst <= LARGEST and not np.isnan(column.min(axis=1)).any():
            return
        axis, entry = (int(i[0]) for i in np.nonzero(~(np.abs(column) <= LARGEST)))
    value = float(column[axis, entry])
    where = f"{what} {entry % rows + 1} of {rows} has {'xyz'[axis]} = {value:g}"
    if np.isfinite(value):
        raise MeshError(f"{where} mm, and no part exceeds {LARGEST:g} mm: check the units of the export", value)
    raise MeshError(f"{where}: coordinates must be finite numbers; export the mesh again", value)


def _chunks(rows: int) -> Iterator[slice]:
    return (slice(i, min(i + CHUNK, rows)) for i in range(0, rows, CHUNK))


# ------------------------------------------------------------------------------------------------ weld


def _weld(column: Reals) -> tuple[Floats, Ints]:
    """Vertices (v, 3) and the vertex row (n,) of each of the n corners whose x, y, z are the rows of ``column``.

    Sorts words of cell, hash and corner number. The cell (of the bounding box, along y then x) goes first so that
    vertices that lie close get close numbers: everything that follows then runs in the cache.
    """
    n = column.shape[1]
    bits = int(n - 1).bit_length()
    key = _corner_keys(column, bits)
    key.sort()
    corner = (key & np.uint64((1 << bits) - 1)).view(np.int64)
    key >>= np.uint64(bits)
    new = np.empty(n, dtype=np.bool_)
    new[0] = True
    np.not_equal(key[1:], key[:-1], out=new[1:])
    row = np.empty(n, dtype=np.int64)
    row[corner] = np.cumsum(new) - 1
    vertex = column.take(corner.take(np.flatnonzero(new)), axis=1)
    return _part_collisions(column, vertex, row)


def _corner_keys(column: Reals, bits: int) -> Words:
    """Words (n,) of 16 bits cell, 48 - ``bits`` bits hash, ``bits`` bits corner number."""
    n = column.shape[1]
    low = column.min(axis=1)
    size = np.maximum(column.max(axis=1) - low, np.finfo(column.dtype).tiny)
    raw = column.view(np.uint32 if column.dtype == np.float32 else np.uint64)
    number = np.arange(CHUNK, dtype=np.uint64)
    keep = np.uint64((1 << 48) - (1 << bits))
    key = np.empty(n, dtype=np.uint64)
    for part in _chunks(n):
        mixed = raw[0, part].astype(np.uint64) * np.uint64(_FACTORS[0])
        for axis in (1, 2):
            mixed += raw[axis, part].astype(np.uint64) * np.uint64(_FACTORS[axis])
        mixed >>= np.uint64(16)  # the upper bits of a product are the well mixed ones
        mixed &= keep
        cell = ((column[1, part] - low[1]) * (_CELLS / size[1])).astype(np.uint32) << np.uint32(8)
        cell |= ((column[0, part] - low[0]) * (_CELLS / size[0])).astype(np.uint32)
        mixed |= cell.astype(np.uint64) << np.uint64(48)
        mixed |= number[: part.stop - part.start]
        np.add(mixed, np.uint64(part.start), out=key[part])
    return key


def _part_collisions(column: Reals, vertex: Reals, row: Ints) -> tuple[Floats, Ints]:
    """Give corners that share a key but not the coordinates vertices of their own; there are hardly ever any."""
    strayed = []
    for part in _chunks(len(row)):
        at = row[part]
        wrong = vertex[0].take(at) != column[0, part]
        wrong |= vertex[1].take(at) != column[1, part]
        wrong |= vertex[2].take(at) != column[2, part]
        if wrong.any():
            strayed.append(np.flatnonzero(wrong) + part.start)
    if strayed:
        corner = np.concatenate(strayed)
        more, which = np.unique(column[:, corner], axis=1, return_inverse=True)
        row[corner] = vertex.shape[1] + which.reshape(-1)
        vertex = np.concatenate([vertex, more], axis=1)
    return vertex.astype(np.float64).T, row


# ------------------------------------------------------------------------------------------------ facets


def _build(vertex: Floats, face: Ints) -> Mesh:
    """Mesh of Fortran-ordered vertices and facets: normals, co-edges, orientation, findings."""
    normal, flat, volume = _normals(vertex, face)
    findings: list[Finding] = []
    if len(flat):
        if len(flat) == len(face):
            raise MeshError(f"none of the {len(face)} facets has an area: check the units and the export", len(face))
        place = _place(vertex, face[flat[0]])
        text = f"{len(flat)} facets without area were left out, the first at {_at(place)}; passes end where that leaves a crack."
        findings.append(Finding(Severity.NOTE, "degenerate-facets", text, value=float(len(flat)), unit="1", place=place))
        face, normal = (np.asfortranarray(np.delete(a, flat, axis=0)) for a in (face, normal))
    key, half = _sorted_half_edges(face, len(vertex))
    coedge_vertex, coedge_face, face_coedge, alone = _pair(key, half, len(face), len(vertex))
    closed = True
    if len(alone):
        more, closed = _edge_findings(key, half, alone, vertex, face)
        findings += more
    if closed and volume < 0.0:
        text = f"The facets looked inward (volume {volume:g} mm3) and were turned outward."
        findings.append(Finding(Severity.NOTE, "inward-facets", text, value=volume, limit=0.0, unit="mm3"))
        face, face_coedge = np.asfortranarray(face[:, ::-1]), np.asfortranarray(face_coedge[:, [1, 0, 2]])
        normal, coedge_vertex = -normal, np.asfortranarray(coedge_vertex[:, ::-1])
    return Mesh(vertex, face, normal, coedge_vertex, coedge_face, face_coedge, tuple(findings))


def _normals(vertex: Floats, face: Ints) -> tuple[Floats, Ints, float]:
    """Unit normals (f, 3), the rows of facets without area, and the volume, mm3 (of a closed mesh)."""
    x, y, z = vertex.T
    normal = np.empty((3, len(face)))
    flat = []
    volume = 0.0
    for part in _chunks(len(face)):
        a, b, c = face[part].T
        ax, ay, az = x.take(a), y.take(a), z.take(a)
        bx, by, bz = x.take(b) - ax, y.take(b) - ay, z.take(b) - az
        cx, cy, cz = x.take(c) - ax, y.take(c) - ay, z.take(c) - az
        nx, ny, nz = by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx
        length = np.sqrt(nx * nx + ny * ny + nz * nz)
        size = bx * bx + by * by + bz * bz + cx * cx + cy * cy + cz * cz
        volume += float(((az + (bz + cz) / 3.0) * nz).sum()) / 2.0  # the prism between the facet and z = 0
        none = np.flatnonzero(length <= FLAT * size)
        if len(none):
            flat.append(none + part.start)
            length[none] = 1.0
        np.divide(nx, length, out=normal[0, part])
        np.divide(ny, length, out=normal[1, part])
        np.divide(nz, length, out=normal[2, part])
    return normal.T, np.concatenate(flat) if flat else np.empty(0, dtype=np.int64), volume


# ------------------------------------------------------------------------------------------------ co-edges


def _sorted_half_edges(face: Ints, vertices: int) -> tuple[Words, Ints]:
    """Keys (3 f,) of lower vertex, upper vertex, sense (0 from lower to upper), ascending, and the half-edge of each.

    Half-edge k f + i leaves vertex k of facet i.
    """
    f = len(face)
    width = np.uint64(int(vertices - 1).bit_length())
    column = face.T.view(np.uint64)
    key = np.empty((3, f), dtype=np.uint64)
    for part in _chunks(f):
        for k in range(3):
            start, end = column[k, part], column[(k + 1) % 3, part]
            word = np.minimum(start, end) << width
            word |= np.maximum(start, end)
            word <<= np.uint64(1)
            np.bitwise_or(word, start > end, out=key[k, part])
    return sort_with_rows(key.reshape(-1), 2 * int(width) + 1)


def sort_with_rows(key: Words, bits: int) -> tuple[Words, Ints]:
    """``key`` (n,) ascending, and the row that each came from; every key is below ``2 ** bits``.

    Where key and row fit into one word, sorting those words is several times faster than argsort.
    """
    row_bits = int(max(len(key) - 1, 1)).bit_length()
    if bits + row_bits > 64:
        order = np.argsort(key, kind="stable")
        return key[order], order.astype(np.int64)
    word = key << np.uint64(row_bits)
    word |= np.arange(len(key), dtype=np.uint64)
    word.sort()
    row = (word & np.uint64((1 << row_bits) - 1)).view(np.int64)
    word >>= np.uint64(row_bits)
    return word, row


def _pair(key: Words, half: Ints, f: int, vertices: int) -> tuple[Ints, Ints, Ints, Ints]:
    """``coedge_vertex``, ``coedge_face``, ``face_coedge`` of a Mesh, and the rows of ``key`` without a partner.

    Partners are the only two half-edges of their edge and run in opposite senses.
    """
    edge = key >> np.uint64(1)
    same = np.equal(edge[1:], edge[:-1])
    partner = same & (key[1:] != key[:-1])
    partner[1:] &= ~same[:-1]
    partner[:-1] &= ~same[1:]
    first = np.flatnonzero(partner)
    alone = np.empty(0, dtype=np.int64)
    if 2 * len(first) < len(key):
        rest = np.ones(len(key), dtype=np.bool_)
        rest[first] = rest[first + 1] = False
        alone = np.flatnonzero(rest)

    row = np.concatenate([first, alone])
    width = np.uint64(int(vertices - 1).bit_length())
    coedge_vertex = np.empty((2, len(row)), dtype=np.int64)
    ends = edge.take(row)
    np.right_shift(ends, width, out=coedge_vertex[0].view(np.uint64))
    np.bitwise_and(ends, (np.uint64(1) << width) - np.uint64(1), out=coedge_vertex[1].view(np.uint64))
    back = len(first) + np.flatnonzero(key.take(alone) & np.uint64(1))
    coedge_vertex[:, back] = coedge_vertex[::-1, back]

    one, two = half.take(row), half.take(first + 1)
    coedge_face = np.full((2, len(row)), -1, dtype=np.int64)
    coedge_face[0] = one - one // f * f
    coedge_face[1, : len(first)] = two - two // f * f
    face_coedge = np.empty(3 * f, dtype=np.int64)
    number = np.arange(len(row))
    face_coedge[one] = number
    face_coedge[two] = number[: len(first)]
    return coedge_vertex.T, coedge_face.T, face_coedge.reshape(3, f).T, alone


# ------------------------------------------------------------------------------------------------ findings

_EDGE_FINDINGS = (
    ("open-shell", "{n} border edges leave the mesh open, the first at {at}; passes end there. Close the shell in CAD if it is meant to be solid."),
    ("inconsistent-winding", "{n} edges have both facets running along them in the same sense, the first at {at}; passes end there. Unify the facet normals."),
    ("non-manifold-edges", "{n} edges have more than two facets, the first at {at}; passes end there. Separate or unite the bodies that meet there."),
)  # fmt: skip


def _edge_findings(key: Words, half: Ints, alone: Ints, vertex: Floats, face: Ints) -> tuple[list[Finding], bool]:
    """Findings on the half-edges without a partner, and whether the mesh is closed all the same.

    It is closed when every edge is run along as often in one sense as in the other.
    """
    _, group, count = np.unique(key[alone] >> np.uint64(1), return_inverse=True, return_counts=True)
    group = group.reshape(-1)
    forward = np.bincount(group, weights=(key[alone] & np.uint64(1)) == 0)
    kind = np.minimum(count, 3)[group]
    facet = half[alone] % len(face)
    findings = []
    for number, (code, text) in enumerate(_EDGE_FINDINGS, start=1):
        at = np.flatnonzero(kind == number)
        if len(at):
            worst = at[np.argmin(facet[at])]
            corner = half[alone[worst]] // len(face)
            place = _place(vertex, face[facet[worst], [corner, (corner + 1) % 3]])
            edges = int(np.count_nonzero(np.minimum(count, 3) == number))
            said = text.format(n=edges, at=_at(place))
            findings.append(Finding(Severity.WARNING, code, said, value=float(edges), limit=0.0, unit="1", place=place))
    return findings, bool((2 * forward == count).all())


def _place(vertex: Floats, row: Ints) -> tuple[float, float, float]:
    x, y, z = vertex[row].mean(axis=0)
    return float(x), float(y), float(z)


def _at(place: tuple[float, float, float]) -> str:
    return "(" + ", ".join(f"{p:g}" for p in place) + ") mm"
