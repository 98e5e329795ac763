# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text from a Program and a dialect: the head, exactly one line a block, the tail."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from io import SEEK_END, BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.cl_path import Motion
from freecad_fiveaxis.core.kinematics import chunks
from freecad_fiveaxis.core.number_text import EXACT, Choice, Column, Part, Units, nearest_whole, rounded, table_parts
from freecad_fiveaxis.core.program import Program
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools

from .dialect import Dialect, PostOptions, slot_texts


def write_nc(
    program: Program, dialect: Dialect, title: str, options: PostOptions | None = None, progress: Progress = silent
) -> bytes:
    """The NC file as ASCII. Block i stands in line ``dialect.first_line + i``; numbers are fixed-point, never "-0.0000".

    Modal words that do not change are left out (where the dialect is modal), the motion word never. Under G93 every feed
    block has its F. Where the feed mode changes inside the program the block says so.
    """
    inverse_first = bool(program.inverse_time[0]) if len(program.words) else False
    slots = slot_texts(dialect, title, options or PostOptions(), inverse_first)
    head, tail = ([line.format(**slots) + dialect.newline for line in lines] for lines in (dialect.head, dialect.tail))
    text = BytesIO("".join(head).encode("ascii"))
    text.seek(0, SEEK_END)
    if len(program.words):
        for portion in table_parts(_block(program, dialect), dialect.newline.encode(), progress):
            text.write(portion)
    text.write("".join(tail).encode("ascii"))
    return text.getvalue()


def _block(program: Program, dialect: Dialect) -> list[Part]:
    feeding = program.motion != Motion.RAPID
    motion = Choice(feeding.view(np.int8), (dialect.rapid.encode(), dialect.straight.encode()))
    start = [*_number(program, dialect), *_mode(program, dialect), motion]
    return [*start, *_axes(program, dialect), *_feed(program, dialect, feeding)]


def _number(program: Program, dialect: Dialect) -> list[Part]:
    if not dialect.number_step:
        return []
    count = dialect.number_most // dialect.number_step
    number = (np.arange(len(program.words)) % count + 1) * dialect.number_step
    return [Column(b"N", number), b" "]


def _mode(program: Program, dialect: Dialect) -> list[Part]:
    changed = _changed(program.inverse_time)
    changed[0] = False  # the head has said it
    if not changed.any():
        return []
    codes = np.where(changed, 1 + program.inverse_time.astype(np.int64), 0)
    return [Choice(codes, (b"", f"{dialect.per_minute} ".encode(), f"{dialect.inverse_time} ".encode()))]


def _axes(program: Program, dialect: Dialect) -> Sequence[Part]:
    order = sorted(range(5), key=lambda column: dialect.order.index(program.letters[column]))
    words = [_word(program, column, dialect) for column in order]
    if not dialect.modal:
        return words
    shows = [_changed(word.values) for word in words]
    shows[0] |= ~np.logical_or.reduce(shows)  # a block without any change still needs an axis word
    return [replace(word, show=show) for word, show in zip(words, shows, strict=True)]


def _word(program: Program, column: int, dialect: Dialect) -> Column | Units:
    """One axis word: counted in steps where a whole number can hold that, so that it is rounded only once."""
    prefix, decimals = b" " + program.letters[column].encode(), dialect.decimals(column)
    words, steps = program.words[:, column], np.empty(len(program.words))
    for part in chunks(len(steps)):
        step = np.multiply(words[part], 10.0**decimals, out=steps[part])
        if not np.maximum(-step.min(), step.max()) < EXACT:  # NaN comes out of max
            return Column(prefix, rounded(words, decimals), decimals)
        nearest_whole(step)
    return Units(prefix, steps.view(np.int64), decimals)


def _feed(program: Program, dialect: Dialect, feeding: Bools) -> list[Part]:
    inverse = feeding & program.inverse_time
    per_minute = feeding & ~program.inverse_time
    if dialect.modal and per_minute.any():
        rows = np.flatnonzero(feeding)
        per_minute[rows] &= _changed(program.feed[rows]) | _changed(program.inverse_time[rows])
    pairs = ((inverse, dialect.inverse_decimals), (per_minute, dialect.feed_decimals))
    return [Column(b" F", program.feed, decimals, show) for show, decimals in pairs if show.any()]


def _changed(column: NDArray[Any]) -> Bools:
    changed = np.ones(len(column), np.bool_)
    np.not_equal(column[1:], column[:-1], out=changed[1:])
    return changed
