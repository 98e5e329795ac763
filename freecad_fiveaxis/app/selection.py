# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be milled: a solid, faces of it, a Part Design body, a compound of solids, or a mesh; and what to
say of all else.

base    the object that the user selected.   faces   names of its faces, as ``Face3``; none: all of it.

A mesh object's property ``Mesh`` is never read as an attribute. FreeCAD 1.1 with Python 3.14 crashes when it
quits with a document open in which one was read: it frees Python's side of the mesh without Python's lock.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Sequence
from typing import Any

import FreeCAD
import Mesh
import Part

from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.base.sentences import Template, say

from .facets import kernel_of

WHAT = say("select a solid, faces of a solid, a body, a compound of solids, or a mesh")
SAME_PLACE = 1e-6
"""mm between the middles of a face and of itself, where two objects have it."""
CHECKED = 100
"""Faces of a shape that is looked at for being valid as soon as it is selected: some 0.1 s."""
_FACE = re.compile(r"Face[1-9]\d*")
_LOST = Template("{label} has no {name} on a solid: select its faces again.")
_LOST_AVOIDED = Template(
    "{label} has no {name} on a solid, which was to be left alone: choose anew which of its faces are not "
    "machined."
)


GONE = "?"
"""What FreeCAD 1.0 and later put before the name of a face that a link still asks for and the object has no
more."""


class SelectionError(FiveAxisError, ValueError):
    """What was selected cannot be milled; the message says what to select."""


def pick(chosen: Iterable[tuple[Any, Sequence[str]]]) -> tuple[Any, tuple[str, ...]]:
    """Return the base and its faces out of selected ``(object, names of its elements)``. Raises
    SelectionError.

    An edge, a vertex or an element of a mesh among the names stands for the whole object.
    """
    rows = [(leaf_of(obj, name), name) for obj, names in chosen for name in (tuple(names) or ("",))]
    if not rows:
        raise SelectionError(say("Nothing is selected: {what}.", what=WHAT), None)
    objects = {id(obj): obj for obj, _ in rows}
    if len(objects) > 1:
        labels = ", ".join(obj.Label for obj in objects.values())
        raise SelectionError(
            say(
                "{count} objects are selected ({labels}): select one, or make a compound of them.",
                count=len(objects),
                labels=labels,
            ),
            labels,
        )
    (base,) = objects.values()
    names = dict.fromkeys(name for _, name in rows if name)
    if not is_mesh(base):
        solids(base)
        faces = tuple(last for name in names if _FACE.fullmatch(last := name.rsplit(".", 1)[-1]))
        return base, faces if len(faces) == len(names) else ()
    check_mesh(base)
    return base, ()


def faces_of(base: Any, chosen: Iterable[tuple[Any, Sequence[str]]]) -> tuple[str, ...]:
    """Return the faces' names on ``base`` out of selected ``(object, names of its elements)``. Raises
    SelectionError that says what to select where anything else is among them."""
    rows = [
        (leaf_of(obj, name), name.rsplit(".", 1)[-1])
        for obj, names in chosen
        for name in (tuple(names) or ("",))
    ]
    if not rows:
        text = say(
            "Nothing is selected: click faces of {label} in the 3D view, several with Ctrl.", label=base.Label
        )
        raise SelectionError(text, None)
    return tuple(dict.fromkeys(_name_on(base, obj, name) for obj, name in rows))


def _name_on(base: Any, obj: Any, name: str) -> str:
    """Return what a face ``name`` of an object is called on ``base``: the same, or as it is counted there, of
    a solid in a part."""
    if not _FACE.fullmatch(name):
        text = say("{name} is no face: select faces of {label}.", name=name or obj.Label, label=base.Label)
        raise SelectionError(text, name or obj.Label)
    found = name if _tip(obj) is _tip(base) else _same_face(base, obj, name)
    if not found:
        text = say(
            "{name} is a face of {other}: select faces of {label}.",
            name=name,
            other=obj.Label,
            label=base.Label,
        )
        raise SelectionError(text, name)
    return found


def _tip(obj: Any) -> Any:
    """Return the feature whose shape a body has, which FreeCAD copies; any other object itself."""
    return obj.Tip or obj if obj.isDerivedFrom("PartDesign::Body") else obj


def _same_face(base: Any, obj: Any, name: str) -> str:
    """Return the name of that face of an object on ``base``; empty where it is none of its."""
    try:
        face, faces = _face(_shape(obj), name), _shape(base).Faces
    except SelectionError:
        return ""
    alike = (i for i, one in enumerate(faces) if face is not None and one.isPartner(face))
    row = next((i for i in alike if (faces[i].CenterOfMass - face.CenterOfMass).Length < SAME_PLACE), None)
    return "" if row is None else f"Face{row + 1}"


def leaf_of(obj: Any, name: str) -> Any:
    """Return what is meant by an element of a group or a part, as ``Box.Face1``: the object in it. A body
    stands for its features."""
    inner = obj.getSubObject(name, 1) if "." in name and not obj.isDerivedFrom("PartDesign::Body") else None
    return inner or obj


def is_mesh(obj: Any) -> bool:
    """Whether the object is a mesh (a Tessellation is one too)."""
    linked = obj.getLinkedObject()
    return (
        "Mesh" in linked.PropertiesList and linked.getTypeIdOfProperty("Mesh") == "Mesh::PropertyMeshKernel"
    )


def copy_of_mesh(obj: Any) -> Any:
    """Return a copy of the mesh object's facets, standing as they do in the object's holder: 0.3 s for 1M
    facets."""
    linked = obj.getLinkedObject()
    mesh = Mesh.Mesh()
    mesh.read(Stream=io.BytesIO(kernel_of(linked)), Format="BMS")
    mesh.Placement = linked.Placement
    return mesh


def check_mesh(obj: Any) -> Any:
    """Return a copy of the mesh object's facets, to be changed at will. Raises SelectionError for a mesh
    without facets."""
    mesh = copy_of_mesh(obj)
    if not mesh.CountFacets:
        raise empty(obj.Label)
    return mesh


def empty(label: str) -> SelectionError:
    """Return what to say of a mesh without facets."""
    return SelectionError(
        say("{label} is an empty mesh: select a mesh with facets, or a solid.", label=label), label
    )


def solids(obj: Any, faces: Sequence[str] = (), avoid: Sequence[str] = ()) -> tuple[Any, list[int]]:
    """Return the object's solids as one shape in the document's coordinates, and which of its Faces (counted
    from 0) the names of the object's ``faces``, and behind them of those to ``avoid``, mean. Raises
    SelectionError.

    A shape of very many faces is not looked at for being valid: that takes seconds, and the mesher does it.
    """
    shape = _shape(obj)
    if len(shape.Faces) <= CHECKED and not shape.isValid():
        raise invalid(obj.Label)
    found = shape.Solids
    if not found:
        text = say(
            "{label} ({kind}) has no solid: {what}.", label=obj.Label, kind=_kind(obj, shape), what=WHAT
        )
        raise SelectionError(text, obj.Label)
    whole = found[0] if len(found) == 1 else Part.makeCompound(found)
    wanted = [(name, text) for names, text in ((faces, _LOST), (avoid, _LOST_AVOIDED)) for name in names]
    return whole, [_face_row(obj.Label, shape, whole, name, text) for name, text in wanted]


def invalid(label: str) -> SelectionError:
    """Return what to say of a shape that OpenCASCADE calls invalid."""
    text = say(
        "The shape of {label} is invalid, so its mesh would have cracks: repair it (Part workbench: Check "
        "geometry shows where), "
        "or select another solid.", label=label,
    )  # fmt: skip
    return SelectionError(text, label)


def _face_row(label: str, shape: Any, whole: Any, name: str, lost: Template) -> int:
    face = _face(shape, name)
    row = next((i for i, one in enumerate(whole.Faces) if face is not None and one.isSame(face)), None)
    if row is None:
        raise SelectionError(lost.say(label=label, name=name.lstrip(GONE)), name)
    return row


def _face(shape: Any, name: str) -> Any:
    number = int(name[4:]) if _FACE.fullmatch(name) else 0
    return shape.Faces[number - 1] if 0 < number <= len(shape.Faces) else None


def _shape(obj: Any) -> Any:
    """Return the object's shape in the document's coordinates."""
    if obj is None:
        raise SelectionError(
            say("The part was deleted: undo that, or choose another one in the property Base."), None
        )
    shape = Part.getShape(obj)
    if shape.isNull():
        raise SelectionError(
            say("{label} ({typeid}) has no solid: {what}.", label=obj.Label, typeid=obj.TypeId, what=WHAT),
            obj.Label,
        )
    shape.Placement = holder_of(obj).multiply(shape.Placement)
    return shape


def holder_of(obj: Any) -> Any:
    """Return the placement in the document of what holds the object: a part or a body that was moved."""
    if not hasattr(obj, "getGlobalPlacement") or not hasattr(obj, "Placement"):
        return FreeCAD.Placement()
    return obj.getGlobalPlacement().multiply(obj.Placement.inverse())


def _kind(obj: Any, shape: Any) -> str:
    if obj.isDerivedFrom("Sketcher::SketchObject"):
        return "a sketch"
    return {"Compound": "a compound without solids", "Wire": "a wire"}.get(
        shape.ShapeType, f"a {shape.ShapeType.lower()}"
    )
