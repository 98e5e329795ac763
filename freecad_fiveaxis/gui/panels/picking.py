# SPDX-License-Identifier: LGPL-2.1-or-later
"""A point picked in the 3D view: a vertex, the centre of a circle, or the spot on a face or mesh that was
clicked.

pick      begins with a button and ends with the first point, with a second press of the button, or with Esc;
          Esc then stops the pick and not the panel.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar
from weakref import WeakSet

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.gui.failures import guards
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, later, translate

from .triple import LAST, TripleField

Point = tuple[float, float, float]


@guards
class Pick:
    """Waits for one point. ``found`` gets it (document coordinates, mm, or what an heir takes instead);
    ``ended`` is called in any case."""

    instances: ClassVar[WeakSet[Pick]] = WeakSet()

    def __init__(self, found: Callable[[Any], None], ended: Callable[[], None]) -> None:
        self.found, self.ended, self.running = found, ended, False
        Pick.instances.add(self)
        self.keys = _Escape(self.stop)

    def start(self) -> None:
        """Listen to the selection from now on."""
        if not self.running:
            self.running = True
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addObserver(self)
            QtWidgets.QApplication.instance().installEventFilter(self.keys)

    def stop(self) -> None:
        """Listen no more."""
        if self.running:
            self.running = False
            FreeCADGui.Selection.removeObserver(self)
            QtWidgets.QApplication.instance().removeEventFilter(self.keys)
            self.ended()

    def addSelection(self, doc: str, name: str, element: str, spot: Point) -> None:
        """FreeCAD calls this when something is selected, with the spot under the mouse."""
        if self.running and element:  # an empty element: chosen in the tree, where there is no spot
            point = point_of(FreeCAD.getDocument(doc).getObject(name), element, spot)
            later(lambda: self._take(point))  # an observer must not go while observers are being called

    def _take(self, point: Any) -> None:
        if self.running:
            self.stop()
            FreeCADGui.Selection.clearSelection()
            self.found(point)


def is_picking() -> bool:
    """Whether what is selected now is taken for a point."""
    return any(one.running for one in Pick.instances)


class _Escape(QtCore.QObject):
    """Takes the Esc key away from the rest of the window."""

    def __init__(self, stop: Callable[[], None]) -> None:
        super().__init__()
        self.stop = stop

    def eventFilter(self, _watched: Any, event: Any) -> bool:
        """Qt calls this before a key arrives anywhere."""
        kind = event.type()
        if (
            kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.ShortcutOverride)
            and event.key() == QtCore.Qt.Key_Escape
        ):
            event.accept()
            if kind == QtCore.QEvent.KeyPress:
                later(self.stop)
            return True
        return False


def point_of(obj: Any, element: str, spot: Point) -> Point:
    """Return the point that a picked element means, document coordinates, mm: ``spot`` unless it is a vertex
    or a circle."""
    shape: Any = obj.getSubObject(element) if hasattr(obj, "getSubObject") else None
    if getattr(shape, "ShapeType", "") == "Vertex":
        return spot_of(shape.Point)
    centre = (
        getattr(getattr(shape, "Curve", None), "Center", None)
        if getattr(shape, "ShapeType", "") == "Edge"
        else None
    )
    return spot_of(spot if centre is None else centre)


def spot_of(vector: Any) -> Point:
    """Return the three numbers of a vector of FreeCAD's."""
    x, y, z = vector
    return x, y, z


class PointField(TripleField):
    """Three coordinates (document coordinates, mm) and a button that picks them in the 3D view."""

    def __init__(self, name: str, hint: str = "", width: int = 60) -> None:
        super().__init__(name, "point", hint, width=width)
        self.button = QtWidgets.QPushButton(translate("FiveAxis", "Pick in the 3D view"))
        self.button.setObjectName(name + "_pick")
        self.button.setCheckable(True)
        self.button.clicked.connect(self._on_press)
        self.row.addWidget(self.button, LAST, 0, 1, 3)
        self.pick = Pick(self._on_find, self._on_end)
        if FreeCADGui.activeDocument() is None:
            self.button.setEnabled(False)
            self.button.setToolTip(
                translate("FiveAxis", "Open a document first: there is nothing to pick from.")
            )

    def _on_press(self, down: bool) -> None:
        if down:
            self.button.setText(translate("FiveAxis", "Click a point, or press Esc"))
            self.pick.start()
        else:
            self.pick.stop()

    def _on_find(self, point: Point) -> None:
        self.show_value(point)
        self.edited.emit()

    def _on_end(self) -> None:
        self.button.setChecked(False)
        self.button.setText(translate("FiveAxis", "Pick in the 3D view"))
