# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machines to choose from: those that come with the program, the user's own files, and those of FreeCAD's
Machine editor.

source    where a machine's file lies: SHIPPED (with the program), USER (the folder of the preferences),
          FREECAD (what the Machine editor of FreeCAD 26.3 and later has saved, and the templates that come
          with it).
"""

from __future__ import annotations

import importlib
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import plain_name
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine

from . import preferences, wording

SHIPPED, USER, FREECAD = "shipped", "user", "freecad"
SUFFIX = ".fcm"


@dataclass(frozen=True)
class Choice:
    """A machine of the chooser. ``machine``: what the setting ``machine`` takes, a shipped name or a path.

    ``error`` is empty, or says why the file is of no use here and what helps: shown, not hidden.
    """

    label: str
    machine: str
    source: str
    error: str = ""


def choices() -> list[Choice]:
    """Every machine there is: shipped, then the user's, then FreeCAD's; each file once, in the order of the
    names."""
    found, seen = [_choice(name, SHIPPED) for name in list_shipped_machines()], set()
    for source, folder in ((USER, user_folder()), *((FREECAD, folder) for folder in freecad_folders())):
        for path in _files(folder):
            if path.resolve() not in seen:
                seen.add(path.resolve())
                found.append(_choice(str(path), source))
    return found


def user_folder() -> Path:
    """Return the folder of the user's own machines: that of the preferences, else ``FiveAxis/machines`` in
    FreeCAD's user data."""
    import FreeCAD

    return preferences.machine_folder() or Path(FreeCAD.getUserAppDataDir()) / "FiveAxis" / "machines"


def free_file(name: str) -> str:
    """Return a file in the user's folder that is not there yet, named after a machine."""
    plain = plain_name(name, "machine")
    names = (plain if count == 1 else f"{plain}-{count}" for count in range(1, 1000))
    found = (user_folder() / (stem + SUFFIX) for stem in names)
    return str(next(path for path in found if not os.path.lexists(path)))


def is_new_folder(file: str | os.PathLike[str] | None) -> bool:
    """Whether the file belongs to the user's folder of machines, and that is not there yet."""
    return file is not None and Path(file).parent == user_folder() and not user_folder().exists()


def make_folder(file: str | os.PathLike[str]) -> None:
    """Make the user's folder of machines where the file belongs to it. Raises FileError."""
    if is_new_folder(file):
        try:
            user_folder().mkdir(parents=True)
        except OSError as error:
            raise FileError(
                say(
                    "folder {folder} cannot be made: {strerror}; choose another one",
                    folder=user_folder(),
                    strerror=error.strerror,
                ),
                file,
            ) from error


def freecad_folders() -> list[Path]:
    """Return the folders of FreeCAD's Machine editor: what the user saved in it, and its templates; none
    before FreeCAD 26.3."""
    import FreeCAD

    editor = Path(FreeCAD.getHomePath()) / "Mod" / "CAM" / "Machine"
    if not editor.is_dir():
        return []
    return [_asset_folder() / "Machines", editor / "machines"]


def _asset_folder() -> Path:
    """Return the folder that CAM keeps its tools and machines in; the user may have moved it."""
    return Path(importlib.import_module("Path.Preferences").getAssetPath())


def _files(folder: Path) -> Iterator[Path]:
    try:
        yield from sorted(
            path for path in folder.iterdir() if path.suffix.lower() == SUFFIX and path.is_file()
        )
    except OSError:  # a folder that is not there (yet) or cannot be looked into has no machines to offer
        return


def _choice(machine: str, source: str) -> Choice:
    try:
        return Choice(load_machine(machine).name, machine, source)
    except FiveAxisError as error:
        return Choice(Path(machine).stem, machine, source, wording.localize(error))
