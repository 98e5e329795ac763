# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each option is for, as the window says it: the tool tips of the panels and the texts of the property
editor.

The command line has help of its own (core/pipeline/settings/groups.py), with its names and ways of writing
values. An option that is not here shows that help.
"""

from __future__ import annotations

from typing import Any


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text for the translators; FreeCAD itself translates the documentation of properties when it
    shows them."""
    return text


TEXTS = {
    "passes": QT_TRANSLATE_NOOP("App::Property", "How the passes are laid over the part"),
    "plane_normal": QT_TRANSLATE_NOOP(
        "App::Property",
        "Direction I, J, K across the planes of the passes; 0, 0, 0: upright planes along the direction"
    ),
    "from_": QT_TRANSLATE_NOOP(
        "App::Property",
        "Where constant-scallop and morph passes begin: border (of the region), X,Y,Z of a point, or a CSV "
        "file with the points of a curve (or these, a ; between two)",
    ),
    "to": QT_TRANSLATE_NOOP(
        "App::Property",
        "Where morph passes end: border (of the region), X,Y,Z of a point, or a CSV file with the points of "
        "a curve (or these, a ; between two)",
    ),
    "pass_centre": QT_TRANSLATE_NOOP(
        "App::Property",
        "Point of the axis that radial passes radiate from and rotary ones turn about: X,Y,Z, or middle (of "
        "what is cut; rotary: of the machine's only rotary axis, else of the part)",
    ),
    "pass_axis": QT_TRANSLATE_NOOP(
        "App::Property",
        "Direction I, J, K of the axis of radial and rotary passes; 0, 0, 0: Z; rotary: the machine's only "
        "rotary axis, else the part's longest side",
    ),
    "rotary_by": QT_TRANSLATE_NOOP(
        "App::Property", "Rings around the rotary axis, which spiral passes make one helix, or lines along it"
    ),
    "within_frames": QT_TRANSLATE_NOOP(
        "App::Property",
        "Constant scallop in each frame, or planes along the frame's axis and the direction of passes"
    ),
    "boundary": QT_TRANSLATE_NOOP(
        "App::Property",
        "CSV file of closed curves at which the passes end: X,Y,Z in mm a line, in the frame of the work "
        "zero, a blank line between two (or the lines themselves, a ; between two)",
    ),
    "boundary_axis": QT_TRANSLATE_NOOP("App::Property", "Direction I, J, K along which the boundary is seen"),
    "boundary_by": QT_TRANSLATE_NOOP("App::Property", "What stays inside the boundary: the contact, or the "
        "cutter's centre"),
    "avoid_allowance": QT_TRANSLATE_NOOP(
        "App::Property",
        "How far cutter, shank and holder keep off the faces that are left alone; 0: they may touch them"
    ),
    "advise": QT_TRANSLATE_NOOP("App::Property", "Where something stays unfinished, try what would finish "
        "more, and name it"),
    "frames": QT_TRANSLATE_NOOP(
        "App::Property",
        "Most positions in which the rotary axes are locked while passes are cut, 1 to 12: as many as are "
        "worth it",
    ),
    "direction": QT_TRANSLATE_NOOP("App::Property", "Angle of the passes to the X axis, counter-clockwise "
        "seen from above"),
    "scallop": QT_TRANSLATE_NOOP("App::Property", "Largest height of the ridges that stay between two "
        "passes"),
    "stepover": QT_TRANSLATE_NOOP("App::Property", "Constant distance of the passes, instead of a scallop "
        "height"),
    "least_interval": QT_TRANSLATE_NOOP("App::Property", "Passes come no closer than this, also on steep "
        "walls"),
    "steep_shallow": QT_TRANSLATE_NOOP(
        "App::Property",
        "Where the surface is steeper than this from the horizontal, level planes are cut instead of the "
        "passes chosen; 0: nowhere",
    ),
    "max_axis_angle": QT_TRANSLATE_NOOP(
        "App::Property",
        "Surfaces steeper than this are not machined; with auto no tool axis leans more. 0: 90 deg; with "
        "auto all that the machine reaches above its table",
    ),
    "cutter": QT_TRANSLATE_NOOP("App::Property", "Shape and sizes of the cutter"),
    "coedge_tolerance": QT_TRANSLATE_NOOP(
        "App::Property",
        "Largest distance between cutter and a convex edge; beyond it the tool rolls around the edge in an "
        "arc"
    ),
    "tool_axis": QT_TRANSLATE_NOOP("App::Property", "How the tool axis is found at each contact point"),
    "axis": QT_TRANSLATE_NOOP("App::Property", "Direction I, J, K of the fixed tool axis, from the tip to "
        "the holder"),
    "lead": QT_TRANSLATE_NOOP("App::Property", "Lead angle: how far the tool leans in the feed direction; "
        "above 0 its top goes ahead of its tip"),
    "tilt": QT_TRANSLATE_NOOP("App::Property", "Tilt angle: how far the tool leans across the feed "
        "direction; above 0 its top stands to the right of the feed"),
    "max_tilt": QT_TRANSLATE_NOOP(
        "App::Property",
        "How far the tool axis may leave the surface normal, for the least deviation or to keep out of the "
        "part"
    ),
    "order": QT_TRANSLATE_NOOP("App::Property", "Zigzag cuts in both directions, one way in one direction "
        "only"),
    "spiral": QT_TRANSLATE_NOOP(
        "App::Property", "Closed passes round one another become one long pass, without links between them"
    ),
    "links": QT_TRANSLATE_NOOP(
        "App::Property",
        "How the tool goes from one pass to the next: near the part where it is free, or over it"
    ),
    "clearance": QT_TRANSLATE_NOOP("App::Property", "Rapid moves stay this far off the part's bounding box"),
    "lead_in": QT_TRANSLATE_NOOP(
        "App::Property",
        "Radius of the arc tangent to the surface on which the tool enters and leaves a pass; 0: along its "
        "axis"
    ),
    "feed": QT_TRANSLATE_NOOP(
        "App::Property", "Feed rate of the tip over the part"
    ),
    "plunge_feed": QT_TRANSLATE_NOOP(
        "App::Property", "Feed rate of the approach to the part"
    ),
    "feed_mode": QT_TRANSLATE_NOOP("App::Property", "F words as inverse time (G93), or as feed per minute "
        "(G94)"),
    "tool": QT_TRANSLATE_NOOP(
        "App::Property",
        "Number of the tool; not given: the program calls no tool, the operator sets tool and length"
    ),
    "spindle": QT_TRANSLATE_NOOP("App::Property", "Spindle speed, 1/min; not given (0): the program does not "
        "start the spindle"),
    "coolant": QT_TRANSLATE_NOOP("App::Property", "Coolant on while the program runs"),
    "work_offset": QT_TRANSLATE_NOOP(
        "App::Property", "Work offset: G54 to G59; LinuxCNC also G59.1 to G59.3, Fanuc also G54.1 P1 to P300"
    ),
    "rtcp": QT_TRANSLATE_NOOP(
        "App::Property",
        "Tool centre point control (RTCP, TCPM, TRAORI): the controller guides the tip itself; off: the "
        "program gives the positions of all axes",
    ),
    "nc_units": QT_TRANSLATE_NOOP(
        "App::Property",
        "Units of lengths and feeds in the NC file; machine: as the machine file says, else mm",
    ),
    "high_speed": QT_TRANSLATE_NOOP(
        "App::Property", "High-speed mode of the controller, with the tolerance given as corner rounding"
    ),
    "blend": QT_TRANSLATE_NOOP("App::Property", "How far the controller may round corners, where it can; 0: "
        "exact path"),
    "machine": QT_TRANSLATE_NOOP("App::Property", "A machine that comes with the workbench, or a machine "
        "file (.fcm)"),
    "controller": QT_TRANSLATE_NOOP("App::Property", "Controller that the NC file is written for"),
    "origin": QT_TRANSLATE_NOOP("App::Property", "Where the work zero stands in the machine's coordinates"),
    "tool_length": QT_TRANSLATE_NOOP(
        "App::Property", "From the spindle's gauge point to the tip; machines with a rotary head need it"
    ),
    "rapids": QT_TRANSLATE_NOOP(
        "App::Property",
        "How the controller drives its axes in a rapid: all together, each at its own rate, or unknown; "
        "machine: as the machine file says",
    ),
    "control_point": QT_TRANSLATE_NOOP(
        "App::Property",
        "Point of the tool that the program moves: the tip, or the centre of the corner radius"
    ),
    "linearize": QT_TRANSLATE_NOOP(
        "App::Property", "Divide blocks that deviate by more than the tolerance, into as few as keep it"
    ),
    "singularity": QT_TRANSLATE_NOOP(
        "App::Property", "What to do near the pole, where a rotary axis turns far to lean the tool a little"
    ),
    "max_axis_change": QT_TRANSLATE_NOOP("App::Property", "Largest change of the tool axis where it is "
        "turned to pass the pole"),
    "gouge": QT_TRANSLATE_NOOP("App::Property", "What to do where cutter, shank or holder would enter the "
        "part"),
    "shank": QT_TRANSLATE_NOOP(
        "App::Property", "Cylinders above the cutter, from below: diameter x length in mm, as 8x20,12x30"
    ),
    "holder": QT_TRANSLATE_NOOP(
        "App::Property",
        "Cylinders of the holder above cutter and shank, from below: diameter x length in mm, as 40x25,63x50"
    ),
    "fixture_clearance": QT_TRANSLATE_NOOP(
        "App::Property",
        "How near the tool may come to fixtures and bodies of the machine before that is told"
    ),
    "rest": QT_TRANSLATE_NOOP("App::Property", "Find the rest material and the overcut on the machined "
        "surface"),
    "tolerance": QT_TRANSLATE_NOOP("App::Property", "Largest deviation of the tip from the programmed line"),
    "method": QT_TRANSLATE_NOOP(
        "App::Property",
        "How the deviation from the line is computed: exactly, or by the model of So et al. 2008"
    ),
    "region": QT_TRANSLATE_NOOP("App::Property", "How far the work zero may move to either side along X, Y, "
        "Z; 0: it stays"),
    "grid": QT_TRANSLATE_NOOP("App::Property", "How many places along X, Y, Z the map shows"),
    "mark": QT_TRANSLATE_NOOP("App::Property", "X,Y,Z over the work zero of a place to mark, as high as part "
        "and clamps reach"),
    "table_height": QT_TRANSLATE_NOOP(
        "App::Property",
        "Height of the table's face in the machine's coordinates; empty: that of the machine's file"
    ),
    "turns": QT_TRANSLATE_NOOP(
        "App::Property", "How many turns of the part about Z are tried, evenly over 360°; 1: as it stands"
    ),
    "jaw_thickness": QT_TRANSLATE_NOOP(
        "App::Property", "How thick the jaws of a vise are of which is told how high they may reach"
    ),
    "certainty": QT_TRANSLATE_NOOP(
        "App::Property",
        "How certain the offsets should be, and how near to those of the machine they are compared with"
    ),
    "against": QT_TRANSLATE_NOOP("App::Property", "CL file (.apt, .cl) or part (.stl) that the program is "
        "compared with"),
    "units": QT_TRANSLATE_NOOP("App::Property", "Units of a program that does not say them itself"),
    "cl_tool": QT_TRANSLATE_NOOP("App::Property", "Number of the CL file's tool whose moves are meant; "
        "empty: all"),
    "decimal": QT_TRANSLATE_NOOP("App::Property", "What a word without a decimal point counts: X100 is 100 "
        "mm, or 0.1 mm"),
    "axis_tolerance": QT_TRANSLATE_NOOP(
        "App::Property", "Largest angle between the tool axis and that of the CL file at the end of a block"
    ),
}  # fmt: skip
"""By the option's name."""


def text_of(leaf: Any) -> str:
    """Return what an option (a field of the core's settings) is for."""
    return TEXTS.get(leaf.name) or str(leaf.metadata["text"])


EDITOR = {
    "passes": QT_TRANSLATE_NOOP(
        "App::Property",
        "Pass strategy. planes: parallel planes; zlevel: level planes; scallop: constant scallop; morph: "
        "from one guide curve to another; radial: about an axis; rotary: around or along an axis about "
        "which the part turns; frames: constant scallop in few positions of locked rotary axes"
    ),
    "tool_axis": QT_TRANSLATE_NOOP(
        "App::Property",
        "How the tool axis is found at each contact point. facet_mean: surface normal; face_normal: "
        "normal to each face, turning at its edges; step_weighted: normal weighted by the step; "
        "minimax: least deviation; auto: free of the part; fixed: one axis everywhere; from_axis: square to "
        "the rotary axis and pointing at it",
    ),
    "order": QT_TRANSLATE_NOOP(
        "App::Property", "Cut pattern. zigzag: in both directions; one_way: in one direction only"
    ),
    "feed_mode": QT_TRANSLATE_NOOP("App::Property", "What F means. g93: inverse time; g94: feed per minute"),
    "blend": QT_TRANSLATE_NOOP(
        "App::Property",
        "Corner rounding: how far the controller may round corners, where it can; 0: exact path"
    ),
    "controller": QT_TRANSLATE_NOOP(
        "App::Property",
        "Controller that the NC file is written for. machine's own: the one that the machine's file names"
    ),
}  # fmt: skip
"""By the option's name, what the property editor says where it shows names of its own: FreeCAD translates no
choices there."""


def editor_text(leaf: Any) -> str:
    """Return what an option is for, and what its choices mean, as the property editor says it."""
    return EDITOR.get(leaf.name) or text_of(leaf)
