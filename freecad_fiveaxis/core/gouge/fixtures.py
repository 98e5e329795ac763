# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool against fixtures (vise, clamps, raw stock), on the way that the machine really goes.

fixture   a mesh in the work frame: it stands still beside the part, whichever of both the machine moves.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, Hit, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Point, Template, join_sentences, say
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import Body

from .check import GougeCheck, check_program
from .fixture_places import parse_fixture, place_mesh
from .worst import find_nearest, find_unproven, find_worst, near_finding

ENTERS = Template(
    "The {part} goes at least {depth} into the fixture {fixture} at {at}, deepest of {count} blocks."
)
REMEDY = say("Clamp the part otherwise, use a longer tool or a smaller holder, or machine fewer faces.")


@dataclass(frozen=True, eq=False)
class Fixture:
    """``mesh``, mm in the work frame, and the ``name`` by which it is told of."""

    name: str
    mesh: Mesh


def read_fixtures(
    paths: tuple[str, ...], progress: Progress = silent, unit: float = 1.0
) -> tuple[Fixture, ...]:
    """Read the STL files of the fixtures, whose coordinates count ``unit`` mm each, and put them where
    ``paths`` say that they stand. Raises FiveAxisError for what says no place, before any is read, and for
    what is no mesh, naming the file."""
    files = [parse_fixture(path) for path in paths]
    return tuple(Fixture(one.name, place_mesh(read_stl(one.path, progress, unit), one)) for one in files)


def join_obstacles(mesh: Mesh, fixtures: Sequence[Fixture]) -> Mesh:
    """Join part and fixtures into what a tool has to keep out of; the very part where there are none. Nothing
    is welded: the part's facets come first and keep their numbers."""
    if not fixtures:
        return mesh
    all_ = [mesh, *(one.mesh for one in fixtures)]
    first = np.cumsum([0, *(len(one.vertex) for one in all_[:-1])])
    facet = np.cumsum([0, *(len(one.face) for one in all_[:-1])])
    coedge = np.cumsum([0, *(len(one.coedge_face) for one in all_[:-1])])
    return Mesh(
        np.concatenate([one.vertex for one in all_]),
        np.concatenate([one.face + at for one, at in zip(all_, first, strict=True)]),
        np.concatenate([one.normal for one in all_]),
        np.concatenate([one.area for one in all_]),
        np.concatenate([one.coedge_vertex + at for one, at in zip(all_, first, strict=True)]),
        np.concatenate(
            [
                np.where(one.coedge_face < 0, -1, one.coedge_face + at)
                for one, at in zip(all_, facet, strict=True)
            ]
        ),
        np.concatenate([one.face_coedge + at for one, at in zip(all_, coedge, strict=True)]),
    )


def box_with(box: tuple[Floats, Floats], fixtures: Sequence[Fixture]) -> tuple[Floats, Floats]:
    """Find the box, low and high corner (3,) mm, about a box and the fixtures."""
    low, high = zip(box, *(one.mesh.box for one in fixtures), strict=True)
    return np.min(low, axis=0), np.max(high, axis=0)


def check_fixtures(
    fixtures: tuple[Fixture, ...], body: Body, kinematics: Chain, program: Program, tolerance: float,
    back: float = 0.0,
    progress: Progress = silent, rapids: str = INTERPOLATED, clearance: float = 0.0,
) -> tuple[Finding, ...]:  # fmt: skip
    """Find where the ``body`` goes more than ``tolerance`` mm into a fixture, on any block, or nearer to it
    than ``clearance`` mm; see :func:`.check.check_program`. None deeper, or nearer by more than the
    tolerance, is missed; told of each fixture is the deepest place, or the nearest where nothing enters."""
    found: list[Finding] = []
    for fixture in fixtures:
        check = check_program(fixture.mesh, body, kinematics, program, tolerance, back, progress, "", rapids)
        new = [*_entering(fixture, check, program, tolerance), *_unproven(fixture, check, program, tolerance)]
        near = find_nearest(
            body,
            clearance if not new else 0.0,
            fixture.mesh,
            kinematics,
            program,
            tolerance,
            back,
            progress,
            rapids,
        )
        if near is not None:
            new.append(near_finding(Code.FIXTURE_NEAR, fixture.name, near, clearance, Point(near.place)))
        found += new
    return tuple(found)


def _entering(fixture: Fixture, check: GougeCheck, program: Program, tolerance: float) -> Iterator[Finding]:
    worst = find_worst(check, program)
    if worst is None:
        return
    row, line, count = worst.row, worst.line, worst.blocks
    hit = Hit(worst.part, fixture.name, worst.u)
    if worst.depth:
        text = ENTERS.say(
            part=worst.part,
            depth=Length(worst.depth, ".4g"),
            fixture=fixture.name,
            at=Point(worst.place),
            count=count,
        )
        text = join_sentences((text, REMEDY))
        yield report_finding(
            Code.FIXTURE_COLLISION, text, worst.depth, tolerance, row, line, worst.place, unit="mm", hit=hit
        )
    else:
        text = say(
            "In {count} blocks the whole cutter is inside the fixture {fixture}. Check the work zero and "
            "the units of the fixture.",
            count=count, fixture=fixture.name,
        )  # fmt: skip
        yield report_finding(Code.FIXTURE_COLLISION, text, float(count), 0.0, row, line, unit="1", hit=hit)


def _unproven(fixture: Fixture, check: GougeCheck, program: Program, tolerance: float) -> Iterator[Finding]:
    """Yield what is not proven of rapids whose axes may run independently."""
    found = find_unproven(check.ways, program, tolerance)
    if found is None:
        return
    text = say(
        "In {count} rapids it is not proven that the tool stays out of the fixture {fixture} on every way "
        "of independent axes, the first in NC line {line}; it enters by no more than {bound}. Drive one "
        "group of axes after the other.",
        count=found.rapids, fixture=fixture.name, line=found.line, bound=Length(found.bound, ".3g"),
    )  # fmt: skip
    yield report_finding(Code.FIXTURE_UNPROVEN, text, found.bound, tolerance, found.row, found.line)
