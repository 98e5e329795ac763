# SPDX-License-Identifier: LGPL-2.1-or-later
"""The story of a sitting, step by step: read it from STEPS downwards."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time

from desk import Desk, run_quietly
from eyes import ENABLED
from sitting import HERE, PROJECT, Sitting, Unseen, make_part

LIMIT = 1.0
"""s that the window may stay without an answer in a step of ours."""


def install(user: Sitting) -> None:
    """As the README says: make install."""
    said = run_quietly([os.path.join(PROJECT, "scripts", "install")])
    if "->" not in said:
        raise Unseen(f"install made no link: {said}")


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


def select(user: Sitting) -> None:
    """Click the part in the tree; where it is not drawn, Space draws it."""
    user.hands.click(user.in_tree("Rounded"))
    user.until(lambda: user.eyes.find("push button", "Tool path.*").has(ENABLED), 5, "Tool path can be pressed")


def tool_path(user: Sitting) -> None:
    """Open the panel."""
    user.press_tool("Tool path.*")
    user.eyes.find("push button", "Calculate")


def calculate(user: Sitting) -> None:
    """Calculate; the tree has a path then."""
    user.press("Calculate")
    user.eyes.find("label", ".*Blocks.*", 60)


def ok(user: Sitting) -> None:
    """OK keeps the path and closes the panel."""
    user.press("OK")
    user.eyes.gone("push button", "Calculate", 60)
    user.in_tree("Toolpath")


def play(user: Sitting) -> None:
    """Play the path, stop it, go one block on, close."""
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("Play.*")
    user.eyes.find("slider")
    raise Unseen("look")


STEPS = [
    ("Install", install),
    ("Start", start),
    ("Workbench", workbench),
    ("Open a part", open_part),
    ("Select it", select),
    ("Tool path", tool_path),
    ("Calculate", calculate),
    ("OK", ok),
    ("Play", play),
]


def main() -> int:
    asked = argparse.ArgumentParser()
    asked.add_argument("form", nargs="?", choices=("short", "long"), default="short")
    asked.add_argument("--limit", type=float, default=LIMIT)
    asked.add_argument("--keep", action="store_true")
    asked = asked.parse_args()
    with Desk() as desk:
        part = os.path.join(os.environ["HOME"], "part.FCStd")
        version = make_part(part)
        folder = os.path.join(PROJECT, "out", "sitting", version)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        user = Sitting(desk, folder)
        user.part = part
        for name, step in STEPS:
            if not user.do(name, step):
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
