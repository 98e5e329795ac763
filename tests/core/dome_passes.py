# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes over the example dome near its top, machines of every kind for them, and the least that a first
rotary word has to turn on a pass, by dynamic programming: for the tests of deform."""

from __future__ import annotations

import importlib.util
from functools import lru_cache
from pathlib import Path

import numpy as np
from bare_machines import BARE

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.passes import facets_within_limits, prepare_planes, slice_mesh
from freecad_fiveaxis.core.toolpath.coedge import close_gaps
from freecad_fiveaxis.core.toolpath.feasible import feasible_rows

SCRIPT = Path(__file__).parents[2] / "resources" / "examples" / "make_parts.py"
spec = importlib.util.spec_from_file_location("make_parts", SCRIPT)
parts = importlib.util.module_from_spec(spec)
spec.loader.exec_module(parts)

HALF = 0.5**0.5
_X, _Y, _Z = (
    Axis(letter, False, "head", tuple(row)) for letter, row in zip("XYZ", np.eye(3).tolist(), strict=True)
)
NUTATING_HEAD = Machine(
    "nutating_head",
    (_X, _Y, _Z, Axis("C", True, "head", (0, 0, 1)), Axis("B", True, "head", (0, HALF, HALF), (0, 0, 200))),
)
BOTH_WAYS = ("fork_head_bc", "head_b_table_c", "trunnion_ac", "trunnion_bc")
"""Machines of orthogonal rotary axes whose second one leans 60 deg to both sides."""
MACHINES = (*BARE, "nutating_head")


def kinematics_of(name):
    machine = NUTATING_HEAD if name == "nutating_head" else load_machine(name)
    return chain(machine, Setup(machine.origin, 100.0))


@lru_cache(maxsize=64)
def dome_passes(
    name,
    stepover=0.5,
    direction=0.0,
    strategy="facet_mean",
    lead=0.0,
    tilt=0.0,
    half_width=8.0,
    order="zigzag",
):
    """Offset path, axes and chain: the passes within ``half_width`` mm of the top of the dome, in the order
    of the cut."""
    mesh, kinematics = from_faces(*parts.dome()), kinematics_of(name)
    keep, _ = facets_within_limits(mesh, kinematics, np.radians(61.0), None)
    planes, _ = prepare_planes(mesh, direction, 5.0, stepover=stepover, scallop=None, least=0.05, keep=keep)()
    planes = planes[np.abs(planes) <= half_width]
    ordered = close_gaps(slice_mesh(mesh, planes, direction, order=order), mesh, 5.0, 0.01, keep)
    axis = tool_axes(ordered, strategy, AxisOptions(lead=lead, tilt=tilt))
    return (*feasible_rows(ordered, axis, kinematics), kinematics)


def meridian_angles(kinematics, word, axis):
    """How far (n, w) rad axes (n, 3) are from the circles on which the second rotary axis moves the tool at
    first words (w,)."""
    first, second = kinematics.direction[3], kinematics.direction[4]
    along = first * (first @ second)
    across, aside = second - along, np.cross(first, second)
    centre = along + np.cos(word)[:, None] * across + np.sin(word)[:, None] * aside
    return np.abs(np.arccos(np.clip(axis @ centre.T, -1, 1)) - np.arccos(second[2]))


def least_turn(kinematics, axis, change, steps=720):
    """The least that the first word turns, rad, on any way that keeps its meridian within ``change`` of the
    axes (n, 3): dynamic programming over ``steps`` words a turn, so at most two steps a row too little or too
    much."""
    word = 2 * np.pi * np.arange(steps) / steps
    allowed = meridian_angles(kinematics, word, axis) <= change
    ramp = 2 * np.pi / steps * np.arange(3 * steps)
    cost = np.where(allowed[0], 0.0, np.inf)
    for inside in allowed[1:]:
        thrice = np.tile(cost, 3)
        up = np.minimum.accumulate(thrice - ramp) + ramp
        down = np.minimum.accumulate((thrice + ramp)[::-1])[::-1] - ramp
        cost = np.where(inside, np.minimum(up, down)[steps : 2 * steps], np.inf)
    return cost.min()
