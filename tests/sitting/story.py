# SPDX-License-Identifier: LGPL-2.1-or-later
"""The story of a sitting, step by step: read it from STEPS downwards."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time

from desk import Desk, run_quietly
from eyes import ENABLED, is_seen
from sitting import HERE, PROJECT, Sitting, Unseen, make_part, table

LIMIT = 5.0
"""s that the window may stay without an answer in a step of ours before it counts as hung: ten times what a
busy machine needs. How long it was stands in the table; 0.3 s is the aim."""
ANSWERS = 20
"""Answers of the window, one each 50 ms where it is awake, before Esc is pressed."""


def install(user: Sitting) -> None:
    """As the README says: make install."""
    read_message = run_quietly([os.path.join(PROJECT, "scripts", "install")])
    if "->" not in read_message:
        raise Unseen(f"install made no link: {read_message}")


def start(user: Sitting) -> None:
    """Start FreeCAD."""
    shutil.copyfile(os.path.join(HERE, "user.cfg"), user_config(user))
    user.start()


def user_config(user: Sitting) -> str:
    """Where this FreeCAD keeps the user's settings."""
    versioned = [name for name in os.listdir(user.home + "/.local/share/FreeCAD") if name.startswith("v")]
    folder = os.path.join(user.home, ".config", "FreeCAD", *versioned[:1])
    os.makedirs(folder, exist_ok=True)
    return os.path.join(folder, "user.cfg")


def workbench(user: Sitting) -> None:
    """Choose the workbench in its list."""
    user.hands.click(user.eyes.find("combo box", "Part"))
    time.sleep(1)
    user.hands.write("Five")
    user.hands.press("Return")
    user.eyes.find("push button", "Tool path.*")


def open_part(user: Sitting) -> None:
    """File, Open."""
    user.hands.press("ctrl+o")
    user.eyes.find("dialog", "Open.*")
    time.sleep(0.5)
    user.hands.write(user.part)
    user.hands.press("Return")
    user.in_tree("Rounded")
    user.in_tree("Body")
    user.hands.click_at(900, 600)
    user.hands.press("0")


def select(user: Sitting) -> None:
    """Click the part in the tree; where it is not drawn, Space draws it."""
    user.hands.click(user.in_tree("Rounded"))
    user.until(
        lambda: user.eyes.find("push button", "Tool path.*").has(ENABLED), 5, "Tool path can be pressed"
    )
    time.sleep(0.3)
    user.hands.press("space")
    user.press_tool("Fit [Aa]ll")


def tool_path(user: Sitting) -> None:
    """Open the panel."""
    user.press_tool("Tool path.*")
    user.eyes.find("push button", "Calculate")


def turn_wheel(user: Sitting) -> None:
    """Turn the wheel over the panel's boxes: the panel scrolls, and no value changes."""
    boxes = [*user.eyes.all("combo box"), *user.eyes.all("spin box")]
    inside = [(box, read_message(box)) for box in boxes if panel_holds(user, box)]
    if not inside:
        raise Unseen("no box in the panel")
    for box, _ in inside:
        left, top, width, height = box.box
        user.hands.point(left + width / 4, top + height / 2)
        user.hands.wheel(2)
        user.hands.wheel(-2)
    time.sleep(0.3)
    changed = [f"{was} to {read_message(box)}" for box, was in inside if read_message(box) != was]
    if changed:
        raise Unseen(f"the wheel has changed {changed}")


def read_message(box) -> str:
    """What stands in a combo box or spin box."""
    return box.name + "|" + (box.text if box.role == "spin box" else "")


def panel_holds(user: Sitting, box) -> bool:
    """Whether a box stands below the panel's Calculate, near enough to be seen."""
    left, top, *_ = user.eyes.find("push button", "Calculate").box
    x, y, *_ = box.box
    return abs(x - left) < 300 and top < y < top + 500


def stop(user: Sitting) -> None:
    """Calculate what takes long, with a very thin cutter, and press Esc: the document is as it was."""
    before = user.objects()
    was = fill(user, "Diameter", "0.06 mm")
    user.press("Calculate")
    escape(user, "Tool path")
    if (after := user.objects()) != before:
        raise Unseen(f"Esc has left {after}, there was {before}")
    fill(user, "Diameter", was)


def fill(user: Sitting, label: str, text: str) -> str:
    """Type a text into a box of the panel; what stood there."""
    box = user.eyes.find("spin box", label)
    was = box.text
    user.hands.click(box, at=(0.2, 0.4))
    user.hands.press("ctrl+a")
    user.hands.write(text)
    user.hands.press("Tab")
    return was


def escape(user: Sitting, title: str) -> None:
    """Esc, after the window has answered so many times while the work went on: the work, which is longer, is
    stopped."""
    work = user.until(lambda: user.eyes.window(title), 20, "the window of the work")
    answered = user.watch.answers()
    user.until(
        lambda: user.watch.answers() >= answered + ANSWERS, 60, "the window to answer while the work goes on"
    )
    if not is_seen(work):
        raise Unseen("the work was over before Esc was pressed")
    user.hands.press("Escape")
    user.until(lambda: not is_seen(work), 30, "Esc to stop the work")


def calculate(user: Sitting) -> None:
    """Calculate; the tree has a path then."""
    user.press("Calculate")
    user.eyes.find("label", ".*Blocks.*", 60)


def ok(user: Sitting) -> None:
    """OK keeps the path and closes the panel."""
    keep(user)
    user.in_tree("Toolpath")


def keep(user: Sitting) -> None:
    """OK; where it is asked whether to keep a path that is not safe: yes."""
    user.press("OK")
    agree(user, "Keep anyway", "Calculate")


def agree(user: Sitting, anyway: str, panel: str) -> None:
    """Wait until the panel with that button is closed; what is asked before is answered by the button
    ``anyway``."""
    wanted = user.until(
        lambda: user.eyes.see("push button", anyway) or not user.eyes.see("push button", panel),
        60,
        "the panel to close or to ask",
    )
    if wanted is not True:
        user.hands.click(wanted)
        user.eyes.gone("push button", panel, 60)


def play(user: Sitting) -> None:
    """Play the path, stop it, go one block on, close."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Play.*")
    time_played = user.eyes.find(
        "label", r"[\d:.]+ of [\d:.]+"
    )  # as 0:00.00 of 4:58.81; looked up now, for while it plays
    button, on = (
        user.eyes.find("check box", "Play and pause"),
        user.eyes.find("push button", "One block on"),
    )  # answers are slow
    begun = time_played.name
    user.hands.click(button)
    user.until(lambda: time_played.name != begun, 10, "the tool moves")
    user.hands.click(button)
    time.sleep(0.5)
    stopped = time_played.name
    user.hands.click(on)
    user.until(lambda: time_played.name != stopped, 10, "one block on")
    user.press("Close")
    user.eyes.gone("slider", "")


def post_process(user: Sitting) -> None:
    """Write the NC file where the panel proposes."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Post-process.*")
    user.nc_file = user.eyes.find("text", "The NC file to write").text
    user.press("OK")
    wanted = user.until(
        lambda: user.eyes.see("push button", "Write anyway") or os.path.isfile(user.nc_file),
        60,
        f"{user.nc_file}, or a question",
    )
    if wanted is not True:
        user.hands.click(wanted)
        user.until(lambda: os.path.isfile(user.nc_file), 60, user.nc_file)
    reported = user.eyes.find("dialog", "NC file written")
    for name in ("Open", "Show folder"):
        user.eyes.find("push button", name, below=reported)
    user.hands.click(user.eyes.find("push button", "Close", below=reported))
    user.eyes.gone("push button", "OK")


def audit(user: Sitting) -> None:
    """Audit the file that was written."""
    user.press_tool("Audit an NC file.*")
    user.eyes.find("push button", "Calculate")
    user.hands.click(user.eyes.find("text", "NC file"))
    user.hands.press("ctrl+a")
    user.hands.write(user.nc_file)
    user.hands.press("Tab")
    user.press("Calculate")
    user.eyes.find("label", ".*Blocks.*", 60)
    keep(user)
    user.in_tree("Audit")


def undo(user: Sitting) -> None:
    """Undo takes the audit back, redo brings it again."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Undo")
    user.not_in_tree("Audit")
    user.press_tool("Redo")
    user.in_tree("Audit")


def recompute(user: Sitting) -> None:
    """Mark the path to be computed anew, and Refresh."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Refresh|Recompute")
    user.in_tree("Toolpath")


def save(user: Sitting) -> None:
    """Save."""
    before = os.path.getmtime(user.part)
    user.hands.press("ctrl+s")
    user.until(lambda: os.path.getmtime(user.part) > before, 30, "the file saved")


def close(user: Sitting) -> None:
    """Close the document; after saving nothing is asked."""
    user.hands.press("ctrl+w")
    user.not_in_tree("Toolpath")


def reopen(user: Sitting) -> None:
    """Open it again: path and audit are there, and the panel comes with the path's result."""
    open_part(user)
    user.in_tree("Audit")
    user.hands.click(user.in_tree("Toolpath"), double=True)
    user.eyes.find("push button", "Calculate")
    user.eyes.find("label", ".*Blocks.*", 60)
    user.hands.click(user.eyes.find("push button", "Cancel"), at=(0.2, 0.5))  # its right half may be cut off
    user.eyes.gone("push button", "Calculate")


def leave(user: Sitting) -> None:
    """Quit; what was changed since is not kept."""
    user.hands.press("ctrl+q")
    left = user.until(
        lambda: user.has_left() or user.eyes.see("push button", DISCARD), 20, "FreeCAD to leave or to ask"
    )
    if left is not True:
        user.hands.click(left)
    user.until(user.has_left, 30, "FreeCAD to leave")


def body(user: Sitting) -> None:
    """A path over the Part Design body too."""
    user.hands.click(user.in_tree("Body"))
    tool_path(user)
    calculate(user)
    keep(user)
    user.in_tree("Toolpath001")


def step_file(user: Sitting) -> None:
    """Open a STEP file, a path over its solid, and close it again without saving."""
    user.hands.press("ctrl+o")
    user.eyes.find("dialog", "Open.*")
    time.sleep(0.5)
    user.hands.write(user.part.replace("FCStd", "step"))
    user.hands.press("Return")
    wanted = user.until(
        lambda: user.row("Imported") or user.eyes.see("dialog", "STEP.*"), 30, "the part, or how to import it"
    )
    if wanted.role == "dialog":  # from FreeCAD 1.0 on
        user.hands.press("Return")
    user.hands.click(user.in_tree("Imported", 30))
    tool_path(user)
    calculate(user)
    keep(user)
    user.hands.press("ctrl+w")
    user.hands.click(user.eyes.find("push button", DISCARD))
    user.not_in_tree("Imported")


def setup(user: Sitting) -> None:
    """Setup: what several paths share; it is kept."""
    user.press_tool("Setup.*")
    user.press("OK")
    user.in_tree("Setup")


def clamp(user: Sitting) -> None:
    """Where to clamp: a map of the path."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Where to clamp.*")
    user.press("Calculate")
    user.eyes.find("label", ".*recommended.*", 240)
    keep(user)


def compare(user: Sitting) -> None:
    """Compare machines, the least deviation (minimax) among the corrections, stop it by Esc, and close the
    panel by another."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Compare.*")
    user.press("Compare")
    escape(user, "Compare.*")
    user.hands.press("Escape")
    user.eyes.gone("push button", "Compare")


DISCARD = "(Discard|Close without|Don.t Save).*"
SHORT = [
    ("Install", install), ("Start", start), ("Workbench", workbench), ("Open a part", open_part), ("Select it", select),
    ("Tool path", tool_path), ("Turn the wheel", turn_wheel), ("Esc while it works", stop), ("Calculate", calculate), ("OK", ok), ("Play", play),
    ("Post-process", post_process), ("Audit", audit), ("Undo, redo", undo), ("Recompute", recompute), ("Save", save),
    ("Close", close), ("Reopen", reopen), ("Quit", leave),
]  # fmt: skip
MORE = [
    ("A body", body), ("A STEP file", step_file), ("Setup", setup), ("Where to clamp", clamp), ("Compare machines", compare),
]  # fmt: skip
LONG = [*SHORT[:-1], *MORE, SHORT[-1]]
FREECADS_OWN = ("Install", "Start", "Workbench", "Open a part", "Save", "Close", "Quit")
"""Steps in which FreeCAD works, and not we: their silence is told, and not judged."""


def main() -> int:
    read_message = argparse.ArgumentParser()
    read_message.add_argument("form", nargs="?", choices=("short", "long"), default="short")
    read_message.add_argument(
        "--limit", type=float, default=LIMIT, help="s that the window may be silent in a step of ours"
    )
    read_message.add_argument("--keep", action="store_true")
    wanted = read_message.parse_args()
    with Desk() as desk:
        part = os.path.join(os.environ["HOME"], "part.FCStd")
        version = make_part(part)
        folder = os.path.join(PROJECT, "out", "sitting", version)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        user = Sitting(desk, folder, part)
        good = all(
            user.do(name, step, None if name in FREECADS_OWN else wanted.limit)
            for name, step in (LONG if wanted.form == "long" else SHORT)
        )
        with open(os.path.join(folder, "table.md"), "w", encoding="utf-8") as file:
            file.write(table(user.rows, version))
    print(f"sitting: FreeCAD {version} {'passed' if good else 'FAILED'}, see {folder}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
