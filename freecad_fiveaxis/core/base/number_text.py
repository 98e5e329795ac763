# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of fixed-point numbers as text, byte for byte what ``%.4f`` gives; for NC, CL and CSV files.

piece   a few bytes of every row, taken from a lookup table by the digits of the number: the integer part with
        its prefix, sign and point, then four decimals at a time.
pad     the byte 0, which fills a piece up to its fixed width from the left and is deleted at the end.

A row is a fixed number of bytes while it is put together, so that every step works on a whole column. Pads
stand in one run before each number: the deletion then mispredicts one branch a number, not two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from io import BytesIO
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .chunks import in_threads
from .progress import Progress, silent
from .records import Bools, Floats, Ints

CHUNK = 65536
"""Rows put together at a time: few enough for their buffer to stay in the cache, enough for two threads to
work side by side."""
HELD = 1 << 21
"""Rows whose portions are held until all of them are put together: about 100 MB of text."""
OFTEN = 0.75
"""A word that stands in more of the rows is worked out in all of them: to pick rows has its price too."""
GROUP = 10_000
"""A piece holds four digits: its table then stays in the cache."""
EXACT = 1e15
"""Scaled numbers below this are exact in a double, with room to tell a tie from its neighbours (2^52 =
4.5e15)."""
MOST_DECIMALS = 9
_WORDS = {1: "u1", 2: "u2", 4: "u4", 8: "u8"}
"""Pieces of these widths are copied as numbers, which is faster."""


@dataclass(frozen=True, eq=False)
class Column:
    """``prefix`` and then ``values`` (n,) with ``decimals`` (0 to 9; integers take 0); nothing where ``show``
    (n,) is False."""

    prefix: bytes
    values: Floats | Ints
    decimals: int = 0
    show: Bools | None = None


@dataclass(frozen=True, eq=False)
class Units:
    """``prefix`` and then ``values`` (n,) counted in units of the last decimal: 12345 with 4 ``decimals`` is
    1.2345."""

    prefix: bytes
    values: Ints
    decimals: int
    show: Bools | None = None


@dataclass(frozen=True, eq=False)
class Choice:
    """One of a few texts in each row: ``texts[codes[i]]``, ``codes`` (n,)."""

    codes: NDArray[Any]
    texts: Sequence[bytes]


Part = Column | Units | Choice | bytes


def table(parts: Sequence[Part], end: bytes = b"\n", progress: Progress = silent) -> bytes:
    """All rows as text: in each row the parts one after the other and then ``end``. A bare ``bytes`` is the
    same in every row.

    Equal to joining ``prefix + "%.<decimals>f" % value`` row by row: the same rounding (of the exact binary
    value, ties to even), the same signs ("-0.0000" too), "nan" and "inf" and numbers of any size. Raises
    ValueError for columns of different lengths, decimals out of range, or a byte 0 in a text.
    """
    text = BytesIO()  # keeps one copy where a list of portions would keep two
    for portion in table_parts(parts, end, progress):
        text.write(portion)
    return text.getvalue()


def table_parts(
    parts: Sequence[Part], end: bytes = b"\n", progress: Progress = silent
) -> Iterator[bytes | memoryview]:
    """Yield the same, in portions of CHUNK rows, for writing to a file as they come."""
    rows = _check_rows(parts, end)

    def text(start: int) -> bytes | memoryview:
        return _chunk([_slice(part, start) for part in (*parts, end)], min(CHUNK, rows - start))

    for first in range(0, rows, HELD):
        stop = min(first + HELD, rows)
        yield from in_threads(text, range(first, stop, CHUNK), partial(_tell, progress, first, stop, rows))


def _tell(progress: Progress, first: int, stop: int, rows: int, done: float) -> None:
    progress("writing text", (first + done * (stop - first)) / rows)


def round_as_printed(values: Floats, decimals: int, unit: float = 1.0) -> Floats:
    """Return the doubles nearest to ``values`` as printed with ``decimals`` in units of ``unit`` each; -0
    becomes 0, so that no text reads "-0.0000"."""
    scale = 10.0**decimals
    result: Floats = values * (scale / unit)
    np.rint(result, out=result)
    result /= scale
    if unit != 1.0:
        result *= unit
    result += 0.0
    return result


def nearest_whole(values: Floats) -> Ints:
    """Return the whole numbers nearest to ``values`` below EXACT, ties to even, in the memory of ``values``,
    which are lost.

    From 2^52 to 2^53 the last bit of a double is worth 1: adding 1.5 2^52 rounds, and leaves the number in
    the lower bits.
    """
    shift = np.array(1.5 * 2.0**52)
    values += shift
    whole = values.view(np.int64)
    whole -= shift.view(np.int64)
    return whole


def _check_rows(parts: Sequence[Part], end: bytes) -> int:
    lengths = {
        len(part.codes if isinstance(part, Choice) else part.values)
        for part in parts
        if not isinstance(part, bytes)
    }
    if len(lengths) != 1:
        raise ValueError(f"columns of a text table have lengths {sorted(lengths)}; need one length")
    texts = [end]
    for part in parts:
        texts += (
            [part] if isinstance(part, bytes) else part.texts if isinstance(part, Choice) else [part.prefix]
        )
        if isinstance(part, (Column, Units)):
            most = MOST_DECIMALS if isinstance(part, Units) or part.values.dtype.kind == "f" else 0
            if not 0 <= part.decimals <= most:
                raise ValueError(
                    f"a column of {part.values.dtype} has {part.decimals} decimals; give 0 to {most}"
                )
    if any(b"\0" in text for text in texts):
        raise ValueError("a text of the table holds a byte 0, which is the padding")
    return lengths.pop()


def _slice(part: Part, start: int) -> Part:
    if isinstance(part, bytes):
        return part
    rows = slice(start, start + CHUNK)
    if isinstance(part, Choice):
        return Choice(part.codes[rows], part.texts)
    show = None if part.show is None else part.show[rows]
    if isinstance(part, Units):
        return Units(part.prefix, part.values[rows], part.decimals, show)
    return Column(part.prefix, part.values[rows], part.decimals, show)


class _Piece(NamedTuple):
    """``entries`` (n,) of one width; at least ``lead`` bytes on the left are pads in all of them."""

    entries: NDArray[Any]
    lead: int = 0


def _chunk(parts: Sequence[Part], rows: int) -> bytes | memoryview:
    """Return the text of one chunk.

    A piece's leading pads lie over the end of the piece before it, which is written after it: the rows are
    shorter then.
    """
    pieces: list[tuple[Ints | slice, _Piece]] = []
    for part in parts:
        place, shown = _select_rows(part)
        found = _pieces(shown, rows)
        if found is None:
            return _by_percent(parts, rows)
        pieces += [(place, piece) for piece in found]
    starts, width = [], 0
    for _, (entries, lead) in pieces:
        starts.append(width - min(lead, width))
        width = starts[-1] + entries.itemsize
    buffer = np.zeros(rows * width, np.uint8)
    for (place, (entries, _)), start in zip(reversed(pieces), reversed(starts), strict=True):
        np.ndarray((rows,), entries.dtype, buffer.data, start, (width,))[place] = entries
    kept: NDArray[np.uint8] = buffer[buffer != 0]  # bytes.translate would keep the other thread waiting
    return kept.data


def _select_rows(part: Part) -> tuple[Ints | slice, Part]:
    """Return the rows to work out of a part, and the part of these rows: of a word that is often left out
    only those where it stands."""
    if isinstance(part, (bytes, Choice)) or part.show is None:
        return slice(None), part
    place = np.flatnonzero(part.show)
    if len(place) > OFTEN * len(part.show):
        return slice(None), part
    values: Any = part.values.take(place)
    return place, replace(part, values=values, show=None)


def _pieces(part: Part, rows: int) -> list[_Piece] | None:
    """Return the pieces of one part, left to right, each (rows,); None where only ``%`` can print a
    number."""
    if isinstance(part, bytes):
        return [_Piece(np.broadcast_to(_texts((part,)), (rows,)))] if part else []
    if isinstance(part, Choice):
        return [_Piece(_texts(tuple(part.texts)).take(part.codes))] if any(part.texts) else []
    scaled = _scale_values(part)
    top = float(
        scaled.view(np.uint64).max(initial=0)
    )  # the least int64 has no absolute value, and comes out huge
    if not top < EXACT:
        return None
    unit = 10**part.decimals
    whole = scaled // unit if part.decimals else scaled
    negative = np.signbit(part.values) if part.values.dtype.kind == "f" else part.values < 0
    pieces = _integer_part(part.prefix, whole, int(top) // unit, negative, part.decimals > 0)
    pieces += _decimals(scaled - whole * unit, part.decimals) if part.decimals else []
    if part.show is not None:
        hidden = np.flatnonzero(~part.show)
        for entries, _ in pieces:
            entries[hidden] = np.zeros((), entries.dtype)
    return pieces


def _scale_values(part: Column | Units) -> Ints:
    """|values| in units of the last decimal, rounded as ``%`` rounds; not below EXACT where a double cannot
    hold that exactly."""
    if part.values.dtype.kind != "f":
        return np.abs(part.values, dtype=np.int64)
    values = np.abs(part.values)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = values * 10.0**part.decimals
        nearest = np.rint(scaled)
        distance = np.subtract(scaled, nearest)
        np.abs(distance, out=distance)
        tie = distance.max(initial=0.0)
        if np.isnan(tie):  # a number that is not finite
            return np.full(len(values), -1, dtype=np.int64)
        if tie == 0.5:
            _settle_ties(np.flatnonzero(distance == 0.5), values, scaled, nearest, 10.0**part.decimals)
        return nearest.astype(np.int64)


def _settle_ties(rows: Ints, values: Floats, scaled: Floats, nearest: Floats, scale: float) -> None:
    """Where the rounded product looks like a tie, round by the exact product (Dekker's two-product, 1971)."""
    a, product = values[rows], scaled[rows]
    splitter = 134217729.0  # 2^27 + 1: cuts a double into two halves of 26 bits
    high = splitter * a - (splitter * a - a)
    scale_high = splitter * scale - (splitter * scale - scale)
    low, scale_low = a - high, scale - scale_high
    error = ((high * scale_high - product) + high * scale_low + low * scale_high) + low * scale_low
    below = np.floor(product)
    nearest[rows] = np.where(error > 0.0, below + 1.0, np.where(error < 0.0, below, nearest[rows]))


def _integer_part(prefix: bytes, whole: Ints, top: int, negative: Bools, point: bool) -> list[_Piece]:
    """Prefix, sign, the integer part (``top`` is the largest) by groups of four digits, and the point."""
    groups = 1
    while top >= GROUP**groups:
        groups += 1
    short = groups == 1
    pieces = []
    if len(prefix) > (2 if short and point else 3):  # no room in a head
        pieces, prefix = [_Piece(_texts((prefix,)).take(np.zeros(len(whole), np.int64)))], b""
    high = whole if short else whole // GROUP ** (groups - 1)
    index = np.multiply(negative, GROUP, dtype=np.int64)
    index += high
    used = len(prefix) + bool(negative.any()) + len(str(top // GROUP ** (groups - 1))) + (short and point)
    pieces.append(_Piece(_pick(_heads(prefix, short and point, short), index), 8 - used))
    for k in range(groups - 2, -1, -1):
        digits = whole // GROUP**k if k else whole
        leads = high == 0  # no digit stands before this group
        index = digits - high * GROUP
        index += np.multiply(leads, GROUP, dtype=np.int64)
        if k:
            index[leads & (digits == 0)] = 2 * GROUP
        last = point and not k
        pieces.append(_Piece(_pick(_groups(last), index), 3 if last else 0))
        high = digits
    return pieces


def _decimals(fraction: Ints, decimals: int) -> list[_Piece]:
    pieces = []
    for left in range(decimals, 0, -4):
        rest = 10 ** max(left - 4, 0)
        digits = fraction // rest if rest > 1 else fraction
        pieces.append(_Piece(_pick(_pad_digits(min(left, 4)), digits)))
        if rest > 1:
            fraction = fraction - digits * rest
    return pieces


def _pick(entries: NDArray[Any], index: Ints) -> NDArray[Any]:
    return entries.take(index, mode="clip")  # never out of range; "clip" spares take a copy


def _by_percent(parts: Sequence[Part], rows: int) -> bytes:
    """Return the plain way, for chunks with a number that is huge or not finite."""
    columns: list[list[bytes]] = []
    for part in parts:
        if isinstance(part, bytes):
            columns.append([part] * rows)
        elif isinstance(part, Choice):
            columns.append([part.texts[code] for code in part.codes])
        else:
            shown = [True] * rows if part.show is None else part.show.tolist()
            pairs = zip(_numbers(part), shown, strict=True)
            columns.append([part.prefix + number if show else b"" for number, show in pairs])
    return b"".join(b"".join(row) for row in zip(*columns, strict=True))


def _numbers(part: Column | Units) -> list[bytes]:
    if part.values.dtype.kind == "f":
        return [b"%.*f" % (part.decimals, value) for value in part.values.tolist()]
    if not part.decimals:
        return [b"%d" % value for value in part.values.tolist()]
    pairs = [
        (b"-" if value < 0 else b"", *divmod(abs(value), 10**part.decimals)) for value in part.values.tolist()
    ]
    return [b"%s%d.%0*d" % (sign, whole, part.decimals, fraction) for sign, whole, fraction in pairs]


@lru_cache(maxsize=64)
def _texts(texts: tuple[bytes, ...]) -> NDArray[Any]:
    """Return the texts padded from the left to one width, where it can be that of a machine word."""
    width = max(len(text) for text in texts)
    width = next((word for word in (1, 2, 4, 8) if width <= word), width)
    return np.frombuffer(b"".join(text.rjust(width, b"\0") for text in texts), _WORDS.get(width, f"V{width}"))


def _digits(width: int) -> NDArray[np.uint8]:
    number = np.arange(10**width)
    return np.stack([48 + number // 10**k % 10 for k in range(width - 1, -1, -1)], axis=1).astype(np.uint8)


@lru_cache(maxsize=8)
def _pad_digits(width: int) -> NDArray[Any]:
    """``width`` digits with leading zeros."""
    return _digits(width).view(_WORDS.get(width, f"V{width}"))[:, 0]


@lru_cache(maxsize=2)
def _groups(point: bool) -> NDArray[Any]:
    """Four digits and maybe the point: with leading zeros, then without, then one entry of pads."""
    entries = np.zeros((2 * GROUP + 1, 8 if point else 4), np.uint8)
    last = 7 if point else 4
    entries[:, last:] = ord(".")
    entries[:-1, last - 4 : last] = np.concatenate([_digits(4), _blank_digits()])
    entries[-1] = 0
    return entries.view(_WORDS[entries.shape[1]])[:, 0]


def _blank_digits() -> NDArray[np.uint8]:
    """Four digits with pads for leading zeros."""
    blank = _digits(4)
    for k in range(3):
        blank[: 10 ** (3 - k), k] = 0
    return blank


@lru_cache(maxsize=64)
def _heads(prefix: bytes, point: bool, zero: bool) -> NDArray[Any]:
    """Prefix, sign, integer part below GROUP and maybe the point in eight bytes: positive, then negative.

    Without ``zero`` the number 0 has no digit, because other groups follow.
    """
    blank = _blank_digits()
    if not zero:
        blank[0] = 0
    entries = np.zeros((2 * GROUP, 8), np.uint8)
    last = 7 if point else 8
    entries[:, last - 4 : last] = np.concatenate([blank, blank])
    entries[:, last:] = ord(".")
    width = np.tile((blank > 0).sum(1), 2)
    for k, byte in enumerate(reversed((*prefix, ord("-")))):
        rows = np.arange(GROUP, 2 * GROUP) if k == 0 else np.arange(2 * GROUP)
        sign = (rows >= GROUP) & (k > 0)
        entries[rows, last - 1 - width[rows] - k + (~sign & (k > 0))] = byte
    return entries.view("u8")[:, 0]
