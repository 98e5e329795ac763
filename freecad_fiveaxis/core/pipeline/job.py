# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole pipeline on one page: from a solid's STL to a proven program.

Three ways in: ``mill`` starts at the STL, ``post`` at a CL file, ``audit`` at a finished NC file; all three
end at the same proof of the rounded words, because that is what the machine gets. ``run`` makes and proves;
:mod:`.outputs` writes. What the settings ask for in the terms of the packages is in :mod:`.options`, the
stages of ``mill`` are in :mod:`.milling` and :mod:`.driving`, what keeps the tool out of the part in
:mod:`.collision_avoidance`.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.audit import Audit, AuditOptions, audit_program
from freecad_fiveaxis.core.audit.feed_words import large_feeds
from freecad_fiveaxis.core.audit.program_end import end_findings
from freecad_fiveaxis.core.audit.spindle import spindle_findings
from freecad_fiveaxis.core.audit.tool_length import assume_length, length_findings
from freecad_fiveaxis.core.audit.units import unit_findings
from freecad_fiveaxis.core.base.errors import ReachError, SettingsError, naming_file
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Option, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import GougeCheck, RestMaterial
from freecad_fiveaxis.core.gouge.faces import facets_on
from freecad_fiveaxis.core.gouge.fixture_in_part import report_in_part
from freecad_fiveaxis.core.gouge.fixtures import Fixture, box_with, check_fixtures
from freecad_fiveaxis.core.gouge.placing import report_placing
from freecad_fiveaxis.core.machine import Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.deviation import Deviation, measure, measure_above, without_guided
from freecad_fiveaxis.core.motion.singularity import find_singular
from freecad_fiveaxis.core.nc.head import slot_texts
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter, note_named_cutter
from freecad_fiveaxis.core.nc.reader import Assumed, dialect_of_text, read_in_order
from freecad_fiveaxis.core.orientation.strategies import find_strategy
from freecad_fiveaxis.core.passes import find_pass_strategy
from freecad_fiveaxis.core.report import Figures, judge
from freecad_fiveaxis.core.report.contacts import Contacts, contacts_of
from freecad_fiveaxis.core.report.near_part import stand_of
from freecad_fiveaxis.core.report.turns_at_pole import assume_programmed_feed
from freecad_fiveaxis.core.toolpath.apt import cutter_note, cutter_taken, of_cl_file, read_cl_file
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .advice import add_advice
from .avoided import check_keep_off
from .collision_avoidance import (
    check_for_gouges,
    compute_allowed_rest,
    compute_unfinished_share,
    cutting,
    divide_unfinished,
    enters_table,
    find_rest_of_program,
    rest_material_findings,
)
from .context import Box, MillContext, PostContext
from .driving import drive, post_path
from .fewer_axes import suit_tool_axis
from .in_machine import check_bodies, look_in_machine, over_tip
from .mill_context import mill_context
from .milling import Seen, mill
from .options import (
    cl_reading,
    compute_driven_to_hub,
    compute_driven_to_surface,
    machine_of,
    post_options,
    rapids_of,
    resolve_setup,
    search_folders,
    tip_to_driven,
    title_of,
    tool_body,
    with_cutter,
    with_head,
)
from .over_table import table_looked_at
from .part_size import unit_suspected
from .programs import MilledProgram, MillSource, PostedProgram, ProgramDraft, Result
from .rotary_axis import settle_rotary_axis
from .safe_start import add_safe_start
from .settings import AUDIT, MILL, POST, Settings, flat_options, is_part, name_units
from .settle_findings import still_true
from .start_plane import find_written_plane
from .stl_files import read_job_fixtures, read_mesh


def run(settings: Settings, progress: Progress = silent, mesh: Mesh | None = None) -> Result:
    """Do the task that the settings name. ``mesh``: the part, where it is at hand and ``settings.source``
    only its name. Raises FiveAxisError for input that cannot be used; writes nothing."""
    result = prove(make(settings, progress, mesh), progress)
    draft = result.draft
    if settings.output.advise == "off" or not isinstance(draft, MilledProgram):
        return result
    return add_advice(
        result, lambda other: prove(make(other, progress, draft.mesh, fixtures=draft.fixtures), progress)
    )


def make(
    settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None,
    fixtures: tuple[Fixture, ...] | None = None, seen: Seen | None = None,
) -> ProgramDraft:  # fmt: skip
    """Return the program, not yet proven. ``mesh``: what to mill, where it is at hand and ``settings.source``
    only its name; facets of it with an allowance are those to avoid; ``faces`` (f,): the facets of it that
    are to be cut, None: all; ``fixtures``: where they are at hand and the settings only name them;
    ``seen``: gets what the stages of ``mill`` make. Raises FiveAxisError for input that cannot be used."""
    settings = suit_tool_axis(settings, load_machine(settings.machine.machine))
    machine, kinematics, dialect = machine_of(settings)
    check_bodies(settings, machine)
    fixtures = read_job_fixtures(settings, progress) if fixtures is None else fixtures
    if settings.task in (MILL, POST):
        dialect = _configure_dialect(settings, machine, dialect)
    if settings.task == MILL:
        mesh = read_mesh(settings, settings.source, progress) if mesh is None else mesh
        given = MillSource(settings, mesh, faces, fixtures)
        context, reports = begin_mill(settings, machine, kinematics, dialect, given, progress)
        if seen is not None:
            seen(context, reports)
        milled = mill(context, seen)
        return replace(milled, findings=reports + milled.findings, fixtures=fixtures, given=given)
    if settings.task == POST:
        return post(settings, machine, kinematics, dialect, progress, fixtures)
    text = read_bytes(settings.source, "NC file")
    dialect, found = (dialect, ()) if settings.machine.controller else dialect_of_text(text, dialect)
    assumed = Assumed(
        settings.reading.units,
        settings.reading.decimal,
        machine.no_motion,
        search_folders(settings, settings.source),
    )
    with naming_file(settings.source):
        reading = read_in_order(text, kinematics, dialect, progress, assumed)
    program = reading.program
    settings, named = _with_named_cutter(settings, text)
    found += (
        named
        + spindle_findings(text, reading)
        + length_findings(text, reading, dialect)
        + end_findings(text, reading, dialect)
        + unit_findings(text, kinematics, program)
        + large_feeds(program, dialect)
    )
    return ProgramDraft(
        settings, machine, kinematics, dialect, program, found + program.findings, fixtures=fixtures,
        assumed=assume_length(reading, dialect),
    )  # fmt: skip


def begin_mill(
    settings: Settings, machine: Machine, kinematics: Chain, dialect: Dialect, given: MillSource,
    progress: Progress = silent,
) -> tuple[MillContext, tuple[Finding, ...]]:  # fmt: skip
    """Return what the stages of ``mill`` work in, and what there is to say of the facets. Raises
    FiveAxisError for input that cannot be used."""
    find_strategy(settings.tool_axis.tool_axis)
    find_pass_strategy(settings.passes.passes)
    mesh, faces, avoided, reports = choose_facets(settings, given.mesh, given.faces, progress)
    settings = settle_rotary_axis(settings, kinematics, mesh)
    try:
        context, left_out = mill_context(
            settings, mesh, machine, kinematics, dialect, progress, faces, given.fixtures, avoided
        )
    except ReachError as error:
        for one in report_in_part(mesh, given.fixtures):  # which is why, and the remedy another
            raise ReachError(one.text, error.value) from error
        raise
    return context, reports + mesh.findings + unit_suspected(mesh, settings.cutter.cutter) + left_out


def _with_named_cutter(settings: Settings, text: bytes) -> tuple[Settings, tuple[Finding, ...]]:
    """Return the settings with the cutter that an NC program names where they have none of their own, and a
    note of that."""
    cutter = find_named_cutter(text)
    taken = with_cutter(settings, cutter)
    return taken, () if taken is settings or cutter is None else note_named_cutter(cutter)


class ChosenFaces(NamedTuple):
    """``mesh``: the part, whose facets have no allowance; ``faces`` (f,): the facets to cut, None: all;
    ``avoided`` (f,): those on faces to avoid, None: there are no such faces."""

    mesh: Mesh
    faces: Bools | None
    avoided: Bools | None
    findings: tuple[Finding, ...]


def choose_facets(settings: Settings, mesh: Mesh, faces: Bools | None, progress: Progress) -> ChosenFaces:
    """Find the facets to cut: those chosen already, else those on the faces that the settings name; without
    those on faces to be avoided. Where these are known already they have an allowance, and are not among the
    ``faces``. Raises FiveAxisError."""
    chosen = settings.faces
    avoided = None if mesh.allowance is None else mesh.allowance > 0.0
    mesh = mesh if avoided is None else replace(mesh, allowance=None)
    reports: tuple[Finding, ...] = ()
    if faces is None and chosen.faces is not None:
        faces, reports = _facets_in(settings, mesh, chosen.faces, progress)
    if chosen.avoid is None:
        return ChosenFaces(mesh, faces, avoided, reports)
    avoided, also = _facets_in(settings, mesh, chosen.avoid, progress, machined=False)
    left = ~avoided if faces is None else faces & ~avoided
    if not left.any():
        text = say(
            "all that is to be machined lies on {name}; leave out {option}",
            name=Path(chosen.avoid).name,
            option=Option("avoid"),
        )
        raise SettingsError(text, chosen.avoid)
    return ChosenFaces(mesh, left, avoided, (*reports, *also))


def _facets_in(
    settings: Settings, mesh: Mesh, name: str, progress: Progress, machined: bool = True
) -> tuple[Bools, tuple[Finding, ...]]:
    """Return the facets on the faces of a file, and how many those are."""
    found = read_mesh(settings, name, progress)
    return facets_on(mesh, found, settings.proof.tolerance, Path(name).name, progress, machined)


def _configure_dialect(settings: Settings, machine: Machine, dialect: Dialect) -> Dialect:
    """Return the dialect as it is to be written: safe start, high-speed mode, tip guided. Raises
    SettingsError, before the long work, for what the controller has not, and for a head that cannot be
    written."""
    dialect = add_safe_start(dialect, machine)
    dialect = dialect.fast() if settings.head.high_speed == "on" else dialect
    dialect = dialect if settings.head.rtcp == "off" else dialect.guide_by(settings.head.rtcp)
    slot_texts(dialect, "", post_options(settings), inverse_time=False)
    return dialect


def post(
    settings: Settings, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress = silent,
    fixtures: tuple[Fixture, ...] = (),
) -> PostedProgram:  # fmt: skip
    """From a CL file (APT) to a program. The part is not known: rapids that are added stay off the box of the
    feed moves and the fixtures."""
    with naming_file(settings.source):
        file = read_cl_file(read_bytes(settings.source, "CL file"), cl_reading(settings), progress)
    given, path = settings, file.path
    settings = with_head(given, file.head)
    box, cuts = box_with(_box_of_moves(path, Motion.RAPID), fixtures), _box_of_moves(path, Motion.LINK)
    context = PostContext(settings, machine, kinematics, dialect, box, progress, cuts, fixtures)
    taken = settings.cutter is not given.cutter
    found = path.findings + (
        cutter_taken(settings.cutter.cutter) if taken else cutter_note(file.head, settings.cutter.cutter)
    )
    return replace(post_path(context, path, drive(context, path), found), fixtures=fixtures)


def _box_of_moves(path: CLPath, first_left_out: Motion) -> Box:
    """Find the box of the tips of all moves but those from ``first_left_out`` on; of all where none is
    left."""
    kept = path.motion < first_left_out
    tip = path.tip[kept] if kept.any() else path.tip
    return tip.min(axis=0), tip.max(axis=0)


def prove(draft: ProgramDraft, progress: Progress = silent, part: Mesh | None = None) -> Result:
    """Return the deviation of every block of a program, its proven bound, and the blocks near the pole.
    Judged is the deviation of the point that makes the surface: of a ball the centre. ``part``: what an audit
    compares with, where it is at hand and ``settings.audit.against`` only its name.

    Where the controller guides the tip there is nothing to measure, and nothing is proven but the blocks'
    ends.
    """
    against, settings = _read_reference(draft.settings, progress) if part is None else (part, draft.settings)
    draft = draft if settings is draft.settings else replace(draft, settings=settings)
    proof, words = settings.proof, draft.program.words
    deviation = measure(draft.kinematics, words, proof.method, progress)
    if (guided := draft.program.guided) is not None:
        deviation = without_guided(deviation, guided.on, guided.tip)
    singularity = find_singular(draft.kinematics, words, draft.machine.singular_cone)
    surface = surface_deviation(draft, compute_driven_to_surface(draft.settings), progress)
    if (unknown := draft.program.unknown_way) is not None:
        tip = forward(draft.kinematics, words_to_q(words))[0]
        deviation, singularity = without_guided(deviation, unknown, tip), singularity.without(unknown)
        surface = surface and without_guided(surface, unknown, tip)
    judged = judge(
        draft.kinematics,
        draft.program,
        surface or deviation,
        singularity,
        proof.tolerance,
        surface is not None,
        find_programmed_feed(draft),
    )
    reference = draft.mesh if isinstance(draft, MilledProgram) else against
    apart = tuple(report_in_part(reference, draft.fixtures)) if isinstance(reference, Mesh) else ()
    gouge, rest, entries = _against_part(draft, progress)
    entries += (
        check_keep_off(draft.context(progress), draft.program) if isinstance(draft, MilledProgram) else ()
    )
    solid = reference if isinstance(reference, Mesh) else None
    apart += report_placing(draft.machine, resolve_setup(settings, draft.machine)[1], solid, draft.fixtures)
    hit = _in_fixtures(draft, progress) + look_in_machine(draft, against, progress)
    found = (
        apart + still_true(draft.findings, gouge, rest, entries) + deviation.findings + entries + hit + judged
    )
    if draft.settings.task != AUDIT:
        return Result(draft, deviation, singularity, found, gouge=gouge, rest=rest, surface=surface)
    audited = _audit_draft(draft, deviation, against, progress)
    of_path = tuple(of_cl_file(one) for one in against.findings) if isinstance(against, CLPath) else ()
    return Result(draft, deviation, singularity, found + of_path + audited.findings, audited, surface=surface)


def find_programmed_feed(draft: ProgramDraft) -> Floats | None:
    """Return how fast the tip was to go over the part in each block (m,), mm/min; of a program that was not
    made here as it mostly goes, None where that is not known."""
    if not isinstance(draft, PostedProgram):
        return assume_programmed_feed(draft.kinematics, draft.program)
    return draft.joints.path.feed.take(np.maximum(draft.program.row, 0))


def surface_deviation(draft: ProgramDraft, above: float, progress: Progress = silent) -> Deviation | None:
    """Return the deviation of the point ``above`` mm over the driven one, against its own chords; ``place``
    (m, 3) mm: where the driven point stands then. None where it is the driven point itself, and where the
    controller guides the tip."""
    program = draft.program
    if above == 0.0 or program.guided is not None:
        return None
    dialect, method = draft.dialect, draft.settings.proof.method
    return measure_above(
        draft.kinematics, program.words, above, dialect.linear_decimals, method, progress, dialect.unit
    )


def _audit_draft(
    draft: ProgramDraft, deviation: Deviation, against: CLPath | Mesh | None, progress: Progress
) -> Audit:
    """Limits and rates (of a program made here they hold by its making), and the comparison that the settings
    ask for."""
    settings, proof = draft.settings, draft.settings.proof
    gouge = settings.gouge
    body = tool_body(settings) if gouge.gouge != "off" or gouge.shank or gouge.holder else None
    above = compute_driven_to_surface(settings)
    rapids = rapids_of(settings, draft.machine, draft.dialect)
    options = AuditOptions(
        proof.tolerance, settings.audit.axis_tolerance, settings.cutter.cutter, body, above, rapids,
        draft.dialect.inverse_time,
    )  # fmt: skip
    return audit_program(draft.kinematics, draft.program, deviation, against, options, progress)


def _read_reference(settings: Settings, progress: Progress) -> tuple[CLPath | Mesh | None, Settings]:
    """Return the CL path or the part that a program is audited against, and the settings with the cutter of a
    CL file where they have none of their own. Raises FiveAxisError where it cannot be read."""
    path = settings.audit.against
    if settings.task != AUDIT or path is None:
        return None, settings
    if is_part(path):
        return read_mesh(settings, path, progress), settings
    with naming_file(path):
        file = read_cl_file(read_bytes(path, "CL file"), cl_reading(settings), progress)
    return file.path, with_cutter(settings, file.head.cutter)


def _against_part(
    draft: ProgramDraft, progress: Progress
) -> tuple[GougeCheck | None, RestMaterial | None, tuple[Finding, ...]]:
    """Return what enters the part, the rest material on it, and what is to be said of both; of a program made
    from a mesh."""
    if not isinstance(draft, MilledProgram):
        return None, None, ()
    context, program = draft.context(progress), draft.program
    gouge, low = check_for_gouges(context, program), enters_table(context, program)
    rest = (
        find_rest_of_program(context, program)
        if draft.settings.gouge.rest == "on" and len(cutting(program.motion))
        else None
    )
    left = rest_material_findings(rest, context, draft.findings)
    return gouge, rest, (gouge.findings if gouge else ()) + low + left


def _in_fixtures(draft: ProgramDraft, progress: Progress) -> tuple[Finding, ...]:
    """Return what of tool and spindle goes into a fixture."""
    settings, back = draft.settings, tip_to_driven(draft.settings)
    rapids, tolerance = rapids_of(settings, draft.machine, draft.dialect), settings.proof.tolerance
    body = over_tip(draft)
    near = settings.gouge.fixture_clearance
    return check_fixtures(
        draft.fixtures, body, draft.kinematics, draft.program, tolerance, back, progress, rapids, near
    )


def rest_material_of(draft: MilledProgram, progress: Progress = silent) -> RestMaterial:
    """Return what the cutter leaves on the machined facets on its real way. Raises SettingsError where no
    block cuts."""
    return find_rest_of_program(draft.context(progress), draft.program)


def _contacts(draft: MilledProgram) -> Contacts | None:
    """Where the ball touches the part; None for any other cutter."""
    cutter, offset = draft.settings.cutter.cutter, draft.offset
    if not cutter.touches_as_ball:
        return None
    above = compute_driven_to_hub(draft.settings)
    return contacts_of(
        offset.centre, offset.normal, draft.axis, offset.face, draft.mesh, cutter.corner, above
    )


def _stand(draft: MilledProgram, contacts: Contacts | None) -> float:
    """How far from the part what is drawn of a cut may stand, mm; with ``contacts`` it is drawn where the
    ball touches."""
    cutter, offset = draft.settings.cutter.cutter, draft.offset
    if contacts is not None:
        return 0.0
    return tip_to_driven(draft.settings) + stand_of(cutter, offset.normal, draft.axis)


def figures(result: Result) -> Figures:
    """Return what the report is made from."""
    draft = result.draft
    contacts = _contacts(draft) if isinstance(draft, MilledProgram) else None
    return Figures(
        title=title_of(draft.settings), kind=draft.settings.task, machine=draft.machine,
        kinematics=draft.kinematics,
        program=draft.program, deviation=result.deviation, singularity=result.singularity,
        tolerance=draft.settings.proof.tolerance, findings=result.findings,
        inputs=flat_options(draft.settings), units=name_units(draft.settings),
        surface=result.surface, programmed_feed=find_programmed_feed(draft),
        audit=result.audit, gouge=result.gouge, rest=result.rest,
        allowed=compute_allowed_rest(draft.settings, draft.mesh, draft.keep)
        if result.rest and isinstance(draft, MilledProgram) else 0.0,
        mesh=draft.mesh if isinstance(draft, MilledProgram) else None,
        unfinished=compute_unfinished_share(result.findings, draft.mesh, draft.keep)
        if isinstance(draft, MilledProgram) else 0.0,
        unfinished_parts=divide_unfinished(
            result.findings, draft.mesh, draft.keep, result.rest is not None
        )
        if isinstance(draft, MilledProgram) else None,
        contacts=contacts, stand=_stand(draft, contacts) if isinstance(draft, MilledProgram) else 0.0,
        rapids=rapids_of(draft.settings, draft.machine, draft.dialect),
        table=table_looked_at(draft.settings, draft.machine, draft.mesh) if isinstance(draft,
            MilledProgram) else None,
        fixtures=tuple(one.name for one in draft.fixtures),
        above=draft.plane.above if isinstance(draft, PostedProgram) else None,
        plane=find_written_plane(draft.machine, draft.dialect, draft.plane)
        if isinstance(draft, PostedProgram) else None,
        assumed=draft.assumed,
    )  # fmt: skip
