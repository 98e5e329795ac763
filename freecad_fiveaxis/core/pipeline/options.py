# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the settings ask for, in the terms of the packages: machine and dialect, options, distances, titles.

hub       the middle of the cutter's corner circles (of a ball: its centre), one corner radius above the tip.
driven    the point that the words of the program move: tip or hub.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Option, one_line, say
from freecad_fiveaxis.core.controllers import Dialect, find_dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.lift import AIM
from freecad_fiveaxis.core.gouge.machine_in_pose import MachineInPose
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.links.lead_in import LeadOptions
from freecad_fiveaxis.core.machine import Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain
from freecad_fiveaxis.core.nc.head import PostOptions
from freecad_fiveaxis.core.nc.named_cutter import CENTRE
from freecad_fiveaxis.core.orientation.axis_corrections import AxisCorrectionOptions
from freecad_fiveaxis.core.orientation.strategies import FOLLOWING, AxisOptions
from freecad_fiveaxis.core.passes import PassOptions, find_pass_strategy, with_room
from freecad_fiveaxis.core.tool import Cutter, cutter_name
from freecad_fiveaxis.core.tool.body import Body, body_of
from freecad_fiveaxis.core.toolpath.apt import ARC_SHARE, ClHead, ClReading

from .context import MillContext
from .fewer_axes import refuse_what_needs_more_axes
from .over_table import largest_axis_angle, table_below
from .settings import COMPARE, MILL, POST, SETUP, Settings
from .settings.groups import AS_MACHINE
from .settings.tree import STEEP

DEFAULT_CONTROLLER = "linuxcnc"
DEFAULT_SCALLOP = 0.01
"""mm, where neither a scallop nor a stepover is asked for: a usual finishing quality."""

UPRIGHT = (0.0, 0.0, 1.0)
"""The axis of passes where none is asked for, and none belongs to the machine."""


WRITTEN = (MILL, POST, SETUP, COMPARE)
"""Tasks that write a program, or judge one that would be written; others read them."""


def machine_of(settings: Settings) -> tuple[Machine, Chain, Dialect]:
    """Return the machine, its chain with the part where it stands, and its dialect. Raises FiveAxisError."""
    machine, setup, dialect = load_setup(settings)
    return machine, chain(machine, setup), dialect


def search_folders(settings: Settings, program: str) -> tuple[str, ...]:
    """Return the folders in which the programs lie that ``program`` calls: its own, then those named. Raises
    SettingsError for one that is none."""
    for folder in settings.reading.search:
        if not Path(folder).is_dir():
            raise SettingsError(
                say(
                    "{search} {folder} is no folder; name one with the called programs",
                    search=Option("search"),
                    folder=folder,
                ),
                folder,
            )
    return (str(Path(program).parent), *settings.reading.search)


def dialect_for(controller: str | None, machine: Machine | None) -> Dialect:
    """Return the dialect of the controller that is named, else of the machine's own, else the usual one.
    Raises SettingsError."""
    return find_dialect(controller or (machine.controller if machine else "") or DEFAULT_CONTROLLER)


def rapids_of(settings: Settings, machine: Machine, dialect: Dialect) -> str:
    """How rapids are driven: as the option says, else the machine file, else the controller."""
    wanted = settings.machine.rapids
    return (machine.rapids or dialect.rapids) if wanted == AS_MACHINE else wanted


def load_setup(settings: Settings) -> tuple[Machine, Setup, Dialect]:
    """Return the machine, where the part stands on it, and its dialect."""
    machine = load_machine(settings.machine.machine)
    refuse_what_needs_more_axes(settings, machine)
    return resolve_setup(settings, machine)


def resolve_setup(settings: Settings, machine: Machine) -> tuple[Machine, Setup, Dialect]:
    """Return the same for a machine that is known, whatever is asked of its axes. Raises SettingsError
    without a head's tool length."""
    given = settings.machine
    dialect = dialect_for(given.controller, machine)
    if settings.task in WRITTEN:
        dialect = take_units(settings.head.nc_units, machine, dialect)
    if given.tool_length is None and machine.has_head:
        raise SettingsError(
            say(
                "machine {name} has a rotary head: give {tool_length}, gauge point to tip",
                name=machine.name,
                tool_length=Option("tool_length"),
            ),
            None,
        )
    length = given.tool_length or 0.0
    if given.control_point == "centre":
        length -= settings.cutter.cutter.corner
    return machine, Setup(machine.origin if given.origin is None else given.origin, length), dialect


def take_units(wanted: str, machine: Machine, dialect: Dialect) -> Dialect:
    """Return the dialect in the units that are ``wanted``; as the machine file says where that is left to it,
    and the controller has both. Raises SettingsError."""
    if wanted == AS_MACHINE:
        return dialect.in_inches() if machine.output_inch and dialect.inch else dialect
    return dialect.in_inches() if wanted == "inch" else dialect


def read_scallop(settings: Settings) -> float | None:
    """Return the scallop asked for, mm; None where a stepover is."""
    passes = settings.passes
    return DEFAULT_SCALLOP if passes.scallop is None and passes.stepover is None else passes.scallop


def steps_over_strips(settings: Settings) -> bool:
    """Tell whether passes are so far apart that strips between them are not touched: at least as far as the
    cutter is wide. A barrel cuts with more of its flank than that."""
    stepover, cutter = settings.passes.stepover, settings.cutter.cutter
    return stepover is not None and cutter.barrel is None and stepover >= cutter.diameter


def pass_options(settings: Settings) -> PassOptions:
    """Options of the strategies for the passes."""
    passes = settings.passes
    return PassOptions(
        passes.direction,
        passes.stepover,
        read_scallop(settings),
        passes.least_interval,
        passes.plane_normal,
        passes.from_,
        passes.to,
        passes.pass_centre,
        passes.pass_axis or UPRIGHT,
        passes.rotary_by,
        passes.within_frames,
    )


def travels(settings: Settings) -> tuple[float, ...]:
    """rad: directions of travel, seen from above, that stand for all of the passes."""
    names = [settings.passes.passes] + [STEEP] * (settings.passes.steep_shallow is not None)
    return tuple(
        dict.fromkeys(
            way for name in names for way in find_pass_strategy(name).travels(pass_options(settings))
        )
    )


def axis_options(settings: Settings) -> AxisOptions:
    """Options of the strategies for the tool axis. Where neither lead nor tilt is asked for, a barrel is
    tilted from the normals so far that the middle of its flank touches, to the side that is up."""
    tool, barrel = settings.tool_axis, settings.cutter.cutter.barrel
    centre, about = settings.passes.pass_centre, settings.passes.pass_axis or UPRIGHT
    through = (0.0, 0.0, 0.0) if isinstance(centre, str) else centre
    if barrel is not None and tool.lead == tool.tilt == 0.0 and tool.tool_axis in FOLLOWING:
        return AxisOptions(tool.axis, 0.0, barrel.middle, through, about, upwards=True)
    return AxisOptions(tool.axis, tool.lead, tool.tilt, through, about, ring=settings.cutter.cutter.ring)


def axis_corrections(context: MillContext) -> AxisCorrectionOptions:
    """Options of the corrections of tool axes."""
    settings = context.settings
    return AxisCorrectionOptions(
        compute_driven_to_hub(settings), settings.cutter.cutter.ring, settings.feeds.feed,
        settings.proof.tolerance, settings.tool_axis.max_tilt, settings.cure.max_axis_change,
        settings.cutter.cutter.barrel,
    )  # fmt: skip


def reacher_of(
    settings: Settings, machine: Machine, kinematics: Chain, mesh: Mesh, bodies: MachineInPose | None = None
) -> Reacher:
    """Tool, machine with room to its limits, table, and how far the axis may lean: what axes are chosen for
    freely. ``bodies``: of the machine, to keep out of."""
    tool, cutter, tolerance = settings.gouge, settings.cutter.cutter, settings.proof.tolerance
    table = table_below(settings, machine, mesh)
    within, most = with_room(kinematics), largest_axis_angle(settings, machine, mesh)
    return Reacher(cutter, tool.shank, tool.holder, within, tolerance, table, most, machine=bodies)


def reacher_in(context: MillContext) -> Reacher:
    """Return the same of a job's context."""
    reacher = reacher_of(context.settings, context.machine, context.kinematics, context.mesh, context.bodies)
    return replace(reacher, floors=context.floors)


def lead_options(context: MillContext) -> LeadOptions:
    """Options of the arcs on which passes are entered and left."""
    settings, tolerance = context.settings, context.settings.proof.tolerance
    driven, above = tip_to_driven(settings), tip_to_surface(settings)
    table = table_below(settings, context.machine, context.mesh)
    return LeadOptions(settings.links.lead_in, tolerance, AIM * tolerance, table, driven, above)


def tool_body(settings: Settings) -> Body:
    """Cutter, shank and holder."""
    return body_of(settings.cutter.cutter, settings.gouge.shank, settings.gouge.holder)


def choose_rapid_body(settings: Settings) -> Body:
    """Return what of the tool keeps off the part on rapids: all of it; of a path for which nothing is to be
    looked at (gouge ``off``) the cutter alone, so that shank and holder are only drawn."""
    only_cutter = settings.task == MILL and settings.gouge.gouge == "off"
    return body_of(settings.cutter.cutter) if only_cutter else tool_body(settings)


def compute_driven_to_hub(settings: Settings) -> float:
    """From the driven point to the hub (the ball's centre), mm."""
    return settings.cutter.cutter.corner if settings.machine.control_point == "tip" else 0.0


def tip_to_driven(settings: Settings) -> float:
    """How far above the tip the point lies that the words drive, mm."""
    return settings.cutter.cutter.corner - compute_driven_to_hub(settings)


def compute_driven_to_surface(settings: Settings) -> float:
    """How far above the driven point, mm, that point stands whose way makes the surface: of a ball that is
    known to cut its centre, of any other cutter, and where the controller guides the tip, the driven point
    itself."""
    known = settings.task == MILL or "cutter" in settings.explicit
    return (
        compute_driven_to_hub(settings)
        if known and settings.cutter.cutter.touches_as_ball and settings.head.rtcp == "off"
        else 0.0
    )


def tip_to_surface(settings: Settings) -> float:
    """Return the same from the tip, mm: the point so far above it goes straight."""
    return tip_to_driven(settings) + compute_driven_to_surface(settings)


def post_options(settings: Settings) -> PostOptions:
    """Return what the head of an NC file is to say."""
    head = settings.head
    tool = None if head.tool is None else int(head.tool)
    named, length = cutter_name(settings.cutter.cutter), settings.machine.tool_length
    named += CENTRE if settings.machine.control_point == "centre" else ""
    speed, coolant = head.spindle or 0.0, head.coolant == "on"
    return PostOptions(tool, speed, coolant, head.work_offset, blend=head.blend, cutter=named, length=length)


def cl_head(settings: Settings) -> ClHead:
    """Return what the head of a CL file is to say."""
    options = post_options(settings)
    return ClHead(options.tool, options.speed, options.coolant)


def cl_reading(settings: Settings) -> ClReading:
    """How a CL file is to be read."""
    tool = settings.reading.cl_tool
    return ClReading(
        settings.feeds.feed,
        ARC_SHARE * settings.proof.tolerance,
        settings.reading.units,
        None if tool is None else int(tool),
    )


def with_head(settings: Settings, findings: ClHead) -> Settings:
    """Return the settings with the tool, speed, coolant and cutter of a CL file where they have none of their
    own.

    Where the cutter's centre is driven, the cutter must be said with it: the machine has been set up by its
    corner.
    """
    given = settings.head
    speed = (findings.speed or None) if given.spindle is None else given.spindle
    head = replace(
        given, tool=findings.tool if given.tool is None else given.tool, spindle=speed,
        coolant="on" if findings.coolant else given.coolant,
    )  # fmt: skip
    return with_cutter(replace(settings, head=head), findings.cutter)


def with_cutter(settings: Settings, cutter: Cutter | None) -> Settings:
    """Return the settings with this cutter, which a file names, where they have none of their own and the tip
    is driven."""
    if cutter is None or "cutter" in settings.explicit or settings.machine.control_point != "tip":
        return settings
    return replace(
        settings, cutter=replace(settings.cutter, cutter=cutter), explicit=settings.explicit | {"cutter"}
    )


def nc_title(settings: Settings, machine: Machine) -> str:
    """For whom the program is. No file's name: the same solid and settings give the same bytes from
    anywhere."""
    return machine.name


def title_of(settings: Settings) -> str:
    """Return the title of reports: the source's name, on one line."""
    return one_line(Path(settings.source).name)
