# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three tasks that write no program: ``setup``, where the part should stand; ``compare``, which machine and
which cure; ``reach``, where the tool gets at all.

trial     a program that is made only to know what it costs. Both tasks make the CL path once, as ``mill`` and
          ``post`` do, and try it many times; no program is written. What is chosen is then given to ``mill``
          or ``post``.
solid     a source that ends in .stl; any other is a CL file.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NoReturn

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.errors import FiveAxisError, ReachError, SettingsError
from freecad_fiveaxis.core.base.files import write_all
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.base.sentences import Choice, Length, Option, join_sentences, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture, box_with
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher
from freecad_fiveaxis.core.machine import Machine, Vector, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program, build_program
from freecad_fiveaxis.core.passes import standing_facets
from freecad_fiveaxis.core.pipeline.avoided import report_places
from freecad_fiveaxis.core.pipeline.context import JobContext
from freecad_fiveaxis.core.pipeline.driving import drive
from freecad_fiveaxis.core.pipeline.fewer_axes import suit_tool_axis, what_needs_more_axes
from freecad_fiveaxis.core.pipeline.job import choose_facets, make
from freecad_fiveaxis.core.pipeline.machine_around import bodies_in_pose
from freecad_fiveaxis.core.pipeline.mill_context import find_area
from freecad_fiveaxis.core.pipeline.options import (
    compute_driven_to_surface,
    load_setup,
    resolve_setup,
    tip_to_driven,
    title_of,
)
from freecad_fiveaxis.core.pipeline.over_table import AUTO, IN_TABLE
from freecad_fiveaxis.core.pipeline.programs import MilledProgram, PostedProgram
from freecad_fiveaxis.core.pipeline.settings import (
    FRAMES,
    MILL,
    POST,
    REACH,
    SETUP,
    Settings,
    flat_options,
    is_part,
)
from freecad_fiveaxis.core.pipeline.settings.groups import USUAL_REGION
from freecad_fiveaxis.core.pipeline.stl_files import read_job_fixtures, read_mesh
from freecad_fiveaxis.core.tool.stick_out import Stack
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .as_milled import Seen, check_against_part, forget
from .compare import Row, compare, compare_html, compare_json, compare_text, station
from .compare_beside import read_part_beside, report_entries, report_hits, stand_beside
from .corrections import check_cures, cures
from .in_the_room import name_machine, report_standing, watch_machine
from .reach_map import ReachMap, reach_map
from .reach_report import reach_html, reach_json, reach_text
from .setup_map import (
    Posting,
    Region,
    SetupMap,
    heat_map_html,
    part_box,
    setup_json,
    setup_map,
    setup_text,
)
from .setup_map.room import with_longer_tool, with_room
from .setup_map.standing import Standing, turn_mesh

GRIDS = ((7, 7, 3), (5, 5, 3), (3, 3, 3))
"""Places along X, Y, Z of a map that nobody asked to be otherwise, the finest first."""
WORK = 8_000_000
"""Rows of all trials of such a map together: some ten to twenty seconds."""


@dataclass(frozen=True, eq=False)
class SetupTrial:
    """``draft``: the program of the present setup; ``chart``: the map, with what is recommended."""

    settings: Settings
    draft: PostedProgram
    chart: SetupMap
    findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class Comparison:
    """``draft``: the program on the first machine; ``rows``: one for each machine, cure and kind of
    control; ``placed``: of the findings those on how part and fixtures stand, which no row says."""

    settings: Settings
    draft: PostedProgram
    rows: tuple[Row, ...]
    findings: tuple[Finding, ...]
    placed: tuple[Finding, ...] = ()


@dataclass(frozen=True, eq=False)
class ReachTrial:
    """``found``: the reach map of the part, by the ``reacher``."""

    settings: Settings
    found: ReachMap
    findings: tuple[Finding, ...]
    reacher: Reacher


Trial = SetupTrial | Comparison | ReachTrial


def run(settings: Settings, progress: Progress = silent, executor: Executor | None = None) -> Trial:
    """Do the task that the settings name. ``executor``: whose workers make the trials, with the same result
    to the last bit; None: they are made here. Raises FiveAxisError for input that cannot be used; writes
    nothing."""
    if settings.task == REACH:
        return try_reach(settings, progress, executor=executor)
    if settings.task == SETUP:
        return try_setups(settings, progress, executor=executor)
    return try_machines(settings, progress, executor=executor)


def try_reach(
    settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None,
    fixtures: Sequence[Fixture] | None = None, most: float = math.pi, executor: Executor | None = None,
) -> ReachTrial:  # fmt: skip
    """Where the tool gets on the part. ``mesh``, ``faces``, ``fixtures``: as in :func:`~.job.make`; ``most``
    rad from +Z it may lean; ``executor``: as in :func:`run`. Raises FiveAxisError."""
    machine, setup, _ = resolve_setup(settings, load_machine(settings.machine.machine))
    table = machine.table if settings.setup.table_height is None else settings.setup.table_height
    if not is_part(settings.source) and mesh is None:
        raise SettingsError(say("{source} is no part; give its STL", source=settings.source), settings.source)
    fixtures = read_job_fixtures(settings, progress) if fixtures is None else fixtures
    mesh = read_part_beside(settings, mesh, fixtures, progress)
    mesh = read_mesh(settings, settings.source, progress) if mesh is None else mesh
    mesh, faces, avoided, remarks = choose_facets(settings, mesh, faces, progress)
    area = find_area(settings, mesh, faces, avoided)
    table, below = _table_under(mesh, None if table is None else table - setup.origin[2])
    tool = settings.gouge
    limit, cutter = settings.proof.tolerance, settings.cutter.cutter
    kinematics = chain(machine, setup)
    bodies = bodies_in_pose(settings, machine, kinematics, mesh, fixtures, progress)
    reacher = Reacher(cutter, tool.shank, tool.holder, kinematics, limit, table, most, machine=bodies)
    found = reach_map(mesh, reacher, area.facets, progress, fixtures, executor, area.keep_off)
    if faces is None and most >= math.pi:  # as mill does where nobody says which facets are cut
        free = (found.obstacle == Obstacle.NONE) & standing_facets(mesh)[found.facet]
        found = replace(found, standing=float(found.area[free].sum()))
    remarks += report_standing(settings, machine, setup, mesh, fixtures)
    remarks += area.findings + report_places(area.keep_off, mesh, area.facets, found.spacing)
    return ReachTrial(settings, found, mesh.findings + remarks + below, reacher)


def _table_under(mesh: Mesh, table: float | None) -> tuple[float | None, tuple[Finding, ...]]:
    """Return the height of the table's face in the work frame, mm; None where it is not known, or cannot be
    right because the part would lie in the table: that is said."""
    lowest = float(mesh.box[0][2])
    if table is None or lowest >= table - IN_TABLE:
        return table, ()
    text = say(
        "The part's lowest place would be {depth} below the table: the table is not looked at. Give the "
        "work zero with {origin}, or the table's height with {table_height}.",
        depth=Length(table - lowest), origin=Option("origin"), table_height=Option("table_height"),
    )  # fmt: skip
    return None, (report_finding(Code.PART_BELOW_TABLE, text, table - lowest),)


def try_setups(
    settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None,
    executor: Executor | None = None, fixtures: tuple[Fixture, ...] | None = None,
) -> SetupTrial:  # fmt: skip
    """Where the part should stand. ``mesh``, ``faces``, ``fixtures``: as in :func:`~.job.make`;
    ``executor``: as in :func:`run`.

    Raises SettingsError for a region with nothing to choose from, and for one that leaves every limit.
    """
    job = suit_tool_axis(_job_settings(settings), load_machine(settings.machine.machine))
    machine, base, dialect = load_setup(
        replace(job, task=SETUP)
    )  # and what makes no sense for a setup is refused
    table = machine.table if settings.setup.table_height is None else settings.setup.table_height
    _region(settings, base.origin, 1, table)  # before the long work
    fixtures = read_job_fixtures(settings, progress) if fixtures is None else fixtures
    mesh = read_part_beside(settings, mesh, fixtures, progress)
    program = _post_job(job, progress, mesh, faces, fixtures)
    region = _region(settings, base.origin, len(program.path.tip), table)
    posting, enough = _posting(job, program, dialect), settings.proof.tolerance
    held = _find_solid(program), program.fixtures
    collide = watch_machine(program.settings, machine, dialect, base, held, progress)
    chart = setup_map(
        program.path, machine, base, region, posting, enough, progress, table, executor, collide,
        min((float(one.mesh.box[0][2]) for one in program.fixtures), default=math.inf),
    )  # fmt: skip
    thick = settings.setup.jaw_thickness
    if chart.best is None:
        longer = with_longer_tool(chart, lambda one: _standing(one, program, machine), thick, progress)
        chart = longer or _refuse(chart)
    else:
        chart = with_room(chart, _standing(chart, program, machine), thick, progress)
    chosen = _standing(chart, program, machine)
    setup, solid = replace(base, origin=chosen.origin), chosen.turned_part
    found = report_standing(program.settings, machine, setup, solid, chosen.turned_fixtures)
    chart = replace(chart, findings=(*found, *chart.findings))
    return SetupTrial(settings, program, chart, chart.findings)


def try_machines(
    settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None,
    executor: Executor | None = None, fixtures: tuple[Fixture, ...] | None = None,
) -> Comparison:  # fmt: skip
    """Return the same path on every machine that the settings name, with each cure. The path is made for the
    first of them that can cut it; those that cannot are rows that say why. ``fixtures``: as in
    :func:`~.job.make`; ``executor``: as in :func:`run`.

    Raises SettingsError for an unknown cure, MachineError for an unknown machine, before any of the long
    work; and what the first machine says where none can cut the path.
    """
    names, wanted = settings.compare.machines, check_cures(settings.compare.cures)
    if not names:
        raise SettingsError(say("there are no machines to compare; name at least one"), names)
    machines = [load_machine(name) for name in names]
    fixtures = read_job_fixtures(settings, progress) if fixtures is None else fixtures
    mesh = read_part_beside(settings, mesh, fixtures, progress)
    each_settings = [
        suit_tool_axis(_job_settings(settings, name), machine)
        for name, machine in zip(names, machines, strict=True)
    ]
    stands = [resolve_setup(job, machine) for job, machine in zip(each_settings, machines, strict=True)]
    refused = [
        what_needs_more_axes(job, machine) for job, machine in zip(each_settings, machines, strict=True)
    ]
    order = sorted(range(len(names)), key=lambda at: -machines[at].rotaries)  # settings of most suit the rest
    program = _draft_for_first(
        [each_settings[at] for at in order], [refused[at] for at in order], progress, mesh, faces, fixtures
    )
    stations = [
        station(
            machine, setup, _posting(settings, program, dialect), name, "" if why is None else why.text,
            stand_beside(program.settings, machine, setup, fixtures),
            check_against_part(program, machine, setup, dialect),
        )
        for name, (machine, setup, dialect), why in zip(names, stands, refused, strict=True)
    ]  # fmt: skip
    rows = compare(program.path, stations, cures(program, wanted), progress=progress, executor=executor)
    forget(program)
    placed = _report_placed(program, stands, fixtures)
    return Comparison(
        settings, program, rows,
        (*placed, *_row_findings(rows), *report_entries(rows), *report_hits(rows)), placed,
    )  # fmt: skip


def _report_placed(
    program: PostedProgram, stands: Sequence[tuple[Machine, Setup, Dialect]], fixtures: Sequence[Fixture]
) -> tuple[Finding, ...]:
    """Return how part and fixtures stand on each of the machines; what is so on all of them, once."""
    solid = _find_solid(program)
    each = [
        name_machine(report_standing(program.settings, machine, setup, solid, fixtures), machine.name)
        for machine, setup, _ in stands
    ]
    return tuple({one.text: one for found in each for one in found}.values())


def _draft_for_first(
    each_settings: Sequence[Settings], refused: Sequence[SettingsError | None], progress: Progress,
    mesh: Mesh | None, faces: Bools | None, fixtures: tuple[Fixture, ...] | None,
) -> PostedProgram:  # fmt: skip
    """Return the path and its program on the first machine that can take up all of its axes. Raises what the
    first machine says where there is none."""
    problems: list[FiveAxisError] = []
    for job, why in zip(each_settings, refused, strict=True):
        try:
            if why is None:
                return _post_job(job, progress, mesh, faces, fixtures, Seen())
            problems.append(why)
        except ReachError as error:
            problems.append(error)
    raise problems[0]


def _job_settings(settings: Settings, machine: str = "") -> Settings:
    """Return the settings of the task that makes the path, on one of several machines."""
    task = MILL if Path(settings.source).suffix.lower() == ".stl" else POST
    given = replace(settings.machine, machine=machine) if machine else settings.machine
    plain = replace(settings.head, rtcp="off")  # with and without it is tried anyway
    return replace(settings, task=task, machine=given, head=plain if machine else settings.head)


def _post_job(
    job: Settings, progress: Progress, mesh: Mesh | None, faces: Bools | None,
    fixtures: tuple[Fixture, ...] | None = None, seen: Seen | None = None,
) -> PostedProgram:  # fmt: skip
    if mesh is not None:
        job = replace(job, task=MILL)
    program = make(job, progress, mesh, faces, fixtures, seen)
    if not isinstance(program, PostedProgram):
        raise SettingsError(
            say("{source} is no source of a path; give an STL or a CL file", source=job.source), job.source
        )
    if seen is not None:
        seen.keep(program)
    return program


def _find_solid(program: PostedProgram) -> Mesh | None:
    """Return the part of a program; None where it is not known."""
    return program.mesh if isinstance(program, MilledProgram) else None


def _standing(chart: SetupMap, program: PostedProgram, machine: Machine) -> Standing:
    """Return the recommended setup with all that stands in it. Rapids are taken as they are interpolated:
    where they may not be, ``mill`` divides them until every way is free."""
    settings, row = program.settings, chart.best or 0
    x, y, z = chart.origin[row].tolist()
    stack = Stack(settings.cutter.cutter, settings.gouge.shank, settings.gouge.holder)
    part = _find_solid(program)
    entering = program.entering if isinstance(program, MilledProgram) else 0.0

    def post(
        kinematics: Chain, path: CLPath, tool: Stack, turn: float, progress: Progress
    ) -> tuple[JointPath, Program]:
        held = [replace(one, mesh=turn_mesh(one.mesh, turn)) for one in program.fixtures]
        box = box_with(part_box(program.path, None if part is None else part.vertex, turn), held)
        given = with_tool(settings, tool)
        context = JobContext(given, machine, kinematics, program.dialect, box, progress)
        joints = drive(context, path, entering)
        inverse_time = settings.feeds.feed_mode == "g93"
        return joints, build_program(joints, kinematics, program.dialect, inverse_time, progress)

    return Standing(
        program.path, machine, chart.base, post, (x, y, z), float(chart.turn[row]), part, program.fixtures,
        chart.table, stack, settings.machine.tool_length is not None, tip_to_driven(settings),
        settings.gouge.fixture_clearance, settings.proof.tolerance,
        None if part is None else _find_axes_choice(settings),
    )  # fmt: skip


def _find_axes_choice(settings: Settings) -> Choice | None:
    """Find the option by which tool axes are chosen by what is free of the whole tool."""
    if settings.tool_axis.tool_axis == AUTO:
        return Choice("tool_axis", (AUTO,), flag=True)
    if settings.passes.passes == FRAMES:
        return Choice("passes", (FRAMES,), flag=True)
    chosen = settings.gouge.gouge
    return Choice("gouge", (chosen,), flag=True) if chosen in ("tilt", "leave-out") else None


def with_tool(settings: Settings, tool: Stack) -> Settings:
    """Return the settings with another tool."""
    gouge = replace(settings.gouge, shank=tool.shank, holder=tool.holder)
    return replace(settings, cutter=replace(settings.cutter, cutter=tool.cutter), gouge=gouge)


def _posting(settings: Settings, program: PostedProgram, dialect: Dialect) -> Posting:
    part = program.mesh.vertex if isinstance(program, MilledProgram) else None
    inverse_time = settings.feeds.feed_mode == "g93"
    return Posting(
        dialect,
        inverse_time,
        settings.links.clearance,
        settings.cutter.cutter.radius,
        part,
        compute_driven_to_surface(program.settings),
    )


def _region(settings: Settings, centre: Vector, rows: int, table: float | None) -> Region:
    """Return the region about the present work zero, with as many places as are asked for, or as ``rows`` of
    the path leave time for. Where nobody says how high the ``table`` is, Z of the usual region stays where it
    is.

    Raises SettingsError where there is nothing to choose from.
    """
    half, turns, grid = settings.setup.region, int(settings.setup.turns), settings.setup.grid
    half = (half[0], half[1], 0.0) if table is None and half == USUAL_REGION else half
    if not any(half) and turns == 1:
        text = say(
            "region 0,0,0 with 1 turn has one setup only; give {region} a way to go along X, Y or Z, or "
            "{turns} above 1",
            region=Option("region"),
            turns=Option("turns"),
        )
        raise SettingsError(text, half)
    able = [count for count in GRIDS if _places(half, count, turns) * rows <= WORK] or [GRIDS[-1]]
    x, y, z = able[0] if grid is None else (int(count) for count in grid)
    count = (x if half[0] else 1, y if half[1] else 1, z if half[2] else 1)
    low, high = (
        (centre[0] + s * half[0], centre[1] + s * half[1], centre[2] + s * half[2]) for s in (-1.0, 1.0)
    )
    return Region(low, high, count, tuple(2.0 * math.pi * turn / turns for turn in range(turns)))


def _places(half: Vector, count: tuple[int, int, int], turns: int) -> int:
    return turns * math.prod(one for one, way in zip(count, half, strict=True) if way)


def _refuse(chart: SetupMap) -> NoReturn:
    low, high = chart.region.low, chart.region.high
    sides = zip("XYZ", low, high, strict=True)
    box = join_sentences((say("{letter} {low} to {high}", letter=letter, low=Length(a, bare=True),
        high=Length(b, bare=letter != "Z"))
                  for letter, a, b in sides), ", ")  # fmt: skip
    why = next(
        (one.text for one in chart.findings if one.severity is Severity.ERROR),
        say("the axes leave their limits everywhere"),
    )
    raise SettingsError(say("setup region {box}: {why}", box=box, why=why), (low, high))


def _row_findings(rows: Sequence[Row]) -> Iterator[Finding]:
    grave = Severity.ERROR if all(row.problem for row in rows) else Severity.WARNING
    for machine, cure, problem in dict.fromkeys(
        (row.machine, row.cure, row.problem) for row in rows if row.problem
    ):
        text = say(
            "On {machine} with correction {cure} the path cannot be driven: {problem}",
            machine=machine,
            cure=Choice("cures", (cure,), alone=True),
            problem=problem,
        )
        yield report_finding(Code.CANNOT_BE_COMPARED, text, severity=grave)


def as_text(trial: Trial) -> str:
    """Return what was found, for the terminal."""
    title = f"{title_of(trial.settings)}: {trial.settings.task}\n"
    if isinstance(trial, SetupTrial):
        return title + setup_text(trial.chart)
    if isinstance(trial, ReachTrial):
        return title + reach_text(trial.found, trial.findings)
    return title + compare_text(trial.rows, trial.settings.proof.tolerance, trial.placed)


def as_json(trial: Trial) -> str:
    """Return what was found, for scripts; ``inputs`` is a job file."""
    inputs = flat_options(trial.settings)
    if isinstance(trial, ReachTrial):
        return reach_json(trial.found, inputs, trial.findings)
    if isinstance(trial, SetupTrial):
        return setup_json(trial.chart, inputs)
    return compare_json(trial.rows, inputs, trial.placed)


def as_html(trial: Trial) -> str:
    """Write what was found, as a page of its own."""
    name = title_of(trial.settings)
    if isinstance(trial, SetupTrial):
        return heat_map_html(trial.chart, name)
    if isinstance(trial, ReachTrial):
        return reach_html(trial.found, name, trial.findings)
    return compare_html(trial.rows, name, trial.settings.proof.tolerance, trial.placed)


REPORTS = {".json": as_json, ".html": as_html, ".htm": as_html, ".txt": as_text}


def write_outputs(trial: Trial) -> list[str]:
    """Write the reports that the settings name, all or none; returns their names. Raises FileError."""
    reports = trial.settings.output.report
    files = {
        path: REPORTS[Path(path).suffix.lower()](trial).encode("utf-8", "backslashreplace")
        for path in reports
    }
    write_all(files)
    return list(files)
