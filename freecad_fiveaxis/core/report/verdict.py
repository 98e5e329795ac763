# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one verdict over everything that is known of a program: a traffic light and one sentence.

red     there is a finding of severity ERROR: part or machine will be spoiled. What enters the part comes
        first.
amber   nothing says so, but something is to be looked at (a warning), or was not looked at: blocks whose
        bound is not proven, or the part, where gouges were not checked.
green   the tolerance is proven for every feed block, and the tool was seen to stay out of the part.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from enum import Enum
from itertools import groupby
from typing import TYPE_CHECKING, Any

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.ranges import ROUNDING
from freecad_fiveaxis.core.base.sentences import (
    MEASURES,
    Area,
    Choice,
    Length,
    Number,
    Sentence,
    Template,
    join_sentences,
    measure,
    plural,
    say,
)

from .unfinished import NOTABLE_SHARE, name_unfinished

if TYPE_CHECKING:
    from .figures import Figures

NAMED = 3
"""So many kinds of errors, or of warnings, are named in the sentence; the findings tell of all."""


class Light(Enum):
    """The light of a verdict; its value is the word for scripts and properties."""

    RED = "red"
    AMBER = "amber"
    GREEN = "green"


HEAD = {Light.RED: say("NOT SAFE"), Light.AMBER: say("CHECK"), Light.GREEN: say("SAFE")}


@dataclass(frozen=True)
class Verdict:
    """``reasons``: why the light shows what it shows, the gravest first, each without a full stop."""

    light: Light
    reasons: tuple[Sentence, ...]

    @property
    def text(self) -> Sentence:
        """The verdict in one sentence, as "NOT SAFE: enters the part at 203 places, 5 mm deep (NC line
        17)."."""
        more = len(self.reasons) - NAMED
        others = [say("and {count} more", count=more)] if more > 0 else []
        return say(
            "{light}: {reasons}.",
            light=HEAD[self.light],
            reasons=join_sentences([*self.reasons[:NAMED], *others], "; "),
        )


def verdict(figures: Figures, numbers: Mapping[str, Any]) -> Verdict:
    """Return the verdict over a program; ``numbers``: its summary."""
    errors = tuple(_errors(figures, numbers))
    if errors:
        return Verdict(Light.RED, errors)
    open_ = tuple(_open(figures, numbers))
    if open_:
        return Verdict(Light.AMBER, open_)
    feeds = numbers["feed_blocks"]
    held = plural(
        feeds,
        "tolerance {tolerance} held in the one feed block, proven",
        "tolerance {tolerance} held in all {count} feed blocks, proven",
        tolerance=Length(figures.tolerance),
    )
    return Verdict(Light.GREEN, (held, _stays_out(figures)))


def is_checked(figures: Figures) -> bool:
    """Whether it was looked at whether the tool enters the part."""
    return figures.gouge is not None or (figures.audit is not None and figures.audit.part is not None)


def _stays_out(figures: Figures) -> Sentence:
    above = is_checked(figures) and any(figures.inputs.get(name) for name in ("shank", "holder"))
    return (
        say("the tool stays out of the part")
        if above
        else say("the cutter stays out of the part (no shank or holder given)")
    )


def _of_severity(figures: Figures, severity: Severity) -> dict[str, tuple[Finding, ...]]:
    """Return the findings of that severity by their codes, in the order in which they came."""
    found = [one for one in figures.findings if one.severity is severity]
    order = {code: at for at, code in enumerate(dict.fromkeys(one.code for one in found))}
    return {
        code: tuple(some)
        for code, some in groupby(sorted(found, key=lambda one: order[one.code]), lambda one: one.code)
    }


def find_largest_judged(numbers: Mapping[str, Any]) -> tuple[float, float]:
    """Take from a summary the largest deviation that was judged, mm, and its proven bound, mm: 0 and the
    bound, at least ROUNDING, where there is none but by rounding."""
    names = ("max_segment_deviation", "max_bound")
    if numbers["max_surface_deviation"] is not None:
        names = ("max_surface_deviation", "max_surface_bound")
    largest, bound = (numbers[name] for name in names)
    return (0.0, max(bound, ROUNDING)) if 0.0 < largest < ROUNDING else (largest, bound)


# ------------------------------------------------------------------------------------------------ red

ENTERS: Mapping[str, Sentence] = {
    Code.OVERCUT: say("enters the part"),
    Code.RAPID_COLLISION: say("hits the part between passes"),
    Code.INDEPENDENT_RAPID: say("a rapid with independent axes hits the part"),
    Code.HOLDER_COLLISION: say("shank or holder hits the part"),
    Code.TABLE_COLLISION: say("the tool goes below the table"),
    Code.FIXTURE_COLLISION: say("the tool hits a fixture"),
    Code.MACHINE_COLLISION: say("the tool hits the machine"),
    Code.BURIED: say("the whole cutter is inside the part"),
    Code.CUT_TOO_DEEP: say("cuts too deep"),
}
"""What enters the part, the most frequent first; all of it before any other error."""


def _errors(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[Sentence]:
    found = _of_severity(figures, Severity.ERROR)
    order = [Code.FIXTURE_IN_PART, *ENTERS, Code.DEVIATION_OVER_TOLERANCE]
    for code in sorted(found, key=lambda code: [*order, code].index(code)):
        if code in ENTERS:
            yield ENTERS[code] + _where(code, found[code], numbers)
        elif code == Code.DEVIATION_OVER_TOLERANCE:
            yield _leaves_path(figures, numbers)
        else:
            yield _meaning(found[code][0])


def _where(code: str, found: tuple[Finding, ...], numbers: Mapping[str, Any]) -> Sentence:
    """As " at 203 places, 5 mm deep (NC line 17)"."""
    worst = max(found, key=lambda one: one.value or 0.0)
    depth = worst.value or 0.0
    if code == Code.BURIED:
        clause = say(" in {count} blocks", count=Number(depth))
    else:
        places = numbers.get(f"{code.replace('-', '_')}_places", len(found))
        depth_text = Length(depth, ".3g")
        clause = plural(
            places, " at {count} place, {depth} deep", " at {count} places, {depth} deep", depth=depth_text
        )
    return clause if worst.line is None else clause + say(" (NC line {line})", line=worst.line)


MEANINGS: Mapping[str, str] = {code: code.meaning for code in Code}


def _meaning(worst: Finding) -> Sentence:
    """As "an axis leaves its limits (12 deg, NC line 5)"."""
    clause = Sentence(MEANINGS[worst.code], {})
    if worst.value is None or worst.unit not in MEASURES:
        return clause if worst.line is None else clause + say(" (NC line {line})", line=worst.line)
    value = measure(worst.value, worst.unit, ".4g")
    return clause + (
        say(" ({value})", value=value)
        if worst.line is None
        else say(" ({value}, NC line {line})", value=value, line=worst.line)
    )


def _leaves_path(figures: Figures, numbers: Mapping[str, Any]) -> Sentence:
    return plural(
        numbers["over_tolerance"],
        "{count} of {all} feed blocks leaves the path by up to {deviation}, {tolerance} allowed (NC line "
        "{line})",
        "{count} of {all} feed blocks leave the path by up to {deviation}, {tolerance} allowed (NC line "
        "{line})",
        all=numbers["feed_blocks"],
        deviation=Length(find_largest_judged(numbers)[0], ".3g"),
        tolerance=Length(figures.tolerance),
        line=numbers["worst_line"],
    )


# ------------------------------------------------------------------------------------------------ amber


def _open(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[Sentence]:
    feeds = numbers["feed_blocks"]
    if figures.unfinished >= NOTABLE_SHARE:
        yield name_unfinished(figures.unfinished, figures.unfinished_parts)
    if not feeds:
        yield say("the program has no feed blocks, so nothing is proven")
    if not is_checked(figures):
        yield say("not checked against the part")
    elif figures.inputs.get("gouge") == "off":
        yield say(
            "only the cutter's own feed moves were checked against the part ({off})",
            off=Choice("gouge", ("off",)),
        )
    if guided := numbers["guided_blocks"]:
        yield say(
            "only the end points of {guided} of {all} feed blocks are verified: the path between them is "
            "under RTCP",
            guided=guided,
            all=feeds,
        )
    if numbers["unproven"]:
        yield say(
            "tolerance {tolerance} not proven in {count} of {all} feed blocks",
            tolerance=Length(figures.tolerance),
            count=numbers["unproven"],
            all=feeds,
        )
    warned = _of_severity(figures, Severity.WARNING)
    for code, found in warned.items():
        if code != Code.BOUND_OVER_TOLERANCE and not (code == Code.REWIND and Code.REWINDS in warned):
            yield _warning(code, found, numbers)


WARNED: Mapping[str, Template] = {
    Code.SPINDLE_OFF: Template("the spindle stays off"),
    Code.LIFTED: Template("the tool is lifted out of the part by up to {value}"),
    Code.LEAST_INTERVAL: Template(
        "passes stand no closer than the least interval, and up to {value} high stays between them"
    ),
    Code.LEFT_OUT: Template("{value} of the passes are left out"),
    Code.UNCUT: Template("more than scallops stays uncut on {value}"),
    Code.NEAR_AVOIDED_FACES: Template(
        "{value} beside the faces to avoid stay uncut for the allowance on these"
    ),
    Code.FACETS_NEAR_AVOIDED: Template("{value} lie too near to the faces to avoid and are left out"),
    Code.FACETS_BEYOND_AXIS_ANGLE: Template("{value} are too steep for the largest axis angle and left out"),
    Code.FACETS_BEYOND_MACHINE: Template("{value} are beyond the machine's limits and left out"),
}
"""What a warning says in the verdict; of one that is not here its code says what it means."""


def _warning(code: str, found: tuple[Finding, ...], numbers: Mapping[str, Any]) -> Sentence:
    worst = found[0]
    if worst.unit == "mm2":  # as for several reasons of one code
        worst = replace(worst, value=sum(one.value or 0.0 for one in found))
    if code == Code.SIDE_NOT_MACHINED:
        area = Area(sum(one.value or 0.0 for one in found), ".4g")
        return plural(
            len(found),
            "a side is not machined ({area})",
            "{count} sides are not machined ({area})",
            area=area,
        )
    if code == Code.SINGULAR_BLOCK:
        near = numbers["singular_blocks"] - numbers["blocks_at_pole"]
        return plural(near, "{count} block near the pole", "{count} blocks near the pole")
    if code == Code.REWINDS:
        return plural(
            int(worst.value or 0.0),
            "a rotary axis turns back inside a cut",
            "a rotary axis turns back inside cuts, {count} times",
        )
    clause = WARNED.get(code)
    if (
        clause is None
        or (worst.value is None and "{" in clause)
        or (code == Code.UNCUT and worst.unit != "mm2")
    ):
        return _meaning(worst)
    return clause.say(value=measure(worst.value or 0.0, worst.unit, ".3g" if code == Code.LIFTED else ".4g"))
