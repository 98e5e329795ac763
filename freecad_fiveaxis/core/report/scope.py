# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a verdict rests on: what was proven of the program, what that takes for granted, and what nobody
looked at.

The light of a verdict is taken for more than it says. So each report, and the window, say in one box what
stands behind it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, Task, plural, say
from freecad_fiveaxis.core.machine.bodies import SPINDLE

from .figures import Figures
from .verdict import ENTERS, is_checked

AUDITED = "audit"
"""The kind of a program that was not made here."""


class Scope(NamedTuple):
    """Sentences: what is ``proven``, what is ``assumed`` for that, and what is ``unknown``, for it was not
    looked at."""

    proven: tuple[Sentence, ...]
    assumed: tuple[Sentence, ...]
    unknown: tuple[Sentence, ...]

    @property
    def named(self) -> tuple[tuple[Sentence, tuple[Sentence, ...]], ...]:
        """Each group with its heading; none that is empty."""
        groups = (
            (say("Proven"), self.proven),
            (say("Assumed"), self.assumed),
            (say("Not known"), self.unknown),
        )
        return tuple((name, texts) for name, texts in groups if texts)


def scope(figures: Figures, numbers: Mapping[str, Any]) -> Scope:
    """Find what stands behind the verdict; ``numbers``: the summary."""
    return Scope(
        tuple(_state_proven(figures, numbers)),
        tuple(_state_assumptions(figures, numbers)),
        tuple(_unknown(figures)),
    )


def _state_proven(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[Sentence]:
    measured = numbers["feed_blocks"] - numbers["guided_blocks"]
    if held := measured - numbers["over_tolerance"] - numbers["unproven"]:
        yield plural(
            held,
            "in {count} of {all} feed blocks {point} stays within {tolerance} of the straight way between "
            "the block's ends",
            "in {count} of {all} feed blocks {point} stays within {tolerance} of the straight way between "
            "the blocks' ends",
            all=numbers["feed_blocks"],
            point=say("the tip") if figures.surface is None else say("the ball's centre"),
            tolerance=Length(figures.tolerance),
        )
    errors = {one.code for one in figures.findings if one.severity is Severity.ERROR}
    if is_checked(figures) and not errors & (
        set(ENTERS) - {Code.TABLE_COLLISION, Code.FIXTURE_COLLISION, Code.MACHINE_COLLISION}
    ):
        yield from _out_of_the_part(figures)
    if figures.table is not None and Code.TABLE_COLLISION not in errors:
        yield say("the tool stays above the table's face, at Z {height}", height=Length(figures.table))
    names, codes = name_checked_bodies(figures), {one.code for one in figures.findings}
    if names and not codes & {Code.MACHINE_COLLISION, Code.MACHINE_UNPROVEN}:
        yield say(
            "from the first block to the last tool and spindle, as far as they are given, stay out of the "
            "machine's bodies: {names}",
            names=names,
        )
        yield from _state_plane(figures)
    together = _name_moving_bodies(figures)
    if together and not codes & {Code.MACHINE_COLLISION, Code.MACHINE_UNPROVEN}:
        yield say(
            "from the first block to the last those of the machine's bodies that move against each other "
            "stay out of each other, and out of part and fixtures as far as these are known, but for "
            "neighbours that touch with all axes at zero: {names}",
            names=together,
        )
    if figures.fixtures and not codes & {Code.FIXTURE_COLLISION, Code.FIXTURE_UNPROVEN}:
        names = ", ".join(figures.fixtures)
        yield say(
            "cutter, shank and holder, as far as they are given, stay out of the fixtures: {names}",
            names=names,
        )
        near = figures.inputs.get("fixture_clearance")
        if isinstance(near, float) and near > figures.tolerance and Code.FIXTURE_NEAR not in codes:
            yield say("they keep {clearance} away from fixtures", clearance=Length(near))
    kept = figures.inputs.get("avoid_allowance")
    if (
        isinstance(kept, float)
        and kept > figures.tolerance
        and not codes & {Code.AVOIDED_FACES_NEAR, Code.AVOIDED_FACES_UNPROVEN}
    ):
        yield say(
            "cutter, shank and holder, as far as they are given, keep {distance} off the faces to avoid",
            distance=Length(kept),
        )


def _state_plane(figures: Figures) -> Iterator[Sentence]:
    """Yield what holds wherever the axes stand before the program."""
    if figures.above is not None:
        yield say(
            "where the program begins and ends, at Z {height}, tool and spindle are above part, fixtures "
            "and the machine's bodies, wherever the other axes stand, and from there Z comes down clear to "
            "the first block and rises clear from the last",
            height=Length(figures.above.z, bare=True),
        )


def _unknown_ends(figures: Figures) -> Iterator[Sentence]:
    """Yield what is not known before the first block and behind the last, for nobody knows where the axes
    stand when a program is started."""
    above = figures.above
    if above is None:
        if figures.kind == AUDITED or name_checked_bodies(figures):
            yield say(
                "how the axes come to the first block, and where they go behind the last: where they stand "
                "before the program is not known, so nothing was looked at there"
            )
        return
    yield say(
        "where the axes stand before the program: the way of Z up to {height}, and the machine's bodies "
        "against each other while the axes go to the first block",
        height=Length(above.z, bare=True),
    )
    if above.but_for:
        yield say(
            "whether tool and spindle meet {names} on the way to the first block: Z cannot go above them",
            names=", ".join(above.but_for),
        )


def _out_of_the_part(figures: Figures) -> Iterator[Sentence]:
    if _feeds_alone(figures):
        yield say(
            "the cutter's feed moves stay out of the part, but for {tolerance}",
            tolerance=Length(figures.tolerance),
        )
        return
    yield say(
        "{tool} out of the part on feed moves and rapids, but for {tolerance}", tool=_tool(figures),
        tolerance=Length(figures.tolerance),
    )  # fmt: skip
    if figures.rapids not in ("", INTERPOLATED) and all(
        one.code != Code.RAPID_UNPROVEN for one in figures.findings
    ):
        yield say("on rapids that holds for each rate at which the axes may run beside each other")


def _tool(figures: Figures) -> Sentence:
    shank, holder = (bool(figures.inputs.get(name)) for name in ("shank", "holder"))
    if shank and holder:
        return say("cutter, shank and holder stay")
    return (
        say("cutter and shank stay")
        if shank
        else say("cutter and holder stay")
        if holder
        else say("the cutter stays")
    )


def _feeds_alone(figures: Figures) -> bool:
    return figures.gouge is None and figures.inputs.get("gouge") == "off"


def _state_assumptions(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[Sentence]:
    yield say(
        "the machine is as {machine} describes it: axes, their signs, centres of rotation ({signs} shows "
        "it), and the part stands where the program takes it to stand",
        machine=figures.machine.name,
        signs=Task("prove-signs"),
    )
    length = figures.inputs.get("tool_length")
    if isinstance(length, int | float):
        yield say("the tool is {length} long, and of the shape given", length=Length(float(length)))
    else:
        yield say("the tool has the length and the shape given")
    if numbers["feed_blocks"] > numbers["guided_blocks"]:
        yield say("in a feed block all axes run in proportion to each other")
    if numbers["guided_blocks"]:
        yield say(
            "the controller guides the tip straight between the ends of {count} blocks (RTCP); their ends "
            "alone were verified",
            count=numbers["guided_blocks"],
        )
    if figures.program.guided is not None and name_checked_bodies(figures):
        yield say(
            "where the controller guides the tip it turns the rotary axes evenly: so were tool, spindle and "
            "the machine's bodies looked at between the blocks' ends"
        )
    if is_checked(figures) and figures.rapids == INTERPOLATED:
        yield say("in a rapid all axes run in proportion to each other ({rapids})", rapids=Option("rapids"))


def name_checked_bodies(figures: Figures) -> str:
    """Name the machine's bodies that tool and spindle were checked against, with commas."""
    return ", ".join(body.name for body in figures.machine.bodies if body.carrier != SPINDLE)


def _name_moving_bodies(figures: Figures) -> str:
    """Name all bodies of a machine, with commas, where some move against others."""
    bodies = figures.machine.bodies
    return ", ".join(body.name for body in bodies) if len({body.carrier for body in bodies}) > 1 else ""


def _unknown(figures: Figures) -> Iterator[Sentence]:
    if name_checked_bodies(figures):
        yield say("fixtures that were not given, other bodies of the machine, and stock that is still there")
    elif figures.fixtures:
        yield say("other fixtures, the machine's own bodies, and stock that is still there")
    else:
        yield say("fixtures, the machine's own bodies, and stock that is still there")
    yield from _unknown_ends(figures)
    yield say("what the drives make of it: servo lag, look-ahead, rounded corners")
    if not is_checked(figures):
        yield say("the part: whether the tool enters it was not looked at")
        return
    if _feeds_alone(figures):
        yield say("rapids, shank and holder were not looked at")
        return
    missing = [name for name in ("shank", "holder") if not figures.inputs.get(name)]
    if missing:
        both = {"shank": say("the shank: none was given"), "holder": say("the holder: none was given")}
        yield both[missing[0]] if len(missing) == 1 else say("shank and holder: none were given")
