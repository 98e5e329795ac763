# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain's drilling cycles as blocks of klartext: one hole each time that a cycle is called, the tool
above it.

200, 203   down by Q202 at F Q206, between up to Q200 over the surface Q203 (FMAX) and down again to Q200 over
           the depth reached. 203: infeeds less by Q212 down to Q205, Q213 breaks of the chip by Q256 before
           each such retract; up at Q208.
201, 202   reaming, boring: down at F Q206, up at Q208. 202: off the wall by 0.2 mm at the bottom where Q214
           names a direction, over the middle again at last.
205        as 203, each retract to Q200 over the surface, down again to Q258 (first) to Q259 (last) over the
           depth reached; breaks of the chip by Q256 after each Q257 of an infeed.
206, 207   tapping: down to Q201 and up again at F Q206; at the pitch Q239 times the spindle's speed.
209        as 207, after each Q257 back by Q256 pitches, or out of the hole where Q256 is 0.
208        bore milling: helices of the pitch Q334, a circle at the bottom, back to the middle. Their radius
           is (Q335 - tool) / 2; the tool's diameter stands in a comment above its TOOL CALL (DM=16, as
           hyperMILL writes it), or is not known.
240        centring: down at F Q206, up by FMAX; by the depth alone (Q343 of 0).
241        single-lip drilling: at F Q253 to a fifth of Q379, Q200 at most, over the start Q379 under the
           surface, on at F Q206, up at Q208.
1          CYCL DEF 1.0 to 1.5, from where the tool stands: down by 1.3, up by FMAX, down to a stop before the
           depth reached.
2, 17      CYCL DEF 2.0 to 2.4, 17.0 to 17.3, from where the tool stands: down and up at F 2.4, at the pitch
           17.3 times the spindle's speed.

At last up to Q200, or Q204, over the surface. Sources: Heidenhain TNC 620 and TNC 640, cycle programming.
Written without the manual at hand, to be checked on the control: breaks by FMAX, the way onto the circle of
208 (straight here), FMAX for Q208 of 0 in 203 and 241, Q206 for it in 201, 202 and 205, 241's Q379, the F of
the way off the wall in 202 (Q206 here), 209's and 205's ways back (straight up, by FMAX in 205).
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
    "201": ("200", "201", "203", "206"), "202": ("200", "201", "203", "206", "214"),
    "205": ("200", "201", "202", "203", "206", "258"), "206": ("200", "201", "203", "206"),
    "207": ("200", "201", "203", "239"), "209": ("200", "201", "203", "239", "257", "256"),
    "240": ("200", "201", "203", "206"),
    "208": ("200", "201", "203", "206", "334", "335"), "241": ("200", "201", "203", "206"),
    "1": ("1", "2", "3", "5"), "2": ("1", "2", "4"), "17": ("1", "2", "3"),
}  # fmt: skip
OLD = ("1", "2", "17")
"""Cycles of several lines, each with one word."""
OFF_WALL = 0.2
"""mm; by so much cycle 202 goes off the wall."""
DIRECTIONS = {0: "", 1: "X-", 2: "Y-", 3: "X+", 4: "Y+"}
"""Q214 of cycle 202."""
TENTHS = 10.0
"""F of a program in inches counts tenths of an inch."""
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
    known; ``place``: X and Y of the hole; ``mm``: one in the program's unit."""

    feed: str
    speed: float | None
    diameter: float | None
    place: Callable[[], tuple[float, float]]
    mm: float = 1.0


def write_hole(cycle: Cycle, around: Around) -> list[str]:
    """Write the blocks of one hole, after which F is what it was. Raises Unread for what is not simple."""
    words, own = cycle.words, cycle.number
    if missing := [name for name in NEEDED[own] if name not in words]:
        name = f"{own}.{missing[0]}" if own in OLD else f"Q{missing[0]}"
        raise Unread(say("cycle {number} without {name}", number=own, name=name))
    if words.get("395", 0.0) != 0.0:
        raise Unread(say("cycle {number} with {name} above 0", number=own, name="Q395"))
    if words["2" if own in OLD else "201"] == 0.0:
        return []
    rows = CYCLES[own](words, around)
    if words.get("204", 0.0) > words.get("200", math.inf):
        rows.append(f"L Z{words['203'] + words['204']:+.6f} FMAX")
    if own == "202" and (way := _direction(words)):
        rows.append(f"L I{_opposite(way)}{OFF_WALL * around.mm:.6f} FMAX")
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


def _ream(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 201."""
    up, _, bottom = _levels(words)
    return [_fast(up), f"L Z{bottom:+.6f} F{words['206']:.6f}", _back(up, words)]


def _bore_out(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 202, but for its last way over the middle."""
    rows, way = _ream(words, around), _direction(words)
    if way:
        rows.insert(2, f"L I{way}{OFF_WALL * around.mm:.6f} F{words['206']:.6f}")
    return rows


def _direction(words: dict[str, float]) -> str:
    """Return the way off the wall, as axis and sign; nothing where there is none."""
    if words["214"] not in DIRECTIONS:
        raise Unread(say("{rest} is not known here", rest=f"Q214={words['214']:g}"))
    return DIRECTIONS[int(words["214"])]


def _opposite(way: str) -> str:
    return way[0] + ("+" if way[1] == "-" else "-")


def _centre_drill(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 240."""
    if words.get("343", 0.0) != 0.0:
        raise Unread(say("cycle {number} with {name} above 0", number="240", name="Q343"))
    up, _, bottom = _levels(words)
    return [_fast(up), f"L Z{bottom:+.6f} F{words['206']:.6f}", _fast(up)]


def _universal(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 205."""
    if words.get("379", 0.0) != 0.0:
        raise Unread(say("cycle {number} with {name} above 0", number="205", name="Q379"))
    up, surface, _ = _levels(words)
    breaks, by = words.get("257", 0.0), words.get("256", math.nan)
    if breaks and not by >= 0.0:
        raise Unread(say("cycle {number} without {name}", number="205", name="Q256"))
    depths = _depths(words["201"], words["202"], words.get("212", 0.0), words.get("205", 0.0))
    first, again = words["258"], len(depths) - 1
    last, rows, at = words.get("259", first), [_fast(up)], 0.0
    for step, depth in enumerate(depths):
        for one in _depths(depth - at, breaks or at - depth, 0.0, 0.0)[:-1]:
            rows += [f"L Z{surface + at + one:+.6f} F{words['206']:.6f}", _fast(surface + at + one + by)]
        rows.append(f"L Z{surface + depth:+.6f} F{words['206']:.6f}")
        if step < again:
            stop = first + (last - first) * step / max(again - 1, 1)
            rows += [_fast(up), _fast(min(up, surface + depth + stop))]
        at = depth
    return [*rows, _back(up, words)]


def _tap_at_feed(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 206."""
    up, _, bottom = _levels(words)
    return [_fast(up), f"L Z{bottom:+.6f} F{words['206']:.6f}", f"L Z{up:+.6f} F{words['206']:.6f}"]


def _tap(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 207."""
    up, _, bottom = _levels(words)
    feed = f"F{_thread_feed(words['239'], around):.6f}"
    return [_fast(up), f"L Z{bottom:+.6f} {feed}", f"L Z{up:+.6f} {feed}"]


def _tap_in_steps(words: dict[str, float], around: Around) -> list[str]:
    """Cycle 209."""
    up, surface, _ = _levels(words)
    feed, out = _thread_feed(words["239"], around), words.get("403", 1.0) or 1.0
    depths = _depths(words["201"], words["257"] or -words["201"], 0.0, 0.0)
    back, rows = abs(words["239"]) * words["256"], [_fast(up)]
    for depth in depths[:-1]:
        stop, faster = (surface + depth + back, 1.0) if back else (up, out)
        rows += [f"L Z{surface + depth:+.6f} F{feed:.6f}", f"L Z{min(stop, up):+.6f} F{feed * faster:.6f}"]
    return [*rows, f"L Z{surface + depths[-1]:+.6f} F{feed:.6f}", f"L Z{up:+.6f} F{feed * out:.6f}"]


def _thread_feed(pitch: float, around: Around) -> float:
    if not around.speed:
        raise Unread(say("the spindle's speed is not told before it"))
    return abs(pitch) * around.speed * (1.0 if around.mm == 1.0 else TENTHS)


def _old_tap(words: dict[str, float], around: Around) -> list[str]:
    """Cycles 2 and 17: by steps, as cycle 1."""
    if words["2"] > 0.0:
        raise Unread(say("its depth is not below 0, or its infeed is not above it"))
    way = words["2"] - abs(words["1"])
    feed = words["4"] if "4" in words else _thread_feed(words["3"], around)
    return [f"L IZ{way:+.6f} F{feed:.6f}", f"L IZ{-way:+.6f} F{feed:.6f}"]


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
        0.6 * around.mm if depth >= -30.0 * around.mm else min(-depth / 50.0, 7.0 * around.mm),
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


def _back(z: float, words: dict[str, float]) -> str:
    """Return the way up at Q208, at Q206 where that is 0."""
    return _out(z, words.get("208", 0.0) or words["206"])


CYCLES: dict[str, Callable[[dict[str, float], Around], list[str]]] = {
    "200": _peck, "201": _ream, "202": _bore_out, "203": _peck, "205": _universal, "206": _tap_at_feed,
    "207": _tap, "208": _bore, "209": _tap_in_steps, "240": _centre_drill, "241": _single_lip,
    "1": _old_pecking, "2": _old_tap, "17": _old_tap,
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
