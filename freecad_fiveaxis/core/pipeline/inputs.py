# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files that a job reads, looked at before the long work: each is there and begins as what it should be,
and the message where not names it, its option and the remedy.

kind   what the beginning of a file tells: an STL file, a CL file, an NC program, JSON. A file is refused as
       of another kind only where it plainly is of that one; what nobody can tell is left to its reader.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from freecad_fiveaxis.core.base.errors import FiveAxisError, MeshError, SettingsError
from freecad_fiveaxis.core.base.files import check_readable, open_file
from freecad_fiveaxis.core.base.sentences import Option, Sentence, Task, say
from freecad_fiveaxis.core.geometry.mesh import check_stl_beginning
from freecad_fiveaxis.core.machine import machine_path

from .outputs import list_paths_read, name_curve_files
from .settings import AUDIT, COMPARE, MILL, POST, REACH, RECOVER, SETUP, Settings, is_part

STL, CL, NC, JSON = "stl", "cl", "nc", "json"
KINDS = {
    STL: say("an STL file"),
    CL: say("a CL file (APT)"),
    NC: say("an NC program"),
    JSON: say("JSON text"),
}
REMEDIES = {
    STL: say("name another file ({task} takes parts)", task=Task("mill")),
    CL: say("name another file ({task} takes CL files)", task=Task("post")),
    NC: say("name another file ({task} takes NC programs)", task=Task("audit")),
    JSON: say("name another file ({task} takes job files)", task=Task("run")),
}
"""What takes a file of that kind."""
OF_SOURCE = {MILL: STL, REACH: STL, POST: CL, RECOVER: CL, AUDIT: NC}
OF_OPTION = {"faces": STL, "avoid": STL, "fixture": STL, "program": NC}
FOLDERS = ("search",)
"""Options that hold folders, at which their reader looks."""
BEGINNING = 4096
"""Bytes that tell the kind of a file."""

CL_LINE = re.compile(
    rb"\s*(?:GOTO|MULTAX|UNITS|PARTNO|MACHIN|CUTTER|FEDRAT|LOADTL|SPINDL|TOOL PATH|FROM)\s*/", re.IGNORECASE
)
NC_LINE = re.compile(
    rb"\s*(?:%|(?:N?\d+\s*)?(?:\([^)]*\)\s*)?"
    rb"(?:[GMTSFXYZABCO]\s*[-+=]?[\d.]|LN?\s+[XYZABCFR]|TOOL CALL|(?:BEGIN|END) PGM|BLK FORM))",
    re.IGNORECASE,
)


class InputFile(NamedTuple):
    """``option``: its name in the settings, empty for what is given without one; ``kind``: what it should be,
    empty where nobody looks."""

    option: str
    path: str
    kind: str = ""


def check_inputs(settings: Settings) -> None:
    """Check all files that the job reads. Raises FileError, MeshError or SettingsError that names the first
    that cannot be used, its option and the remedy."""
    check_files(list_inputs(settings))


def check_files(files: Iterable[InputFile]) -> None:
    """Check these. Raises as :func:`check_inputs`."""
    files = tuple(files)
    for one in files:
        _name_option(one, check_readable)
    _refuse_exchanged(files)
    for one in files:
        if one.kind:
            _check_kind(one)


def list_inputs(settings: Settings) -> Iterator[InputFile]:
    """Yield the files that the job reads, the source first."""
    if settings.source:
        kind = OF_SOURCE.get(settings.task, "")
        if settings.task in (SETUP, COMPARE):
            kind = STL if is_part(settings.source) else CL
        yield InputFile("", settings.source, kind)
    for name, path in list_paths_read(settings):
        if name in FOLDERS:
            continue
        against = STL if is_part(path) else CL
        yield InputFile(
            "" if name == "program" else name, path, against if name == "against" else OF_OPTION.get(name, "")
        )
    for name, path in name_curve_files(settings):
        yield InputFile(name, path)
    given = [("machine", settings.machine.machine), *(("machines", one) for one in settings.compare.machines)]
    for option, name in given:
        file = machine_path(name) if name else None
        if file is not None:
            yield InputFile(option, os.fspath(file))


def find_kind(path: str) -> str:
    """Tell the kind of a file from its beginning; empty where that is not plain."""
    with open_file(path) as file:
        start, size = file.read(BEGINNING), os.fstat(file.fileno()).st_size
    try:
        check_stl_beginning(start, size)
        return STL
    except MeshError:
        pass
    if b"\0" in start:
        return ""
    lines = [line for line in start.splitlines()[:60] if line.strip()]
    if any(map(CL_LINE.match, lines)):
        return CL
    if 2 * sum(NC_LINE.match(line) is not None for line in lines) > len(lines):
        return NC
    return JSON if start.lstrip()[:1] in (b"{", b"[") else ""


def _check_kind(one: InputFile) -> None:
    found = find_kind(one.path)
    if found == one.kind:
        return
    if found:
        text = say(
            "{path} is {found}, needed is {wanted}; {remedy}",
            path=one.path, found=KINDS[found], wanted=KINDS[one.kind], remedy=_remedy(one, found),
        )  # fmt: skip
        raise SettingsError(_after_option(one, text), one.path)
    if one.kind == STL:
        _name_option(one, _check_stl)


def _remedy(one: InputFile, found: str) -> Sentence:
    return say("name another file") if one.option else REMEDIES[found]


def _check_stl(path: str) -> None:
    with open_file(path) as file:
        start, size = file.read(BEGINNING), os.fstat(file.fileno()).st_size
    try:
        check_stl_beginning(start, size)
    except MeshError as error:
        raise MeshError(say("{name}: {problem}", name=path, problem=error), error.value) from error


def _refuse_exchanged(files: tuple[InputFile, ...]) -> None:
    """Refuse two files of which each is what the other should be."""
    bare = [one for one in files if not one.option and one.kind]
    if len(bare) != 2:
        return
    kinds = [find_kind(one.path) for one in bare]
    if bare[0].kind != bare[1].kind and kinds == [bare[1].kind, bare[0].kind]:
        first, second = bare
        text = say(
            "{first} is {found} and {second} is {other}: the two are exchanged; name {second} first",
            first=first.path, found=KINDS[kinds[0]], second=second.path, other=KINDS[kinds[1]],
        )  # fmt: skip
        raise SettingsError(text, first.path)


def _name_option(one: InputFile, check: Callable[[str], None]) -> None:
    """Check the file; what is raised says its option."""
    try:
        check(one.path)
    except FiveAxisError as error:
        raise type(error)(_after_option(one, error.text), error.value) from error


def _after_option(one: InputFile, text: str) -> Sentence | str:
    if not one.option:
        return text
    return say("{option}: {problem}", option=Option(one.option), problem=text)
