# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one verdict over everything that is known of a program: a traffic light and one sentence.

red     there is a finding of severity ERROR: part or machine will be spoiled. What enters the part comes first.
amber   nothing says so, but something is to be looked at (a warning), or was not looked at: blocks whose bound is not proven,
        or the part, where gouges were not checked.
green   the tolerance is proven for every feed block, and the tool was seen to stay out of the part.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from itertools import groupby
from typing import TYPE_CHECKING, Any

from freecad_fiveaxis.core.findings import Finding, Severity

from .judgement import OVER, SINGULAR, UNPROVEN

if TYPE_CHECKING:
    from .figures import Figures

CLAUSE = re.compile(r"[.:;] ")
"""What ends a clause; a point within a number does not."""

NAMED = 3
"""So many kinds of errors, or of warnings, are named in the sentence; the findings tell of all."""


class Light(Enum):
    """The light of a verdict; its value is the word for scripts and properties."""

    RED = "red"
    AMBER = "amber"
    GREEN = "green"


HEAD = {Light.RED: "NOT SAFE", Light.AMBER: "CHECK", Light.GREEN: "SAFE"}


@dataclass(frozen=True)
class Verdict:
    """``reasons``: why the light shows what it shows, the gravest first, each without a full stop."""

    light: Light
    reasons: tuple[str, ...]

    @property
    def text(self) -> str:
        """The verdict in one sentence, as "NOT SAFE: enters the part at 203 places, 5 mm deep (NC line 17)."."""
        more = len(self.reasons) - NAMED
        named = "; ".join(self.reasons[:NAMED])
        return f"{HEAD[self.light]}: {named}{f'; and {more} more' if more > 0 else ''}."


def verdict(figures: Figures, numbers: Mapping[str, Any]) -> Verdict:
    """The verdict over a program; ``numbers``: its summary."""
    errors = tuple(_errors(figures, numbers))
    if errors:
        return Verdict(Light.RED, errors)
    open_ = tuple(_open(figures, numbers))
    if open_:
        return Verdict(Light.AMBER, open_)
    feeds = numbers["feed_blocks"]
    held = "the one feed block" if feeds == 1 else f"all {feeds} feed blocks"
    return Verdict(Light.GREEN, (f"tolerance {figures.tolerance:g} mm held in {held}, proven", _stays_out(figures)))


def is_checked(figures: Figures) -> bool:
    """Whether it was looked at whether the tool enters the part."""
    return figures.gouge is not None or (figures.audit is not None and figures.audit.part is not None)


def _stays_out(figures: Figures) -> str:
    above = figures.gouge is not None and any(figures.inputs.get(name) for name in ("shank", "holder"))
    return "the tool stays out of the part" if above else "the cutter stays out of the part (no shank or holder given)"


def _of_severity(figures: Figures, severity: Severity) -> dict[str, tuple[Finding, ...]]:
    """The findings of that severity by their codes, in the order in which they came."""
    found = [one for one in figures.findings if one.severity is severity]
    order = {code: at for at, code in enumerate(dict.fromkeys(one.code for one in found))}
    return {code: tuple(some) for code, some in groupby(sorted(found, key=lambda one: order[one.code]), lambda one: one.code)}


# ------------------------------------------------------------------------------------------------ red

ENTERS = {
    "overcut": "enters the part",
    "rapid-collision": "hits the part between passes",
    "holder-collision": "shank or holder hits the part",
    "buried": "the whole cutter is inside the part",
    "cut-too-deep": "cuts too deep",
}
"""What enters the part, the most frequent first; all of it before any other error."""


def _errors(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[str]:
    found = _of_severity(figures, Severity.ERROR)
    for code in sorted(found, key=lambda code: [*ENTERS, OVER, code].index(code)):
        if code in ENTERS:
            yield ENTERS[code] + _where(code, found[code], numbers)
        elif code == OVER:
            yield _leaves_path(figures, numbers)
        else:
            yield _gist(found[code][0].text)


def _where(code: str, found: tuple[Finding, ...], numbers: Mapping[str, Any]) -> str:
    """As " at 203 places, 5 mm deep (NC line 17)"."""
    worst = max(found, key=lambda one: one.value or 0.0)
    if code == "buried":
        said = f" in {worst.value or 0.0:g} blocks"
    else:
        places = numbers.get(f"{code.replace('-', '_')}_places", len(found))
        said = f" at {places} place{'' if places == 1 else 's'}, {worst.value or 0.0:.3g} mm deep"
    return said if worst.line is None else f"{said} (NC line {worst.line})"


def _leaves_path(figures: Figures, numbers: Mapping[str, Any]) -> str:
    over, feeds = numbers["over_tolerance"], numbers["feed_blocks"]
    blocks = f"{over} of {feeds} feed blocks {'leaves' if over == 1 else 'leave'}"
    by = f"by up to {numbers['max_segment_deviation']:.3g} mm, {figures.tolerance:g} mm allowed"
    return f"{blocks} the path {by} (NC line {numbers['worst_line']})"


def _gist(text: str) -> str:
    """The first clause of a finding's text, as it goes on in the middle of a sentence."""
    said = CLAUSE.split(text, maxsplit=1)[0].rstrip(".")
    return said[:1].lower() + said[1:] if said[1:2].islower() else said


# ------------------------------------------------------------------------------------------------ amber


def _open(figures: Figures, numbers: Mapping[str, Any]) -> Iterator[str]:
    feeds = numbers["feed_blocks"]
    if not feeds:
        yield "the program has no feed blocks, so nothing is proven"
    if not is_checked(figures):
        yield "not checked against the part"
    if guided := numbers["guided_blocks"]:
        yield f"in {guided} of {feeds} feed blocks the controller guides the tip (RTCP), proven are only their ends"
    if numbers["unproven"]:
        yield f"tolerance {figures.tolerance:g} mm not proven in {numbers['unproven']} of {feeds} feed blocks"
    for code, found in _of_severity(figures, Severity.WARNING).items():
        if code != UNPROVEN:
            yield _warning(code, found, numbers)


WARNED = {
    "spindle-off": "the spindle stays off",
    "lifted": "the tool is lifted out of the part by up to {value:.3g} mm, what it leaves stays uncut",
    "left-out": "{value:.4g} mm of the passes are left out",
    "uncut": "more than scallops stays uncut on {value:.4g} mm2",
    "facets-beyond-axis-angle": "{value:.4g} mm2 are too steep for the largest axis angle and left out",
    "facets-beyond-machine": "{value:.4g} mm2 are beyond the machine's limits and left out",
}
"""What a warning says in the verdict; one that is not here gives its first clause."""


def _warning(code: str, found: tuple[Finding, ...], numbers: Mapping[str, Any]) -> str:
    worst = found[0]
    if code == "side-not-machined":
        sides = "a side is" if len(found) == 1 else f"{len(found)} sides are"
        return f"{sides} not machined ({sum(one.value or 0.0 for one in found):.4g} mm2)"
    if code == SINGULAR:
        count = numbers["singular_blocks"]
        return f"{count} block{'' if count == 1 else 's'} near the pole"
    said = WARNED.get(code)
    if said is None or (worst.value is None and "{" in said) or (code == "uncut" and worst.unit != "mm2"):
        return _gist(worst.text)
    return said.format(value=worst.value)
