# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who meshes a solid: this FreeCAD, or one without a window beside it.

OpenCASCADE lets nobody else work while it meshes: not the window, and not the user's Cancel. So what takes
long is meshed by a process of its own wherever a window listens. The mesh is the same to the last bit. Where
no such process can be had, and where it fails, this FreeCAD meshes.

quick     what takes hardly longer than such a process takes to begin.
"""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from typing import Any

import FreeCAD
import Mesh

from freecad_fiveaxis.core.base.progress import Progress

from . import mesher
from .long_work import run

QUICK = 10000
"""Facets that are meshed here: some 0.2 s."""
MANY = 200
"""Faces; it would take long only to look at more of them."""
PER_CHORD = 6.0
"""Facets that OpenCASCADE makes in a square as long as the chord of the deflection."""
CURVED = 4
"""A facet of a surface without a radius takes so many times as long."""
NAMES = ("freecadcmd", "FreeCADCmd", "freecadcmd-python3", "FreeCADCmd.exe", "freecadcmd.exe")
WAIT = 0.05
"""s between two looks at the process."""


def mesh_shape(shape: Any, linear: float, angular: float, progress: Progress) -> tuple[Any, list[int]] | None:
    """Return the mesh of the solids of a shape and the number of facets of each face; None where the shape is
    invalid.

    ``linear`` mm, ``angular`` rad. Raises Cancelled where the listener stops it.
    """
    program = (
        command() if hasattr(progress, "pump") and estimate_facets(shape, linear, angular) > QUICK else ""
    )
    found = _beside(program, shape, linear, angular, progress) if program else ()
    return mesher.solid_mesh(shape, linear, angular) if found == () else found  # type: ignore[return-value]


def estimate_facets(shape: Any, linear: float, angular: float) -> float:
    """About how many facets the mesh will have, those that take longer counted more than once; infinite for
    very many faces."""
    faces = shape.Faces
    return math.inf if len(faces) > MANY else sum(_estimate_face(face, linear, angular) for face in faces)


def _estimate_face(face: Any, linear: float, angular: float) -> float:
    """Return a flat face with many holes takes time by the square of its corners."""
    corners = float(len(face.Edges))
    if face.Surface.TypeId == "Part::GeomPlane":
        return corners * corners
    radius = getattr(face.Surface, "Radius", None) or 0.0
    around = radius or math.sqrt(face.Area) / math.pi
    chord = min(math.sqrt(8.0 * linear * around), around * angular)
    return corners + PER_CHORD * (1.0 if radius else CURVED) * float(face.Area) / float(max(chord, 1e-9)) ** 2


def command() -> str:
    """Return the path of a FreeCAD without a window; empty where there is none."""
    folders = [os.path.join(FreeCAD.getHomePath(), "bin"), os.path.dirname(sys.executable or "")]
    beside = [os.path.join(folder, name) for folder in folders for name in NAMES]
    there = [path for path in beside if os.path.isfile(path) and os.access(path, os.X_OK)]
    return there[0] if there else next(filter(None, map(shutil.which, NAMES)), "")


def _beside(program: str, shape: Any, linear: float, angular: float, progress: Progress) -> Any:
    """As :func:`mesh_shape`, by a process; an empty tuple where it fails."""
    with tempfile.TemporaryDirectory() as folder:
        shape.exportBinary(os.path.join(folder, mesher.SHAPE))
        with open(os.path.join(folder, mesher.TASK), "w", encoding="ascii") as file:
            json.dump({"linear": linear, "angular": angular}, file)
        run(lambda progress: _wait_for(program, folder, progress), progress)
        return _read(folder)


def _read(folder: str) -> Any:
    file_path = os.path.join(folder, mesher.OUTCOME)
    if not os.path.isfile(file_path):
        FreeCAD.Console.PrintLog("Five-axis: the process that meshes failed; the solid is meshed here\n")
        return ()
    with open(file_path, encoding="ascii") as file:
        counts = json.load(file)
    if counts is None:
        return None
    mesh = Mesh.Mesh()
    mesh.read(os.path.join(folder, mesher.MESH))
    return mesh, counts


def _wait_for(program: str, folder: str, progress: Progress) -> None:
    """Run the process to its end; whatever is raised meanwhile ends it. It is a new user's: no other add-on
    is loaded."""
    environment = {
        **os.environ,
        mesher.FOLDER: folder,
        "FREECAD_USER_HOME": folder,
        "QT_QPA_PLATFORM": "offscreen",
    }
    hidden: dict[str, int] = {}
    if sys.platform == "win32":
        hidden["creationflags"] = subprocess.CREATE_NO_WINDOW
    quiet = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.DEVNULL)
    process = subprocess.Popen([program, mesher.__file__], env=environment, cwd=folder, **quiet, **hidden)  # type: ignore[call-overload]
    try:
        while process.poll() is None:
            progress("tessellate", 0.0)
            time.sleep(WAIT)
    finally:
        process.kill()
        process.wait()
