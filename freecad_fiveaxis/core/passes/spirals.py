# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed passes round one another become one long open pass: a spiral.

turn      once round. The first turn of a spiral is the first loop of its chain, the last one the last loop:
          borders are finished. Between them turn k leads from loop k to loop k + 1: on it, ``index - share =
          k``, with the index of the loops as a field (k on loop k) and the share of a turn. So at any place
          two turns are one index apart, as two loops are, and meet where the share begins anew, to the last
          bit.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .bands import FEWEST, find_chains
from .contact_path import ContactPath, slice_field
from .divide import assemble, divide
from .piece_order import Tour, tour_rows
from .refine import Copy, assemble_copy, take_facets
from .winding import find_turns

TOUCH = 1e-4
"""Of the way between two levels: no vertex lies nearer to a level than that."""

MOST = 0.5
"""Of the segments of a polyline that must be those of a loop in a spiral for the one to stand for the
other."""

COLUMNS = ("point", "normal", "face", "coedge", "polyline", "pass_")


class Rings(NamedTuple):
    """``copy`` of the facets between loops, cut open along seams; at its vertices (v,) the ``ring`` they
    belong to, the ``height`` in loops and the ``share`` of a turn; ``first`` and ``last`` (r,) loop of each
    ring."""

    copy: Copy
    ring: Ints
    height: Floats
    share: Floats
    first: Ints
    last: Ints


class Turns(NamedTuple):
    """``contact`` with a polyline (p,) for each turn; the ``ring`` of each, how many turns came before it,
    ``turn``, and whether it is to be taken ``back``wards."""

    contact: ContactPath
    ring: Ints
    turn: Ints
    back: Bools


def find_spirals(
    part: Mesh, copy: Copy, value: Floats, levels: Floats
) -> tuple[ContactPath, Ints, Ints] | None:
    """Find the spirals that lie in a copy of facets of the part whose passes have the ascending ``levels``
    (k,) of ``value`` (v,), each a polyline, its ``pass_`` that of its first loop; and of the loops for which
    they stand the facets (n,) of the copy and the passes (n,). None where there is none."""
    if len(levels) <= FEWEST or not (np.diff(levels) > 0.0).all():
        return None
    whole, index, slab, owner = _divide_at_loops(part, copy, value, levels)
    inside, beside = find_chains(whole.mesh, slab, levels)
    if not inside.any():
        return None
    rows = np.flatnonzero(inside)
    ring = take_facets(whole, part, rows)
    rings = _cut_open(part, ring, carry(ring.mesh, index[whole.mesh.face[rows]]))
    spirals, good = _one_after_the_other(rings, _all_turns(rings))
    belongs = np.full(len(inside), -1)
    belongs[rows] = ring.component[ring.mesh.face[:, 0]]
    beside = beside[good[belongs[beside].max(axis=1)]]
    if not len(beside):
        return None
    return rings.copy.on_part(spirals, part), owner[beside].reshape(-1), np.repeat(slab[beside[:, 0]], 2)


def has_loops(contact: ContactPath) -> bool:
    """Whether enough polylines end where they begin for a spiral."""
    first = _begins(contact)
    last = np.append(first[1:], len(contact.point)) - 1
    return bool((contact.point[first] == contact.point[last[: len(first)]]).all(axis=1).sum() > FEWEST)


def without_loops(contact: ContactPath, face: Ints, pass_: Ints) -> ContactPath:
    """Leave out the polylines of which most segments are cut out of these facets (n,) by these passes (n,); a
    pass has one segment in a facet."""
    count = int(contact.face.max(initial=0)) + 1
    gone = np.isin(contact.pass_ * count + contact.face, (pass_ * count + face)[face < count])
    rows = np.flatnonzero(
        (np.bincount(contact.polyline, gone) < MOST * np.bincount(contact.polyline))[contact.polyline]
    )
    return take_lines(contact, rows)


def merge_passes(contact: ContactPath, spirals: ContactPath) -> ContactPath:
    """Put spirals among other polylines, in the order of their passes."""
    both = put_beside([contact, spirals])
    rows = np.argsort(both.pass_, kind="stable")
    return replace(take_lines(both, rows), findings=contact.findings)


def take_lines(contact: ContactPath, rows: Ints) -> ContactPath:
    """Take some rows of whole polylines, polylines and segments counted anew."""
    columns = {name: getattr(contact, name)[rows] for name in COLUMNS}
    columns["polyline"] = (np.cumsum(np.diff(columns["polyline"], prepend=-1) != 0) - 1).astype(np.int64)
    return replace(contact, **columns, segment=np.arange(len(rows)) >> 1)


def _divide_at_loops(
    part: Mesh, copy: Copy, value: Floats, levels: Floats
) -> tuple[Copy, Floats, Ints, Ints]:
    """Return the copy divided at all levels, the index of the loops at its vertices, the slab of its facets,
    and the facets of the copy given in which they lie."""
    knots, number = _knots(levels)
    value = off_levels(value, levels)
    cuts = divide(copy, value[copy.mesh.face], levels)
    whole = replace(assemble(copy, part, cuts), bend=copy.bend)
    return whole, carry(whole.mesh, np.interp(cuts.value, knots, number)), cuts.slab, cuts.owner


def _knots(levels: Floats) -> tuple[Floats, Floats]:
    """Return the levels with one more at either end, and their numbers from -1 on."""
    knots = np.concatenate([[2.0 * levels[0] - levels[1]], levels, [2.0 * levels[-1] - levels[-2]]])
    return knots, np.arange(-1.0, len(levels) + 1.0)


def off_levels(value: Floats, levels: Floats) -> Floats:
    """Move values (v,) that are next to one of the ascending ``levels`` (k,), at least two, just above it:
    passes that run along sides of facets would else be told to lie in those on the other side."""
    knots, number = _knots(levels)
    index = np.interp(value, knots, number)
    near = (np.abs(index - np.round(index)) < TOUCH) & (index > -0.5) & (index < len(levels) - 0.5)
    return np.asarray(np.where(near, np.interp(np.round(index) + 1.001 * TOUCH, number, knots), value))


def carry(mesh: Mesh, corner: Any) -> Any:
    """Give what is known of corners (f, 3), alike wherever they meet, at the vertices (v,)."""
    value = np.empty(len(mesh.vertex), corner.dtype)
    value[mesh.face] = corner
    return value


def _cut_open(part: Mesh, ring: Copy, index: Floats) -> Rings:
    """Return the rings, a component each, divided where turns begin and cut open there."""
    turns = find_turns(ring.mesh, ring.component, index)
    planes = np.arange(np.floor(turns.min()), np.ceil(turns.max()) + 1.0)
    cuts = divide(ring, turns, planes, index[:, None])
    share = cuts.value - planes[cuts.slab - 1][:, None]
    face = cuts.face + len(cuts.vertex) * (
        share == 1.0
    )  # vertices at which a turn ends are others than those where one begins
    copy = assemble_copy(part, np.tile(cuts.vertex[:, :3], (2, 1)), face, cuts.label, ring.parent[cuts.owner])
    pieces = int(ring.component.max(initial=-1)) + 1
    first, last = np.full(pieces, np.inf), np.full(pieces, -np.inf)
    np.minimum.at(first, ring.component, index)
    np.maximum.at(last, ring.component, index)
    belongs = np.repeat(ring.component[ring.mesh.face[cuts.owner, 0]][:, None], 3, axis=1)
    belongs, height, share = (
        carry(copy.mesh, corner) for corner in (belongs, cuts.vertex[cuts.face, 3], share)
    )
    return Rings(
        replace(copy, bend=ring.bend), belongs, height, share, first.astype(np.int64), last.astype(np.int64)
    )


def _all_turns(rings: Rings) -> Turns:
    """Return the first loop of every ring, the turns from loop to loop, and the last loop: level lines of
    three fields in which rings have a range of their own each."""
    mesh, loops = rings.copy.mesh, rings.last - rings.first
    begin = np.arange(len(loops)) * (int(loops.max()) + 3.0)
    own, over = begin[rings.ring], rings.height - rings.first[rings.ring]
    between, turn = number_runs(loops)
    every, none = np.arange(len(loops)), np.zeros(len(loops), np.int64)
    fields = [
        (
            own - over,
            begin,
            every,
            none,
            True,
        ),  # the facets above the first loop are below it here, and it runs back
        (own + over - rings.share, begin[between] + turn, between, turn + 1, False),
        (own + over, begin + loops, every, loops + 1, False),
    ]
    cuts = [
        (slice_field(mesh, value, levels), ring, turn, back) for value, levels, ring, turn, back in fields
    ]
    number = [contact.pass_[_begins(contact)] for contact, *_ in cuts]
    return Turns(
        put_beside(contact for contact, *_ in cuts),
        np.concatenate([ring[at] for at, (_, ring, _, _) in zip(number, cuts, strict=True)]),
        np.concatenate([turn[at] for at, (_, _, turn, _) in zip(number, cuts, strict=True)]),
        np.concatenate([np.full(len(at), back) for at, (*_, back) in zip(number, cuts, strict=True)]),
    )


def _one_after_the_other(rings: Rings, turns: Turns) -> tuple[ContactPath, Bools]:
    """Return the turns of each ring as one polyline, and which rings (r,) came out whole: one turn of each
    number, each beginning where the one before it ends. Of the others there is none."""
    contact, order = turns.contact, np.lexsort((turns.turn, turns.ring))
    first = _begins(contact)
    last = np.append(first[1:], len(contact.point)) - 1
    ring, turn, back = turns.ring[order], turns.turn[order], turns.back[order]
    goes_on = ring[1:] == ring[:-1]
    leaves = contact.point[np.where(back, first[order], last[order])]
    enters = contact.point[np.where(back, last[order], first[order])]
    meets = np.linalg.norm(enters[1:] - leaves[:-1], axis=1) < COINCIDENT_MM
    wrong = np.append(turn[:1] != 0, np.where(goes_on, ~meets | (np.diff(turn) != 1), turn[1:] != 0))
    count = len(rings.first)
    good = (np.bincount(ring, wrong, count) == 0) & (
        np.bincount(ring, minlength=count) == rings.last - rings.first + 2
    )
    keep = good[ring]
    row, piece, _ = tour_rows(first, last, Tour(order[keep], back[keep]))
    ring = ring[keep][piece]
    line = np.unique(ring, return_inverse=True)[1].astype(np.int64)
    point, normal, face, coedge = (getattr(contact, name)[row] for name in COLUMNS[:4])
    return ContactPath(point, normal, face, coedge, np.arange(len(row)) >> 1, line, rings.first[ring]), good


def _begins(contact: ContactPath) -> Ints:
    """Return the rows (p,) at which polylines begin."""
    return np.flatnonzero(np.diff(contact.polyline, prepend=-1))


def put_beside(contacts: Iterable[ContactPath]) -> ContactPath:
    """Put the polylines of all one after the other."""
    parts = list(contacts)
    columns: dict[str, Any] = {
        name: np.concatenate([getattr(part, name) for part in parts]) for name in COLUMNS
    }
    line = np.cumsum(np.concatenate([np.diff(part.polyline, prepend=-1) != 0 for part in parts])) - 1
    columns["polyline"] = line.astype(np.int64)
    return ContactPath(**columns, segment=np.arange(len(line)) >> 1)
