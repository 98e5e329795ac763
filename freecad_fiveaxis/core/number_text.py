# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of fixed-point numbers as text, byte for byte what ``%.4f`` gives; for NC, CL and CSV files.

piece   a few bytes of every row, taken from a lookup table by the digits of the number: the integer part with its prefix,
        sign and point, then four decimals at a time.
pad     the byte 0, which fills a piece up to its fixed width from the left and is deleted at the end.

A row is a fixed number of bytes while it is put together, so that every step works on a whole column. Pads stand in one
run before each number: the deletion then mispredicts one branch a number, not two.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .progress import Progress, silent
from .records import Bools, Floats, Ints

CHUNK = 8192
"""Rows put together at a time: the buffer then stays in the second-level cache."""
GROUP = 10_000
"""A piece holds four digits: its table then stays in the cache."""
EXACT = 1e15
"""Scaled numbers below this are exact in a double, with room to tell a tie from its neighbours (2^52 = 4.5e15)."""
MOST_DECIMALS = 9


@dataclass(frozen=True, eq=False)
class Column:
    """``prefix`` and then ``values`` (n,) with ``decimals`` (0 to 9; integers take 0); nothing where ``show`` (n,) is False."""

    prefix: bytes
    values: Floats | Ints
    decimals: int = 0
    show: Bools | None = None


@dataclass(frozen=True, eq=False)
class Choice:
    """One of a few texts in each row: ``texts[codes[i]]``, ``codes`` (n,)."""

    codes: NDArray[Any]
    texts: Sequence[bytes]


Part = Column | Choice | bytes


def table(parts: Sequence[Part], end: bytes = b"\n", progress: Progress = silent) -> bytes:
    """All rows as text: in each row the parts one after the other and then ``end``. A bare ``bytes`` is the same in every row.

    Equal to joining ``prefix + "%.<decimals>f" % value`` row by row: the same rounding (of the exact binary value, ties to
    even), the same signs ("-0.0000" too), "nan" and "inf" and numbers of any size. Raises ValueError for columns of
    different lengths, decimals out of range, or a byte 0 in a text.
    """
    text = BytesIO()  # keeps one copy where a list of portions would keep two
    for portion in table_parts(parts, end, progress):
        text.write(portion)
    return text.getvalue()


def table_parts(parts: Sequence[Part], end: bytes = b"\n", progress: Progress = silent) -> Iterator[bytes | bytearray]:
    """The same, in portions of CHUNK rows, for writing to a file as they come."""
    rows, buffer = _checked_rows(parts, end), bytearray()
    for start in range(0, rows, CHUNK):
        if start % (64 * CHUNK) == 0:
            progress("writing text", start / rows)
        yield _chunk([_slice(part, start) for part in (*parts, end)], min(CHUNK, rows - start), buffer)


def rounded(values: Floats, decimals: int) -> Floats:
    """The doubles nearest to ``values`` as printed with ``decimals``; -0 becomes 0, so that no text reads "-0.0000"."""
    scale = 10.0**decimals
    result: Floats = values * scale
    np.rint(result, out=result)
    result /= scale
    result += 0.0
    return result


def _checked_rows(parts: Sequence[Part], end: bytes) -> int:
    lengths = {len(part.values if isinstance(part, Column) else part.codes) for part in parts if not isinstance(part, bytes)}
    if len(lengths) != 1:
        raise ValueError(f"columns of a text table have lengths {sorted(lengths)}; need one length")
    texts = [end]
    for part in parts:
        texts += [part] if isinstance(part, bytes) else [part.prefix] if isinstance(part, Column) else part.texts
        if isinstance(part, Column):
            most = MOST_DECIMALS if part.values.dtype.kind == "f" else 0
            if not 0 <= part.decimals <= most:
                raise ValueError(f"a column of {part.values.dtype} has {part.decimals} decimals; give 0 to {most}")
    if any(b"\0" in text for text in texts):
        raise ValueError("a text of the table holds a byte 0, which is the padding")
    return lengths.pop()


def _slice(part: Part, start: int) -> Part:
    if isinstance(part, bytes):
        return part
    rows = slice(start, start + CHUNK)
    if isinstance(part, Choice):
        return Choice(part.codes[rows], part.texts)
    return Column(part.prefix, part.values[rows], part.decimals, None if part.show is None else part.show[rows])


def _chunk(parts: Sequence[Part], rows: int, buffer: bytearray) -> bytes | bytearray:
    """The text of one chunk; ``buffer`` is room to work in, kept from chunk to chunk."""
    pieces: list[NDArray[Any]] = []
    for part in parts:
        found = _pieces(part, rows)
        if found is None:
            return _by_percent(parts, rows)
        pieces += found
    width = sum(piece.itemsize for piece in pieces)
    if len(buffer) != rows * width:
        buffer[:] = bytes(rows * width)
    at = 0
    for piece in pieces:
        np.ndarray((rows,), piece.dtype, buffer, at, (width,))[:] = piece
        at += piece.itemsize
    return buffer.translate(None, b"\0")


def _pieces(part: Part, rows: int) -> list[NDArray[Any]] | None:
    """The pieces of one part, left to right, each (rows,); None where only ``%`` can print a number."""
    if isinstance(part, bytes):
        return [np.broadcast_to(_texts((part,)), (rows,))] if part else []
    if isinstance(part, Choice):
        return [_texts(tuple(part.texts)).take(part.codes)] if any(part.texts) else []
    scaled = _scaled(part)
    if scaled is None:
        return None
    unit = 10**part.decimals
    whole = scaled // unit if part.decimals else scaled
    fraction = scaled - whole * unit
    negative = np.signbit(part.values) if part.values.dtype.kind == "f" else part.values < 0
    hidden = None if part.show is None or part.show.all() else ~part.show
    top = int(whole.max(initial=0))
    if top < GROUP and len(part.prefix) <= 2:
        whole += np.multiply(negative, GROUP, dtype=np.int64)
        pieces = [_pick(_heads(part.prefix, part.decimals > 0), whole, hidden)]
    else:
        pieces = _wide(part, whole, top, negative, hidden)
    return pieces + _decimals(fraction, part.decimals, hidden)


def _scaled(part: Column) -> Ints | None:
    """|values| in units of the last decimal, rounded as ``%`` rounds; None where a double cannot hold that exactly."""
    if part.values.dtype.kind != "f":
        whole = np.abs(part.values.astype(np.int64))  # the least int64 stays negative, and goes to %
        fits = not len(whole) or (int(whole.max()) < EXACT and int(whole.min()) >= 0)
        return whole if fits else None
    values = np.abs(part.values)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = values * 10.0**part.decimals
        nearest = np.rint(scaled)
        distance = np.subtract(scaled, nearest)
        np.abs(distance, out=distance)
        if not scaled.max(initial=0.0) < EXACT:  # NaN comes out of max
            return None
    if distance.max(initial=0.0) == 0.5:
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


def _wide(part: Column, whole: Ints, top: int, negative: Bools, hidden: Bools | None) -> list[NDArray[Any]]:
    """Prefix with sign, then the integer part by groups of four digits, then the point."""
    codes = negative.astype(np.int64)
    pieces = [_texts((part.prefix, part.prefix + b"-", b"")).take(codes if hidden is None else np.where(hidden, 2, codes))]
    groups = 1
    while top >= GROUP**groups:
        groups += 1
    for k in range(groups - 1, -1, -1):
        digits = whole // GROUP**k
        lead = digits < GROUP  # no digit stands before this group
        blank = lead & (digits == 0) & (k > 0)
        index = digits % GROUP + lead * GROUP
        index[blank] = 2 * GROUP
        pieces.append(_pick(_groups(), index, hidden))
    if part.decimals:
        shown = np.zeros(len(whole), np.int64) if hidden is None else hidden.astype(np.int64)
        pieces.append(_texts((b".", b"")).take(shown))
    return pieces


def _decimals(fraction: Ints, decimals: int, hidden: Bools | None) -> list[NDArray[Any]]:
    pieces = []
    for left in range(decimals, 0, -4):
        rest = 10 ** max(left - 4, 0)
        digits = fraction // rest if rest > 1 else fraction
        fraction = fraction - digits * rest
        pieces.append(_pick(_fixed(min(left, 4)), digits, hidden))
    return pieces


def _pick(entries: NDArray[Any], index: Ints, hidden: Bools | None) -> NDArray[Any]:
    if hidden is not None:
        index = np.where(hidden, len(entries) - 1, index)
    return entries.take(index, mode="clip")  # never out of range; "clip" spares take a copy


def _by_percent(parts: Sequence[Part], rows: int) -> bytes:
    """The plain way, for chunks with a number that is huge or not finite."""
    columns: list[list[bytes]] = []
    for part in parts:
        if isinstance(part, bytes):
            columns.append([part] * rows)
        elif isinstance(part, Choice):
            columns.append([part.texts[code] for code in part.codes])
        else:
            form = b"%%.%df" % part.decimals if part.values.dtype.kind == "f" else b"%d"
            shown = [True] * rows if part.show is None else part.show.tolist()
            pairs = zip(part.values.tolist(), shown, strict=True)
            columns.append([part.prefix + form % value if show else b"" for value, show in pairs])
    return b"".join(b"".join(row) for row in zip(*columns, strict=True))


def _texts(texts: tuple[bytes, ...]) -> NDArray[Any]:
    """The texts padded from the left to one width."""
    width = max(len(text) for text in texts)
    return np.frombuffer(b"".join(text.rjust(width, b"\0") for text in texts), f"V{width}")


def _digits(width: int) -> NDArray[np.uint8]:
    number = np.arange(10**width)
    return np.stack([48 + number // 10**k % 10 for k in range(width - 1, -1, -1)], axis=1).astype(np.uint8)


@lru_cache(maxsize=8)
def _fixed(width: int) -> NDArray[Any]:
    """``width`` digits with leading zeros; the last entry is all pads."""
    entries = np.concatenate([_digits(width), np.zeros((1, width), np.uint8)])
    return np.ascontiguousarray(entries).view({1: "u1", 2: "u2", 3: "V3", 4: "u4"}[width])[:, 0]


@lru_cache(maxsize=1)
def _groups() -> NDArray[Any]:
    """Four digits: with leading zeros, then without, then one entry of pads."""
    full, blank = _digits(4), _digits(4)
    for k in range(3):
        blank[: 10 ** (3 - k), k] = 0
    return np.concatenate([full, blank, np.zeros((1, 4), np.uint8)]).view("u4")[:, 0]


@lru_cache(maxsize=64)
def _heads(prefix: bytes, point: bool) -> NDArray[Any]:
    """Prefix, sign, integer part below GROUP and point in eight bytes: positive, negative, then one entry of pads."""
    blank = _groups()[GROUP : 2 * GROUP].view(np.uint8).reshape(-1, 4)
    entries = np.zeros((2 * GROUP + 1, 8), np.uint8)
    last = 7 if point else 8
    entries[: 2 * GROUP, last - 4 : last] = np.concatenate([blank, blank])
    entries[: 2 * GROUP, last:] = ord(".")
    width = np.tile((blank > 0).sum(1), 2)
    for k, byte in enumerate(reversed((*prefix, ord("-")))):
        rows = np.arange(GROUP, 2 * GROUP) if k == 0 else np.arange(2 * GROUP)
        sign = (rows >= GROUP) & (k > 0)
        entries[rows, last - 1 - width[rows] - k + (~sign & (k > 0))] = byte
    return entries.view("u8")[:, 0]
