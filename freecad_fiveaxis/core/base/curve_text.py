# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves as the user gives them: a CSV file, or the lines of one in its place.

run      rows that follow one another: a curve. A blank line ends it.
inline   ``X,Y,Z;X,Y,Z;...``: a semicolon stands for the end of a line, two for a blank line.
"""

from __future__ import annotations

import csv
import io
import itertools
from pathlib import Path

from .files import read_bytes
from .sentences import one_line

END_OF_LINE, ENDING = ";", ".csv"

LONGEST_NAME = 40
"""Characters of an inline curve that a message repeats."""

Run = list[list[str]]


def is_inline(source: str) -> bool:
    """Tell whether a source is a curve itself, and no file's name."""
    return END_OF_LINE in source and not source.lower().endswith(ENDING)


def name_source(source: str) -> str:
    """Name a source in a message: the file, or how the inline curve begins."""
    if not is_inline(source):
        return one_line(Path(source).name)
    return source if len(source) <= LONGEST_NAME else source[: LONGEST_NAME - 1] + "…"


def read_runs(source: str, what: str, most_bytes: float = float("inf")) -> list[Run]:
    """Read the rows of cells of each curve, without the names of the columns; none where the file has more
    than ``most_bytes`` or is no text. ``what`` it is, in a message. Raises FileError for a file that cannot
    be read."""
    text = source.replace(END_OF_LINE, "\n")
    if not is_inline(source):
        data = read_bytes(source, what)
        if len(data) > most_bytes:
            return []
        text = data.decode("utf-8-sig", "replace")
    try:
        rows = list(csv.reader(io.StringIO(text, newline="")))
    except csv.Error:
        return []
    runs = [
        list(run)
        for some, run in itertools.groupby(rows, lambda row: any(cell.strip() for cell in row))
        if some
    ]
    if runs and not is_number(runs[0][0][0]):
        runs = [run for run in (runs[0][1:], *runs[1:]) if run]
    return runs


def is_number(text: str) -> bool:
    """Tell whether Python reads a number from the text."""
    try:
        float(text)
    except ValueError:
        return False
    return True
