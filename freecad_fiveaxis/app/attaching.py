# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected in whatever document as the surface of a machine's body: solids, meshes, parts and links.

path    how FreeCAD tells a selected object: an object and the names that lead into it, as ``Link.Box.``.
        Along it every placement counts, of links too.
zero    the point of the document at which the machine's zero lies, mm.
part    of a part or group all that is visible counts: its solids, and the meshes in it.
"""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from itertools import takewhile
from typing import Any, NamedTuple

import FreeCAD
import numpy as np
import Part

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles

from . import meshing, selection
from .facets import STL, Facets, kernel_of
from .long_work import listening

LINEAR, ANGULAR = 0.1, 30.0
"""mm, deg: facets as coarse as bodies of a machine may be."""
HEAD = 84
"""Bytes of a binary STL before its facets."""


class Chosen(NamedTuple):
    """The object at the end of a ``path`` from ``top``."""

    top: Any
    path: str = ""

    @property
    def leaf(self) -> Any:
        """The object itself."""
        return self.top.getSubObject(self.path, 1)

    def inner(self) -> Iterator[Chosen]:
        """Yield what a part, a group or a link to one holds and shows."""
        for name in self.leaf.getSubObjects():
            one = Chosen(self.top, self.path + name)
            if one.leaf is not None and one.leaf.Visibility:
                yield one


class Surface(NamedTuple):
    """What is to become a body: its ``label`` and ``mesh``, mm from the machine's zero."""

    label: str
    mesh: Mesh


def paths(chosen: Iterable[tuple[Any, Sequence[str]]]) -> list[Chosen]:
    """Return the objects meant by selected ``(object, names of its elements)``, each once; a body stands for
    its features."""
    found = [_path(obj, name) for obj, names in chosen for name in (tuple(names) or ("",))]
    return list({(one.top.Document.Name, one.top.Name, one.path): one for one in found}.values())


def _path(obj: Any, name: str) -> Chosen:
    found = Chosen(obj)
    for part in takewhile(
        lambda part: not part.startswith(";"), name.split(".")[:-1]
    ):  # what begins so names an element
        if found.leaf.getLinkedObject().isDerivedFrom("PartDesign::Body"):
            break
        found = Chosen(obj, f"{found.path}{part}.")
    return found


def surfaces(chosen: Sequence[Chosen], zero: Sequence[float], linear: float = LINEAR) -> list[Surface]:
    """Return the surfaces of what was chosen; facets lie about ``linear`` mm beside the solids at most.
    Raises FiveAxisError that says which is none; then none is given."""
    if not linear > 0.0:
        raise SettingsError(
            say("a deviation of {linear} is not above 0; give one as 0.1 mm", linear=Length(linear)), linear
        )
    with listening() as progress:
        return [_surface(one, zero, linear, progress) for one in chosen]


def _surface(one: Chosen, zero: Sequence[float], linear: float, progress: Progress) -> Surface:
    holder, label = _holder(one.top), one.leaf.Label
    corners = [_mesh_corners(each, holder) for each in _meshes(one)]
    shape = Part.getShape(one.top, one.path)
    if not shape.isNull() and shape.Solids:
        corners.append(_solid_corners(label, shape, holder, linear, progress))
    if not sum(map(len, corners)):
        kind = one.leaf.getLinkedObject().TypeId
        text = say("{label} ({kind}) holds neither a solid nor a mesh: select a solid, a mesh, or a part or "
            "link of some.",
                   label=label, kind=kind)  # fmt: skip
        raise selection.SelectionError(text, label)
    return Surface(
        label, from_triangles(np.concatenate(corners).astype(float) - np.asarray(zero, dtype=float))
    )


def _meshes(one: Chosen) -> Iterator[Chosen]:
    """Yield the meshes at the end of the path and in what stands there."""
    if selection.is_mesh(one.leaf):
        yield one
    elif not one.leaf.getLinkedObject().isDerivedFrom("PartDesign::Body"):
        for inner in one.inner():
            yield from _meshes(inner)


def _mesh_corners(one: Chosen, holder: Any) -> Floats:
    """Return the corners (f, 3, 3) of a mesh, mm of the document."""
    matrix = holder.Matrix.multiply(one.top.getSubObject(one.path, 4))
    return _corners(Facets(kernel_of(one.leaf), tuple(matrix.A)).stl())


def _solid_corners(label: str, shape: Any, holder: Any, linear: float, progress: Progress) -> Floats:
    """Return the corners (f, 3, 3) of the facets of a shape's solids, mm of the document."""
    shape.Placement = holder.multiply(shape.Placement)
    found = meshing.mesh_shape(shape, linear, math.radians(ANGULAR), progress)
    if found is None:
        raise selection.invalid(label)
    with tempfile.TemporaryDirectory() as folder:  # FreeCAD 0.20 writes nothing into a stream
        path = os.path.join(folder, "part.stl")
        found[0].write(path)
        return _corners(read_bytes(path, "part"))


def _corners(stl: bytes) -> Floats:
    return np.frombuffer(stl, STL, offset=HEAD)["corner"]


def _holder(top: Any) -> Any:
    """Return the placement in the document of what holds the object at the beginning of a path; none holds it
    where FreeCAD tells the whole path, as it does of what is selected in its tree and views."""
    if hasattr(top, "getGlobalPlacement"):
        return selection.holder_of(top)
    group = (
        top.getParentGeoFeatureGroup()
    )  # of a link; not its parents, which name the links to its group too
    return FreeCAD.Placement() if group is None else group.getGlobalPlacement()
