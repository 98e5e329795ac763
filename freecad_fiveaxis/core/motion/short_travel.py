# SPDX-License-Identifier: LGPL-2.1-or-later
"""What helps where a linear axis is driven beyond a limit: another work zero, where its travel is long
enough."""

from __future__ import annotations

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, say


def say_remedy_beyond_limit(letter: str, words: Floats, low: float, high: float) -> Sentence:
    """Say what helps where ``words`` (n,) mm of a linear axis leave ``low`` to ``high`` mm: to move the work
    zero, unless they span more than the axis has, and then by how much it is too short."""
    span, travel = float(words.max() - words.min()), high - low
    if span <= travel:
        return say("move the work zero ({origin}) or take a larger machine.", origin=Option("origin"))
    return say(
        "the program needs {span} of {letter}, whose travel is {travel}, {short} too short. Take a larger "
        "machine, or mill less of the part at once.",
        span=Length(span, ".6g"), letter=letter, travel=Length(travel, ".6g"),
        short=Length(span - travel, ".6g"),
    )  # fmt: skip
