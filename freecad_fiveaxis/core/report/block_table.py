# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of blocks: one CSV row for every motion block, rapids too.

block    the row of the Program, counted from 0 (as in ``Finding.block``); row 0 is the first position, all
         figures 0.
line     the line of the NC file, counted from 1.
words    the block's end, mm and degrees, turns not folded; X Y Z and then the machine's two rotary letters
         sorted. Where the controller guides the tip X Y Z are the tip's place, and the deviations are 0: they
         are not ours to measure.
bound    rounded up, so that what is read back is still a bound.
surface  deviation and bound of the point that makes the surface: only where that is not the tip (a ball's
         centre); last columns.
depth    only where the program was checked against the part: how deep cutter, shank or holder go into it in
         the block, mm.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freecad_fiveaxis.core.base.number_text import Choice, Column, Part, table
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.gouge import GougeCheck
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.singularity import Singularity
from freecad_fiveaxis.core.toolpath.cl_path import Motion

DECIMALS = 6
"""Millimetres, degrees and u: finer than any controller's step, so that a rounded word is written exactly."""


def letter_order(letters: str) -> list[int]:
    """Return the columns of the words as people read them: X Y Z, then the rotary letters sorted ("XYZCA": 0
    1 2 4 3); only those that the machine has."""
    return [0, 1, 2, *sorted(find_physical_columns(letters)[3:], key=lambda column: letters[column])]


def header(letters: str, depth: bool = False, surface: bool = False) -> str:
    """Return the column names for the machine's ``letters`` (in the order of the words, as "XYZCA");
    ``depth``, ``surface``: the last ones too."""
    words = ",".join(letters[column] for column in letter_order(letters))
    of_deviation = "u_line,line_deviation,u_segment,segment_deviation,bound,axis_deviation,singular"
    names = f"block,line,motion,{words},feed,{of_deviation}"
    return names + ",depth" * depth + ",surface_deviation,surface_bound" * surface


def block_columns(program: Program, numbers: Iterable[Floats]) -> list[Part]:
    """Return the columns that every table of blocks begins with, and these ``numbers``, each (m,)."""
    return [
        Column(b"", np.arange(len(program.words))),
        Column(b",", program.line),
        b",",
        Choice(program.motion, [motion.name.lower().encode() for motion in Motion]),
        *(Column(b",", values, DECIMALS) for values in numbers),
    ]


def round_up(values: Floats, decimals: int = DECIMALS) -> Floats:
    """Return the smallest decimal fractions of so many decimals that are not below ``values`` (n,)."""
    step = 10.0**decimals
    count = np.ceil(values * step)
    return np.where(count / step < values, count + 1.0, count) / step


def blocks_csv(
    program: Program, deviation: Deviation, singularity: Singularity, progress: Progress = silent,
    gouge: GougeCheck | None = None, surface: Deviation | None = None,
) -> bytes:  # fmt: skip
    """Return the whole table as ASCII text, lines ending in a line feed. All records have one row a block,
    ``gouge`` one less."""
    rows = len(program.words)
    # adding 0 turns -0 into 0
    words = [_take_programmed(program, column) + 0.0 for column in letter_order(program.letters)]
    figures = [
        deviation.u_line,
        deviation.line,
        deviation.u_segment,
        deviation.segment,
        round_up(deviation.bound),
    ]
    numbers = [*words, program.feed, *figures, np.degrees(deviation.axis)]
    parts = block_columns(program, numbers)
    parts.append(Column(b",", singularity.singular.astype(np.int64)))
    if gouge is not None:
        depth = np.maximum(gouge.cutter.depth, gouge.above.depth)
        parts.append(Column(b",", np.append(0.0, depth)[:rows], DECIMALS))
    if surface is not None:
        parts += [Column(b",", values, DECIMALS) for values in (surface.segment, round_up(surface.bound))]
    return (
        header(program.letters, gouge is not None, surface is not None).encode()
        + b"\n"
        + table(parts, progress=progress)
    )


def _take_programmed(program: Program, column: int) -> Floats:
    """Return the words (m,) of one letter as the NC file says them: the tip's place where the controller
    guides it."""
    if program.guided is None or column >= 3:
        return program.words[:, column]
    return np.where(program.guided.on, program.guided.tip[:, column], program.words[:, column])
