# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a solid, by MeshPart; also a program of its own, for a FreeCAD without a window.

As a program it takes the folder FIVEAXIS_MESHER with ``task.json`` (the deflections) and ``shape.bin``, and leaves there
``mesh.bms`` and then ``made.json``: the number of facets of each face, or null where the shape is invalid. It imports nothing of
this add-on, which that FreeCAD need not know.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from typing import Any

import MeshPart
import Part

FOLDER = "FIVEAXIS_MESHER"
TASK, SHAPE, MESH, MADE = "task.json", "shape.bin", "mesh.bms", "made.json"


def solid_mesh(shape: Any, linear: float, angular: float) -> tuple[Any, list[int]] | None:
    """The mesh of the solids of a shape, outside out, and the number of facets of each face; None for an invalid shape.

    ``linear`` mm, ``angular`` rad.
    """
    if not shape.isValid():
        return None
    outward = [solid if solid.Volume > 0 else solid.reversed() for solid in shape.Solids]
    whole = outward[0] if len(outward) == 1 else Part.makeCompound(outward)
    mesh = MeshPart.meshFromShape(
        Shape=whole.copy(), LinearDeflection=linear, AngularDeflection=angular, Relative=False, Segments=True
    )
    return mesh, [len(mesh.getSegment(i)) for i in range(mesh.countSegments())]


def main(folder: str) -> None:
    """Do the task of a folder."""
    with open(os.path.join(folder, TASK), encoding="ascii") as file:
        task = json.load(file)
    shape = Part.Shape()
    shape.importBinary(os.path.join(folder, SHAPE))
    made = solid_mesh(shape, task["linear"], task["angular"])
    if made is not None:
        made[0].write(os.path.join(folder, MESH))
    with open(os.path.join(folder, MADE), "w", encoding="ascii") as file:
        json.dump(made and made[1], file)


if __name__ == "mesher":  # what FreeCAD calls a program: by the stem of its file
    try:
        main(os.environ[FOLDER])
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    os._exit(0)  # an exception that FreeCAD sees makes it run the file again
