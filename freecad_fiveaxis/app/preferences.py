# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers: defaults, folders and colours, from FreeCAD's own parameters; with and without a
window.

key    the name of a parameter in the group GROUP; DEFAULTS lists every key with its default, in FreeCAD's own
       units.
unit   FreeCAD keeps a parameter's length in mm, an angle in degrees and a feed in mm/s; the getters below
       give mm/min.
count  FreeCAD keeps it as a whole number without a sign, as it does a colour.
colour red, green and blue, each from 0 to 1; FreeCAD keeps it as the number 0xRRGGBBAA, whose alpha is not
used.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

GROUP = "User parameter:BaseApp/Preferences/Mod/FiveAxis"

FOLDS = "Folds"
"""The group, within ours, of what is unfolded in the panels."""

Colour = tuple[float, float, float]

GREEN, ORANGE, PURPLE = 0x009E73FF, 0xD55E00FF, 0xCC79A7FF
"""Okabe and Ito's palette: told apart by colour-blind users too."""

LENGTH = 50.0
"""mm; the cutting edge of a new path's cutter."""

DEFAULTS: dict[str, str | float | int] = {
    "Machine": "trunnion_ac",
    "Controller": "",
    "MachineFolder": "",
    "OutputFolder": "",
    "CutterKind": "ball",
    "CutterDiameter": 10.0,
    "CutterCorner": 1.0,
    "CutterTaper": 5.0,
    "CutterNeck": 3.0,
    "CutterFlank": 85.0,
    "Shank": "",
    "Holder": "",
    "Scallop": 0.01,
    "Tolerance": 0.01,
    "Feed": 1000.0 / 60,
    "Processes": 0,
    "ColourGood": GREEN,
    "ColourBad": ORANGE,
    "ColourSingular": PURPLE,
}


def read(key: str) -> Any:
    """Return the parameter as FreeCAD keeps it: a text, a number (mm, mm/s) or 0xRRGGBBAA. KeyError for a key
    that is not ours."""
    default = DEFAULTS[key]
    if isinstance(default, str):
        return _group().GetString(key, default)
    return _group().GetUnsigned(key, default) if isinstance(default, int) else _group().GetFloat(key, default)


def _text(key: str) -> str:
    """Return a parameter that is a text, without blanks about it."""
    return str(read(key)).strip()


def write(key: str, value: str | float | int) -> None:
    """Keep a parameter, in the units of ``read``. KeyError for a key that is not ours."""
    default = DEFAULTS[key]
    if isinstance(default, str):
        _group().SetString(key, value)
    elif isinstance(default, int):
        _group().SetUnsigned(key, value)
    else:
        _group().SetFloat(key, value)


def reset() -> None:
    """Forget what the user preferred: every default counts again."""
    for key, default in DEFAULTS.items():
        if isinstance(default, str):
            _group().RemString(key)
        elif isinstance(default, int):
            _group().RemUnsigned(key)
        else:
            _group().RemFloat(key)


def is_open(key: str, default: bool) -> bool:
    """Whether a group of a panel is unfolded, as the user left it."""
    return bool(_group().GetGroup(FOLDS).GetBool(key, default))


def keep_open(key: str, opened: bool) -> None:
    """Keep that a group of a panel is folded, or not."""
    _group().GetGroup(FOLDS).SetBool(key, opened)


def machine() -> str:
    """Return a shipped machine's name, or the path of a ``.fcm`` file."""
    return _text("Machine") or str(DEFAULTS["Machine"])


def controller() -> str | None:
    """Return a controller's name; None: the machine's own."""
    return _text("Controller") or None


def machine_folder() -> Path | None:
    """Return the folder with the user's own ``.fcm`` files; None where none is set."""
    return _folder("MachineFolder")


def output_folder() -> Path | None:
    """Where NC files go at first; None: beside the document."""
    return _folder("OutputFolder")


def cutter() -> str:
    """Return a new path's cutter as an option; whether there can be such a one is the core's to say."""
    from freecad_fiveaxis.core.tool import KINDS, sizes_text  # numpy has no business when the window starts

    kind = _text("CutterKind")
    kind = kind if kind in KINDS else str(DEFAULTS["CutterKind"])
    sizes = {
        name: read("Cutter" + name.capitalize()) for name in ("diameter", "corner", "taper", "neck", "flank")
    }
    return sizes_text(kind, sizes | {"length": LENGTH})


def shank() -> str:
    """Return a new path's shank: cylinders, as ``8x20,12x30``, mm; empty where there is none."""
    return _text("Shank")


def holder() -> str:
    """Return a new path's holder, likewise."""
    return _text("Holder")


def scallop() -> float:
    """Largest scallop of a new path, mm."""
    return float(read("Scallop"))


def tolerance() -> float:
    """Largest deviation of the tip that passes for good, mm."""
    return float(read("Tolerance"))


def feed() -> float:
    """Feed of a new path's tip over the part, mm/min."""
    return round(
        60 * float(read("Feed")), 9
    )  # 1000 mm/min is no whole number of mm/s: what was typed comes back


def processes() -> int:
    """How many processes may work on one study; 0: as many as there are processors."""
    return int(read("Processes"))


def colour_good() -> Colour:
    """Colour of blocks without deviation."""
    return _colour("ColourGood")


def colour_bad() -> Colour:
    """Colour of blocks over the tolerance."""
    return _colour("ColourBad")


def colour_singular() -> Colour:
    """Colour of blocks near the pole."""
    return _colour("ColourSingular")


def _group() -> Any:
    import FreeCAD

    return FreeCAD.ParamGet(GROUP)


def _folder(key: str) -> Path | None:
    given = read(key).strip()
    return Path(given).expanduser() if given else None


def _colour(key: str) -> Colour:
    packed = read(key)
    return (packed >> 24 & 255) / 255, (packed >> 16 & 255) / 255, (packed >> 8 & 255) / 255
