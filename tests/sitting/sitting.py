# SPDX-License-Identifier: LGPL-2.1-or-later
"""One sitting: FreeCAD, eyes and hands, and what is looked at after every step.

step      a function that does what a user does and waits for what he would see; it raises TimeoutError or
          Unseen where it is not.
red       a line of a panel that says why something cannot be done or should not have happened.
"""

from __future__ import annotations

import os
import re
import time
from dataclasses import dataclass

from desk import Desk, run_quietly
from eyes import Eyes, Thing, Watch, picture
from hands import Hands

HERE = os.path.dirname(os.path.abspath(__file__))
PROJECT = os.path.dirname(os.path.dirname(HERE))

BAD = re.compile(
    r"Traceback|\w*Error\b|\w*Exception\b|Segmentation fault|SIGSEGV|already deleted|[Uu]nhandled|resizeDocks"
)
NOT_OURS = re.compile(r"Addon Manager|QtWebEngine|zygote|libEGL|MESA|dconf|dbus|GLib|Gtk-", re.IGNORECASE)
"""What FreeCAD or the machine says by itself, with no add-on too."""
ANSWERED = re.compile(r"^told: (.*)$", re.MULTILINE)
"""What the console was made to say."""
RED = "Error"
"""How a red line describes itself to a screen reader."""


class Unseen(Exception):
    """What a user would have seen by now is not there, or what he should not see is."""


@dataclass
class Row:
    """A step as it went: the user's clicks and keys, seconds, longest silence (s), and what failed."""

    step: str
    clicks: int = 0
    keys: int = 0
    seconds: float = 0.0
    silence: float = 0.0
    failed: str = ""


class Sitting:
    """What the steps have in their hands. ``folder``: where pictures go; ``home``: the user's."""

    def __init__(self, desk: Desk, folder: str, part: str) -> None:
        self.desk, self.folder, self.home, self.part = desk, folder, os.environ["HOME"], part
        self.nc_file = ""
        self.hands, self.rows = Hands(), []
        self.eyes: Eyes | None = None
        self.watch: Watch | None = None
        self.log, self.read = os.path.join(folder, "freecad.log"), 0
        open(self.log, "wb").close()
        self.program = None

    # ------------------------------------------------------------------------------------------ FreeCAD

    def start(self, *arguments: str) -> None:
        """Start FreeCAD and wait until it can be seen."""
        self.program = self.desk.start(["freecad", *arguments], self.log)
        self.eyes = Eyes(self.desk.bus_address, "FreeCAD")
        self.until(self.eyes.is_there, 25, "FreeCAD on the accessibility bus")
        self.eyes.find("frame", "FreeCAD.*", 60)
        self.watch = Watch(self.desk.bus_address, self.eyes.root.name_on_bus, self.program.pid)
        self.watch.start()

    def until(self, seen, seconds: float, what: str):
        """Wait until ``seen()`` gives something, and return it. Raises Unseen, or where FreeCAD has ended."""
        end = time.monotonic() + seconds
        while not (found := seen()):
            self.alive()
            if time.monotonic() > end:
                raise Unseen(f"{what}: not within {seconds:g} s")
            time.sleep(0.1)
        return found

    def has_left(self) -> bool:
        """Whether FreeCAD has ended."""
        return self.program is not None and self.program.poll() is not None

    def alive(self) -> None:
        """Raises Unseen where FreeCAD has ended with a code that is not 0, or was killed by a signal."""
        if self.program is not None and self.program.poll():
            raise Unseen(f"FreeCAD has ended by itself (code {self.program.returncode})")

    # ------------------------------------------------------------------------------------------ steps

    def do(self, name: str, step, limit: float | None = None) -> bool:
        """Do a step, look at everything, make a picture; whether it went well. ``limit``: s that the window
        may be silent."""
        row = Row(name)
        self.hands.clicks = self.hands.keys = 0
        begun = time.monotonic()
        try:
            self._try(step, row, begun, limit)
        except Exception as error:
            row.failed = "; FreeCAD says: ".join(
                [str(error) or type(error).__name__, *wrong(self.new_in_log())[-1:]]
            )
        self.rows.append(row)
        stem = os.path.join(
            self.folder, f"{len(self.rows):02d}-{re.sub('[^a-z0-9]+', '-', name.lower()).strip('-')}"
        )
        picture(stem + ".png")
        if row.failed:
            self.write_tree(stem + ".txt")
        print(
            f"sitting: {name:<24} {row.clicks:>3} clicks {row.seconds:6.1f} s, silent {row.silence:5.2f} s",
            flush=True,
        )
        if row.failed:
            print(f"sitting: FAILED: {row.failed}", flush=True)
        return not row.failed

    def _try(self, step, row: Row, begun: float, limit: float | None) -> None:
        try:
            step(self)
        finally:
            row.seconds, row.clicks, row.keys = time.monotonic() - begun, self.hands.clicks, self.hands.keys
            row.silence = self.watch.longest(begun) if self.watch else 0.0
        self.look()
        if limit is not None and row.silence > limit:
            raise Unseen(f"the window was silent for {row.silence:.2f} s, allowed are {limit:g} s")
        if self.watch and not self.has_left():
            self.collect()
            self.look()

    def look(self) -> None:
        """Raises Unseen where anything has gone wrong that a user could see: a red line, or an error in what
        FreeCAD says."""
        message = self.new_in_log()
        self.alive()
        bad = wrong(message)
        if bad:
            raise Unseen("FreeCAD says: " + bad[-1].strip()[:200])
        red = self.red_lines() if self.eyes and self.program.poll() is None else []
        if red:
            raise Unseen("a red line: " + red[0])

    def new_in_log(self) -> str:
        """What FreeCAD has said since the last look, on its terminal and in the report view."""
        with open(self.log, "rb") as file:
            file.seek(self.read)
            message = file.read()
            self.read += len(message)
        return message.decode(errors="replace")

    def red_lines(self) -> list[str]:
        """The texts of the red lines that are showing."""
        return [thing.name for thing in self.eyes.all("label") if thing.description == RED and thing.name]

    def write_tree(self, path: str) -> None:
        """All that is showing, to find out why something was not found."""
        with open(path, "w", encoding="utf-8") as file:
            try:
                for thing, role in self.eyes.things():
                    file.write(f"{role!r} {thing.name!r} {thing.description[:60]!r} {thing.box}\n")
            except Exception as error:
                file.write(f"{error}\n")

    # --------------------------------------------------------------------------------------- what a user does

    def press_tool(self, name: str) -> None:
        """Click a button of a tool bar."""
        roles = ("push button", "button menu")
        found = lambda: next((one for role in roles if (one := self.eyes.see(role, name))), None)  # noqa: E731
        self.hands.click(self.until(found, 20, f"a button {name}"))

    def press(self, name: str, seconds: float = 20) -> None:
        """Click a push button of a panel or a dialog."""
        self.hands.click(self.eyes.find("push button", name, seconds))

    def in_tree(self, label: str, seconds: float = 10) -> Thing:
        """The row of the model tree."""
        return self.until(lambda: self.row(label), seconds, f"{label} in the tree")

    def not_in_tree(self, label: str) -> None:
        """Wait until the tree is shown without that row."""
        self.until(lambda: self._model() and not self.row(label), 20, f"{label} gone from the tree")

    def _model(self) -> list[Thing]:
        """The model tree, and what else FreeCAD draws as a tree but the lists of properties."""
        return [
            tree for tree in self.eyes.all("tree") if not self.eyes.see("column header", "Property", tree)
        ]

    def row(self, label: str) -> Thing | None:
        """The row of that label in the model tree, if it is seen."""
        return next(
            (row for tree in self._model() if (row := self.eyes.see("table cell", label, tree))), None
        )

    def collect(self) -> None:
        """Have Python's garbage collected, by typing into FreeCAD's own console; it counts as no work of the
        user's."""
        self.answer("__import__('gc').collect()")

    def objects(self) -> str:
        """The names of the document's objects, by FreeCAD's console; it counts as no work of the user's."""
        return self.answer("' '.join(one.Name for one in App.ActiveDocument.Objects)")

    def answer(self, expression: str) -> str:
        """What FreeCAD's console says of a Python expression. Raises Unseen."""
        self.hands.counting = False
        try:
            for _ in range(3):  # a window that is just being closed swallows keys
                message = self._type(expression)
                if message is not None:
                    return message
            raise Unseen(f"the console does not answer {expression}")
        finally:
            self.hands.counting = True

    def _type(self, expression: str) -> str | None:
        console = self.console()
        before = len(ANSWERED.findall(console.text))
        self.hands.click(console, (0.5, 0.9))
        self.hands.press("ctrl+End")
        self.hands.write(f"print('to' + 'ld:', {expression})")
        self.hands.press("Return")
        try:
            self.until(lambda: len(ANSWERED.findall(console.text)) > before, 8, "an answer of the console")
        except Unseen:
            self.alive()
            return None
        return ANSWERED.findall(console.text)[-1]

    def console(self) -> Thing:
        """The text of the Python console."""
        dock = next(
            (one for role in ("frame", "panel") if (one := self.eyes.see(role, "Python [Cc]onsole"))), None
        )
        if dock is None:
            raise Unseen("no Python console is shown")
        return self.eyes.find("text", below=dock)


def wrong(message: str) -> list[str]:
    """The lines that tell of an error which is not FreeCAD's own, nor the machine's."""
    return [line for line in message.splitlines() if BAD.search(line) and not NOT_OURS.search(line)]


def table(rows: list[Row], version: str) -> str:
    """The rows as Markdown."""
    head = f"| FreeCAD {version} | clicks | keys | seconds | longest silence, s |\n|---|---|---|---|---|\n"
    lines = [
        f"| {row.step} | {row.clicks} | {row.keys} | {row.seconds:.1f} | {row.silence:.2f} |\n"
        for row in rows
    ]
    clicks, seconds = sum(row.clicks for row in rows), sum(row.seconds for row in rows)
    keys, silence = sum(row.keys for row in rows), max(row.silence for row in rows)
    return head + "".join(lines) + f"| **all** | {clicks} | {keys} | {seconds:.1f} | {silence:.2f} |\n"


def make_part(path: str) -> str:
    """Draw the part that the sitting is about; the version of FreeCAD."""
    version = os.path.join(os.path.dirname(path), "version")
    run_quietly(
        ["freecadcmd", os.path.join(HERE, "part.py")],
        QT_QPA_PLATFORM="offscreen",
        FIVEAXIS_PART=path,
        FIVEAXIS_VERSION=version,
    )
    with open(version, encoding="ascii") as file:
        return file.read()
