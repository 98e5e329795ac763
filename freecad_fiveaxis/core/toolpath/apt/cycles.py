# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drilling cycles of a CL file: what a CYCLE statement says, and the way of the tool along its axis that
it stands for.

Creo   ``CYCLE/ DRILL, DEPTH, d, MMPM, f, CLEAR, c``; ``CYCLE/ DEEP`` and ``BRKCHP`` with ``STEP, s``.
NX     ``CYCLE/DRILL, RAPTO, c, FEDTO, -d, RTRCTO, r | AUTO, MMPM, f``; ``CYCLE/DRILL,DEEP`` and
       ``DRILL,BRKCHP`` with ``STEP``.
CAMWorks  ``CYCLE/DRILL, FEDTO, d, MMPM, f, RAPTO, c, RTRCTO, r, DWELL, t``: FEDTO, said first, counts
          downwards; ``CYCLE/DEEP``
       with ``INCR, s``; ``CYCLE/DEEP2`` with ``1STPECK, s, SUBPECK, s2``. Before it ``CYCLE/INIT`` or
       ``/CLEAR``: where to leave.
point  each GOTO while the cycle is on is the top of a hole; lengths are counted from there along the tool
       axis.
clear  height of the rapid before the hole.       out   height after it: clear where nothing is said; AUTO:
       where the tool stood before the cycle.
peck   DEEP takes the chips out to ``clear`` after each step, BRKCHP only lifts by ``GAP``.

Forms whose numbers have other meanings (CATIA's, by their order), and words beyond these (TAP, BACK, MANUAL,
ORIENT ...) are not interpreted: a hole drilled wrongly spoils the part.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from . import vocabulary as words

GAP = 0.5
"""mm above the last bottom: so far DEEP goes back at rapid, and so far BRKCHP lifts; as controllers do (G83,
G73)."""
MOST_PECKS = 10_000
"""Of one hole: more are a slip of the pen."""
CHIPS = ("DEEP", "DEEP2", "BRKCHP")
KINDS = ("DRILL", *CHIPS, "BORE", "REAM", "FACE", "CSINK")
OF_DRILL = (*CHIPS, "CSINK")
"""Kinds that NX says behind DRILL."""
FED_OUT = ("BORE", "REAM")
"""Kinds that leave the hole at feed (G85)."""
WORDS = {
    "RAPTO": "clear",
    "CLEAR": "clear",
    "FEDTO": "bottom",
    "DEPTH": "depth",
    "RTRCTO": "out",
    "RETURN": "out",
    "DWELL": "dwell",
    "STEP": "step",
    "INCR": "step",
    "1STPECK": "step",
    "SUBPECK": "later",
}
FEEDS = {**{word: (unit, False) for word, unit in words.FEED_UNITS.items()}}
FEEDS |= {word: (math.nan if unit is None else unit, True) for word, unit in words.PER_TURN.items()}


@dataclass(frozen=True)
class Cycle:
    """``clear``, ``depth`` and ``out`` in the file's unit (``out`` None: clear; NaN: where the tool stood
    before); ``steps`` of the pecks, the last one for all that follow; ``chips`` DEEP, BRKCHP or empty;
    ``fed_out``; ``feed`` NaN: that of FEDRAT, in mm of its ``unit`` (NaN: the file's), or per ``turn``;
    ``dwell`` s or turns."""

    clear: float
    depth: float
    out: float | None = None
    steps: tuple[float, ...] = ()
    chips: str = ""
    fed_out: bool = False
    feed: float = math.nan
    unit: float = math.nan
    turn: bool = False
    dwell: float = 0.0


def cycle_of(rest: str) -> Cycle | None:
    """Return what stands behind ``CYCLE/``, blanks removed, in capitals; None where it is not interpreted."""
    parts = rest.split(",")
    kinds = [part for part in parts[:2] if part in KINDS]
    if (
        not kinds
        or parts[: len(kinds)] != kinds
        or (len(kinds) == 2 and (kinds[0] != "DRILL" or kinds[1] not in OF_DRILL))
    ):
        return None
    stated = _read_numbers(parts[len(kinds) :])
    if stated is None or len(stated.get("clear", ())) != 1:
        return None
    depth = _depth(stated)
    clear, steps, out = (
        stated["clear"][0],
        stated.get("step", ()) + stated.get("later", ()),
        stated.get("out", ()),
    )
    if depth is None or not (clear >= 0.0 and clear + depth > 0.0) or any(step <= 0.0 for step in steps):
        return None
    if steps and depth / steps[-1] > MOST_PECKS:
        return None
    feed, unit, turn = stated.get("feed", (math.nan, math.nan, 0.0))
    chips = kinds[-1].rstrip("2") if kinds[-1] in CHIPS else ""
    if steps and not chips:
        return None
    return Cycle(
        clear,
        depth,
        out[0] if out else None,
        steps,
        chips,
        kinds[-1] in FED_OUT,
        feed,
        unit,
        bool(turn),
        *stated.get("dwell", ()),
    )


def _read_numbers(parts: list[str]) -> dict[str, tuple[float, ...]] | None:
    """Return the numbers behind each word; None where a word is not known, has none, or stands twice."""
    stated: dict[str, tuple[float, ...]] = {}
    k = 0
    while k < len(parts):
        word, numbers = parts[k], _numbers(parts[k + 1 :])
        name = _name(word, k, numbers)
        k += 1 + len(numbers)
        if word == "RTRCTO" and parts[k : k + 1] == ["AUTO"] and not numbers:
            numbers, k = [math.nan], k + 1
        elif word == "DWELL" and parts[k : k + 1] == ["REV"]:
            k += 1
        if not name or name in stated or not numbers or (len(numbers) > 1 and name != "step"):
            return None
        stated[name] = (numbers[0], *FEEDS[word]) if name == "feed" else tuple(numbers)
    good = stated.get("feed", (1.0,))[0] > 0.0
    return stated if good else None


def _name(word: str, k: int, numbers: list[float]) -> str:
    """Return what the word, part k behind the kind, says; FEDTO counts upwards, but where it stands first and
    is above 0 downwards."""
    if word == "FEDTO" and k == 0 and numbers and numbers[0] > 0.0:
        return "depth"
    return "feed" if word in FEEDS else WORDS.get(word, "")


def _numbers(parts: list[str]) -> list[float]:
    """Return the numbers at the begin of ``parts``, of sizes that holes can have."""
    numbers: list[float] = []
    for part in parts:
        if not words.NUMBER.fullmatch(part) or not abs(float(part)) <= words.LARGEST:
            break
        numbers.append(float(part))
    return numbers


def _depth(stated: dict[str, tuple[float, ...]]) -> float | None:
    """How far below the point the hole ends: DEPTH counts downwards, FEDTO upwards; None where neither or
    both are said, or the end lies above the point."""
    depth = [*stated.get("depth", ()), *(-bottom for bottom in stated.get("bottom", ()))]
    return depth[0] + 0.0 if len(depth) == 1 and depth[0] >= 0.0 else None


def bottoms(cycle: Cycle, scale: float) -> list[float]:
    """Where the steps of a hole end, mm above the point (so 0 or less), the last at its depth; ``scale`` mm
    of the unit."""
    deep, depths, reached = cycle.depth * scale, [], 0.0
    steps = iter(cycle.steps)
    step = next(steps, 0.0)
    while step > 0.0 and reached + step * scale < deep - 1e-9:
        reached += step * scale
        depths.append(-reached)
        step = next(steps, step)
    return [*depths, -deep]


def way(cycle: Cycle, scale: float) -> list[tuple[float, bool]]:
    """Return the way along the axis before the tool leaves for ``out``: heights, mm above the point, and
    whether each is reached at feed."""
    clear = cycle.clear * scale
    depths: list[tuple[float, bool]] = [(clear, False)]
    last = None
    for bottom in bottoms(cycle, scale):
        if last is not None:
            depths += [(clear, False)] if cycle.chips == "DEEP" else []
            depths.append((min(last + GAP, clear), False))
        depths.append((bottom, True))
        last = bottom
    return [*depths, (clear, True)] if cycle.fed_out and cycle.out is not None else depths


def set_leaving(cycle: Cycle, how: float) -> Cycle:
    """Return the cycle with what ``how`` (of ``LEAVING``, 0: nothing) says of where its holes are left."""
    if how == words.LEAVING["CLEAR"]:
        return replace(cycle, out=None)
    return replace(cycle, out=math.nan) if how == words.LEAVING["INIT"] and cycle.out is None else cycle
