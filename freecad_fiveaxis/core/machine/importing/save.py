# SPDX-License-Identifier: LGPL-2.1-or-later
"""An imported machine is written: its file and the meshes of its bodies beside it, over no file, all of them
or none."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

from freecad_fiveaxis.core.base.files import write_all
from freecad_fiveaxis.core.geometry.mesh import stl_bytes
from freecad_fiveaxis.core.machine import check_new, machine_bytes
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.mesh_files import free_mesh_file

from .imported import Imported


def save_imported(imported: Imported, path: str | os.PathLike[str]) -> list[str]:
    """Write a machine as a new ``.fcm`` file; returns the names of all files, that one first. Raises
    FileError where it is there already or cannot be written, MachineError for an axis without a maximum rate;
    then no file is left."""
    target, machine = Path(path), imported.machine
    check_new(target)
    files: dict[str, bytes] = {}
    bodies: list[MachineBody] = []
    for body in machine.bodies:
        if body.name in imported.meshes:
            name = free_mesh_file(target, body.name, files)
            files[name] = stl_bytes(imported.meshes[body.name])
            body = replace(body, file=Path(name).name)
        bodies.append(body)
    write_all(files | {str(target): machine_bytes(replace(machine, bodies=tuple(bodies)))})
    return [str(target), *files]
