# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small table whose rows are chosen, and the buttons below it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.gui.panels.wrapping import WrappingRow
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets

ROWS = 6
"""As many are seen at most before the table scrolls."""


class Table(QtWidgets.QTableWidget):
    """Rows of texts, of which one is chosen; nothing is edited in it."""

    def __init__(self, name: str, label: str, heads: Sequence[str]) -> None:
        super().__init__(0, len(heads))
        self.setObjectName(name)
        self.setAccessibleName(label)
        self.setHorizontalHeaderLabels(list(heads))
        self.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        self.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        self.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.horizontalHeader().setStretchLastSection(True)

    def at(self) -> int:
        """Return the chosen row; -1: none."""
        return int(self.currentRow())

    def show_rows(self, rows: Sequence[Sequence[str]], at: int | None = None) -> None:
        """Show these rows, ``at`` chosen; None: the one that is."""
        self.blockSignals(True)
        at = self.at() if at is None else at
        self.setRowCount(len(rows))
        for row, cells in enumerate(rows):
            self._write(row, cells)
        chosen = min(max(at, 0), len(rows) - 1)
        if chosen >= 0:
            self.setCurrentCell(chosen, 0)
            self.selectRow(chosen)
        self._fit()
        self.blockSignals(False)

    def show_cells(self, row: int, cells: Sequence[str]) -> None:
        """Show other texts in a row."""
        self.blockSignals(True)
        self._write(row, cells)
        self._fit()
        self.blockSignals(False)

    def _write(self, row: int, cells: Sequence[str]) -> None:
        model = self.model()
        for column, cell in enumerate(cells):
            model.setData(model.index(row, column), cell, QtCore.Qt.DisplayRole)

    def _fit(self) -> None:
        self.resizeColumnsToContents()
        shown = min(max(self.rowCount(), 1), ROWS)
        height = (
            self.horizontalHeader().sizeHint().height() + shown * self.verticalHeader().defaultSectionSize()
        )
        self.setFixedHeight(height + self.horizontalScrollBar().sizeHint().height() + 2 * self.frameWidth())


def tool_button(name: str, text: str, hint: str) -> Any:
    """Return a button of a few letters."""
    button = QtWidgets.QToolButton()
    button.setObjectName(name)
    button.setText(text)
    button.setToolTip(hint)
    button.setAccessibleName(hint)
    return button


def buttons_row(*buttons: Any) -> Any:
    """Return a widget with the buttons beside each other, as far as they have room."""
    return WrappingRow(buttons)


def show_items(field: Any, items: Sequence[tuple[str, str]]) -> None:
    """Give a ChoiceField these items, value and text, and no others; whoever calls shows the value, and hears
    of it himself."""
    field.editor.clear()
    for value, text in items:
        field.editor.addItem(text, value)
