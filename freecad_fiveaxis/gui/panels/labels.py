# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words beside the fields: one for each option of the core's settings, for each choice, and for each controller."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import translate


def option_label(name: str) -> str:
    """What stands beside the field of an option; an option that is new says its own name."""
    return _options().get(name) or name.replace("_", " ").capitalize()


def option_hint(leaf: Any) -> str:
    """What an option is for: the help of its field in the core's settings, as the property editor says it too."""
    return translate("App::Property", leaf.metadata["text"])


def choice_label(name: str) -> str:
    """What a choice is called in a list; one that is new says its own name."""
    return _choices().get(name) or name.replace("_", " ")


def group_label(name: str) -> str:
    """The title of a group of options, by the name of its settings class."""
    return _groups().get(name) or name.replace("Settings", "")


def controller_label(name: str) -> str:
    """What a controller is called in a list; one that is new says its own name."""
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


def _options() -> dict[str, str]:
    return _of_programs() | _of_machines_and_places()


def _of_programs() -> dict[str, str]:
    """Options of making and proving a program."""
    return {
        "direction": translate("FiveAxis", "Direction of passes"),
        "scallop": translate("FiveAxis", "Scallop"),
        "stepover": translate("FiveAxis", "Stepover"),
        "least_interval": translate("FiveAxis", "Least interval"),
        "max_axis_angle": translate("FiveAxis", "Steepest facet"),
        "cutter": translate("FiveAxis", "Cutter"),
        "coedge_tolerance": translate("FiveAxis", "Edge tolerance"),
        "tool_axis": translate("FiveAxis", "Tool axis"),
        "axis": translate("FiveAxis", "Fixed axis I, J, K"),
        "lead": translate("FiveAxis", "Lead"),
        "tilt": translate("FiveAxis", "Tilt"),
        "max_tilt": translate("FiveAxis", "Largest tilt"),
        "order": translate("FiveAxis", "Order"),
        "clearance": translate("FiveAxis", "Clearance"),
        "feed": translate("FiveAxis", "Feed"),
        "plunge_feed": translate("FiveAxis", "Plunge feed"),
        "feed_mode": translate("FiveAxis", "Feed mode"),
        "tool": translate("FiveAxis", "Tool number"),
        "spindle": translate("FiveAxis", "Spindle, 1/min"),
        "coolant": translate("FiveAxis", "Coolant"),
        "work_offset": translate("FiveAxis", "Work offset"),
        "blend": translate("FiveAxis", "Corner rounding"),
        "rtcp": translate("FiveAxis", "Tip guided (RTCP)"),
        "high_speed": translate("FiveAxis", "High-speed mode"),
        "machine": translate("FiveAxis", "Machine"),
        "controller": translate("FiveAxis", "Controller"),
        "origin": translate("FiveAxis", "Work zero on the machine"),
        "tool_length": translate("FiveAxis", "Tool length"),
        "control_point": translate("FiveAxis", "Driven point"),
        "gouge": translate("FiveAxis", "What to do"),
        "shank": translate("FiveAxis", "Shank, Ø x length"),
        "holder": translate("FiveAxis", "Holder, Ø x length"),
        "left": translate("FiveAxis", "What is left"),
        "linearize": translate("FiveAxis", "Linearize"),
        "singularity": translate("FiveAxis", "Near the pole"),
        "max_axis_change": translate("FiveAxis", "Largest axis change"),
        "tolerance": translate("FiveAxis", "Tolerance"),
        "against": translate("FiveAxis", "Compare with"),
        "axis_tolerance": translate("FiveAxis", "Axis tolerance"),
        "method": translate("FiveAxis", "Line deviation by"),
        "region": translate("FiveAxis", "Room for the work zero"),
        "grid": translate("FiveAxis", "Places on the map"),
        "turns": translate("FiveAxis", "Turns of the part"),
        "machines": translate("FiveAxis", "Machines"),
        "cures": translate("FiveAxis", "Cures"),
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
        "linear_deflection": translate("FiveAxis", "Mesh deflection"),
        "angular_deflection": translate("FiveAxis", "Mesh angle"),
        "work_zero": translate("FiveAxis", "Work zero"),
        "cutter_kind": translate("FiveAxis", "Kind"),
        "cutter_diameter": translate("FiveAxis", "Diameter"),
        "cutter_corner": translate("FiveAxis", "Corner radius"),
        "cutter_taper": translate("FiveAxis", "Taper, each side"),
        "cutter_length": translate("FiveAxis", "Cutting length"),
        "nc_file": translate("FiveAxis", "NC file"),
    }


def _choices() -> dict[str, str]:
    return {
        "facet_mean": translate("FiveAxis", "mean of the facet normals"),
        "step_weighted": translate("FiveAxis", "normals weighted by step"),
        "minimax": translate("FiveAxis", "least deviation (minimax)"),
        "fixed": translate("FiveAxis", "fixed"),
        "zigzag": translate("FiveAxis", "to and fro"),
        "one_way": translate("FiveAxis", "one way"),
        "g93": translate("FiveAxis", "inverse time (G93)"),
        "g94": translate("FiveAxis", "units a minute (G94)"),
        "report": translate("FiveAxis", "only report"),
        "linearize": translate("FiveAxis", "divide blocks"),
        "on": translate("FiveAxis", "on"),
        "off": translate("FiveAxis", "off"),
        "deform": translate("FiveAxis", "lead the axis past it"),
        "angles": translate("FiveAxis", "by rotary words"),
        "vectors": translate("FiveAxis", "by tool vectors"),
        "tip": translate("FiveAxis", "tip"),
        "centre": translate("FiveAxis", "centre of the rounding"),
        "lift": translate("FiveAxis", "lift the tool"),
        "tilt": translate("FiveAxis", "tilt the tool"),
        "leave-out": translate("FiveAxis", "leave out"),
        "ball": translate("FiveAxis", "ball end"),
        "flat": translate("FiveAxis", "flat end"),
        "bull": translate("FiveAxis", "bull nose"),
        "taperball": translate("FiveAxis", "tapered ball"),
        "taperbull": translate("FiveAxis", "tapered bull nose"),
        "exact": translate("FiveAxis", "exact"),
        "so2008": translate("FiveAxis", "model of So et al. 2008"),
        "so2008-printed": translate("FiveAxis", "model of So et al. 2008 as printed"),
        "scallop": translate("FiveAxis", "Scallop"),
        "stepover": translate("FiveAxis", "Stepover"),
    }


def _groups() -> dict[str, str]:
    return {
        "PassSettings": translate("FiveAxis", "Passes"),
        "CutterSettings": translate("FiveAxis", "Cutter"),
        "ToolAxisSettings": translate("FiveAxis", "Tool axis"),
        "LinkSettings": translate("FiveAxis", "Between passes"),
        "FeedSettings": translate("FiveAxis", "Feeds"),
        "HeadSettings": translate("FiveAxis", "Head of the NC file"),
        "MachineSettings": translate("FiveAxis", "Machine"),
        "CureSettings": translate("FiveAxis", "Against deviation"),
        "GougeSettings": translate("FiveAxis", "Where the tool enters the part"),
        "ProofSettings": translate("FiveAxis", "Proof"),
        "SetupSettings": translate("FiveAxis", "Setup"),
        "CompareSettings": translate("FiveAxis", "Comparison"),
        "AuditSettings": translate("FiveAxis", "CL path or part"),
        "RecoverSettings": translate("FiveAxis", "Recover"),
        "ProveSettings": translate("FiveAxis", "Moves"),
    }
