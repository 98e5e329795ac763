# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the G and M codes mean to the reader (ISO 6983-1, NIST RS274NGC 3, Fanuc B-63324EN; G43.4 is written
434).

modal group  codes of which one is in force at a time: motion, distance, units, feed mode, plane.
finding      severity, code and text for what is not interpreted; the text goes on after "G2 stands in 3
             lines:".
grammar      one table for each language: ISO (LinuxCNC, Fanuc, Haas, Mach3, grbl), Siemens, Heidenhain.
private      small letters stand for words that ISO has not (:mod:`.siemens`, :mod:`.heidenhain`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.sentences import say

NONE, RAPID, STRAIGHT, ARC, CYCLE, SPLINE_MODE = -1, 0, 1, 2, 3, 4
"""Motion modes. NONE: no motion code so far, or after G80."""
CLOCKWISE, COUNTER = 20, 30
CYCLES = (*range(730, 780, 10), *range(810, 900, 10), 842, 843, 330, 331, 382, 383, 384, 385)
SPLINES = (50, 52, 62)
CURVES = (21, 22, 23, 24, 31, 32, 33, 34)
"""G2.1 to G3.4 of Fanuc: threads, involutes, exponential and three-dimensional arcs."""
MOTION = {
    0: RAPID, 10: STRAIGHT, 800: NONE, 20: ARC, 30: ARC, **dict.fromkeys(SPLINES, SPLINE_MODE),
    **dict.fromkeys(CYCLES, CYCLE), **dict.fromkeys(CURVES, SPLINE_MODE),
}  # fmt: skip
DISTANCE = {900: 0, 910: 1}
CENTRES = {911: 0, 901: 1}
"""Arc centres: from the start of the arc, or absolute (G90.1 of LinuxCNC and Mach3)."""
PLANES = {170: 0, 180: 1, 190: 2}
PER_MINUTE, INVERSE, PER_TURN = 0, 1, 2
PER_TURN_M = 9510
"""Private code, G951: M136 of Heidenhain."""
FEED_MODE = {940: PER_MINUTE, 930: INVERSE, 950: PER_TURN, PER_TURN_M: PER_TURN}
INCH = 25.4
DWELL = 40
TILT, LEVEL = (682, 531), 690
"""G68.2 and G53.1: a tilted plane, and the axes turned to it; G69 ends it."""
TURN, POLAR_MODE = 680, 160
"""G68 and G16 of Fanuc: coordinates turned in the plane, and polar ones (:mod:`.polar_mode`)."""
DYNAMIC = (2540, 2550)
"""G254 and G255 of Haas: the dynamic work offset, on and off (:mod:`.dynamic_offset`)."""
KINEMATICS = (121, 131)
"""G12.1 and G13.1 of LinuxCNC: the switch of kinematics (:mod:`.kinematics_switch`)."""
PRESET_ZERO = 920
LOCAL = 520
"""G52: the zero of the local coordinate system."""
RETRACT_M = 140
"""M140 of Heidenhain: back along the tool."""
DATUM = 540
"""G54 of Heidenhain's DIN/ISO: a datum shift."""
NO_MOVE = (
    71, 100, 109, 120, 130, 220, 270, 280, 281, 290, 300, 301, 310, 350, 360, 370, 431, 432, 470, 501, 510,
    511, 520, 530, 531, 650, 660, 661, 680, 682, 683, 684, 920, 921, 922, 923, 1000, 1010, 1070, 1360,
    1500, 2680,
)  # fmt: skip
"""Codes (ten times the G number) whose axis words are no move of a block: what they shift, turn, scale or
mirror about, where a stored stroke ends, a tool's length (G43.1 of LinuxCNC), what a probe (G31, G36, G136)
or a pocket (G12, G13, G150) of one line begins with."""
OFFSETS = (*range(540, 600, 10), 591, 592, 593, 541, 1540)
NUMBERED_OFFSETS = (541, 1540)
"""G54.1 P5 of Fanuc, G154 P5 of Haas: P says which."""
GUIDE_ON, GUIDE_OFF = (434, 435, 2340), (430, 490, 2341)
VECTORS_ON = (435,)
"""I J K of straight blocks are the tool's direction."""
HARMLESS = {
    *(MOTION.keys() - {*CYCLES, *SPLINES, *CURVES}), *DISTANCE, *CENTRES, *PLANES, 210, 200, 940, 930, 40, 51,
    80, 90, 150, 400,
    401, 430, 440, 490, 431, 432, 500, 610, 611, 620, 640, 670, 690, 960, 970, 980, 990, 53, 250, 260, 1030,
    1870, *OFFSETS, *GUIDE_ON, *GUIDE_OFF, *TILT,
}  # fmt: skip
SIDES = (410, 411, 412, 414, 415, 416, 420, 421, 422, 424, 425, 426)
"""Cutter compensation; with D0 in the same line it moves nothing."""
WORDS_IGNORED = "NOSMTHDPQLFG"
WORDS_OF = {
    51: "R",
    53: "R",
    1870: "E",
    250: "R",
    260: "R",
    100: "R",
    680: "R",
    3310: "K",
    3320: "K",
    **dict.fromkeys(CYCLES, "R"),
}
"""Words that belong to a code in their line and are no places: the level of G5.1 Q1 R1 (Fanuc), the tolerance
of G187 P3 E0.01 (Haas), the height R of a cycle, of which is said that it is not written out."""
AXES = "XYZABCUVW"
INCREMENTED = AXES + "IJKR"
"""Words that count the least increment where they have no decimal point, on the controllers that are set
so."""

PECK = "Q"

STEP_OF = dict(zip("XYZABC", "xyzabc", strict=True))
"""An incremental word among absolute ones (Heidenhain's IX, Siemens' X=IC())."""
SHORTER_OF = dict(zip("ABC", "efg", strict=True))
"""A rotary word that is reached by the shorter way (Siemens' C=DC())."""
VECTOR = "ijk"
CENTRE = "pqr"
"""An absolute arc centre, which stays until the next one (Heidenhain's CC)."""
SWITCH = "t"
"""t1: the controller guides the tip; t0: no longer."""
ANGLE = "n"
"""n30: the angle of a straight line in the working plane, deg (Siemens' ANG=, Fanuc's ,A)."""
PLANE = "w"
"""w3: the fourth of the tilted planes of the program (Heidenhain's PLANE, Siemens' CYCLE800)."""
DRILL = "d"
"""d3: the fourth of the program's calls of drilling cycles (:mod:`.siemens_cycles`)."""
SHIFTED = "s"
"""The words of this line shift the zero; s0: ends all shifts, s1: of the axes named, s2: of all, s3: on from
where it is; s4, s5: turn the coordinates anew, on (Siemens' ROT, AROT)."""
IN_THE_PLANE = "I"
"""In a line that turns the coordinates: the angle about the normal of G17, G18 or G19 (Siemens' RPL=)."""
TURNS = "o"
"""o2: the arc of this line goes round twice more (Siemens' TURN=)."""
ORIGIN = "hlm"
"""In the line of a tilted plane: the shift before it, mm."""
MACHINE = "v"
"""v1: the words of this line are machine positions (Heidenhain's M91, M92, Siemens' SUPA)."""

AXIS_LETTERS = "XYZABC"
ABSOLUTE = "u"
"""u3: the word of A in this line, the fourth of AXIS_LETTERS, is absolute whatever is in force (Siemens'
A=AC())."""

Kind = tuple[Code, str]
CYCLE_KIND: Kind = (
    Code.CYCLE_NOT_INTERPRETED,
    say("cycles, whose moves are missing here; post straight moves"),
)
ARC_KIND: Kind = (
    Code.ARC_NOT_INTERPRETED,
    say("arcs of a form that is not known here, taken as straight to their end points; post straight moves"),
)
SPLINE: Kind = (
    Code.SPLINE_NOT_INTERPRETED,
    say("splines, taken as straight to their end points; post straight moves"),
)
CALL: Kind = (
    Code.CALL_NOT_INTERPRETED,
    say("calls, whose moves are missing here; post one program without them"),
)
HOME: Kind = (
    Code.MACHINE_POSITION,
    say(
        "moves to machine positions unknown to the program; they and the ways back from there are not audited"
    ),
)
SHIFT: Kind = (
    Code.OFFSET_NOT_INTERPRETED,
    say("shifts, turns or scales of the coordinates; post without them"),
)
POLAR: Kind = (
    Code.POLAR_NOT_INTERPRETED,
    say("polar coordinates, whose moves are missing here; post X, Y and Z"),
)
RADIUS: Kind = (
    Code.COMPENSATION_NOT_INTERPRETED,
    say("cutter compensation; the words are taken as they are"),
)
PER_TURN_KIND: Kind = (Code.FEED_PER_TURN, say("feeds per spindle turn; no time is given for these blocks"))
MACRO: Kind = (
    Code.MACRO_NOT_INTERPRETED,
    say("variables, expressions or jumps; their words are missing here. Post without them"),
)
CORNER: Kind = (
    Code.CORNER_NOT_INTERPRETED,
    say(
        "roundings, chamfers or angles of a contour, whose moves are missing here; post straight moves and "
        "arcs"
    ),
)
SPATIAL: Kind = (
    Code.ORIENTATION_NOT_INTERPRETED,
    say(
        "tool axes told by spatial, Euler or lead angles; they are missing here. Post rotary words or vectors"
    ),
)
IDLE_VECTOR: Kind = (
    Code.ORIENTATION_NOT_INTERPRETED,
    say(
        "tool vectors while nothing guides the tip; the rotary axes stay where they are. Switch the guide on "
        "before (M128, FUNCTION TCPM, TRAORI)"
    ),
)
OTHER_AXIS: Kind = (
    Code.UNKNOWN_AXIS,
    say(
        "an axis that this machine does not have; its moves are missing here. Choose the program's own "
        "machine"
    ),
)
UNKNOWN: Kind = (Code.UNKNOWN_CODE, say("not known and not interpreted; what it does is missing here"))
DELTA: Kind = (
    Code.TOOL_DELTA,
    say(
        "a tool unlike that of the control's table (DL, DR); the words are taken as they are, without the "
        "difference"
    ),
)
PRESET: Kind = (
    Code.DATUM_OF_TABLE,
    say("the zero is that row of the control's table; the program is read as if the work zero stood there"),
)
PRESETS: Kind = (
    Code.WORK_OFFSET_CHANGE,
    say(
        "rows of the control's table, whose distance is not known; the blocks between are not right. Audit "
        "each part on its own"
    ),
)
WAY: Kind = (
    Code.ROTARY_DIRECTION,
    say("rotary words with a direction (ACP, ACN); taken by the shorter way. Post absolute words"),
)

DWELL_KIND: Kind = (Code.DWELL, say("dwells; their time is in no time that is told here"))

CODES: dict[int, Kind] = {
    DWELL: DWELL_KIND,
    **dict.fromkeys(CYCLES, CYCLE_KIND),
    **dict.fromkeys(SPLINES, SPLINE),
    **dict.fromkeys(CURVES, ARC_KIND),
    **dict.fromkeys((650, 660, 661), CALL),
    **dict.fromkeys((280, 281, 300, 301, 530), HOME),
    **dict.fromkeys(
        (100, 160, 501, 510, 511, 542, 543, 544, 680, 683, 684, 2530, 2680, 2690, 920, 921, 922, 923, 1000),
        SHIFT,
    ),
    **dict.fromkeys((70, 1010, 1430), SHIFT),
    **dict.fromkeys((71, 1070), POLAR),
    **dict.fromkeys((120, 130, 310, 350, 360, 370, 470, 1360, 1500), CYCLE_KIND),
    **dict.fromkeys((270, 290), HOME),
    **dict.fromkeys(SIDES, RADIUS),
    950: PER_TURN_KIND,
}


@dataclass(frozen=True)
class Grammar:
    """One language. ``units``: codes of mm (0) and inches (1), ``units_text``: how messages call them;
    ``harmless``, ``codes``, ``m_codes``: what is said of a code; ``ends``: M codes that end the program;
    ``guide_m``: M codes that switch the guide on (1) and off (0); ``dwell``: words that can be the time of
    G4, the first of them that stands in its line is; ``offsets``: work offsets; ``inch_feed``: the mm/min of
    F1 in a program in inches; ``inch_degrees``: F of rotary axes alone is in degrees a minute there too;
    ``no_move``, ``machine_m``: G and M codes whose axis words are no move; ``motion``: the modes of motion
    codes."""

    name: str
    units: Mapping[int, int]
    units_text: str
    harmless: frozenset[int]
    codes: Mapping[int, Kind]
    m_codes: Mapping[int, Kind]
    ends: tuple[int, ...] = (2, 30, 99)
    inch_feed: float = INCH
    inch_degrees: bool = True
    guide_m: Mapping[int, int] | None = None
    dwell: str = "PXUF"
    offsets: tuple[int, ...] = OFFSETS
    no_move: tuple[int, ...] = NO_MOVE
    machine_m: tuple[int, ...] = ()
    motion: Mapping[int, int] = field(default_factory=lambda: MOTION)


ISO = Grammar(
    "iso", {210: 0, 200: 1}, say("neither G20 nor G21"), frozenset({*HARMLESS, LOCAL, *DYNAMIC, *KINEMATICS}),
    CODES,
    {97: CALL, 98: CALL, 198: CALL}, guide_m={128: 1, 129: 0, 428: 1, 429: 0, 430: 0},
)  # fmt: skip
LENGTHS_ALONE = (700, 710)
"""G70 and G71 of Siemens: units that F does not heed."""
_SIEMENS_OWN = {
    700: 1, 7000: 1, 710: 0, 7100: 0, 600: 0, 6010: 0, 6020: 0, 6030: 0, 6410: 0, 6420: 0, 6430: 0, 6440: 0,
    6450: 0, 500: 0,
    5000: 0, 4500: 0, 4510: 0, 2900: 0, 90: 0, 250: 0, 260: 0, 1500: 0, 4600: 0, 4610: 0, 1470: 0, 1480: 0,
    **dict.fromkeys((2470, 2480, 3470, 3480, 1400, 1410, 1420, 1430, 3400, 3410), 0),
}  # fmt: skip
FEED_GROUPS = tuple(range(90000, 95000, 10))
"""Private codes, G9000 to G9499: over which axes F is measured (:mod:`.feed_groups`)."""
WITHOUT_OFFSET = 5000
"""G500 of Siemens: no settable zero offset is on."""
POLES = (1100, 1110, 1120)
"""G110 to G112 of Siemens: poles, whose axis words move nothing."""
TAPPING = (3310, 3320)
"""G331 and G332 of Siemens: a thread cut without a cycle, in and out, whose Z follows the spindle."""
_SIEMENS_OFFSETS = (540, 550, 560, 570, *range(5050, 6000, 10))
SIEMENS = Grammar(
    "siemens",
    {700: 1, 7000: 1, 710: 0, 7100: 0},
    say("neither G70 nor G71 (G700, G710)"),
    frozenset(
        {*HARMLESS, *_SIEMENS_OWN, *_SIEMENS_OFFSETS, *FEED_GROUPS} - {490, 434, 435, 2340, 2341, *TILT}
    ),
    {
        **dict.fromkeys((330, 331, 332, 340, 350, 630, *TAPPING), CYCLE_KIND),
        **dict.fromkeys((530, 740, 750, 1530), HOME),
        **dict.fromkeys((*POLES, 580, 590), SHIFT),
        **dict.fromkeys((410, 420), RADIUS),
        950: PER_TURN_KIND,
        DWELL: DWELL_KIND,
    },
    {},
    ends=(2, 17, 30),
    dwell="FS",
    offsets=_SIEMENS_OFFSETS,
    no_move=(530, 580, 590, 740, 750, 1530, *POLES),
    motion={
        **{code: mode for code, mode in MOTION.items() if code not in (740, 750)},
        **dict.fromkeys(TAPPING, CYCLE),
    },  # G74 and G75: fixed points, in their line alone
)
HEIDENHAIN = Grammar(
    "heidenhain",
    {210: 0, 200: 1},
    say("neither MM nor INCH in BEGIN PGM"),
    frozenset({*HARMLESS, PER_TURN_M, 300, 310} - {530}),
    {
        530: SHIFT,
        DWELL: DWELL_KIND,
        **dict.fromkeys((100, 110, 120, 130, 150, 160), POLAR),
        **dict.fromkeys((280, 720, 730), SHIFT),
        **dict.fromkeys((50, 60, 240, 250, 260, 270), ARC_KIND),
        **dict.fromkeys((*range(740, 800, 10), 830, 840, 850, 860), CYCLE_KIND),
        **dict.fromkeys((410, 420), RADIUS),
    },  # of DIN/ISO: polar moves, mirror, scale and turn, arcs, chamfers, ways in and out, cycles, their call
    {89: CYCLE_KIND, 99: CYCLE_KIND, 91: HOME, 92: HOME, 114: SPATIAL, 130: SHIFT, 144: SHIFT},
    ends=(2, 30),
    inch_feed=0.1 * INCH,
    dwell="FPXU",
    no_move=(*NO_MOVE, DATUM),
    motion={
        code: mode for code, mode in MOTION.items() if mode is not CYCLE and code not in (50, 52, 62, 800)
    }
    | {50: SPLINE_MODE, 60: SPLINE_MODE},
    guide_m={128: 1, 129: 0},
    machine_m=(91, 92),
)
GRAMMARS = {grammar.name: grammar for grammar in (ISO, SIEMENS, HEIDENHAIN)}
