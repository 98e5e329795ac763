# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part and fixtures in the room of the machine, in the tasks that write no program: what stands in a body on
which it is clamped, what seems to be in other units, and what of the machine a setup's program hits.

held      part and fixtures: they go with the work zero that is tried, and turn with the part.
aside     what goes with the tool but for turns (:func:`_goes_with_tool`) passes part and fixtures alike in
          every setup: that is no reason to choose another one, and is told of the one that is chosen.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, Hit
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.carried_motion import steps_between
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine
from freecad_fiveaxis.core.gouge.placing import Sunk, find_sunk, report_placing, report_sunk
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import SPINDLE
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.pipeline.options import rapids_of, tip_to_driven, tool_body
from freecad_fiveaxis.core.pipeline.part_size import unit_suspected
from freecad_fiveaxis.core.pipeline.settings import Settings
from freecad_fiveaxis.core.tool.body import PARTS

from .setup_map import Collide
from .setup_map.standing import turn_mesh

Held = tuple[Mesh | None, tuple[Fixture, ...]]
"""The part, None where it is not known, and the fixtures."""

DEEPER = 1.02
"""Times as deep as in the present setup: depths are those of samples, and so well known."""


def report_standing(
    settings: Settings, machine: Machine, setup: Setup, part: Mesh | None, fixtures: Sequence[Fixture]
) -> tuple[Finding, ...]:
    """Report, as ``mill`` does, part and fixtures that stand in bodies of the machine, and what seems to be
    in other units. Raises FiveAxisError for the file of a body that cannot be used."""
    size = () if part is None else unit_suspected(part, settings.cutter.cutter)
    return (*size, *report_placing(machine, setup, part, fixtures))


def name_machine(found: Sequence[Finding], machine: str) -> tuple[Finding, ...]:
    """Name the machine on which that is so, but for what is so on any."""
    return tuple(
        one
        if one.code == Code.UNIT_SUSPECTED
        else replace(one, text=say("On {machine}: {what}", machine=machine, what=one.text))
        for one in found
    )


def watch_machine(
    settings: Settings, machine: Machine, dialect: Dialect, base: Setup, held: Held, progress: Progress
) -> Collide | None:
    """Return what the program of a setup hits of the machine, its bodies of each other, of part and fixtures,
    and where these stand deeper in a body than in the present setup ``base``; None where the machine's file
    names no bodies."""
    if not machine.bodies:
        return None
    present = max((one.depth for one in find_sunk(machine, base, *held)), default=0.0)
    aside = _find_aside(machine)

    def collide(turn: float, setup: Setup, kinematics: Chain, program: Program) -> tuple[Finding, ...]:
        part, fixtures = _turn(held, turn)
        length = None if settings.machine.tool_length is None else setup.tool_length
        given = InMachine(
            machine, setup, kinematics, tool_body(settings), length, tip_to_driven(settings),
            rapids_of(settings, machine, dialect), settings.gouge.fixture_clearance, fixtures,
        )  # fmt: skip
        found = check_machine(given, program, part, settings.proof.tolerance, progress)
        names = {"", *(one.name for one in fixtures)}
        hits = tuple(one for one in found if not _is_aside(one, aside, names))
        return hits + _refuse_sunk(machine, setup, (part, fixtures), DEEPER * present)

    return collide


def _find_aside(machine: Machine) -> set[str]:
    """Name all that part and fixtures meet alike in every setup: the tool, and what goes with it."""
    return {*PARTS, *(one.name for one in machine.bodies if _goes_with_tool(machine, one.carrier))}


def _goes_with_tool(machine: Machine, carrier: str) -> bool:
    """Tell whether no linear axis lies between a carrier and the spindle."""
    return all(step.axis.rotary for step in steps_between(machine, SPINDLE, carrier))


def _is_aside(found: Finding, aside: set[str], held: set[str]) -> bool:
    hit = found.hit or found.near
    return hit is not None and hit.entered in held and hit.enters in aside


def _turn(held: Held, turn: float) -> Held:
    """Turn part and fixtures by ``turn`` rad."""
    part, fixtures = held
    turned = tuple(replace(one, mesh=turn_mesh(one.mesh, turn)) for one in fixtures)
    return None if part is None else turn_mesh(part, turn), turned


def _refuse_sunk(machine: Machine, setup: Setup, held: Held, most: float) -> tuple[Finding, ...]:
    """Return where part or fixtures stand more than ``most`` mm deep in a body, as errors with what is
    more."""
    return tuple(_refuse_one(one, most) for one in find_sunk(machine, setup, *held) if one.depth > most)


def _refuse_one(one: Sunk, most: float) -> Finding:
    deeper = one.depth - most
    return replace(
        report_sunk(one), value=deeper, severity=Severity.ERROR, hit=Hit(one.fixture or "", one.body)
    )
