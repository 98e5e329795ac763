# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text from a Program and a dialect: the head, exactly one line a block, the tail."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.number_text import (
    EXACT,
    Choice,
    Column,
    Part,
    Units,
    nearest_whole,
    round_as_printed,
    table_parts,
)
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .head import PostOptions, slot_texts, write_head_and_tail
from .start import start_words


def write_nc(
    program: Program, dialect: Dialect, title: str, options: PostOptions | None = None,
    progress: Progress = silent,
    height: float = 0.0,
) -> bytes:  # fmt: skip
    """Return the NC file as ASCII; ``height`` mm: the word of Z of the plane above the part, for a dialect
    that starts and ends there.
     Block i stands in line ``dialect.first_line + i``; numbers are fixed-point, never "-0.0000".

    Modal words that do not change are left out (where the dialect is modal), the motion word never. Under G93
    every feed block has its F. Where the feed mode changes inside the program the block says so.
    """
    inverse_first = bool(program.inverse_time[0]) if len(program.words) else False
    modulo, start = "modulo" in program.wrap, start_words(program, dialect, height)
    slots = slot_texts(
        dialect, title, options or PostOptions(), inverse_first, program.letters, modulo, start
    )
    head, tail = write_head_and_tail(dialect, slots, len(program.words))
    rows = (
        table_parts(_block(program, dialect), dialect.newline.encode(), progress)
        if len(program.words)
        else ()
    )
    return b"".join([head, *rows, tail])


def _block(program: Program, dialect: Dialect) -> list[Part]:
    feeding, program = program.motion != Motion.RAPID, _in_units(program, dialect)
    motion = Choice(feeding.view(np.int8), (dialect.rapid.encode(), dialect.straight.encode()))
    start = [*_number(program, dialect), *_mode(program, dialect), motion]
    end = [Choice(feeding.view(np.int8), (dialect.rapid_end.encode(), b""))] if dialect.rapid_end else []
    return [*start, *_axes(program, dialect), *_feed(program, dialect, feeding), *end]


def _in_units(program: Program, dialect: Dialect) -> Program:
    """Return the program with F as the dialect counts it: inches a minute, but degrees where rotary axes move
    alone."""
    if dialect.unit == 1.0:
        return program
    linear = program.words[:, :3] if program.guided is None else program.guided.tip
    change = np.diff(np.column_stack([linear, program.words[:, 3:]]), axis=0, prepend=np.zeros((1, 5)))
    unit = np.where(program.inverse_time, 1.0, dialect.find_feed_units(change))
    return replace(program, feed=program.feed / unit)


def _number(program: Program, dialect: Dialect) -> list[Part]:
    if not dialect.number_step:
        return []
    count, place = dialect.number_most // dialect.number_step, np.arange(len(program.words))
    at = (place + len(dialect.head)) % dialect.number_most if dialect.number_all else place % count + 1
    return [Column(dialect.number_letter.encode(), at * dialect.number_step), b" "]


def _mode(program: Program, dialect: Dialect) -> list[Part]:
    changed = _find_changes(program.inverse_time)
    changed[0] = False  # the head has said it
    if not changed.any():
        return []
    codes = np.where(changed, 1 + program.inverse_time.astype(np.int64), 0)
    return [Choice(codes, (b"", f"{dialect.per_minute} ".encode(), f"{dialect.inverse_time} ".encode()))]


def _axes(program: Program, dialect: Dialect) -> Sequence[Part]:
    addresses = _address_words(program, dialect)
    words = [_word(one, len(program.words)) for one in addresses]
    if dialect.modal:
        words = _modal(words, dialect.guide is not None and dialect.guide.vector is not None)
    return [
        part for word, one in zip(words, addresses, strict=True) for part in _spelt(word, one, dialect.plus)
    ]


@dataclass(frozen=True)
class _AddressWord:
    """One word of every block: ``values`` (m,) with ``decimals``; ``close`` stands after the number;
    ``fold``: 0 to 360."""

    prefix: str
    values: Floats
    decimals: int
    close: str = ""
    fold: bool = False


def _address_words(program: Program, dialect: Dialect) -> list[_AddressWord]:
    """Return the words in the order of the block. Raises ProgramError where the dialect guides and the
    program is for joints, or not."""
    guided = program.guided if len(program.words) else None
    if len(program.words) and (guided is None) != (dialect.guide is None):
        raise ProgramError(
            say("the program was not built for {name} as it is to be written", name=dialect.name),
            dialect.name,
        )
    linear = program.words if guided is None else guided.tip
    order = sorted(
        find_physical_columns(program.letters),
        key=lambda column: dialect.order.index(program.letters[column]),
    )
    vector = None if guided is None or dialect.guide is None else dialect.guide.vector
    addresses = [
        _axis_word(program, column, linear, dialect) for column in order if column < 3 or vector is None
    ]
    if vector is not None and guided is not None and guided.vector is not None and dialect.guide is not None:
        decimals = dialect.guide.vector_decimals
        addresses += [
            _AddressWord(f" {word}", guided.vector[:, k], decimals) for k, word in enumerate(vector)
        ]
    return addresses


def _axis_word(program: Program, column: int, linear: Floats, dialect: Dialect) -> _AddressWord:
    letter = " " + program.letters[column]
    if column < 3:
        values = linear[:, column]
        in_its_unit = values if dialect.unit == 1.0 else values / dialect.unit
        return _AddressWord(letter, in_its_unit, dialect.linear_decimals)
    fold = program.wrap[column - 3] == "modulo"
    before, after = dialect.shorter_word if fold else ("", "")
    return _AddressWord(letter + before, program.words[:, column], dialect.rotary_decimals, after, fold)


def _modal(words: list[Column | Units], vector: bool) -> list[Column | Units]:
    """Only the words that change; a tool vector always whole; where nothing changes, the first word."""
    shows = in_threads(lambda word: _find_changes(word.values), words)
    if vector:
        shows[-3:] = [np.logical_or.reduce(shows[-3:])] * 3
    shows[0] = shows[0] | ~np.logical_or.reduce(shows)  # a block without any change still needs an axis word
    return [replace(word, show=show) for word, show in zip(words, shows, strict=True)]


def _spelt(word: Column | Units, address: _AddressWord, signed: bool) -> list[Part]:
    """Return the word as the parts of a block: with a plus sign where the dialect has one, and what stands
    after the number."""
    parts: list[Part] = [word]
    shown = np.ones(len(word.values), np.bool_) if word.show is None else word.show
    if signed:
        positive = word.values >= 0
        parts = [
            replace(word, prefix=word.prefix + b"+", show=shown & positive),
            replace(word, show=shown & ~positive),
        ]
    if address.close:
        parts.append(Choice(shown.view(np.int8), (b"", address.close.encode())))
    return parts


def _word(address: _AddressWord, rows: int) -> Column | Units:
    """One word: counted in steps where a whole number can hold that, so that it is rounded only once."""
    prefix, steps = address.prefix.encode(), np.empty(rows)

    def count(part: slice) -> bool:
        step = np.multiply(address.values[part], 10.0**address.decimals, out=steps[part])
        exact = bool(np.maximum(-step.min(), step.max()) < EXACT)  # NaN comes out of max
        nearest_whole(step)
        return exact

    if not all(in_threads(count, chunks(rows))):
        return Column(prefix, round_as_printed(address.values, address.decimals), address.decimals)
    counted = steps.view(np.int64)
    return Units(
        prefix, counted % (360 * 10**address.decimals) if address.fold else counted, address.decimals
    )


def _feed(program: Program, dialect: Dialect, feeding: Bools) -> list[Part]:
    inverse = feeding & program.inverse_time
    per_minute = feeding & ~program.inverse_time
    if dialect.modal and per_minute.any():
        per_minute &= _feed_changed(program, feeding)
    pairs = ((inverse, dialect.inverse_decimals), (per_minute, dialect.feed_decimals))
    return [Column(b" F", program.feed, decimals, show) for show, decimals in pairs if show.any()]


def _feed_changed(program: Program, feeding: Bools) -> Bools:
    """Where F or its mode is not that of the last block before that had one."""
    changed = _find_changes(program.feed)
    changed |= _find_changes(program.inverse_time)
    begin = np.flatnonzero(feeding[1:] & ~feeding[:-1]) + 1  # blocks after rapids
    end = np.flatnonzero(feeding[:-1] & ~feeding[1:])
    before = np.searchsorted(end, begin) - 1
    changed[begin] = True
    row, last = begin[before >= 0], end[before[before >= 0]]
    changed[row] = (program.feed[row] != program.feed[last]) | (
        program.inverse_time[row] != program.inverse_time[last]
    )
    return changed


def _find_changes(column: NDArray[Any]) -> Bools:
    changed = np.ones(len(column), np.bool_)
    np.not_equal(column[1:], column[:-1], out=changed[1:])
    return changed
