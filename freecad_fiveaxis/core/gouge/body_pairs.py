# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of the machine against each other, and against part and fixtures, on the way that the machine really
goes.

Pairs whose carriers move against each other are looked at, each with the joints between its carriers alone:
blocks in which these stand, or which repeat others, cost nothing. What tool and spindle hit of the bodies of
table and base is found in :mod:`.machine_check`; here the tool is looked at against bodies that other axes of
its own head carry.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, Hit, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, Point, Sentence, join_sentences, say
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program, find_unknown_ways

from .body_search import Meetings, Pair, find_meetings
from .carried_motion import Step
from .carried_pieces import TOOL, Carried, CarriedPair, pair_up
from .machine_way import MachineWay, plain_way
from .rapid_check import independent_rapids

PARED, SLACK = 0.9, 0.1
"""Shares of the tolerance: pieces are pared by the one, and what is open by the other is called free."""

FINEST = 0.1
"""Depths and distances are known to this share of themselves, or to the tolerance."""

REMEDY = say("Clamp the part elsewhere or higher, use a longer tool, or lean it less.")
SAME_SIDE = say(
    "Place the part otherwise on the table, or lean the tool less, so that the axes need not go there."
)
"""What helps, and what does where the tool's length changes nothing."""


@dataclass(frozen=True, eq=False)
class PairCheck:
    """``zero`` (5,) mm and degrees: the words at which every joint stands at zero, those of ``known`` (5,)
    whether or not the tool's length is known; ``way``: the program's; ``rapids`` as of
    :func:`.check.check_program`; ``clearance`` mm between bodies that have none."""

    machine: Machine
    kinematics: Chain
    way: MachineWay
    zero: Floats
    known: Bools
    rapids: str
    tolerance: float
    clearance: float = 0.0

    @property
    def program(self) -> Program:
        """What is checked."""
        return self.way.program


class Closest(NamedTuple):
    """Of one pair: ``block`` and ``u`` (None: not known) of the deepest place, or of the nearest; ``level``
    mm: how deep at least, or less than 0: how near at most; ``place`` (3,) mm, seen from what carries the
    entered piece; ``blocks``: how many there are."""

    block: int
    u: float | None
    level: float
    place: Vector
    blocks: int


def check_pairs(
    given: PairCheck, carried: Sequence[Carried], progress: Progress = silent
) -> tuple[Finding, ...]:
    """Find where bodies go more than the tolerance into each other, or nearer than the clearance, on any
    block. None deeper is missed; told of each pair is the deepest place, or the nearest where they stay out
    of each other."""
    pairs, left = pair_up(given.machine, carried)
    found, of_tool, touching = list[Finding](), list[Finding](), list[CarriedPair]()
    for k, pair in enumerate(pairs):
        progress("gouge", k / len(pairs))
        columns = [given.kinematics.letters.index(step.axis.letter) for step in pair.motion.steps]
        if given.known[columns].all():
            new = [*_look_at(given, pair, _levels(given, pair, columns))]
            (of_tool if pair.enters.kind == TOOL else found).extend(new)
            touching += [pair] if pair.granted is not None and not new else []
    return (*_touching(touching, left), *found, *_worst_of_tool(of_tool))


def which_meet(
    given: PairCheck, pairs: Sequence[CarriedPair], blocks: Ints, progress: Progress = silent
) -> Bools:
    """Tell in which of these ``blocks`` (k,) one of the ``pairs`` is not proven to stay out of each other."""
    found = np.zeros(len(blocks), np.bool_)
    independent = given.rapids != INTERPOLATED
    rapids = np.flatnonzero(np.isin(blocks, independent_rapids(given.program))) if independent else blocks[:0]
    for k, pair in enumerate(pairs):
        progress("gouge", k / len(pairs))
        columns = [given.kinematics.letters.index(step.axis.letter) for step in pair.motion.steps]
        if not given.known[columns].all():
            continue
        levels = _levels(given, pair, columns)
        for rows, together in ((np.arange(len(blocks)), True), (rapids, False)):
            left = rows[~found[rows]]
            met = levels.meet(levels.least, blocks[left], together)
            found[left] = met.met | met.unproven
    return found


def _worst_of_tool(found: Sequence[Finding]) -> Iterator[Finding]:
    """Of each body the worst of what the tool's many pieces do to it."""
    worst: dict[str, Finding] = {}
    for one in found:
        met = one.hit or one.near
        name = met.entered if met else one.text
        other = worst.setdefault(name, one)
        if (one.severity, one.hit is not None, _badness(one)) > (
            other.severity,
            other.hit is not None,
            _badness(other),
        ):
            worst[name] = one
    yield from worst.values()


def _badness(one: Finding) -> float:
    """Return what is deeper is worse, and what is nearer."""
    return (one.value or 0.0) if one.hit else -(one.value or 0.0)


def _touching(pairs: Sequence[CarriedPair], left: Sequence[tuple[Carried, Carried]]) -> Iterator[Finding]:
    """Yield which neighbours go no deeper into each other, and which are ``left`` out."""
    if pairs:
        text = say(
            "These touch each other with all axes at zero, so they are taken for neighbours; they go nowhere "
            "deeper into each other than there: {names}.",
            names=_name_pairs([(one.standing, one.moved) for one in pairs]),
        )
        yield report_finding(Code.MACHINE_TOUCHING, text, float(len(pairs)))
    if left:
        text = say(
            "These touch each other with all axes at zero and were not looked at against each other, for one "
            "is hollow or holds the other: {names}. Divide what is hollow into several bodies.",
            names=_name_pairs(left),
        )
        yield report_finding(Code.MACHINE_TOUCHING, text, float(len(left)))


def _name_pairs(pairs: Sequence[tuple[Carried, Carried]]) -> str:
    return "; ".join(f"{one.name}, {other.name}" for one, other in pairs)


def _levels(given: PairCheck, pair: CarriedPair, columns: Sequence[int]) -> _Levels:
    """Return a pair at its levels; where none of its axes is linear, it goes as in a program that is not
    guided."""
    steps = pair.motion.steps
    way = plain_way(given.program) if all(step.axis.rotary for step in steps) else given.way
    own = _joints(given, steps, columns, given.program)
    same = way.in_step is given.program
    return _Levels(given, pair, way, own, own if same else _joints(given, steps, columns, way.in_step))


def _joints(given: PairCheck, steps: Sequence[Step], columns: Sequence[int], program: Program) -> Floats:
    """Return the joints (m, k) of the steps in every row of a program, mm and rad."""
    off = (program.words - given.zero)[:, columns]
    return np.where([step.axis.rotary for step in steps], np.deg2rad(off), off)


def _look_at(given: PairCheck, pair: CarriedPair, levels: _Levels) -> Iterator[Finding]:
    deep, unproven = levels.find(levels.least, levels.most)
    if deep is not None:
        yield _collision(given, pair, deep)
        return
    if len(unproven):
        yield _unproven(given, pair, unproven)
        return
    if pair.granted is not None:
        return
    wanted = max(pair.moved.clearance, pair.standing.clearance) or given.clearance
    near, _ = levels.find(PARED * given.tolerance - wanted, 0.0) if wanted > given.tolerance else (None, None)
    if near is not None:
        yield _near(given, pair, near, wanted)


@dataclass(frozen=True, eq=False)
class _Levels:
    """A pair at a level, mm: above 0 what lies so deep in the standing piece is met, below 0 what comes so
    near. ``joints`` (m, k) of the program's rows, ``in_step`` those of the rows of the ``way``."""

    given: PairCheck
    pair: CarriedPair
    way: MachineWay
    joints: Floats
    in_step: Floats

    @property
    def least(self) -> float:
        """What is less deep is none, mm."""
        return (self.pair.granted or 0.0) + PARED * self.given.tolerance

    @property
    def most(self) -> float:
        """Nothing can be deeper, mm."""
        rounds = self.pair.moved.piece.round + self.pair.standing.piece.round
        return 0.99 * (rounds or self.pair.standing.piece.inmost[1])

    def at(self, level: float) -> Pair:
        """Give the pair whose meetings are those of the level."""
        motion, standing = self.pair.motion, self.pair.standing.piece
        if level > 0.0 and not self.pair.moved.piece.round + standing.round:
            return Pair(motion, standing.pare(min(level, self.most)))
        return Pair(motion, standing, -min(level, self.most))

    def meet(self, level: float, blocks: Ints, joined: bool) -> Meetings:
        """Find the meetings of these blocks (k,): pieces of the way where the joints go in step (``joined``),
        else blocks of the program."""
        program, joints = (self.way.in_step, self.in_step) if joined else (self.given.program, self.joints)
        start, end = joints[blocks], joints[blocks + 1]
        unknown = find_unknown_ways(program)[blocks]
        start = np.where(unknown[:, None], end, start) if unknown.any() else start
        return find_meetings(self.at(level), start, end, joined, SLACK * self.given.tolerance)

    def find(self, level: float, most: float) -> tuple[Closest | None, Ints]:
        """Find the block that is deepest, from ``level`` mm up to ``most``; and the blocks (k,) of which that
        is not proven."""
        found, unproven = self._on_way(level, most)
        if self.given.rapids != INTERPOLATED and found is None:
            rapids = independent_rapids(self.given.program)
            found, more = self._deepest(level, most, rapids, False)
            unproven = np.union1d(unproven, more)
        return found, unproven

    def _on_way(self, level: float, most: float) -> tuple[Closest | None, Ints]:
        """Find the same in step, each level so much lower as the real way may be off, and told so."""
        pieces, off = np.arange(len(self.in_step) - 1), self.way.off
        found, unproven = self._deepest(level - off, most, pieces, True)
        if found is not None:
            block, u = self.way.locate(found.block, found.u)
            found = found._replace(block=block, u=u, level=found.level - off)
        return found, np.unique(self.way.block[unproven])

    def _deepest(self, level: float, most: float, blocks: Ints, joined: bool) -> tuple[Closest | None, Ints]:
        met = self.meet(level, blocks, joined)
        unproven, owner = blocks[met.unproven], self.way.block if joined else np.arange(len(self.joints))
        count = len(np.unique(owner[blocks[met.met]]))
        if not count:
            return None, unproven
        best = self._one(level, blocks, met, count, joined)
        blocks = blocks[met.met]
        while most - level > max(FINEST * abs(level), self.given.tolerance):
            middle = 2.0 * level if 0.0 < 2.0 * level < most else 0.5 * (level + most)
            met = self.meet(middle, blocks, joined)
            if met.met.any():
                level, best = middle, self._one(middle, blocks, met, count, joined)
                blocks = blocks[met.met]
            else:
                most = middle
        return best, unproven

    def _one(self, level: float, blocks: Ints, met: Meetings, count: int, joined: bool) -> Closest:
        """Return the first that is met."""
        at = int(met.met.argmax())
        place = met.place[at]
        if self.pair.entered is self.pair.moved:
            turn, shift = (part[0] for part in self.pair.motion.lines(met.joints[at : at + 1]).poses)
            place = (place - shift) @ turn
        x, y, z = place.tolist()
        return Closest(int(blocks[at]), float(met.u[at]) if joined else None, level, (x, y, z), count)


def _collision(given: PairCheck, pair: CarriedPair, deep: Closest) -> Finding:
    text = say(
        "The {part} goes at least {depth} into the {name}, at {at}, deepest of {count} blocks.",
        part=pair.enters.name, depth=Length(deep.level, ".4g"), name=pair.entered.name, at=_at(deep),
        count=deep.blocks,
    )  # fmt: skip
    row, line, place = _where(given, deep.block)
    remedy = SAME_SIDE if len({step.axis.side for step in pair.motion.steps}) == 1 else REMEDY
    if pair.granted is not None and pair.granted > given.tolerance:
        at_zero = say(
            "With all axes at zero they are {depth} in each other.", depth=Length(pair.granted, ".3g")
        )
        text = join_sentences((text, at_zero))
    text, hit = join_sentences((text, remedy)), Hit(pair.enters.key, pair.entered.key, deep.u)
    limit = given.tolerance + (pair.granted or 0.0)
    return report_finding(Code.MACHINE_COLLISION, text, deep.level, limit, row, line, place, hit=hit)


def _near(given: PairCheck, pair: CarriedPair, near: Closest, wanted: float) -> Finding:
    distance = min(given.tolerance - near.level, wanted)
    text = say(
        "The {part} comes nearer than {distance} to {name} at {at}, nearest of {count} blocks; {clearance} "
        "are asked for.",
        part=pair.enters.name, distance=Length(distance, ".3g"), name=pair.entered.name, at=_at(near),
        count=near.blocks,
        clearance=Length(wanted),
    )  # fmt: skip
    row, line, place = _where(given, near.block)
    return report_finding(
        Code.MACHINE_NEAR,
        text,
        distance,
        wanted,
        row,
        line,
        place,
        near=Hit(pair.enters.key, pair.entered.key, near.u),
    )


def _unproven(given: PairCheck, pair: CarriedPair, blocks: Ints) -> Finding:
    row, line, _ = _where(given, int(blocks[0]))
    text = say(
        "In {count} blocks it is not proven that the {part} stays out of the {name}, the first in NC line "
        "{line}. Drive one group of axes after the other, or place the part otherwise on the table.",
        count=len(blocks), part=pair.enters.name, name=pair.entered.name, line=line,
    )  # fmt: skip
    return report_finding(Code.MACHINE_UNPROVEN, text, block=row, line=line)


def _at(closest: Closest) -> Sentence:
    """Where that is on the machine, in words."""
    return say(
        "{at} in the machine frame with the axes that carry it at zero", at=Point(closest.place, ".4g")
    )


def _where(given: PairCheck, block: int) -> tuple[int, int, Vector]:
    """Return the row to which a block leads, its NC line, and where the tip then is, mm, work frame."""
    row = block + 1
    x, y, z = forward(given.kinematics, words_to_q(given.program.words[row : row + 1]))[0][0].tolist()
    return row, int(given.program.line[row]), (x, y, z)
