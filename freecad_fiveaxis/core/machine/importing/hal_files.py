# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values that LinuxCNC's HAL files give to pins.

pin      a number of a component, set by ``setp pin value`` or fed by a signal.
signal   what ``net signal pin ...`` joins pins with; ``sets signal value`` gives it a value.

HAL files of the kind ``.tcl`` are programs; of them, and of ``.hal`` files, these statements alone are read,
wherever they stand. Files that begin with ``LIB:`` are LinuxCNC's own, know nothing of the machine and are
not read.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.base.sentences import Template, say

from .ini_file import IniFile, Value, number, text_lines
from .panel import panel_values

FILES = ("HALFILE", "POSTGUI_HALFILE")
TRUE = {"1": 1.0, "TRUE": 1.0, "0": 0.0, "FALSE": 0.0}
FROM_INI = re.compile(r"\[(\w+)\]\(?(\w+)\)?|\$::(\w+)\((\w+)\)")
ARROWS = {"<=", "=>", "<=>"}


class HalValues:
    """What all HAL files of a configuration say about pins."""

    def __init__(self, ini: IniFile) -> None:
        self.loaded: list[Value] = []
        """What ``loadrt`` loads: module and options."""
        self.programs: list[Value] = []
        """What ``loadusr`` starts: options, program and its arguments."""
        self.panel = panel_values(ini)
        self.from_panel: dict[str, float] = {}
        """The pins whose value was asked for and is what a slider of the screen starts with."""
        self.set: dict[str, Value] = {}
        self.signals: dict[str, Value] = {}
        self.signal_of: dict[str, str] = {}
        self.sources: dict[str, set[str]] = {}
        self.unread: list[FileError] = []
        """HAL files that cannot be read: they matter where the module has pins."""
        for text, where in _statements(ini, self.unread):
            self._take(_substitute_ini(text, where, ini).split(), where)

    def value(self, pin: str) -> float | None:
        """Return the number that a pin has from the start, None where nothing sets it. Raises MachineError
        where that is not known."""
        signal = self.signal_of.get(pin)
        given = self._find_start_value(pin, signal)
        if given is None and signal is not None and self.sources[signal] - {pin}:
            others = ", ".join(sorted(self.sources[signal] - {pin}))
            text = Template(
                "{pin} comes from signal {signal} ({others}), whose value no HAL file says; write setp {pin} "
                "VALUE for the import"
            )
            raise MachineError(text.say(pin=pin, signal=signal, others=others), pin)
        if given is None:
            return None
        found = TRUE[given.text.upper()] if given.text.upper() in TRUE else number(given, pin)
        if self._panel_of(pin) is not None:
            self.from_panel[pin] = found
        return found

    def _find_start_value(self, pin: str, signal: str | None) -> Value | None:
        """Return what the slider that drives the signal starts with, else what ``sets`` says of it, else
        ``setp`` of the pin itself."""
        of_signal = None if signal is None else self.signals.get(signal)
        return self._panel_of(pin) or of_signal or self.set.get(pin)

    def _panel_of(self, pin: str) -> Value | None:
        """Return what a slider that a signal joins with the pin starts with."""
        sources = self.sources.get(self.signal_of.get(pin, ""), set())
        return next((self.panel[source] for source in sorted(sources) if source in self.panel), None)

    def beside(self, pin: str, other: str) -> tuple[float | None, bool]:
        """Give the number of a pin without what ``other`` adds to it, and whether it adds to it: alone, or by
        a sum2.

        Raises MachineError where the number is not known."""
        if self.is_joined(pin, other):
            return 0.0, True
        name = self._sum_into(pin)
        if name is None:
            return self.value(pin), False
        gains = {f"{name}.in{i}": self._or(f"{name}.gain{i}", 1.0) for i in (0, 1)}
        added = next((place for place in gains if gains[place] == 1.0 and self.is_joined(place, other)), None)
        rest = sum(gains[place] * self._or(place, 0.0) for place in gains if place != added)
        return self._or(f"{name}.offset", 0.0) + rest, added is not None

    def _or(self, pin: str, default: float) -> float:
        return default if (given := self.value(pin)) is None else given

    def _sum_into(self, pin: str) -> str | None:
        """Return the sum2 whose output feeds a pin."""
        sources = self.sources.get(self.signal_of.get(pin, ""), set())
        return next((name for name in self._sums() if f"{name}.out" in sources), None)

    def _sums(self) -> Iterator[str]:
        for module, *options in (value.text.split() for value in self.loaded):
            given = dict(option.split("=", 1) for option in options if "=" in option)
            if module == "sum2" and "names" in given:
                yield from given["names"].strip('"').split(",")
            elif module == "sum2":
                count = given.get("count", "1")
                yield from (
                    f"sum2.{i}" for i in range(int(count) if re.fullmatch("[0-9]{1,2}", count) else 1)
                )

    def with_signal(self, pin: str) -> set[str]:
        """Return the pins that a signal joins with one, that one too; empty where none does."""
        return self.sources.get(self.signal_of.get(pin, ""), set())

    def is_set(self, pin: str) -> bool:
        """Tell whether anything sets a pin or joins it with another."""
        return pin in self.set or len(self.with_signal(pin)) > 1

    def is_joined(self, pin: str, other: str) -> bool:
        """Whether one signal joins both pins."""
        signal = self.signal_of.get(pin)
        return signal is not None and other in self.sources[signal]

    def _take(self, words: list[str], where: str) -> None:
        words = [word for word in words if word not in ARROWS]
        words = words[1:] if words[:1] == ["hal"] else words
        if len(words) == 1 and re.fullmatch(r"[\w.-]+=\S+", words[0]):  # the short form of setp
            words = ["setp", *words[0].split("=")]
        if len(words) >= 3 and words[1] == "=":
            words = ["setp", words[0], words[2]]
        match words:
            case ["loadrt", _, *_]:
                self.loaded.append(Value(" ".join(words[1:]), where))
            case ["loadusr", _, *_]:
                self.programs.append(Value(" ".join(words[1:]), where))
            case ["setp", pin, value, *_]:
                self.set[pin] = Value(value, where)
            case ["sets", signal, value, *_]:
                self.signals[signal] = Value(value, where)
            case ["net" | "linksp", signal, *pins]:
                self._join(signal, pins)
            case ["linkps", pin, signal]:
                self._join(signal, [pin])

    def _join(self, signal: str, pins: list[str]) -> None:
        self.sources.setdefault(signal, set()).update(pins)
        self.signal_of.update(dict.fromkeys(pins, signal))


def _statements(ini: IniFile, unread: list[FileError]) -> Iterator[tuple[str, str]]:
    for key in FILES:
        for value in ini.every("HAL", key):
            name = value.text.split()[0] if value.text else ""
            if name and not name.startswith("LIB:"):
                try:
                    yield from _of_file(ini.path.parent / _at_home(name, value.where), ini, value.where)
                except FileError as error:
                    unread.append(error)
    for value in ini.every("HAL", "HALCMD"):
        yield value.text, value.where


def _at_home(name: str, where: str) -> Path:
    """Return the file, ``~`` and ``~user`` being folders of users. Raises MachineError where there is no such
    user."""
    try:
        return Path(name).expanduser()
    except RuntimeError as error:
        text = say(
            "{where}: {name} begins with the folder of a user who is not known; write the whole path",
            where=where,
            name=name,
        )
        raise MachineError(text, name) from error


def _of_file(path: Path, ini: IniFile, named: str, depth: int = 0) -> Iterator[tuple[str, str]]:
    """Yield the statements of a HAL file and of those that it sources (relative to the ini file, as LinuxCNC
    has it).

    ``named``: where it is named. Raises MachineError where the files go in a circle or are too many."""
    ini.reading.take(path, depth, named)
    for line, where in text_lines(path, "HAL file"):
        text = line.partition("#")[0].strip().rstrip(";")
        words = text.split()
        if words[:1] == ["source"] and len(words) == 2 and not words[1].startswith(("LIB:", "$")):
            yield from _of_file(ini.path.parent / words[1], ini, where, depth + 1)
        elif words:
            yield text, where


def _substitute_ini(text: str, where: str, ini: IniFile) -> str:
    """``[SECTION](KEY)``, ``[SECTION]KEY`` and Tcl's ``$::SECTION(KEY)`` replaced by the ini file's value."""

    def value(found: re.Match[str]) -> str:
        section, key = (found[1], found[2]) if found[1] else (found[3], found[4])
        given = ini.get(section, key)
        if given is None and "setp" in text:
            raise MachineError(
                say(
                    "{where}: [{section}] {key} is missing in {path}; add it",
                    where=where,
                    section=section,
                    key=key,
                    path=ini.path,
                ),
                f"[{section}] {key}",
            )
        return given.text if given else found[0]

    return FROM_INI.sub(value, text) if "[" in text or "$::" in text else text
