# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed passes chained: each begins, and runs, so that a rotary axis with limits can go on from where the
pass before it ends."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import inverse_axis
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.joint_path.branches import POLE_ANGLE, within_limits
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.passes.piece_order import Tour, arrange_pieces
from freecad_fiveaxis.core.passes.ring_chain import TURN, Ways, choose_ways
from freecad_fiveaxis.core.passes.ring_starts import begin_at, find_closed, find_sense, reverse, unwind_ring
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .context import MillContext
from .records import SolvedJoints

PLACES = 16
"""Places round a ring, by the axis' word, at which it may begin, besides where it does."""
LITTLE = 0.1
"""Way, mm, that a ring has to spare to begin elsewhere or to run the other way round."""


class _Rows(NamedTuple):
    """Of the contacts: the ``words`` (2, n), rad, of the axis on either branch, NaN at the pole; ``fits`` (2,
    n): the other axis' word is within its limits; ``when`` (n,) the row of the joint path that cuts each;
    ``cut`` (n,): on a facet that is machined."""

    words: Floats
    fits: Bools
    when: Ints
    cut: Bools


class _Choice(NamedTuple):
    """What a way is of a ring: how many rows later it begins, and whether it runs the other way round."""

    start: Ints
    back: Bools


def chain_rings(
    context: MillContext, solved: SolvedJoints, when: Ints, axis: int
) -> tuple[ContactPath, bool] | None:
    """Return the passes with rings begun elsewhere or reversed so that the ``axis``, a column of the words,
    turns back seldom, and whether any is reversed; None where all stay as they are. ``when`` (n,): the rows
    of the joint path that cut the contacts. Rings are reversed only where passes may run to and fro."""
    contact, joints = solved.contact, solved.joints
    rows = _read_rows(context, contact, joints, when, axis)
    closed = find_closed(contact, context.keep)
    closed = closed[[_is_whole(solved, when[first:behind]) for first, behind in closed.tolist()]]
    begins = {int(first): ring for ring, first in enumerate(closed[:, 0])}
    edge = np.flatnonzero(np.diff(contact.polyline, prepend=-1, append=-1))
    spans = [span for span in zip(edge[:-1].tolist(), edge[1:].tolist(), strict=True) if _turns(rows, *span)]
    spans.sort(key=lambda span: int(rows.when[slice(*span)].min()))
    to_and_fro = context.settings.links.order == "zigzag"
    ways, choices = [], []
    for first, behind in spans:
        ring = _ways_round(contact, rows, first, behind, to_and_fro) if first in begins else None
        one, choice = ring if ring is not None else _ways_along(contact, rows, first, behind)
        ways.append(one)
        choices.append(choice)
    if not ways:
        return None
    chosen = choose_ways(
        ways,
        _find_free(context, joints, [rows.when[slice(*span)] for span in spans]),
        float(context.kinematics.low[axis]),
        float(context.kinematics.high[axis]),
    )
    start, back = np.zeros(len(closed), np.int64), np.zeros(len(closed), np.bool_)
    for (first, _), choice, way in zip(spans, choices, chosen.tolist(), strict=True):
        if first in begins:
            start[begins[first]], back[begins[first]] = choice.start[way], choice.back[way]
    if not (start.any() or back.any()):
        return None
    begun = reverse(begin_at(contact, closed[start > 0], start[start > 0]), closed[back])
    return _order_as_cut(begun, rows, edge), bool(back.any())


def _is_whole(solved: SolvedJoints, when: Ints) -> bool:
    """Return whether the rows ``when`` of the joint path are cut without a link between them."""
    row = solved.joints.row[when]
    return bool((solved.path.motion[row.min() + 1 : row.max() + 1] < Motion.LINK).all())


def _order_as_cut(contact: ContactPath, rows: _Rows, edge: Ints) -> ContactPath:
    """Return the passes in the order in which they are cut, and those that a later stage turns round turned
    round, so that no tour is worth leaving that order for."""
    first, last = edge[:-1], edge[1:] - 1
    spans = [slice(*span) for span in zip(first.tolist(), (last + 1).tolist(), strict=True)]
    order = np.argsort([int(rows.when[span].min()) for span in spans], kind="stable")
    back = np.array([find_sense(rows.when[span]) < 0.0 for span in spans])
    return arrange_pieces(contact, first, last, Tour(order, back[order]))


def _read_rows(context: MillContext, contact: ContactPath, joints: JointPath, when: Ints, axis: int) -> _Rows:
    """Return what is known of each contact."""
    kinematics, tool = context.kinematics, joints.path.axis[when]
    both, _ = inverse_axis(kinematics, tool)
    words = np.array(both[:, :, axis - 3])
    pole = np.linalg.norm(np.cross(tool, kinematics.direction[3]), axis=1) <= POLE_ANGLE
    words[:, pole] = np.nan
    fits = within_limits(both, kinematics.low[3:], kinematics.high[3:]) | pole
    return _Rows(words, fits, when, context.keep[contact.face])


def _turns(rows: _Rows, first: int, behind: int) -> bool:
    """Return whether a polyline is cut and needs the axis at all: one along the pole leaves it where it
    is."""
    span = slice(first, behind)
    return bool((rows.cut[span] & ~np.isnan(rows.words[:, span]).all(axis=0)).any())


def _find_free(context: MillContext, joints: JointPath, cuts: list[Ints]) -> Bools:
    """Return to which of the passes (p,), whose rows of the joint path are ``cuts``, a rapid above the part
    leads that is not there to turn back on."""
    path, height = joints.path, float(context.box[1][2]) + context.settings.links.clearance
    given = np.append(np.diff(joints.row) > 0, True)
    above = (path.motion == Motion.RAPID) & given & (path.tip[:, 2] >= height - LITTLE)
    count = np.cumsum(above)
    last = [int(rows.max()) for rows in cuts]
    return np.array(
        [True, *(count[rows.min()] > count[behind] for rows, behind in zip(cuts[1:], last, strict=False))]
    )


def _branches(rows: _Rows, span: slice) -> list[int]:
    """Return the branches on which the other axis stays within its limits all along, both where neither
    does."""
    good = [branch for branch in (0, 1) if (rows.fits[branch, span] | ~rows.cut[span]).all()]
    return good or [0, 1]


def _fill(word: Floats) -> Floats:
    """Return words (n,) with those at the pole as those before them, or behind them at the beginning."""
    known = np.flatnonzero(~np.isnan(word))
    return np.asarray(word[known[np.maximum(np.searchsorted(known, np.arange(len(word)), "right") - 1, 0)]])


def _ways_along(contact: ContactPath, rows: _Rows, first: int, behind: int) -> tuple[Ways, _Choice]:
    """Return the ways to cut a pass that begins and runs as it does: one on each branch."""
    span = slice(first, behind)
    at = first + np.flatnonzero(rows.cut[span])
    if find_sense(rows.when[span]) < 0.0:
        at = at[::-1]
    branches = _branches(rows, span)
    way = [np.unwrap(_fill(rows.words[branch, at])) for branch in branches]
    words = np.array([(one[0], one[-1], one.min(), one.max()) for one in way])
    ends = np.broadcast_to(contact.point[at[[0, -1]]], (len(way), 2, 3))
    none = np.zeros(len(way))
    return Ways(words, ends, np.array(branches), none), _Choice(none.astype(np.int64), none > 0)


def _ways_round(
    contact: ContactPath, rows: _Rows, first: int, behind: int, to_and_fro: bool
) -> tuple[Ways, _Choice] | None:
    """Return the ways to cut a closed pass, from each of some places and both ways round; None where it makes
    no whole turn of the axis."""
    span = slice(first, behind)
    words, start, branch = [], [], []
    for one in _branches(rows, span):
        round_, net = unwind_ring(_fill(rows.words[one, span]))
        if abs(net) < math.pi:
            return None
        places = _places(round_[:, 0])
        words.append(round_[places])
        start.append(places)
        branch.append(np.full(len(places), one))
    table, places, branches = np.concatenate(words), np.concatenate(start), np.concatenate(branch)
    swapped = table[:, [1, 0, 2, 3]]
    table, swapped = (swapped, table) if find_sense(rows.when[span]) < 0.0 else (table, swapped)
    back = np.zeros(len(table), np.bool_)
    if to_and_fro:
        table, back = np.concatenate([table, swapped]), np.repeat([False, True], len(places))
        places, branches = np.tile(places, 2), np.tile(branches, 2)
    ends = np.repeat(contact.point[first + places][:, None], 2, axis=1)
    worse = LITTLE * ((places > 0).astype(float) + back)
    return Ways(table, ends, branches, worse), _Choice(places, back)


def _places(way: Floats) -> Ints:
    """Return the rows, even ones, at which a ring with these words (n,) may begin: where it does and where it
    comes to some words."""
    rows = np.arange(0, len(way), 2)
    part = np.floor(way[rows] * (PLACES / TURN)).astype(np.int64) % PLACES
    return np.union1d([0], rows[np.unique(part, return_index=True)[1]])
