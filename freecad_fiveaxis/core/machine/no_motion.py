# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions of a machine's builder that move nothing: how a machine file writes them, and which it may name.

M202             an M function, with what stands in brackets behind it.
G05 P10000       a G code with one word of another letter.
CYCL DEF 392     a cycle of the builder, Heidenhain's 300 to 399 and 500 to 599: its line, and those that it
                 goes on in.
FUNCTION NAME    a function of klartext by its name.

What moves axes, turns coordinates, ends or calls a program, or says how words are meant, is none of these and
is refused.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import say

FORMS = re.compile(
    r"M0*(?P<m>[0-9]{1,6})|G0*(?P<g>[0-9]{1,3}(?:\.[0-9])?)(?: "
    r"(?P<word>[DEHKLPQRST])0*(?P<value>[0-9]{1,9}))?|"
    r"CYCL DEF (?P<cycle>[35][0-9]{2})|FUNCTION (?!RESET|TCPM|PROG|MODE|TURN|CORR|DRESS)[A-Z][A-Z0-9-]*"
)
READ_M = {0, 1, 2, 17, 30, 66, 70, 71, 72, 73, 89, 91, 92, *range(97, 100), *range(101, 150), 428, 429, 430}
"""M functions whose meaning is the reader's: ends, calls, machine positions, who guides the tip, Heidenhain's
path functions."""


def check_names(names: Iterable[str]) -> tuple[str, ...]:
    """Check names of functions without motion, and bring them to capitals and single blanks. Raises
    MachineError, with value and remedy."""
    return tuple(_check_name(" ".join(name.upper().split())) for name in names)


def _check_name(name: str) -> str:
    found = FORMS.fullmatch(name)
    if found is None or (found["g"] and not found["word"]):
        raise MachineError(
            say(
                "no_motion: {name} is no function that can be passed over; write one each as M202, G05 "
                "P10000, CYCL DEF 392 (300 to 399, 500 to 599) or FUNCTION NAME",
                name=repr(name[:40]),
            ),
            name,
        )
    if (found["m"] and int(found["m"]) in READ_M) or (found["g"] and float(found["g"]) < 4.0):
        raise MachineError(
            say("no_motion: {name} moves the tool or ends a program; leave it out", name=repr(name)), name
        )
    return name
