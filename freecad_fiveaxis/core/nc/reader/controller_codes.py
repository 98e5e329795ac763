# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one controller means by a code or a word that the others of its language mean otherwise.

haas      G68 turns the coordinates, as Fanuc's does. G110 to G129 are work offsets, G70 to G72 circles and
          rows of holes (NGC mill operator's manual).
fanuc     G16 makes X and Y polar (:mod:`.polar_mode`). G43.1 is a length along the tool's axis, in whose
          lines X Y Z move (B-63324EN, tool length compensation in tool axis direction); elsewhere its words
          are the length itself (LinuxCNC, grbl).
          G112 is another name of G12.1, polar coordinates (B-64304EN, G code list), where Haas' mills have a
          work offset.
grbl      F in a program in inches is made mm a minute whatever moves (gcode.c of grbl-Mega-5X), so that of
          rotary axes alone is 25.4 times as many degrees.
turns     LinuxCNC's P of G2 and G3: an arc of P turns, P1 where none is told; grblHAL has it from there. L of
          Fanuc's spiral and conical interpolation, where the radius stays (B-63324EN, 4.8).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding

from . import codes
from .codes import GRAMMARS, Grammar
from .lines import Lines
from .noted import kind_findings
from .words import Words

HOLES = (700, 710, 720)
TAPS = (770, 1740, 1840)
"""G77 back boring and G174, G184, threads along a tilted tool, of Haas."""
RELAYS = (128, 129)
"""M121 to M129 of Haas switch relays of the owner: M128 is no guide of the tip there."""
NUMBERED = tuple(range(1100, 1300, 10))
ALONG_AXIS = 431
POLAR_ON, POLAR_OFF = 1120, 1130
TURNING = ("linuxcnc", "grbl", "")
"""Controllers whose arcs have turns; "": nobody has said which."""
OTHER_P = (41, 51, 100, 434, 435, 541, 640, 960, 1540, 1870, 2340)
"""Codes in whose line P is theirs."""
M_WITH_P = (*range(62, 69), 97, 98)


def grammar_of(language: str, controller: str) -> Grammar:
    """Return the grammar of a text in that language for that controller, ``""`` where nobody has said it."""
    grammar = GRAMMARS[language]
    if language != "iso":
        return grammar
    if controller == "haas":
        return replace(
            grammar,
            codes=_without(grammar, codes.TURN) | dict.fromkeys((*HOLES, *TAPS), codes.CYCLE_KIND),
            harmless=grammar.harmless | {*NUMBERED, codes.TURN}, offsets=grammar.offsets + NUMBERED,
            no_move=grammar.no_move + HOLES + TAPS,
            guide_m={code: on for code, on in (grammar.guide_m or {}).items() if code not in RELAYS},
        )  # fmt: skip
    if controller == "grbl":
        return replace(grammar, inch_degrees=False)
    if controller == "fanuc":
        no_move = tuple(code for code in grammar.no_move if code != ALONG_AXIS)
        own = {ALONG_AXIS: codes.SHIFT, POLAR_ON: codes.POLAR}
        return replace(
            grammar, codes={**_without(grammar, codes.TURN, codes.POLAR_MODE), **own}, no_move=no_move,
            harmless=grammar.harmless | {POLAR_OFF, codes.TURN, codes.POLAR_MODE},
        )  # fmt: skip
    return grammar


def _without(grammar: Grammar, *numbers: int) -> dict[int, codes.Kind]:
    """Return what is said of codes, but of these, which are interpreted."""
    return {code: kind for code, kind in grammar.codes.items() if code not in numbers}


def turn_arcs(
    words: Words, lines: Lines, grammar: Grammar, controller: str = ""
) -> tuple[Words, list[Finding]]:
    """Return the words with the turns of arcs (P, L of Fanuc) as the private word for those besides; without
    any, the same object."""
    count = "P" if controller in TURNING else "L" if controller == "fanuc" else ""
    if grammar.name != "iso" or not count or count not in lines.letters:
        return words, []
    arc = lines.mode(grammar.motion, codes.NONE) == codes.ARC
    arc &= ~np.isnan(lines.columns("IJKR")).all(axis=1) & ~lines.any_of(OTHER_P)
    arc[lines.m_line(M_WITH_P)] = False
    at = np.flatnonzero((words.letter == ord(count)) & arc[words.line])
    if not len(at):
        return words, []
    letter, value = words.letter.copy(), words.value.copy()
    letter[at] = ord(codes.TURNS)
    value[at] = np.maximum(np.rint(value[at]), 1.0) - 1.0
    return replace(words, letter=letter, value=value), []


def name_inclinations(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Report the inclination Q of a tool that vectors turn (G43.5 of Fanuc), which is not read."""
    if grammar.name != "iso" or not np.isin(lines.code, codes.VECTORS_ON).any():
        return words, []
    group = {**dict.fromkeys((*codes.GUIDE_ON, *codes.GUIDE_OFF), 0), **dict.fromkeys(codes.VECTORS_ON, 1)}
    row = np.flatnonzero((lines.mode(group, 0) == 1) & (np.nan_to_num(lines.column("Q")) != 0.0))
    return words, kind_findings(codes.SPATIAL, {"Q of G43.5": (int(row[0]), len(row))}) if len(row) else []


def name_quadratic_splines(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Report lines of G5.1 with I or J, which is LinuxCNC's quadratic spline; with Q it is Fanuc's
    smoothing."""
    if grammar.name != "iso" or 51 not in lines.code:
        return words, []
    row = np.flatnonzero(lines.any_of((51,)) & ~np.isnan(lines.columns("IJ")).all(axis=1))
    return words, kind_findings(codes.SPLINE, {"G5.1": (int(row[0]), len(row))}) if len(row) else []
