# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of the fixtures: which solids and meshes of the document hold the part."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .fields import Field

ROWS = 4
"""So many are seen at once; the list scrolls."""


class FixturesField(Field):
    """A list of the solids and meshes of ``doc`` but for the part that is milled (``part``), each to be
    ticked; ``hint`` as the property's help says."""

    def __init__(self, doc: Any, part: Any, hint: str) -> None:
        from freecad_fiveaxis.app import compared

        super().__init__("fixtures", QtWidgets.QListWidget(), hint)
        self.doc = doc
        for one in compared.parts_of(doc):
            if one is not part:
                self._add(one)
        if self.editor.count() == 0:
            self.show_note(translate("FiveAxis", "There is no other solid in the document."))
        self.editor.setMaximumHeight(
            self.editor.fontMetrics().height() * 3 // 2 * min(max(self.editor.count(), 1), ROWS) + 6
        )
        self.editor.itemChanged.connect(self._on_change)

    def _add(self, one: Any) -> None:
        item = QtWidgets.QListWidgetItem(one.Label)
        item.setData(QtCore.Qt.UserRole, one.Name)
        item.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable | QtCore.Qt.ItemIsSelectable)
        item.setCheckState(QtCore.Qt.Unchecked)
        self.editor.addItem(item)

    def _find_ticked(self) -> list[Any]:
        items = [self.editor.item(row) for row in range(self.editor.count())]
        return [one for one in items if one.checkState() == QtCore.Qt.Checked]

    def value(self) -> list[Any]:
        """Return the objects that are ticked and still there."""
        found = [self.doc.getObject(one.data(QtCore.Qt.UserRole)) for one in self._find_ticked()]
        return [one for one in found if one is not None]

    def words(self) -> str:
        """Their labels."""
        return ", ".join(one.text() for one in self._find_ticked())

    def show_value(self, value: Sequence[Any] | None) -> None:
        """Tick these objects and no others."""
        names = {one.Name for one in value or ()}
        for row in range(self.editor.count()):
            item = self.editor.item(row)
            item.setCheckState(
                QtCore.Qt.Checked if item.data(QtCore.Qt.UserRole) in names else QtCore.Qt.Unchecked
            )
