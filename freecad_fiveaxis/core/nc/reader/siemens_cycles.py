# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' drilling cycles CYCLE81 to CYCLE89 and CYCLE840: what a call says, and its steps in the hole.

RTP RFP SDIS     retraction plane, reference plane, safety clearance: the feed begins at RFP + SDIS, the tool
                 ends at RTP.
DP DPR           final depth, absolute or from RFP on; one of them is told, or both agree.
FDEP FDPR _DAM   CYCLE83: first depth; each peck is less than the one before by _DAM (below 0: that part of
                 it), but at least _MDEP; the last two of _DAM share what is left. VARI 1: up to RFP + SDIS
                 after each, and down to _DIS1 over the depth reached; 0: up by _VRT.
_VARI _DAM _VRT  CYCLE84: 1: a thread in infeeds of _DAM, back by _VRT (1 mm) after each; 2: out to RFP +
                 SDIS.
RPA RPO RPAP     CYCLE86: at the bottom so far aside in the plane's two axes and up, by rapid; so up to RFP +
                 SDIS, and over the middle again on the way to RTP.
FFR RFF          CYCLE85: feeds down and up.  PIT MPIT SST SST1: threads; the feed is pitch times speed.
MCALL            the cycle runs after each block that moves, until MCALL alone.

Source: Siemens 840D sl, Programming Manual Cycles (drilling cycles); the order of the values also as posts
write it. The pecks were written without the manual at hand: no other place hangs on them.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from itertools import pairwise

from freecad_fiveaxis.core.base.sentences import say

from .codes import INCH
from .cycle_plan import EQUAL_HEIGHT, Hole, Steps, Ways, pecks, steps_of
from .expressions import LARGEST, NUMBER, Parser, Unread, Variables, number

BASIC = ("RTP", "RFP", "SDIS", "DP", "DPR")
SHOWN = ("_GMODE", "_DMODE", "_AMODE")
THREAD = ("_PITM", "_PTAB", "_PTABA")
PARAMETERS = {
    "CYCLE81": (*BASIC, "DTB", *SHOWN),
    "CYCLE82": (*BASIC, "DTB", *SHOWN, "_VARI", "S_ZA", "S_FA", "S_ZD", "S_FD"),
    "CYCLE83": (
        *BASIC, "FDEP", "FDPR", "_DAM", "DTB", "DTS", "FRF", "VARI", "_AXN", "_MDEP", "_VRT", "_DTD", "_DIS1",
        *SHOWN,
    ),
    "CYCLE84": (
        *BASIC, "DTB", "SDAC", "MPIT", "PIT", "POSS", "SST", "SST1", "_AXN", "_PITA", "_TECHNO", "_VARI",
        "_DAM", "_VRT",
        *THREAD, *SHOWN,
    ),
    "CYCLE840": (*BASIC, "DTB", "SDR", "SDAC", "ENC", "MPIT", "PIT", "_AXN", "_PITA", "_TECHNO", *THREAD,
        *SHOWN),
    "CYCLE85": (*BASIC, "DTB", "FFR", "RFF", *SHOWN),
    "CYCLE86": (*BASIC, "DTB", "SDIR", "RPA", "RPO", "RPAP", "POSS", *SHOWN),
    "CYCLE87": (*BASIC, "SDIR", *SHOWN),
    "CYCLE88": (*BASIC, "DTB", "SDIR", *SHOWN),
    "CYCLE89": (*BASIC, "DTB", *SHOWN),
}  # fmt: skip
"""The values of each cycle in their order."""
WITHOUT_DWELL = (*BASIC, *SHOWN)
"""CYCLE81 with eight values, as some posts write it: no DTB."""
CODE = {"CYCLE84": 840, "CYCLE840": 840, "CYCLE85": 850, "CYCLE89": 890}
"""The ISO cycles that move alike; the others as G81."""
CHANGING = ("_GMODE", "_VARI", "S_ZA", "S_FA", "S_ZD", "S_FD", "RPA", "RPO", "RPAP")
"""Values other than 0 of these make other moves: a depth to the shank or by a diameter, pecks, a lateral
lift."""
NOT_CHANGING = {"CYCLE86": ("_GMODE", "RPA", "RPO", "RPAP"), "CYCLE84": ("_VARI",)}
"""Those of them that are known here, or change nothing."""
COARSE = {
    3: 0.5, 4: 0.7, 5: 0.8, 6: 1.0, 8: 1.25, 10: 1.5, 12: 1.75, 14: 2.0, 16: 2.0, 18: 2.5, 20: 2.5, 22: 2.5,
    24: 3.0, 27: 3.0,
    30: 3.5, 33: 3.5, 36: 4.0, 39: 4.0, 42: 4.5, 45: 4.5, 48: 5.0,
}  # fmt: skip
"""Pitch, mm, of metric coarse threads (ISO 261), for MPIT."""
MOST_PECKS = 10_000
FARTHEST = 1e7
WAYS = Ways()
CALL = re.compile(
    rb"(?<![A-Z0-9_$])(MCALL *)?(CYCLE(?:8[1-9]|840)) *\(((?:[^()\n]|\((?:[^()\n]|\([^()\n]*\))*\))*)\)"
    rb"|(?<![A-Z0-9_$])MCALL(?= *$)",
    re.MULTILINE,
)


@dataclass(frozen=True)
class Drill:
    """A call: the cycle's ``name``, '' for the end of a modal one; ``values``: its values by their names, in
    the program's units; ``modal``: it is called after each block; ``refused``: why it is not understood."""

    name: str = ""
    values: dict[str, float] = field(default_factory=dict)
    modal: bool = False
    refused: str = ""


def drill_of(name: str, inside: str, modal: bool) -> Drill:
    """Return what stands in the brackets of a call."""
    parts = [part.strip() for part in split_arguments(inside)]
    names = WITHOUT_DWELL if name == "CYCLE81" and len(parts) == len(WITHOUT_DWELL) else PARAMETERS[name]
    try:
        values = {one: _value(part) for one, part in zip(names, parts, strict=False) if part}
        beyond = [part for part in parts[len(names) :] if part and _value(part)]
    except Unread as refused:
        return Drill(name, modal=modal, refused=refused.reason)
    except (ArithmeticError, ValueError):
        return Drill(name, modal=modal, refused=say("a value that is no number"))
    return Drill(name, values, modal, _wrong(name, values, beyond))


def _value(text: str) -> float:
    """Return a number, or arithmetic without parameters. Raises Unread, ArithmeticError, ValueError."""
    if NUMBER.fullmatch(text.lstrip("+-")) and text.count("-") + text.count("+") <= 1:
        value = float(text)
    else:
        parser = Parser(text.replace(" ", "").replace("(", "[").replace(")", "]"), False)
        expression = parser.expression()
        if parser.rest():
            raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
        value = number(expression(Variables()))
    if not abs(value) < LARGEST:
        raise Unread(say("a value beyond all words"))
    return value


def _wrong(name: str, values: dict[str, float], beyond: list[str]) -> str:
    """Why the values make no moves that are known here; '' where they do."""
    if beyond:
        return say("it has more values than are known here")
    changing = [one for one in CHANGING if values.get(one) and one not in NOT_CHANGING.get(name, ())]
    if changing:
        return say("{rest} is not known here", rest=f"{changing[0]}={values[changing[0]]:g}")
    for one, known in (
        ("VARI", (0, 1)),
        ("_PITA", (0, 1, 2, 3, 4)),
        ("_AXN", (0, 3)),
        ("MPIT", (0, *COARSE)),
        ("_VARI", (0, 1, 2)),
    ):
        if abs(values.get(one, 0.0)) not in known:
            return say("{rest} is not known here", rest=f"{one}={values[one]:g}")
    needed = ("RTP", "RFP", *(("_DAM",) if _in_steps(name, values) else ()))
    missing = [one for one in needed if one not in values]
    if missing:
        return say("it has no {name}", name=missing[0])
    if any(
        abs(values.get(one, 0.0)) > FARTHEST for one in ("RTP", "RFP", "SDIS", "DP", "DPR", "FDEP", "FDPR")
    ):
        return say("a value beyond all words")
    return _wrong_depth(name, values)


def _wrong_depth(name: str, values: dict[str, float]) -> str:
    for one, other in (("DP", "DPR"), ("FDEP", "FDPR"))[: 2 if name == "CYCLE83" else 1]:
        if one not in values and other not in values:
            return say("it has no {name}", name=f"{one}, {other}")
        if (
            one in values
            and values.get(other)
            and abs(values["RFP"] - abs(values[other]) - values[one]) > EQUAL_HEIGHT
        ):
            return say("{one} and {other} tell two depths; leave one out", one=one, other=other)
    if _depth(values, "DP", "DPR") > values["RFP"] or values["RTP"] < values["RFP"]:
        return say("RTP, RFP and its depth do not lie one below the other")
    if name == "CYCLE83" and not _depth(values, "FDEP", "FDPR") < values["RFP"] - EQUAL_HEIGHT:
        return say("its first depth does not lie below RFP")
    if _in_steps(name, values) and not values["_DAM"] > 0.0:
        return say("{rest} is not known here", rest=f"_DAM={values['_DAM']:g}")
    return say("it makes too many pecks") if _count_infeeds(name, values) > MOST_PECKS else ""


def _count_infeeds(name: str, values: dict[str, float]) -> float:
    """Return the infeeds of a cycle, about; 1 of one that makes no more."""
    if _in_steps(name, values):
        return (values["RFP"] - _depth(values, "DP", "DPR")) / values["_DAM"]
    return len(_depths(values)) + 1 if name == "CYCLE83" else 1


def _in_steps(name: str, values: dict[str, float]) -> bool:
    """Whether a thread is cut in several infeeds."""
    return name == "CYCLE84" and values.get("_VARI", 0.0) in (1.0, 2.0)


def _depth(values: dict[str, float], absolute: str, relative: str) -> float:
    return (
        values["RFP"] - abs(values[relative]) if values.get(relative) else values.get(absolute, values["RFP"])
    )


def _depths(values: dict[str, float]) -> list[float]:
    """Return the depths of the pecks of CYCLE83 above the last."""
    bottom, at = _depth(values, "DP", "DPR"), values["RFP"]
    stroke, less = at - max(_depth(values, "FDEP", "FDPR"), bottom), values.get("_DAM", 0.0)
    floor = values.get("_MDEP", 0.0) or max(less, 0.0)
    depths = list[float]()
    while at - stroke > bottom + EQUAL_HEIGHT and len(depths) < MOST_PECKS:
        if less > 0.0 and stroke <= floor and at - bottom < 2.0 * stroke:
            return [*depths, (at + bottom) / 2.0]
        at -= stroke
        depths.append(at)
        stroke = max(stroke - less if less > 0.0 else -stroke * less, floor) if less else stroke
    return depths


@dataclass(frozen=True)
class Around:
    """What is in force where a cycle runs: the plane (0 to 2), F, S, feed per turn, mm of a unit of
    length and of that of F."""

    plane: int
    feed: float
    speed: float
    per_turn: bool
    scale: float
    feed_scale: float


def wrong_here(drill: Drill, around: Around) -> str:
    """Why the cycle makes no moves that are known where it runs."""
    plane = int(abs(drill.values.get("_DMODE", 0.0))) % 10
    if plane not in (0, around.plane + 1):
        return say("{rest} is not known here", rest=f"_DMODE={drill.values['_DMODE']:g}")
    if drill.values.get("_AXN") and around.plane:
        return say("{rest} is not known here", rest=f"_AXN={drill.values['_AXN']:g}")
    return ""


def steps(drill: Drill, around: Around) -> list[tuple[bool, float, float]]:
    """Rapids and feeds of a hole, from wherever the tool stands above it: (fast, height, F), in the program's
    units."""
    values, clear = drill.values, drill.values["RTP"]
    r, z = values["RFP"] + abs(values.get("SDIS", 0.0)), _depth(values, "DP", "DPR")
    if drill.name == "CYCLE83":
        moves: Steps = [*_deep(values, r, z, around.scale), (True, clear)]
    elif _in_steps(drill.name, values):
        moves = [*_thread(values, r, z, around.scale), (True, clear)]
    elif any(sideways(drill)):
        moves = [(False, z), (True, z + values.get("RPAP", 0.0)), (True, r), (True, clear)]
    else:
        moves = steps_of(Hole(CODE.get(drill.name, 810), r=r, z=z), clear, WAYS)
    feeds = [*_feeds(drill.name, values, around)]
    more = feeds if _in_steps(drill.name, values) else feeds[-1:]
    feeding = iter(feeds + more * len(moves))
    return [
        (True, r, math.nan),
        *((fast, height, math.nan if fast else next(feeding)) for fast, height in moves),
    ]


def _deep(values: dict[str, float], r: float, z: float, scale: float) -> Steps:
    whole = values.get("VARI", 0.0) == 1.0
    off = values.get("_DIS1", 0.0) if whole else values.get("_VRT", 0.0)
    if not off > 0.0:
        off = (min(max((values["RFP"] - z) * scale / 50.0, 0.6), 7.0) if whole else 1.0) / scale
    return pecks(r, _depths(values), z, off, whole, fast=whole)


def _thread(values: dict[str, float], r: float, z: float, scale: float) -> Steps:
    """Return the infeeds of a thread and the ways back between them, all at its feed."""
    back, moves, at = values.get("_VRT", 0.0) or 1.0 / scale, Steps(), values["RFP"]
    while at - values["_DAM"] > z + EQUAL_HEIGHT:
        at -= values["_DAM"]
        moves += [(False, at), (False, min(at + back, r) if values["_VARI"] == 1.0 else r)]
    return [*moves, (False, z), (False, r)]


def sideways(drill: Drill) -> tuple[float, float]:
    """How far CYCLE86 goes aside at the bottom, along the plane's first and second axis; back again in its
    last move."""
    if drill.name != "CYCLE86":
        return 0.0, 0.0
    return drill.values.get("RPA", 0.0), drill.values.get("RPO", 0.0)


def _feeds(name: str, values: dict[str, float], around: Around) -> tuple[float, ...]:
    """F of the feeds one after the other; the last goes on."""
    if name == "CYCLE83":
        return around.feed * (values.get("FRF", 0.0) or 1.0), around.feed
    if name == "CYCLE85":
        return values.get("FFR", 0.0) or around.feed, values.get("RFF", 0.0) or around.feed
    pitch = _pitch(values) / around.feed_scale
    if name not in ("CYCLE84", "CYCLE840") or not pitch:
        return (around.feed,)
    down = abs(values.get("SST", 0.0)) or around.speed
    speeds = down, abs(values.get("SST1", 0.0)) or down
    return (
        (pitch,)
        if around.per_turn
        else tuple(around.feed if math.isnan(one) else pitch * one for one in speeds)
    )


def _pitch(values: dict[str, float]) -> float:
    """mm a turn; 0 where the cycle does not say it."""
    pitch = abs(values.get("PIT", 0.0))
    if not pitch:
        return COARSE.get(int(abs(values.get("MPIT", 0.0))), 0.0)
    way = int(values.get("_PITA", 0.0))
    return {2: pitch * INCH, 3: INCH / pitch, 4: math.pi * pitch}.get(way, pitch)


def split_arguments(inside: str) -> list[str]:
    """Return what stands between commas that lie in no bracket of their own."""
    depth, cuts = 0, [-1]
    for at, sign in enumerate(inside):
        depth += (sign in "([") - (sign in ")]")
        if sign == "," and not depth:
            cuts.append(at)
    return [inside[one + 1 : other] for one, other in pairwise([*cuts, len(inside)])]
