# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens 840D text to plain words (Programming manual, Fundamentals and Job planning).

X=1.5     an address with an equals sign.          X=AC() X=IC() C=DC()   absolute, incremental, by the
          shorter way.
A3= B3= C3=   the tool's direction.                 CR=                    radius of an arc; I=AC() an
              absolute centre;
                                                    TURN= full turns that an arc makes besides (Fundamentals,
                                                    helix).
KEYWORD   a word of two letters and more, maybe with brackets: known and harmless, known and not interpreted,
          or unknown.
"""

from __future__ import annotations

import re

from . import codes, corners, feed_groups, siemens_cycles
from .noted import Notes
from .plane_calls import cycle800
from .siemens_cycles import Drill, drill_of

STRING = re.compile(rb'"[^"\n]*"')
NUMBER = rb" *([-+]?[0-9.][0-9. ]*)"
BRACKETED = re.compile(rb"(?<![A-Z_$])([XYZABCIJK]) *= *(AC|IC|DC|ACP|ACN) *\(" + NUMBER + rb"\)")
VECTOR = re.compile(rb"(?<![A-Z_$])([ABC])3 *=")
RADIUS = re.compile(rb"(?<![A-Z_$])CR *=")
TURNS = re.compile(rb"(?<![A-Z0-9_$])TURN *=(?= *\+?[0-9])")
ALONE = re.compile(
    rb"^( *(?:N *[0-9]+ *)?)(?:(L[0-9]+)|([A-Z_][A-Z_][A-Z0-9_]*)(?: *\((?:[^()\n]|\([^()\n]*\))*\))?)(?: +P "
    rb"*=? *[0-9]+)? *$",
    re.MULTILINE,
)
"""A line of nothing but a name: a subprogram, where it is no known word."""
ADDRESS = re.compile(rb"(?<![A-Z_$])([XYZABCUVWFIJKSDT]) *=(?= *[-+.0-9])")
SIDE = re.compile(
    rb"(?<![A-Z0-9_$])(?:CTOL|ATOL|OTOL|ADIS|ADISPOS|[SMH][0-9]+|FP|SF|TOFFR|FGREF\[[A-Z]\]) "
    rb"*=" + NUMBER
)
AXIS_BY_NUMBER = re.compile(rb"(?<![A-Z0-9_$])([XYZABC]1) *=" + NUMBER)
FIXED_POINT = re.compile(rb"(?<![A-Z0-9])G *0*7[45](?![0-9])")
"""The lines in which X1=0 is the name of a machine axis, whatever it is to: G74 and G75."""
SPINDLE_OR_DRIVE = re.compile(
    rb"(?<![A-Z0-9_$])(?:SPOSA?|LIMS|ACC|JERKLIM|VELOLIM|FL|FA|STOLF)(?: *\[[^\]\n]*\])? *="
    rb" *(?:(?:AC|IC|DC|ACP|ACN) *\(" + NUMBER + rb"\)|" + NUMBER.replace(b"(", b"(?:") + rb")"
)
"""Where a spindle stops, and limits of drives and of positioning axes: neither place nor F of a block."""
LENGTH = re.compile(rb"(?<![A-Z0-9_$])(TOFFL?)(?:\[[A-Z1-3]\])? *=" + NUMBER)
"""A change of the tool's length on top of the table's, which moves the tip."""
FRAME = re.compile(rb"(?<![A-Z0-9_$])(A?SCALE|A?MIRROR|A?ROTS)(?![A-Z0-9_])[^\n]*")
"""What scales, mirrors or turns the coordinates, in a block of its own, whose words are no move."""
SHIFT = re.compile(rb"(?<![A-Z0-9_$])(A)?TRANS(?![A-Z0-9_])")
ROTATE = re.compile(rb"(?<![A-Z0-9_$])(A)?ROT(?![A-Z0-9_])")
IN_THE_PLANE = re.compile(rb"(?<![A-Z0-9_$])RPL *=(?= *[-+.0-9])")
SWIVEL = "CYCLE800"
CYCLE800 = re.compile(rb"\bCYCLE800(?: *\(([^()\n]*)\)|(?= *$))", re.MULTILINE)
"""Without brackets it ends the plane, as with empty ones."""
TOOL = re.compile(rb"(?<![A-Z0-9_$])T *=(?= *(?:$|[A-Z]))", re.MULTILINE)
ORIENTATION = re.compile(rb"(?<![A-Z0-9_$])(?:[ABC][2-9]|LEAD|TILT|THETA|PHI|PSI) *=" + NUMBER)
VALUE = rb" *= *[-+]?[0-9.]+(?![0-9. ]*[-+*/(\[])"
"""A plain number ends a keyword's value; of anything else nobody knows where it ends, and the rest of the
line goes with it."""
KEYWORD = re.compile(rb"[A-Z_$][A-Z_$][A-Z0-9_$]*( *\([^()\n]*\)|" + VALUE + rb"| *=[^\n]*)?")
LABEL = re.compile(rb"^( *(?:N[0-9]+ *)?)([A-Z_][A-Z_][A-Z0-9_]*:)", re.MULTILINE)

STATEMENT = re.compile(
    rb"^( *(?:N *[0-9]+ *)?)((DEF|DEFINE|FOR|CASE|PROC|IF|WHILE|UNTIL|SET|REPEATB?|GOTO[FBC]?)\b[^\n]*)",
    re.MULTILINE,
)
"""A line of variables or jumps, whose words are none of a block."""
STATEMENTS = (b"DEF", b"FOR", b"CASE", b"PROC", b"IF", b"WHILE", b"UNTIL", b"SET", b"REPEAT", b"GOTO")
OWN_HEAD = re.compile(
    rb"^ *(?:N *[0-9]+ *)?PROC +[A-Z_][A-Z0-9_]* *(?:\( *\))?"
    rb"(?: +(?:SAVE|DISPLOF|DISPLON|SBLOF|SBLON|ACTBLOCNO))* *$",
    re.MULTILINE,
)
"""The head of a subprogram that takes no values, and is read by itself."""
OWN_END = re.compile(rb"^( *(?:N *[0-9]+ *)?)RET(?= *$)", re.MULTILINE)
HARMLESS = frozenset(
    b"""TRAFOOF TRAORI ORIWKS ORIMKS ORIAXES ORIVECT ORIEULER ORIRPY ORIRPY2 ORIVIRT1 ORIVIRT2 ORIPLANE ORISON ORISOF
    FGROUP FFWON FFWOF SOFT BRISK DRIVE COMPON COMPOF COMPCURV COMPCAD COMPSURF STOPRE CYCLE832 MSG WORKPIECE CUT3DC CUT2D CUT2DF
    CUT3DF CUT3DFF NORM KONT KONTC KONTT DIAMOF UPATH SPATH FIFOCTRL STARTFIFO STOPFIFO G64 FNORM FLIN FCUB CFTCP CFC CFIN
    RTLION RTLIOF OST OSC OSOF OSS OSSE SPOF SPON PTP CP ORICURVE DYNNORM DYNPOS DYNROUGH DYNSEMIFIN DYNFINISH DYNPREC ORISOLH
    EXTCLOSE PAROT PAROTOF SETMS FXS CYCLE_HSC GROUP_BEGIN GROUP_END WAITM DISPLOF DISPLON SAVE SBLON SBLOF ACCLIMA VELOLIM
    SPCON SPCOF COMPPATH WALIMON WALIMOF CDON CDOF CDOF2 FENDNORM LFON LFOF SOFTA BRISKA DRIVEA ORIC ORID CPRECON
    CPRECOF TOROTOF CORROF DRFOF WAITP GET GETD RELEASE CLEARM SETM BLSYNC IPOBRKA
    DISR DISRP DISCL DISC FAD OFFN ORIRESET CTRANS TOWSTD TOWTCP TCOFR TCOABS MIRRORW""".split()  # noqa: E501
)
SHIFTS = frozenset(
    b"DIAMON ROTS AROTS SCALE ASCALE MIRROR AMIRROR CYCLE800 TOROT TOFRAME TCARR G58 RPL".split()
)
CALLS = frozenset(b"CALL PCALL EXTCALL MCALL ISOCALL".split())
ARCS = frozenset(b"CIP CT TURN AR".split())
SPLINES = frozenset(b"ASPLINE BSPLINE CSPLINE POLY POLYPATH INVCW INVCCW".split())
POLAR = frozenset(b"AP RP".split())
CORNERS = frozenset(b"RND RNDM CHR CHF ANG ANG1 ANG2".split())
MACROS = frozenset(
    b"""IF ELSE ENDIF FOR ENDFOR WHILE ENDWHILE LOOP ENDLOOP REPEAT REPEATB UNTIL GOTO GOTOF GOTOB GOTOC GOTOS CASE DEF DEFINE
    PROC SET RET ID IDS EVERY WHENEVER WHEN DO FROM""".split()  # noqa: E501
)
KNOWN = HARMLESS | {b"TRAORI", b"TRAFOOF", b"SUPA"}
CYCLE = re.compile(rb"CYCLE[0-9]+|HOLES[0-9]|SLOT[0-9]|POCKET[0-9]|LONGHOLE|OSCTRL|OSE")
KINDS = (
    (SHIFTS, codes.SHIFT), (CALLS, codes.CALL), (ARCS, codes.ARC_KIND), (SPLINES, codes.SPLINE),
    (POLAR, codes.POLAR),
    (CORNERS, codes.CORNER),
)  # fmt: skip
WAYS = {
    b"AC": str,
    b"IC": codes.STEP_OF,
    b"DC": codes.SHORTER_OF,
    b"ACP": codes.SHORTER_OF,
    b"ACN": codes.SHORTER_OF,
}


def plain(text: bytes, notes: Notes) -> bytes:
    """Return the text, in capitals and without comments, as ISO words with the private letters; every line
    stays where it is."""
    text = corners.mark_corners(shifts(_without_statements(without_strings(text), notes)), siemens=True)
    if b"SCALE" in text or b"MIRROR" in text or b"ROTS" in text:
        text = FRAME.sub(lambda found: _note_word(found, codes.SHIFT, found[1], notes), text)
    if b"FG" in text:
        text = feed_groups.WORD.sub(notes.feeds.word, text)
    text = ALONE.sub(lambda found: _alone(found, notes), text)
    if b"=" in text:
        text = _addresses(text, notes)
    if b"CYCLE8" in text or b"MCALL" in text:
        text = siemens_cycles.CALL.sub(lambda found: _drill(found, notes), text)
    return KEYWORD.sub(
        lambda found: _keyword(found, notes), LABEL.sub(_label, text) if b":" in text else text
    )


def _without_statements(text: bytes, notes: Notes) -> bytes:
    """Leave out the head of a program, and lines of variables and jumps, which are noted."""
    if b"PROC" in text:
        text = OWN_HEAD.sub(_blank, text)
    if b"RET" in text:
        text = OWN_END.sub(rb"\1M17", text)
    if not any(word in text for word in STATEMENTS):
        return text
    return STATEMENT.sub(lambda found: _leave_out(found, notes), text)


def swivels(text: bytes, notes: Notes) -> bytes:
    """Return the text with the private word of a tilted plane for each CYCLE800, whose tool carrier stands in
    quotation marks."""
    return CYCLE800.sub(
        lambda found: notes.tilt(cycle800((found[1] or b"").decode("latin-1"))).ljust(len(found[0])), text
    )


def shifts(text: bytes) -> bytes:
    """Return the text with the private word of a shift for TRANS, ATRANS, ROT and AROT, whose words stay as
    they are."""
    if b"ROT" in text:
        text = ROTATE.sub(lambda found: (b"s5" if found[1] else b"s4").ljust(len(found[0])), text)
        text = IN_THE_PLANE.sub(lambda found: codes.IN_THE_PLANE.encode().ljust(len(found[0])), text)
    return (
        SHIFT.sub(lambda found: (b"s3" if found[1] else b"s2").ljust(len(found[0])), text)
        if b"TRANS" in text
        else text
    )


def _drill(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return the private word of a call of a drilling cycle, or of MCALL alone, which ends one."""
    drill = Drill()
    if found[2]:
        drill = drill_of(found[2].decode(), found[3].decode("latin-1"), bool(found[1]))
    return notes.drill(drill).ljust(len(found[0]))


def without_strings(text: bytes) -> bytes:
    """Return the text without what stands in quotation marks."""
    return TOOL.sub(_blank, STRING.sub(_blank, text)) if b'"' in text else text


def _blank(found: re.Match[bytes]) -> bytes:
    return b" " * len(found[0])


def _label(found: re.Match[bytes]) -> bytes:
    return found[1] + b" " * len(found[2])


def _addresses(text: bytes, notes: Notes) -> bytes:
    for letter, private in zip((b"A", b"B", b"C"), codes.VECTOR, strict=True):
        text = text.replace(letter + b"3=", private.encode() + b"  ")
    if b"=" not in text:
        return text
    text = BRACKETED.sub(lambda found: _rewrite_bracket(found, notes), text)
    text = VECTOR.sub(
        lambda found: codes.VECTOR["ABC".index(found[1].decode())].encode().ljust(len(found[0])), text
    )
    text = RADIUS.sub(lambda found: b"R".ljust(len(found[0])), text)
    if b"TURN" in text:
        text = TURNS.sub(lambda found: codes.TURNS.encode().ljust(len(found[0])), text)
    text = ADDRESS.sub(lambda found: found[1].ljust(len(found[0])), text)
    text = SIDE.sub(_blank, SPINDLE_OR_DRIVE.sub(_blank, text))
    if b"TOFF" in text:
        text = LENGTH.sub(lambda found: _rewrite_length(found, notes), text)
    text = AXIS_BY_NUMBER.sub(lambda found: _axis_by_number(found, notes), text) if b"1" in text else text
    return ORIENTATION.sub(
        lambda found: _note_word(found, codes.SPATIAL, found[0].split(b"=")[0].strip(), notes), text
    )


def _axis_by_number(found: re.Match[bytes], notes: Notes) -> bytes:
    """Leave out the word of a machine axis; where it moves one, that is noted."""
    text, last = found.string, found.string.find(b"\n", found.end())
    line = text[text.rfind(b"\n", 0, found.start()) + 1 : last if last >= 0 else None]
    return _blank(found) if FIXED_POINT.search(line) else _note_word(found, codes.OTHER_AXIS, found[1], notes)


def _leave_out(found: re.Match[bytes], notes: Notes) -> bytes:
    """Leave out a line of variables or jumps, which is noted."""
    notes.note(codes.MACRO, found[3].decode("latin-1"), found.start(2))
    return found[1] + b" " * len(found[2])


def _rewrite_length(found: re.Match[bytes], notes: Notes) -> bytes:
    """Leave out a change of the tool's length; one by other than nothing is noted."""
    nothing = not found[2].strip(b" -+.0")
    return _blank(found) if nothing else _note_word(found, codes.SHIFT, found[1], notes)


def _rewrite_bracket(found: re.Match[bytes], notes: Notes) -> bytes:
    letter, way, number = found[1].decode(), found[2], found[3]
    if way in (b"ACP", b"ACN"):
        notes.note(codes.WAY, f"{letter}={way.decode()}()", found.start())
    if letter in "IJK":
        word = codes.CENTRE["IJK".index(letter)] if way == b"AC" else letter
    elif way == b"AC":
        mark = codes.ABSOLUTE.encode() + b"%d" % codes.AXIS_LETTERS.index(letter)
        return (found[1] + number + mark).ljust(len(found[0]))
    else:
        known = codes.STEP_OF if way == b"IC" else codes.SHORTER_OF
        word = known.get(letter, letter)
    return (word.encode() + number).ljust(len(found[0]))


def _note_word(found: re.Match[bytes], kind: codes.Kind, name: bytes, notes: Notes) -> bytes:
    notes.note(kind, name.decode("latin-1"), found.start())
    return _blank(found)


def _keyword(found: re.Match[bytes], notes: Notes) -> bytes:
    """Blanks, or the private word, for a keyword with what belongs to it; a note where it is not
    interpreted."""
    name = re.split(rb"[ (=]", found[0], maxsplit=1)[0]
    if name == b"TRAORI":
        return b"t1".ljust(len(found[0]))
    if name == b"TRAFOOF":
        return b"t0".ljust(len(found[0]))
    if name in (b"SUPA", b"G53"):
        return b"v1".ljust(len(found[0]))
    if name in HARMLESS:
        return _blank(found)
    if name == b"MCALL":  # of something else: it ends the modal cycle before it
        return notes.drill(Drill()) + _note_word(found, codes.CALL, name, notes)[2:]
    return _note_word(found, _kind(name), name, notes)


def _alone(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return the line with blanks for a call, noted; as it is where its word is a known one."""
    name = found[2] or found[3]
    if name in KNOWN or not (found[2] or _kind(name) is codes.UNKNOWN):
        return found[0]
    return found[1] + _note_word(found, codes.CALL, name, notes)[len(found[1]) :]


def _kind(name: bytes) -> codes.Kind:
    for known, kind in KINDS:
        if name in known:
            return kind
    if name in MACROS or name.startswith(b"$"):
        return codes.MACRO
    return codes.CYCLE_KIND if CYCLE.fullmatch(name) else codes.UNKNOWN
