# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Tessellation object: the mesh of a solid, with the facets of the chosen faces.

linear deflection    mm; no facet is further than this from the surface.   angular deflection   deg between
                     neighbouring facets.
facet runs           start, stop, start, stop ...: which facets lie on the faces that are milled: the chosen
                     ones, or all, without those that are left alone; none where all are to be milled.

The mesher is MeshPart's, which keeps the facets of a face together and in the order of the faces;
``shape.tessellate`` takes many times as long and makes more facets.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from itertools import accumulate
from typing import Any

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import Angle, Length, Option, say

from . import meshing, selection
from .long_work import check_open, listening, take_back
from .plain_errors import hide_trace
from .properties import HIDDEN, OUTPUT, QT_TRANSLATE_NOOP, RESULT, Property
from .schema import Proxy

LINEAR, ANGULAR = 0.02, 15.0
"""mm, deg: what is taken where nothing is asked for."""
PROPERTIES = (
    Property(
        "Base", "App::PropertyLinkSubGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "The solid, body, compound or mesh, and the faces of it that are "
            "milled"),
    ),
    Property(
        "Avoid", "App::PropertyLinkSubGlobal", "Base",
        QT_TRANSLATE_NOOP("App::Property", "Faces of the base that are left alone: they are not milled"),
    ),
    Property(
        "LinearDeflection", "App::PropertyLength", "Tessellation",
        QT_TRANSLATE_NOOP("App::Property", "Largest distance of a facet from the surface"), LINEAR,
    ),
    Property(
        "AngularDeflection", "App::PropertyAngle", "Tessellation",
        QT_TRANSLATE_NOOP("App::Property", "Largest angle between neighbouring facets"), ANGULAR,
    ),
    Property("Facets", "App::PropertyInteger", "Result", QT_TRANSLATE_NOOP("App::Property", "Facets of the "
        "mesh"), 0, RESULT),
    Property(
        "FacetRuns", "App::PropertyIntegerList", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Start and stop of the facets that are milled"), [],
        RESULT | HIDDEN | OUTPUT,
    ),
    Property(
        "AvoidedRuns", "App::PropertyIntegerList", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Start and stop of the facets that are left alone"), [],
        RESULT | HIDDEN | OUTPUT,
    ),
    Property(
        "MadeOf", "App::PropertyString", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Checksum of the base and the deflections that the mesh is made "
            "of"), "",
        RESULT | HIDDEN | OUTPUT,
    ),
    Property(
        "HolderPlaces", "App::PropertyFloatList", "Result",
        QT_TRANSLATE_NOOP("App::Property", "Where the parts that hold the base and the mesh stood when the "
            "mesh was made"), [],
        RESULT | HIDDEN | OUTPUT,
    ),
)  # fmt: skip
SAME_PLACE = 1e-6
"""mm, and of a direction's components: what stands nearer than this has not been moved."""


class Tessellation(Proxy):
    """Proxy of a tessellation."""

    def __init__(self, obj: Any) -> None:
        super().__init__(obj)
        obj.setEditorMode("Placement", ["ReadOnly"])  # it stands where its base stands

    _found: tuple[tuple[Any, ...], list[int]] | None

    def _begin(self) -> None:
        self.built, self._found = False, None

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the base, the faces left alone, both deflections, and which facets are to be milled."""
        return PROPERTIES

    def build(self, obj: Any) -> None:
        """Make the mesh now. Raises SelectionError, SettingsError, Cancelled; the recompute that follows does
        no work again."""
        (base, faces), doc = find_base_and_faces(obj), obj.Document
        with listening() as progress:
            progress("tessellate", 0.0)
            check_open(doc)
            _check_avoid(obj)
            deflections = obj.LinearDeflection.Value, obj.AngularDeflection.Value
            mesh, runs, off = mesh_base(base, faces, *deflections, progress, name_avoided(obj))
            progress("tessellate", 1.0)
        check_open(doc)
        mesh.Placement = selection.holder_of(obj).inverse().multiply(mesh.Placement)
        obj.Mesh, obj.FacetRuns, obj.Facets, obj.MadeOf = mesh, runs, mesh.CountFacets, hash_inputs(obj)
        obj.AvoidedRuns, obj.HolderPlaces = off, find_holder_places(obj)
        self.built = True

    def avoided_runs(self, obj: Any) -> list[int]:
        """Return the runs of the facets that are left alone, also where an earlier version has made the mesh
        and did not keep them: then from the same mesh made once more, which stays out of the document. Raises
        SelectionError where it is not the same."""
        if obj.AvoidedRuns or not name_avoided(obj):
            return list(obj.AvoidedRuns)
        inputs = find_base_and_faces(obj)[1], name_avoided(obj), obj.MadeOf
        if self._found is None or self._found[0] != inputs:
            self._found = inputs, _find_avoided(obj)
        return self._found[1]

    def onChanged(self, obj: Any, name: str) -> None:
        """Ask for a new mesh where the input changes."""
        if name in ("Base", "Avoid", "LinearDeflection", "AngularDeflection"):
            self.built = False

    def mustExecute(self, obj: Any) -> bool:
        """FreeCAD asks whether it is to be recomputed though nothing that it leads to has changed."""
        return has_moved(obj)

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        if not self.built or has_moved(obj):
            self.build(obj)
        self.built = False


def _find_avoided(obj: Any) -> list[int]:
    """Return the runs of the facets on the faces left alone, of the object's mesh made anew. Raises
    SelectionError for another mesh."""
    base, faces = find_base_and_faces(obj)
    with listening() as progress:
        mesh, runs, off = mesh_base(
            base, faces, obj.LinearDeflection.Value, obj.AngularDeflection.Value, progress, name_avoided(obj)
        )
    if mesh.CountFacets != obj.Mesh.CountFacets or runs != list(obj.FacetRuns):
        text = say(
            "{label} was made by an earlier version, which did not keep where the faces to be left alone "
            "are: recompute it, that is mark it to recompute in the tree and recompute the document.",
            label=obj.Label,
        )  # fmt: skip
        raise selection.SelectionError(text, obj.Label)
    return off


def hash_inputs(obj: Any) -> str:
    """Return a checksum of the base, as far as its vertices tell, the chosen faces, those left alone and the
    deflections; empty without a base."""
    base, faces = find_base_and_faces(obj)
    if base is None:
        return ""
    shape: tuple[Any, ...]
    if selection.is_mesh(base):
        mesh = selection.copy_of_mesh(base)
        box, shape = mesh.BoundBox, (mesh.CountFacets, mesh.CountPoints)
    else:
        whole = selection.solids(base)[0]
        box, shape = whole.BoundBox, tuple(tuple(corner.Point) for corner in whole.Vertexes)
    inputs = [
        shape,
        str(box),
        selection.holder_of(base).Matrix.A,
        faces,
        obj.LinearDeflection.Value,
        obj.AngularDeflection.Value,
    ]
    inputs += (
        [name_avoided(obj)] if name_avoided(obj) else []
    )  # documents that know of none keep their checksums
    return hashlib.sha256(repr(tuple(inputs)).encode()).hexdigest()


def find_holder_places(obj: Any) -> list[float]:
    """Return the matrices of where the parts stand that hold the base and the mesh; empty without a base."""
    base = find_base_and_faces(obj)[0]
    return [] if base is None else [part for one in (base, obj) for part in selection.holder_of(one).Matrix.A]


def has_moved(obj: Any) -> bool:
    """Whether the base, or the mesh, was moved since the mesh was made by what holds it: of that FreeCAD's
    links know nothing. Not known of a mesh that an earlier version made."""
    before = getattr(obj, "HolderPlaces", None)
    now = find_holder_places(obj) if before else []
    return any(abs(one - other) > SAME_PLACE for one, other in zip(before or [], now, strict=False))


def find_base_and_faces(obj: Any) -> tuple[Any, tuple[str, ...]]:
    """Return the base of a Tessellation and the names of its chosen faces."""
    if obj.Base is None:
        return None, ()
    base, names = obj.Base
    return base, tuple(name for name in names if name)


def name_avoided(obj: Any) -> tuple[str, ...]:
    """Return the names of the faces that a Tessellation leaves alone."""
    link = getattr(obj, "Avoid", None)
    return () if link is None else tuple(name for name in link[1] if name)


def _is_of_base(obj: Any) -> bool:
    """Whether the faces left alone, if there are any, are the base's."""
    return not name_avoided(obj) or (obj.Base is not None and obj.Avoid[0] is obj.Base[0])


def _check_avoid(obj: Any) -> None:
    if obj.Base is not None and not _is_of_base(obj):
        base, other, names = obj.Base[0].Label, obj.Avoid[0].Label, ", ".join(name_avoided(obj))
        text = say(
            "{names} to be left alone is of {other}: choose faces of {label}.",
            names=names,
            other=other,
            label=base,
        )
        raise selection.SelectionError(text, names)


def leave_alone(obj: Any, names: Sequence[str]) -> bool:
    """Have a Tessellation leave these faces of its base alone, and no others; whether that is a change. The
    mesh is not made."""
    if tuple(names) == name_avoided(obj) and _is_of_base(obj):
        return False
    obj.Avoid = (obj.Base[0], list(names)) if names else None
    return True


def mesh_base(
    base: Any,
    faces: Sequence[str],
    linear: float,
    angular: float,
    progress: Progress,
    avoid: Sequence[str] = (),
) -> tuple[Any, list[int], list[int]]:
    """Return the mesh of a base, the runs of its facets that are milled: those on the faces, all where none
    is named, without those on faces to ``avoid``; no runs where all are; and the runs of those. ``linear``
    mm, ``angular`` deg. Raises FiveAxisError."""
    if base is not None and selection.is_mesh(base):
        return _copy_mesh(base, faces, avoid), [], []
    if linear <= 0.0 or angular <= 0.0:
        raise SettingsError(
            say(
                "the deflections are {linear} and {angular}; both must be above 0",
                linear=Length(linear),
                angular=Angle(angular),
            ),
            (linear, angular),
        )
    whole, rows = selection.solids(base, faces, avoid)
    off = sorted(set(rows[len(faces) :]))
    rows = _find_milled(base.Label, rows, len(faces), avoid, len(whole.Faces))
    found = meshing.mesh_shape(whole, linear, math.radians(angular), progress)
    if found is None:
        raise selection.invalid(base.Label)
    mesh, counts = found
    if not mesh.CountFacets or len(counts) != len(whole.Faces) or sum(counts) != mesh.CountFacets:
        raise selection.SelectionError(
            say(
                "FreeCAD could not mesh {label}: check its geometry, or choose other deflections.",
                label=base.Label,
            ),
            base,
        )
    stop = list(accumulate(counts))
    runs, off = (
        [bound for row in some for bound in (stop[row] - counts[row], stop[row])] for some in (rows, off)
    )
    return mesh, runs, off


def _find_milled(label: str, rows: Sequence[int], chosen: int, avoid: Sequence[str], count: int) -> list[int]:
    """Return the faces, of ``count``, that are milled: the first ``chosen`` rows, all where there are none of
    these, without the others. None where all are. Raises SelectionError where nothing is left, which would be
    taken for all."""
    left = set(rows[:chosen] or range(count)) - set(rows[chosen:])
    if not left:
        text = say(
            "All that is to be milled of {label} is to be left alone too: take {names}, or some of them, out "
            "of {option}.",
            label=label, names=", ".join(avoid), option=Option("avoid", flag=False),
        )  # fmt: skip
        raise selection.SelectionError(text, ", ".join(avoid))
    return sorted(left) if rows else []


def _copy_mesh(base: Any, faces: Sequence[str], avoid: Sequence[str] = ()) -> Any:
    if avoid:
        raise no_names(base)
    if faces:
        raise selection.SelectionError(
            say("{label} is a mesh and has no faces to choose: select the whole of it.", label=base.Label),
            base.Label,
        )
    mesh = selection.check_mesh(base)
    mesh.Placement = selection.holder_of(base).multiply(mesh.Placement)
    return mesh


def no_names(base: Any) -> selection.SelectionError:
    """Return what to say where faces of a mesh are to be left alone."""
    text = say(
        "{label} is a mesh, whose faces have no names: choose the solid it is of, or mill it on the command "
        "line with {option}.",
        label=base.Label, option="--avoid FACES.stl",
    )  # fmt: skip
    return selection.SelectionError(text, base.Label)


def make(
    doc: Any,
    base: Any,
    faces: Sequence[str] = (),
    linear: float = LINEAR,
    angular: float = ANGULAR,
    avoid: Sequence[str] = (),
) -> Any:
    """Return a Tessellation object with its mesh. ``linear`` mm, ``angular`` deg. Raises as
    :meth:`Tessellation.build`.

    Where it fails, no object is left behind.
    """
    obj = doc.addObject("Mesh::FeaturePython", "Tessellation")
    try:
        Tessellation(obj)
        obj.Base = (base, list(faces))
        leave_alone(obj, avoid)
        obj.LinearDeflection, obj.AngularDeflection = linear, angular
        obj.Proxy.build(obj)
        doc.recompute([obj])
    except BaseException:
        take_back(doc, obj)
        raise
    return obj
