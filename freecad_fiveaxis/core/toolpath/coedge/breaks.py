# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a plane asks for more than the facet in it: a facet ends, its plane goes on.

claim      what the plane of a neighbour takes off a chord: the stretch on which the ball would reach below
           that plane. The facet may end before, and then the ball is free there.
free       a place at which the ball touches the part, as it does wherever a path leads, and does not enter
           it: there a claim is none.
break      where a chord is claimed on which the ball is free: the two chords do not meet, and the path ends
           at the one and begins anew at the other. Each is then cut back to where the ball is free.

Only chords that a trim would use up, or that are trimmed against one that was no neighbour before, are looked
at; elsewhere two facets share a co-edge, which bounds them both.
"""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM, dot
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.nearest import Facets, Pieces, nearest, search

from .chord import Chords, drop_chords, height_above, place_on

CLAIM = 0.05
"""mm by which a place is below a plane before the part decides: where less is claimed, the chords meet near
by, and no break is worth it."""
WORTH = 0.25
"""Radii that a free stretch is long at least, before a path is broken for it: a break costs a way out
and in. In a coarse bowl, whose chords are short, none is worth it."""
FREE, ENDS_FREE = 1e-4, 1e-3
"""mm that the ball may enter the part where it counts as free; and where a path is cut back to."""
STEP, MOST = 0.125, 512
"""Places looked at on a chord: one to so many radii, and at most so many."""
HALVINGS = 24
"""Of a step, in which the ball ceases to be free."""


class Part:
    """The facets that keep the ball of ``radius`` mm off; what finds them is made when it is first asked
    for."""

    def __init__(self, mesh: Mesh, radius: float) -> None:
        self.mesh, self.radius = mesh, radius

    @cached_property
    def _facets(self) -> tuple[Facets, Pieces]:
        corner = np.ascontiguousarray(self.mesh.vertex[self.mesh.face].transpose(1, 0, 2))
        facets = Facets(corner, self.mesh.normal)
        return facets, facets.pieces()

    def leaves_free(self, place: Floats, tolerance: float) -> Bools:
        """Whether a ball at ``place`` (3, n) mm touches the part within ``tolerance`` mm, (n,)."""
        if not len(self.mesh.face) or not place.shape[1]:
            return np.zeros(place.shape[1], bool)
        facets, pieces = self._facets
        distance = search(np.ascontiguousarray(place.T), pieces, facets.square_distances, nearest, 2)[:, 0]
        return np.asarray(np.abs(distance - self.radius) <= tolerance)


class _Stretches(NamedTuple):
    """On chords (k,): ``low`` to ``high`` mm a stretch on which the ball is free; ``any`` whether there is
    one."""

    low: Floats
    high: Floats
    any: Bools


def spare_free(chords: Chords, part: Part, gone: Ints) -> Ints:
    """Break the path at those chords of ``gone`` on which the ball is free though planes claim all of them;
    return the others, which may be dropped."""
    ask = gone[chords.real[gone]]
    before = np.where(chords.crosses[chords.before[ask]], chords.before[ask], -1)
    after = np.where(chords.crosses[ask], chords.after[ask], -1)
    found = _free_where_claimed(chords, part, ask, chords.low[ask], chords.high[ask], (before, after))
    worth = found.any & (found.high - found.low > WORTH * chords.radius)
    spared = ask[worth]
    if not len(spared):
        return gone
    low, high = found.low[worth], found.high[worth]
    head, tail = chords.start[spared] > low, chords.stop[spared] < high
    chords.start[spared] = np.where(head, low, chords.start[spared])
    chords.stop[spared] = np.where(tail, high, chords.stop[spared])
    left, right = chords.before[spared[head]], chords.after[spared[tail]]
    _break_after(chords, np.concatenate([left[left >= 0], spared[tail]]))
    _cut_back(chords, part, left[left >= 0], right[right >= 0])
    return np.setdiff1d(gone, spared[chords.alive[spared]])


def break_unmet(chords: Chords, part: Part, uncut: float) -> None:
    """Break the path between chords that were no neighbours before and of which one is trimmed where the ball
    is free, so that more than ``uncut`` mm would stay."""
    one = np.flatnonzero(chords.alive & chords.crosses & (chords.after >= 0))
    one = one[(chords.after[one] != chords.next[one]) & ~chords.ghost[one] & ~chords.ghost[chords.after[one]]]
    two = chords.after[one]
    ends = place_on(chords, one, chords.stop[one]), place_on(chords, two, chords.start[two])
    unmet = np.zeros(len(one), bool)
    for chord, low, high, other in (
        (one, chords.stop[one], chords.high[one], two),
        (two, chords.low[two], chords.start[two], one),
    ):
        ask = np.flatnonzero(chords.real[chord] & (high - low > COINCIDENT_MM))
        near = ends[0].take(ask, axis=1), ends[1].take(ask, axis=1)
        found = _free_where_claimed(
            chords, part, chord[ask], low[ask], high[ask], (other[ask],), (near, uncut)
        )
        unmet[ask] |= found.any & (found.high - found.low > WORTH * chords.radius)
    one, two = one[unmet], two[unmet]
    if len(one):
        _break_after(chords, one)
        _cut_back(chords, part, one, two)


def _break_after(chords: Chords, chord: Ints) -> None:
    after = chords.after[chord]
    chords.before[after[after >= 0]] = -1
    chords.after[chord], chords.crosses[chord] = -1, False


def _cut_back(chords: Chords, part: Part, tails: Ints, heads: Ints) -> None:
    """Cut the chords at which a path now ends, and those at which one begins, back to where the ball is free;
    those on which it is nowhere free go, and so do pieces of arcs."""
    while len(tails) or len(heads):
        tails = _cut_back_side(chords, part, tails, 1.0)
        heads = _cut_back_side(chords, part, heads[chords.alive[heads]], -1.0)
        tails = tails[chords.alive[tails]]


def _cut_back_side(chords: Chords, part: Part, chord: Ints, sense: float) -> Ints:
    """Cut ends of paths (``sense`` 1) or beginnings (-1) back; return those that follow what is dropped."""
    chord = chord[chords.alive[chord] & ~chords.ghost[chord]]
    low = np.where(sense > 0.0, chords.start[chord], chords.low[chord])
    high = np.where(sense > 0.0, chords.high[chord], chords.stop[chord])
    keeps = chords.real[chord] & (high - low > COINCIDENT_MM)
    ask = np.flatnonzero(keeps)
    found = _free_stretch(chords, part, chord[ask], low[ask], high[ask], sense)
    keeps[ask] = found.any
    kept = chord[ask[found.any]]
    if sense > 0.0:
        chords.stop[kept] = found.high[found.any]
    else:
        chords.start[kept] = found.low[found.any]
    gone = chord[~keeps]
    onward = chords.before[gone] if sense > 0.0 else chords.after[gone]
    drop_chords(chords, gone)
    return onward[onward >= 0]


def _places(chords: Chords, low: Floats, high: Floats) -> tuple[Ints, Floats]:
    """Return the row of the stretch (n,) and the place (n,) mm on it, of places along stretches."""
    count = np.clip(np.ceil((high - low) / (STEP * chords.radius)), 1, MOST).astype(np.int64)
    owner, step = number_runs(count)
    return owner, low[owner] + (step + 0.5) / count[owner] * (high - low)[owner]


def _free_where_claimed(
    chords: Chords,
    part: Part,
    chord: Ints,
    low: Floats,
    high: Floats,
    claims: tuple[Ints, ...],
    beyond: tuple[tuple[Floats, Floats], float] | None = None,
) -> _Stretches:
    """Find the longest free stretches of chords that the planes of ``claims`` (k,) each, -1 for none, claim.
    ``beyond``: only what lies more than so many mm outside the balls at the ends of the way between two
    places (3, k) counts."""
    owner, t = _places(chords, low, high)
    place = place_on(chords, chord[owner], t)
    claimed = np.zeros(len(owner), bool)
    for claim in claims:
        by = claim[owner]
        claimed |= (by >= 0) & (height_above(chords, by, place) < -CLAIM)
    if beyond is not None:
        (one, two), uncut = beyond
        contact = place - chords.radius * chords.normal.take(chord[owner], axis=1)
        claimed &= _off_way(contact, one.take(owner, axis=1), two.take(owner, axis=1)) > chords.radius + uncut
    free = np.zeros(len(owner), bool)
    free[claimed] = part.leaves_free(place[:, claimed], FREE)
    some = np.zeros(len(chord), bool)
    some[owner[free]] = True
    inner = np.flatnonzero(some)
    found = _free_stretch(chords, part, chord[inner], low[inner], high[inner], 0.0, FREE)
    whole = _Stretches(low.copy(), high.copy(), some)
    whole.low[inner], whole.high[inner], whole.any[inner] = found
    return whole


def _off_way(place: Floats, one: Floats, two: Floats) -> Floats:
    """From ``place`` (3, n) to the nearest point of the way from ``one`` to ``two`` (3, n), (n,) mm."""
    along, off = two - one, place - one
    share = np.clip(dot(off, along) / np.maximum(dot(along, along), COINCIDENT_MM**2), 0.0, 1.0)
    off = off - share * along
    return np.asarray(np.sqrt(dot(off, off)))


def _free_stretch(
    chords: Chords,
    part: Part,
    chord: Ints,
    low: Floats,
    high: Floats,
    sense: float,
    tolerance: float = ENDS_FREE,
) -> _Stretches:
    """Find the last (``sense`` 1), the first (-1) or the longest (0) stretches on which the ball is free."""
    owner, t = _places(chords, low, high)
    free = part.leaves_free(place_on(chords, chord[owner], t), tolerance)
    begins = np.append(True, (owner[1:] != owner[:-1]) | (free[1:] != free[:-1]))[: len(owner)]
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(owner))[: len(first)] - 1
    runs = np.flatnonzero(free[first])
    rank = np.where(sense == 0.0, t[last[runs]] - t[first[runs]], sense * first[runs])
    runs = runs[np.lexsort((rank, owner[first[runs]]))]  # the last of each chord is the one
    runs = runs[np.append(owner[first[runs]][1:] != owner[first[runs]][:-1], True)[: len(runs)]]
    first, last = first[runs], last[runs]
    at = owner[first]
    result = _Stretches(low.copy(), high.copy(), np.zeros(len(chord), bool))
    result.any[at] = True
    ahead, behind = np.maximum(first - 1, 0), np.minimum(last + 1, len(owner) - 1)
    from_ = np.where((first > 0) & (owner[ahead] == at), t[ahead], low[at])
    to = np.where((last < len(owner) - 1) & (owner[behind] == at), t[behind], high[at])
    result.low[at] = _edge(chords, part, chord[at], t[first], from_, tolerance)
    result.high[at] = _edge(chords, part, chord[at], t[last], to, tolerance)
    return result


def _edge(
    chords: Chords, part: Part, chord: Ints, inside: Floats, outside: Floats, tolerance: float
) -> Floats:
    """Between a free place and another, the farthest to which the ball is free."""
    inside, outside, middle = inside.copy(), outside.copy(), outside
    for _ in range(HALVINGS):
        free = part.leaves_free(place_on(chords, chord, middle), tolerance)
        inside, outside = np.where(free, middle, inside), np.where(free, outside, middle)
        middle = 0.5 * (inside + outside)
    return inside
