# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether fixtures and part stand in a body of the machine on which they are clamped, or are of another size
than a machine: a wrong work zero, a wrong place, or other units.

clamped  bodies of table and base that no linear axis moves against the work, as platter and cradle: with
         the rotary axes at zero they are where they are wherever the tool stands. What other bodies do to
         part and fixtures is found on the program's way.
depth    of the deepest sample of the one's surface in the other.
size     of fixtures and of bodies in files against the machine's strokes: what is TINY, or LARGE and HUGE, is
         in another unit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, Sentence, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.bodies import BASE, FILE, MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup

from .carried_motion import steps_between, work_carrier
from .fixture_in_part import PRESSED, choose_spacing, find_common, find_facets_near, select_deep
from .fixtures import Fixture
from .inside import is_closed
from .machine_bodies import make_mesh
from .rest_material import surface_samples

STEPS = 6
"""Halvings by which a depth is found, after it has been doubled often enough."""

TINY, LARGE = 10.0, 2000.0
"""mm: no fixture, and no body that has a file of its own, is smaller than the one; and none larger than the
other that is longer than HUGE times the longest stroke, too."""

HUGE = 4.0
"""Times the longest stroke."""

INCH, METRE = 25.4, 1000.0
"""mm."""


def report_placing(
    machine: Machine, setup: Setup, part: Mesh | None, fixtures: Sequence[Fixture]
) -> tuple[Finding, ...]:
    """Report fixtures and part that stand in bodies of the machine, and files that seem to be in other units.
    Raises FiveAxisError for the file of a body that cannot be used."""
    sunk = find_sunk(machine, setup, part, fixtures)
    return (*_report_units(machine, fixtures), *map(report_sunk, sunk))


class Sunk(NamedTuple):
    """The ``fixture`` by its name, None for the part, that stands in a ``body``, ``depth`` mm deep at
    ``place`` (3,) mm at least."""

    fixture: str | None
    body: str
    depth: float
    place: Vector


def find_sunk(
    machine: Machine, setup: Setup, part: Mesh | None, fixtures: Sequence[Fixture]
) -> Iterator[Sunk]:
    """Yield what stands in which body on which it is clamped. Raises FiveAxisError for the file of a body
    that cannot be used."""
    bodies = [one for one in machine.bodies if _is_clamped_on(machine, one)]
    meshes = [(one.name, make_mesh(one, -np.array(setup.origin))) for one in bodies]
    for name, mesh in meshes:
        for fixture in fixtures:
            found = find_overlap(fixture.mesh, mesh)
            if found is not None:
                yield Sunk(fixture.name, name, *found)
        found = None if part is None else find_overlap(part, mesh)
        if found is not None:
            yield Sunk(None, name, *found)


def report_sunk(one: Sunk) -> Finding:
    """Report what stands in a body."""
    if one.fixture is None:
        return _part_in_body(one.body, one.depth, one.place)
    return _in_body(one.fixture, one.body, one.depth, one.place)


def _is_clamped_on(machine: Machine, body: MachineBody) -> bool:
    held = [BASE, *(axis.letter for axis in machine.fitted if axis.side == "table")]
    steps = steps_between(machine, work_carrier(machine), body.carrier)
    return body.carrier in held and all(step.axis.rotary for step in steps)


def _in_body(fixture: str, body: str, depth: float, place: Vector) -> Finding:
    text = say(
        "The fixture {fixture} stands in {body}, a body of the machine, at least {depth} deep at {at}. Check "
        "the work zero on the machine ({zero}), the fixture's place and its units, or mend the body.",
        fixture=fixture, body=body, depth=Length(depth, ".3g"), at=Point(place), zero=Option("origin"),
    )  # fmt: skip
    return report_finding(Code.FIXTURE_IN_BODY, text, depth, PRESSED, place=place)


def _part_in_body(body: str, depth: float, place: Vector) -> Finding:
    text = say(
        "The part stands in {body}, a body of the machine, at least {depth} deep at {at}. Check the work "
        "zero on the machine ({zero}), or mend the body.",
        body=body, depth=Length(depth, ".3g"), at=Point(place), zero=Option("origin"),
    )  # fmt: skip
    return report_finding(Code.PART_IN_BODY, text, depth, PRESSED, place=place)


def find_overlap(mesh: Mesh, other: Mesh) -> tuple[float, Vector] | None:
    """Find how deep, mm, and where (3,) mm two meshes are in each other, deeper than PRESSED; None where they
    are not, or no samples find it."""
    ways = [one for one in (_find_deepest(mesh, other), _find_deepest(other, mesh)) if one is not None]
    if ways:
        return max(ways)
    place = find_common(mesh, other)
    return None if place is None else (PRESSED, place)


def _find_deepest(mesh: Mesh, other: Mesh) -> tuple[float, Vector] | None:
    near = find_facets_near(mesh, other)
    if not near.any() or not is_closed(other):
        return None
    point, _, _ = surface_samples(mesh, choose_spacing(mesh, other), near)
    point = select_deep(point, other)
    if not len(point):
        return None
    depth, point = _deepen(point, other)
    x, y, z = point[0].tolist()
    return depth, (x, y, z)


def _deepen(point: Floats, other: Mesh) -> tuple[float, Floats]:
    """Find how deep the deepest of points (n, 3) mm is at least, and keep those that are so."""
    low, high = PRESSED, 2.0 * PRESSED
    while len(kept := select_deep(point, other, high)):
        low, high, point = high, 2.0 * high, kept
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        kept = select_deep(point, other, middle)
        low, high, point = (middle, high, kept) if len(kept) else (low, middle, point)
    return low, point


def _report_units(machine: Machine, fixtures: Sequence[Fixture]) -> Iterator[Finding]:
    most = max(LARGE, HUGE * find_longest_stroke(machine))
    for fixture in fixtures:
        size = _size(fixture.mesh)
        if not TINY <= size <= most:
            yield _units_of_fixture(fixture.name, size, most)
    for body in machine.bodies:
        if body.shape == FILE:
            size = _size(make_mesh(body, np.zeros(3)))
            if not TINY <= size <= most:
                yield _units_of_body(body.name, size, most)


def find_longest_stroke(machine: Machine) -> float:
    """Find the longest way, mm, of a linear axis that has limits; infinity where none has."""
    ways = [axis.high - axis.low for axis in machine.fitted if not axis.rotary]
    return max((way for way in ways if math.isfinite(way)), default=math.inf)


def _size(mesh: Mesh) -> float:
    return float(np.ptp(mesh.vertex, axis=0).max())


def _units_of_fixture(name: str, size: float, most: float) -> Finding:
    text = say(
        "The fixture {name} is {size} long: its file may be in metres ({metres}) or inches ({inches}), or "
        "scaled too often. Export it in mm, or name the units of STL files: {option}.",
        name=name, size=Length(size, ".4g"), metres=Length(METRE * size, ".4g"),
        inches=Length(INCH * size, ".4g"), option=Option("stl_units"),
    )  # fmt: skip
    return _units(text, size, most)


def _units_of_body(name: str, size: float, most: float) -> Finding:
    text = say(
        "The body {name} of the machine is {size} long: its file may be in metres ({metres}) or inches "
        "({inches}), or scaled too often. Files of bodies are read in mm: export it so.",
        name=name, size=Length(size, ".4g"), metres=Length(METRE * size, ".4g"),
        inches=Length(INCH * size, ".4g"),
    )  # fmt: skip
    return _units(text, size, most)


def _units(text: Sentence, size: float, most: float) -> Finding:
    return report_finding(Code.UNIT_SUSPECTED, text, size, TINY if size < TINY else most, unit="mm")
