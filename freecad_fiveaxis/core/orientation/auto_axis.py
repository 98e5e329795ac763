# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool axes of strategy `auto`: every contact takes its axis from the field on the surface, where that is
free.

preferred  the axis of the field, leaned by lead and tilt; where that is not free the axis of the field; where
           that is not either, the nearest free direction of one of the nearest nodes.

Nodes are few, and a narrow place may have none: contacts that are not free become nodes themselves, and the
field is found once more (:func:`refine_field`). Contacts without any free axis are told apart: a path that is
made leaves them out, others keep the axis given there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from enum import IntEnum
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Number, Point, Sentence, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher, stay_above
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, lean_axis
from freecad_fiveaxis.core.tool.barrel import Flank
from freecad_fiveaxis.core.toolpath.cl_offset import rows_between
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.feed_direction import feed_direction

from .at_pole import take_pole
from .axis_field import (
    Nodes,
    find_freedom,
    nearest_free,
    with_margin,
    with_way_out,
)
from .blocked_places import PART, Blocker, choose_places, choose_remedy, find_blockers, name_blocker
from .contacts import Contacts, find_contacts
from .facets_with_axis import AxisField
from .level_bottom import find_axes, stand_level

CLOSE = 1e-6
"""Of a step: rows that much farther apart by rounding are not divided again."""

FEW = 0.005
"""Of all contacts: where so few have no free axis, those are single places in corners, and no reason to check
the program."""

MORE = 400
"""Contacts, at most, that become nodes because they are not free."""

SOME = 8000
"""Contacts, about, that are asked for these: where nothing is free there, it is not free at those beside them
either."""


class Free(IntEnum):
    """What is free at a contact: nothing; the tool as it stands; its way out along its axis, too."""

    NONE = 0
    STANDING = 1
    WAY_OUT = 2


def auto_axes(
    path: OffsetPath, given: Floats, field: AxisField, mesh: Mesh, reacher: Reacher, options: AxisOptions,
    progress: Progress = silent, contacts: Contacts | None = None, blockers: Sequence[Blocker] = (),
) -> tuple[Floats, Ints, tuple[Finding, ...]]:  # fmt: skip
    """Find the unit axis (n, 3) of every row of ``path``, what is free with it (n,) of :class:`Free`, and say
    where nothing is.

    ``given`` (n, 3): what stays where no axis is free; ``field`` of the facets of ``mesh`` that are cut;
    ``reacher``: tool, machine and table; ``contacts``: those of ``path``, None: found here; ``blockers``:
    what is named where it is in the way, besides the part.
    """
    tree = facet_tree(mesh)
    contacts, long = contacts or find_contacts(path, mesh, reacher), with_way_out(reacher, tree)

    def find_blocking(rows: Ints) -> Ints:
        first = contacts.first[rows]
        point = contacts.stand[first]
        return find_blockers(point, contacts.normal[first], mesh, reacher, field.freedom.direction, blockers)

    free, tools = np.zeros(len(contacts.first), np.int64), (*stay_above(long), reacher)
    if not len(given) or not field.freedom.some.any():
        return given, free[contacts.contact], _findings(free, contacts, blockers, find_blocking)
    axis, by = _find_free_axes(field, contacts, tools, tree, progress)
    free[by < len(tools)] = Free.WAY_OUT
    free[by == len(tools) - 1] = Free.STANDING
    if (
        reacher.kinematics is not None and reacher.cutter.touches_as_ball
    ):  # what is no ball cuts otherwise when it leans otherwise

        def free_with(pole: Floats, near: Bools) -> Bools:
            found = np.zeros(len(free), np.bool_)
            for number, tool in enumerate(tools):
                found |= contacts.free(pole, near & (by == number), tool, tree, progress)
            return found

        axis = take_pole(axis, contacts.contact, path.polyline, reacher.kinematics, free_with)
    if options.lead or options.tilt:
        for number, tool in enumerate(tools):
            axis = _lean_axes(path, contacts, axis, by == number, tool, tree, options, progress)
    row_free = free[contacts.contact]
    found = _findings(free, contacts, blockers, find_blocking)
    return np.where(row_free[:, None] > 0, axis[contacts.contact], given), row_free, found


def refine_field(
    field: AxisField, path: OffsetPath, mesh: Mesh, reacher: Reacher, progress: Progress = silent,
    contacts: Contacts | None = None,
) -> AxisField:  # fmt: skip
    """Find the field once more with up to MORE contacts of ``path`` among its nodes, of those at which the
    ball fits and the tool with its way out is not free with the axis of the ``field`` given; that very field
    where there are none. ``contacts``: those of ``path``, None: found here."""
    tree, wide = facet_tree(mesh), with_margin(reacher)
    if not len(path.point) or not field.freedom.some.any():
        return field
    contacts, long = contacts or find_contacts(path, mesh, reacher), with_way_out(reacher, tree)
    each = np.arange(len(contacts.first))
    wanted = contacts.all_fit & (each % max(1, len(each) // SOME) == 0)
    axis = np.zeros((len(each), 3))
    axis[wanted] = field.at(contacts.point[wanted], contacts.mean[wanted], progress)
    rows = np.flatnonzero(wanted & ~contacts.free(axis, wanted, long, tree, progress))
    if not len(rows):
        return field
    more = _nodes_at(field, contacts, rows[:: max(1, -(-len(rows) // MORE))], wide)
    freedom = field.freedom.join(find_freedom(more, wide, tree, field.freedom.direction, progress))
    nodes = field.nodes.join(more)
    return AxisField(nodes, freedom, find_axes(nodes, freedom, wide, tree, progress))


def select_rows_with_way_out(free: Ints, polyline: Ints) -> Ints:
    """Choose the rows (k,) between the first and the last of each polyline (n,) from which the tool can be
    drawn out, of what is ``free`` (n,) there: what lies before and behind them can be neither come to nor
    left."""
    out = np.flatnonzero(free == Free.WAY_OUT)
    number = np.cumsum(np.diff(polyline, prepend=polyline[:1]) != 0)
    first, last = (
        np.full(number[-1:].max(initial=-1) + 1, len(free)),
        np.full(number[-1:].max(initial=-1) + 1, -1),
    )
    np.minimum.at(first, number[out], out)
    np.maximum.at(last, number[out], out)
    row = np.arange(len(free))
    return np.flatnonzero((row >= first[number]) & (row <= last[number]))


def divide_path(
    path: OffsetPath, axis: Floats, step: float, ring: float, barrel: Flank | None = None
) -> tuple[OffsetPath, Floats]:
    """Put rows between those of ``path`` until contacts are at most ``step`` mm apart, with axes (n, 3) that
    turn evenly; ``ring`` mm of the cutter, or the flank of a barrel."""
    pieces = np.ones(len(axis), np.int64)
    away = np.linalg.norm(np.diff(path.point, axis=0), axis=1)
    joined = np.diff(path.polyline) == 0
    pieces[1:][joined] = np.maximum(np.ceil(away[joined] / step - CLOSE), 1)
    return rows_between(path, axis, pieces, ring, barrel)[:2] if (pieces > 1).any() else (path, axis)


def _find_free_axes(
    field: AxisField, contacts: Contacts, tools: Sequence[Reacher], tree: FacetTree, progress: Progress
) -> tuple[Floats, Ints]:
    """Return the unit axis (k, 3) of each contact, and the first of the ``tools`` that is free with it (k,);
    their number where none is."""
    axis, none = field.at(contacts.point, contacts.mean, progress), len(tools)
    level = stand_level(axis, contacts.mean) if tools[0].cutter.has_level_bottom else None
    by = np.full(len(axis), none)
    for number, tool in enumerate(tools):
        if level is not None:
            good = contacts.free(level, by == none, tool, tree, progress)
            axis[good], by[good] = level[good], number
        by[contacts.free(axis, by == none, tool, tree, progress)] = number
        axis, pulled = _pull_axes(field, contacts, axis, by != none, tool, tree, progress)
        by[pulled & (by == none)] = number
    return _raise_axes(field, contacts, axis, by, tools, tree, progress) if tools[-1].floors else (axis, by)


def _raise_axes(
    field: AxisField, contacts: Contacts, axis: Floats, by: Ints, tools: Sequence[Reacher], tree: FacetTree,
    progress: Progress,
) -> tuple[Floats, Ints]:  # fmt: skip
    """Return the axes (k, 3), and ``by`` which of the ``tools`` each is free (k,), with axes above a floor,
    found of all directions, at up to MORE contacts that are not free above the highest one, and as many that
    are not free at all. Nodes beside them may know only axes that are not free here; but the few that need a
    low axis among those that need none stay as they are."""
    kinds = (
        np.flatnonzero(contacts.all_fit & one) for one in ((by > 0) & (by < len(tools)), by == len(tools))
    )
    rows = np.concatenate([one[:: max(1, -(-len(one) // MORE))] for one in kinds])
    nodes = _nodes_at(field, contacts, rows, tools[-1])
    freedom = find_freedom(nodes, tools[-1], tree, field.freedom.direction, progress)
    tried, (nearest, found) = axis.copy(), nearest_free(axis[rows], nodes.normal, freedom)
    tried[rows], rows, best = nearest, rows[found], np.full(len(by), len(tools))
    for number, tool in enumerate(tools[: len(tools[-1].floors)]):
        left = np.isin(np.arange(len(by)), rows) & (best == len(tools))
        best[contacts.free(tried, left, tool, tree, progress)] = number
    return np.where((best < by)[:, None], tried, axis), np.minimum(best, by)


def _nodes_at(field: AxisField, contacts: Contacts, rows: Ints, reacher: Reacher) -> Nodes:
    """Return contacts (k,) as nodes of the field."""
    at, normal = contacts.first[rows], contacts.mean[rows]
    stand = contacts.stand[at] + reacher.cutter.corner * (
        contacts.normal[at] - normal
    )  # the ball stays where it is
    return Nodes(
        contacts.point[rows], contacts.facet[rows], normal, stand, contacts.fits[at], field.nodes.spacing
    )


def _pull_axes(
    field: AxisField,
    contacts: Contacts,
    axis: Floats,
    free: Bools,
    reacher: Reacher,
    tree: FacetTree,
    progress: Progress,
) -> tuple[Floats, Bools]:
    """Return the axes (k, 3) with those that are not ``free`` (k,) pulled to free directions of the nearest
    nodes, or to their own normals, and what is free. On slivers the nearest nodes may all lie on another
    face."""
    found, free, wanted, out = axis.copy(), free.copy(), [axis], np.flatnonzero(~free)
    if not len(out):
        return found, free
    node, _ = field.near(contacts.point[out], contacts.mean[out])
    for column in (*node.T, None):
        still = ~free[out]
        left, tried = out[still], axis.copy()
        if column is None:
            tried[left] = contacts.mean[left]
        else:
            near = column[still]
            tried[left], _ = nearest_free(axis[left], field.nodes.normal[near], field.freedom.of(near))
        left = left[
            ~np.any([(one[left] == tried[left]).all(axis=1) for one in wanted], axis=0)
        ]  # nodes side by side: one direction
        freed = contacts.free(tried, np.isin(np.arange(len(free)), left), reacher, tree, progress)
        found[freed], free[freed] = tried[freed], True
        wanted.append(tried)
    return found, free


def _lean_axes(
    path: OffsetPath, contacts: Contacts, axis: Floats, free: Bools, reacher: Reacher, tree: FacetTree,
    options: AxisOptions,
    progress: Progress,
) -> Floats:  # fmt: skip
    """Return the axes (k, 3) leaned by lead and tilt where that leaves them ``free`` (k,)."""
    rows = axis[contacts.contact]
    tried = lean_axis(rows, feed_direction(path, rows), options.lead, options.tilt)[contacts.first]
    good = contacts.free(tried, free, reacher, tree, progress)
    return np.where((good & free)[:, None], tried, axis)


def _findings(
    free: Ints, contacts: Contacts, blockers: Sequence[Blocker] = (),
    find_blocking: Callable[[Ints], Ints] | None = None,
) -> tuple[Finding, ...]:  # fmt: skip
    """At how many contacts at which the ball fits no axis that was tried keeps the tool out of what is in its
    way, and what that is: of some contacts (k,) ``find_blocking`` tells it."""
    held = contacts.all_fit & (free == Free.NONE)
    count = int(np.count_nonzero(held))
    if not count:
        return ()
    x, y, z = contacts.point[int(held.argmax())].tolist()
    fields = {
        "count": count,
        "all": len(free),
        "share": Number(100.0 * count / len(free), ".3g"),
        "place": Point((x, y, z)),
    }
    blocking = np.array([PART])
    if blockers and find_blocking is not None:
        blocking = find_blocking(np.flatnonzero(held)[choose_places(np.ones(count))])
    text = _say_blocked(fields, blocking, blockers)
    severity = Severity.NOTE if count <= FEW * len(free) else Severity.WARNING
    return (report_finding(Code.NO_FREE_AXIS, text, float(count), 0.0, place=(x, y, z), severity=severity),)


def _say_blocked(fields: Mapping[str, Any], blocking: Ints, blockers: Sequence[Blocker]) -> Sentence:
    """Say what is in the way at contacts without a free axis, of some of which it is known (k,)."""
    shares = {number: float((blocking == number).mean()) for number in range(len(blockers))}
    named = [(blockers[number], share) for number, share in shares.items() if share > 0.0]
    if not named:
        return say(
            "At {count} of {all} contacts ({share} %), the first at {place}, no tool axis was found that the "
            "machine can take up and that keeps the tool out of the part; they are left out. Use a smaller "
            "cutter or holder, or a longer tool, or turn the part.",
            **fields,
        )
    causes = [name_blocker(one, Number(100.0 * share, ".3g")) for one, share in named]
    text = say(
        "At {count} of {all} contacts ({share} %), the first at {place}, no tool axis was found that the "
        "machine can take up and that keeps the tool off what stands about it; they are left out. In the way "
        "is {causes}. {remedy}",
        **fields, causes=join_sentences(causes, ", "), remedy=choose_remedy([one for one, _ in named]),
    )  # fmt: skip
    rest = 1.0 - sum(share for _, share in named)
    besides = say(
        "At the others ({share} %) the part is: use a smaller cutter or holder, or a longer tool, or turn "
        "the part.",
        share=Number(100.0 * rest, ".3g"),
    )
    return text if rest < FEW else join_sentences((text, besides))
