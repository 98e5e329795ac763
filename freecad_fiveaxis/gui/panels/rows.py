# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a form that is as narrow as its panel: label and editor side by side where both have room, else the
label above.

FreeCAD 1.1 lays its task panel over the view, about 330 pixels wide, and 0.20's is 260 at first: nothing may
be cut there in any language.
"""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtWidgets

from .fields import LINES, Field

SHARE = 0.42
"""Of the width that the labels get, where the editors stand beside them."""
GAP, INDENT = 6, 6
"""Pixels between label and editor, and left of both."""
BUTTON = 28
"""Pixels of the button beside an editor."""
LEAST = 190
"""Pixels of the rows in the narrowest panel."""


class Rows(QtWidgets.QWidget):
    """Fields below each other, placed anew whenever the width changes."""

    def __init__(self, indent: int = INDENT) -> None:
        super().__init__()
        self.resize(
            LEAST, 0
        )  # as narrow as it may get, until a layout says otherwise: labels above need least
        self.rows: list[Row] = []
        self.grid = QtWidgets.QGridLayout(self)
        self.grid.setContentsMargins(indent, 0, 0, 3 if indent else 0)
        self.grid.setHorizontalSpacing(GAP)
        self.grid.setVerticalSpacing(2)
        for column, share in enumerate(
            (SHARE, 1.0 - SHARE)
        ):  # so that the editors of all groups stand below each other
            self.grid.setColumnStretch(column, round(100 * share))

    def add(self, field: Field) -> list[Any]:
        """Return a row of the field; returns the widgets that are hidden with it."""
        row = Row(field, self._next())
        self.rows.append(row)
        for kind, line in field.lines.items():
            row.place_line(self.grid, kind, line)
        field.place_line = lambda kind, line: row.place_line(self.grid, kind, line)
        row.place(self.grid, self._label_room(), self._editor_room())
        return row.widgets

    def add_wide(self, widget: Any) -> None:
        """Add a row of one widget."""
        self.grid.addWidget(widget, self._next(), 0, 1, 3)

    def _next(self) -> int:
        """Return the first line of the grid after the last field and its lines, which may still come."""
        return max([self.grid.rowCount(), *(row.at + 2 + len(LINES) for row in self.rows[-1:])])

    def resizeEvent(self, event: Any) -> None:
        """Labels go beside the editors where there is room now, or above them."""
        super().resizeEvent(event)
        for row in self.rows:
            row.place(self.grid, self._label_room(), self._editor_room())

    def _label_room(self) -> int:
        return int(SHARE * self.width())

    def _editor_room(self) -> int:
        return self.width() - self._label_room() - GAP - self.grid.contentsMargins().left()


class Row:
    """A field in two lines of a grid, from ``at`` on: label and editor in the second one, or the label in the
    first."""

    def __init__(self, field: Field, at: int) -> None:
        self.field, self.at = field, at
        self.browse = getattr(field, "browse", None)
        self.label = None if field.has_own_labels else _label(field)
        self.widgets = [one for one in (self.label, field.editor, self.browse) if one is not None]
        self.above: bool | None = None

    def place_line(self, grid: Any, kind: str, line: Any) -> None:
        """Put the field's line of that kind under its editor."""
        grid.addWidget(line, self.at + 2 + list(LINES).index(kind), 0, 1, 3)

    def place(self, grid: Any, label_room: int, editor_room: int) -> None:
        """Put the widgets where they have room (pixels); nothing is done to a row that stays as it is."""
        editor_needs = self.field.room() + (BUTTON if self.browse else 0)
        above = self.label is None or _width(self.label) > label_room or editor_needs > editor_room
        if self.above == above:
            return
        self.above = above
        for widget in self.widgets:
            grid.removeWidget(widget)
        if self.label is not None:
            self.label.setWordWrap(above)  # beside its editor it has room for all of it
            grid.addWidget(self.label, self.at + (not above), 0, 1, 3 if above else 1)
        first = 0 if above else 1
        grid.addWidget(self.field.editor, self.at + 1, first, 1, (2 if self.browse else 3) - first)
        if self.browse:
            grid.addWidget(self.browse, self.at + 1, 2)


def _width(label: Any) -> int:
    """Pixels of a label's text in one line."""
    return int(label.fontMetrics().boundingRect(label.text()).width()) + 2


def _label(field: Field) -> Any:
    label = QtWidgets.QLabel(field.label)
    label.setBuddy(field.focus_widget())
    label.setToolTip(field.editor.toolTip())
    return label
