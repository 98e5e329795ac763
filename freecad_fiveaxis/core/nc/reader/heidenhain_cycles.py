# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain's drilling cycles as blocks of klartext: one hole each time that a cycle is called, the tool
above it.

200, 203   down by Q202 at F Q206, between up to Q200 over the surface Q203 (FMAX) and down again to Q200 over
           the depth reached. 203: infeeds less by Q212 down to Q205, Q213 breaks of the chip by Q256 before
           each such retract; up at Q208.
207        tapping: down to Q201 and up again at the pitch Q239 times the spindle's speed.
208        bore milling: helices of the pitch Q334, a circle at the bottom, back to the middle. Their radius
           is (Q335 - tool) / 2; the tool's diameter stands in a comment above its TOOL CALL (DM=16, as
           hyperMILL writes it), or is not known.
241        single-lip drilling: at F Q253 to a fifth of Q379, Q200 at most, over the start Q379 under the
           surface, on at F Q206, up at Q208.
1          CYCL DEF 1.0 to 1.5, from where the tool stands: down by 1.3, up by FMAX, down to a stop before the
           depth reached.

At last up to Q200, or Q204, over the surface. Sources: Heidenhain TNC 620 and TNC 640, cycle programming.
Written without the manual at hand, to be checked on the control: breaks by FMAX, the way onto the circle of
208 (straight here), FMAX for Q208 of 0, 241's Q379.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field

from freecad_fiveaxis.core.base.sentences import say

from .expressions import NUMBER, Unread
from .preface import with_line_feeds

NEEDED = {
    "200": ("200", "201", "202", "203", "206"), "203": ("200", "201", "202", "203", "206"),
    "207": ("200", "201", "203", "239"),
    "208": ("200", "201", "203", "206", "334", "335"), "241": ("200", "201", "203", "206"),
    "1": ("1", "2", "3", "5"),
}  # fmt: skip
FREE = (0.0, 99999.0)
"""Feeds that mean FMAX."""
MOST_PECKS = 10_000
PLACE = re.compile(rf"(?<![A-Z])(I?)([XY]) *([-+]?(?:{NUMBER.pattern}))")
BLOCK = re.compile(r" *(?:/ *)?(?:LN?|C|CR)(?=[ IXYZABC])(?!.*M9[12])")
MOVES_COORDINATES = re.compile(r" *(?:/ *)?(?:CYCL +DEF +(?:7|8|10|11|19|26|247)(?![0-9])|PLANE|TRANS)")
FARTHEST_BACK = 10_000
DIAMETER = re.compile(rb"\bDM *= *([0-9]+\.?[0-9]*)")
COMMENT = re.compile(rb" *[0-9]* *(?:[;*].*)?$")
TOOL_CALL = re.compile(rb" *[0-9]* *TOOL +CALL\b")


@dataclass(eq=False)
class Cycle:
    """A cycle that was defined: its number, and its words by their numbers (Q200 as 200; 1.2 of cycle 1 as
    2)."""

    number: str
    words: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Around:
    """What a call finds: ``feed`` as text, ``speed`` 1/min and the tool's ``diameter`` mm where they are
    known; ``place``: X and Y mm of the hole."""

    feed: str
    speed: float | None
    diameter: float | None
    place: Callable[[], tuple[float, float]]


def write_hole(cycle: Cycle, around: Around) -> list[str]:
    """Write the blocks of one hole, after which F is what it was. Raises Unread for what is not simple."""
    words, own = cycle.words, cycle.number
    if missing := [name for name in NEEDED[own] if name not in words]:
        name = f"1.{missing[0]}" if own == "1" else f"Q{missing[0]}"
        raise Unread(say("cycle {number} without {name}", number=own, name=name))
    if words.get("395", 0.0) != 0.0:
        raise Unread(say("cycle {number} with {name} above 0", number=own, name="Q395"))
    if words["2" if own == "1" else "201"] == 0.0:
        return []
    rows = CYCLES[own](words, around)
    if words.get("204", 0.0) > words.get("200", math.inf):
        rows.append(f"L Z{words['203'] + words['204']:+.6f} FMAX")
    return [*rows, f"L F{around.feed}"] if around.feed else rows


def _levels(words: dict[str, float]) -> tuple[float, float, float]:
    """Return set-up clearance, surface and bottom, as Z."""
    surface, clear, depth = words["203"], words["200"], words["201"]
    if depth > 0.0 or clear < 0.0:
        raise Unread(say("its depth is not below 0, or its infeed is not above it"))
    return surface + clear, surface, surface + depth


def _depths(depth: float, infeed: float, less: float, least: float) -> list[float]:
    """Return the depths (below 0) that the infeeds reach, the last of them ``depth``."""
    if not infeed > 0.0 or (less > 0.0 and not least > 0.0):
        raise Unread(say("its depth is not below 0, or its infeed is not above it"))
    found, at = list[float](), 0.0
    while at > depth + 1e-9 * infeed:
        at = max(depth, at - infeed)
        found.append(at)
        infeed = max(infeed - less, least) if less else infeed
        if len(found) > MOST_PECKS:
            raise Unread(say("its Q makes too many pecks"))
    return found


def _peck(words: dict[str, float], around: Around) -> list[str]:
    """Cycles 200 and 203."""
    up, surface, _ = _levels(words)
    breaks, back = int(words.get("213", 0.0)), words.get("256", math.nan)
    if breaks and not back >= 0.0:
        raise Unread(say("cycle {number} without {name}", number="203", name="Q256"))
    depths = _depths(words["201"], words["202"], words.get("212", 0.0), words.get("205", 0.0))
    rows = [_fast(up)]
    for step, depth in enumerate(depths, 1):
        rows.append(f"L Z{surface + depth:+.6f} F{words['206']:.6f}")
        if step == len(depths):
            break
        if step % (breaks + 1):
            rows.append(_fast(surface + depth + back))
        else:
            rows += [_fast(up), _fast(surface + depth + words["200"])]
    return [*rows, _out(up, words.get("208", 0.0))]


def _tap(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 207."""
    up, _, bottom = _levels(words)
    if not around.speed:
        raise Unread(say("the spindle's speed is not told before it"))
    feed = f"F{abs(words['239']) * around.speed:.6f}"
    return [_fast(up), f"L Z{bottom:+.6f} {feed}", f"L Z{up:+.6f} {feed}"]


def _single_lip(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 241."""
    up, surface, bottom = _levels(words)
    if 0.0 < words.get("202", 0.0) < -words["201"]:
        raise Unread(say("cycle {number} with {name} above 0", number="241", name="Q202"))
    rows, start = [_fast(up)], words.get("379", 0.0)
    if start:
        rows.append(_out(surface - abs(start) + min(0.2 * abs(start), words["200"]), words.get("253", 0.0)))
    return [*rows, f"L Z{bottom:+.6f} F{words['206']:.6f}", _out(up, words.get("208", 0.0))]


def _bore(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 208."""
    up, _, bottom = _levels(words)
    if around.diameter is None:
        raise Unread(
            say(
                "its radius is that of the tool, which only the control knows; name it above TOOL CALL as ; "
                "DM=16"
            )
        )
    radius, down = 0.5 * (words["335"] - around.diameter), f"F{words['206']:.6f}"
    if radius < -1e-6:
        raise Unread(say("the tool is wider than the hole"))
    if radius < 1e-6:
        return [_fast(up), f"L Z{bottom:+.6f} {down}", _fast(up)]
    x, y = around.place()
    circle = (
        f"C X{x + radius:+.6f} Y{y:+.6f} Z{{:+.6f}} DR{'-' if words.get('351', 1.0) < 0.0 else '+'} {down}"
    )
    turns = [circle.format(up + depth) for depth in _depths(bottom - up, words["334"], 0.0, 0.0)]
    middle = f"X{x:+.6f} Y{y:+.6f}"
    return [
        _fast(up),
        f"CC {middle}",
        f"L X{x + radius:+.6f} Y{y:+.6f} {down}",
        *turns,
        circle.format(bottom),
        f"L {middle} {down}",
        _fast(up),
    ]


def _old_pecking(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 1: all by steps from where the tool stands. Clearance and infeed have the sign of the depth, as
    old controls ask, or none, as later ones do (SET UP 2, DEPTH -20, PECKG 5); posts of both kinds were
    read."""
    clear, depth, infeed = abs(words["1"]), words["2"], abs(words["3"])
    if depth > 0.0:
        raise Unread(say("its depth is not below 0, or its infeed is not above it"))
    stop, down, at, rows = (
        0.6 if depth >= -30.0 else min(-depth / 50.0, 7.0),
        f"F{words['5']:.6f}",
        0.0,
        list[str](),
    )
    for one in _depths(depth, infeed, 0.0, 0.0):
        if at < 0.0:
            again = min(0.0, at + stop)
            rows.append(f"L IZ{again:+.6f} FMAX")
            at = again
        rows += [f"L IZ{one - clear - at:+.6f} {down}", f"L IZ{clear - one:+.6f} FMAX"]
        at = one - clear
    return rows


def _fast(z: float) -> str:
    return f"L Z{z:+.6f} FMAX"


def _out(z: float, feed: float) -> str:
    return _fast(z) if feed in FREE else f"L Z{z:+.6f} F{feed:.6f}"


CYCLES: dict[str, Callable[[dict[str, float], Around], list[str]]] = {
    "200": _peck, "203": _peck, "207": _tap, "208": _bore, "241": _single_lip, "1": _old_pecking,
}  # fmt: skip


def place_before(rows: list[tuple[int, str]]) -> tuple[float, float]:
    """Find X and Y mm that the rows told last. Raises Unread where they do not
    since the coordinates were changed."""
    found, steps = dict[str, float](), {"X": 0.0, "Y": 0.0}
    for _, row in reversed(rows[-FARTHEST_BACK:]):
        if MOVES_COORDINATES.match(row):
            break
        for step, letter, value in PLACE.findall(row) if BLOCK.match(row) else ():
            if letter not in found and step:
                steps[letter] += float(value)
            elif letter not in found:
                found[letter] = float(value) + steps[letter]
        if len(found) == 2:
            return found["X"], found["Y"]
    raise Unread(say("X and Y are not told before it"))


def diameters(text: bytes) -> dict[int, float]:
    """Find the tools' diameters mm, by the index of the line of their TOOL CALL, in comments right above it
    (DM=16)."""
    found, commented = dict[int, float](), None
    if b"DM" not in text:
        return found
    for at, line in enumerate(with_line_feeds(text.upper()).split(b"\n")):
        if TOOL_CALL.match(line):
            if commented is not None:
                found[at] = commented
            commented = None
        elif not COMMENT.match(line):
            commented = None
        elif diameter := DIAMETER.search(line):
            commented = float(diameter[1])
    return found
