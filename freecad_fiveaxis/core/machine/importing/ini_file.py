# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's ini files: sections of ``KEY = value``, keys that repeat, ``#INCLUDE file``, lines that a
backslash joins."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

DEEPEST = 8
"""Files that include one another deeper than this go in a circle."""
MOST = 200
"""Files of one configuration, each counted as often as it is read; none needs as many, and a few that name
one another twice would make more than any time is enough for."""
LONGEST = 5_000_000
"""Bytes; no configuration is as long."""


@dataclass(frozen=True)
class Value:
    """What stands behind a key: its text, and where ("machine.ini line 7")."""

    text: str
    where: str


class Reading:
    """The files that one configuration makes the import read, so that the end is certain. ``path``: the ini
    file."""

    def __init__(self, path: Path) -> None:
        self.path, self.count = path, 0

    def take(self, path: Path, depth: int, where: str) -> None:
        """One file more, named at ``where``. Raises MachineError where they go in a circle or are too
        many."""
        self.count += 1
        if depth > DEEPEST:
            raise MachineError(
                say(
                    "{where}: {name} and others include one another in a circle; remove one",
                    where=where,
                    name=path.name,
                ),
                str(path),
            )
        if self.count > MOST:
            raise MachineError(
                say(
                    "{where}: more than {most} files are included, some again and again; leave out {name}",
                    where=where,
                    most=MOST,
                    name=path.name,
                ),
                str(path),
            )


class IniFile:
    """The values of an ini file by section and key, both as spelled."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.reading = Reading(path)
        self.values: dict[tuple[str, str], list[Value]] = {}
        section = ""
        for line, where in text_lines(path, "LinuxCNC configuration", self.reading):
            if found := re.fullmatch(r"\[(\w+)\]\s*(?:[#;].*)?", line):
                section = found[1]
            elif not line.startswith(("#", ";")) and "=" in line:
                key, _, text = line.partition("=")
                self.values.setdefault((section, key.strip()), []).append(Value(text.strip(), where))

    def every(self, section: str, key: str) -> list[Value]:
        """All values of a key, in their order."""
        return self.values.get((section, key), [])

    def get(self, section: str, key: str) -> Value | None:
        """Return the first value of a key (the one that LinuxCNC takes), or None."""
        return next(iter(self.every(section, key)), None)

    def need(self, section: str, key: str, remedy: str) -> Value:
        """Return the first value. Raises MachineError naming what is missing."""
        value = self.get(section, key)
        if value is None or not value.text:
            raise MachineError(
                say(
                    "{path}: [{section}] {key} is missing; {remedy}",
                    path=self.path,
                    section=section,
                    key=key,
                    remedy=remedy,
                ),
                f"[{section}] {key}",
            )
        return value


def text_lines(
    path: Path, what: str, reading: Reading | None = None, depth: int = 0
) -> Iterator[tuple[str, str]]:
    """Yield the lines of a text file without blanks at their ends, those that end in a backslash joined, each
    with its place.

    ``reading``: counts the files that ``#INCLUDE`` names; without it, that is a line like any other."""
    content = read_bytes(path, what)
    if b"\0" in content or len(content) > LONGEST:
        raise MachineError(say("{path} is no text file; give the {what}", path=path, what=what), str(path))
    begun, lines = "", re.split(r"\r\n|\r|\n", content.decode("utf-8-sig", "replace"))
    for number, line in enumerate(lines, 1):
        joined = begun + line.strip()
        begun = joined[:-1] + " " if joined.endswith("\\") else ""
        if begun and number < len(lines):
            continue
        if reading is not None and (found := re.fullmatch(r"#INCLUDE\s+(\S.*)", joined)):
            included = path.parent / found[1].strip()
            reading.take(included, depth + 1, f"{path.name} line {number}")
            yield from text_lines(included, what, reading, depth + 1)
        elif joined:
            yield joined, f"{path.name} line {number}"


def number(value: Value, what: str) -> float:
    """Return the value as a finite number. Raises MachineError naming it and its place."""
    words = value.text.split()
    try:
        given = float(words[0]) if words else math.nan
    except ValueError:
        given = math.nan
    if not math.isfinite(given):
        raise MachineError(
            say(
                "{where}: {what} is {text}, not a number; write the number itself",
                where=value.where,
                what=what,
                text=repr(value.text[:60]),
            ),
            value.text,
        )
    return given
