# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's ``trivkins``: every joint is an axis word, P = J - t ez. It knows of no rotary line.

linear   X, Y and Z make a machine of three axes.
one      with one rotary axis A or B, no configuration says what it carries, where its line runs and which way
         it turns. Taken: it turns the table about the line through the machine's zero along X or Y, with the
         sign of ISO 841. A finding says so.
two      of two rotary axes nothing says which carries which, so they are refused; as is C alone, which never
         tilts the tool.

Source: ``trivkins.c``.
"""

from __future__ import annotations

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Sentence, say
from freecad_fiveaxis.core.machine.machine_file import list_shipped_machines, load_machine

from .record import Given, Kinematics, Turn, X, Y

DIRECTIONS = {"A": X, "B": Y}


def _turns(given: Given) -> tuple[Turn, ...]:
    rotary = [letter for letter in "ABC" if letter in given.letters]
    _check(given, rotary)
    return tuple(Turn(letter, "table", DIRECTIONS[letter], (0.0, 0.0, 0.0)) for letter in rotary)


def _check(given: Given, rotary: list[str]) -> None:
    """Refuse axes that make no machine."""
    problem: str = ""
    if lacking := [letter for letter in "XYZ" if letter not in given.letters]:
        problem = say(
            "without {letters} there is no milling machine; name X, Y and Z", letters=" and ".join(lacking)
        )
    elif len(rotary) > 1:
        problem = _say_undecided(rotary)
    elif rotary == ["C"]:
        problem = say(
            "C alone is parallel to the tool and never tilts it; leave C out for a machine of three axes"
        )
    if problem:
        raise MachineError(
            say(
                "{where}: trivkins has the axes {letters}; {problem}",
                where=given.where,
                letters=given.letters,
                problem=problem,
            ),
            given.letters,
        )


def _say_undecided(rotary: list[str]) -> Sentence:
    """Say what to do with several rotary axes: to begin with a machine that has them."""
    alike = [name for name in list_shipped_machines() if _letters(name) == rotary]
    if not alike:
        return say(
            "nothing says where {letters} stand and which carries which; describe the machine by hand "
            "(docs/adding.md)",
            letters=" and ".join(rotary),
        )
    return say(
        "nothing says where {letters} stand and which carries which; copy the file of a shipped machine "
        "with these axes ({alike}) and write their lines, signs, limits and rates into it by hand "
        "(docs/adding.md)",
        letters=" and ".join(rotary),
        alike=", ".join(alike),
    )


def _letters(name: str) -> list[str]:
    return sorted(axis.letter for axis in load_machine(name).rotary if axis.fitted)


def _remarks(given: Given) -> tuple[Finding, ...]:
    rotary = [letter for letter in DIRECTIONS if letter in given.letters]
    if not rotary:
        return ()
    text = say(
        "trivkins does not say where {letter} stands. Taken: it turns the table about the line through the "
        "machine's zero along {along}, with the sign of ISO 841. Correct what is otherwise in the machine "
        "file; prove the signs before cutting.",
        letter=rotary[0],
        along="X" if rotary[0] == "A" else "Y",
    )
    return (report_finding(Code.ROTARY_ASSUMED, text),)


TRIVIAL = (Kinematics("trivkins", "XYZABCUVW", "", _turns, _remarks, spare="XYZABCUVW"),)
