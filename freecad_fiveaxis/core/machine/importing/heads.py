# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's machines with a tilting head: ``5axiskins`` and ``maxkins``.

L      the pin pivot-length; t: the tool length. Both modules have B reversed (ISO 841 has it the other way
       round).
5axis  a fork C carries B. L is meant to be the distance from the gauge point to the pivot, plus t:
           P = J + L ez - (L + W) k          k = Rz(C) Ry(-B) ez
       so C runs through the gauge point, and B through the point L - t above it. Source: ``5axiskins.c``.
max    a head B over a table C. It moves the joints by its inverse,
           J = Rz(-C) P + (L + W) Ry(-B) ez - L ez          k = Rz(C) Ry(-B) ez
       C runs through the machine's zero, B through the point L above the gauge point. t enters as W. The
       module's own forward takes the head's part without turning it by C: it is no inverse of that where B
       and C are both off zero. The pin conventional-directions, which newer versions have, makes B that of
       ISO 841. Source: ``maxkins.c``.
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, say

from .record import Given, Kinematics, Pin, Turn, Y, Z, apply_sense

PIVOT = "pivot-length"


def _fork(given: Given) -> tuple[Turn, ...]:
    """Return the fork C that carries B."""
    pivot = (0.0, 0.0, given.values[PIVOT])
    return Turn("C", "head", Z, (0.0, 0.0, 0.0)), Turn("B", "head", apply_sense(Y, -1.0), pivot)


def _fork_remarks(given: Given) -> tuple[Finding, ...]:
    if given.follows_tool:
        return ()
    text = say(
        "pivot-length is a constant {pivot}, so LinuxCNC takes the same tool length for every tool; "
        "add motion.tooloffset.z to it by a sum2, or measure tools from the tip of that one.",
        pivot=Length(given.values[PIVOT]),
    )
    return (report_finding(Code.CONSTANT_TOOL_OFFSET, text, given.values[PIVOT]),)


def _head_over_table(given: Given) -> tuple[Turn, ...]:
    """Return the head B over the table C."""
    sense = 1.0 if given.values["conventional-directions"] else -1.0
    pivot = (0.0, 0.0, given.values[PIVOT])
    return Turn("C", "table", Z, (0.0, 0.0, 0.0)), Turn("B", "head", apply_sense(Y, sense), pivot)


def _max_remarks(given: Given) -> tuple[Finding, ...]:
    forward = say(
        "maxkins shows wrong positions where B and C are both off zero: its forward formula does not fit "
        "the one that moves the joints. The machine is that of the latter; home it with B or C at 0."
    )
    length = say(
        "maxkins turns the tool length with the head only where it is a W offset of the tool table; enter it "
        "there."
    )
    return (
        report_finding(Code.FORWARD_DIFFERS, forward),
        report_finding(Code.TOOL_LENGTH_IN_W, length),
    )


HEADS = (
    Kinematics(
        "5axiskins", "XYZBCW", "XYZBCW", _fork, _fork_remarks, spare="AUV", tool=PIVOT, tool_in=True,
        pins=(Pin(PIVOT, 250.0),),
    ),
    Kinematics(
        "maxkins", "XYZABCUVW", "XYZBC", _head_over_table, _max_remarks, spare="AUVW", fixed=True,
        pins=(Pin(PIVOT, 0.666), Pin("conventional-directions", required=False, length=False)),
    ),
)  # fmt: skip
