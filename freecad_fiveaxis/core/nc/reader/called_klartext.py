# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext programs that a program calls and that stand in files of their own, written behind it.

CALL PGM NAME.H   runs NAME.H from its first line to END PGM, then on behind the call. Q parameters are common
                  to both, labels are each program's own (Heidenhain TNC 640, Klartext Programming: calling
                  any NC program as a subprogram).

A folder before the name is one of the control; NAME.H is looked for in the folders that are named, in their
order. A call stays as it is, and is named as such, where no folder has the file, where its unit is another
one, or where M2 or M30 stand in it, which a called program must not have.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .preface import with_line_feeds

CALL = re.compile(r'^( *(?:[0-9]+ +)?)CALL +PGM +"?([^"\n]*?)"? *$')
LABEL = re.compile(r'\bLBL *("[^"]*"|[1-9][0-9]*)')
BEGIN = re.compile(r"^ *(?:[0-9]+ +)?BEGIN +PGM\b.*?(INCH|MM)? *$")
END = re.compile(r"^ *(?:[0-9]+ +)?END +PGM\b")
STOPS = re.compile(r"(?<![A-Z0-9])M0*(?:2|30)(?![0-9])")
COMMENT = re.compile(rb'("[^"\n]*")|;[^\n]*|^ *(?:[0-9]+ *)?\* *-[^\n]*', re.MULTILINE)
ENDING = ".h"
PROGRAM, RETURN = '"=PGM=', '"=END="'
"""How the label begins that a program written behind begins with, and the one that ends it."""
MOST = 100
"""Files that one program may call."""


def with_called_programs(text: bytes, folders: Sequence[str]) -> tuple[bytes, int]:
    """Return a text, in capitals and without comments, with the programs that it calls behind it, after an
    empty row; and how many rows are its own. Raises Unread for more files than :data:`MOST`."""
    rows = text.decode("latin-1").split("\n")
    own, first = len(rows), 0
    if not folders or not any(CALL.match(row) for row in rows):
        return text, own
    unit, names, at = _unit(rows), dict[str, bool](), 0
    while at < len(rows):
        found, first = CALL.match(rows[at]), at if at < own else first
        if found and (name := name_of(found[2])):
            if name not in names:
                program = _program(name, folders, unit)
                names[name] = program is not None
                if len(names) > MOST:
                    raise Unread(say("it calls more than {most} programs", most=MOST), first)
                rows += ([] if len(rows) > own else [""]) + (program or [])
            if names[name]:
                rows[at] = f'{found[1]}CALL LBL {PROGRAM}{name}"'
        at += 1
    return "\n".join(rows).encode("latin-1"), own


def name_of(path: str) -> str:
    """Return the name of a program that is called, without folder and ending."""
    name = re.split(r"[\\/:]", path.strip())[-1]
    return name[: -len(ENDING)] if name.lower().endswith(ENDING) else name


def _unit(rows: Sequence[str]) -> str:
    return next((found[1] or "" for row in rows if (found := BEGIN.match(row))), "")


def _program(name: str, folders: Sequence[str], unit: str) -> list[str] | None:
    """Return the rows of a program between its own labels; None where it cannot be run."""
    text = _text(name, folders)
    rows = [] if text is None else text.decode("latin-1").split("\n")
    if not rows or _unit(rows) != unit or any(STOPS.search(row) for row in rows):
        return None
    inner = [row for row in rows if not BEGIN.match(row) and not END.match(row)]
    own = [LABEL.sub(lambda found: f'LBL "{name}={found[1].strip(chr(34))}"', row) for row in inner]
    return [f'LBL {PROGRAM}{name}"', *own, f"LBL {RETURN}"]


def _text(name: str, folders: Sequence[str]) -> bytes | None:
    """Return the file of that name in capitals, without comments; None where no folder has it."""
    for folder in folders:
        try:
            here = {entry.lower(): entry for entry in sorted(os.listdir(folder))}
            if file := here.get(name.lower() + ENDING):
                text = with_line_feeds(read_bytes(os.path.join(folder, file), "NC file"))
                return COMMENT.sub(lambda found: found[1] or b"", text.replace(b"\t", b" ")).upper()
        except (OSError, FileError):
            continue
    return None
