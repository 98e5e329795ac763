# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that were attached to a draft as bodies: each is an STL in a folder of its own until the draft is
saved.

beside    with the draft each is written beside the machine's file, named after both, where no file is yet.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from itertools import count
from pathlib import Path
from tempfile import TemporaryDirectory

from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.geometry.mesh import Mesh, write_stl
from freecad_fiveaxis.core.machine.bodies import FILE, MachineBody, free_body_name
from freecad_fiveaxis.core.machine.mesh_files import SUFFIX, free_mesh_file

from .draft import MachineDraft


class AttachedMeshes:
    """The meshes of one session of editing. They are gone when it is closed, or the process ends."""

    def __init__(self) -> None:
        self._folder: TemporaryDirectory[str] | None = None
        self._numbers = count(1)

    def add(self, mesh: Mesh) -> str:
        """Keep a mesh, mm in the machine frame with every joint at zero; returns the name of its file. Raises
        FileError."""
        if self._folder is None:
            self._folder = TemporaryDirectory(prefix="fiveaxis-machine-")
        path = os.path.join(self._folder.name, f"{next(self._numbers)}{SUFFIX}")
        write_stl(mesh, path)
        return path

    def holds(self, file: str) -> bool:
        """Tell whether a body's file is one of these."""
        return self._folder is not None and os.path.dirname(file) == self._folder.name

    def close(self) -> None:
        """Remove what is kept; may be called twice."""
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None


def attach_bodies(
    draft: MachineDraft, surfaces: Sequence[tuple[str, Mesh]], carrier: str, attached: AttachedMeshes
) -> MachineDraft:
    """Add bodies of a ``carrier`` after labels and meshes, mm in the machine frame with every joint at zero;
    a label that is a body's name already gets a number. Raises FileError."""
    bodies = list(draft.bodies)
    for label, mesh in surfaces:
        name = free_body_name(label, [body.name for body in bodies])
        bodies.append(MachineBody(name, carrier, FILE, file=attached.add(mesh)))
    return replace(draft, bodies=tuple(bodies))


def name_attached(
    draft: MachineDraft, target: Path, attached: AttachedMeshes
) -> tuple[MachineDraft, dict[str, bytes]]:
    """Give the draft as it will be in the machine file ``target``, the attached meshes beside it, and what is
    to be written under their new names. Raises FileError."""
    bodies: list[MachineBody] = []
    files: dict[str, bytes] = {}
    for body in draft.bodies:
        if body.shape == FILE and attached.holds(body.file):
            name = free_mesh_file(target, body.name, files)
            files[name] = read_bytes(body.file, "mesh")
            body = replace(body, file=name)
        bodies.append(body)
    return replace(draft, bodies=tuple(bodies)), files
