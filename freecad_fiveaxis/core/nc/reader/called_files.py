# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subprograms that a LinuxCNC program calls and that stand in files of their own, written behind it.

O<name> CALL   runs O<name> SUB ... ENDSUB of ``name.ngc``, the name in small letters; O100 CALL that of
               ``100.ngc``. What stands outside of subprograms in such a file is not run.

Source: LinuxCNC 2.9, O codes (calling files). The folders that are named are searched in their order.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .flow import O_WORD, without_number

ENDING = ".ngc"
MOST = 100
"""Files that one program may call."""


def file_of(name: str) -> str:
    """Return the file in which LinuxCNC looks for a subprogram, by its name as ``<NAME>`` or ``100``."""
    return name.strip("<>").lower() + ENDING


def with_called_files(
    text: bytes, folders: Sequence[str], clean: Callable[[bytes], bytes]
) -> tuple[bytes, list[int]]:
    """Return a text, in capitals and without comments, with the subprograms that it calls from files behind
    it; and the line of the text, from 0, that each line comes from: of a subprogram that of its first call.
    ``clean``: brings another text to the same form. Raises Unread for more files than :data:`MOST`."""
    rows = text.split(b"\n")
    origin = list(range(len(rows)))
    if not folders or b"CALL" not in text.replace(b" ", b""):
        return text, origin
    known, waiting, looked = {name for name, _ in _subs(rows)}, list(_calls(rows, origin)), set[str]()
    while waiting:
        name, at = waiting.pop(0)
        if name in known or name in looked:
            continue
        looked.add(name)
        subs = [sub for sub in _subs(_rows_of(name, folders, clean)) if sub[0] not in known]
        if len(looked) > MOST:
            raise Unread(say("it calls more than {most} programs", most=MOST), at)
        for sub, own in subs:
            known.add(sub)
            rows += own
            origin += [at] * len(own)
            waiting += _calls(own, [at] * len(own))
    return b"\n".join(rows), origin


def _rows_of(name: str, folders: Sequence[str], clean: Callable[[bytes], bytes]) -> list[bytes]:
    """Return the rows of the file of a subprogram; none where no folder has it."""
    for folder in folders:
        try:
            here = {entry.lower(): entry for entry in sorted(os.listdir(folder))}
            file = here.get(file_of(name))
            if file is not None:
                return clean(read_bytes(os.path.join(folder, file), "NC file")).split(b"\n")
        except (OSError, FileError):
            continue
    return []


def _o_words(rows: Sequence[bytes]) -> Iterator[tuple[int, str, str]]:
    """Yield index, name and keyword of the O-word lines."""
    for at, row in enumerate(rows):
        if b"O" in row and (found := O_WORD.match(without_number(row.replace(b" ", b"").decode("latin-1")))):
            yield at, found[1].lstrip("0") or "0", found[2]


def _calls(rows: Sequence[bytes], origin: Sequence[int]) -> Iterator[tuple[str, int]]:
    """Yield the names that are called, with the line of the text that each comes from."""
    return ((name, origin[at]) for at, name, word in _o_words(rows) if word == "CALL")


def _subs(rows: Sequence[bytes]) -> Iterator[tuple[str, list[bytes]]]:
    """Yield name and rows of each subprogram that is whole."""
    begun: dict[str, int] = {}
    for at, name, word in _o_words(rows):
        if word == "SUB":
            begun[name] = at
        elif word == "ENDSUB" and name in begun:
            yield name, list(rows[begun.pop(name) : at + 1])
