# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part and fixtures in task ``compare``: how they stand beside the program of each machine, and what is
reported of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import Choice, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixture_in_part import check_apart
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_bodies import spindle_body
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Setup
from freecad_fiveaxis.core.pipeline.options import choose_rapid_body, tip_to_driven, tool_body
from freecad_fiveaxis.core.pipeline.settings import Settings, is_part
from freecad_fiveaxis.core.pipeline.stl_files import read_mesh
from freecad_fiveaxis.core.tool.body import Body, lower_body

from .compare import Beside, Row
from .compare.beside_fixtures import find_worst_meeting, hits_fixture
from .compare.beside_part import find_deepest, rank_entry


def read_part_beside(
    settings: Settings, mesh: Mesh | None, fixtures: Sequence[Fixture], progress: Progress
) -> Mesh | None:
    """Return the part, where there is one and fixtures stand beside it: that at hand, else that of the
    settings. Raises FiveAxisError for a fixture in the part."""
    if not fixtures:
        return mesh
    if mesh is None and is_part(settings.source):
        mesh = read_mesh(settings, settings.source, progress)
    if mesh is not None:
        check_apart(mesh, fixtures)
    return mesh


def stand_beside(job: Settings, machine: Machine, setup: Setup, fixtures: Sequence[Fixture]) -> Beside | None:
    """Return the fixtures beside a machine's program; None where there are none. ``job``: of the task that
    makes the path."""
    if not fixtures:
        return None
    tool, back = tool_body(job), tip_to_driven(job)
    known = job.machine.tool_length is not None
    spindle = spindle_body(machine, setup.tool_length + back) if known else Body(())
    rapid = lower_body(choose_rapid_body(job), back)
    stack = Body((*tool.pieces, *spindle.pieces))
    return Beside(tuple(fixtures), stack, rapid, back, job.proof.tolerance, job.gouge.fixture_clearance)


def report_entries(rows: Sequence[Row]) -> Iterator[Finding]:
    """Yield the deepest entry into the part of all rows: an error where every way has one."""
    able = [row for row in rows if not row.problem]
    found = [(row, deep) for row in able if (deep := find_deepest(row.part)) is not None]
    if found:
        row, deep = max(found, key=lambda one: rank_entry(one[1]))
        yield _of_row(row, deep, len(found) == len(able))


def report_hits(rows: Sequence[Row]) -> Iterator[Finding]:
    """Yield the deepest entry into a fixture of all rows: an error where every way has one."""
    able = [row for row in rows if not row.problem]
    hit = [row for row in able if hits_fixture(row.fixtures)]
    found = [(met.room, row, met.found) for row in hit if (met := find_worst_meeting(row.fixtures))]
    if found:
        _, row, deep = min(found, key=lambda one: one[0])
        yield _of_row(row, deep, len(hit) == len(able))


def _of_row(row: Row, found: Finding, everywhere: bool) -> Finding:
    text = say(
        "On {machine} with correction {cure}: {what}",
        machine=row.machine, cure=Choice("cures", (row.cure,), alone=True), what=found.text,
    )  # fmt: skip
    grave = Severity.ERROR if everywhere else Severity.WARNING
    return replace(found, severity=grave, text=text, block=None, line=None)
