# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of three numbers: a point, a direction, lengths, counts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets

from .fields import ARROW, Field, NumberField, QuantityField, width_of

WIDE = 1000
"""Pixels of an editor that never stands beside its label."""
FIRST, LAST = 1, 4
"""Lines of the grid: of the first box, and of what stands below all of them."""


class Wide(QtWidgets.QWidget):
    """A widget that tells when its width has changed."""

    widened = QtCore.Signal()

    def resizeEvent(self, event: Any) -> None:
        """Qt calls this whenever the size has changed."""
        super().resizeEvent(event)
        self.widened.emit()


class TripleField(Field):
    """Three lengths (mm), three numbers, or three counts, beside each other where they have room, else below
    each other.

    ``none_text``: what a box says that, ticked, gives None, and hides the three; ``width``: what each needs
    at least, pixels.
    """

    def __init__(self, name: str, kind: str, hint: str = "", none_text: str = "", width: int = 60) -> None:
        super().__init__(name, Wide(), hint)
        parts = [f"{name}_{letter}" for letter in "xyz"]
        makers: dict[str, Callable[[str], Field]] = {
            "point": lambda part: QuantityField(part, "length"),
            "counts": lambda part: NumberField(part, whole=True),
        }
        self.parts = [makers.get(kind, RatioField)(part) for part in parts]
        for part, letter in zip(self.parts, "XYZ", strict=True):
            part.editor.setAccessibleName(f"{self.label} {letter}")
            part.nest()
        self.none = QtWidgets.QCheckBox(none_text) if none_text else None
        self.width = width
        self._lay_out()
        for part in self.parts:
            part.edited.connect(self._on_change)

    def _lay_out(self) -> None:
        self.row = QtWidgets.QGridLayout(self.editor)
        self.row.setContentsMargins(0, 0, 0, 0)
        self.below: bool | None = None
        self.place()
        self.editor.widened.connect(self.place)
        if self.none:
            self.row.addWidget(self.none, 0, 0, 1, 3, QtCore.Qt.AlignLeft)
            self.none.toggled.connect(self._on_toggle)

    def place(self) -> None:
        """Put the boxes where what they say has room; nothing is done where they stand so already."""
        needed = sum(self._needs(part) for part in self.parts) + 2 * max(self.row.horizontalSpacing(), 0)
        below = needed > self.editor.width()
        if below == self.below:
            return
        self.below = below
        for at, part in enumerate(self.parts):
            self.row.removeWidget(part.editor)
            row, column, span = (FIRST + at, 0, 3) if below else (FIRST, at, 1)
            self.row.addWidget(part.editor, row, column, 1, span)

    def _needs(self, part: Any) -> int:
        """Pixels of one box."""
        return max(self.width, width_of(part.editor, str(part.editor.property("text"))) + ARROW)

    def parts_of(self) -> Sequence[Field]:
        """Return the three, where they are shown."""
        return () if self.none and self.none.isChecked() else self.parts

    def focus_widget(self) -> Any:
        """Return the first box."""
        return self.parts[0].editor

    def room(self) -> int:
        """Three numbers need the whole width, or their digits are cut."""
        return WIDE

    def words(self) -> str:
        """Label and numbers."""
        if self.value() is None:
            return ""
        texts = [str(part.editor.property("text")) for part in self.parts]
        units = {text.partition(" ")[2] for text in texts}
        if len(units) == 1:  # which need not be said three times
            texts[:2] = [text.partition(" ")[0] for text in texts[:2]]
        return f"{self.label} {', '.join(texts)}"

    def _on_toggle(self, ticked: bool) -> None:
        for part in self.parts:
            part.editor.setVisible(not ticked)
        self._on_change()

    def value(self) -> list[float] | None:
        """Three numbers, mm where they are lengths."""
        return None if self.none and self.none.isChecked() else [part.value() for part in self.parts]

    def show_value(self, value: Sequence[float] | None) -> None:
        """Three numbers, or None."""
        if self.none:
            self.none.setChecked(value is None)
        for part, number in zip(self.parts, value or (0.0, 0.0, 0.0), strict=True):
            part.show_value(number)
        self.place()


class RatioField(NumberField):
    """A number of a direction."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.editor.places = (6, 6)
        self.editor.setSuffix("")
        self.editor.setSingleStep(0.1)
