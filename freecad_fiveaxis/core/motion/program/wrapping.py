# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the controller takes a rotary word, as the machine file's ``wrap_strategy`` says.

unwound   absolute, any number of turns: the axis turns to exactly that word.
modulo    the word is 0 to 360, and the axis takes the shorter way to it. A block of half a turn or more
          cannot be said.
rezero    as unwound; the count of turns is set back by the operator or the control when the axis stands,
          never in a block.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers.dialect import Dialect

CIRCLE = 360.0


def wraps_of(rotary: Sequence[str], dialect: Dialect | None) -> tuple[str, str]:
    """How the words of the NC file are written: from 0 to 360 (``modulo``) only where the controller is known
    to take the shorter way. How they are meant is the machine file's affair alone, in writing as in
    reading."""
    shorter = dialect is not None and dialect.shorter_way
    first, second = ("unwound" if wrap == "modulo" and not shorter else wrap for wrap in rotary)
    return first, second


def shorter_turns(word: Floats, absolute: Bools | None = None) -> Ints:
    """Whole turns (n,) to add to words (n,) degrees so that each is reached by the shorter way from the one
    before.

    ``absolute`` (n,): where False the word was told as a step, which is never shortened. Row 0 gets none.
    """
    turns = np.zeros(len(word), np.int64)
    turns[1:] = -np.rint(np.diff(word) / CIRCLE)
    if absolute is not None:
        turns[~absolute] = 0
    return np.cumsum(turns)


def by_the_shorter_way(
    words: Floats,
    wrap: tuple[str, str],
    rotary: Sequence[str],
    letters: str,
    dialect: Dialect,
    feeding: Bools,
) -> tuple[Floats, tuple[Finding, ...]]:
    """Return the words (m, 5) mm and degrees as the axes really turn, and what there is to say about it.

    ``rotary``: the machine's strategies, ``wrap``: how they are written (``wraps_of``); ``feeding`` (m,) is
    False in rapids. Where the machine file says modulo no block turns by more than half a turn, however its
    words are written: so both kinds of control do the same with them, and the reader finds the same places.
    """
    found: list[Finding] = []
    for k in (0, 1):
        letter = letters[3 + k]
        if rotary[k] != wrap[k]:
            text = say(
                "{name} does not take the shorter way to a word of 0 to 360, as the machine file says of "
                "{letter} (modulo): the words count their turns on. Set the control accordingly, or "
                "wrap_strategy to unwound.",
                name=dialect.name,
                letter=letter,
            )
            found.append(report_finding(Code.WRAP_NOT_WRITTEN, text))
        if rotary[k] != "modulo":
            continue
        turns = shorter_turns(words[:, 3 + k])
        if turns.any():
            other = np.flatnonzero(np.diff(turns, prepend=0))
            words = words.copy(order="K")
            words[:, 3 + k] = round_as_printed(words[:, 3 + k] + CIRCLE * turns, dialect.rotary_decimals)
            found.append(_other_way(letter, other, feeding))
    return words, tuple(found)


def _other_way(letter: str, blocks: Ints, feeding: Bools) -> Finding:
    cutting = int(feeding[blocks].sum())
    text = say(
        "{count} blocks would turn {letter} by more than half a turn ({cutting} of them feed blocks); the "
        "control takes the shorter way there (wrap_strategy modulo), and so do the words here. Divide "
        "blocks, or set wrap_strategy to unwound.",
        count=len(blocks),
        letter=letter,
        cutting=cutting,
    )
    severity = Severity.WARNING if cutting else Severity.NOTE
    return report_finding(
        Code.TURNED_THE_SHORTER_WAY, text, float(len(blocks)), block=int(blocks[0]), severity=severity
    )
