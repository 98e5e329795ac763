# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's polar lines as Cartesian ones (Heidenhain TNC 640, Klartext Programming, Path contours: Polar
coordinates).

CC X+5 Y+5     the pole. CC IX+2 IY+0: from where the tool stands; CC alone: where it stands.
LP PR+10 PA+30 a line to that radius and angle (degrees, from +X, counter-clockwise); IPR, IPA: from where the
tool stands. CP PA+90 DR+   an arc about the pole.     CP IPA+1080 IZ-9 DR+   a helix of three turns.

For this the tool's place is followed from line to line. Where it, or the pole, is not known the line stays as
it is, and is a finding of the reader's. The pole lies in XY, the plane of tool axis Z.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from .codes import TURNS

POLAR = re.compile(rb"\b[CL]P +I?P[AR]|\bCC *(?:I[XYZ]|$)", re.MULTILINE)
"""What shows that a text has such lines."""
LINE = re.compile(r"( *(?:/ *)?(?:[0-9]+ +)?)([A-Z]+)(?=[ IXYZABCFRMDPT]|$)(.*)")
VALUE = r" *([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?![0-9.]*[A-Z0-9]*Q)"
WORD = re.compile(rf"(?<![A-Z])(I?)(P[AR]|[XYZ]){VALUE}")
ANY_WORD = re.compile(r"(?<![A-Z])I?(?:P[AR]|[XY])(?=[-+ .0-9Q])")
SENSE = re.compile(r"(?<![A-Z])DR *([-+])(?![0-9.Q])")
ELSEWHERE = re.compile(r"(?<![A-Z0-9])M9[12](?![0-9])")
MOVES = ("L", "LN", "C", "CR", "CT")
KEEP = (
    "BEGIN",
    "BLK",
    "TOOL",
    "LBL",
    "STOP",
    "M",
    "F",
    "R",
    "END",
    "FN",
    "X",
    "Y",
    "Z",
    "A",
    "B",
    "RND",
    "CHF",
)
"""How lines begin that neither lead the tool sideways nor move the coordinates, or whose words say where they
lead."""
STAYS = re.compile(r" *(?:CALL *(?:M|F|$)|DEF *(?:9\.[0-9]|13|32|20[0-9]|24[01])(?![0-9]))")
"""Cycles that leave the coordinates, and the tool above its hole."""
SMALL = 1e-9


@dataclass
class Place:
    """Where the tool stands, and the pole, in the units of the words; None: not known."""

    x: float | None = None
    y: float | None = None
    pole: tuple[float, float] | None = None

    def forget(self) -> None:
        """Nothing is known any more."""
        self.x = self.y = self.pole = None

    def find_polar(self) -> tuple[float, float] | None:
        """Radius and angle (deg) of the tool's place about the pole."""
        if self.x is None or self.y is None or self.pole is None:
            return None
        across, along = self.x - self.pole[0], self.y - self.pole[1]
        return math.hypot(across, along), math.degrees(math.atan2(along, across))


def without_polar(text: bytes) -> bytes:
    """Return the text, in capitals and without comments, with its polar lines written as L and C where that
    can be; line by line."""
    if not POLAR.search(text):
        return text
    place = Place()
    return "\n".join(_line(row, place) for row in text.decode("latin-1").split("\n")).encode("latin-1")


def _line(row: str, place: Place) -> str:
    found = LINE.match(row)
    if found is None:
        return row
    begin, name, rest = found.groups()
    if name == "CC":
        return _pole(row, begin, rest, place)
    if name in ("LP", "CP"):
        cartesian = (_straight if name == "LP" else _round)(_words(rest), rest, place)
        if cartesian is None:
            place.x = place.y = None
        return row if cartesian is None else begin + cartesian
    if name in MOVES or name in KEEP:
        _follow(rest if name in MOVES else name + rest, place)
    elif name != "CYCL" or not STAYS.match(rest):
        place.forget()
    return row


def _words(rest: str) -> dict[str, float] | None:
    """Return the words by name, incremental ones as IX; None where one has no number or stands twice."""
    words = {one[1] + one[2]: float(one[3]) for one in WORD.finditer(rest)}
    named = len(re.findall(r"(?<![A-Z])I?(?:P[AR]|[XYZ])(?=[-+ .0-9Q])", rest))
    return words if named == len(words) else None


def _follow(rest: str, place: Place) -> None:
    words = _words(rest)
    if words is None or ELSEWHERE.search(rest):
        place.x = place.y = None
        return
    for name in ("x", "y"):
        now = getattr(place, name)
        if (to := words.get(name.upper())) is not None:
            setattr(place, name, to)
        elif (by := words.get("I" + name.upper())) is not None:
            setattr(place, name, None if now is None else now + by)


def _pole(row: str, begin: str, rest: str, place: Place) -> str:
    """Return the pole with absolute words; left as it is where it is so already, or cannot be told."""
    words = _words(rest)
    place_now, place.pole = (place.x, place.y), None
    if words is None or any(name.endswith("Z") for name in words):
        return row
    at = [_absolute(words, name, now) for name, now in zip("XY", place_now, strict=True)]
    if at[0] is None or at[1] is None:
        return row
    place.pole = at[0], at[1]
    return row if {"X", "Y"} == words.keys() else f"{begin}CC X{at[0]:+.9f} Y{at[1]:+.9f}"


def _absolute(words: dict[str, float], name: str, now: float | None) -> float | None:
    if name in words:
        return words[name]
    by = words.get("I" + name, 0.0 if not words else None)
    return None if by is None or now is None else now + by


def _straight(words: dict[str, float] | None, rest: str, place: Place) -> str | None:
    """L to where an LP leads."""
    if words is None or place.pole is None:
        return None
    seen = place.find_polar()
    radius, angle = (
        _find_target(words, name, seen[k] if seen else None) for k, name in enumerate(("PR", "PA"))
    )
    if radius is None or angle is None:
        return None
    return "L " + _to(place, radius, angle) + _others(rest)


def _find_target(words: dict[str, float], name: str, now: float | None) -> float | None:
    if name in words:
        return words[name]
    return None if now is None else now + words.get("I" + name, 0.0)


def _round(words: dict[str, float] | None, rest: str, place: Place) -> str | None:
    """C, with its further turns, for a CP."""
    sense, seen = SENSE.search(rest), place.find_polar()
    if (
        words is None
        or sense is None
        or seen is None
        or not ("PA" in words) ^ ("IPA" in words)
        or "PR" in words
        or "IPR" in words
    ):
        return None
    if seen[0] <= SMALL:
        return None
    by, turns = words.get("IPA"), 0
    if by is not None:
        ahead = by if sense[1] == "+" else -by
        if abs(by) <= SMALL or ahead <= -360.0:
            return None
        turns = max(math.ceil(ahead / 360.0 - SMALL) - 1, 0)
    whole = by is not None and abs(math.remainder(by, 360.0)) <= SMALL
    angle = words["PA"] if by is None else seen[1] + by
    to = f"X{place.x:+.9f} Y{place.y:+.9f}" if whole else _to(place, seen[0], angle)
    return f"C {to}{_others(rest)}" + (f" {TURNS}{turns}" if turns else "")


def _to(place: Place, radius: float, angle: float) -> str:
    """Return the words of the place at that radius and angle (deg) about the pole; the tool stands there
    then."""
    across, along = place.pole or (0.0, 0.0)
    place.x = across + radius * math.cos(math.radians(angle))
    place.y = along + radius * math.sin(math.radians(angle))
    return f"X{place.x:+.9f} Y{place.y:+.9f}"


def _others(rest: str) -> str:
    """Return the words beside the polar ones, with a blank before them."""
    left = WORD.sub(lambda found: "" if found[2] in ("PA", "PR") else found[0], rest).strip()
    return " " + left if left else ""
