# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every input of a job, as one tree of frozen dataclasses.

The tree is the only place where settings are gathered: the command line, job files, reports and the
workbench's properties are made from its fields, which :mod:`.groups` lists.

option    the flat name of a field: ``least_interval`` in job files, ``--least-interval`` on the command line.
"""

from __future__ import annotations

import dataclasses
import difflib
import math
from collections.abc import Iterator, Mapping
from copy import copy
from dataclasses import dataclass, field, fields, replace
from typing import Any

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Option, Task, say
from freecad_fiveaxis.core.pipeline.option_values import SHOWN_UNITS, read_option, read_text, write_option

from .groups import (
    AuditSettings,
    BoundarySettings,
    CompareSettings,
    CureSettings,
    CutterSettings,
    FacesSettings,
    FeedSettings,
    GougeSettings,
    HeadSettings,
    LinkSettings,
    MachineSettings,
    OutputSettings,
    PassSettings,
    ProofSettings,
    ProveSettings,
    ReadingSettings,
    RecoverSettings,
    SetupSettings,
    ToolAxisSettings,
)
from .option import AUDIT, COMPARE, MILL, POST, RECOVER, RENAMED, SETUP, TASKS, WITHOUT_SOURCE

SHORTEST = 1e-9
"""Length of a vector whose direction is lost in rounding."""
FRAMES = "frames"
"""The passes that choose their own tool axes."""
ROTARY, FROM_AXIS = "rotary", "from_axis"
"""The passes about a rotary axis, and the tool axis that points at it."""
OF_PLANES = ("direction", "plane_normal")
"""Options that mean nothing to any other passes."""
STEEP = "zlevel"
"""The pass strategy of what is steep, where the others are divided from it."""
BY_FACET = "scallop"
"""The passes whose spacing follows how a cutter that is no ball stands on each facet; others take one for
all."""

OVER_SURFACE = ("frames", "morph", "radial", "rotary", "scallop")
"""Pass strategies whose passes lie over walls as over floors; their own attribute says so too, but to ask it
loads numpy."""


def flat_name(name: str) -> str:
    """Return the option of a field: ``from_``, which Python keeps for itself, is ``from``."""
    return name.rstrip("_")


def group(cls: type) -> Any:
    """Return a field that is a settings dataclass of its own."""
    return field(default_factory=cls, metadata={"group": cls})


@dataclass(frozen=True)
class Settings:
    """Every input of a job. ``source``: the STL, CL or NC file that the task reads; ``explicit``: the options
    given, the others have their defaults."""

    task: str = MILL
    source: str = ""
    machine: MachineSettings = group(MachineSettings)
    cutter: CutterSettings = group(CutterSettings)
    faces: FacesSettings = group(FacesSettings)
    passes: PassSettings = group(PassSettings)
    boundary: BoundarySettings = group(BoundarySettings)
    tool_axis: ToolAxisSettings = group(ToolAxisSettings)
    links: LinkSettings = group(LinkSettings)
    feeds: FeedSettings = group(FeedSettings)
    head: HeadSettings = group(HeadSettings)
    cure: CureSettings = group(CureSettings)
    gouge: GougeSettings = group(GougeSettings)
    proof: ProofSettings = group(ProofSettings)
    setup: SetupSettings = group(SetupSettings)
    compare: CompareSettings = group(CompareSettings)
    recover: RecoverSettings = group(RecoverSettings)
    prove: ProveSettings = group(ProveSettings)
    reading: ReadingSettings = group(ReadingSettings)
    audit: AuditSettings = group(AuditSettings)
    output: OutputSettings = group(OutputSettings)
    explicit: frozenset[str] = field(default=frozenset(), compare=False, repr=False)


def option_fields(task: str | None = None) -> Iterator[tuple[type, dataclasses.Field[Any]]]:
    """Every option with the group that it belongs to, in order; of one task with the defaults there, or of
    all."""
    for top in fields(Settings):
        if "group" in top.metadata:
            for leaf in fields(top.metadata["group"]):
                if task is None or task in leaf.metadata["tasks"]:
                    yield top.metadata["group"], _in_task(leaf, task)


def _in_task(leaf: dataclasses.Field[Any], task: str | None) -> dataclasses.Field[Any]:
    """Return the field with the default that it has in the task."""
    own = leaf.metadata["by_task"]
    if task not in own:
        return leaf
    built = copy(leaf)
    built.default = own[task]
    return built


def build_settings(task: str, source: str, options: Mapping[str, Any]) -> Settings:
    """Return settings from flat options as people write them (job files, command line).

    Raises SettingsError for an unknown option, a value out of range, or a contradiction.
    """
    if task not in WITHOUT_SOURCE:
        read_text(source, "source")
    options = with_current_names(options)
    known = {flat_name(leaf.name) for _, leaf in option_fields(task)}
    for name in options:
        if flat_name(name) not in known:
            close = difflib.get_close_matches(name, known, 1)
            raise SettingsError(
                say("unknown option {name} for {task}", name=repr(name), task=task)
                + (say("; do you mean {close}?", close=repr(close[0])) if close else ""),
                name,
            )
    given = {flat_name(name): value for name, value in options.items() if value is not None}
    groups = {
        top.name: _build(top.metadata["group"], task, given)
        for top in fields(Settings)
        if "group" in top.metadata
    }
    settings = _with_defaults(Settings(task=task, source=source, explicit=frozenset(given), **groups), given)
    check_together(settings)
    return settings


def with_current_names(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options under their names of today, where a former name (``left``) is given. Raises
    SettingsError for one that is given under both."""
    for old, name in RENAMED.items():
        if options.get(old) is not None and options.get(name) is not None:
            raise SettingsError(
                say("{old} is the former name of {name}; give {name} alone", old=old, name=name), old
            )
    return {
        RENAMED.get(name, name): value
        for name, value in options.items()
        if name not in RENAMED or value is not None
    }


def _with_strategies(settings: Settings, given: Mapping[str, Any]) -> Settings:
    """Return the pass strategy and the tool axis chosen by the other options, where they are not ``given``.

    Whoever asks for what only planes have gets planes; and planes, level ones too, stand as in Lin & Ye, on
    the normals. So do cutters without a ball end, whose passes are as far apart as the bottom is wide there;
    a level bottom lies on plane faces up to their edges.
    """
    if "passes" not in given and any(name in given for name in OF_PLANES):
        settings = replace(settings, passes=replace(settings.passes, passes="planes"))
    for option, passes in (("frames", FRAMES), ("within_frames", FRAMES), ("rotary_by", ROTARY)):
        if "passes" not in given and option in given:
            settings = replace(settings, passes=replace(settings.passes, passes=passes))
    if settings.passes.passes == FRAMES:
        return settings
    if "tool_axis" not in given and settings.passes.passes == ROTARY:
        return replace(settings, tool_axis=replace(settings.tool_axis, tool_axis=FROM_AXIS))
    cutter = settings.cutter.cutter
    if "tool_axis" not in given and (
        settings.passes.passes not in OVER_SURFACE or not cutter.touches_as_ball
    ):
        strategy = "face_normal" if cutter.has_level_bottom else "facet_mean"
        settings = replace(settings, tool_axis=replace(settings.tool_axis, tool_axis=strategy))
    return settings


def _with_defaults(settings: Settings, given: Mapping[str, Any]) -> Settings:
    """Return what was not asked for, where its default depends on what was: a guided tip is not divided, no
    part is not looked at."""
    settings = _with_strategies(settings, given)
    if settings.head.rtcp != "off" and "linearize" not in given:
        settings = replace(settings, cure=replace(settings.cure, linearize="off"))
    if settings.task == AUDIT and "gouge" not in given and not is_part(settings.audit.against or ""):
        settings = replace(settings, gouge=replace(settings.gouge, gouge="off"))
    return settings


def _build(cls: type, task: str, given: Mapping[str, Any]) -> Any:
    leaves = [_in_task(leaf, task) for leaf in fields(cls)]
    names = {leaf.name: flat_name(leaf.name) for leaf in leaves}
    return cls(
        **{
            leaf.name: read_option(leaf, given[at]) if (at := names[leaf.name]) in given else leaf.default
            for leaf in leaves
        }
    )


def _check_reading(settings: Settings) -> None:
    """Check that a part is not asked for what only a CL file has."""
    if settings.task not in (SETUP, COMPARE) or not is_part(settings.source):
        return
    for name, value in (("units", settings.reading.units), ("cl_tool", settings.reading.cl_tool)):
        if value not in ("file", None):
            raise SettingsError(
                say(
                    "{option} is of a CL file, {source} is a part; leave it out",
                    option=Option(name),
                    source=settings.source,
                ),
                value,
            )


def check_together(settings: Settings) -> None:
    """Refuse settings that exclude each other. Raises SettingsError."""
    for check in (
        _check_named,
        _check_spacing,
        _check_deform,
        _check_guided,
        _check_steep,
        _check_gouge,
        _check_faces,
        _check_boundary,
        _check_reading,
        _check_frames,
        _check_tool_axis,
        _check_barrel,
    ):
        check(settings)


def _check_named(settings: Settings) -> None:
    """Check that a task is known and has the machine, the machines or the program that it works with."""
    task, machines = settings.task, Task("machines")
    if task not in TASKS:
        raise SettingsError(
            say("unknown task {task}; known: {tasks}", task=repr(task), tasks=", ".join(TASKS)), task
        )
    if task == COMPARE and not settings.compare.machines:
        text = say(
            "no machines given; name them with {machines} ({list} shows them)",
            machines=Option("machines", given="A,B"),
            list=machines,
        )
        raise SettingsError(text, ())
    if task not in (COMPARE, RECOVER) and not settings.machine.machine:
        text = say(
            "no machine given; name one with {machine} ({list} shows them)",
            machine=Option("machine"),
            list=machines,
        )
        raise SettingsError(text, "")
    if task == RECOVER and not settings.recover.program:
        raise SettingsError(say("no program given; name the NC file that was posted from the CL path"), "")


def _check_spacing(settings: Settings) -> None:
    passes = settings.passes
    if passes.scallop is not None and passes.stepover is not None:
        raise SettingsError(say("scallop and stepover exclude each other; give one of them"), passes.stepover)


def _check_deform(settings: Settings) -> None:
    if settings.task == POST and settings.cure.singularity == "deform":
        text = say(
            "{past} needs the part's passes: use it with {mill}; a CL file keeps its axes",
            past=Choice("singularity", ("deform",)),
            mill=Task("mill"),
        )
        raise SettingsError(text, "deform")


def _check_guided(settings: Settings) -> None:
    cure = settings.cure
    if settings.head.rtcp != "off" and (cure.linearize == "on" or cure.singularity == "linearize"):
        text = say(
            "{rtcp} lets the controller guide the tip, {linearize} divides blocks where it does not; "
            "give one",
            rtcp=Option("rtcp", flag=False),
            linearize=Option("linearize", flag=False),
        )
        raise SettingsError(text, "rtcp")


def _check_faces(settings: Settings) -> None:
    faces = settings.faces.faces or settings.faces.avoid
    if faces and settings.task != MILL and not is_part(settings.source):
        text = say("faces need the part (.stl), {source} is none; leave faces out", source=settings.source)
        raise SettingsError(text, faces)


def _check_boundary(settings: Settings) -> None:
    bounds = settings.boundary
    if bounds.boundary and settings.task != MILL and not is_part(settings.source):
        text = say(
            "{option} needs the part (.stl), {source} is none; leave it out",
            option=Option("boundary"),
            source=settings.source,
        )
        raise SettingsError(text, bounds.boundary)
    if math.hypot(*bounds.boundary_axis) < SHORTEST:
        given = ",".join(f"{number:g}" for number in bounds.boundary_axis)
        text = say(
            "{option} {given} has no direction; give I,J,K along which the boundary is seen, as 0,0,1",
            option=Option("boundary_axis"), given=given,
        )  # fmt: skip
        raise SettingsError(text, bounds.boundary_axis)


def _check_steep(settings: Settings) -> None:
    """Level planes are not divided from themselves, frames divide the part by themselves, and what turns has
    no level walls."""
    passes = settings.passes.passes
    if settings.passes.steep_shallow is None or passes not in (STEEP, FRAMES, ROTARY):
        return
    option, given = Option("steep_shallow"), Choice("passes", (passes,))
    if passes == STEEP:
        text = say(
            "{option} divides level planes from other passes, but {passes} are level planes all over; leave "
            "one of them out",
            option=option, passes=given,
        )  # fmt: skip
    else:
        text = say(
            "{option} does not go together with {passes}; leave one of them out", option=option, passes=given
        )
    raise SettingsError(text, passes)


def _check_frames(settings: Settings) -> None:
    """Locked rotary axes leave no choice of tool axes, nor one from contact to contact."""
    if settings.passes.passes != FRAMES:
        return
    tool, frames = settings.tool_axis, Choice("passes", (FRAMES,))
    refused = (
        ("tool_axis", tool.tool_axis != "auto", tool.tool_axis), ("lead", tool.lead != 0.0, tool.lead),
        ("tilt", tool.tilt != 0.0, tool.tilt),
    )  # fmt: skip
    for name, against, value in refused:
        if against:
            text = say(
                "{frames} lock the rotary axes and choose the tool axes themselves; leave {option} out",
                frames=frames,
                option=Option(name),
            )  # fmt: skip
            raise SettingsError(text, value)
    for name, value in (("gouge", settings.gouge.gouge), ("singularity", settings.cure.singularity)):
        if value in ("tilt", "deform"):
            text = say(
                "{frames} lock the rotary axes, {choice} turns them; choose another", frames=frames,
                choice=Choice(name, (value,)),
            )  # fmt: skip
            raise SettingsError(text, value)


def _check_tool_axis(settings: Settings) -> None:
    tool = settings.tool_axis
    if tool.tool_axis == "fixed" and math.hypot(*tool.axis) < SHORTEST:
        given = ",".join(f"{number:g}" for number in tool.axis)
        raise SettingsError(
            say("axis {given} has no direction; give I,J,K of the fixed tool axis, as 0,0,1", given=given),
            tool.axis,
        )
    for name in ("lead", "tilt"):
        lean = math.degrees(getattr(tool, name))
        if tool.tool_axis == "minimax" and lean != 0.0:
            raise SettingsError(
                say(
                    "{name} {lean} leaves {minimax} no choice; leave it out, or choose {facet_mean}",
                    name=Option(name, flag=False),
                    lean=Angle(lean),
                    minimax=Choice("tool_axis", ("minimax",), alone=True),
                    facet_mean=Choice("tool_axis", ("facet_mean",), alone=True),
                ),
                lean,
            )


def _check_barrel(settings: Settings) -> None:
    """Refuse minimax with a barrel: it lets the axis lean as the machine likes, and with that another place
    of the arc cuts."""
    if settings.cutter.cutter.barrel is not None and settings.tool_axis.tool_axis == "minimax":
        raise SettingsError(
            say(
                "{minimax} would lean a barrel off its flank; choose {facet_mean}, or a ball cutter",
                minimax=Choice("tool_axis", ("minimax",), alone=True),
                facet_mean=Choice("tool_axis", ("facet_mean",), alone=True),
            ),
            "minimax",
        )


def _check_gouge(settings: Settings) -> None:
    """Check that an audit changes nothing, and knows no part but the one that it is given. Shank and holder
    are looked at beside fixtures and the machine's bodies too."""
    gouge, against = settings.gouge, settings.audit.against
    if settings.task != AUDIT or (
        gouge.gouge == "off" and (gouge.fixture or (not gouge.shank and not gouge.holder))
    ):
        return
    if gouge.gouge not in ("off", "report"):
        raise SettingsError(
            say(
                "{gouge} changes the passes: use it with {mill}; for an audit give {report}",
                gouge=Choice("gouge", (gouge.gouge,)),
                mill=Task("mill"),
                report=Choice("gouge", ("report",), alone=True),
            ),
            gouge.gouge,
        )
    own = (
        (settings.machine.machine or "").lower().endswith(".fcm")
    )  # its file may name bodies, which are looked at too
    if (against is None or not is_part(against)) and not (own and gouge.gouge == "off"):
        raise without_part(against)


def without_part(against: str | None) -> SettingsError:
    """Say that shank and holder have nothing to be looked at against."""
    text = say(
        "gouge, shank and holder need the part or a fixture: give its STL with {against} or {fixture}",
        against=Option("against"),
        fixture=Option("fixture"),
    )  # fmt: skip
    return SettingsError(text, against)


def flat_options(settings: Settings) -> dict[str, Any]:
    """Return the options that the task uses, as a job file would hold them (degrees, mm), defaults
    included."""
    values = {}
    for cls, leaf in option_fields(settings.task):
        holder = next(
            getattr(settings, top.name) for top in fields(Settings) if top.metadata.get("group") is cls
        )
        values[flat_name(leaf.name)] = write_option(leaf, getattr(holder, leaf.name))
    return {"task": settings.task, "source": settings.source, **values}


def name_units(settings: Settings) -> dict[str, str]:
    """Return the units of :func:`flat_options`; none of an option that has none."""
    kinds = {flat_name(leaf.name): leaf.metadata["kind"] for _, leaf in option_fields(settings.task)}
    return {name: SHOWN_UNITS[kind] for name, kind in kinds.items() if kind in SHOWN_UNITS}


def is_part(against: str) -> bool:
    """Whether the file that a program is compared with is a part (.stl); any other is a CL file."""
    return against.lower().endswith(".stl")
