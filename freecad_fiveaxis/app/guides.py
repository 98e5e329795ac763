# SPDX-License-Identifier: LGPL-2.1-or-later
"""What guides the passes, picked from the document: where they begin and end, boundary, centre and axis.

link      an object and the name of a vertex, edge or face of it. It is looked at anew whenever the path is
          computed, so that the passes follow the solid. An option that is linked counts no more by itself.
curve     what an edge becomes, with the edges that go on from it smoothly; of a face its borders. Its chords
          are within CHORD.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import Part

from freecad_fiveaxis.core.base.curve_text import END_OF_LINE
from freecad_fiveaxis.core.base.sentences import Option, say

from . import selection
from .properties import QT_TRANSLATE_NOOP, Property

Link = tuple[Any, str]
"""An object and the name of an element of it."""
LINKS = {
    "from_": Property(
        "PassesFromPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex or edge where the passes begin; empty: as typed"),
    ),
    "to": Property(
        "PassesToPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex or edge where the passes end; empty: as typed"),
    ),
    "pass_centre": Property(
        "PassCentrePicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The vertex, circle or sphere that is the centre of radial "
            "passes; empty: as typed"),
    ),
    "pass_axis": Property(
        "PassAxisPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The edge or round face whose axis the radial passes have; empty: "
            "as typed"),
    ),
    "boundary": Property(
        "BoundaryPicked", "App::PropertyLinkSubGlobal", "Passes",
        QT_TRANSLATE_NOOP("App::Property", "The face, or the closed edges, at which the passes end; empty: "
            "as typed"),
    ),
}  # fmt: skip
PLACES = 12
"""Digits of a picked length or direction."""
CHORD = 0.002
"""mm that the chords of a picked curve may be off it."""
SMOOTH = 1.0
"""deg; edges that meet at less go on from one another."""


def links_of(obj: Any) -> dict[str, Link]:
    """Return the options of a Toolpath that are picked, each with its link."""
    held = {option: getattr(obj, one.name, None) for option, one in LINKS.items()}
    return {
        option: (link[0], link[1][0].lstrip(selection.GONE))
        for option, link in held.items()
        if link and link[1]
    }


def put(obj: Any, links: Mapping[str, Link]) -> None:
    """Link these options of a Toolpath and no others."""
    for option, one in LINKS.items():
        if links.get(option) != links_of(obj).get(option):
            link = links.get(option)
            setattr(obj, one.name, (link[0], [link[1]]) if link else None)


def options_of(links: Mapping[str, Link], work_zero: Sequence[float]) -> dict[str, Any]:
    """Return what the links say now, as options; places about the ``work_zero`` (mm, document). Raises
    SelectionError."""
    found: dict[str, Any] = {}
    for option, (obj, name) in links.items():
        read = _READERS[option](obj, name)
        found[option] = read if option == "pass_axis" else _text_of(read, work_zero)
    return found


def _text_of(curves: list[list[Any]], zero: Sequence[float]) -> str:
    """Curves of points as an option has them: one point, or lines, about the ``zero``."""
    lines = [[[at - off for at, off in zip(point, zero, strict=True)] for point in one] for one in curves]
    text = [[",".join(f"{at:.{PLACES}g}" for at in point) for point in one] for one in lines]
    return (END_OF_LINE + END_OF_LINE).join(END_OF_LINE.join(one) for one in text)


def name_of(link: Link) -> str:
    """Return what a link is called."""
    return say("{name} of {label}", name=link[1], label=link[0].Label)


def _shape(obj: Any) -> Any:
    """Return the shape of an object in the document's coordinates."""
    shape = Part.getShape(obj)
    if not shape.isNull():
        shape.Placement = selection.holder_of(obj).multiply(shape.Placement)
    return shape


def _element(obj: Any, name: str, option: str, shape: Any = None) -> Any:
    """Return the vertex, edge or face of an object, in the document's coordinates. Raises SelectionError
    where it is gone."""
    shape = _shape(obj) if shape is None else shape
    if not shape.isNull():
        kind, number = name.rstrip("0123456789"), name[len(name.rstrip("0123456789")) :]
        there = {"Vertex": shape.Vertexes, "Edge": shape.Edges, "Face": shape.Faces}.get(kind, [])
        if number and 0 < int(number) <= len(there):
            return there[int(number) - 1]
    text = say(
        "{label} has no {name}, which was picked: pick {option} anew.", label=obj.Label, name=name or "?",
        option=Option(option, flag=False),
    )  # fmt: skip
    raise selection.SelectionError(text, name)


def _guide(obj: Any, name: str, option: str) -> list[list[Any]]:
    """Return the point that a vertex is, or the points of an edge and of those that go on from it smoothly;
    mm, document."""
    shape = _shape(obj)
    element = _element(obj, name, option, shape)
    if element.ShapeType == "Vertex":
        return [[element.Point]]
    if element.ShapeType == "Edge" and not element.Degenerated:
        return [_points(_smooth_chain(shape, element))]
    text = say(
        "{name} of {label} is no vertex or edge: pick one, or name a CSV file of a curve.",
        name=name,
        label=obj.Label,
    )
    raise selection.SelectionError(text, name)


def _boundary(obj: Any, name: str) -> list[list[Any]]:
    """Return the borders of a face; of an edge the closed wire it is in that is widest from above; mm,
    document."""
    shape = _shape(obj)
    element = _element(obj, name, "boundary", shape)
    if element.ShapeType == "Face":
        return [_points(wire.OrderedEdges) for wire in element.Wires]
    if element.ShapeType == "Edge":
        around = [
            _points(wire.OrderedEdges) for wire in shape.Wires if wire.isClosed() and _holds(wire, element)
        ]
        if around:
            return [max(around, key=_area_from_above)]
    text = say(
        "{name} of {label} bounds nothing: pick a face, or an edge of a closed wire.",
        name=name,
        label=obj.Label,
    )
    raise selection.SelectionError(text, name)


def _holds(wire: Any, edge: Any) -> bool:
    return any(one.isSame(edge) for one in wire.Edges)


def _area_from_above(curve: list[Any]) -> float:
    return abs(float(sum(one.x * other.y - one.y * other.x for one, other in itertools.pairwise(curve))))


def _smooth_chain(shape: Any, edge: Any) -> list[Any]:
    """Return the edge, and the edges of the shape before and after it that go on without a corner, one at
    each end."""
    chain = [edge]
    for at_end in (True, False):
        while (found := _next(shape, chain, at_end)) is not None:
            chain = [*chain, found] if at_end else [found, *chain]
    in_order: list[Any] = Part.__sortEdges__(chain)
    return in_order


def _next(shape: Any, chain: list[Any], at_end: bool) -> Any:
    """Return the one edge that goes on from the end, or the beginning, of a chain; None where there is none,
    or a choice."""
    edge, before = (chain[-1], chain[-2:-1]) if at_end else (chain[0], chain[1:2])
    ends = [
        one
        for one in edge.Vertexes
        if not any(one.isSame(other) for last in before for other in last.Vertexes)
    ]
    if edge.isClosed() or not ends:
        return None
    end = ends[-1] if at_end else ends[0]
    others = [one for one in shape.ancestorsOfType(end, Part.Edge) if not one.Degenerated]
    others = [one for one in others if not any(one.isSame(own) for own in chain)]
    smooth = [
        one for one in others if _way_from(one, end).getAngle(-_way_from(edge, end)) < math.radians(SMOOTH)
    ]
    return smooth[0] if len(smooth) == 1 else None


def _way_from(edge: Any, vertex: Any) -> Any:
    """Return the direction in which an edge leaves a vertex of it."""
    begins = edge.valueAt(edge.FirstParameter).distanceToPoint(vertex.Point) < edge.valueAt(
        edge.LastParameter
    ).distanceToPoint(vertex.Point)
    return edge.tangentAt(edge.FirstParameter) if begins else -edge.tangentAt(edge.LastParameter)


def _points(edges: Sequence[Any]) -> list[Any]:
    """Points along edges that follow one another, each but once; of closed ones the first again at the
    end."""
    runs = [edge.discretize(Deflection=CHORD) for edge in edges]
    if len(runs) > 1 and _gap(runs[0][-1], runs[1]) > _gap(runs[0][0], runs[1]):
        runs[0].reverse()
    found: list[Any] = runs[0]
    for run in runs[1:]:
        found += (
            run[1:]
            if found[-1].distanceToPoint(run[0]) <= found[-1].distanceToPoint(run[-1])
            else run[-2::-1]
        )
    return found


def _gap(point: Any, run: list[Any]) -> float:
    """How far a point is from the nearer end of a run."""
    return float(min(point.distanceToPoint(run[0]), point.distanceToPoint(run[-1])))


def _centre(obj: Any, name: str) -> list[list[Any]]:
    """Return the point that an element means, mm, document."""
    element = _element(obj, name, "pass_centre")
    point = getattr(element, "Point", None)
    if point is None and _kind(element) in ("Part::GeomCircle", "Part::GeomSphere"):
        point = _geometry(element).Center
    if point is None:
        text = say(
            "{name} of {label} has no centre: pick a vertex, a circle or a sphere.",
            name=name,
            label=obj.Label,
        )
        raise selection.SelectionError(text, name)
    return [[point]]


def _axis(obj: Any, name: str) -> tuple[float, float, float]:
    """Return the direction of an element's axis, document, that looks up."""
    element = _element(obj, name, "pass_axis")
    kind, along = _kind(element), None
    if kind in ("Part::GeomLine", "Part::GeomLineSegment"):
        ends = [one.Point for one in element.Vertexes]
        along = (ends[-1] - ends[0]).normalize() if len(ends) == 2 else element.Curve.Direction
    elif kind in ("Part::GeomCircle", "Part::GeomCylinder", "Part::GeomCone"):
        along = _geometry(element).Axis
    if along is None:
        text = say(
            "{name} of {label} has no axis: pick a straight or circular edge, or a cylindrical or conical "
            "face.", name=name,
            label=obj.Label,
        )  # fmt: skip
        raise selection.SelectionError(text, name)
    x, y, z = (round(part, PLACES) + 0.0 for part in along)
    sense = -1.0 if (z, y, x) < (0.0, 0.0, 0.0) else 1.0  # an edge, or a face, has none that anybody sees: up
    return sense * x + 0.0, sense * y + 0.0, sense * z + 0.0


def _geometry(element: Any) -> Any:
    """Return the curve of an edge, the surface of a face; None of a vertex."""
    name = {"Face": "Surface", "Edge": "Curve"}.get(element.ShapeType, "")
    try:
        return getattr(element, name, None)
    except TypeError:  # a seam without length, as at the pole of a sphere
        return None


def _kind(element: Any) -> str:
    return getattr(_geometry(element), "TypeId", "")


_READERS: dict[str, Callable[[Any, str], Any]] = {
    "from_": partial(_guide, option="from_"), "to": partial(_guide, option="to"), "boundary": _boundary,
    "pass_centre": _centre,
    "pass_axis": _axis,
}  # fmt: skip
