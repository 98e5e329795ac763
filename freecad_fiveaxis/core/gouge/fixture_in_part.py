# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a fixture stands in the part: what no clamping does, but a wrong place, other units, or the stock
in place of a vise.

touch     jaws lie on the part, a soft one is pressed into it, and both are meshed by chords: PRESSED is none.
told      a task that makes no program refuses it; a program that is made or audited has it as its first
          finding, an error, before all that is told of the fixture where it cannot stand.
deep      a sample of the one's surface in the other, about which a ball of PRESSED meets none of its facets;
          or such a place below the surface, which lies so deep in both: where the fixture is the part itself,
          or a body little larger or smaller than it, neither's surface lies deep in the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool.body import Body, round_piece

from .fixtures import Fixture
from .inside import inside, is_closed
from .obstacles import enters
from .rest_material import surface_samples

PRESSED = 1.0
"""mm: so deep in each other part and fixture touch."""

ALONG = 60
"""Samples along the shorter of part and fixture, about."""

BELOW = 1.01
"""Of PRESSED: so deep below the surface is looked for what lies in both."""

NOTHING = 1e-6
"""mm: a facet that comes so far into the ball meets it."""


def check_apart(mesh: Mesh, fixtures: Sequence[Fixture]) -> None:
    """Check that none of the fixtures, work frame, stands deeper than PRESSED in the part, nor the part in
    it. Raises SettingsError that names the first that does, and a place."""
    for one, place in _find_in_part(mesh, fixtures):
        raise SettingsError(
            say(
                "{option}: {fixture} stands in the part, more than {depth} deep at {at}; check its place "
                "and its units",
                option=Option("fixture"), fixture=one.name, depth=Length(PRESSED), at=Point(place),
            ),
            one.name,
        )  # fmt: skip


def report_in_part(mesh: Mesh, fixtures: Sequence[Fixture]) -> Iterator[Finding]:
    """Report each fixture that does, of a program that is made or audited all the same."""
    for one, place in _find_in_part(mesh, fixtures):
        text = say(
            "The fixture {fixture} stands in the part, more than {depth} deep at {at}: check its place and "
            "its units first. What else is told of it is told of that place.",
            fixture=one.name, depth=Length(PRESSED), at=Point(place),
        )  # fmt: skip
        yield report_finding(Code.FIXTURE_IN_PART, text, place=place)


def _find_in_part(
    mesh: Mesh, fixtures: Sequence[Fixture]
) -> Iterator[tuple[Fixture, tuple[float, float, float]]]:
    for one in fixtures:
        pairs = (one.mesh, mesh), (mesh, one.mesh)
        places = (find(*pair) for find in (find_deep, find_common) for pair in pairs)
        place = next((place for place in places if place is not None), None)
        if place is not None:
            yield one, place


def find_deep(mesh: Mesh, other: Mesh) -> tuple[float, float, float] | None:
    """Find a place (3,) mm of the surface of ``mesh`` that lies deeper than PRESSED in the ``other``; None
    where no sample does, or that is not closed."""
    near = find_facets_near(mesh, other)
    if not near.any() or not is_closed(other):
        return None
    point, _, _ = surface_samples(mesh, choose_spacing(mesh, other), near)
    return _take_first(select_deep(point, other))


def find_common(mesh: Mesh, other: Mesh) -> tuple[float, float, float] | None:
    """Find a place (3,) mm that lies deeper than PRESSED in ``mesh`` and in the ``other``, little below the
    surface of the first; None where no sample does, or one is not closed."""
    near = find_facets_near(mesh, other, BELOW * PRESSED)
    if not near.any() or not (is_closed(other) and is_closed(mesh)):
        return None
    point, facet, _ = surface_samples(mesh, choose_spacing(mesh, other), near)
    below = point - BELOW * PRESSED * mesh.normal[facet]
    return _take_first(select_deep(select_deep(below, other), mesh))


def select_deep(point: Floats, mesh: Mesh, depth: float = PRESSED) -> Floats:
    """Select those of the points (n, 3) mm that lie deeper than ``depth`` mm in a closed mesh."""
    point = point[inside(facet_tree(mesh), point)]
    up = np.tile((0.0, 0.0, 1.0), (len(point), 1))
    ball = Body((round_piece(0.0, depth, depth),))
    return point[~enters(ball, facet_tree(mesh), point - depth * up, up, NOTHING)]


def _take_first(point: Floats) -> tuple[float, float, float] | None:
    if not len(point):
        return None
    x, y, z = point[0].tolist()
    return x, y, z


def find_facets_near(mesh: Mesh, other: Mesh, margin: float = 0.0) -> Bools:
    """Find the facets (f,) whose boxes reach into the other's box, or come nearer to it than a margin, mm."""
    low, high = other.box
    corner = mesh.vertex[mesh.face]
    reach = (corner.max(axis=1) > low - margin) & (corner.min(axis=1) < high + margin)
    return np.asarray(reach.all(axis=1))


def choose_spacing(mesh: Mesh, other: Mesh) -> float:
    """mm between samples: fine enough for the part of the boxes that both have, never so fine that samples
    are many."""
    low, high = (np.stack(ends) for ends in zip(mesh.box, other.box, strict=True))
    both: Floats = high.min(axis=0) - low.max(axis=0)
    return max(float(both.max()) / ALONG, float(np.ptp(mesh.vertex, axis=0).max()) / (4 * ALONG))
