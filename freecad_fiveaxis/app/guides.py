# SPDX-License-Identifier: LGPL-2.1-or-later
"""What leads the passes, picked from the document: where they begin and end, the centre and the axis of radial ones.

link      an object and the name of a vertex, edge or face of it. It is looked at anew whenever the path is computed, so that the
          passes follow the solid. An option that is linked counts no more by itself.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import Part

from freecad_fiveaxis.core.base.sentences import Option, say

from . import selection
from .properties import QT_TRANSLATE_NOOP, Property

Link = tuple[Any, str]
"""An object and the name of an element of it."""
LINKS = {
    "from_": Property(
        "PassesFromPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex where the passes begin; empty: as typed"),
    ),
    "to": Property(
        "PassesToPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex where the passes end; empty: as typed"),
    ),
    "pass_centre": Property(
        "PassCentrePicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex, circle or sphere that is the centre of radial passes; empty: as typed"),
    ),
    "pass_axis": Property(
        "PassAxisPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The edge or round face whose axis the radial passes have; empty: as typed"),
    ),
}  # fmt: skip
PLACES = 12
"""Digits of a picked length or direction."""


def links_of(obj: Any) -> dict[str, Link]:
    """The options of a Toolpath that are picked, each with its link."""
    held = {option: getattr(obj, one.name, None) for option, one in LINKS.items()}
    return {option: (link[0], link[1][0].lstrip(selection.GONE)) for option, link in held.items() if link and link[1]}


def put(obj: Any, links: Mapping[str, Link]) -> None:
    """Link these options of a Toolpath and no others."""
    for option, one in LINKS.items():
        if links.get(option) != links_of(obj).get(option):
            link = links.get(option)
            setattr(obj, one.name, (link[0], [link[1]]) if link else None)


def options_of(links: Mapping[str, Link], work_zero: Sequence[float]) -> dict[str, Any]:
    """What the links say now, as options; places about the ``work_zero`` (mm, document). Raises SelectionError."""
    found: dict[str, Any] = {}
    for option, (obj, name) in links.items():
        read = _READERS[option](obj, name)
        if option != "pass_axis":
            read = ",".join(f"{at - zero:.{PLACES}g}" for at, zero in zip(read, work_zero, strict=True))
        found[option] = read
    return found


def name_of(link: Link) -> str:
    """What a link is called."""
    return say("{name} of {label}", name=link[1], label=link[0].Label)


def _element(obj: Any, name: str, option: str) -> Any:
    """The vertex, edge or face in the document's coordinates. Raises SelectionError where it is gone."""
    shape = Part.getShape(obj)
    if not shape.isNull():
        shape.Placement = selection.holder_of(obj).multiply(shape.Placement)
        kind, number = name.rstrip("0123456789"), name[len(name.rstrip("0123456789")) :]
        there = {"Vertex": shape.Vertexes, "Edge": shape.Edges, "Face": shape.Faces}.get(kind, [])
        if number and 0 < int(number) <= len(there):
            return there[int(number) - 1]
    text = say(
        "{label} has no {name}, which was picked: pick {option} anew.", label=obj.Label, name=name or "?",
        option=Option(option, flag=False),
    )  # fmt: skip
    raise selection.SelectionError(text, name)


def _point(obj: Any, name: str, option: str) -> tuple[float, float, float]:
    """The point that a vertex is, mm, document."""
    point = getattr(_element(obj, name, option), "Point", None)
    if point is None:
        text = say("{name} of {label} is no vertex: pick a vertex, or name a CSV file of a curve.", name=name, label=obj.Label)
        raise selection.SelectionError(text, name)
    return tuple(point)


def _centre(obj: Any, name: str) -> tuple[float, float, float]:
    """The point that an element means, mm, document."""
    element = _element(obj, name, "pass_centre")
    point = getattr(element, "Point", None)
    if point is None and _kind(element) in ("Part::GeomCircle", "Part::GeomSphere"):
        point = _geometry(element).Center
    if point is None:
        text = say("{name} of {label} has no centre: pick a vertex, a circle or a sphere.", name=name, label=obj.Label)
        raise selection.SelectionError(text, name)
    return tuple(point)


def _axis(obj: Any, name: str) -> tuple[float, float, float]:
    """The direction of an element's axis, document, that looks up."""
    element = _element(obj, name, "pass_axis")
    kind, along = _kind(element), None
    if kind in ("Part::GeomLine", "Part::GeomLineSegment"):
        ends = [one.Point for one in element.Vertexes]
        along = (ends[-1] - ends[0]).normalize() if len(ends) == 2 else element.Curve.Direction
    elif kind in ("Part::GeomCircle", "Part::GeomCylinder", "Part::GeomCone"):
        along = _geometry(element).Axis
    if along is None:
        text = say(
            "{name} of {label} has no axis: pick a straight or circular edge, or a cylindrical or conical face.", name=name,
            label=obj.Label,
        )  # fmt: skip
        raise selection.SelectionError(text, name)
    x, y, z = (round(part, PLACES) + 0.0 for part in along)
    sense = -1.0 if (z, y, x) < (0.0, 0.0, 0.0) else 1.0  # an edge, or a face, has none that anybody sees: up
    return sense * x + 0.0, sense * y + 0.0, sense * z + 0.0


def _geometry(element: Any) -> Any:
    """The curve of an edge, the surface of a face; None of a vertex."""
    name = {"Face": "Surface", "Edge": "Curve"}.get(element.ShapeType, "")
    try:
        return getattr(element, name, None)
    except TypeError:  # a seam without length, as at the pole of a sphere
        return None


def _kind(element: Any) -> str:
    return getattr(_geometry(element), "TypeId", "")


_READERS = {
    "from_": partial(_point, option="from_"), "to": partial(_point, option="to"), "pass_centre": _centre, "pass_axis": _axis,
}  # fmt: skip
