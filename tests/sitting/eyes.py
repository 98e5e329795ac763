# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is on the screen, read through the accessibility tree as a screen reader reads it, and in pictures.

thing     a widget or a part of one: its role, name, description, place and state. Only what is showing is
          looked at.
silence   how long the program gave no answer: every question is answered by the thread that draws its window.
"""

from __future__ import annotations

import contextlib
import os
import re
import subprocess
import threading
import time
from collections.abc import Iterator
from dataclasses import dataclass

from gi.repository import Gio, GLib

ACCESSIBLE, TEXT = "org.a11y.atspi.Accessible", "org.a11y.atspi.Text"
ROOT = "/org/a11y/atspi/accessible/root"
CHECKED, ENABLED, FOCUSED, MODAL, SHOWING = 4, 8, 12, 16, 25
"""Bits of a thing's state, by the standard of the tree."""
FLAT = ("list", "menu", "menu bar", "menu item", "separator", "status bar")
"""Roles that nothing is looked for below."""
ANSWER = 60_000
"""ms that an answer may take; then the program counts as hung."""


class Bus:
    """A connection of its own to the bus of the accessibility tree."""

    def __init__(self, address: str) -> None:
        flags = Gio.DBusConnectionFlags.AUTHENTICATION_CLIENT | Gio.DBusConnectionFlags.MESSAGE_BUS_CONNECTION
        self.connection = Gio.DBusConnection.new_for_address_sync(address, flags, None, None)

    def ask(self, name: str, path: str, interface: str, method: str, values: GLib.Variant | None = None):
        """What the program answers. Raises GLib.Error where the thing is gone or the program does not
        answer."""
        reply = self.connection.call_sync(
            name, path, interface, method, values, None, Gio.DBusCallFlags.NONE, ANSWER
        )
        return reply.unpack()

    def program(self, name: str) -> str:
        """The bus name of the program that calls itself so; empty where it is not there yet."""
        registry = "org.a11y.atspi.Registry"
        for child, path in self.ask(registry, ROOT, ACCESSIBLE, "GetChildren")[0]:
            values = GLib.Variant("(ss)", (ACCESSIBLE, "Name"))
            if self.ask(child, path, "org.freedesktop.DBus.Properties", "Get", values)[0] == name:
                return child
        return ""


@dataclass(frozen=True)
class Thing:
    """Something on the screen. ``box``: left, top, width, height in pixels."""

    bus: Bus
    name_on_bus: str
    path: str

    def _ask(self, method: str, values: GLib.Variant | None = None, interface: str = ACCESSIBLE):
        return self.bus.ask(self.name_on_bus, self.path, interface, method, values)

    def _property(self, name: str) -> str:
        values = GLib.Variant("(ss)", (ACCESSIBLE, name))
        return self._ask("Get", values, "org.freedesktop.DBus.Properties")[0]

    @property
    def role(self) -> str:
        return {"button": "push button", "tree item": "table cell"}.get(
            message := self._ask("GetRoleName")[0], message
        )

    @property
    def name(self) -> str:
        return self._property("Name")

    @property
    def description(self) -> str:
        return self._property("Description")

    @property
    def text(self) -> str:
        return self._ask("GetText", GLib.Variant("(ii)", (0, -1)), TEXT)[0]

    @property
    def box(self) -> tuple[int, int, int, int]:
        return self._ask("GetExtents", GLib.Variant("(u)", (0,)), "org.a11y.atspi.Component")[0]

    def has(self, state: int) -> bool:
        low, high = self._ask("GetState")[0]
        return bool((low | high << 32) >> state & 1)

    def children(self) -> list[Thing]:
        return [
            Thing(self.bus, name, path)
            for name, path in self._ask("GetChildren")[0]
            if not path.endswith("/null")
        ]


class Eyes:
    """Looks at one program. ``find`` waits until what is looked for is there."""

    def __init__(self, address: str, program: str) -> None:
        self.bus, self.program, self.root = Bus(address), program, None

    def is_there(self) -> bool:
        """Whether the program has come to the tree."""
        name = self.bus.program(self.program)
        self.root = Thing(self.bus, name, ROOT) if name else None
        return bool(name)

    def things(self, below: Thing | None = None) -> Iterator[tuple[Thing, str]]:
        """All that is showing, and its role, from the top of the window down; what goes meanwhile is left
        out."""
        for child in _there(lambda: (below or self.root).children(), []):
            if _there(lambda child=child: child.has(SHOWING), False):
                role = _there(lambda child=child: child.role, "")
                yield child, role
                if role not in FLAT:
                    yield from self.things(child)

    def see(self, role: str, name: str = "", below: Thing | None = None) -> Thing | None:
        """The first thing of that role whose whole name or description is matched by the expression ``name``
        (empty: any)."""
        for thing, its_role in self.things(below):
            if its_role == role and (not name or _there(lambda thing=thing: _is_called(thing, name), False)):
                return thing
        return None

    def window(self, title: str) -> Thing | None:
        """The window of the program with that title; it asks little, for a program at work answers slowly."""
        tops = _there(self.root.children, [])
        return next(
            (
                top
                for top in tops
                if is_seen(top) and re.fullmatch(title, _there(lambda top=top: top.name, ""))
            ),
            None,
        )

    def find(self, role: str, name: str = "", seconds: float = 20, below: Thing | None = None) -> Thing:
        """As ``see``, waiting. Raises TimeoutError, with what there is of that role."""
        end = time.monotonic() + seconds
        while True:
            thing = self.see(role, name, below)
            if thing:
                return thing
            if time.monotonic() > end:
                there = sorted({one.name for one, its in self.things(below) if its == role} - {""})
                raise TimeoutError(f"no {role} {name!r} within {seconds:g} s; there are {there[:40]}")
            time.sleep(0.1)

    def gone(self, role: str, name: str, seconds: float = 20) -> None:
        """Wait until there is no such thing. Raises TimeoutError."""
        end = time.monotonic() + seconds
        while self.see(role, name):
            if time.monotonic() > end:
                raise TimeoutError(f"{role} {name!r} is still there after {seconds:g} s")
            time.sleep(0.1)

    def all(self, role: str) -> list[Thing]:
        """Everything of that role that is showing."""
        return [thing for thing, its in self.things() if its == role]


def is_seen(thing: Thing) -> bool:
    """Whether the thing is there still and showing."""
    return _there(lambda: thing.has(SHOWING), False)


def _there(request, otherwise):
    try:
        return request()
    except GLib.Error as error:
        if error.matches(Gio.io_error_quark(), Gio.IOErrorEnum.TIMED_OUT):
            raise TimeoutError("the window does not answer") from error
        return otherwise  # gone between two questions


def _is_called(thing: Thing, wanted: str) -> bool:
    match = re.compile(wanted, re.DOTALL).fullmatch
    return bool(match(thing.name.replace("&", "")) or match(thing.description))


class Watch(threading.Thread):
    """Asks the window every 50 ms whether it is awake. ``longest(since)``: the longest time it took to
    answer, s.

    That is without the time in which the kernel gave the processors to others, so that a machine with other
    work tells the same: what the window's thread waited for one, the one of the program's other threads that
    waited most, and this thread.
    """

    EVERY = 0.05

    def __init__(self, address: str, name_on_bus: str, process: int) -> None:
        super().__init__(daemon=True)
        self.bus, self.name_on_bus, self.process = Bus(address), name_on_bus, process
        self.silences, self.running = [], True

    def run(self) -> None:
        while self.running:
            request, before = time.monotonic(), self.waits()
            with contextlib.suppress(GLib.Error):  # the program has gone
                self.bus.ask(self.name_on_bus, ROOT, ACCESSIBLE, "GetRole")
            took = time.monotonic() - request
            self.silences.append((request + took, max(0.0, took - self.starved(before))))
            time.sleep(max(0.0, self.EVERY - took))

    def waits(self) -> dict[int, float]:
        """What each thread of the program, and this one, has waited for a processor so far, s."""
        found = {0: waited(f"/proc/self/task/{threading.get_native_id()}")}  # a thread 0 there is not
        with contextlib.suppress(OSError):  # the program has gone
            folder = f"/proc/{self.process}/task"
            found |= {int(thread): waited(f"{folder}/{thread}") for thread in os.listdir(folder)}
        return found

    def starved(self, before: dict[int, float]) -> float:
        """The time since ``before`` (of :meth:`waits`) in which the program had no processor, s."""
        more = {thread: wait - before.get(thread, wait) for thread, wait in self.waits().items()}
        return more.pop(0) + more.pop(self.process, 0.0) + max(more.values(), default=0.0)

    def answers(self) -> int:
        """How many times the window has answered so far."""
        return len(self.silences)

    def longest(self, since: float) -> float:
        """The longest silence that ended after ``since`` (monotonic), s."""
        ended = [took for end, took in self.silences[-20_000:] if end >= since]
        return max([*ended, 0.0])


def waited(thread: str) -> float:
    """What a thread, a folder of /proc, has waited for a processor so far, s; 0 where it has ended or the
    kernel does not say."""
    try:
        with open(thread + "/schedstat", encoding="ascii") as file:
            return int(file.read().split()[1]) / 1e9
    except (OSError, IndexError):
        return 0.0


def picture(path: str) -> None:
    """The whole screen as a PNG."""
    subprocess.run(["import", "-window", "root", path], check=True, timeout=60)
