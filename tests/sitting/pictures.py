# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of the documentation, made by a sitting: read it from STEPS downwards. They go to out/pictures
as the screen is.

still     a picture by its name in docs/images; the mouse is out of the way.
film      numbered pictures in out/pictures/film, with the mouse's place in film.json; scripts/pictures puts
          both into docs/images.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
import tempfile
import time

import story
from desk import Desk, run_quietly
from eyes import picture
from sitting import HERE, PROJECT, Sitting, Unseen, make_part

SIZE = (1600, 900)
FOLDER = os.path.join(PROJECT, "out", "pictures")
PARTS = os.path.join(tempfile.gettempdir(), "first-part")
"""Its name is seen in the pictures."""
SPINDLE = "8000"
ON_TABLE = (0.58 * SIZE[0], 0.53 * SIZE[1])
"""Where the part is in Play."""
STOPS = 36
"""Pictures of the film while the tool moves."""


class Camera:
    """Takes pictures of one sitting."""

    def __init__(self, user: Sitting) -> None:
        self.user, self.film = user, []

    def still(self, name: str) -> None:
        """A picture for docs/images."""
        self.user.hands.point(SIZE[0] - 3, SIZE[1] - 3)
        time.sleep(0.7)
        picture(os.path.join(FOLDER, name + ".png"))

    def frame(self, seconds: float, thing=None, at: tuple[float, float] = (0.5, 0.5), tell: str = "") -> None:
        """A picture of the film, shown so long, the mouse on a thing that is clicked next; ``tell``: a line
        below."""
        place = None
        if thing is not None:
            left, top, width, height = thing.box
            place = (left + at[0] * width, top + at[1] * height)
        name = f"{len(self.film):03d}.png"
        picture(os.path.join(FOLDER, "film", name))
        self.film.append({"picture": name, "seconds": seconds, "mouse": place, "tell": tell})

    def click(self, thing, tell: str) -> None:
        """Show what is clicked, and click it."""
        self.frame(1.3, thing, tell=tell)
        self.user.hands.click(thing)
        time.sleep(0.3)


def button(user: Sitting, name: str):
    """A button of a tool bar or a panel."""
    roles = ("push button", "button menu")
    return user.until(
        lambda: next((one for role in roles if (one := user.eyes.see(role, name))), None),
        20,
        f"a button {name}",
    )


def start(user: Sitting, _: Camera) -> None:
    """FreeCAD over the whole screen, without the console."""
    story.install(user)
    with open(os.path.join(HERE, "user.cfg"), encoding="utf-8") as file:
        settings = file.read()
    for view in ("Std_ReportView", "Std_PythonView"):
        settings = settings.replace(f'"{view}" Value="1"', f'"{view}" Value="0"')
    settings = settings.replace(f'{GROUP}"Document">', f'{QUIET}{GROUP}"Document">')
    with open(story.user_config(user), "w", encoding="utf-8") as file:
        file.write(settings)
    user.start()
    run_quietly(
        [
            "xdotool",
            "search",
            "--sync",
            "--onlyvisible",
            "--name",
            "FreeCAD",
            "windowsize",
            *map(str, SIZE),
            "windowmove",
            "0",
            "0",
        ]
    )
    left, top, width, _ = user.eyes.find("frame", "FreeCAD.*").box
    user.hands.click_at(left + width / 2, max(top - 10, 5), double=True)
    time.sleep(1.5)
    story.workbench(user)


GROUP = "<FCParamGroup Name="
QUIET = "".join(
    f'<FCBool Name="{name}" Value="0"/>'
    for name in ("NotificationAreaEnabled", "NonIntrusiveNotificationsEnabled")
)
QUIET = f'{GROUP}"NotificationArea">{QUIET}</FCParamGroup>'
"""Settings: FreeCAD's messages do not come up over the view."""
BACKGROUND = (0.32 * SIZE[0], 0.88 * SIZE[1])
"""A place of the 3D view where nothing is drawn."""


def open_file(user: Sitting, path: str, label: str) -> None:
    """File, Open; the part from the front, right and above."""
    user.hands.press("ctrl+o")
    user.eyes.find("dialog", "Open.*")
    time.sleep(0.5)
    user.hands.write(path)
    user.hands.press("Return")
    user.in_tree(label)
    user.hands.click_at(*BACKGROUND)
    user.hands.press("0")
    time.sleep(1)


def select(user: Sitting, camera: Camera) -> None:
    open_file(user, user.part, "Rounded")
    story.select(user)
    away(user, 3)
    camera.still("first-1-select")


def away(user: Sitting, notches: int) -> None:
    """Turn the wheel over the view: the part has room between the legend and the panel."""
    user.hands.point(0.43 * SIZE[0], 0.55 * SIZE[1])  # this place stays where it is
    user.hands.wheel(notches)
    time.sleep(0.7)


def bring(user: Sitting, label: str) -> None:
    """Turn the wheel over the panel until a box of it is seen with some room below."""
    for _ in range(30):
        top = user.eyes.find("spin box", label).box[1]
        if top < SIZE[1] - 170:
            return
        user.hands.point(SIZE[0] - 250, SIZE[1] - 110)
        user.hands.wheel(1)
        time.sleep(0.3)
    raise Unseen(f"{label} does not come into sight")


def nothing_selected(user: Sitting) -> None:
    user.hands.click_at(*BACKGROUND)
    time.sleep(0.5)


def tool_path(user: Sitting, camera: Camera) -> None:
    camera.click(button(user, "Tool path.*"), "1  The box is selected: Tool path")
    user.eyes.find("push button", "Calculate")
    camera.still("first-2-panel")
    bring(user, "Spindle speed")
    story.fill(user, "Tool number", "1")
    story.fill(user, "Spindle speed", SPINDLE)
    camera.still("first-3-tool")
    camera.frame(1.5, tell="Cutter and spindle speed")


def calculate(user: Sitting, camera: Camera) -> None:
    camera.click(button(user, "Calculate"), "2  Calculate: passes, tool axes, proof")
    user.eyes.find("label", ".*Blocks.*", 60)
    nothing_selected(user)
    time.sleep(1)
    camera.still("workbench")
    camera.frame(2.5, tell="The light says whether it is safe")
    user.hands.click(
        user.eyes.find("check box", "Markers"), (0.1, 0.5)
    )  # they would cover the small part in Play
    time.sleep(0.5)
    camera.click(button(user, "OK"), "3  OK")
    user.in_tree("Toolpath")


def post_process(user: Sitting, camera: Camera) -> None:
    user.hands.click(user.in_tree("Toolpath"))
    time.sleep(0.5)
    camera.click(button(user, "Post-process.*"), "4  Post-process")
    user.nc_file = user.eyes.find("text", "The NC file to write").text
    camera.click(button(user, "OK"), "5  OK writes the NC file")
    reported = user.eyes.find("dialog", "NC file written", 60)
    time.sleep(0.5)
    camera.still("first-6-written")
    camera.frame(2.5, tell="The NC file is written")
    user.hands.click(user.eyes.find("push button", "Close", below=reported))
    user.eyes.gone("push button", "OK")


def play(user: Sitting, camera: Camera) -> None:
    nothing_selected(user)
    user.hands.click(user.in_tree("Toolpath"))
    time.sleep(0.3)
    camera.click(button(user, "Play.*"), "Play")
    user.eyes.find("label", r"[\d:.]+ of [\d:.]+")
    user.hands.click(user.eyes.find("check box", "On the machine"), (0.1, 0.5))
    time.sleep(1)
    user.press_tool("Fit [Aa]ll")
    user.hands.point(*ON_TABLE)
    user.hands.wheel(-4)
    time.sleep(0.5)
    speed = user.eyes.find("combo box", "× 1|.*Speed.*")
    user.hands.click(speed)
    time.sleep(0.4)
    user.hands.press("Down", "Down", "Down", "Return")
    time.sleep(0.5)
    begin = user.eyes.find("check box", "Play and pause")
    user.hands.click(begin)
    for at in range(STOPS):
        camera.frame(0.15, tell="Play: the table turns as the program turns it")
        if at == STOPS // 3:
            user.hands.click(begin)
            camera.still("play")
            user.hands.click(begin)
    user.hands.click(begin)
    user.press("Close")
    user.eyes.gone("slider", "")


def audit(user: Sitting, camera: Camera) -> None:
    hide(user, "Toolpath")  # the program is drawn as it was read
    nothing_selected(user)
    user.press_tool("Audit an NC file.*")
    user.eyes.find("push button", "Calculate")
    user.press("Calculate")
    user.eyes.find("label", ".*Blocks.*", 60)
    time.sleep(0.5)
    nothing_selected(user)
    camera.still("first-7-audit")
    story.keep(user)
    user.in_tree("Audit")


def hide(user: Sitting, label: str) -> None:
    """Hide what is shown, or show it; a click on what is selected already would begin to rename it."""
    nothing_selected(user)
    user.hands.click(user.in_tree(label))
    time.sleep(0.4)
    user.hands.press("space")
    time.sleep(0.4)


def leave_part(user: Sitting) -> None:
    """Close the document that is open, if there is one, without keeping what was changed."""
    if not user.row("Toolpath"):
        return
    user.hands.press("ctrl+w")
    user.hands.click(user.eyes.find("push button", story.DISCARD))


def rest_map(user: Sitting, camera: Camera) -> None:
    leave_part(user)
    open_file(user, os.path.join(PARTS, "groove.FCStd"), "Groove")
    path_over(user, "Groove")
    nothing_selected(user)
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("What is left.*")
    time.sleep(8)
    nothing_selected(user)
    camera.still("left-map")


def setup_map(user: Sitting, camera: Camera) -> None:
    leave_part(user)
    open_file(user, os.path.join(PARTS, "dome.FCStd"), "Dome")
    path_over(user, "Dome")
    hide(user, "Dome")
    hide(user, "Toolpath")
    user.press_tool("Where to clamp.*")
    for box in [one for one in user.eyes.all("spin box") if one.text.startswith("100")][:3]:
        user.hands.click(box, at=(0.2, 0.4))
        user.hands.press("ctrl+a")
        user.hands.write("40 mm")
        user.hands.press("Tab")
    user.press("Calculate")
    user.eyes.find("label", ".*recommended.*", 240)
    nothing_selected(user)
    user.press_tool("Fit [Aa]ll")
    away(user, 1)
    camera.still("setup-map")
    story.keep(user)


def path_over(user: Sitting, label: str) -> None:
    user.hands.click(user.in_tree(label))
    user.press_tool("Fit [Aa]ll")
    away(user, 2)
    story.tool_path(user)
    bring(user, "Spindle speed")
    story.fill(user, "Spindle speed", SPINDLE)
    story.calculate(user)
    story.keep(user)
    user.in_tree("Toolpath")


def whole_part(user: Sitting, camera: Camera) -> None:
    """Where a tool gets, the passes before they are computed, the path, and what it leaves:
    docs/whole-part.md."""
    leave_part(user)
    open_file(user, os.path.join(PARTS, "knob.FCStd"), "Knob")
    user.hands.click(user.in_tree("Knob"))
    user.press_tool("Fit [Aa]ll")
    away(user, 2)
    user.press_tool("Reach map.*")
    set_tool(user)
    user.press("Calculate")
    user.eyes.find("label", ".*cutter too large.*", 240)
    nothing_selected(user)
    camera.still("whole-1-reach")
    user.press("OK")
    hide(user, "Reach map")
    hide(user, "Knob")
    story.tool_path(user)
    set_tool(user)
    bring(user, "Spindle speed")
    story.fill(user, "Spindle speed", SPINDLE)
    user.press("Preview passes")
    user.eyes.find("label", r".*links not counted.*", 60)
    nothing_selected(user)
    camera.still("whole-2-preview")
    story.calculate(user)
    nothing_selected(user)
    camera.still("whole-3-path")
    story.keep(user)
    user.in_tree("Toolpath")
    nothing_selected(user)
    user.hands.click(user.in_tree("Toolpath"))
    user.press_tool("What is left.*")
    time.sleep(8)
    nothing_selected(user)
    camera.still("whole-4-left")


def set_tool(user: Sitting) -> None:
    """A ball of 6 mm on a shank, in a holder, as the fields of a panel ask for them."""
    for field, text in TOOL:
        story.fill(user, field, text)


TOOL = (("Diameter", "6 mm"),)
"""Labels of boxes, and what is typed there."""

STEPS = [start, select, tool_path, calculate, post_process, play, audit, rest_map, setup_map, whole_part]


def wanted(names: list[str]) -> list:
    """The steps so named, after the start; all of them where none is named."""
    return [one for one in STEPS if not names or one is start or one.__name__ in names]


def main() -> int:
    with Desk(SIZE) as desk:
        os.makedirs(PARTS)
        part = os.path.join(PARTS, "part.FCStd")
        version = make_part(part)
        run_quietly(
            ["freecadcmd", os.path.join(HERE, "picture_parts.py")],
            QT_QPA_PLATFORM="offscreen",
            FIVEAXIS_PART=part,
        )
        shutil.rmtree(FOLDER, ignore_errors=True)
        os.makedirs(os.path.join(FOLDER, "film"))
        user = Sitting(desk, FOLDER, part)
        camera = Camera(user)
        try:
            for step in wanted(sys.argv[2:]):
                print(f"pictures: {step.__name__}", flush=True)
                step(user, camera)
                with open(os.path.join(FOLDER, "film.json"), "w", encoding="utf-8") as file:
                    json.dump(camera.film, file)
                user.alive()
        except Exception as error:
            picture(os.path.join(FOLDER, "failed.png"))
            user.write_tree(os.path.join(FOLDER, "failed.txt"))
            print(f"pictures: FAILED in {step.__name__}: {error}")
            return 1
        finally:
            shutil.rmtree(PARTS)
    print(f"pictures: FreeCAD {version}, see {FOLDER}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
