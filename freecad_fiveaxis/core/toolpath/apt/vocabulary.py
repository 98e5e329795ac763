# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a CL file, by what they mean to a path (ISO 4343; the forms that CATIA, NX, Creo and Mastercam
print).

motion     GOTO/ x, y, z of the driven point, and i, j, k of the tool axis (tip to holder); FROM/ the same,
           where the tool starts; GODLTA/ a step from where it stands. TLAXIS/ the axis of those that follow
           without one.
harmless   says nothing about where the tool goes: machine, tolerance, colour, label, cutter, tool, coolant.
spoiling   moves the tool or the coordinates, and is not interpreted: what it does is missing in the path.
"""

from __future__ import annotations

import re

MOTIONS = {b"GOTO/": (3, 6), b"FROM/": (3, 6), b"GODLTA/": (1, 3, 6)}
"""How many numbers each may have."""

FREE_TEXT = ("PARTNO", "PPRINT", "INSERT", "REMARK", "DISPLY", "TPRINT", "LETTER", "PLABEL")
"""Words whose line is text: nothing in it is a statement, and no $ in it goes on in the next line."""

_HARMLESS = """MACHIN CLPRNT NOPOST CUTTER TLDATA LOADTL LOAD TURRET TOOLNO TOOL SELECT SELCTL UNLOAD INTOL OUTTOL TOLER TOOLPATH
END-OF-PATH PAINT MODE SEQNO LEADER AUXFUN PREFUN OPSKIP OPSTOP STOP END FINI REWIND BREAK CLEARP CLAMP CLRSRF SAFETY DELAY
DWELL SPINDL COOLNT MULTAX FEDRAT RAPID UNITS CHANNEL SYN SWITCH PIVOTZ RETRCT MCHFIN MCHTOL THICK TMARK HEAD MAXDPM MAXVEL
TLCOMP VERIFY CATMAT RESERV FLUSH AIR PLOT PARTNO ARCSLP SET CHUCK SADDLE COMBIN AUTOPS SETUP
CSI_SET_FLUTE_LENGTH CSI_SET_EXTENSION_LENGTH"""  # noqa: E501
HARMLESS = frozenset(_HARMLESS.split())

_CURVES = (
    """CIRCLE CYLNDR TLON TLLFT TLRGT INDIRV GOFWD GOBACK GOLFT GORGT GOUP GODOWN MOVARC NURBS SPLINE BCURV"""
)
CURVES = frozenset(_CURVES.split())
"""Curved moves, in forms that are not interpreted: the path goes on straight to the next GOTO."""

_FRAMES = """TRACUT ORIGIN TRANS ROTATE ROTABL ROTHED COPY INDEX CALL GOHOME CYCLE CUTCOM MSYS CSYS TRNTYP TLAXIS MACRO DO
LOOPST UNTIL JUMPTO IF"""  # noqa: E501
SPOILING = CURVES | frozenset(_FRAMES.split())

_WITHOUT_EFFECT = """CUTCOM/OFF TRACUT/NOMORE TRACUT/OFF TRACUT/ COPY/OFF ROTABL/OFF"""
WITHOUT_EFFECT = frozenset(_WITHOUT_EFFECT.split())
"""Whole statements with a spoiling word that switch something off."""
SHIFTS = frozenset({"ORIGIN", "TRANS", "TRNTYP"})
"""Words that do nothing when all their numbers are zero."""

UNITS = {
    "MM": 1.0,
    "CM": 10.0,
    "M": 1000.0,
    "INCHES": 25.4,
    "INCH": 25.4,
    "IN": 25.4,
    "FEET": 304.8,
    "FT": 304.8,
}
"""mm."""
FEED_UNITS = {"IPM": 25.4, "MMPM": 1.0}
PER_TURN = {"IPR": 25.4, "MMPR": 1.0, "PERREV": None}
"""mm a turn; PERREV: the file's unit."""

OF_INCHES = frozenset({"IPM", "IPR", "SFM", "FPM"})
"""Units of feeds and cutting speeds that files in mm do not say."""

LEAVING = {"CLEAR": 1.0, "INIT": 2.0}
"""CAMWorks, before a cycle: holes are left at the height of RAPTO, or at that of RTRCTO, where the tool stood
before."""

LARGEST = 1e9
"""A number of a circle, a cycle or a tool beyond this is a slip of the pen."""

NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:E[+-]?\d+)?")


def numbers_of(rest: str) -> list[float]:
    """Return the numbers among the parts between commas."""
    return [float(part) for part in rest.split(",") if NUMBER.fullmatch(part)]
