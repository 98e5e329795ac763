# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel vertical planes through a mesh (Lin & Ye, II.B and D), and level sets of any field on it.
Intersects, nothing else.

pass      all that one plane, or one level of a field, cuts out of the mesh: one or more polylines.
polyline  an ordered run of facet segments, each going on where the one before it ended; open or closed.
segment   the straight piece that one plane cuts out of one facet; two rows of the path: entry and exit.
plain     facets that are passed over and not cut: their co-edges say nothing where both sides lie in one
          plane.
zigzag    every other pass is cut backwards, so that it begins near the end of the one before.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze, run_ids
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .slicing import Crossings, chain, find_crossings

QUARTER = 1e-15  # a cosine or sine below it comes from rounding a multiple of pi / 2, and means 0
ORDERS = ("zigzag", "one_way")
LEVEL = 1e-12  # two unit normals that differ by no more are one: over ten thousand facets that makes 1e-8 rad


@dataclass(frozen=True, eq=False)
class ContactPath:
    """Ordered contact (CC) points: rows 2i and 2i + 1 are entry and exit of facet segment i.

    ``point`` (n, 3) mm; ``normal`` (n, 3) unit normal of the facet; ``face`` (n,) that facet, of several
    plain ones one; ``coedge`` (n,) the co-edge on which the point lies, -1 if none; ``segment`` (n,) = i;
    ``polyline`` (n,) counts the polylines of the whole path; ``pass_`` (n,) counts the planes. Consecutive
    segments of one polyline share the co-edge where they meet; where a plane passes through a vertex, facets
    cut at that one point are left out, and the exit and the next entry lie on two co-edges of that vertex.
    The points are the same bits in any case. In a closed polyline the last exit is the first entry again
    (same point, and the same co-edge but at a vertex).
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
        freeze(
            self, None, point="f3", normal="f3", face="i", coedge="i", segment="i", polyline="i", pass_="i"
        )


def slice_mesh(
    mesh: Mesh, offsets: ArrayLike, angle: float, keep: ArrayLike | None = None, progress: Progress = silent,
    plain: Bools | None = None, order: str = "one_way",
) -> ContactPath:  # fmt: skip
    """Cut the mesh by vertical planes.

    Plane k holds the points with ``across . p = offsets[k]`` mm (ascending), ``across = (-sin angle, cos
    angle, 0)``; the travel is ``(cos angle, sin angle, 0)``, angle in rad. A segment runs along ``across x
    normal``, so an upward facet is cut in the sense of the travel. ``keep`` (f,) leaves out the facets where
    it is False; polylines end there. Of ``plain`` (f,) facets those that follow one another in one plane make
    one segment, as on the underside of a part. Passes go by plane; the polylines of a pass by where they
    start along the travel. In the ``order`` zigzag the polylines of every other pass that cuts more than
    plain facets, and their segments, come the other way round.

    A vertex on a plane counts as above it, so a facet that only touches the plane from above is not cut, and
    an edge on the plane is cut out of the facet below it. Segments of zero length are left out.
    Raises SettingsError for offsets that are not finite or not ascending, a ``keep`` of the wrong length, or
    an unknown order.
    """
    planes = _planes(offsets)
    cosine, sine = direction(angle)
    x, y, z = mesh.vertex.T
    columns = (cosine * x + sine * y, z)
    upright = partial(_upright, planes, (cosine, sine))
    return _slice_mesh(mesh, planes, columns, cosine * y - sine * x, upright, keep, progress, plain, order)


def slice_field(
    mesh: Mesh, value: Floats, levels: ArrayLike, keep: ArrayLike | None = None, progress: Progress = silent,
    plain: Bools | None = None, order: str = "one_way",
) -> ContactPath:  # fmt: skip
    """Cut the mesh where a field has the ascending ``levels`` (k,): ``value`` (v,) at its vertices, linear
    over each facet.

    All else as for :func:`slice_mesh`, whose planes are the levels of ``across . p``: a segment runs along
    ``grad x normal``, so that the field rises to its left; the polylines of a pass go by where they start
    along X. Raises SettingsError as :func:`slice_mesh` does, and for a field of the wrong length or one that
    is not finite.
    """
    value = np.asarray(value, dtype=np.float64)
    if value.shape != (len(mesh.vertex),) or not np.isfinite(value).all():
        raise SettingsError(
            say(
                "the field of the passes is not one finite number for each of the {count} vertices",
                count=len(mesh.vertex),
            ),
            value.shape,
        )
    x, y, z = mesh.vertex.T
    return _slice_mesh(mesh, _planes(levels), (x, y, z), value, _as_it_is, keep, progress, plain, order)


Placing = Callable[[Sequence[Floats], Ints, Floats], None]
"""From the columns (c, n) of crossings and their planes (n,) to their points: x, y, z into the rows of (3,
n)."""


def _slice_mesh(
    mesh: Mesh, planes: Floats, columns: tuple[Floats, ...], value: Floats, placing: Placing,
    keep: ArrayLike | None,
    progress: Progress, plain: Bools | None, order: str,
) -> ContactPath:  # fmt: skip
    if order not in ORDERS:
        raise SettingsError(
            say("order is {order}; choose one of {orders}", order=repr(order), orders=", ".join(ORDERS)),
            order,
        )
    kept = None if keep is None else np.asarray(keep, dtype=np.bool_)
    if kept is not None and kept.shape != (len(mesh.face),):
        raise SettingsError(
            say(
                "keep has shape {shape}: give one value for each of the {count} facets",
                shape=kept.shape,
                count=len(mesh.face),
            ),
            kept.shape,
        )
    progress("slice", 0.0)
    cross = find_crossings(mesh, planes, columns, value, kept)
    progress("slice", 0.5)
    crossing, first, plane = chain(cross)
    if plain is not None and plain.any():
        crossing, first = _join_coplanar(mesh, cross, crossing, first, plain)
    progress("slice", 0.8)
    chains = _Chains(crossing, first, plane, np.zeros(len(crossing), np.bool_))
    if order == "zigzag":
        chains = _zigzag(chains, cross, plain)
    path = _contact_path(mesh, cross, chains, placing)
    progress("slice", 1.0)
    return path


def direction(angle: float) -> tuple[float, float]:
    """Cosine and sine of ``angle`` rad, exact at multiples of a quarter turn, so that planes along x or y
    keep their vertices."""
    if not math.isfinite(angle):
        raise SettingsError(
            say("the direction of the planes is {angle}: give a finite angle", angle=angle), angle
        )
    cosine, sine = math.cos(angle), math.sin(angle)
    return (0.0 if abs(cosine) < QUARTER else cosine, 0.0 if abs(sine) < QUARTER else sine)


def _planes(offsets: ArrayLike) -> Floats:
    planes = np.asarray(offsets, dtype=np.float64)
    if planes.ndim != 1:
        raise SettingsError(
            say("plane offsets have shape {shape}: give one ascending row of numbers", shape=planes.shape),
            planes.shape,
        )
    if not np.isfinite(planes).all():
        wrong = float(planes[~np.isfinite(planes)][0])
        raise SettingsError(say("a plane offset is {wrong}: give finite numbers", wrong=wrong), wrong)
    if (np.diff(planes) < 0.0).any():
        at = int(np.argmax(np.diff(planes) < 0.0))
        raise SettingsError(
            say(
                "plane offset {offset} follows {before}: give them ascending",
                offset=Length(planes[at + 1], bare=True),
                before=Length(planes[at], bare=True),
            ),
            float(planes[at + 1]),
        )
    return planes


def _join_coplanar(
    mesh: Mesh, cross: Crossings, crossing: Ints, first: Ints, plain: Bools
) -> tuple[Ints, Ints]:
    """Return the chains without the crossings between two plain facets of one plane."""
    stays = np.ones(len(crossing), dtype=np.bool_)

    def look(part: slice) -> None:
        facet = cross.left.take(crossing[part.start : part.stop + 1])  # the last crossing of all ends a chain
        between = np.flatnonzero(plain.take(facet))
        between = between[np.flatnonzero(np.diff(between) == 1)]
        one, two = (mesh.normal.T.take(facet.take(between + side), axis=1) for side in (0, 1))
        stays[part.start + between[np.abs(one - two).max(axis=0, initial=0.0) <= LEVEL]] = False

    in_threads(look, chunks(len(crossing)))
    stays[first] = stays[first[1:] - 1] = True
    before = np.cumsum(stays)
    return crossing[stays], before[first] - 1


class _Chains(NamedTuple):
    """Chains of crossings as :func:`~.slicing.chain` gives them; ``back`` (x,) where they go the other way
    round."""

    crossing: Ints
    first: Ints
    plane: Ints
    back: Bools


def _zigzag(chains: _Chains, cross: Crossings, plain: Bools | None) -> _Chains:
    """Return the chains with every other plane's the other way round, of the planes that cut facets which are
    not plain."""
    crossing, first, plane, back = chains
    begin = np.flatnonzero(np.diff(plane, prepend=-1))
    bounds = np.append(first[begin], len(crossing))
    cuts = np.ones(len(begin), np.bool_)
    if plain is not None and len(begin):
        cuts = np.logical_or.reduceat(~np.append(plain, True).take(cross.left.take(crossing)), bounds[:-1])
    turned = np.flatnonzero(cuts)[1::2]
    ordered, back = crossing.copy(), back.copy()
    for low, high in zip(bounds[turned].tolist(), bounds[turned + 1].tolist(), strict=True):
        ordered[low:high], back[low:high] = crossing[low:high][::-1], True
    size = np.diff(np.append(begin, len(plane)))
    mirror = np.repeat(bounds[:-1] + bounds[1:], size) - np.append(first[1:], len(crossing))
    return _Chains(ordered, np.sort(np.where(back[first], mirror, first)), plane, back)


def _contact_path(mesh: Mesh, cross: Crossings, chains: _Chains, placing: Placing) -> ContactPath:
    """Entry and exit of each segment from the chains of crossings."""
    crossing, first, plane, back = chains
    columns = in_threads(lambda column: column.take(crossing), list(cross.place))
    end, number = _segment_ends(columns, first)
    used = np.flatnonzero(number)
    number, plane = 2 * number.take(used), plane.take(used)
    # one block for the labels and one for the rest: numpy asks for large memory pages where an array is large
    face, coedge, segment, polyline, pass_ = label = np.empty((5, 2 * len(end)), dtype=np.int64)
    point, normal = np.empty((2, 3, 2 * len(end)))
    polyline[:] = run_ids(number)

    def fill(part: slice) -> None:
        rows = slice(2 * part.start, 2 * part.stop)
        exits = end[part]
        at = np.empty(2 * len(exits), dtype=np.int64)
        at[0::2], at[1::2] = exits - 1, exits
        plane.take(polyline[rows], out=pass_[rows], mode="clip")
        placing([column.take(at) for column in columns], pass_[rows], point[:, rows])
        cross.coedge.take(crossing.take(at), out=coedge[rows], mode="clip")
        cut = cross.left.take(
            crossing.take(exits - back.take(exits))
        )  # the facet is left where the chain itself leaves it
        for values, both in (
            (cut, face[rows]),
            *zip((n.take(cut) for n in mesh.normal.T), normal[:, rows], strict=True),
        ):
            both[0::2] = both[1::2] = values
        segment[rows] = np.arange(rows.start, rows.stop) >> 1

    in_threads(fill, chunks(len(end)))
    return ContactPath(point.T, normal.T, *label)


def _upright(
    planes: Floats, heading: tuple[float, float], columns: Sequence[Floats], plane: Ints, out: Floats
) -> None:
    """Points of upright planes from ``along`` and the height; the rest is the plane's own offset, to the last
    bit."""
    (along, out[2]), offset, (cosine, sine) = columns, planes.take(plane), heading
    np.subtract(cosine * along, sine * offset, out=out[0])
    np.add(sine * along, cosine * offset, out=out[1])


def _as_it_is(columns: Sequence[Floats], plane: Ints, out: Floats) -> None:
    """Points whose columns are x, y and z."""
    for row, column in zip(out, columns, strict=True):
        row[:] = column


def _segment_ends(columns: Sequence[Floats], first: Ints) -> tuple[Ints, Ints]:
    """Rows of the chains' crossings where a segment ends that began in the row before and has a length;
    number in each chain."""
    cuts = np.zeros(len(columns[0]), dtype=np.bool_)
    for column in columns:
        cuts[1:] |= column[1:] != column[:-1]
    cuts[first] = False
    return np.flatnonzero(cuts), np.add.reduceat(cuts, first, dtype=np.int64) if len(first) else first
