# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of the faces that are left alone: selected in the 3D view, and taken into a list."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCADGui

from freecad_fiveaxis.gui.qt import QtWidgets, translate

from .fields import Field
from .picking import is_picking
from .triple import WIDE

ROWS = 4
"""So many are seen at once; the list scrolls."""


class AvoidField(Field):
    """A list of names of faces of the solid ``base``; one button takes those selected in the 3D view into it,
    another takes rows out. Over a mesh, whose faces have no names, it is idle and says so."""

    def __init__(self, base: Any) -> None:
        hint = translate("App::Property", "Faces of the base that are left alone: they are not milled")
        super().__init__("avoid", QtWidgets.QWidget(), hint)
        self.base = base
        self.list = QtWidgets.QListWidget()
        self.add = QtWidgets.QPushButton(translate("FiveAxis", "Add selected faces"))
        self.remove = QtWidgets.QPushButton(translate("FiveAxis", "Remove"))
        self._lay_out()
        self.add.clicked.connect(lambda *_: self._add())
        self.remove.clicked.connect(lambda *_: self._remove())
        self.list.itemSelectionChanged.connect(self._fit)
        self.list.itemClicked.connect(lambda *_: self._light_up())
        self._say_what_lacks()
        self._fit()

    def _lay_out(self) -> None:
        for widget, name in (
            (self.list, "avoid_list"),
            (self.add, "avoid_add"),
            (self.remove, "avoid_remove"),
        ):
            widget.setObjectName(name)
        self.list.setAccessibleName(self.label)
        self.list.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self.add.setToolTip(
            translate("FiveAxis", "Click faces of the part in the 3D view first, several with Ctrl")
        )
        column = QtWidgets.QVBoxLayout(self.editor)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        for widget in (self.list, self.add, self.remove):
            column.addWidget(widget)

    def _say_what_lacks(self) -> None:
        from freecad_fiveaxis.app.selection import is_mesh

        if self.base is None:
            self.show_note(_explain_deletion())
        elif is_mesh(self.base):
            text = translate(
                "FiveAxis",
                "The faces of a mesh have no names: choose a solid, or {option} on the command line.",
            )
            self.show_note(text.format(option="--avoid"))

    def _fit(self) -> None:
        """Make the list as high as its rows; there is something to remove where a row is chosen."""
        height = self.list.fontMetrics().height() * 3 // 2
        self.list.setFixedHeight(height * min(max(self.list.count(), 1), ROWS) + 6)
        self.remove.setEnabled(bool(self.list.selectedItems()))

    def focus_widget(self) -> Any:
        """Return the list."""
        return self.list

    def room(self) -> int:
        """Return the buttons need the whole width."""
        return WIDE

    def _add(self) -> None:
        """Take the faces that are selected in the 3D view into the list; say what to select where there are
        none."""
        from freecad_fiveaxis.app import selection, wording

        self.show_error("")
        chosen = [(one.Object, one.SubElementNames) for one in FreeCADGui.Selection.getSelectionEx()]
        try:
            found = selection.faces_of(self.base, chosen)
        except (selection.SelectionError, ReferenceError) as error:
            self.show_error(
                _explain_deletion() if isinstance(error, ReferenceError) else wording.localize(error)
            )
            return
        self._take([*self.value(), *(name for name in found if name not in self.value())])

    def _remove(self) -> None:
        gone = {item.text() for item in self.list.selectedItems()}
        self._take([name for name in self.value() if name not in gone])

    def _light_up(self) -> None:
        """Select the faces of the chosen rows in the 3D view: it shows which these are."""
        if is_picking():
            return
        FreeCADGui.Selection.clearSelection()
        try:
            for item in self.list.selectedItems():
                FreeCADGui.Selection.addSelection(self.base.Document.Name, self.base.Name, item.text())
        except (
            ReferenceError,
            RuntimeError,
            ValueError,
        ):  # the part is gone, or that face of it: Calculate says so
            return

    def _take(self, names: Sequence[str]) -> None:
        self.show_value(names)
        self.edited.emit()

    def value(self) -> tuple[str, ...]:
        """Return the names in the list."""
        return tuple(self.list.item(row).text() for row in range(self.list.count()))

    def words(self) -> str:
        """Say that they are left out."""
        return (
            translate("FiveAxis", "without {faces}").format(faces=", ".join(self.value()))
            if self.value()
            else ""
        )

    def show_value(self, value: Sequence[str] | None) -> None:
        """Show these names and no others."""
        self.list.clear()
        self.list.addItems(list(value or ()))
        self._fit()


def _explain_deletion() -> str:
    return translate("FiveAxis", "The part was deleted meanwhile: press Cancel, and select another one.")
