# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines of other programs become machine files of the user's. No document is needed, none is changed."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.files import check_readable, check_writable
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.importing import Imported, find_model, import_machine, save_imported

from . import machines


def read(source: Any, bodies: Any = None) -> Imported:
    """Return the machine of a LinuxCNC .ini, a URDF file or a FreeCAD .fcm, with what that file leaves open;
    ``bodies``: the vismach model of a LinuxCNC .ini, None or empty for none. Raises FiveAxisError."""
    for one in filter(None, (source, bodies)):
        check_readable(one)
    return import_machine(os.fspath(source), os.fspath(bodies or ""))


def find_bodies(source: Any) -> str:
    """Return the vismach model that a LinuxCNC .ini starts; empty where there is none, or it cannot be
    read."""
    if Path(source).suffix.lower() != ".ini":
        return ""
    try:
        return os.fspath(find_model(Path(source)) or "")
    except FiveAxisError:
        return ""


def check_target(fcm_file: Any) -> None:
    """Before the work: a machine file of that name can be written, and none is there. Raises
    FiveAxisError."""
    if Path(os.fspath(fcm_file)).suffix.lower() != machines.SUFFIX:
        raise SettingsError(
            say(
                "{fcm_file} does not end in {suffix}, as machine files do; name it so",
                fcm_file=fcm_file,
                suffix=machines.SUFFIX,
            ),
            fcm_file,
        )
    if os.path.lexists(fcm_file):
        raise FileError(
            say(
                "{fcm_file} exists already; choose another name, so that no machine is lost",
                fcm_file=fcm_file,
            ),
            fcm_file,
        )
    if not machines.is_new_folder(fcm_file):
        check_writable(fcm_file)


def write(imported: Imported, fcm_file: Any = None) -> str:
    """Write the machine file and the meshes of its bodies, never over another file; returns its name. None:
    in the user's folder. Raises FiveAxisError."""
    target = os.fspath(fcm_file) if fcm_file else machines.free_file(imported.machine.name)
    check_target(target)
    machines.make_folder(target)
    save_imported(imported, target)
    return target
