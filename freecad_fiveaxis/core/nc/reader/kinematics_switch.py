# SPDX-License-Identifier: LGPL-2.1-or-later
"""The switch of kinematics that is coming in LinuxCNC: G12.1 P selects one by its number, G13.1 goes back to
the axes.

Source: LinuxCNC's pull requests 4414 (G12.1 and G13.1, merged), 4534 (M428 of the bridge mill as G12.1 P0)
and 4374 (the whole of the work on several axes, open; G43.4 and G43.5 there select the same kinematics, and
G49 and G13.1 end it). What a number means is the kinematics module's: 0 is the tip on the trt modules and on
5axiskins, where the remap M428 says G12.1 P0 too, 1 the axes (M429). With ``identityfirst``, and in the trsrn
modules, it is the other way round; so which way was taken is said.

Without P it is Fanuc's polar coordinate interpolation, which is not interpreted.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .codes import Grammar
from .lines import Lines
from .noted import kind_findings

TIP, AXES = 0, 1
"""Numbers of kinematics, as the modules that LinuxCNC ships count them."""


def _match_switches(lines: Lines, grammar: Grammar) -> tuple[Ints, Ints, Ints]:
    """Return the lines of the switch that go to the tip's kinematics, to the axes, and to one that is not
    known."""
    chosen = (
        np.flatnonzero(lines.any_of(codes.KINEMATICS[:1])) if grammar.name == "iso" else np.empty(0, np.int64)
    )
    number = lines.column("P")[chosen] if len(chosen) else np.empty(0)
    other = ~np.isnan(number) & (number != TIP) & (number != AXES)
    return chosen[number == TIP], chosen[number == AXES], chosen[other]


def find_switches(lines: Lines, grammar: Grammar) -> list[tuple[Ints, bool]]:
    """Return the lines that switch to the tip and back, as events of the guide."""
    if grammar.name != "iso" or not np.isin(lines.code, codes.KINEMATICS).any():
        return []
    tip, axes, other = _match_switches(lines, grammar)
    back = np.flatnonzero(lines.any_of(codes.KINEMATICS[1:]))
    return [(np.concatenate([axes, other, back]), False), (tip, True)]


def switch_findings(lines: Lines, grammar: Grammar) -> list[Finding]:
    """Return what a number was taken for, those that are not known, and G12.1 without any."""
    if grammar.name != "iso" or codes.KINEMATICS[0] not in lines.code:
        return []
    tip, axes, other = _match_switches(lines, grammar)
    taken = np.sort(np.concatenate([tip, axes]))
    bare = np.flatnonzero(lines.any_of(codes.KINEMATICS[:1]) & np.isnan(lines.column("P")))
    found = [_report_numbers(int(taken[0]))] if len(taken) else []
    found += [_unknown(int(other[0]), float(lines.column("P")[other[0]]), len(other))] if len(other) else []
    found += kind_findings(codes.POLAR, {"G12.1": (int(bare[0]), len(bare))}) if len(bare) else []
    return found


def _report_numbers(row: int) -> Finding:
    text = say(
        "G12.1 P0 is taken as the kinematics of the tip (M428), G12.1 P1 as that of the axes (M429), as "
        "LinuxCNC's trt modules and 5axiskins count them. If the machine's module counts otherwise, the "
        "path is another: look into its HAL file."
    )
    return report_finding(Code.KINEMATICS_NUMBER, text, line=row)


def _unknown(row: int, number: float, count: int) -> Finding:
    text = say(
        "{count} lines select a kinematics that is not known here (the first: G12.1 P{number}); the words "
        "after them are taken as those of the axes. Post with G12.1 P0 and G13.1.",
        count=count,
        number=f"{number:g}",
    )
    return report_finding(Code.KINEMATICS_NOT_KNOWN, text, float(count), line=row)
