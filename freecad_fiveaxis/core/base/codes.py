# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of finding, with its severity, the unit of its value and what it means: the one list of them.

code      a stable kebab-case word, by which JSON reports, scripts and the window know a finding.
severity  ordered by consequence: NOTE changes nothing on the part, WARNING may show on the part,
          ERROR will spoil the part or the machine if nobody looks (the command line then exits with 1).

``scripts/pages`` writes ``docs/findings.md`` from this list.
"""

from __future__ import annotations

from enum import Enum, IntEnum


class Severity(IntEnum):
    """Consequence for the part, least first."""

    NOTE = 0
    WARNING = 1
    ERROR = 2


NOTE, WARNING, ERROR = Severity


class Code(str, Enum):
    """What a finding is about. ``severity``: where the place that reports it knows no better; ``unit``: of
    its value, "" for a count or where it has none; ``meaning``: a clause for the list and the verdict, which
    is translated as the sentences are."""

    severity: Severity
    unit: str
    meaning: str

    def __new__(cls, text: str, severity: Severity, unit: str, meaning: str) -> Code:
        """Make a member that is its text, with the other three beside it."""
        code = str.__new__(cls, text)
        code._value_ = text
        code.severity, code.unit, code.meaning = severity, unit, meaning
        return code

    def __str__(self) -> str:
        return str(self.value)

    # ---------------------------------------------------------------------------------------- the mesh
    CORNERS_JOINED = "corners-joined", NOTE, "1", "corners that lie next to each other were joined"
    DEGENERATE_FACETS = "degenerate-facets", NOTE, "1", "facets without an area were dropped"
    DOUBLED_FACETS = "doubled-facets", NOTE, "1", "facets that were there twice; one of each was kept"
    FACETS_TURNED = (
        "facets-turned",
        NOTE,
        "1",
        "facets that faced the other way than their neighbours were turned",
    )
    INCONSISTENT_WINDING = (
        "inconsistent-winding",
        WARNING,
        "1",
        "neighbouring facets disagree about which side is outside",
    )
    INWARD_FACETS = "inward-facets", NOTE, "1", "the facets of a closed mesh looked inward and were turned"
    NON_MANIFOLD_EDGES = "non-manifold-edges", WARNING, "1", "passes end at edges with more than two facets"
    OPEN_SHELL = "open-shell", WARNING, "1", "the mesh is open, and passes end at its edges"
    T_JUNCTIONS_JOINED = (
        "t-junctions-joined",
        NOTE,
        "1",
        "facets were divided at corners that lie on their sides",
    )
    UNIT_SUSPECTED = (
        "unit-suspected",
        WARNING,
        "mm",
        "part, path or limits look as if they were in another unit",
    )

    # ---------------------------------------------------------------------------------------- what is milled
    FACES_AVOIDED = "faces-avoided", NOTE, "mm2", "the faces that are to be avoided, and their area"
    FACES_CHOSEN = "faces-chosen", NOTE, "mm2", "the faces that are to be milled, and their area"
    FACES_MISSED = "faces-missed", WARNING, "mm2", "only a part of the chosen faces lies on the mesh"
    FACETS_ACROSS_AXIS = (
        "facets-across-axis",
        NOTE,
        "mm2",
        "facets at the ends of a rotary axis get no rotary passes",
    )
    FACETS_BEYOND_AXIS_ANGLE = (
        "facets-beyond-axis-angle",
        WARNING,
        "mm2",
        "facets lean more than the largest axis angle",
    )
    FACETS_BEYOND_MACHINE = (
        "facets-beyond-machine",
        WARNING,
        "mm2",
        "facets need rotary positions beyond the limits",
    )
    FACETS_LOOKING_DOWN = (
        "facets-looking-down",
        NOTE,
        "mm2",
        "facets that no allowed tool axis reaches from above, or that the part stands on",
    )
    FACETS_INSIDE = "facets-inside", NOTE, "mm2", "facets lie inside another solid of the part"
    SURFACE_LOOKS_DOWN = (
        "surface-looks-down",
        WARNING,
        "mm2",
        "the open surface looks down, so that its underside is machined",
    )
    FACETS_NEAR_AVOIDED = (
        "facets-near-avoided",
        WARNING,
        "mm2",
        "facets lie nearer to faces to avoid than the allowance",
    )
    FACETS_WITHOUT_FREE_AXIS = (
        "facets-without-free-axis",
        WARNING,
        "mm2",
        "no tool axis is free at these facets",
    )
    NEAR_AVOIDED_FACES = "near-avoided-faces", WARNING, "mm2", "a strip beside the faces to avoid stays uncut"
    OUTSIDE_BOUNDARY = "outside-boundary", NOTE, "mm2", "facets outside the boundary are left out"
    OUTSIDE_FRAMES = "outside-frames", WARNING, "mm2", "the tool is free there in none of the frames"
    SIDE_NOT_MACHINED = "side-not-machined", WARNING, "mm2", "no pass touches a side of the part"

    # -------------------------------------------------------------------------- passes and the cutter on them
    CORNER_NOT_REACHED = "corner-not-reached", WARNING, "", "an inside corner is tighter than the cutter"
    CUT_AT_BOUNDARY = "cut-at-boundary", NOTE, "mm", "passes end at the boundary"
    HEEL_IN_HOLLOW = (
        "heel-in-hollow",
        WARNING,
        "",
        "the cutter's bottom stands in the part before or behind its contact",
    )
    HIGH_SCALLOPS = (
        "high-scallops",
        NOTE,
        "mm",
        "passes that turn in corners or end at edges leave more than the scallop there",
    )
    LEAST_INTERVAL = (
        "least-interval",
        WARNING,
        "mm",
        "the scallop asks for passes nearer than the least interval",
    )
    NARROW_PASSES = "narrow-passes", NOTE, "mm", "passes are near to each other, for the cutter stands aslant"
    STEPOVER_BEYOND_CUTTER = (
        "stepover-beyond-cutter",
        WARNING,
        "mm",
        "passes are farther apart than the cutter is wide",
    )
    OFF_FLANK = (
        "off-flank",
        WARNING,
        "mm",
        "a barrel cutter touches with the ball at its tip, not with its flank",
    )
    SURFACE_TIGHTER_THAN_CUTTER = (
        "surface-tighter-than-cutter",
        WARNING,
        "",
        "the surface curls tighter than the cutter",
    )

    # ---------------------------------------------------------------------------------------- tool axes
    AXIS_BEYOND_LIMITS = (
        "axis-beyond-limits",
        WARNING,
        "mm",
        "tool axes that the machine cannot reach are left out",
    )
    AXIS_INTO_PART = (
        "axis-into-part",
        WARNING,
        "mm",
        "contacts at which the tool would stand in the part are left out",
    )
    FLANK_INTO_PART = (
        "flank-into-part",
        WARNING,
        "mm",
        "contacts at which a cone's flank would enter are left out",
    )
    FRAMES = "frames", NOTE, "1", "the part is cut in frames, each with a tool axis of its own"
    NO_FREE_AXIS = "no-free-axis", WARNING, "", "no tool axis keeps the tool out of part, fixtures and table"
    NO_WAY_OUT = "no-way-out", WARNING, "mm", "stretches that the tool could not leave are left out"
    AXIS_CHANGE_TRADE = "axis-change-trade", NOTE, "deg", "what a change of the tool axis buys near the pole"
    AXIS_LED_PAST_POLE = "axis-led-past-pole", NOTE, "deg", "passes were turned past the machine's pole"
    AXIS_LEFT_NEAR_POLE = (
        "axis-left-near-pole",
        NOTE,
        "deg/mm",
        "passes near the pole that could not be turned past it any better",
    )

    # ---------------------------------------------------------------------------------------- gouge avoidance
    LEFT_OUT = (
        "left-out",
        WARNING,
        "mm",
        "stretches of passes are left out, since the tool would enter the part",
    )
    LIFTED = "lifted", WARNING, "mm", "the tool was lifted out of the part"
    NOT_FREED = "not-freed", WARNING, "mm", "no allowed tilt keeps shank and holder out of the part"
    TILTED = "tilted", NOTE, "deg", "the tool axis was turned away from the part"

    # --------------------------------------------------------------------------------- joints and the program
    LEAD_IN_SMALLER = "lead-in-smaller", NOTE, "1", "lead-in or lead-out arcs are smaller than asked, or none"
    LINKS_RAISED = "links-raised", NOTE, "mm", "links or rewinds go higher, round bodies of the machine"
    NO_WAY_ROUND = (
        "no-way-round",
        WARNING,
        "mm",
        "no link within the travel goes round a body of the machine",
    )
    RAPIDS_DIVIDED = "rapids-divided", NOTE, "1", "rapids were divided, so that every way of the axes is free"
    RETRACT_DOWNWARDS = (
        "retract-downwards",
        WARNING,
        "mm",
        "the retract to a machine position goes below where the program begins or ends",
    )
    RETRACT_BELOW_PART = "retract-below-part", WARNING, "1", "retracts or approaches pass below the part"
    DIP_BELOW_PART = "dip-below-part", WARNING, "mm", "the tool dips below the plane on which the part stands"
    REWIND = "rewind", WARNING, "deg", "a rotary axis turns back inside a cut, with the tool retracted"
    REWINDS = "rewinds", WARNING, "1", "how many times a rotary axis turns back inside a cut"
    REWINDS_BETWEEN_CUTS = (
        "rewinds-between-cuts",
        NOTE,
        "1",
        "how many times a rotary axis turns back between cuts",
    )
    RINGS_BEGUN_ELSEWHERE = (
        "rings-begun-elsewhere",
        NOTE,
        "1",
        "closed passes begin where a rotary axis has room",
    )
    RINGS_REVERSED = (
        "rings-reversed",
        NOTE,
        "1",
        "closed passes run by turns one way and the other, within a rotary axis' limits",
    )
    ROWS_MERGED = "rows-merged", NOTE, "1", "rows of passes that are close together were merged"
    LIMIT = "limit", ERROR, "mm", "an axis leaves its limits"
    FEED_ABOVE_LARGEST = "feed-above-largest", NOTE, "mm/min", "F exceeds the controller's largest"
    FEED_BELOW_STEP = "feed-below-step", WARNING, "mm/min", "F lies below the controller's smallest step"
    FEED_HELD_BACK = "feed-held-back", NOTE, "1", "an axis would exceed its rate; the block runs slower"
    FIRST_POSITION_RAPID = (
        "first-position-rapid",
        NOTE,
        "",
        "the path starts with a feed; the program goes there in rapid",
    )
    NO_INVERSE_TIME = "no-inverse-time", NOTE, "", "the controller knows no inverse time feeds"
    TIP_GUIDED_BY_CONTROLLER = (
        "tip-guided-by-controller",
        NOTE,
        "mm",
        "the controller guides the tip between block ends",
    )
    TURNED_THE_SHORTER_WAY = (
        "turned-the-shorter-way",
        WARNING,
        "1",
        "a rotary axis that wraps takes the shorter way",
    )
    WRAP_NOT_WRITTEN = (
        "wrap-not-written",
        WARNING,
        "",
        "the controller does not take the shorter way that the machine file names",
    )
    LINEARIZED = "linearized", NOTE, "1", "blocks were divided to hold the tolerance"
    LINEARIZE_IMPOSSIBLE = (
        "linearize-impossible",
        WARNING,
        "1",
        "no number of blocks holds the tolerance there",
    )
    LINEARIZE_LIMIT = "linearize-limit", ERROR, "1", "a divided block would leave the limits in its middle"
    LINEARIZE_ROUNDING = (
        "linearize-rounding",
        WARNING,
        "mm",
        "the decimals of the words are too few for the tolerance",
    )
    ROTARY_WORDS_EVEN = "rotary-words-even", NOTE, "1", "rotary axes turn evenly in divided blocks"

    # ----------------------------------------------------------------------------- start and end of a program
    PART_BELOW_TABLE = (
        "part-below-table",
        WARNING,
        "mm",
        "the part would reach below the table, which is not looked at",
    )
    PART_IN_TABLE = (
        "part-in-table",
        NOTE,
        "mm",
        "the part would reach into the table, so its place is not known",
    )
    SAFE_START_BEYOND_LIMIT = (
        "safe-start-beyond-limit",
        WARNING,
        "mm",
        "the safe height lies beyond the limits",
    )
    START_BELOW_BODIES = (
        "start-below-bodies",
        WARNING,
        "mm",
        "the program begins and ends below what the axes carry",
    )
    SPINDLE_OFF = "spindle-off", WARNING, "", "the spindle stays off"
    SPINDLE_WITHOUT_SPEED = "spindle-without-speed", WARNING, "", "the spindle is started without a speed"
    SPINDLE_REVERSED = "spindle-reversed", WARNING, "", "the spindle turns to the left"
    TOOL_LENGTH_OFF = "tool-length-off", WARNING, "", "no tool length is active where the program feeds"
    TOOL_LENGTH_OTHER = "tool-length-other", WARNING, "", "the length of another tool is active"
    GUIDE_NOT_ENDED = "guide-not-ended", WARNING, "", "the tip is still guided where the program ends"
    PROGRAM_WITHOUT_END = "program-without-end", NOTE, "", "nothing ends the program"
    START_THROUGH_PART = (
        "start-through-part",
        ERROR,
        "",
        "on its way to its first or from its last place the tool passes through the part",
    )
    STARTS_AT_REFERENCE = (
        "starts-at-reference",
        NOTE,
        "",
        "the program begins and ends at the reference point of Z",
    )

    # --------------------------------------------------------------------------- what the machine really does
    BOUND_OVER_TOLERANCE = (
        "bound-over-tolerance",
        WARNING,
        "mm",
        "the tolerance is held as measured, not as proven",
    )
    DEVIATION_OVER_TOLERANCE = "deviation-over-tolerance", ERROR, "mm", "a block leaves the commanded path"
    SINGULAR_BLOCK = (
        "singular-block",
        WARNING,
        "deg",
        "a block lies near the machine's pole: rotary axes swing",
    )
    TURNS_AT_POLE = (
        "turns-at-pole",
        NOTE,
        "deg",
        "a rotary axis turns while the tool stands at the machine's pole",
    )
    SO2008_NO_ROOT = "so2008-no-root", NOTE, "1", "the formula of So et al. has no root in these blocks"

    # ------------------------------------------------------------------------------ collisions and what stays
    AVOIDED_FACES_NEAR = (
        "avoided-faces-near",
        ERROR,
        "mm",
        "the tool comes nearer to faces to avoid than the allowance",
    )
    AVOIDED_FACES_UNPROVEN = (
        "avoided-faces-unproven",
        WARNING,
        "mm",
        "a rapid may come too near to the faces to avoid",
    )
    BURIED = "buried", ERROR, "1", "the whole cutter is inside the part"
    CUT_TOO_DEEP = "cut-too-deep", ERROR, "mm", "more than the tolerance is missing on the surface"
    FIXTURE_COLLISION = "fixture-collision", ERROR, "mm", "the tool hits a fixture"
    FIXTURE_IN_BODY = "fixture-in-body", WARNING, "mm", "a fixture stands in a body of the machine"
    FIXTURE_IN_PART = "fixture-in-part", ERROR, "", "a fixture stands in the part"
    FIXTURE_NEAR = "fixture-near", WARNING, "mm", "the tool comes nearer to a fixture than the clearance"
    FIXTURE_UNPROVEN = "fixture-unproven", WARNING, "mm", "a rapid may hit a fixture on some way of the axes"
    HOLDER_COLLISION = "holder-collision", ERROR, "mm", "shank or holder enters the part"
    INDEPENDENT_RAPID = (
        "independent-rapid",
        ERROR,
        "mm",
        "a rapid whose axes run independently enters the part",
    )
    MACHINE_COLLISION = (
        "machine-collision",
        ERROR,
        "mm",
        "tool, spindle or a body of the machine hits another one",
    )
    MACHINE_NEAR = (
        "machine-near",
        WARNING,
        "mm",
        "tool, spindle or a body of the machine comes nearer to another than the clearance",
    )
    MACHINE_TOUCHING = (
        "machine-touching",
        NOTE,
        "1",
        "bodies that touch at zero go no deeper into each other, or were not looked at",
    )
    MACHINE_UNPROVEN = "machine-unproven", WARNING, "mm", "a collision with the machine is not excluded"
    PART_IN_BODY = "part-in-body", WARNING, "mm", "the part stands in a body of the machine"
    OVERCUT = "overcut", ERROR, "mm", "the cutter enters the part in a feed move"
    RAPID_COLLISION = "rapid-collision", ERROR, "mm", "the cutter enters the part between passes"
    RAPID_UNPROVEN = "rapid-unproven", WARNING, "mm", "a rapid may enter the part on some way of the axes"
    TABLE_COLLISION = "table-collision", ERROR, "mm", "the tool goes below the machine's table"
    UNCUT = "uncut", WARNING, "mm2", "more than the scallop stays"
    UNCUT_AT_FIXTURE = "uncut-at-fixture", NOTE, "mm2", "of what stays a fixture keeps the tool off so much"
    UNCUT_AT_TABLE = "uncut-at-table", NOTE, "mm2", "of what stays the table keeps the tool off so much"
    UNCUT_TOO_TIGHT = "uncut-too-tight", NOTE, "mm2", "of what stays so much is tighter than the cutter"
    ADVICE = "advice", NOTE, "mm2", "what another setting would finish"

    # ------------------------------------------------------------------------------ NC programs that are read
    ARC_NOT_INTERPRETED = "arc-not-interpreted", ERROR, "", "arcs that the reader cannot follow"
    ARC_WITHOUT_CENTRE = "arc-without-centre", ERROR, "", "no circle fits the words of an arc"
    AXIS_NOT_REACHABLE = "axis-not-reachable", ERROR, "", "the machine cannot stand as the program commands"
    AXIS_RATE = "axis-rate", WARNING, "mm/min", "a block asks more of an axis than its maximum rate"
    BLOCK_SKIP = "block-skip", NOTE, "", "lines that a switch of the control skips"
    BORING_SHIFT = "boring-shift", NOTE, "", "the shift at the bottom of a boring cycle is not followed"
    CALL_NOT_INTERPRETED = (
        "call-not-interpreted",
        ERROR,
        "",
        "calls of other programs, whose moves are missing",
    )
    COMPENSATION_NOT_INTERPRETED = (
        "compensation-not-interpreted",
        ERROR,
        "",
        "cutter compensation in the control",
    )
    CORNER_NOT_INTERPRETED = "corner-not-interpreted", ERROR, "", "roundings, chamfers or angles of a contour"
    CUTTER_FROM_PROGRAM = "cutter-from-program", NOTE, "mm", "the cutter is that which the program names"
    CYCLE_NOT_INTERPRETED = "cycle-not-interpreted", ERROR, "", "cycles, whose moves are missing"
    DWELL = "dwell", NOTE, "", "dwells, whose time is not counted"
    DATUM_OF_TABLE = "datum-of-table", NOTE, "", "the work zero is a row of the control's table"
    FEED_BY_PARAMETER = "feed-by-parameter", WARNING, "", "a feed is given by a parameter or the tool"
    FEED_OVER_PART = (
        "feed-over-part",
        WARNING,
        "mm/min",
        "the tool moves over the part at another speed than F",
    )
    FEED_PER_TURN = (
        "feed-per-turn",
        WARNING,
        "",
        "feeds are for each turn of the spindle, so no time is given",
    )
    FEED_WORD_TOO_LARGE = "feed-word-too-large", WARNING, "", "F is larger than the controller takes"
    INVERSE_FEED_MISSING = "inverse-feed-missing", ERROR, "", "a block of inverse time has no F of its own"
    KINEMATICS_NOT_KNOWN = (
        "kinematics-not-known",
        ERROR,
        "",
        "the kinematics that the program switches to are not known",
    )
    KINEMATICS_NUMBER = (
        "kinematics-number",
        NOTE,
        "",
        "which kinematics a number switches to, as LinuxCNC counts",
    )
    MACHINE_POSITION = (
        "machine-position",
        WARNING,
        "",
        "moves to positions of the machine, which are not known",
    )
    FEED_FROM_MACHINE_POSITION = (
        "feed-from-machine-position",
        ERROR,
        "1",
        "a feed begins where an axis stands at a machine position that is not known",
    )
    MACRO_NOT_INTERPRETED = "macro-not-interpreted", ERROR, "", "variables, expressions or jumps"
    NO_DECIMAL_POINT = "no-decimal-point", NOTE, "", "words without a decimal point"
    NO_FEED = "no-feed", ERROR, "", "feed moves have no feed"
    NO_MOTION = "no-motion", NOTE, "", "an axis is passed over: the machine file says that it moves nothing"
    NO_MOTION_CODE = "no-motion-code", WARNING, "", "axis words under no motion code are taken as feed moves"
    NOT_NC_TEXT = "not-nc-text", NOTE, "", "parts of the file that are no NC text"
    OFFSET_NOT_INTERPRETED = "offset-not-interpreted", ERROR, "", "shifts, turns or scales of the coordinates"
    ORIENTATION_NOT_INTERPRETED = "orientation-not-interpreted", ERROR, "", "tool axes given by angles"
    OTHER_LANGUAGE = "other-language", NOTE, "", "the text is in another controller's language"
    PECK_CLEARANCE = "peck-clearance", NOTE, "", "how far a peck goes back is a setting of the control"
    PLANE_NOT_TAKEN = "plane-not-taken", ERROR, "", "the tool stands off the normal of its tilted plane"
    PLANE_SOLUTION = "plane-solution", NOTE, "", "the way to stand in a tilted plane that the control takes"
    POLAR_NOT_INTERPRETED = "polar-not-interpreted", ERROR, "", "polar coordinates, whose moves are missing"
    POSITION_UNKNOWN = "position-unknown", NOTE, "", "where an axis stands at the first motion is not said"
    READ_AS = "read-as", NOTE, "", "the controller whose language the text was read in"
    ROTARY_DIRECTION = "rotary-direction", WARNING, "", "the direction of a rotary axis hangs on a parameter"
    SPLINE_NOT_INTERPRETED = "spline-not-interpreted", ERROR, "", "splines, taken as straight to their ends"
    TEXT_AFTER_END = "text-after-end", NOTE, "", "what stands after the end is not read"
    TOOL_DELTA = "tool-delta", NOTE, "", "the tool differs from that of the control's table"
    UNITS_NOT_SAID = "units-not-said", WARNING, "", "neither mm nor inches are named"
    UNKNOWN_AXIS = "unknown-axis", ERROR, "", "words of an axis that the machine does not have"
    UNKNOWN_CODE = "unknown-code", WARNING, "", "a code that the reader does not know"
    WORD_NOT_INTERPRETED = "word-not-interpreted", WARNING, "", "words that the reader does not interpret"
    WORK_OFFSET_CHANGE = "work-offset-change", WARNING, "", "the work zero changes within the program"
    WRAP_CONTRADICTED = (
        "wrap-contradicted",
        WARNING,
        "",
        "the words of a rotary axis do not fit the way it wraps",
    )

    # ----------------------------------------------------------------------------- a program against its path
    AXIS_OFF_CL_PATH = "axis-off-cl-path", ERROR, "deg", "the tool axis differs from that of the path"
    BETWEEN_CL_ROWS = (
        "between-cl-rows",
        ERROR,
        "mm",
        "blocks leave the path between their ends, which lie on it",
    )
    CL_ROWS_MISSED = "cl-rows-missed", ERROR, "mm", "rows of the path that no block reaches"
    OFF_CL_PATH = "off-cl-path", ERROR, "mm", "blocks end off the path"
    WAY_NOT_IN_CL_PATH = (
        "way-not-in-cl-path",
        NOTE,
        "mm",
        "blocks leave the path and come back to it: ways of the post's own",
    )

    # ---------------------------------------------------------------------------------------- CL files
    ARC_DOES_NOT_FIT = "arc-does-not-fit", ERROR, "", "an arc does not pass through the points beside it"
    ARC_RUNS_BACK = "arc-runs-back", WARNING, "", "rows of an arc run against its sense"
    AXIS_CARRIED_ON = "axis-carried-on", WARNING, "", "moves without an axis keep the last one, which leans"
    AXIS_NOT_UNIT = "axis-not-unit", WARNING, "1", "tool axes were not of unit length"
    CUTTER_COMPENSATION = "cutter-compensation", ERROR, "", "the path counts on compensation in the control"
    CUTTER_DIFFERS = "cutter-differs", NOTE, "mm", "another cutter is used than the file names"
    CUTTER_FROM_CL_FILE = "cutter-from-cl-file", NOTE, "mm", "the cutter is that which the file names"
    CYCLE_DWELL_LEFT_OUT = "cycle-dwell-left-out", WARNING, "", "dwells of drilling cycles are left out"
    CYCLE_STEP_NOT_SAID = "cycle-step-not-said", WARNING, "", "a pecking cycle without its step"
    NO_HOLE_IN_CYCLE = "no-hole-in-cycle", ERROR, "", "a statement within a drilling cycle drills no hole"
    SEVERAL_COORDINATE_SYSTEMS = (
        "several-coordinate-systems",
        ERROR,
        "",
        "the file has several coordinate systems",
    )
    SEVERAL_TOOLS = (
        "several-tools",
        ERROR,
        "",
        "the file changes tools, and the program cuts all of it with one",
    )
    STATEMENT_NOT_INTERPRETED = (
        "statement-not-interpreted",
        WARNING,
        "",
        "statements that the reader does not interpret",
    )
    TOOL_CHOSEN = "tool-chosen", NOTE, "", "the tool that was taken of several"

    # ----------------------------------------------------------------------------- machines that are imported
    AXIS_ENDLESS = "axis-endless", NOTE, "", "the configuration gives a rotary axis no limits"
    AXIS_HELD = "axis-held", WARNING, "", "the kinematics move axes that a machine file cannot hold"
    BASE_FRAME_NOT_USED = (
        "base-frame-not-used",
        ERROR,
        "",
        "what the machine's file says of its base frame is not used",
    )
    CONSTANT_TOOL_OFFSET = "constant-tool-offset", WARNING, "", "a pin of the tool length is a constant"
    FORWARD_DIFFERS = "forward-differs", WARNING, "", "the control shows other positions than it drives"
    HAL_FILE_NOT_READ = "hal-file-not-read", NOTE, "", "a HAL file was not read"
    MACHINE_DEFAULT = "machine-default", NOTE, "", "what the machine's file does not say was taken as usual"
    MODEL_DIFFERS = "model-differs", WARNING, "mm", "the machine's model moves otherwise than its kinematics"
    MODEL_LEFT_OUT = "model-left-out", WARNING, "", "parts of the machine's model are not read"
    OFFSET_FROM_PANEL = "offset-from-panel", WARNING, "", "an offset is where a slider of the screen starts"
    OFFSET_NOT_SET = (
        "offset-not-set",
        WARNING,
        "",
        "no HAL file sets an offset, so LinuxCNC's own value is taken",
    )
    OFFSET_NOT_USED = "offset-not-used", WARNING, "", "an offset is set that the kinematics do not use"
    ROTARY_ASSUMED = "rotary-assumed", WARNING, "", "what carries a rotary axis is assumed"
    SIGN_UNPROVEN = "sign-unproven", WARNING, "", "the direction of an axis is not proven at the machine"
    TOOL_LENGTH_IN_W = "tool-length-in-w", NOTE, "", "the tool length turns with the head only as a W offset"

    # ---------------------------------------------------------------------------------------- calibration
    BLOCKS_WITHOUT_ROW = (
        "blocks-without-row",
        NOTE,
        "1",
        "blocks of the program that belong to no row of the path",
    )
    LAYOUT_NOT_DETERMINED = (
        "layout-not-determined",
        ERROR,
        "1",
        "other layouts of axes explain the rows as well",
    )
    LIMITS_UNKNOWN = "limits-unknown", NOTE, "", "limits and rates are assumed: no row tells them"
    MARK_NOT_GIVEN = "mark-not-given", WARNING, "mm", "how high part and clamps reach is not given"
    NOT_DETERMINED = "not-determined", ERROR, "", "the rows do not tell a dimension of the machine"
    POOR_FIT = "poor-fit", ERROR, "mm", "the rows are off the best machine by more than rounding"
    POST_AND_MACHINE_DIFFER = "post-and-machine-differ", ERROR, "", "the post had another machine in mind"
    ROWS_LEFT_OUT = "rows-left-out", WARNING, "1", "rows that do not fit the machine are left out"
    TOOL_LENGTH_INCLUDED = "tool-length-included", NOTE, "", "a pivot was found with the tool length in it"
    TURNS_AGAINST_ISO = "turns-against-iso", NOTE, "", "a rotary axis turns against ISO 841"
    UNCERTAIN = "uncertain", WARNING, "mm", "a dimension of the machine is certain within a range only"
    WRONG_SIGN_HARDLY_SEEN = "wrong-sign-hardly-seen", WARNING, "mm", "a wrong sign would hardly be seen"
    ZERO_ELSEWHERE = "zero-elsewhere", WARNING, "", "the program's zero is not that of the path or machine"
    ZEROS_ASSUMED = "zeros-assumed", NOTE, "", "zeros of rotary axes are taken as right"

    # ------------------------------------------------------------------------ where to clamp, and comparisons
    CANNOT_BE_COMPARED = "cannot-be-compared", ERROR, "", "a machine on which the path cannot be driven"
    NO_SETUP_FREE = (
        "no-setup-free",
        ERROR,
        "mm",
        "in all setups that were tried the machine is hit",
    )
    JAWS_FREE = "jaws-free", NOTE, "mm", "how high the jaws of a vise may reach beside the part"
    NO_STICK_OUT_FREE = (
        "no-stick-out-free",
        WARNING,
        "mm",
        "no stick-out of the tool within reason keeps the holder free",
    )
    NO_SETUP_ON_THE_TABLE = "no-setup-on-the-table", ERROR, "", "no position on the table is free"
    NO_SETUP_WITHIN_LIMITS = (
        "no-setup-within-limits",
        ERROR,
        "mm",
        "no position keeps the axes within their limits",
    )
    SETUP_AT_EDGE = "setup-at-edge", NOTE, "1", "the best position lies at the edge of the region"
    SETUPS_HIT_MACHINE = (
        "setups-hit-machine",
        NOTE,
        "1",
        "setups are passed over: the machine is hit there",
    )
    STICK_OUT_ENOUGH = "stick-out-enough", NOTE, "mm", "the shortest stick-out with which the holder is free"
    STICK_OUT_TOO_SHORT = (
        "stick-out-too-short",
        WARNING,
        "mm",
        "the tool must stick out farther, so that the holder is free",
    )
    TABLE_UNKNOWN = "table-unknown", WARNING, "", "where the table is, is not known"
    TURN_OUT_OF_REACH = (
        "turn-out-of-reach",
        WARNING,
        "deg",
        "with the part turned the rotary limits allow no way",
    )
