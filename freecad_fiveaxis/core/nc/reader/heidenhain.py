# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain conversational text (klartext) to plain words (User's manual Klartext programming).

% NAME G71   begin and end of a program in DIN/ISO, with its unit.
12 L X+1 IY-2 A+3 R0 F500 M3   a block number, the function L, words, I for an incremental one, radius
                               compensation, F, M.
FMAX   rapid, in its block alone.      LN ... TX TY TZ   with the tool's direction.      CC, C, CR   centre,
       arc, arc by radius.
CYCL DEF 7.1 X+10, TRANS DATUM AXIS X+10   shifts of the zero (:mod:`.shifts`).
TOOL CALL, CYCL DEF, FUNCTION ...      lines of words: known and harmless, known and not interpreted, or
                                       unknown.
~      the line goes on in the next one.                 Q1, QL1, QR1, QS1   parameters: not interpreted.
"""

from __future__ import annotations

import re

from . import codes
from .heidenhain_changes import HEAD, read_change
from .heidenhain_feeds import (
    BY_TOOL,
    UNKNOWN_FEED,
    feed_of_call,
    feeds_of_tools,
    note_unknown,
    without_words_of_m,
)
from .noted import Notes
from .old_working_plane import HEAD as OLD_PLANE
from .old_working_plane import read_working_plane
from .plane_calls import heidenhain as plane

CONTINUED = re.compile(rb"[^\n]*~ *\n(?:[^\n]*~ *\n)*[^\n]*")
NUMBERED = re.compile(rb"^( *(?:/ *)?)([0-9]+)(?= *(?:[A-Z/]|$))", re.MULTILINE)
BEGIN = re.compile(rb"^ *(?:[0-9]+ +)?BEGIN +PGM\b", re.MULTILINE)
G_LINE = re.compile(rb"^ *(?:/ *)?G[0-9][^\n]*", re.MULTILINE)
"""A line of DIN/ISO, which klartext does not know: what it says holds neither there nor behind it."""
COMMA = re.compile(
    rb'"[^"\n]*"|((?<![A-Z0-9])(?:[A-Z]{1,3}|Q[LR]?[0-9]+ *=|MB|DIST|ABST)? *[-+]?[0-9]*),(?=[0-9])'
)
"""A decimal comma, or what stands in quotation marks."""
CYCLE = re.compile(rb"\bCYCL +DEF(?=[0-9])")
CODE_LINE = re.compile(rb"^ *(?:/ *)?(?!LN )([A-Z]{2,}[^\n]*)$", re.MULTILINE)
OWN = re.compile(
    rb"(?:LN?|CC|CR?)(?= |[IXYZABCUVW][XYZABC]?[-+.0-9])|I[XYZABC](?= *[-+.0-9])|FMAX|R[LR]\b|[TN][XYZ] "
    rb"*[-+.0-9]"
)
"""How lines of words begin that are not lines of one function: they are words with numbers."""
LINE = re.compile(rb"^( *(?:/ *)?)LN?(?=[ IXYZABCFRMTN])", re.MULTILINE)
ARC = re.compile(rb"^( *(?:/ *)?)CR?(?= +(?:[XYZxyz]|DR))", re.MULTILINE)
CENTRE = re.compile(rb"^( *(?:/ *)?)CC\b([^\n]*)$", re.MULTILINE)
TOOL_AXIS = re.compile(rb"TOOL CALL(?: *(?:[0-9.]+|Q[LRS]?[0-9]+))? *([XYZ])(?![0-9A-Z])")
"""The axis that the tool of a TOOL CALL lies along: arcs are in the plane across it."""
PLANES = {b"X": b"G19", b"Y": b"G18", b"Z": b"G17"}
SENSE = re.compile(rb"DR *([-+])")
NO_RADIUS = re.compile(rb"(?<![A-Z0-9.])R0(?![0-9.])")
SIDE = re.compile(rb"(?<![A-Z])R([LR])(?![A-Z])")
FIRST_LINE = re.compile(rb"\s*%[^\n]*?\s+G7([01])(?![0-9.])")
"""The begin of a DIN/ISO program: its name, and its unit: G70 is inch, G71 mm (User's manual DIN/ISO
programming)."""
LAST_LINE = re.compile(rb"^ *N[0-9]+ *%[^\n]*", re.MULTILINE)
"""The end of a DIN/ISO program: its name once more."""
RETRACT = re.compile(rb"M140 *MB *(?:MAX|[-+]?[0-9.]+)(?: +F *(?:MAX|[0-9.]+))?")
RAPID = re.compile(rb"(?<![A-Z])F +MAX\b")
EMPTY = re.compile(
    rb"(?<![A-Z0-9])(?:R(?= +[FM]| *$)|F(?= +M(?: *[0-9]| *$)| *$)|M(?= *$))(?<=[0-9. ][RFM])", re.MULTILINE
)
"""R, F or M alone, as old controls list them behind the words of a block: the radius compensation, or F,
stays as it is."""
STEP = re.compile(rb"I([XYZABC])")
SHIFT = re.compile(
    rb"(?:CYCL DEF 7\.[1-9]|TRANS DATUM AXIS) *((?:I?[XYZABC] *[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+) *)+)$|TRANS "
    rb"DATUM RESET$"
)
"""A shift of the zero, told by axes; one of a table is not known here."""
FEED_BY_NAME = re.compile(rb"F *Q[LR]?[0-9]+")
NORMAL = re.compile(rb"(?<![A-Z])N[XYZ] *[-+]? *[0-9]*\.?[0-9]+\.?")
"""A component of the surface's normal, which moves nothing."""
PARAMETER = re.compile(rb"^[^\n]*(?:Q[LRS]?[0-9]+|[=#])[^\n]*$", re.MULTILINE)

PRIVATE = ((b"TX", "i"), (b"TY", "j"), (b"TZ", "k"))
QUIET = re.compile(rb"FN *(?:14|15|16|19|20|26|27|29|37|38) *:|(?:DECLARE STRING )?QS[0-9]+ *=")
"""Functions that write, show, wait or stop, and settings of strings: none moves an axis."""
HARMLESS = (
    b"END PGM", b"BLK FORM", b"TOOL CALL", b"TOOL DEF", b"LBL", b"STOP", b"CYCL DEF 32",
    b"CYCL DEF 13", b"CYCL DEF 7.0", b"FUNCTION MODE MILL", b"SECTION MONITORING",
    b"FUNCTION MODE SET", b"FUNCTION COUNT", b"FUNCTION S-PULSE", b"FUNCTION LIFTOFF",
    b"FUNCTION PARAXCOMP DISPLAY",
)  # fmt: skip
"""How lines begin that move nothing; a post of old TNCs spells the dwell CYCLE DEF."""
DELTA = re.compile(rb"(?<![A-Z0-9])D(?:L|R2?) *[-+]? *(?:Q[LRS]?[0-9]+|[0-9]*\.?[0-9]+\.?)")
NO_DELTA = re.compile(rb"D(?:L|R2?) *[-+]? *[0.]+$")
PRESET = re.compile(rb"CYCL DEF 247\b(?:.*?Q339 *= *([-+]?[0-9]+))?")
KINDS: tuple[tuple[bytes, codes.Kind], ...] = (
    (b"CYCL DEF 7 ", codes.SHIFT), (b"CYCL DEF 7.", codes.SHIFT), (b"CYCL DEF 8", codes.SHIFT),
    (b"CYCL DEF 10", codes.SHIFT),
    (b"CYCL DEF 11", codes.SHIFT), (b"CYCL DEF 19", codes.SHIFT), (b"CYCL DEF 26", codes.SHIFT),
    (b"PLANE", codes.SHIFT),
    (b"TRANS", codes.SHIFT), (b"CYCL DEF 9.", codes.DWELL_KIND), (b"CYCLE DEF 9.", codes.DWELL_KIND),
    (b"FUNCTION DWELL", codes.DWELL_KIND), (b"FUNCTION FEED", codes.DWELL_KIND),
    (b"CYCL", codes.CYCLE_KIND), (b"TCH PROBE", codes.CYCLE_KIND),
    (b"PATTERN", codes.CYCLE_KIND),
    (b"CALL", codes.CALL), (b"SEL", codes.CALL), (b"FN", codes.MACRO), (b"IF", codes.MACRO),
    (b"ELSE", codes.MACRO), (b"WHILE", codes.MACRO), (b"FOR", codes.MACRO), (b"END IF", codes.MACRO),
    (b"END WHILE", codes.MACRO), (b"END FOR", codes.MACRO),
    (b"DECLARE", codes.MACRO),
    (b"RND", codes.ARC_KIND), (b"CHF", codes.ARC_KIND), (b"APPR", codes.ARC_KIND), (b"DEP", codes.ARC_KIND),
    (b"CT", codes.ARC_KIND),
    (b"CP", codes.ARC_KIND), (b"LP", codes.ARC_KIND), (b"LT", codes.ARC_KIND), (b"FPOL", codes.ARC_KIND),
    (b"FL", codes.ARC_KIND),
)  # fmt: skip
"""The first that the line begins with."""


def plain(text: bytes, notes: Notes) -> bytes:
    """Return the text, in capitals and without comments, as ISO words with the private letters; every line
    stays where it is."""
    text = NUMBERED.sub(lambda found: found[1] + b" " * len(found[2]), text)
    text = LAST_LINE.sub(_blank, text) if b"%" in text else text
    if b"G" in text and BEGIN.search(text):
        text = G_LINE.sub(lambda found: _note_word(found, codes.UNKNOWN, notes), text)
    text = RETRACT.sub(lambda found: _retract(found, notes), text) if b"M140" in text else text
    text = without_words_of_m(feeds_of_tools(text, notes), notes)
    text = RAPID.sub(lambda found: b"FMAX".ljust(len(found[0])), text)
    text = EMPTY.sub(_blank, text)
    text = CODE_LINE.sub(lambda found: _function(found, notes), text)
    _name_datum_changes(notes)
    text = text.replace(b"FMAX", b"G0  ").replace(b" R0 ", b"    ")
    for word, private in PRIVATE:
        text = text.replace(word, private.encode() + b" ")
    text = NORMAL.sub(_blank, text) if b"N" in text else text
    if b"F" in text:
        text = BY_TOOL.sub(lambda found: note_unknown(found, notes), text)
        text = FEED_BY_NAME.sub(lambda found: _note_word(found, UNKNOWN_FEED, notes), text)
    if b"Q" in text or b"=" in text or b"#" in text:
        text = PARAMETER.sub(lambda found: _note_word(found, codes.MACRO, notes), text)
    text = _words(text, notes).replace(b" L ", b" G1").replace(b" LN ", b" G1 ")
    return LINE.sub(rb"\1G1", text) if b"L" in text else text


def join_lines(text: bytes) -> bytes:
    """Return the text with each function that goes on over several lines (~) in its first one."""
    return CONTINUED.sub(_one_line, text) if b"~" in text else text


def with_points(text: bytes) -> bytes:
    """Return klartext with a point for each decimal comma, which a setting of the control (MP7280) writes; in
    DIN/ISO a comma ends the number of a label."""
    if b"," not in text or not BEGIN.search(text):
        return text
    return COMMA.sub(lambda found: found[1] + b"." if found[1] is not None else found[0], text)


def with_unit(whole: bytes, text: bytes) -> bytes:
    """``text``, of which the first line of ``whole`` has been blanked, with the unit that this line says."""
    found = FIRST_LINE.match(whole)
    if found is None:
        return text
    at = found.start(1) - 2
    return text[:at] + (b"G20" if found[1] == b"0" else b"G21") + text[at + 3 :]


def _words(text: bytes, notes: Notes) -> bytes:
    """Incremental words, radius compensation and arcs."""
    text = STEP.sub(lambda found: found[1].lower() + b" ", text) if b"I" in text else text
    if b"CC" in text:
        text = CENTRE.sub(lambda found: _centre(found, notes), text)
    if b"C " in text or b"CR " in text:
        text = ARC.sub(lambda found: found[1] + b" " * (len(found[0]) - len(found[1])), text)
    if b"R" in text:
        text = SENSE.sub(lambda found: (b"G3" if found[1] == b"+" else b"G2").ljust(len(found[0])), text)
        text = NO_RADIUS.sub(b"  ", text)
        text = SIDE.sub(lambda found: _note_word(found, codes.RADIUS, notes), text)
    return text


def _one_line(found: re.Match[bytes]) -> bytes:
    """Return a function over several lines as its first line, with empty ones behind it and as long as
    before."""
    lines = found[0].split(b"\n")
    return b" ".join(line.replace(b"~", b"", 1) for line in lines) + b"\n" * (len(lines) - 1)


def _blank(found: re.Match[bytes]) -> bytes:
    return b" " * len(found[0])


def _note_word(found: re.Match[bytes], kind: codes.Kind, notes: Notes) -> bytes:
    notes.note(kind, b" ".join(found[0].split()).decode("latin-1"), found.start())
    return b" " * len(found[0])


def _retract(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return M140 without its way and its F: the tool is no longer where the program knows it."""
    return b"M140" + _note_word(found, codes.HOME, notes)[4:]


def _centre(found: re.Match[bytes], notes: Notes) -> bytes:
    """CC: the axis letters become those of an absolute centre; an incremental one is not known here."""
    words = found[2]
    if re.search(rb"[xyz]", words) or not re.search(rb"[XYZ]", words):
        return _note_word(found, codes.ARC_KIND, notes)
    return found[1] + b"  " + words.translate(bytes.maketrans(b"XYZ", codes.CENTRE.encode()))


def _function(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return what a line that begins with a word of letters means."""
    line = CYCLE.sub(b"CYCL DEF ", b" ".join(found[1].split()))
    before = found[0][: found.start(1) - found.start()]
    if OWN.match(line):
        return found[0]
    if b"CENTER-CENTER" in line:
        notes.note(codes.SHIFT, "REFPNT CENTER-CENTER", found.start(1))
    if line.startswith(b"PLANE "):
        return before + notes.tilt(plane(line.decode("latin-1"))).ljust(len(found[1]))
    words = line.decode("latin-1")
    if HEAD.match(words) or OLD_PLANE.match(words):
        return before + b" " * len(found[1])
    if change := read_change(words) or read_working_plane(words):
        return before + notes.tilt(change).ljust(len(found[1]))
    if shift := SHIFT.match(line):
        return before + (b"s1 " + shift[1] if shift[1] else b"s0").ljust(len(found[1]))
    if line.startswith((b"TOOL CALL", b"CYCL DEF 247")):
        _note_tool_or_datum(line, found.start(1), notes)
        return before + _words_of_call(line).ljust(len(found[1]))
    word = _word_of(line)
    if word is None:
        _note_function(line, found.start(1), notes)
    return before + (word or b"").ljust(len(found[1]))


def _words_of_call(line: bytes) -> bytes:
    """Return the words that a TOOL CALL leaves in force: plane and F."""
    axis, feed = TOOL_AXIS.match(re.sub(rb'"[^"]*"', b"0", line)), feed_of_call(line)
    if not line.startswith(b"TOOL"):
        return b""
    return (PLANES[axis[1]] if axis else b"") + (b"F" + feed if feed else b"")


def _note_tool_or_datum(line: bytes, at: int, notes: Notes) -> None:
    """TOOL CALL with differences other than 0, and a datum of the table."""
    if preset := PRESET.match(line):
        notes.note(codes.PRESET, f"CYCL DEF 247 Q339={int(preset[1] or 0)}", at)
    deltas = [one for one in DELTA.findall(re.sub(rb'"[^"]*"', b"", line)) if not NO_DELTA.match(one)]
    if deltas:
        notes.note(codes.DELTA, b" ".join([b"TOOL CALL", *deltas]).decode("latin-1"), at)


def _name_datum_changes(notes: Notes) -> None:
    """Several rows of the table are another finding than one."""
    rows = [(kind, name) for kind, name in notes.met if kind is codes.PRESET]
    for key in rows if len(rows) > 1 else ():
        notes.met[codes.PRESETS, key[1]] = notes.met.pop(key)


def _word_of(line: bytes) -> bytes | None:
    """Return the private word of a function that is interpreted, nothing for one that is harmless, None for
    another."""
    if line.startswith(b"BEGIN PGM"):
        return b"G20" if line.endswith(b"INCH") else b"G21"
    if line.startswith(b"FUNCTION RESET TCPM"):
        return b"t0"
    if line.startswith(b"FUNCTION TCPM") and b"AXIS SPAT" not in line:
        return b"t1"
    return b"" if line.startswith(HARMLESS) or QUIET.match(line) else None


def _note_function(line: bytes, at: int, notes: Notes) -> None:
    if line.startswith(b"FUNCTION TCPM"):
        kind = codes.SPATIAL
    else:
        kind = next((kind for start, kind in KINDS if line.startswith(start)), codes.UNKNOWN)
    name = (
        line[:2] if line.startswith((b"CP ", b"LP ")) else b" ".join(line.split()[:3])
    )  # each has other numbers
    notes.note(kind, name.decode("latin-1"), at)
