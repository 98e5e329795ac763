# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CL file says besides the path: tool, spindle, coolant, cutter."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.tool import Cutter, cutter_from_apt, cutter_name

SAME_CUTTER = 1e-3
"""mm (and rad of the taper) by which a cutter may differ from the CL file's: what its four printed decimals,
in inches too, leave open."""


@dataclass(frozen=True)
class ClHead:
    """``tool`` number (None: no tool call), ``speed`` 1/min (0: not said), ``coolant`` on; ``diameter`` and
    ``corner`` radius of the cutter, mm (0: not said); ``stated`` (0 to 7 numbers) all that its CUTTER
    statement says of it, mm and deg; ``neck`` (0 or 2 numbers) diameter and upper end of a lollipop's neck,
    mm; ``flank`` (0 or 2) radius of a barrel's flank, and its length."""

    tool: int | None = None
    speed: float = 0.0
    coolant: bool = False
    diameter: float = 0.0
    corner: float = 0.0
    stated: tuple[float, ...] = field(default=(), compare=False)
    neck: tuple[float, ...] = field(default=(), compare=False)
    flank: tuple[float, ...] = field(default=(), compare=False)

    @property
    def cutter(self) -> Cutter | None:
        """The cutter, where its shape is said and is one that can be used here."""
        return cutter_from_apt(self.stated, neck=self.neck, flank=self.flank)


def cutter_taken(taken: Cutter) -> tuple[Finding, ...]:
    """Report that the CL file's cutter has been taken, because none is given."""
    text = say("No cutter is given; the CL file's is taken: {cutter}.", cutter=cutter_name(taken))
    return (report_finding(Code.CUTTER_FROM_CL_FILE, text, taken.diameter),)


def of_cl_file(finding: Finding) -> Finding:
    """Return a finding of a CL file among those of a program, whose lines are others."""
    if finding.line is None:
        return replace(finding, text=say("CL file: {finding}", finding=finding.text))
    return replace(
        finding,
        text=say("CL file, line {line}: {finding}", line=finding.line, finding=finding.text),
        line=None,
    )


def cutter_note(head: ClHead, given: Cutter) -> tuple[Finding, ...]:
    """Return a note where the CL file is for another cutter than the one given: of another diameter, or,
    where it says one, shape."""
    other = head.cutter
    diameter = head.diameter if other is None else other.diameter
    if head.diameter > 0.0 and abs(diameter - given.diameter) > SAME_CUTTER:
        text = say(
            "The CL file is for a cutter of {diameter}, retracts are laid out for {given}; give {cutter}.",
            diameter=Length(diameter),
            given=Length(given.diameter),
            cutter=Option("cutter"),
        )
        return (report_finding(Code.CUTTER_DIFFERS, text, diameter, given.diameter),)
    if other is None or _off_shape(other, given) <= SAME_CUTTER:
        return ()
    text = say(
        "The CL file is for a {named}, retracts are laid out for a {given}; give {cutter}.",
        named=cutter_name(other),
        given=cutter_name(given),
        cutter=Option("cutter"),
    )
    return (report_finding(Code.CUTTER_DIFFERS, text),)


def _off_shape(other: Cutter, given: Cutter) -> float:
    """By how much, mm or rad, the CL file's cutter has another corner, taper or flank, or a thinner neck than
    the one given: a neck thinner than the file's has the room of the file's. Only one of two with a flank has
    another shape altogether."""
    thicker = max((given.neck or given.diameter) - other.neck, 0.0) if other.neck is not None else 0.0
    if (other.flank is None) != (given.flank is None):
        return other.diameter
    flank = abs((other.flank or 0.0) - (given.flank or 0.0))
    return max(abs(other.corner - given.corner), abs(other.taper - given.taper), thicker, flank)
