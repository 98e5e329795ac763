# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table and fixtures of a job as what may be in the tool's way, and how much of what stays is so because of
them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Area, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge.rest_material import RestMaterial
from freecad_fiveaxis.core.gouge.too_tight import find_too_tight
from freecad_fiveaxis.core.orientation.axis_field import even_directions, main_directions
from freecad_fiveaxis.core.orientation.blocked_places import (
    HIGHER,
    OTHERWISE,
    Blocker,
    choose_places,
    find_blockers,
)

from .context import MillContext, obstacles_of
from .options import reacher_in


def list_blockers(context: MillContext) -> tuple[Blocker, ...]:
    """List the table, where it is known where it is, and the fixtures, each with what the tool is kept out of
    without it."""
    return tuple(_each_blocker(context))


def _each_blocker(context: MillContext) -> Iterator[Blocker]:
    reacher, fixtures = reacher_in(context), context.fixtures
    if reacher.table is not None:
        yield Blocker("", context.obstacles, replace(reacher, table=None))
    for one in fixtures:
        others = [other for other in fixtures if other is not one]
        yield Blocker(one.name, obstacles_of(context.mesh, others, context.keep_off)[0], reacher)


def report_blocked(rest: RestMaterial, context: MillContext, above: float) -> tuple[Finding, ...]:
    """Say of how much of the surface on which more than ``above`` mm is left table or fixtures keep the tool:
    no tool axis that was tried is free there, and one is without them. Told of balls alone, which touch alike
    however they lean; what is too tight for the ball is not counted."""
    blockers, cutter = list_blockers(context), context.settings.cutter.cutter
    rows = np.flatnonzero(rest.height > above)
    if not len(rows) or not blockers or not cutter.touches_as_ball or not cutter.corner:
        return ()
    whole = float(rest.area[rows].sum())
    rows = rows[choose_places(rest.area[rows])]
    each = whole / float(rest.area[rows].sum()) * rest.area[rows]
    point, normal = rest.point[rows], context.mesh.normal[rest.facet[rows]]
    fits = ~find_too_tight(facet_tree(context.mesh), cutter.corner, point, normal, above)
    direction = np.concatenate([main_directions(context.mesh), even_directions()])
    found = find_blockers(
        point[fits], normal[fits], context.obstacles, reacher_in(context), direction, blockers
    )
    lost = [float(each[fits][found == number].sum()) for number in range(len(blockers))]
    return tuple(_report(one, area) for one, area in zip(blockers, lost, strict=True) if area > 0.0)


def _report(blocker: Blocker, lost: float) -> Finding:
    if not blocker.name:
        text = say(
            "About {lost} of that cannot be reached because of the table: the tool would go below its face. "
            "{remedy}",
            lost=Area(lost, ".4g"), remedy=HIGHER,
        )  # fmt: skip
        return report_finding(Code.UNCUT_AT_TABLE, text, lost)
    text = say(
        "About {lost} of that cannot be reached because of the fixture {fixture}, which is in the way. "
        "{remedy}",
        lost=Area(lost, ".4g"), fixture=blocker.name, remedy=OTHERWISE,
    )  # fmt: skip
    return report_finding(Code.UNCUT_AT_FIXTURE, text, lost)
