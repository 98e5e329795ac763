# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subprograms behind the closing ``%``: stretches of their own in the same file, each from its O number on.

A stretch is read where the program, or one that is read, calls its number (M98, G65, G66) and has it not
itself. A control that reads the file as one tape stops at the ``%`` before.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from freecad_fiveaxis.core.base.sentences import say

Span = tuple[int, int]
HEAD = re.compile(rb"^ *[O:] *0*([0-9]+)", re.MULTILINE)
CALL = re.compile(rb"(?:M *0*98|G *6[56](?:\.1)?)(?![0-9.])[^\n]*?P *0*([0-9]+)")
FEWEST = 10_000
"""From this number on, the last four digits may be the program and those before how often it runs."""


def find_called(text: bytes, program: Span, behind: Sequence[Span]) -> dict[int, Span]:
    """Return the stretches ``behind`` that are called, by their number, in the order of the calls."""
    heads = {
        int(found[1]): span for span in behind if (found := HEAD.match(text[slice(*span)].lstrip(b"\n")))
    }
    called, waiting, known = dict[int, Span](), [program], set[int]()
    while waiting and heads:
        own = text[slice(*waiting.pop(0))]
        known |= {int(one) for one in HEAD.findall(own)}
        for number in map(int, CALL.findall(own)):
            name = number % FEWEST if number >= FEWEST and number not in heads else number
            if name in heads and name not in called and name not in known:
                called[name] = heads[name]
                waiting.append(heads[name])
    return called


def join_sections(text: bytes, program: Span, called: dict[int, Span]) -> bytes:
    """Return the text from the program's begin on with an end in the place of its ``%``, and of all behind it
    the stretches that are called; every line stays where it is."""
    parts, end = [text[slice(*program)]], program[1]
    for begin, last in sorted(called.values()):
        between = re.sub(rb"[^\n]", b"", text[end:begin])
        parts += [(b"M30" if end == program[1] else b"") + between, text[begin:last]]
        end = last
    return b"".join(parts)


def sentence_of(called: dict[int, Span]) -> str:
    """Say which stretches are read."""
    names = ", ".join(f"O{number}" for number in called)
    return say(
        "The programs {names} behind the closing % are called, and read. A control may stop at that %: load "
        "each by itself.",
        names=names,
    )
