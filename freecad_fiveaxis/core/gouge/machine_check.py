# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool, and what the spindle carries, against the bodies of the machine, and these against each other
(:mod:`.body_pairs`), on the way that the machine really goes.

locked   words whose joints between the body's carrier and the work stand at zero: seen from the carrier the
         tool then goes as it does in a work frame that the carrier holds, which is that of all joints at
         zero. So each body stands still, whatever moves it, and one check serves them all.
guided   blocks whose tip the controller guides are looked at in pieces (:mod:`.machine_way`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, Hit, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Point, Sentence, join_sentences, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.bodies import BASE, MachineBody
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import PARTS, Body, grow_body
from freecad_fiveaxis.core.tool.body import SPINDLE as SPINDLE_PART

from .body_pairs import REMEDY, PairCheck, check_pairs
from .carried_pieces import Carried, carry_bodies, carry_tool, carry_work
from .check import ROUGHLY, GougeCheck, check_program
from .fixtures import Fixture
from .inside import inside, is_closed
from .joint_box import JointSpace
from .machine_bodies import find_round_bodies, make_mesh, spindle_body
from .machine_way import MachineWay, lay_way, plain_way
from .rapid_check import check_rapids
from .worst import Worst, find_unproven, find_worst, near_finding


@dataclass(frozen=True, eq=False)
class InMachine:
    """What is to be checked: the ``machine`` with its bodies, the ``setup`` in which the part stands on it,
    the chain of both, and the tool's ``body``. ``length`` mm, gauge point to the driven point; None where it
    is not known. ``back`` mm from the tip up to that point; ``rapids`` as of :func:`.check.check_program`;
    ``clearance`` mm to bodies that have none of their own; ``fixtures`` stand beside the part."""

    machine: Machine
    setup: Setup
    kinematics: Chain
    body: Body
    length: float | None
    back: float = 0.0
    rapids: str = INTERPOLATED
    clearance: float = 0.0
    fixtures: tuple[Fixture, ...] = ()


def check_machine(
    given: InMachine, program: Program, part: Mesh | None, tolerance: float, progress: Progress = silent
) -> tuple[Finding, ...]:
    """Find where tool or spindle go more than ``tolerance`` mm into a body of the machine, the spindle into
    the ``part`` (None: not known), and bodies into each other, part and fixtures, on any block. None deeper
    is missed; told of each is the deepest place.
    Nothing is found where the machine's file names no bodies. Raises FiveAxisError for the file of a body
    that cannot be used."""
    if not given.machine.bodies:
        return ()
    way = lay_way(given.kinematics, program, tolerance)
    return (
        *_report_unplaced(given),
        *_report_guided(way),
        *_against_bodies(given, way, tolerance, progress),
        *_against_part(given, way, part, tolerance, progress),
        *_near_fixtures(given, way, tolerance, progress),
        *_of_bodies(given, way, part, tolerance, progress),
    )


def _report_guided(way: MachineWay) -> Iterator[Finding]:
    """Yield what is not decided of blocks whose tip the controller guides."""
    guided, rows = way.program.guided, np.flatnonzero(way.undecided) + 1
    if guided is not None and guided.vector is not None:
        text = say(
            "The tool axis is given by vectors. What was looked at of the machine's bodies holds where the "
            "controller takes the same rotary words at the blocks' ends and turns them evenly in between; it "
            "may choose others, and where it turns the vector itself they go otherwise."
        )
        yield report_finding(Code.MACHINE_UNPROVEN, text, severity=Severity.NOTE)
    if len(rows):
        row, line = int(rows[0]), int(way.program.line[rows[0]])
        text = say(
            "In {count} blocks whose tip the controller guides, the first in NC line {line}, the way of the "
            "axes is not bounded closely enough: the machine's bodies were looked at where these blocks end, "
            "not in between.",
            count=len(rows),
            line=line,
        )
        yield report_finding(Code.MACHINE_UNPROVEN, text, block=row, line=line)


def _report_unplaced(given: InMachine) -> Iterator[Finding]:
    """Yield what cannot be looked at without the tool's length."""
    missing = [one.name for one in given.machine.bodies if needs_length(given.machine, one)]
    if given.length is None and missing:
        text = say(
            "Where the spindle is over the tip is not known without the tool's length: {names} were not "
            "looked at. Give it ({option}).",
            names=", ".join(missing),
            option=Option("tool_length"),
        )
        yield report_finding(Code.MACHINE_UNPROVEN, text)


def needs_length(machine: Machine, body: MachineBody) -> bool:
    """Tell whether the place of a body against the tip depends on the tool's length: where the head carries
    it, or the table moves along Z beyond it."""
    if not is_held(machine, body):
        return True
    locked = find_locked_letters(machine, body)
    return any(
        axis.letter in locked and not axis.rotary and abs(axis.direction[2]) > 1e-9 for axis in machine.axes
    )


def is_held(machine: Machine, body: MachineBody) -> bool:
    """Tell whether table or base carry a body, not the head."""
    table = [axis.letter for axis in machine.fitted if axis.side == "table"]
    return body.carrier in (BASE, *table)


def find_locked_letters(machine: Machine, body: MachineBody) -> str:
    """Return the axes of the table between the body's carrier and the work."""
    table = [axis.letter for axis in machine.fitted if axis.side == "table"]
    return "".join(table if body.carrier == BASE else table[: table.index(body.carrier)])


def zero_words(machine: Machine, setup: Setup, kinematics: Chain) -> Floats:
    """Give the words (5,), mm and degrees, at which every joint stands at zero."""
    gauge = np.array(machine.gauge_point) - (0.0, 0.0, setup.tool_length)
    shift = np.linalg.solve(kinematics.direction[:3].T, np.array(setup.origin) - gauge)
    return np.concatenate([-shift, (0.0, 0.0)])


def lock_words(machine: Machine, setup: Setup, kinematics: Chain, words: Floats, letters: str) -> Floats:
    """Give the words (m, 5) mm and degrees with the joints of these ``letters`` at zero."""
    zero = zero_words(machine, setup, kinematics)
    at = [k for k, letter in enumerate(kinematics.letters) if letter in letters]
    found = words.copy()
    found[:, at] = zero[at]
    return found


def _against_bodies(
    given: InMachine, way: MachineWay, tolerance: float, progress: Progress
) -> Iterator[Finding]:
    stack, program = stack_of(given), way.program
    for body in given.machine.bodies:
        if not is_held(given.machine, body) or (given.length is None and needs_length(given.machine, body)):
            continue
        moved = _lock_way(given, way, find_locked_letters(given.machine, body))
        mesh = make_mesh(body, -np.array(given.setup.origin), progress)
        check = _check_on_way(mesh, stack, given, moved, tolerance, progress)
        new = [*_entering(body.name, body.name, check, given, program, tolerance)]
        new += _unproven(body.name, check, program, tolerance)
        new += [] if new else _report_enclosed(body.name, body.name, mesh, given, moved)
        for wanted, some in [] if new else group_by_clearance(given, body.clearance):
            new += _coming_near((body.name, body.name), mesh, some, wanted, given, moved, tolerance, progress)
        yield from new


def group_by_clearance(given: InMachine, clearance: float) -> list[tuple[float, Body]]:
    """Give the pieces of the stack by how near, mm, they may come to a body with this ``clearance`` of its
    own: what the spindle carries may have a larger one."""
    spindle, bodies = spindle_of(given).pieces, find_round_bodies(given.machine)
    wanted = [(clearance or given.clearance, piece) for piece in given.body.pieces]
    for piece, body in zip(spindle, bodies if spindle else (), strict=True):
        wanted.append((max(clearance, body.clearance) or given.clearance, piece))
    alike = sorted({one for one, _ in wanted})
    return [(one, Body(tuple(piece for by, piece in wanted if by == one))) for one in alike]


def _coming_near(
    name: tuple[str, str], mesh: Mesh, body: Body, wanted: float, given: InMachine, way: MachineWay,
    tolerance: float, progress: Progress,
) -> Iterator[Finding]:  # fmt: skip
    """Yield where a ``body`` of the stack comes nearer than ``wanted`` mm to what is called so, and has this
    key in a Hit: there the body, grown by as much, enters."""
    if wanted <= tolerance:
        return
    near = find_worst(
        _check_on_way(mesh, grow_body(body, wanted), given, way, tolerance, progress), way.program
    )
    if near is not None:
        at, place = _places(near, given, way.program)
        yield near_finding(Code.MACHINE_NEAR, name[0], near._replace(place=place), wanted, at, name[1])


def _lock_way(given: InMachine, way: MachineWay, letters: str) -> MachineWay:
    """Give the way with the joints of these ``letters`` at zero."""
    words, in_step = (
        lock_words(given.machine, given.setup, given.kinematics, one.words, letters)
        for one in (way.program, way.in_step)
    )
    return way.with_words(words, in_step)


def _check_on_way(
    mesh: Mesh, body: Body, given: InMachine, way: MachineWay, tolerance: float, progress: Progress
) -> GougeCheck:
    """Check a ``body`` that the spindle carries on the whole way; what is found is in blocks of the
    program."""
    kinematics, back, program = given.kinematics, given.back, way.program
    if way.in_step is program:
        return check_program(mesh, body, kinematics, program, tolerance, back, progress, "", given.rapids)
    check = way.fold(
        check_program(mesh, body, kinematics, way.in_step, tolerance - way.off, back, progress, "")
    )
    if given.rapids == INTERPOLATED:
        return check
    known, space = (check.cutter.depth > 0.0) | (check.above.depth > 0.0), JointSpace.of(kinematics, back)
    return replace(check, ways=check_rapids(mesh, body, space, program, tolerance, ROUGHLY, known, progress))


def _against_part(
    given: InMachine, way: MachineWay, part: Mesh | None, tolerance: float, progress: Progress
) -> Iterator[Finding]:
    spindle, program = spindle_of(given), way.program
    if part is not None and spindle.pieces:
        check = _check_on_way(part, spindle, given, way, tolerance, progress)
        new = [*_entering(say("part"), "", check, given, program, tolerance)]
        new += _unproven(say("part"), check, program, tolerance)
        new += [] if new else _report_enclosed(say("part"), "", part, given, way)
        for wanted, some in [] if new else group_own_clearances(given):
            new += _coming_near((say("part"), ""), part, some, wanted, given, way, tolerance, progress)
        yield from new


def group_own_clearances(given: InMachine) -> list[tuple[float, Body]]:
    """Give what the spindle carries by the clearance, mm, that it has itself."""
    alone = replace(given, body=Body(()), clearance=0.0)
    return [(wanted, some) for wanted, some in group_by_clearance(alone, 0.0) if wanted > 0.0]


def _near_fixtures(
    given: InMachine, way: MachineWay, tolerance: float, progress: Progress
) -> Iterator[Finding]:
    """Yield where what the spindle carries comes nearer to a fixture than its own clearance; what is nearer
    than the clearance to all fixtures, or enters, is found by :mod:`.fixtures`."""
    for fixture in given.fixtures:
        for wanted, some in group_own_clearances(given):
            if wanted > given.clearance:
                name = fixture.name, fixture.name
                for one in _coming_near(name, fixture.mesh, some, wanted, given, way, tolerance, progress):
                    if one.value is not None and one.value > max(given.clearance, tolerance):
                        yield one


def _of_bodies(
    given: InMachine, way: MachineWay, part: Mesh | None, tolerance: float, progress: Progress
) -> tuple[Finding, ...]:
    """Return what bodies of the machine do to each other, to part and fixtures, and the tool to bodies of its
    head."""
    check = pair_check(given, way.program, tolerance, way)
    return check_pairs(check, carry_all(given, part, progress), progress)


def carry_all(given: InMachine, part: Mesh | None, progress: Progress = silent) -> list[Carried]:
    """Give all that the axes carry: bodies, part and fixtures, and the tool where its length is known. Raises
    FiveAxisError for the file of a body that cannot be used."""
    machine = given.machine
    carried = [*carry_bodies(machine, progress), *carry_work(machine, given.setup, part, given.fixtures)]
    if given.length is not None:
        carried += carry_tool(machine, given.body, given.length + given.back)
    return carried


def pair_check(
    given: InMachine, program: Program, tolerance: float, way: MachineWay | None = None
) -> PairCheck:
    """Make what a check of pairs takes, of a program; ``way``: None where its tip is not guided."""
    machine, kinematics = given.machine, given.kinematics
    rise = np.linalg.solve(kinematics.direction[:3].T, (0.0, 0.0, 1.0))
    known = np.concatenate([np.abs(rise) < 1e-9, (True, True)]) | (given.length is not None)
    zero = zero_words(machine, given.setup, kinematics)
    return PairCheck(
        machine, kinematics, way or plain_way(program), zero, known, given.rapids, tolerance, given.clearance
    )


def spindle_of(given: InMachine) -> Body:
    """Give what the spindle carries, heights from the tip; nothing where the tool's length is not known."""
    return Body(()) if given.length is None else spindle_body(given.machine, given.length + given.back)


def stack_of(given: InMachine) -> Body:
    """Stack the tool and what the spindle carries, heights from the tip."""
    return Body((*given.body.pieces, *spindle_of(given).pieces))


def _entering(
    name: str, entered: str, check: GougeCheck, given: InMachine, program: Program, tolerance: float
) -> Iterator[Finding]:
    """Yield what enters a body that is told of as ``name``; ``entered`` as in a Hit."""
    worst = find_worst(check, program)
    if worst is None:
        return
    at, place = _places(worst, given, program)
    if worst.depth:
        text = say(
            "The {part} goes at least {depth} into the {name}, at {at}, deepest of {count} blocks.",
            part=worst.part, depth=Length(worst.depth, ".4g"), name=name, at=at, count=worst.blocks,
        )  # fmt: skip
    else:
        text = say("In {count} blocks the whole cutter is inside the {name}.", count=worst.blocks, name=name)
    text, row, line = join_sentences((text, REMEDY)), worst.row, worst.line
    hit = Hit(worst.part, entered, worst.u)
    yield report_finding(Code.MACHINE_COLLISION, text, worst.depth, tolerance, row, line, place, hit=hit)


def _report_enclosed(name: str, key: str, mesh: Mesh, given: InMachine, way: MachineWay) -> Iterator[Finding]:
    """Yield where all of a piece that the spindle carries is in a closed body that it does not cross: there
    may be air between it and the tool. Then it is so where a block ends."""
    if not is_closed(mesh):
        return
    driven, axis = forward(given.kinematics, words_to_q(way.program.words))
    held = np.zeros(len(driven), np.bool_)
    for piece in spindle_of(given).pieces:
        held |= inside(facet_tree(mesh), driven + (0.5 * (piece.low + piece.high) - given.back) * axis)
    if held.any():
        row, count = int(held.argmax()), int(np.count_nonzero(held))
        text = say("In {count} blocks the whole spindle is inside the {name}.", count=count, name=name)
        line, hit = int(way.program.line[row]), Hit(PARTS[SPINDLE_PART], key, None)
        x, y, z = driven[row].tolist()
        text = join_sentences((text, REMEDY))
        yield report_finding(Code.MACHINE_COLLISION, text, block=row, line=line, place=(x, y, z), hit=hit)


def _places(worst: Worst, given: InMachine, program: Program) -> tuple[Sentence, Vector]:
    """Where that is on the machine, in words, and where the tip then is, mm, work frame."""
    at = Point(tuple(np.add(worst.place, given.setup.origin).tolist()), ".4g")
    x, y, z = forward(given.kinematics, words_to_q(program.words[worst.row : worst.row + 1]))[0][0].tolist()
    return say("{at} in the machine frame with the axes that carry it at zero", at=at), (x, y, z)


def _unproven(name: str, check: GougeCheck, program: Program, tolerance: float) -> Iterator[Finding]:
    """Yield what is not proven of rapids whose axes may run independently."""
    found = find_unproven(check.ways, program, tolerance)
    if found is None:
        return
    text = say(
        "In {count} rapids it is not proven that tool and spindle stay out of the {name} on every way of "
        "independent axes, the first in NC line {line}; they enter by no more than {bound}. Drive one group "
        "of axes after the other.",
        count=found.rapids, name=name, line=found.line, bound=Length(found.bound, ".3g"),
    )  # fmt: skip
    yield report_finding(Code.MACHINE_UNPROVEN, text, found.bound, tolerance, found.row, found.line)
