# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of a solid, by MeshPart; also a program of its own, for a FreeCAD without a window.

As a program it takes the folder FIVEAXIS_MESHER with ``task.json`` (the deflections) and ``shape.bin``, and
leaves there ``mesh.bms`` and then ``draft.json``: the number of facets of each face, or null where the shape
is invalid. Of a task with a ``file`` (STEP, IGES, BREP, FCStd) it meshes the solid ``named``, or the only
one, to ``mesh.stl``; ``draft.json`` is then ``{"facets": count}`` or ``{"error": why not}``. It imports
nothing of this add-on, which that FreeCAD need not know.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import sys
import traceback
from collections.abc import Iterator
from typing import Any

import FreeCAD
import MeshPart
import Part

FOLDER = "FIVEAXIS_MESHER"
TASK, SHAPE, MESH, OUTCOME, STL = "task.json", "shape.bin", "mesh.bms", "made.json", "mesh.stl"
DOCUMENT = ".fcstd"
SEVERAL = 8
"""So many solids of a document are named."""


def solid_mesh(shape: Any, linear: float, angular: float) -> tuple[Any, list[int]] | None:
    """Return the mesh of the solids of a shape, outside out, and the number of facets of each face; None for
    an invalid shape.

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
    outcome = _mesh_file(task, folder) if "file" in task else _mesh_shape(task, folder)
    with open(os.path.join(folder, OUTCOME), "w", encoding="ascii") as file:
        json.dump(outcome, file)


def _mesh_shape(task: dict[str, Any], folder: str) -> list[int] | None:
    shape = Part.Shape()
    shape.importBinary(os.path.join(folder, SHAPE))
    meshed = solid_mesh(shape, task["linear"], task["angular"])
    if meshed is not None:
        meshed[0].write(os.path.join(folder, MESH))
    return meshed and meshed[1]


def _mesh_file(task: dict[str, Any], folder: str) -> dict[str, Any]:
    try:
        shape = _read_shape(task["file"], task["named"])
        meshed = solid_mesh(shape, task["linear"], math.radians(task["angular"]))
    except Exception as error:
        return {"error": _reason(error)}
    if meshed is None:
        return {"error": "its solid is invalid; repair it (Part, Check geometry)"}
    meshed[0].write(os.path.join(folder, STL))
    return {"facets": meshed[0].CountFacets}


def _reason(error: Exception) -> str:
    """Say in one line why a file was not meshed."""
    return " ".join(str(error).split()) or type(error).__name__


@contextlib.contextmanager
def _reading() -> Iterator[None]:
    """Raise ValueError for whatever FreeCAD raises over a file. Before 1.1 that holds a dictionary, and the
    sentence is in it."""
    try:
        yield
    except Exception as error:
        held = error.args[0] if error.args else ""
        reason = held.get("sErrMsg", "") if isinstance(held, dict) else error
        reason = " ".join(str(reason).split()) or type(error).__name__
        raise ValueError(f"FreeCAD cannot read it ({reason}); export it again") from error


def _read_shape(path: str, named: str) -> Any:
    """Return the solids of a file, in mm. Raises ValueError where there is none, or not one that is meant."""
    if path.lower().endswith(DOCUMENT):
        with _reading():
            doc = FreeCAD.openDocument(path, True)
        try:
            return _solid_of(doc, named)
        finally:
            FreeCAD.closeDocument(doc.Name)
    shape = Part.Shape()
    with _reading():
        shape.read(path)
    if not shape.Solids:
        raise ValueError("it holds no solid; export one, or give the part as STL")
    return shape


def _solid_of(doc: Any, named: str) -> Any:
    """Return the shape of the object ``named``, by its label or else its name; without a name that of the
    only one, or the only visible one, which no other solid is made of."""
    solids = [obj for obj in doc.Objects if _is_solid(obj)]
    if named:
        chosen = [obj for obj in solids if obj.Label == named] or [obj for obj in solids if obj.Name == named]
    else:
        last = [obj for obj in solids if not any(map(_is_solid, obj.InListRecursive))]
        chosen = [obj for obj in last if obj.Visibility] or last
    if len(chosen) != 1:
        raise ValueError(_not_one(chosen or solids, named))
    shape = chosen[0].Shape.copy()
    shape.Placement = chosen[0].getGlobalPlacement()
    return shape


def _is_solid(obj: Any) -> bool:
    if obj.TypeId == "App::Part":  # FreeCAD gives what it holds as its shape
        return False
    shape = getattr(obj, "Shape", None)
    return shape is not None and not shape.isNull() and bool(shape.Solids)


def _not_one(found: list[Any], named: str) -> str:
    if not found:
        return "it holds no solid"
    labels = ", ".join(obj.Label for obj in found[:SEVERAL]) + (" ..." if len(found) > SEVERAL else "")
    return (
        f"{named} is none of its solids, or not the only one of that label" * bool(named)
        + "; " * bool(named)
        + (f"it holds {labels}: name one behind the file, as part.FCStd:{found[0].Label}")
    )


if __name__ == "mesher":  # what FreeCAD calls a program: by the stem of its file
    try:
        main(os.environ[FOLDER])
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    os._exit(0)  # an exception that FreeCAD sees makes it run the file again
