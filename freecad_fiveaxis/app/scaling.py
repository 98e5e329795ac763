# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that was drawn or imported in another unit: the path gets a copy of it, scaled about the document's
origin."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import Number, say

from . import selection, tessellation, toolpath

LARGEST = 1e6
"""A factor beyond it, or below its reciprocal, is no change of units."""


def scale_part(path: Any, factor: float) -> Any:
    """Mill a copy of a toolpath's part, ``factor`` times as large; the part itself is hidden. Returns the
    copy.

    The path's work zero is scaled with it; the path is not computed. Raises SettingsError for a factor that
    is no scale and SelectionError; the caller's transaction then takes back what was done.
    """
    if not 1.0 / LARGEST <= factor <= LARGEST:
        raise SettingsError(
            say("the factor is {factor}; it must be between 1e-6 and 1e6", factor=Number(factor, ".6g")),
            factor,
        )
    if path.Mesh is None:
        raise toolpath.mesh_is_gone(path)
    mesh, doc = path.Mesh, path.Document
    base, faces = tessellation.find_base_and_faces(mesh) if hasattr(mesh, "LinearDeflection") else (mesh, ())
    avoid = tessellation.name_avoided(mesh)
    copy, names = _scale_copy(doc, base, (*faces, *avoid), factor)
    copy.Label = f"{base.Label} x {factor:g}"
    if base is mesh:
        path.Mesh = copy
    else:
        mesh.Base = (copy, names[: len(faces)])
        tessellation.leave_alone(mesh, names[len(faces) :])
        mesh.Proxy.build(mesh)
    path.WorkZero = path.WorkZero * factor
    doc.recompute([copy, mesh])
    _show(copy, base)
    return copy


def _scale_copy(doc: Any, base: Any, faces: tuple[str, ...], factor: float) -> tuple[Any, list[str]]:
    """Return a copy of the base, and what its faces are called there: the copy is of the solids alone, in the
    document's coordinates."""
    if selection.is_mesh(base):
        facets = selection.check_mesh(base)
        facets.Placement = selection.holder_of(base).multiply(facets.Placement)
        facets.transform(_matrix(factor) * facets.Placement.Matrix)
        facets.Placement = FreeCAD.Placement()
        copy = doc.addObject("Mesh::Feature", "Scaled")
        copy.Mesh = facets
        return copy, []
    whole, rows = selection.solids(base, faces)
    copy = doc.addObject("Part::Feature", "Scaled")
    copy.Shape = whole.copy().scale(factor, FreeCAD.Vector())
    return copy, [f"Face{row + 1}" for row in rows]


def _matrix(factor: float) -> Any:
    matrix = FreeCAD.Matrix()
    matrix.scale(factor, factor, factor)
    return matrix


def _show(copy: Any, base: Any) -> None:
    if FreeCAD.GuiUp:
        copy.ViewObject.Visibility, base.ViewObject.Visibility = True, False
