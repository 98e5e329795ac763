# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where material stays because no ball of this size gets near enough: inside corners and hollows tighter than
it.

The ball is set on a place along the facet's normal and pushed out of what it enters, from the point that is
deepest in it, again and again. Where it comes to rest out of the part and near enough the ball alone can cut
there, whatever its shank does; where it does not, no place for it was found, and it is too tight.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.tool.body import Body, round_piece

from .rest_material import RestMaterial, uncut_finding
from .search import find_entries
from .swept_motion import still_positions

PUSHES = 12
"""So often a ball is pushed out: two walls take two, a hollow that closes slowly some more."""

MOST_PLACES = 3000
"""Places on which a ball is set; where more is left, as after passes far apart, some stand for all."""

ENTERS = 0.1
"""Of what may stay: so deep a ball may enter and still counts as out of the part."""


def find_ball(body: Body) -> float | None:
    """Return the radius, mm, of the ball at the end of a cutter; None where it has another end."""
    lowest = min(body.pieces, key=lambda piece: piece.low - piece.round)
    round_ = lowest.low_radius == lowest.high_radius == 0.0
    return lowest.round if round_ else None


def find_too_tight(tree: FacetTree, radius: float, point: Floats, normal: Floats, above: float) -> Bools:
    """Tell for which points (n, 3) mm of the surface with unit ``normal`` (n, 3) no place of a ball of
    ``radius`` mm was found that is out of the part and leaves at most ``above`` mm there."""
    ball, limit = Body((round_piece(0.0, radius, radius),)), ENTERS * above
    centre, tight, rows = point + radius * normal, np.ones(len(point), np.bool_), np.arange(len(point))
    up = np.array([0.0, 0.0, 1.0])
    for _ in range(PUSHES):
        still = still_positions(centre[rows] - radius * up, np.tile(up, (len(rows), 1)))
        entry = find_entries(ball, tree, still, limit)
        deep = entry.bound > limit
        tight[rows[~deep]] = False
        rows, away, depth = rows[deep], centre[rows[deep]] - entry.place[deep], entry.depth[deep]
        centre[rows] += (depth / np.maximum(np.linalg.norm(away, axis=1), 1e-12))[:, None] * away
        rows = rows[np.linalg.norm(centre[rows] - point[rows], axis=1) <= radius + above]
        if not len(rows):
            break
    return tight


def report_uncut(remainder: RestMaterial, above: float, untouched: float = 0.0) -> tuple[Finding, ...]:
    """Say where more than ``above`` mm is left, and of a cutter with a ball at its end how much of that is
    too tight for it. ``untouched`` mm2: what no pass touches."""
    return (*uncut_finding(remainder, above, untouched), *report_too_tight(remainder, above))


def report_too_tight(remainder: RestMaterial, above: float) -> tuple[Finding, ...]:
    """Say how much of the surface on which more than ``above`` mm is left is too tight for the ball; nothing
    where the cutter has none at its end, or part and cutter are not known."""
    mesh, rows = remainder.mesh, np.flatnonzero(remainder.height > above)
    radius = None if remainder.body is None else find_ball(remainder.body)
    if mesh is None or radius is None:
        return ()
    whole = float(remainder.area[rows].sum())
    rows = rows[:: -(-len(rows) // MOST_PLACES) or 1]
    normal, area = mesh.normal[remainder.facet[rows]], remainder.area[rows]
    area *= whole / area.sum() if len(rows) else 1.0
    tight = find_too_tight(facet_tree(mesh), radius, remainder.point[rows], normal, above)
    lost = float(area[tight].sum())
    if not lost:
        return ()
    text = say(
        "{lost} of that are tighter than the cutter: a ball of its size finds no place there that leaves "
        "less. On {rest} the ball fits.",
        lost=Area(lost, ".4g"),
        rest=Area(float(area[~tight].sum()), ".4g"),
    )
    return (report_finding(Code.UNCUT_TOO_TIGHT, text, lost),)
