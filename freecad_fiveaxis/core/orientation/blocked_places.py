# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in the way at places where no tool axis is free: the machine's table or a fixture, where an axis is
free without it; else the part itself."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Number, Sentence, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher

from .axis_field import Nodes, find_freedom
from .raised_contacts import raise_contacts

FREE, PART = -2, -1
"""Instead of the number of a blocker: an axis is free there; none is, whichever blocker is taken away."""

TRIED = 300
"""Places, at most, that are asked: each for all directions, as a node of the field."""

GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
"""Steps of this share fall evenly on whatever order the places have."""

HIGHER = say("Clamp the part higher above the table.")
OTHERWISE = say("Clamp the part otherwise, so that the fixture stands elsewhere.")


@dataclass(frozen=True, eq=False)
class Blocker:
    """What may be in the way: a fixture by ``name``, the table where that is empty. ``mesh`` and
    ``reacher``: what the tool is kept out of, and tool and table, without it."""

    name: str
    mesh: Mesh
    reacher: Reacher


def name_blocker(blocker: Blocker, share: Number) -> Sentence:
    """Name a blocker, with the ``share`` % of the places at which it is in the way."""
    if not blocker.name:
        return say("the table at {share} % of them", share=share)
    return say("the fixture {fixture} at {share} % of them", fixture=blocker.name, share=share)


def choose_remedy(blockers: Sequence[Blocker]) -> Sentence:
    """Say what helps against these."""
    if all(one.name for one in blockers):
        return OTHERWISE
    return HIGHER if not any(one.name for one in blockers) else join_sentences((HIGHER, OTHERWISE))


def choose_places(weight: Floats, count: int = TRIED) -> Ints:
    """Choose rows (k,) of places with these weights (n,), at most ``count``, evenly by weight; all of few."""
    if len(weight) <= count:
        return np.arange(len(weight))
    summed = np.cumsum(weight)
    at = np.searchsorted(summed, (GOLDEN * np.arange(count) % 1.0) * summed[-1])
    return np.unique(np.minimum(at, len(weight) - 1))


def find_blockers(
    point: Floats, normal: Floats, mesh: Mesh, reacher: Reacher, direction: Floats,
    blockers: Sequence[Blocker],
) -> Ints:  # fmt: skip
    """Find which of the ``blockers`` (n,) is in the way of a ball that is to touch ``point`` (n, 3) mm, where
    the surface has the unit ``normal`` (n, 3), with any ``direction`` (d, 3): the first without which an axis
    is free; FREE and PART besides."""
    found = np.full(len(point), FREE)
    rows = np.arange(len(point))
    rows = rows[~_find_some_free(point, normal, mesh, reacher, direction)]
    found[rows] = PART
    for number, one in enumerate(blockers):
        if not len(rows):
            break
        freed = _find_some_free(point[rows], normal[rows], one.mesh, one.reacher, direction)
        found[rows[freed]] = number
        rows = rows[~freed]
    return found


def _find_some_free(point: Floats, normal: Floats, mesh: Mesh, reacher: Reacher, direction: Floats) -> Bools:
    """Whether any axis is free at each place (n,)."""
    tree = facet_tree(mesh)
    nodes = Nodes(
        point, np.zeros(len(point), np.int64), normal, *raise_contacts(reacher, tree, point, normal), 1.0
    )
    return find_freedom(nodes, reacher, tree, direction).some
