# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places from which the tool cannot rise: it is free where it stands, but some of the part is over it.

overhang   what a tool meets on its way up along its axis. A way that leads from under it to a lifted place
           beside it goes through the part, and nothing put in between helps: there is no way out along the
           axis, so such a place cannot be cut under it.
rise       how far a tool goes up until nothing is over it; no farther than the last point of the part above
           it demands.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.search import find_demanded_lift, find_entries, which_enter
from freecad_fiveaxis.core.gouge.swept_motion import still_positions, ways_up
from freecad_fiveaxis.core.tool.body import Body, extend_way_out, way_out

LAYERS = 200
"""Times that a tool rises to the next point over it."""

ROUGHLY = 0.5
"""Of the cutter's thickness: so near to the deepest point is near enough to rise by. That nothing deeper than
the aim is left is known all the same."""


def rise_above(
    cutter: Body, tree: FacetTree, tip: Floats, axis: Floats, aim: float, progress: Progress = silent
) -> Floats:
    """How far (n,) mm cutters at tips and axes (n, 3) rise until their way up out of the part's box enters it
    by no more than ``aim`` mm; 0 where it does so from the start."""
    far, left = _out_of_box(tree, tip, axis), np.arange(len(tip))
    rise = np.maximum(
        find_demanded_lift(cutter, tree, ways_up(tip, axis, far), aim, progress) - 0.5 * aim, 0.0
    )
    enough = ROUGHLY * max(piece.most for piece in cutter.pieces)
    for _ in range(LAYERS):
        start, up, way = (
            tip[left] + rise[left, None] * axis[left],
            axis[left],
            np.maximum(far[left] - rise[left], 0.0),
        )
        entries = find_entries(cutter, tree, ways_up(start, up, way), aim, enough, progress=progress)
        deep = np.flatnonzero(entries.depth > 0.0)
        if not len(deep):
            break
        left, gone = left[deep], entries.u[deep] * way[deep]
        more = tree.allowance_of(entries.facet[deep])
        by = way_out(cutter, start[deep] + gone[:, None] * up[deep], up[deep], entries.place[deep], more)
        rise[left] += gone + np.maximum(by, 0.5 * aim)
    return rise


def is_under(
    cutter: Body, tree: FacetTree, tip: Floats, axis: Floats, aim: float, progress: Progress = silent
) -> Bools:
    """Which cutters (n,) at tips and axes (n, 3) enter the part by more than ``aim`` mm on their way up out
    of its box."""
    far = float(_out_of_box(tree, tip, axis).max(initial=0.0))
    body = extend_way_out(cutter, far) if far > 0.0 else cutter
    return which_enter(body, tree, still_positions(tip, axis), aim, np.arange(len(tip)), progress)


def _out_of_box(tree: FacetTree, tip: Floats, axis: Floats) -> Floats:
    """How far (n,) mm tips go along their axes until the whole of the part's box is below them."""
    middle, half = tree.middle[:, 0], tree.half[:, 0] + tree.most_allowance
    return np.asarray(
        np.maximum(((middle - tip) * axis).sum(axis=1) + (half * np.abs(axis)).sum(axis=1), 0.0)
    )


def groups_of(under: Bools, cuts: Bools, rows: Ints) -> Bools:
    """Of the rows marked ``under`` (n,) those that stand in one unbroken group, joined by ``cuts`` (n - 1,),
    with one of the rows ``rows`` (k,)."""
    group = np.cumsum(np.append(True, ~(cuts & under[1:] & under[:-1])))
    return np.asarray(under & np.isin(group, group[rows]))


def under_with(
    cutter: Body, tree: FacetTree, tip: Floats, axis: Floats, cuts: Bools, rows: Ints, aim: float,
    progress: Progress = silent
) -> Bools:  # fmt: skip
    """Of cutters at tips and axes (n, 3) those that are under something (:func:`is_under`), in one unbroken
    group, joined by ``cuts`` (n - 1,), with one of the rows ``rows`` (k,) that is."""
    under = groups_of(np.ones(len(tip), np.bool_), cuts, rows)  # all rows that cuts join to them
    row = np.flatnonzero(under)
    under[row] = is_under(cutter, tree, tip[row], axis[row], aim, progress)
    return groups_of(under, cuts, rows)
