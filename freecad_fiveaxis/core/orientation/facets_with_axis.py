# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of tool axes of a part, and which of its facets it serves: a facet is left out where no axis is
free on it.

A facet is left out as a whole only where none of the nodes on it and near it has a free axis; of the others
each contact is asked (:mod:`.auto_axis`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import batches, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, Area, Length, Number, Sentence, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, stick_out_farther
from freecad_fiveaxis.core.passes.within_limits import LEVEL
from freecad_fiveaxis.core.tool.stick_out import LONGER_BY

from .axis_field import (
    Freedom,
    Nodes,
    agreeing,
    even_directions,
    find_freedom,
    main_directions,
    near_places,
    surface_nodes,
    unit,
    with_margin,
)
from .beyond_limits import narrow_reasons
from .blocked_places import PART, Blocker, choose_places, find_blockers
from .blocking_body import find_blocking_body
from .level_bottom import find_axes
from .slide_bottoms import slide_bottoms

OF_PART, OF_WANTED = say("of the part"), say("of what is to be machined")


class Whole(NamedTuple):
    """Of what shares are told: its ``area``, mm2, and how it is named behind a per cent sign."""

    area: float
    name: Sentence


NEAREST = 6
"""Nodes whose mean a contact takes."""

BATCH = 16384
"""Points that are asked for an axis at a time."""

TRIED, ENOUGH = 60, 0.9
"""A longer tool is tried at so many nodes, about, where the machine is in the way; it helps where such a
share is free then."""

ABOUT = 3
"""Nodes about the middle of a facet of which one must be free, where none lies on it."""


@dataclass(frozen=True, eq=False)
class AxisField:
    """The field: ``axis`` (n, 3) unit at its ``nodes``, and what is ``freedom`` there."""

    nodes: Nodes
    freedom: Freedom
    axis: Floats

    def near(self, point: Floats, normal: Floats) -> tuple[Ints, Floats]:
        """Return the nodes (k, NEAREST) nearest to points (k, 3) mm with unit normals (k, 3) of those where
        any axis is free, and their weights: one over the distance, and none for one that is as far off as the
        next one after them."""
        rows, tree = self._tree()
        return self._near(tree, rows, point, normal)

    def _tree(self) -> tuple[Ints, scipy.spatial.cKDTree]:
        """Return the nodes where any axis is free, and where they are."""
        rows = np.flatnonzero(self.freedom.some)
        return rows, scipy.spatial.cKDTree(self.nodes.places()[rows])

    def _near(
        self, tree: scipy.spatial.cKDTree, rows: Ints, point: Floats, normal: Floats
    ) -> tuple[Ints, Floats]:
        count = min(NEAREST + 1, len(rows))
        away, found = tree.query(near_places(point, normal, self.nodes.spacing), k=np.arange(1, count + 1))
        away = np.maximum(away, 1e-6 * self.nodes.spacing)
        weight = 1.0 / away[:, :-1] - 1.0 / away[:, -1:] if count > NEAREST else 1.0 / away
        node = rows[found[:, : weight.shape[1]]]
        return node, weight * agreeing(normal[:, None], self.nodes.normal[node]) + 1e-12

    def at(self, point: Floats, normal: Floats, progress: Progress = silent) -> Floats:
        """Return the unit axis (k, 3) at points (k, 3) mm with unit normals (k, 3)."""

        def mean(some: slice) -> Floats:
            node, weight = self._near(tree, rows, point[some], normal[some])
            return unit((self.axis[node] * weight[:, :, None]).sum(axis=1))

        rows, tree = self._tree()
        parts = batches(len(point), BATCH)
        found = in_threads(mean, parts, lambda share: progress("axis field", share))
        return np.concatenate(found) if parts else np.empty((0, 3))


def find_axis_field(
    mesh: Mesh, facets: Bools, reacher: Reacher, progress: Progress = silent, direction: Floats | None = None
) -> AxisField:
    """Find the field on ``facets`` (f,) of the part for tool, machine and table (``reacher``); ``direction``
    (d, 3): what is tried, None: spread evenly, and the part's own main ones. Raises SettingsError for sizes
    that no tool has."""
    tree, wide = facet_tree(mesh), with_margin(reacher)
    direction = np.concatenate([main_directions(mesh), even_directions()]) if direction is None else direction
    nodes = surface_nodes(mesh, facets, reacher, tree)
    if reacher.cutter.has_level_bottom:
        nodes = replace(
            nodes, stand=nodes.stand + slide_bottoms(wide, tree, nodes.stand, nodes.normal, progress)
        )
    freedom = find_freedom(nodes, wide, tree, direction, progress)
    return AxisField(nodes, freedom, find_axes(nodes, freedom, wide, tree, progress))


def select_facets(
    field: AxisField, mesh: Mesh, facets: Bools, most: float, reacher: Reacher | None = None,
    fixtures: Sequence[Blocker] = (), whole: Whole | None = None,
) -> tuple[Bools, tuple[Finding, ...]]:  # fmt: skip
    """Choose those of ``facets`` (f,) on or near which a node has a free axis, and say by reason what is left
    out.

    ``most`` rad: the largest angle from +Z that was wanted; ``reacher``: with which a longer tool is tried
    where the machine is in the way, None: none is; ``fixtures``: what is named where it is in the way, and
    not the part; ``whole``: of what shares are told, None: of the mesh. Raises ReachError where nothing is
    left.
    """
    whole = Whole(float(mesh.area.sum()), OF_PART) if whole is None else whole
    some, out = field.freedom.some, np.zeros(len(mesh.face), np.bool_)
    if some.all():
        return facets, ()
    rows = np.flatnonzero(facets)
    middle = mesh.vertex[mesh.face[rows]].mean(axis=1)
    about = near_places(middle, mesh.normal[rows], field.nodes.spacing)
    _, near = scipy.spatial.cKDTree(field.nodes.places()).query(
        about, k=np.arange(1, min(ABOUT, len(some)) + 1)
    )
    out[rows] = ~some[near].any(axis=1)
    out[field.nodes.facet[some]] = False
    reason = np.full(len(out), int(Obstacle.NONE))
    reason[rows] = _choose_reasons(field, mesh, reacher, near)
    if not (facets & ~out).any():
        met = Obstacle(int(np.bincount(reason[rows], mesh.area[rows]).argmax()))
        raise ReachError(
            say("no facet can be cut: no tool axis is free on any; {remedy}", remedy=_REMEDY[met]), None
        )
    by_machine = reacher is not None and (out & (reason == Obstacle.MACHINE)).any()
    longer = ""
    if reacher is not None and by_machine:
        longer = join_sentences((_name_blocking(field, mesh, reacher), _try_longer(field, mesh, reacher)))
    blocking = np.full(len(out), PART)
    if reacher is not None and fixtures and out.any():
        blocking[rows] = _find_fixtures(field, about, mesh, reacher, fixtures)
        blocking[~out | (reason == Obstacle.LIMITS) | (reason == Obstacle.TABLE)] = PART
    by_fixture = _report_at_fixtures(mesh, blocking, fixtures, whole)
    by_others = _report_left_out(mesh, out & (blocking < 0), reason, most, longer, whole)
    return facets & ~out, by_fixture + by_others


def _choose_reasons(field: AxisField, mesh: Mesh, reacher: Reacher | None, near: Ints) -> Ints:
    """Return what is in the way (k,) about facets with these nodes ``near`` (k, m) them, the nearest one
    first: that of the axis that gets farthest, where the nearest one does not tell more."""
    met = field.freedom.met if reacher is None else narrow_reasons(field.nodes, field.freedom, mesh, reacher)
    nearest, tells = met[near[:, 0]], (met != field.freedom.met)[near[:, 0]]
    return np.where(tells, nearest, field.freedom.met[near].max(axis=1))


def _find_fixtures(
    field: AxisField, about: Floats, mesh: Mesh, reacher: Reacher, fixtures: Sequence[Blocker]
) -> Ints:
    """Return which of the ``fixtures`` is in the way about facets (k,), by the nearest of some nodes where no
    axis is free; below zero where none is."""
    held = np.flatnonzero(~field.freedom.some)
    nodes = field.nodes.take(held[choose_places(np.ones(len(held)))])
    found = find_blockers(nodes.point, nodes.normal, mesh, reacher, field.freedom.direction, fixtures)
    return np.asarray(found[scipy.spatial.cKDTree(nodes.places()).query(about)[1]])


def _report_at_fixtures(
    mesh: Mesh, blocking: Ints, fixtures: Sequence[Blocker], whole: Whole
) -> tuple[Finding, ...]:
    """Say how much area is left out for each fixture, of the facets (f,) at which it is in the way."""
    found = []
    for number, one in enumerate(fixtures):
        group = blocking == number
        if group.any():
            why = say("the fixture {fixture} is in the way; clamp the part otherwise", fixture=one.name)
            found.append(_report_group(mesh, group, why, "", whole))
    return tuple(found)


def _some_held(field: AxisField) -> Nodes:
    """Return some of the nodes where no axis is free and the machine is in the way."""
    held = np.flatnonzero(~field.freedom.some & (field.freedom.met == Obstacle.MACHINE))
    return field.nodes.take(held[:: max(1, len(held) // TRIED)])


def _name_blocking(field: AxisField, mesh: Mesh, reacher: Reacher) -> str:
    """Say which body of the machine blocks most, at some of the nodes; nothing where none does alone."""
    nodes, direction = _some_held(field), field.freedom.direction
    name = find_blocking_body(nodes, with_margin(reacher), facet_tree(mesh), direction)
    return "" if name is None else say("Most of that is blocked by {name}.", name=name)


def _try_longer(field: AxisField, mesh: Mesh, reacher: Reacher) -> str:
    """Say by how much a longer tool would help, tried at some of the nodes where the machine is in the way;
    nothing where no tool does that is up to the last of LONGER_BY longer."""
    nodes, tree = _some_held(field), facet_tree(mesh)
    for more in LONGER_BY:
        longer = stick_out_farther(with_margin(reacher), more)
        share = (
            float(find_freedom(nodes, longer, tree, field.freedom.direction).some.mean())
            if len(nodes.point)
            else 0.0
        )
        if share >= ENOUGH:
            return say(
                "With a tool that sticks out {more} farther an axis is free on about {share} % of that.",
                more=Length(more), share=Number(100.0 * share, ".0f"),
            )  # fmt: skip
    return ""


def _report_left_out(
    mesh: Mesh, out: Bools, reason: Ints, most: float, longer: str, whole: Whole
) -> tuple[Finding, ...]:
    """How much area is left out for each reason; the place is the middle of the largest such facet."""
    down = out & (reason == Obstacle.LIMITS) & (mesh.normal[:, 2] < -math.sin(LEVEL))
    groups = [(obstacle, out & ~down & (reason == obstacle)) for obstacle in _REMEDY]
    return (
        *_looking_down(mesh, down, most, whole),
        *(_without_axis(mesh, group, why, longer, whole) for why, group in groups if group.any()),
    )


def _looking_down(mesh: Mesh, down: Bools, most: float, whole: Whole) -> tuple[Finding, ...]:
    if not down.any():
        return ()
    lost, share, place = _area_of(mesh, down, whole)
    text = say(
        "{area} ({share} % {of_whole}) look down and are left out: no tool axis within {most} of Z gets "
        "there. Turn the part over, or raise the largest axis angle.",
        area=Area(lost, ".6g"), share=share, of_whole=whole.name, most=Angle(math.degrees(most)),
    )  # fmt: skip
    if most >= math.pi:
        text = say(
            "{area} ({share} % {of_whole}) look down and are left out: no tool axis that the machine takes "
            "up gets there. Turn the part over.",
            area=Area(lost, ".6g"), share=share, of_whole=whole.name,
        )  # fmt: skip
    return (report_finding(Code.FACETS_LOOKING_DOWN, text, lost, 0.0, place=place),)


def _without_axis(mesh: Mesh, group: Bools, obstacle: Obstacle, longer: str, whole: Whole) -> Finding:
    longer = longer if obstacle == Obstacle.MACHINE else ""
    return _report_group(mesh, group, _REMEDY[obstacle], longer, whole)


def _report_group(mesh: Mesh, group: Bools, remedy: Sentence, longer: str, whole: Whole) -> Finding:
    lost, share, place = _area_of(mesh, group, whole)
    text = say(
        "{area} ({share} % {of_whole}) are left out, for no tool axis is free there: {remedy}.",
        area=Area(lost, ".6g"), share=share, of_whole=whole.name, remedy=remedy,
    )  # fmt: skip
    text = join_sentences((text, longer))
    return report_finding(Code.FACETS_WITHOUT_FREE_AXIS, text, lost, 0.0, place=place)


def _area_of(mesh: Mesh, group: Bools, whole: Whole) -> tuple[float, Number, tuple[float, float, float]]:
    """mm2, share of the whole in per cent, and the middle of the largest facet."""
    area = np.where(group, mesh.area, 0.0)
    x, y, z = mesh.vertex[mesh.face[int(area.argmax())]].mean(axis=0).tolist()
    return float(area.sum()), Number(100.0 * float(area.sum()) / whole.area, ".3g"), (x, y, z)


_REMEDY: dict[Obstacle, Sentence] = {
    Obstacle.HOLLOW: say("it is a closed hollow, where no tool gets in"),
    Obstacle.LIMITS: say(
        "beyond the machine's limits or the largest axis angle; turn the part over, or raise the angle"
    ),
    Obstacle.TABLE: say("the tool would go below the table; clamp the part higher"),
    Obstacle.CUTTER: say("it is too tight for the cutter; use a smaller one"),
    Obstacle.SHANK: say("the shank is in the way; use a thinner or a longer one"),
    Obstacle.HOLDER: say("the holder is in the way; let the tool stick out farther"),
    Obstacle.MACHINE: say(
        "the machine is in the way; use a longer tool, or clamp the part higher or elsewhere"
    ),
}
