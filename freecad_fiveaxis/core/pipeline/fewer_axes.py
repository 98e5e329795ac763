# SPDX-License-Identifier: LGPL-2.1-or-later
"""What machines of three and four axes cannot do: asked for all the same, it is refused by name, with the
remedy.

The tool of a machine without rotary axes stands along Z, so only the strategy `fixed` makes sense. One rotary
axis turns the tool in one plane (or on one cone): what asks for other axes is named where it arises, what is
only made for two is refused.
"""

from __future__ import annotations

import math
from dataclasses import replace

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Option, say
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.orientation.strategies import FOLLOWING

from .settings import COMPARE, FRAMES, MILL, POST, PROVE, SETUP, Settings
from .settings.tree import ROTARY

FIXED = "fixed"
USUAL = {0: FIXED, 1: "facet_mean"}
"""The tool-axis strategy of machines of so few rotary axes, where none is asked for."""


def suit_tool_axis(settings: Settings, machine: Machine) -> Settings:
    """Return the settings, with a tool axis that the machine can follow where they leave it open."""
    if machine.rotaries not in USUAL or "tool_axis" in settings.explicit or settings.passes.passes == FRAMES:
        return settings
    if machine.rotaries and settings.passes.passes == ROTARY:
        return settings
    return replace(settings, tool_axis=replace(settings.tool_axis, tool_axis=USUAL[machine.rotaries]))


def refuse_what_needs_more_axes(settings: Settings, machine: Machine) -> None:
    """Raise SettingsError for the first thing asked for that a machine of so few rotary axes cannot do."""
    refused = what_needs_more_axes(settings, machine)
    if refused is not None:
        raise refused


def what_needs_more_axes(settings: Settings, machine: Machine) -> SettingsError | None:
    """Why a machine of so few rotary axes cannot do what is asked for: the first reason, or None."""
    if machine.rotaries == 2:
        return None
    refused = (
        _task(settings, machine),
        _cures(settings, machine),
        _leaning(settings, machine),
        _flank(settings, machine),
        _refuse_guiding(settings, machine),
    )
    return next((SettingsError(*one) for one in refused if one), None)


def keeps_its_axis(settings: Settings, machine: Machine) -> bool:
    """Whether the tool axis is the same on all facets because the machine cannot follow them."""
    return machine.rotaries < 2 and settings.tool_axis.tool_axis == FIXED


def _task(settings: Settings, machine: Machine) -> tuple[str, object] | None:
    if settings.task == PROVE:
        return say(
            "machine {name} has fewer than two rotary axes: the proof of signs turns two; jog each axis and "
            "compare with the machine file",
            name=machine.name,
        ), machine.rotaries
    if settings.task == SETUP and not machine.rotaries:
        return say(
            "machine {name} has no rotary axis: its tip leaves no line wherever the part is clamped; put it "
            "where the travel reaches",
            name=machine.name,
        ), machine.rotaries
    return None


def _cures(settings: Settings, machine: Machine) -> tuple[str, object] | None:
    if settings.task not in (MILL, POST, SETUP):
        return None
    if settings.cure.singularity == "deform":
        return say(
            "{singularity} leads past a pole, and machine {name} has none; leave it out",
            singularity=Choice("singularity", ("deform",), flag=True),
            name=machine.name,
        ), settings.cure.singularity
    if settings.passes.passes == FRAMES:
        return None
    if settings.task != POST and settings.tool_axis.tool_axis in ("minimax", "auto"):
        return say(
            "{tool_axis} turns two rotary axes, machine {name} has fewer; choose another, {fixed} keeps the "
            "tool along Z",
            tool_axis=Choice("tool_axis", (settings.tool_axis.tool_axis,), flag=True),
            fixed=Choice("tool_axis", (FIXED,), alone=True),
            name=machine.name,
        ), settings.tool_axis.tool_axis
    return None


def _leaning(settings: Settings, machine: Machine) -> tuple[str, object] | None:
    """Tilts, for a machine that has no rotary axis at all."""
    tool = settings.tool_axis
    if machine.rotaries or settings.task not in (MILL, COMPARE):
        return None
    if tool.tool_axis != FIXED and settings.passes.passes != FRAMES:
        return say(
            "machine {name} has no rotary axis and cannot lean the tool as {strategy} asks: choose "
            "{tool_axis}",
            name=machine.name,
            strategy=Choice("tool_axis", (tool.tool_axis,), alone=True),
            tool_axis=Choice("tool_axis", (FIXED,), flag=True),
        ), tool.tool_axis
    for option, value in (("lead", tool.lead), ("tilt", tool.tilt)):
        if value:
            return say(
                "machine {name} has no rotary axis and cannot lean the tool: leave {option} out",
                name=machine.name,
                option=Option(option),
            ), value  # fmt: skip
    if settings.gouge.gouge == "tilt":
        return say(
            "machine {name} has no rotary axis and cannot lean the tool: choose {gouge}",
            name=machine.name,
            gouge=Choice("gouge", ("lift", "leave-out", "report"), flag=True),
        ), settings.gouge.gouge
    return None


def _flank(settings: Settings, machine: Machine) -> tuple[str, object] | None:
    """Return a barrel that has to lean from the surface, which one rotary axis can only do in one plane."""
    tool, barrel = settings.tool_axis, settings.cutter.cutter.barrel
    if settings.task not in (MILL, COMPARE) or barrel is None or machine.rotaries != 1:
        return None
    if tool.lead or tool.tilt or tool.tool_axis not in FOLLOWING:
        return None
    return say(
        "a barrel leans {angle} from the surface, which machine {name} cannot follow with one rotary axis: "
        "choose {fixed} for upright walls, or a ball cutter",
        angle=Angle(math.degrees(barrel.middle), ".0f"),
        name=machine.name,
        fixed=Choice("tool_axis", (FIXED,), flag=True),
    ), machine.rotaries


def _refuse_guiding(settings: Settings, machine: Machine) -> tuple[str, object] | None:
    if machine.rotaries or settings.task not in (MILL, POST) or settings.head.rtcp == "off":
        return None
    return say(
        "{rtcp} lets the controller guide the tip while rotary axes turn, and machine {name} has none; leave "
        "it out",
        rtcp=Option("rtcp"),
        name=machine.name,
    ), settings.head.rtcp
