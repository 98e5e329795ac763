# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids and meshes of the document that have many facets, drawn from coarser copies while the picture moves:
the part, what holds it, and whatever else stands about.

shape   the node by which FreeCAD draws the facets of one object; the very facets that it draws are reduced,
        so that the copy is of what is seen at rest. It takes the shape's place in its group: the object's
        colour, placement, edges and visibility are as they were.

A copy is made while the window is idle, and in a thread: reading piece by piece, for pivy makes an object of
each point. Until it is there, and where it would not be the same picture (faces of several colours), the
shape itself is drawn.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Generator, Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.geometry.reduced import SMALL, Reduced, reduce_facets, share_facets
from freecad_fiveaxis.core.geometry.shading import Shaded
from freecad_fiveaxis.gui.qt import QtCore
from freecad_fiveaxis.gui.scene import nodes

from .solids import blend_in_order, face_node, light

KINDS = ("SoBrepFaceSet", "SoFCIndexedFaceSet", "BrepFaceSet", "FCIndexedFaceSet")
"""What FreeCAD draws solids and meshes by; Coin leaves out the So of some."""
BUDGET = 20_000
"""Facets of all shapes together that are drawn while they move, but for small ones."""
POINTS, CORNERS = 10_000, 100_000
"""That are read at once: 20 ms."""
WAIT = 5
"""ms between two pieces, in which the window goes on."""

Steps = Generator[None, None, Any]


class ReducedShape:
    """A ``face`` node in its ``group``, with the node of its points; ``copy`` and ``node``: what is drawn in
    its place, None until that is made; ``tried``: whether that was begun; ``stale``: whether its facets are
    others since."""

    def __init__(self, group: Any, face: Any, place: Any) -> None:
        self.group, self.face, self.place = group, face, place
        for one in (group, face, place):
            one.ref()
        self.copy: Reduced | None = None
        self.node: Any = None
        self.tried = self.stale = False
        self._sensors = [_watch(field, self._change) for field in (face.coordIndex, place.point)]

    @property
    def count(self) -> int:
        """How many facets are drawn at rest."""
        return int(self.face.coordIndex.getNum()) // 4

    @property
    def reduced(self) -> bool:
        """Whether the copy is drawn."""
        return self.node is not None and self.group.findChild(self.node) >= 0

    def show(self, moving: bool) -> None:
        """Draw the copy while it moves, where there is one, and else the shape."""
        if self.node is None or (moving and not self.stale) == self.reduced:
            return
        old, new = (self.node, self.face) if self.reduced else (self.face, self.node)
        if self.group.findChild(old) >= 0:
            self.group.replaceChild(old, new)

    def take(self, found: tuple[Reduced, Shaded] | None) -> None:
        """Take the copy that was made, and its lit facets."""
        if found is not None and not self.stale:
            self.copy = found[0]
            self.node = nodes.separate(nodes.unpickable(), blend_in_order(), face_node(found[1]))
            self.node.ref()

    def release(self) -> None:
        """Draw the shape again, for good."""
        self.show(False)
        for sensor in self._sensors:
            sensor.detach()
        for one in (self.group, self.face, self.place, *([] if self.node is None else [self.node])):
            one.unref()
        self.node = None

    def _change(self, *_: Any) -> None:
        self.stale = True
        self.show(False)


class DocumentCopies:
    """The large shapes below the ``graph`` of a 3D view; ``beside``: facets of what else is drawn in many."""

    def __init__(self, graph: Any, beside: Sequence[int] = ()) -> None:
        self._graph, self._beside, self._moving = graph, list(beside), False
        self.shapes: list[ReducedShape] = []
        self._work: Steps | None = None
        self._timer = QtCore.QTimer()
        self._timer.setInterval(WAIT)
        self._timer.timeout.connect(self._go_on)
        self._look()

    @property
    def busy(self) -> bool:
        """Whether copies are being made."""
        return self._work is not None

    @property
    def counts(self) -> list[int]:
        """How many facets each shape has."""
        return [one.count for one in self.shapes]

    def show(self, moving: bool) -> None:
        """Draw copies while the picture moves; what is there anew is looked for when it begins to."""
        if moving and not self._moving:
            self._look()
        self._moving = moving
        if self._work is None and not all(one.tried for one in self.shapes):
            self._work = self._make_copies()
            self._timer.start()
        for one in self.shapes:
            one.show(moving)

    def remove(self) -> None:
        """Draw all as FreeCAD does, for good."""
        self._timer.stop()
        self._work = None
        while self.shapes:
            self.shapes.pop().release()

    def _look(self) -> None:
        """Find the shapes that are seen, and leave those that have changed, to be found anew."""
        for one in [one for one in self.shapes if one.stale]:
            self.shapes.remove(one)
            one.release()
        known = {_address(one.face) for one in self.shapes}
        found = _find_shapes(self._graph)
        self.shapes += [ReducedShape(*one) for one in found if _address(one[1]) not in known]

    def _go_on(self) -> None:
        try:
            if self._work is not None:
                next(self._work)
        except StopIteration:
            self._timer.stop()
            self._work = None

    def _make_copies(self) -> Steps:
        """Make what is missing, piece by piece."""
        while waiting := [one for one in self.shapes if not one.tried]:
            one = waiting[0]
            one.tried = True
            most = share_facets([*self.counts, *self._beside], BUDGET)[self.shapes.index(one)]
            one.take((yield from _make_copy(one, most)))


def _make_copy(shape: ReducedShape, most: int) -> Generator[None, None, tuple[Reduced, Shaded] | None]:
    place, index = coin.SoMFVec3f(), coin.SoMFInt32()
    place.copyFrom(shape.place.point)  # both at once: the shape may change, or go, before they are read
    index.copyFrom(shape.face.coordIndex)
    points = yield from _read(place, POINTS, _to_points)
    corners = yield from _read(index, CORNERS, _to_numbers)
    found: list[tuple[Reduced, Shaded]] = []
    thread = threading.Thread(target=_reduce, args=(points, corners, most, found), daemon=True)
    thread.start()
    while thread.is_alive():
        yield
    return found[0] if found else None


def _reduce(points: np.ndarray, corners: np.ndarray, most: int, found: list[tuple[Reduced, Shaded]]) -> None:
    """Put the copy into ``found``, where there is one: of points (v, 3) and corners, -1 after each facet."""
    rows = corners[: len(corners) // 4 * 4].reshape(-1, 4)
    if len(rows) * 4 != len(corners) or (rows[:, 3] != -1).any() or not _are_rows(rows[:, :3], len(points)):
        return
    try:
        copy = reduce_facets(points, rows[:, :3].astype(np.int64), most)
    except FiveAxisError:
        return
    if copy is not None:
        found.append((copy, light(copy.mesh, outward=True)))


def _are_rows(rows: np.ndarray, count: int) -> bool:
    return bool(len(rows) and rows.min() >= 0 and rows.max() < count)


def _read(rest: Any, each: int, convert: Callable[[Any], np.ndarray]) -> Steps:
    """Return the values of a field, and empty it: Coin gives those from a row to the last one, so that it is
    read from its end and cut off."""
    parts = [convert([])]
    for start in reversed(range(0, int(rest.getNum()), each)):
        parts.append(convert(rest.getValues(start)))
        rest.setNum(start)
        yield
    return np.concatenate(parts[::-1])


def _to_points(values: Any) -> np.ndarray:
    return np.array([one.getValue() for one in values], float).reshape(-1, 3)


def _to_numbers(values: Any) -> np.ndarray:
    return np.array(values, np.int32)


def _find_shapes(graph: Any) -> list[tuple[Any, Any, Any]]:
    """Return group, face and point nodes of the shapes that are seen, have many facets and one colour."""
    search = coin.SoSearchAction()
    search.setType(coin.SoIndexedFaceSet.getClassTypeId(), True)
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(graph)
    paths, found = search.getPaths(), {}
    for path in (paths[at] for at in range(paths.getLength())):
        face, place = path.getTail(), _find_before(path, "SoCoordinate3")
        large = face.getTypeId().getName().getString() in KINDS and face.coordIndex.getNum() > 4 * SMALL
        if large and place is not None and path.getLength() > 1 and _has_one_colour(path):
            found[_address(face)] = (path.getNodeFromTail(1), face, place)
    return list(found.values())


def _has_one_colour(path: Any) -> bool:
    binding = _find_before(path, "SoMaterialBinding")
    return binding is None or binding.value.getValue() == coin.SoMaterialBinding.OVERALL


def _find_before(path: Any, kind: str) -> Any:
    """Return the node of a kind that holds for the end of a path: the last one before it, or before one of
    the groups that it is in."""
    wanted = getattr(coin, kind).getClassTypeId()
    for at in range(1, path.getLength()):
        group = path.getNodeFromTail(at)
        for row in reversed(range(path.getIndexFromTail(at - 1))):
            if group.getChild(row).getTypeId() == wanted:
                return group.getChild(row)
    return None


def _address(node: Any) -> int:
    return int(node.this)


def _watch(field: Any, changed: Callable[..., None]) -> Any:
    """Return a sensor that tells at once of a change of a field."""
    sensor = coin.SoFieldSensor(changed, None)
    sensor.setPriority(0)
    sensor.attach(field)
    return sensor
