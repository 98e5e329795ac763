# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spoilt copies of files: what a hand, a wrong post or a broken transfer does to them. All by a seeded random
generator."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

Change = Callable[[bytes, random.Random], bytes]

NUMBERS = (
    b"0", b"-0", b"1", b"-1", b"0.1", b"1e300", b"-1E300", b"1e-320", b"9" * 30, b"99999999", b"nan", b"inf", b"-", b".", b"1.2.3", b"2147483648",
    b"360", b"-180", b"0.0000001", b"1,5", b"0x10", b"1e", b"+ 1",
)  # fmt: skip
TOKEN = re.compile(rb"[-+]?\d*\.?\d+(?:[eE][-+]?\d+)?")
JUNK = (
    b"\0",
    b"\xff\xfe",
    b"\r",
    b"\r\n",
    b"\n\n",
    b"\t",
    b" ",
    b"(",
    b")",
    b"[",
    b"]",
    b"#",
    b"%",
    b";",
    b"$",
    b'"',
    b"/",
    b"=",
    b"\xe4",
    "Ä".encode(),
    b"\x1a",
)


def _number(data: bytes, dice: random.Random) -> bytes:
    found = list(TOKEN.finditer(data))
    if not found:
        return data
    one = dice.choice(found)
    return data[: one.start()] + dice.choice(NUMBERS) + data[one.end() :]


def _junk(data: bytes, dice: random.Random) -> bytes:
    at = dice.randint(0, len(data))
    return data[:at] + dice.choice(JUNK) * dice.choice((1, 1, 1, 40)) + data[at:]


def _byte(data: bytes, dice: random.Random) -> bytes:
    at = dice.randrange(max(len(data), 1))
    return data[:at] + bytes([dice.randrange(256)]) + data[at + 1 :]


def _cut(data: bytes, dice: random.Random) -> bytes:
    start = dice.randrange(max(len(data), 1))
    return data[:start] + data[start + dice.choice((1, 2, 5, 20, 10**9)) :]


def _lines(data: bytes, dice: random.Random) -> bytes:
    """A line twice, elsewhere, missing, or joined to the next one."""
    lines = data.split(b"\n")
    a, b = (dice.randrange(len(lines)) for _ in range(2))
    how = dice.randrange(4)
    if how == 0:
        lines.insert(b, lines[a])
    elif how == 1:
        lines[a], lines[b] = lines[b], lines[a]
    elif how == 2:
        del lines[a]
    else:
        lines[a : a + 2] = [b" ".join(lines[a : a + 2])]
    return b"\n".join(lines)


def _letter(data: bytes, dice: random.Random) -> bytes:
    """Another letter, in the other case, or none."""
    places = [at for at, one in enumerate(data) if chr(one).isalpha()]
    if not places:
        return data
    at = dice.choice(places)
    new = dice.choice((b"", data[at : at + 1].swapcase(), bytes([dice.randrange(65, 91)])))
    return data[:at] + new + data[at + 1 :]


CHANGES: tuple[Change, ...] = (_number, _number, _number, _junk, _byte, _cut, _lines, _lines, _letter)


def spoilt(data: bytes, dice: random.Random) -> bytes:
    """The data with one to four changes."""
    for _ in range(dice.choice((1, 1, 2, 4))):
        data = dice.choice(CHANGES)(data, dice)
    return data
