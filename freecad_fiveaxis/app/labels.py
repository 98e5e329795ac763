# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words beside the fields: one for each option of the core's settings, for each choice, and for each
controller."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.sentences import Choice, Option, Task

from .option_texts import text_of

translate = FreeCAD.Qt.translate


def option_label(name: str) -> str:
    """Return what stands beside the field of an option; an option that is new says its own name."""
    return _options().get(name) or name.replace("_", " ").capitalize()


def option_hint(leaf: Any) -> str:
    """Return what an option is for, as the property editor says it too."""
    text: str = translate("App::Property", text_of(leaf))
    return text


def choice_label(name: str) -> str:
    """Return what a choice is called in a list; one that is new says its own name."""
    return _choices().get(name) or name.replace("_", " ")


def choice_hint(option: str, choice: str) -> str:
    """Return what a choice of an option does, in a sentence; empty where its name says it."""
    return _choice_hints().get((option, choice), "")


def name_of(named: Option | Choice | Task) -> str:
    """Return what the window calls a setting, choices of one, or a task that a sentence of the core names."""
    if isinstance(named, Task):
        return _tasks().get(named.name) or str(named)
    if isinstance(named, Option):
        return option_label(named.name)
    choices = ", ".join(
        cure_label(one) if named.option == "cures" else choice_label(one) for one in named.choices
    )
    return choices if named.alone else f"{option_label(named.option)}: {choices}"


def cure_label(cure: str) -> str:
    """Return what a correction is called in a comparison, where no field says of what it is a choice."""
    own = {
        "none": translate("FiveAxis", "none"),
        "deform": translate("FiveAxis", "turn the axis past the pole"),
    }
    return own.get(cure) or choice_label(cure)


def group_label(name: str) -> str:
    """Return the title of a group of options in a panel, by its name in the property editor."""
    return _groups().get(name) or translate("App::Property", name)


def controller_label(name: str) -> str:
    """Return what a controller is called in a list; one that is new says its own name."""
    return _controllers().get(name) or name


def _controllers() -> dict[str, str]:
    return {
        "linuxcnc": "LinuxCNC",
        "fanuc": "Fanuc",
        "haas": "Haas",
        "siemens840d": "Siemens 840D",
        "heidenhain": "Heidenhain TNC (TCPM)",
        "heidenhain_m128": "Heidenhain iTNC (M128)",
        "mach3": "Mach3, Mach4",
        "grbl": translate("FiveAxis", "grbl with five axes"),
    }


def _tasks() -> dict[str, str]:
    """Tasks of the core, as the workbench's commands name them."""
    return {
        "mill": translate("FiveAxis", "“Tool path”"),
        "post": translate("FiveAxis", "“Post-process”"),
        "setup": translate("FiveAxis", "“Where to clamp”"),
        "recover": translate("FiveAxis", "“Recover a machine from a program”"),
        "prove-signs": translate("FiveAxis", "“Prove the signs”"),
        "machines": translate("FiveAxis", "the list of machines"),
        "audit": translate("FiveAxis", "“Audit an NC file”"),
        "run": translate("FiveAxis", "the command line"),
    }


def _options() -> dict[str, str]:
    return _of_passes() | _of_programs() | _of_machines_and_places() | _of_the_machine_editor()


def _of_passes() -> dict[str, str]:
    """Options of where passes lie."""
    return {
        "passes": translate("FiveAxis", "Pass strategy"),
        "plane_normal": translate("FiveAxis", "Normal of the planes I, J, K"),
        "from_": translate("FiveAxis", "Passes begin at"),
        "to": translate("FiveAxis", "Passes end at"),
        "pass_centre": translate("FiveAxis", "Centre of passes"),
        "pass_axis": translate("FiveAxis", "Axis of passes I, J, K"),
        "rotary_by": translate("FiveAxis", "Rotary passes"),
        "frames": translate("FiveAxis", "Frames at most"),
        "within_frames": translate("FiveAxis", "Passes in each frame"),
        "direction": translate("FiveAxis", "Direction of passes"),
        "scallop": translate("FiveAxis", "Scallop height"),
        "stepover": translate("FiveAxis", "Stepover"),
        "least_interval": translate("FiveAxis", "Smallest stepover"),
        "steep_shallow": translate("FiveAxis", "Steep from"),
        "max_axis_angle": translate("FiveAxis", "Steepest surface"),
        "avoid": translate("FiveAxis", "Faces to leave alone"),
        "stl_units": translate("FiveAxis", "Units of STL files"),
        "avoid_allowance": translate("FiveAxis", "Allowance on faces to avoid"),
        "boundary": translate("FiveAxis", "Boundary"),
        "boundary_axis": translate("FiveAxis", "Axis of the boundary I, J, K"),
        "boundary_by": translate("FiveAxis", "Boundary holds"),
    }


def _of_programs() -> dict[str, str]:
    """Options of making and proving a program."""
    return {
        "cutter": translate("FiveAxis", "Cutter"),
        "coedge_tolerance": translate("FiveAxis", "Edge tolerance"),
        "tool_axis": translate("FiveAxis", "Tool axis"),
        "axis": translate("FiveAxis", "Fixed axis I, J, K"),
        "lead": translate("FiveAxis", "Lead"),
        "tilt": translate("FiveAxis", "Tilt"),
        "max_tilt": translate("FiveAxis", "Largest axis angle"),
        "order": translate("FiveAxis", "Cut pattern"),
        "spiral": translate("FiveAxis", "Spiral passes"),
        "links": translate("FiveAxis", "Links"),
        "clearance": translate("FiveAxis", "Clearance"),
        "lead_in": translate("FiveAxis", "Lead-in radius"),
        "table_height": translate("FiveAxis", "Height of the table"),
        "feed": translate("FiveAxis", "Feed"),
        "plunge_feed": translate("FiveAxis", "Plunge feed"),
        "feed_mode": translate("FiveAxis", "Feed mode"),
        "tool": translate("FiveAxis", "Tool number"),
        "spindle": translate("FiveAxis", "Spindle speed"),
        "coolant": translate("FiveAxis", "Coolant"),
        "work_offset": translate("FiveAxis", "Work offset"),
        "blend": translate("FiveAxis", "Corner rounding"),
        "rtcp": translate("FiveAxis", "Tip guided (RTCP)"),
        "high_speed": translate("FiveAxis", "High-speed mode"),
        "nc_units": translate("FiveAxis", "Units of the program"),
        "machine": translate("FiveAxis", "Machine"),
        "controller": translate("FiveAxis", "Controller"),
        "origin": translate("FiveAxis", "Work zero on the machine"),
        "tool_length": translate("FiveAxis", "Tool length"),
        "rapids": translate("FiveAxis", "Rapids"),
        "control_point": translate("FiveAxis", "Programmed point"),
        "gouge": translate("FiveAxis", "Gouge protection"),
        "shank": translate("FiveAxis", "Shank, Ø x length"),
        "holder": translate("FiveAxis", "Holder, Ø x length"),
        "advise": translate("FiveAxis", "Advice"),
        "fixture": translate("FiveAxis", "Fixtures"),
        "fixtures": translate("FiveAxis", "Fixtures"),
        "fixture_clearance": translate("FiveAxis", "Clearance to fixtures"),
        "rest": translate("FiveAxis", "Rest material"),
        "linearize": translate("FiveAxis", "Divide blocks"),
        "singularity": translate("FiveAxis", "Near the pole"),
        "max_axis_change": translate("FiveAxis", "Largest axis change"),
        "tolerance": translate("FiveAxis", "Tolerance"),
        "against": translate("FiveAxis", "Compare with a file"),
        "units": translate("FiveAxis", "Units"),
        "cl_tool": translate("FiveAxis", "Tool of the CL file"),
        "decimal": translate("FiveAxis", "Words without a decimal point"),
        "search": translate("FiveAxis", "Folder of called programs"),
        "axis_tolerance": translate("FiveAxis", "Axis tolerance"),
        "method": translate("FiveAxis", "Line deviation by"),
        "region": translate("FiveAxis", "Room for the work zero"),
        "grid": translate("FiveAxis", "Places on the map"),
        "turns": translate("FiveAxis", "Turns of the part"),
        "jaw_thickness": translate("FiveAxis", "Thickness of the jaws"),
        "machines": translate("FiveAxis", "Machines"),
        "cures": translate("FiveAxis", "Corrections"),
    }


def _of_machines_and_places() -> dict[str, str]:
    """Options about a machine itself, and the fields of panels that are no options of the core."""
    return {
        "program": translate("FiveAxis", "NC file"),
        "machine_file": translate("FiveAxis", "Machine file to write"),
        "certainty": translate("FiveAxis", "Certain within"),
        "mark": translate("FiveAxis", "Mark"),
        "gap": translate("FiveAxis", "Gap above the mark"),
        "travel": translate("FiveAxis", "Way of X, Y, Z"),
        "angle": translate("FiveAxis", "Turn of each axis"),
        "slow_feed": translate("FiveAxis", "Slow feed"),
        "cl_file": translate("FiveAxis", "CL file"),
        "sheet": translate("FiveAxis", "Sheet to print"),
        "source": translate("FiveAxis", "File to import"),
        "bodies": translate("FiveAxis", "Model with bodies"),
        "linear_deflection": translate("FiveAxis", "Mesh deflection"),
        "angular_deflection": translate("FiveAxis", "Mesh angle"),
        "setup": translate("FiveAxis", "Setup"),
        "setup_name": translate("FiveAxis", "Name"),
        "work_zero": translate("FiveAxis", "Work zero"),
        "largest_axis_angle": translate("FiveAxis", "Largest axis angle"),
        "spacing": translate("FiveAxis", "Spacing by"),
        "spacing_kind": translate("FiveAxis", "Spacing by"),
        "cutter_kind": translate("FiveAxis", "Cutter"),
        "cutter_diameter": translate("FiveAxis", "Diameter"),
        "cutter_corner": translate("FiveAxis", "Corner radius"),
        "cutter_taper": translate("FiveAxis", "Taper, each side"),
        "cutter_neck": translate("FiveAxis", "Neck diameter"),
        "cutter_flank": translate("FiveAxis", "Flank radius"),
        "cutter_length": translate("FiveAxis", "Cutting length"),
        "nc_file": translate("FiveAxis", "NC file"),
        "nc_path": translate("FiveAxis", "NC file"),
        "part": translate("FiveAxis", "Part in the document"),
    }


def _of_the_machine_editor() -> dict[str, str]:
    return {
        "start_from": translate("FiveAxis", "Start from"),
        "machine_name": translate("FiveAxis", "Name"),
        "machine_description": translate("FiveAxis", "Description"),
        "machine_controller": translate("FiveAxis", "Controller"),
        "gauge_point": translate("FiveAxis", "Gauge point"),
        "machine_origin": translate("FiveAxis", "Work zero on the machine"),
        "table_height": translate("FiveAxis", "Height of the table's face"),
        "axis_letter": translate("FiveAxis", "Letter"),
        "axis_side": translate("FiveAxis", "Carries"),
        "axis_direction": translate("FiveAxis", "Direction"),
        "axis_point": translate("FiveAxis", "Point of the axis"),
        "axis_low": translate("FiveAxis", "Lower limit"),
        "axis_high": translate("FiveAxis", "Upper limit"),
        "axis_rate": translate("FiveAxis", "Largest rate"),
        "axis_acceleration": translate("FiveAxis", "Largest acceleration"),
        "body_name": translate("FiveAxis", "Name"),
        "body_carrier": translate("FiveAxis", "Carried by"),
        "body_low": translate("FiveAxis", "Low end"),
        "body_high": translate("FiveAxis", "High end"),
        "body_centre": translate("FiveAxis", "Centre"),
        "body_radius": translate("FiveAxis", "Radius"),
        "body_low_radius": translate("FiveAxis", "Radius at the low end"),
        "body_high_radius": translate("FiveAxis", "Radius at the high end"),
        "body_file": translate("FiveAxis", "STL file"),
        "body_clearance": translate("FiveAxis", "Clearance"),
        "attach_carrier": translate("FiveAxis", "To be carried by"),
        "machine_zero": translate("FiveAxis", "Machine's zero in the document"),
        "attach_deviation": translate("FiveAxis", "Deviation of facets"),
    }


def _choices() -> dict[str, str]:
    return {
        "planes": translate("FiveAxis", "parallel planes"),
        "morph": translate("FiveAxis", "morph between two curves"),
        "radial": translate("FiveAxis", "radial about an axis"),
        "rotary": translate("FiveAxis", "rotary: the part turns under the tool"),
        "around": translate("FiveAxis", "around the axis"),
        "along": translate("FiveAxis", "along the axis"),
        "frames": translate("FiveAxis", "frames with locked rotary axes (3+2)"),
        "zlevel": translate("FiveAxis", "level planes"),
        "facet_mean": translate("FiveAxis", "surface normal"),
        "face_normal": translate("FiveAxis", "face normal, turning at edges"),
        "step_weighted": translate("FiveAxis", "normal weighted by step"),
        "minimax": translate("FiveAxis", "least deviation (minimax)"),
        "auto": translate("FiveAxis", "free of the part (auto)"),
        "fixed": translate("FiveAxis", "fixed axis"),
        "from_axis": translate("FiveAxis", "away from the rotary axis"),
        "zigzag": translate("FiveAxis", "zigzag"),
        "one_way": translate("FiveAxis", "one way"),
        "near": translate("FiveAxis", "near the part where free"),
        "machine": translate("FiveAxis", "the machine's own"),
        "interpolated": translate("FiveAxis", "in proportion"),
        "independent": translate("FiveAxis", "each axis alone"),
        "unknown": translate("FiveAxis", "not known"),
        "over": translate("FiveAxis", "always over the part"),
        "g93": translate("FiveAxis", "inverse time (G93)"),
        "g94": translate("FiveAxis", "per minute (G94)"),
        "report": translate("FiveAxis", "only report"),
        "linearize": translate("FiveAxis", "divide blocks"),
        "on": translate("FiveAxis", "on"),
        "off": translate("FiveAxis", "off"),
        "deform": translate("FiveAxis", "turn the axis past it"),
        "angles": translate("FiveAxis", "by rotary axes"),
        "vectors": translate("FiveAxis", "by tool vectors"),
        "tip": translate("FiveAxis", "tip"),
        "centre": translate("FiveAxis", "centre of corner radius"),
        "contact": translate("FiveAxis", "contact"),
        "lift": translate("FiveAxis", "lift the tool"),
        "tilt": translate("FiveAxis", "tilt the tool"),
        "leave-out": translate("FiveAxis", "skip these places"),
        "ball": translate("FiveAxis", "ball end mill"),
        "flat": translate("FiveAxis", "flat end mill"),
        "bull": translate("FiveAxis", "bull nose mill"),
        "taperball": translate("FiveAxis", "tapered ball"),
        "taperbull": translate("FiveAxis", "tapered bull nose"),
        "lollipop": translate("FiveAxis", "lollipop"),
        "barrel": translate("FiveAxis", "barrel"),
        "exact": translate("FiveAxis", "exact"),
        "so2008": translate("FiveAxis", "model of So et al. 2008"),
        "so2008-printed": translate("FiveAxis", "model of So et al. 2008 as printed"),
        "scallop": translate("FiveAxis", "constant scallop"),
        "file": translate("FiveAxis", "as the file says"),
        "mm": translate("FiveAxis", "mm"),
        "cm": translate("FiveAxis", "cm"),
        "m": translate("FiveAxis", "m"),
        "inch": translate("FiveAxis", "inch"),
        "calculator": translate("FiveAxis", "as they stand"),
        "least-increment": translate("FiveAxis", "least increment"),
    }


def _choice_hints() -> dict[tuple[str, str], str]:
    return _of_safety() | {
        ("tool_axis", "facet_mean"): translate(
            "FiveAxis", "The tool stands normal to the surface, leaned by lead and tilt."
        ),
        ("tool_axis", "face_normal"): translate(
            "FiveAxis",
            "The tool stands normal to each face up to its edges and turns over a sharp edge on the spot: a "
            "level bottom finishes plane faces.",
        ),
        ("tool_axis", "step_weighted"): translate(
            "FiveAxis", "Between two facets the axis turns evenly over the steps on either side (Lin and Ye)."
        ),
        ("tool_axis", "minimax"): translate(
            "FiveAxis",
            "The axis that makes the deviation of this machine smallest, within the largest axis angle; "
            "takes long.",
        ),
        ("tool_axis", "auto"): translate(
            "FiveAxis",
            "The axis that keeps cutter, shank and holder out of the part and turns smoothly over the "
            "surface.",
        ),
        ("tool_axis", "fixed"): translate(
            "FiveAxis", "One axis everywhere: three-axis milling, or 3 + 2 with a tilted axis."
        ),
        ("tool_axis", "from_axis"): translate(
            "FiveAxis", "Square to the rotary axis and pointing at it, as the part turns."
        ),
        ("rtcp", "off"): translate(
            "FiveAxis", "The program gives the positions of all axes; any controller can run it."
        ),
        ("rtcp", "angles"): translate(
            "FiveAxis", "The controller guides the tip; the program gives the rotary axes."
        ),
        ("rtcp", "vectors"): translate(
            "FiveAxis", "The controller guides the tip; the program gives the tool axis as a vector."
        ),
    }


def _of_safety() -> dict[tuple[str, str], str]:
    return {
        ("gouge", "off"): translate("FiveAxis", "Nothing is checked: the tool may enter the part."),
        ("gouge", "report"): translate(
            "FiveAxis", "Places where the tool enters the part are listed; the path stays as it is."
        ),
        ("gouge", "lift"): translate(
            "FiveAxis", "The tool is lifted along its axis until nothing enters the part."
        ),
        ("gouge", "tilt"): translate(
            "FiveAxis",
            "The tool is tilted until shank and holder are free; where the cutter still enters, it is "
            "lifted.",
        ),
        ("gouge", "leave-out"): translate(
            "FiveAxis", "Places where the tool would enter the part are not machined."
        ),
        ("singularity", "report"): translate(
            "FiveAxis", "Blocks near the pole are listed; the path stays as it is."
        ),
        ("singularity", "linearize"): translate(
            "FiveAxis", "Blocks near the pole that are over tolerance are divided."
        ),
        ("singularity", "deform"): translate(
            "FiveAxis", "The tool axis is turned by a few degrees, so that it passes beside the pole."
        ),
    }


def _groups() -> dict[str, str]:
    """Return groups that no property editor shows, or not by a name for a panel."""
    return {
        "Compare": translate("FiveAxis", "Comparison"),
        "Recover": translate("FiveAxis", "Recover"),
        "Prove": translate("FiveAxis", "Moves"),
    }
