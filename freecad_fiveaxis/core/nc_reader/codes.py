# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the G and M codes mean to the reader (ISO 6983-1, NIST RS274NGC 3, Fanuc B-63324EN; G43.4 is written 434).

modal group  codes of which one is in force at a time: motion, distance, units, feed mode.
finding      severity, code and text for each code that is not interpreted; the text goes on after "G2 stands in 3 lines:".
"""

from __future__ import annotations

from freecad_fiveaxis.core.findings import Severity

NONE, RAPID, STRAIGHT, ARC, CYCLE = -1, 0, 1, 2, 3
"""Motion modes. NONE: no motion code so far, or after G80."""
CYCLES = (*range(730, 770, 10), *range(810, 900, 10), 330, 331, 382, 383, 384, 385)
CURVES = (20, 30, 50, 52, 62)
MOTION = {0: RAPID, 10: STRAIGHT, 800: NONE, **dict.fromkeys(CURVES, ARC), **dict.fromkeys(CYCLES, CYCLE)}
DISTANCE = {900: 0, 910: 1}
UNITS = {210: 0, 200: 1}
PER_MINUTE, INVERSE, PER_TURN = 0, 1, 2
FEED_MODE = {940: PER_MINUTE, 930: INVERSE, 950: PER_TURN}
NO_MOVE = (40, 100, 280, 281, 300, 301, 520, 530, 650, 660, 661, 920, 921, 922, 923)
"""Codes (ten times the G number) whose axis words are no move of a block."""
OFFSETS = tuple(range(540, 600))
HARMLESS = {
    *(MOTION.keys() - set(CYCLES) - set(CURVES)), *DISTANCE, *UNITS, 940, 930, 40, 51, 80, 90, 150, 170, 180, 190, 400, 430, 440,
    490, 431, 432, 500, 610, 611, 640, 690, 901, 911, 960, 970, 980, 990, 1870, *OFFSETS,
}  # fmt: skip
WORDS_IGNORED = "NOSMTHDPQLFG"
AXES = "XYZABCUVW"

Kind = tuple[Severity, str, str]
ARCS: Kind = (Severity.ERROR, "arc-not-interpreted", "arcs, taken as straight to their end points; post straight moves")
CYCLE_KIND: Kind = (Severity.ERROR, "cycle-not-interpreted", "cycles, whose moves are missing here; post straight moves")
SPLINE: Kind = (Severity.ERROR, "spline-not-interpreted", "splines, taken as straight to their end points; post straight moves")
CALL: Kind = (Severity.ERROR, "call-not-interpreted", "calls, whose moves are missing here; post one program without them")
HOME: Kind = (Severity.WARNING, "machine-position", "moves to machine positions unknown to the program; they are not audited")
SHIFT: Kind = (Severity.ERROR, "offset-not-interpreted", "shifts, turns or scales of the coordinates; post without them")
RTCP: Kind = (Severity.ERROR, "rtcp-not-interpreted", "tool centre point control; the words are taken as joints all the same")
RADIUS: Kind = (Severity.ERROR, "compensation-not-interpreted", "cutter compensation; the words are taken as they are")
PER_TURN_KIND: Kind = (Severity.WARNING, "feed-per-turn", "feeds per spindle turn; no time is given for these blocks")

CODES: dict[int, Kind] = {
    **dict.fromkeys((20, 30), ARCS),
    **dict.fromkeys(CYCLES, CYCLE_KIND),
    **dict.fromkeys((50, 52, 62), SPLINE),
    **dict.fromkeys((650, 660, 661), CALL),
    **dict.fromkeys((280, 281, 300, 301, 530, 531), HOME),
    **dict.fromkeys((100, 160, 501, 510, 520, 544, 680, 682, 920, 921, 922, 923), SHIFT),
    **dict.fromkeys((434, 435, 2340, 2341), RTCP),
    **dict.fromkeys((410, 411, 420, 421), RADIUS),
    950: PER_TURN_KIND,
}
M_CODES: dict[int, Kind] = {97: CALL, 98: CALL, 128: RTCP, 428: RTCP}
