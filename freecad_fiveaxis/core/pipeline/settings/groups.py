# SPDX-License-Identifier: LGPL-2.1-or-later
"""The groups of settings, one frozen dataclass each: every input of a job stands here, and nowhere else.

A field knows its quantity (and so its unit), its range, its help and the tasks that use it. :mod:`.settings`
makes one tree of the groups.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from freecad_fiveaxis.core.base.ranges import LARGEST_CHANGE, LEAST_CHANGE, LEAST_TILT, MOST_TILT
from freecad_fiveaxis.core.base.rapids import RAPIDS
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.tool import Cutter

from .option import (
    AUDIT,
    COMPARE,
    FARTHEST,
    FASTEST,
    FROM_PATH,
    FROM_SOLID,
    LONGEST,
    MILL,
    NEAREST,
    ONE_PROGRAM,
    POST,
    PROVE,
    REACH,
    RECOVER,
    SETUP,
    SLOWEST,
    SMALLEST,
    TASKS,
    TRIALS,
    WIDEST_LEAD,
    option,
)


@dataclass(frozen=True)
class PassSettings:
    """Where the passes lie (planes: Lin & Ye, II.B and C)."""

    passes: str = option(
        "scallop",
        "text",
        "pass strategy (see `strategies`); planes if a direction or a plane normal is given",
    )
    plane_normal: Vector | None = option(
        None, "vector", "I,J,K across the planes [upright, along the direction]", least=-LONGEST, most=LONGEST
    )
    from_: str | Vector = option(
        "border", "place",
        "where scallop and morph passes begin: at the region's border, at a point X,Y,Z or along a curve, a "
        "file of X,Y,Z on each line (or the lines themselves, a ; between two)",
        least=-LONGEST, most=LONGEST,
    )  # fmt: skip
    to: str | Vector = option(
        "border", "place",
        "where morph passes end: the same. From border to border they run along the direction, on a ring "
        "from rim to rim",
        least=-LONGEST, most=LONGEST,
    )  # fmt: skip
    pass_centre: str | Vector = option(
        "middle", "place",
        "point of the axis that radial passes radiate from, and rotary ones turn about: X,Y,Z or the middle "
        "of what is cut (rotary: of the machine's only rotary axis, else of the part)",
        least=-LONGEST, most=LONGEST,
    )  # fmt: skip
    pass_axis: Vector | None = option(
        None, "vector",
        "I,J,K of that axis [0,0,1; rotary: the machine's only rotary axis, else the part's longest side]",
        least=-LONGEST, most=LONGEST,
    )  # fmt: skip
    rotary_by: Literal["around", "along"] = option(
        "around", "choice",
        "rotary passes are rings around the axis, which --spiral makes one helix, or lines along it",
        choices=("around", "along"),
    )  # fmt: skip
    frames: float = option(
        12, "count",
        "most positions of the rotary axes that the passes `frames` are cut in [as many as are worth it]",
        least=1,
        most=12,
    )  # fmt: skip
    within_frames: Literal["scallop", "planes"] = option(
        "scallop", "choice",
        "what the passes `frames` are in each frame: constant scallop, or planes along the frame's axis and "
        "the direction",
        choices=("scallop", "planes"),
    )  # fmt: skip
    direction: float = option(
        0.0,
        "angle",
        "travel direction of planes (and of morph passes from border to border), counter-clockwise from X",
    )
    scallop: float | None = option(
        None,
        "length",
        "largest scallop left between passes; where these turn in corners or end at edges up to 3.5 "
        "times as much may stay [0.01 where no stepover is given]",
        least=SMALLEST,
        most=LONGEST,
    )
    stepover: float | None = option(
        None, "length", "constant distance of the planes, instead of a scallop", least=SMALLEST, most=LONGEST
    )
    least_interval: float = option(
        0.05, "length", "planes never come closer than this (steep walls)", least=SMALLEST, most=LONGEST
    )
    steep_shallow: float | None = option(
        None, "angle",
        "level planes where the surface is steeper than this from the horizontal, the passes only where it "
        "is not [the passes everywhere]",
        above=0, most=math.pi / 2,
    )  # fmt: skip
    max_axis_angle: float | None = option(
        None, "angle", "facets (auto: axes) that lean more from Z are left out; beyond 90 they look down "
        "[90; auto: as far as the machine goes, where its file says where the table is]",
        above=0, most=math.pi,
    )  # fmt: skip


@dataclass(frozen=True)
class FacesSettings:
    """Which faces are machined and which are not, and how STL files are meant. The workbench selects faces
    instead, and its solids are in mm."""

    faces: str | None = option(
        None,
        "path",
        "an STL file of faces: only the facets of the part that lie on them are machined [all]",
        (*FROM_SOLID, REACH),
    )
    avoid: str | None = option(
        None,
        "path",
        "an STL file of faces: the facets of the part that lie on them are not machined [none]",
        (*FROM_SOLID, REACH),
    )
    stl_units: Literal["mm", "cm", "m", "inch"] = option(
        "mm",
        "choice",
        "what the coordinates of STL files count (part, faces, fixtures): an STL file does not say it",
        (MILL, POST, AUDIT, SETUP, COMPARE, REACH),
        choices=("mm", "cm", "m", "inch"),
    )


@dataclass(frozen=True)
class BoundarySettings:
    """Within which closed curves the passes are kept."""

    boundary: str | None = option(
        None,
        "curve",
        "a CSV file of closed curves, X,Y,Z in mm on each line, a blank line between two (or the lines "
        "themselves, a ; between two, and ;; between two curves): passes end at them [none]",
        (*FROM_SOLID, REACH),
    )
    boundary_axis: Vector = option(
        (0.0, 0.0, 1.0),
        "vector",
        "I,J,K along which the boundary is seen",
        (*FROM_SOLID, REACH),
        least=-LONGEST,
        most=LONGEST,
    )
    boundary_by: Literal["contact", "centre"] = option(
        "contact",
        "choice",
        "what stays inside the boundary: the contact, or the cutter's centre",
        choices=("contact", "centre"),
    )


@dataclass(frozen=True)
class CutterSettings:
    """The cutter and how co-edges are closed."""

    cutter: Cutter = option(
        Cutter(10.0), "cutter", "KIND:DIAMETER, as ball:10 or ball:0.5in", (*FROM_PATH, AUDIT, REACH)
    )
    coedge_tolerance: float = option(
        0.01,
        "length",
        "largest R - r at a convex co-edge before an arc is used",
        least=SMALLEST,
        most=LONGEST,
    )


@dataclass(frozen=True)
class ToolAxisSettings:
    """How the tool stands at each contact."""

    tool_axis: str = option(
        "auto",
        "text",
        "tool-axis strategy (see `strategies`); facet_mean for planes, face_normal for flat and bull cutters",
    )
    axis: Vector = option(
        (0.0, 0.0, 1.0),
        "vector",
        "I,J,K of the strategy `fixed`, tip to holder",
        least=-LONGEST,
        most=LONGEST,
    )
    lead: float = option(
        0.0,
        "angle",
        "lean of the tool along the feed; above 0 its top goes ahead of its tip",
        least=-math.pi / 2,
        most=math.pi / 2,
    )
    tilt: float = option(
        0.0,
        "angle",
        "lean of the tool across the feed; above 0 its top stands to the right of the feed",
        least=-math.pi / 2,
        most=math.pi / 2,
    )
    max_tilt: float = option(
        math.radians(5.0), "angle",
        "how far the strategy `minimax` may leave the facet normals, and gouge `tilt` the axes of any "
        "strategy",
        least=LEAST_TILT, most=MOST_TILT,
    )  # fmt: skip


@dataclass(frozen=True)
class LinkSettings:
    """What happens between passes."""

    order: Literal["zigzag", "one_way"] = option(
        "zigzag", "choice", "passes run to and fro, or all in one direction", choices=("zigzag", "one_way")
    )
    spiral: Literal["on", "off"] = option(
        "off", "choice", "closed passes round one another become one long pass, without links between them",
        choices=("on", "off"),
    )  # fmt: skip
    links: Literal["near", "over"] = option(
        "near", "choice",
        "between passes the tool stays near the part where it is free there, or always goes over it",
        choices=("near", "over"),
    )  # fmt: skip
    clearance: float = option(
        5.0, "length", "rapids stay this far off the part's bounding box", least=NEAREST, most=FARTHEST
    )
    lead_in: float = option(
        0.0, "length",
        "passes are entered from off the part, and left, on an arc of this radius tangent to the surface "
        "[none]",
        least=0.0, most=WIDEST_LEAD,
    )  # fmt: skip


@dataclass(frozen=True)
class FeedSettings:
    """Feeds of the tip over the part."""

    feed: float = option(
        1000.0, "feed", "feed of the tip over the part, mm/min", FROM_PATH, least=SLOWEST, most=FASTEST
    )
    plunge_feed: float = option(300.0, "feed", "feed of the approach, mm/min", least=SLOWEST, most=FASTEST)
    feed_mode: Literal["g93", "g94"] = option(
        "g93", "choice", "inverse time, or units a minute", FROM_PATH, choices=("g93", "g94")
    )


RTCP = ("off", "angles", "vectors")
"""Joint output, or the tip guided by the controller: as the dialects' guides are called."""


AS_MACHINE = "machine"
"""The choice that leaves it to the machine file."""


@dataclass(frozen=True)
class HeadSettings:
    """What the head of the NC file says."""

    tool: float | None = option(
        None,
        "count",
        "tool number [no tool call: the operator has set tool and length]",
        (MILL, POST, PROVE),
        least=1,
        most=99_999,
    )
    spindle: float | None = option(
        None, "speed",
        "spindle speed, 1/min; off (or 0) for a dry run [the spindle stays off, with a warning]",
        (MILL, POST),
        least=0, most=999_999,
    )  # fmt: skip
    coolant: Literal["on", "off"] = option(
        "off", "choice", "coolant during the program", (MILL, POST), choices=("on", "off")
    )
    work_offset: str = option(
        "G54",
        "text",
        "work offset: G54 to G59, LinuxCNC's G59.1 to G59.3, Fanuc's G54.1 P1 to P300",
        (MILL, POST, PROVE),
    )
    rtcp: str = option(
        "off", "choice",
        "the controller guides the tip (RTCP), told the tool axis by rotary words (angles) or vectors; off: "
        "joint output",
        (MILL, POST), choices=RTCP, bare="angles",
    )  # fmt: skip
    high_speed: Literal["on", "off"] = option(
        "off",
        "choice",
        "the controller's high-speed mode, with the tolerance of --blend",
        (MILL, POST),
        choices=("on", "off"),
    )
    nc_units: Literal["machine", "mm", "inch"] = option(
        AS_MACHINE,
        "choice",
        "lengths and feeds of the NC file; machine: as the machine file says (output.units), else mm",
        (MILL, POST),
        choices=(AS_MACHINE, "mm", "inch"),
    )
    blend: float = option(
        0.0,
        "length",
        "how far the controller may round corners, where it can; 0: exact path",
        (MILL, POST),
        least=0,
        most=999,
    )


@dataclass(frozen=True)
class MachineSettings:
    """The machine and where the part stands on it."""

    machine: str = option(
        "",
        "text",
        "a shipped machine's name or a path to a .fcm",
        (*ONE_PROGRAM, SETUP, REACH, RECOVER, PROVE),
    )
    controller: str | None = option(
        None, "text", "the dialect of the NC file [the machine's, or linuxcnc]", TASKS
    )
    origin: Vector | None = option(
        None,
        "point",
        "X,Y,Z of the work zero in the machine frame [the machine's]",
        TASKS,
        least=-LONGEST,
        most=LONGEST,
    )
    tool_length: float | None = option(
        None,
        "length",
        "gauge point to tip; machines with a rotary head need it",
        TASKS,
        least=0,
        most=LONGEST,
    )
    rapids: str = option(
        AS_MACHINE, "choice",
        "how the controller drives its axes in a rapid: together (interpolated), each at its own rate "
        "(independent), or unknown; machine: as the machine file says, else the controller",
        (MILL, AUDIT), choices=(AS_MACHINE, *RAPIDS),
    )  # fmt: skip
    control_point: Literal["tip", "centre"] = option(
        "tip", "choice", "the point of the tool that the words drive", choices=("tip", "centre")
    )


SINGULARITY = ("report", "linearize", "deform")
"""What can be done about blocks that pass the singular cone."""


@dataclass(frozen=True)
class CureSettings:
    """What is done against deviation and needless turning."""

    linearize: Literal["on", "off"] = option(
        "off", "choice", "divide feed blocks over tolerance into the fewest that hold it; off with rtcp",
        (MILL, POST, SETUP),
        choices=("on", "off"), by_task={MILL: "on", POST: "on", SETUP: "on"},
    )  # fmt: skip
    singularity: str = option(
        "report", "choice",
        "near the pole: only report, divide blocks over tolerance, or lead the tool axis past it (deform)",
        (MILL, POST), choices=SINGULARITY,
    )  # fmt: skip
    max_axis_change: float = option(
        math.radians(2.0), "angle", "largest change of the tool axis where it is led past the pole (deform)",
        least=LEAST_CHANGE, most=LARGEST_CHANGE,
    )  # fmt: skip


GOUGE = ("off", "report", "lift", "leave-out", "tilt")
"""What is done where the tool would enter the part."""


@dataclass(frozen=True)
class GougeSettings:
    """Cutter, shank and holder against the whole part."""

    gouge: str = option(
        "off", "choice",
        "where the tool enters the part: only report, lift it along its axis, leave out, or tilt it free "
        "within max-tilt and lift where the cutter still enters; off: no check",
        (MILL, AUDIT, SETUP, COMPARE), choices=GOUGE,
        by_task={MILL: "lift", SETUP: "lift", COMPARE: "lift", AUDIT: "report"},
    )  # fmt: skip
    shank: tuple[tuple[float, float], ...] = option(
        (), "stack", "cylinders above the cutter, DIAMETERxLENGTH upwards in mm, as 8x20,12x30; see gouge",
        (MILL, AUDIT, *TRIALS),
    )  # fmt: skip
    holder: tuple[tuple[float, float], ...] = option(
        (), "stack", "cylinders of the holder above cutter and shank, as 40x25,63x50 in mm; see gouge",
        (MILL, AUDIT, *TRIALS),
    )  # fmt: skip
    fixture: tuple[str, ...] = option(
        (), "paths",
        "an STL file of a vise, clamp or other fixture, in the part's own place, or with the place of its "
        "zero behind it: FILE.stl@X,Y,Z in mm from the work zero, or FILE.stl@X,Y,Z,RX,RY,RZ with degrees, "
        "turned about X, then Y, then Z of the work zero; the tool is checked against it, and a path is laid "
        "around it; may be repeated", (*ONE_PROGRAM, *TRIALS),
    )  # fmt: skip
    fixture_clearance: float = option(
        0.0, "length",
        "how near cutter, shank, holder and spindle may come to fixtures and bodies of the machine before "
        "that is "
        "told", (*ONE_PROGRAM, SETUP, COMPARE), least=0.0, most=LONGEST,
    )  # fmt: skip
    avoid_allowance: float = option(
        0.0, "length",
        "so far cutter, shank and holder keep off the faces to avoid, on feeds and rapids; 0: they may touch "
        "them",
        (*FROM_SOLID, REACH), least=0.0, most=LONGEST,
    )  # fmt: skip
    rest: Literal["on", "off"] = option(
        "off", "choice", "map of what stays uncut and of what is cut too deep, on the machined facets",
        (MILL,),
        choices=("on", "off"), bare="on",
    )  # fmt: skip


@dataclass(frozen=True)
class ProofSettings:
    """What is proven of every block."""

    tolerance: float = option(
        0.01, "length", "largest deviation of the tip from the commanded segment", (*FROM_PATH, AUDIT, REACH),
        least=SMALLEST, most=LONGEST,
    )  # fmt: skip
    method: Literal["exact", "so2008", "so2008-printed"] = option(
        "exact", "choice", "line deviation: exact, or the model of So et al. 2008", ONE_PROGRAM,
        choices=("exact", "so2008", "so2008-printed"),
    )  # fmt: skip


USUAL_REGION = (100.0, 100.0, 100.0)
"""mm; Z of it only where the height of the table is known."""


@dataclass(frozen=True)
class SetupSettings:
    """Where the part may stand."""

    region: Vector = option(
        USUAL_REGION, "lengths",
        "X,Y,Z: so far to either side the work zero may move from where it is; 0: it stays, as Z does where "
        "nobody says how high the table is",
        (SETUP,), least=0, most=FARTHEST,
    )  # fmt: skip
    grid: Vector | None = option(
        None,
        "counts",
        "places that the map shows along X,Y,Z [as many as take some seconds]",
        (SETUP,),
        least=1,
        most=200,
    )
    turns: float = option(
        1.0,
        "count",
        "so many turns of the part about Z are tried, evenly over 360 deg [1: as it stands]",
        (SETUP,),
        least=1,
        most=360,
    )
    table_height: float | None = option(
        None,
        "height",
        "height of the table's face in the machine frame, mm [the machine's]",
        (SETUP, REACH),
        least=-LONGEST,
        most=LONGEST,
    )
    jaw_thickness: float = option(
        40.0, "length",
        "how thick the jaws are of which is told how high they may reach, where there is a fixture", (SETUP,),
        least=0.1, most=FARTHEST,
    )  # fmt: skip


@dataclass(frozen=True)
class CompareSettings:
    """What is compared."""

    machines: tuple[str, ...] = option(
        (),
        "names",
        "machines to compare, as for `mill`, with commas between; or --machine again for each",
        (COMPARE,),
    )
    cures: tuple[str, ...] = option(
        (), "names", "cures to compare, with commas between [every one there is]", (COMPARE,)
    )


@dataclass(frozen=True)
class RecoverSettings:
    """What a machine is recovered from, and the file it goes to."""

    program: str = option("", "path", "the NC program that was posted from the CL path", (RECOVER,))
    machine_file: str | None = option(None, "path", "the machine file (.fcm) to write", (RECOVER,))
    certainty: float = option(
        0.01, "length", "offsets should be that certain, and that near to those of the machine given",
        (RECOVER,),
        above=0, most=LONGEST,
    )  # fmt: skip


@dataclass(frozen=True)
class ProveSettings:
    """What is moved to prove the signs."""

    mark: Vector | None = option(
        None, "point",
        "X,Y,Z over the work zero of a place to mark, as high as part and clamps reach [nothing above Z 0]",
        (PROVE,), least=-LONGEST, most=LONGEST,
    )  # fmt: skip
    gap: float = option(
        20.0,
        "length",
        "the tip stops so far above the mark, and never comes nearer",
        (PROVE,),
        least=5,
        most=500,
    )
    travel: float = option(20.0, "length", "way of each linear axis", (PROVE,), least=1, most=500)
    angle: float = option(
        math.radians(10.0),
        "angle",
        "turn of each rotary axis",
        (PROVE,),
        least=math.radians(2.0),
        most=math.radians(45.0),
    )
    slow_feed: float = option(
        200.0, "feed", "feed of all its moves, mm/min and deg/min", (PROVE,), least=1, most=2000
    )


UNITS, DECIMAL = ("file", "mm", "inch"), ("calculator", "least-increment")
"""What a file may be taken for that does not say it itself."""


@dataclass(frozen=True)
class ReadingSettings:
    """How numbers of a file of other origin are meant."""

    units: Literal["file", "mm", "inch"] = option(
        "file",
        "choice",
        "lengths in an NC or CL file that does not say its units; file: mm, with a warning",
        (POST, SETUP, COMPARE, AUDIT, RECOVER),
        choices=UNITS,
    )
    cl_tool: float | None = option(
        None, "count", "the tool of the CL file whose moves are meant, by its number there [all]",
        (POST, SETUP, COMPARE, AUDIT, RECOVER), least=0, most=99_999_999,
    )  # fmt: skip
    decimal: Literal["calculator", "least-increment"] = option(
        "calculator", "choice", "a word without a decimal point: X100 is 100 mm, or 0.1 mm (least increment)",
        (AUDIT, RECOVER),
        choices=DECIMAL,
    )  # fmt: skip
    search: tuple[str, ...] = option(
        (),
        "paths",
        "a folder with the programs that the program calls, beside its own; may be repeated",
        (AUDIT, RECOVER),
    )


@dataclass(frozen=True)
class AuditSettings:
    """What the audited program is compared with."""

    against: str | None = option(
        None,
        "path",
        "the CL file (.apt, .cl) or the part (.stl) that the program is compared with [neither]",
        (AUDIT,),
    )
    axis_tolerance: float = option(
        math.radians(0.2), "angle",
        "largest angle between the tool axis and that of the CL path at a block's end", (AUDIT,),
        above=0, most=math.pi / 2,
    )  # fmt: skip


@dataclass(frozen=True)
class OutputSettings:
    """Files to write, and advice."""

    output: str | None = option(None, "path", "the NC file", (MILL, POST, PROVE))
    cl: str | None = option(None, "path", "the CL path as an APT file", (MILL,))
    report: tuple[str, ...] = option(
        (), "paths", "report; the ending .json, .html or .txt says which; may be repeated", TASKS
    )
    blocks: str | None = option(None, "path", "CSV with one row a block", ONE_PROGRAM)
    rates: str | None = option(
        None, "path",
        "CSV with one row a block: time, feed over the part, rates asked of the axes, distance off path or "
        "part",
        (AUDIT,),
    )  # fmt: skip
    advise: Literal["on", "off"] = option(
        "off", "choice",
        "where something stays unfinished: other passes, free tool axes and smaller balls are tried, and the "
        "one that finishes most more is named; takes as long as some programs", (MILL,),
        choices=("on", "off"), bare="on",
    )  # fmt: skip
