# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program as the machine gets it: words rounded to the controller's step, feeds, times.

block     one row: the straight joint move from the row before it to this one. Row 0 is the first position: where the
          machine comes from is not known, so nothing is claimed of it.
G94, G93  feed in mm/min, or inverse time: one over the minutes that the block takes.
"""

from __future__ import annotations

from dataclasses import dataclass

from .findings import Finding
from .records import Bools, Bytes, Floats, Ints, freeze


@dataclass(frozen=True, eq=False)
class Program:
    """``letters``: the five words in order: X Y Z, first rotary, second rotary (nearer to the work first), as "XYZCA".

    ``words`` (m, 5) mm and **degrees**, as rounded for the controller, turns not folded; ``feed`` (m,) the F word
    (mm/min, or 1/min where ``inverse_time``; 0 for rapids); ``inverse_time`` (m,) True under G93; ``motion`` (m,) of
    :class:`~freecad_fiveaxis.core.cl_path.Motion`; ``seconds`` (m,) the time that the block is meant to take (0 for row 0);
    ``row`` (m,) row of the CL path, -1 where there is none; ``line`` (m,) line of the NC file, counted from 1.
    """

    letters: str
    words: Floats
    feed: Floats
    inverse_time: Bools
    motion: Bytes
    seconds: Floats
    row: Ints
    line: Ints
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, words="f5", feed="f", inverse_time="b", motion="m", seconds="f", row="i", line="i")
