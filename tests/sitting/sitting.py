# SPDX-License-Identifier: LGPL-2.1-or-later
"""One sitting: FreeCAD, eyes and hands, and what is looked at after every step.

step      a function that does what a user does and waits for what he would see; it raises TimeoutError or Unseen where it is not.
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
BAD = re.compile(r"Traceback|\w*Error\b|\w*Exception\b|Segmentation fault|SIGSEGV|already deleted|[Uu]nhandled|resizeDocks")
NOT_OURS = (
    re.compile(r"Addon Manager|QtWebEngine|zygote|libEGL|MESA|dconf|dbus|GLib|Gtk-", re.I),
    re.compile(r"^\s*$"),
)
"""What FreeCAD or the machine says by itself, with no add-on too."""
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
    watched: bool = True
    failed: str = ""


class Sitting:
    """What the steps have in their hands. ``folder``: where pictures go; ``home``: the user's."""

    def __init__(self, desk: Desk, folder: str) -> None:
        self.desk, self.folder, self.home = desk, folder, os.environ["HOME"]
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
        self.watch = Watch(self.desk.bus_address, self.eyes.root.name_on_bus)
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

    def alive(self) -> None:
        """Raises Unseen where FreeCAD has gone by itself."""
        if self.program is not None and self.program.poll() is not None:
            raise Unseen(f"FreeCAD has ended by itself (code {self.program.returncode})")

    # ------------------------------------------------------------------------------------------ steps

    def do(self, name: str, step, watched: bool = True) -> bool:
        """Do a step, look at everything, make a picture; whether it went well. ``watched``: its silence counts."""
        row = Row(name, watched=watched)
        self.hands.clicks = self.hands.keys = 0
        begun = time.monotonic()
        try:
            step(self)
            row.seconds = time.monotonic() - begun
            self.look()
        except Exception as error:
            row.seconds = row.seconds or time.monotonic() - begun
            row.failed = str(error) or type(error).__name__
        row.clicks, row.keys = self.hands.clicks, self.hands.keys
        row.silence = self.watch.longest(begun) if self.watch else 0.0
        self.rows.append(row)
        stem = os.path.join(self.folder, f"{len(self.rows):02d}-{re.sub('[^a-z0-9]+', '-', name.lower()).strip('-')}")
        picture(stem + ".png")
        if row.failed:
            self.write_tree(stem + ".txt")
        elif self.watch and self.watch.running:
            self.collect()
        print(
            f"sitting: {name:<28} {row.clicks:>3} clicks {row.seconds:6.1f} s, silent {row.silence:5.2f} s"
            + (f"  FAILED: {row.failed}" if row.failed else ""),
            flush=True,
        )
        return not row.failed

    def look(self) -> None:
        """Raises Unseen where anything has gone wrong that a user could see: a red line, or an error in what FreeCAD says."""
        self.alive_or_left()
        said = self.new_in_log()
        bad = [line for line in said.splitlines() if BAD.search(line) and not any(one.search(line) for one in NOT_OURS)]
        if bad:
            raise Unseen("FreeCAD says: " + bad[-1].strip()[:200])
        red = self.red_lines() if self.eyes and self.program.poll() is None else []
        if red:
            raise Unseen("a red line: " + red[0])

    def alive_or_left(self) -> None:
        """FreeCAD is there, or was left by the user with code 0."""
        if self.program is not None and self.program.poll() not in (None, 0):
            raise Unseen(f"FreeCAD has ended by itself (code {self.program.returncode})")

    def new_in_log(self) -> str:
        """What FreeCAD has said since the last look, on its terminal and in the report view."""
        with open(self.log, "rb") as file:
            file.seek(self.read)
            said = file.read()
            self.read += len(said)
        return said.decode(errors="replace")

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

    # ------------------------------------------------------------------------------------------ what a user does

    def press_tool(self, name: str) -> None:
        """Click a button of a tool bar."""
        self.hands.click(self.eyes.find("push button", name))

    def press(self, name: str, seconds: float = 20) -> None:
        """Click a push button of a panel or a dialog."""
        self.hands.click(self.eyes.find("push button", name, seconds))

    def in_tree(self, label: str, seconds: float = 10) -> Thing:
        """The row of the model tree."""
        return self.eyes.find("table cell", label, seconds)

    def collect(self) -> None:
        """Have Python's garbage collected: typed into FreeCAD's own console. The focus goes back to where it was by no click."""
        self.hands.counting = False
        try:
            console = self.console()
            if console is None:
                return
            before = console.text.count("collected")
            self.hands.click(console, (0.5, 0.9))
            self.hands.press("ctrl+End")
            self.hands.write("import gc; print('collec' + 'ted', gc.collect())")
            self.hands.press("Return")
            self.until(lambda: self.console().text.count("collected") > before, 20, "the garbage to be collected")
        finally:
            self.hands.counting = True

    def console(self) -> Thing | None:
        """The text of the Python console, where it is showing and no dialog lies before it."""
        frame = self.eyes.see("frame", "Python console") or self.eyes.see("dock", "Python console")
        return self.eyes.see("text", below=frame) if frame else None


def make_part(path: str) -> str:
    """Draw the part that the sitting is about; the version of FreeCAD."""
    version = os.path.join(os.path.dirname(path), "version")
    run_quietly(
        ["freecadcmd", os.path.join(HERE, "part.py")], QT_QPA_PLATFORM="offscreen", FIVEAXIS_PART=path, FIVEAXIS_VERSION=version
    )
    with open(version, encoding="ascii") as file:
        return file.read()
