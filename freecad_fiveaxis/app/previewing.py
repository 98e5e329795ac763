# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passes of settings that are not computed yet: laid by the core, kept by whoever asked. The document
holds none of them.

The mesh of the tool path is taken where it is that of the settings; any other one is made, and thrown away.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.pipeline import preview
from freecad_fiveaxis.core.pipeline.settings import MILL, Settings, build_settings

from . import convert, results, selection, tessellation, toolpath
from .arguments import names
from .long_work import check_open, listening, run


@dataclass(frozen=True)
class Part:
    """What is milled: the ``base`` and names of its ``faces``, without those to ``avoid``, meshed with the
    deflections ``linear`` mm and ``angular`` deg; ``mesh``: the object that may be its mesh already."""

    base: Any
    faces: Sequence[str] = ()
    avoid: Sequence[str] = ()
    linear: float = tessellation.LINEAR
    angular: float = tessellation.ANGULAR
    mesh: Any = None


def part_of(path: Any, settings: Mapping[str, Any]) -> Part:
    """Return the part of a Toolpath with the settings that are of its mesh; without them as its mesh has
    them. Raises SelectionError."""
    mesh = path.Mesh
    if mesh is None:
        raise toolpath.mesh_is_gone(path)
    chosen, avoid = names(settings.get("faces") or ()), settings.get("avoid")
    if not hasattr(mesh, "LinearDeflection"):
        if chosen or avoid:
            raise tessellation.no_names(mesh)
        return Part(mesh)
    base, faces = tessellation.find_base_and_faces(mesh)
    linear = settings.get("linear_deflection")
    return Part(
        base, chosen or faces, tessellation.name_avoided(mesh) if avoid is None else names(avoid),
        mesh.LinearDeflection.Value if linear is None else linear,
        settings.get("angular_deflection") or mesh.AngularDeflection.Value, mesh,
    )  # fmt: skip


def lay(doc: Any, part: Part, options: Mapping[str, Any], work_zero: Sequence[float]) -> preview.Preview:
    """Return the passes of the ``options`` on a part, about the ``work_zero`` (mm, document). Raises
    FiveAxisError, Cancelled."""
    options = toolpath.with_strategies(convert.convert_options(MILL, options))
    settings = build_settings(MILL, f"{getattr(part.base, 'Label', '')}.stl", options)
    with listening() as listener:
        facets, runs, off = _find_facets(part, work_zero, settings, listener)
        check_open(doc)

        def work(progress: Progress) -> preview.Preview:
            mesh, faces = convert.mesh_and_mask(facets(), runs, off, settings.gouge.avoid_allowance, progress)
            return preview.preview_passes(settings, progress, mesh, faces)

        return run(work, listener, doc)


def _find_facets(
    part: Part, work_zero: Sequence[float], settings: Settings, progress: Progress
) -> tuple[Callable[[], bytes], Sequence[int], Sequence[int]]:
    """Return what gives the facets as a binary STL, relative to the work zero, in any thread; and the runs of
    those that are milled, and of those to avoid."""
    if _is_meshed(part):
        return convert.facets_of(part.mesh, work_zero).stl, *results.runs_of(part.mesh, settings)
    if part.base is not None and selection.is_mesh(part.base) and not (part.faces or part.avoid):
        return convert.facets_of(part.base, work_zero).stl, *results.runs_of(part.base, settings)
    progress("tessellate", 0.0)
    mesh, runs, off = tessellation.mesh_base(
        part.base, part.faces, part.linear, part.angular, progress, part.avoid
    )
    mesh.Placement = convert.move_to_zero(mesh.Placement, work_zero)
    with tempfile.TemporaryDirectory() as folder:  # FreeCAD 0.20 writes nothing into a stream
        path = os.path.join(folder, "part.stl")
        mesh.write(path)
        stl = read_bytes(path, "part")
    return lambda: stl, runs, off


def _is_meshed(part: Part) -> bool:
    """Whether the mesh object is that of the part as it is now."""
    mesh = part.mesh
    if (
        mesh is None
        or mesh.State != ["Up-to-date"]
        or mesh.MadeOf != tessellation.hash_inputs(mesh)
        or tessellation.has_moved(mesh)
    ):
        return False
    known = (mesh.LinearDeflection.Value, mesh.AngularDeflection.Value, tessellation.name_avoided(mesh))
    same_faces = tessellation.find_base_and_faces(mesh)[1] == tuple(part.faces)
    return same_faces and known == (part.linear, part.angular, tuple(part.avoid))
