# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words that say arcs, in four dialects; each is read as centre, right-handed normal and radius.

Creo   ``CIRCLE/ x, y, z, i, j, k, r`` and the GOTO of its end: right-handed about i, j, k.
NX     ``CIRCLE/x, y, z, i, j, k, r, t, f, d, e`` (tolerance, factor, cutter's diameter and corner) and the
       GOTO of its end: clockwise for who looks along -i, -j, -k from the vector's tip, so left-handed. With
       ``TIMES, n`` behind it goes on round n - 1 times on a helix: so ramps come to the whole or half degrees
       that were asked for.
CAMWorks  ``CIRCLE/x, y, z, i, j, k`` and the GOTO of its end: right-handed, the radius is the start's
          distance from the axis.
CATIA  ``INDIRV/ i, j, k`` the direction at the start, and ``TLON,GOFWD/ (CIRCLE/ x, y, z, r), ON, (LINE/ x,
       y, z, xe, ye, ze)`` with the end: a move of its own, no GOTO need follow. ``ON, 2, INTOF`` where the
       arc passes the line behind the centre before.

Handedness by files of these systems: four-quarter contours whose arcs join straight moves on either side.
"""

from __future__ import annotations

import re

import numpy as np

from . import vocabulary as words

MOST_TURNS = 10_000
"""Of one helix: more are a slip of the pen."""


def circle_numbers(rest: str) -> tuple[float, ...] | None:
    """x, y, z, i, j, k (right-handed), r (NaN: not said) and further turns of a CIRCLE statement; None for a
    form that is not known."""
    parts = rest.split(",")
    turns = 0
    if (
        parts[11:12] == ["TIMES"]
        and len(parts) == 13
        and parts[12].isdecimal()
        and 1 <= int(parts[12][:6]) <= MOST_TURNS
    ):
        turns, parts = int(parts[12][:6]) - 1, parts[:11]
    if len(parts) not in (6, 7, 11) or not all(words.NUMBER.fullmatch(part) for part in parts):
        return None
    x, y, z, i, j, k, *rest_of = (float(part) for part in parts[:7])
    r = rest_of[0] if rest_of else 1.0
    hand = -1.0 if len(parts) == 11 else 1.0
    good = (
        r > 0.0 and np.abs([x, y, z, i, j, k, r]).max() <= words.LARGEST and np.linalg.norm([i, j, k]) > 0.0
    )
    return (x, y, z, hand * i, hand * j, hand * k, r if rest_of else np.nan, float(turns)) if good else None


_N = rb"([-+.0-9E\x01]+)"
CATIA_ARC = re.compile(
    rb"(?m)^INDIRV/" + rb",".join([_N] * 3) + rb"$\nT\x01?LON,\x01?GOFWD/\x01?"
    + rb"\(CIRCLE/\x01?" + rb",".join([_N] * 4) + rb"\)\x01?,\x01?ON\x01?,\x01?(?:[12],\x01?INTOF,\x01?)?"
    + rb"\(\x01?LINE/\x01?" + rb",".join([_N] * 6) + rb"\)\x01?$"
)  # fmt: skip


def catia_arcs_apart(text: bytes) -> bytes:
    """Return the text of all statements with each INDIRV and TLON of CATIA as a TANGENT statement of seven
    numbers and the GOTO of the arc's end, in the same lines."""
    return CATIA_ARC.sub(_apart, text) if b"TLON" in text else text


def _apart(found: re.Match[bytes]) -> bytes:
    part = [number.replace(b"\x01", b"") for number in found.groups()]
    first, second = found[0].split(b"\n")
    tangent = b"TANGENT/" + b",".join([*part[3:6], *part[:3], part[6]]) + b"\x01" * first.count(b"\x01")
    return tangent + b"\nGOTO/" + b",".join(part[10:]) + b"\x01" * second.count(b"\x01")
