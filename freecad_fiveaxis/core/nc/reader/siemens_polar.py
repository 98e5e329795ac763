# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' polar words and arcs by an opening angle or a point between as plain words.

G111 X Y    the pole: of the coordinates, G110 from where the tool stands, G112 from the pole before; each by
            AP RP too. None: the zero.
AP= RP=     angle (deg, from the plane's first axis) and radius about the pole; IC() on from the last. One
            that is not told stays. Under G2 and G3 the arc goes about the pole.
AR=         the opening angle of an arc, deg, with its end, or with its centre (I, J, K).
CIP         an arc through I1= J1= K1= to its end, all in the working plane.

For this the tool's place is followed from line to line. What is not known that way, or is told another way,
stays as it is, and is a finding of the reader's: an arc through a point off the plane too.

Source: SINUMERIK 840D sl, Programming Manual Fundamentals (polar coordinates; circular interpolation with
opening angle and polar coordinates, with end and intermediate points).
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

from .siemens import HARMLESS, without_strings

SIGN = re.compile(rb"(?<![A-Z0-9_$])(?:A[PR]|RP) *=|(?<![A-Z0-9_$])CIP(?![A-Z0-9_])")
"""What shows that a text has such lines."""
NUMBER = r"[-+]? *(?:[0-9]+\.?[0-9]*|\.[0-9]+)"
WORD = re.compile(
    rf"(?<![A-Z_$])(?:(AP|RP|AR|CR|[IJK]1|[XYZIJK]) *= *"
    rf"(?:(AC|IC) *\( *({NUMBER}) *\)|({NUMBER})(?![ 0-9.]*[-+*/(\[]))"
    rf"|([XYZIJK]) *({NUMBER})(?! *[=0-9.]))"
)
NAMED = re.compile(r"(?<![A-Z_$])(?:(?:AP|RP|AR|CR|[IJK]1) *=|[XYZIJK](?=[-+. 0-9=]))")
G_CODE = re.compile(r"(?<![A-Z0-9_$])G *0*([0-9]+)(?![0-9.=])")
OTHER = re.compile(r"(?<![A-Z0-9_$])[A-Z_$]{2}[A-Z0-9_]*")
ARC_WORD = re.compile(r"(?<![A-Z0-9_$])C(?:IP|T)(?![A-Z0-9_])")
FIRST = re.compile(r"^( *(?:/[0-9]? *)?(?:N *[0-9]+ *)?)")
AXES = {17: ("X", "Y", "I", "J"), 18: ("Z", "X", "K", "I"), 19: ("Y", "Z", "J", "K")}
"""By plane: the two axes, and the words of a centre along them."""
ACROSS = {17: "Z", 18: "Y", 19: "X"}
POLES, UNITS, ELSEWHERE = (110, 111, 112), (70, 71, 700, 710), (53, 74, 75, 153)
OFFSETS = (54, 55, 56, 57, 58, 59, *range(500, 600))
SMALL = 1e-9
PARTS_OF_MOVE = b"CIP CT SUPA RND RNDM CHR CHF ANG TURN AR AP RP CR AC IC DC ACP ACN"
KEEPS = frozenset(word.decode() for word in (*HARMLESS, *PARTS_OF_MOVE.split()))
"""Words that leave the coordinates as they are."""
DRILLS = {"MCALL", "CYCLE840"} | {f"CYCLE{number}" for number in range(81, 90)}
"""Cycles that leave the coordinates, but not the tool where it was."""
Words = dict[str, tuple[str, float]]
"""The words of a line: how each is meant (AC, IC, or as G90 or G91 say) and its value."""


@dataclass
class Place:
    """Where the tool stands, by axis, in the units of the words; a missing one is not known. ``pole`` in the
    working plane, None: not known; ``programmed``: by the program; ``polar``: the last RP and AP about it."""

    at: dict[str, float] = field(default_factory=dict)
    pole: tuple[float, float] | None = (0.0, 0.0)
    programmed: bool = False
    polar: dict[str, float] = field(default_factory=dict)
    plane: int = 17
    motion: str = "G1"
    steps: bool = False

    def forget(self) -> None:
        """Nothing is known of these coordinates but their zero."""
        self.at, self.polar = {}, {}
        if self.programmed:
            self.pole = None

    def here(self) -> tuple[float, float] | None:
        """Return where the tool stands in its plane."""
        one, two = AXES[self.plane][:2]
        return (self.at[one], self.at[two]) if one in self.at and two in self.at else None


def without_polar(text: bytes) -> bytes:
    """Return the text, in capitals and without comments, with its polar lines and such arcs as plain words
    where that can be; line by line."""
    if not SIGN.search(text):
        return text
    place = Place()
    rows = without_strings(text).decode("latin-1").split("\n")
    return "\n".join(_line(row, place) for row in rows).encode("latin-1")


def _line(row: str, place: Place) -> str:
    numbers = [int(one) for one in G_CODE.findall(row)]
    words, whole = _read_words(row)
    _change_modes(row, numbers, place)
    if set(numbers) & set(POLES):
        return _set_pole(row, numbers, words if whole else None, place)
    if words.keys() & {*AXES[place.plane][:2]}:
        place.polar = {}
    machine = "SUPA" in row or bool(set(numbers) & set(ELSEWHERE))
    if whole and not machine and (new := _rewrite(words, place)) is not None:
        row = _with_words(row, words, new, place)
    elif {"AP", "RP", "AR"} & words.keys():
        place.at, place.polar = {}, {}
    if machine or not whole:
        for axis in "XYZ" if not whole else words.keys() & set("XYZ"):
            place.at.pop(axis, None)
        place.polar = {}
    else:
        _follow(_read_words(row)[0], place)
    return row


def _read_words(row: str) -> tuple[Words, bool]:
    """Return the words by name, and whether each that the line names could be read, once."""
    found = [
        (one[1] or one[5], one[2] or "", float((one[3] or one[4] or one[6]).replace(" ", "")))
        for one in WORD.finditer(row)
    ]
    words = {name: (how, value) for name, how, value in found}
    return words, len(words) == len(found) == len(NAMED.findall(row))


def _change_modes(row: str, numbers: list[int], place: Place) -> None:
    """Take the modes that the line sets, and forget what it makes unknown."""
    others = {one for one in OTHER.findall(row) if one not in KEEPS}
    if re.search(r"[a-z{}\x7f]", row) or not others <= DRILLS:
        place.forget()
    if others:
        place.at = {}
    if "TRAORI" in row or "TRAFOOF" in row or set(numbers) & set(OFFSETS):
        place.at = {}
    for number in numbers:
        if number in (0, 1, 2, 3):
            place.motion = f"G{number}"
        elif number in (90, 91):
            place.steps = number == 91
        elif number in AXES and number != place.plane:
            place.plane, place.pole, place.polar = number, None if place.programmed else place.pole, {}
        elif number in UNITS:
            place.forget()
    if found := ARC_WORD.search(row):
        place.motion = found[0]


def _absolute(place: Place, words: Words, name: str, start: float | None) -> float | None:
    """Return where a word leads, from ``start`` where it is incremental; ``start`` without one."""
    if name not in words:
        return start
    how, value = words[name]
    if how == "IC" or (place.steps and not how):
        return None if start is None else start + value
    return value


def _set_pole(row: str, numbers: list[int], words: Words | None, place: Place) -> str:
    """Set the pole, and return the line without it; as it is where the pole cannot be told."""
    kind = next(number for number in numbers if number in POLES)
    base = {110: place.here(), 111: (0.0, 0.0), 112: place.pole}[kind]
    off = _offset(words, place, kind == 111) if words is not None else None
    place.programmed, place.polar, place.pole = True, {}, None
    if base is None or off is None:
        return row
    place.pole = base[0] + off[0], base[1] + off[1]
    return G_CODE.sub(lambda one: "" if int(one[1]) in POLES else one[0], WORD.sub("", row))


def _offset(words: Words, place: Place, whole: bool) -> tuple[float, float] | None:
    """Return what a line of a pole says (2,); ``whole``: it must name both axes. A polar one of G111 would
    count from the pole before, which is not read."""
    one, two = AXES[place.plane][:2]
    if words.keys() == {"AP", "RP"} and not whole:
        return _at(words["RP"][1], words["AP"][1])
    named = words.keys() & {one, two}
    if not named or len(named) != len(words) or (whole and len(named) != 2):
        return None
    if any(how == "IC" for how, _ in words.values()):
        return None
    return words.get(one, ("", 0.0))[1], words.get(two, ("", 0.0))[1]


def _at(radius: float, degrees: float) -> tuple[float, float]:
    return radius * math.cos(math.radians(degrees)), radius * math.sin(math.radians(degrees))


def _rewrite(words: Words, place: Place) -> dict[str, str] | None:
    """Return the words that take the place of polar ones, of an opening angle, or of a point between; None
    where the line has none, or they are not known."""
    if {"AP", "RP"} & words.keys():
        return _polar(words, place)
    if "AR" in words:
        return _opening(words, place)
    return _between(words, place) if place.motion == "CIP" else None


def _polar(words: Words, place: Place) -> dict[str, str] | None:
    one, two, *centre = AXES[place.plane]
    if place.pole is None or place.steps or {one, two, "AR", "CR", "I", "J", "K"} & words.keys():
        return None
    radius, degrees = (_absolute(place, words, name, place.polar.get(name)) for name in ("RP", "AP"))
    if radius is None or degrees is None or radius < 0.0 or place.motion not in ("G0", "G1", "G2", "G3"):
        return None
    place.polar = {"RP": radius, "AP": degrees}
    off = _at(radius, degrees)
    new = {axis: f"={at + by:+.9f}" for axis, at, by in zip((one, two), place.pole, off, strict=True)}
    if place.motion in ("G2", "G3"):
        new |= {letter: f"=AC({at:+.9f})" for letter, at in zip(centre, place.pole, strict=True)}
    return new


def _opening(words: Words, place: Place) -> dict[str, str] | None:
    """Return the radius of an arc whose end is told, or the end of one whose centre is."""
    one, two, *centre = AXES[place.plane]
    start, degrees = place.here(), words["AR"][1]
    if start is None or place.motion not in ("G2", "G3") or not 0.0 < degrees < 360.0 or "CR" in words:
        return None
    end = [_absolute(place, words, axis, at) for axis, at in zip((one, two), start, strict=True)]
    middle = words.keys() & {"I", "J", "K"}
    if {one, two} & words.keys():
        chord = math.dist(start, [at for at in end if at is not None])
        if middle or chord <= SMALL:
            return None
        radius = chord / (2.0 * math.sin(math.radians(degrees) / 2.0))
        return {"CR": f"={radius if degrees <= 180.0 else -radius:+.9f}"}
    if not middle or not middle <= set(centre):
        return None
    off = [_offset_of_centre(words.get(name), at) for name, at in zip(centre, start, strict=True)]
    turn = math.radians(degrees if place.motion == "G3" else -degrees)
    cos, sin = math.cos(turn), math.sin(turn)
    to = (
        start[0] + off[0] - cos * off[0] + sin * off[1],
        start[1] + off[1] - sin * off[0] - cos * off[1],
    )
    new = {axis: f"=AC({at:+.9f})" for axis, at in zip((one, two), to, strict=True)}
    return new | {name: f"={by:+.9f}" for name, by in zip(centre, off, strict=True)}


def _offset_of_centre(word: tuple[str, float] | None, start: float) -> float:
    """Return a centre's word from the start of the arc, which all but AC() are."""
    if word is None:
        return 0.0
    return word[1] - start if word[0] == "AC" else word[1]


def _between(words: Words, place: Place) -> dict[str, str] | None:
    """Return the centre and the sense of an arc in the plane through a point between."""
    one, two, *centre = AXES[place.plane]
    across, start = ACROSS[place.plane], place.here()
    third = "IJK"["XYZ".index(across)]
    level = place.at.get(across)
    if start is None or not {f"{name}1" for name in centre} & words.keys() or words.keys() & {*"IJK", "CR"}:
        return None
    end = [_absolute(place, words, axis, at) for axis, at in zip((one, two), start, strict=True)]
    middle = [_absolute(place, words, f"{name}1", at) for name, at in zip(centre, start, strict=True)]
    if {across, f"{third}1"} & words.keys():
        heights = (_absolute(place, words, name, level) for name in (across, f"{third}1"))
        if level is None or any(height is None or abs(height - level) > SMALL for height in heights):
            return None
    return _through(start, [at or 0.0 for at in middle], [at or 0.0 for at in end], centre)


def _through(
    start: tuple[float, float], middle: list[float], end: list[float], centre: list[str]
) -> dict[str, str] | None:
    (ux, uy), (vx, vy) = ((at[0] - start[0], at[1] - start[1]) for at in (middle, end))
    cross = ux * vy - uy * vx
    if abs(cross) <= SMALL:
        return None
    u, v = ux * ux + uy * uy, vx * vx + vy * vy
    off = (vy * u - uy * v) / (2.0 * cross), (ux * v - vx * u) / (2.0 * cross)
    sense = "3" if cross > 0.0 else "2"
    return {"G": sense} | {name: f"={by:+.9f}" for name, by in zip(centre, off, strict=True)}


def _with_words(row: str, words: Words, new: dict[str, str], place: Place) -> str:
    """Return the line with the new words in the place of those that they stand for."""
    gone = {"AP", "RP", "AR", "I1", "J1", "K1", *new}

    def keep(found: re.Match[str]) -> str:
        return "" if (found[1] or found[5]) in gone else found[0]

    row = WORD.sub(keep, row)
    if "G" in new:
        row = ARC_WORD.sub("", row)
        row = FIRST.sub(rf"\g<1>G{new['G']} ", row, count=1)
    return row.rstrip() + "".join(f" {name}{value}" for name, value in new.items() if name != "G")


def _follow(words: Words, place: Place) -> None:
    """Let the tool stand where the words lead."""
    for axis in words.keys() & set("XYZ"):
        if (to := _absolute(place, words, axis, place.at.get(axis))) is None:
            place.at.pop(axis, None)
        else:
            place.at[axis] = to
