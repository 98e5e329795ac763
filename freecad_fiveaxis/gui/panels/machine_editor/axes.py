# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axes of a draft: a table of all from the work to the tool, and the fields of the one that is chosen
there."""

from __future__ import annotations

import math
from typing import Any

from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.app.units import angle_text, feed_text, length_text
from freecad_fiveaxis.core.machine.editing import (
    AxisDraft,
    MachineDraft,
    add_axis,
    change_axis,
    free_letters,
    move_axis,
    remove_axis,
)
from freecad_fiveaxis.gui.panels.fields import ChoiceField, Field
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.panels.triple import TripleField
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .boxes import TURNS_A_MINUTE, AccelerationField, DirectionField, OpenField, RateField
from .table import Table, buttons_row, show_items, tool_button

LETTERS = ("X", "Y", "Z", "A", "B", "C")
CHANGES = {
    "axis_letter": "letter", "axis_side": "side", "axis_direction": "direction", "axis_point": "point",
    "axis_low": "low",
    "axis_high": "high", "axis_rate": "max_rate", "axis_acceleration": "max_acceleration",
}  # fmt: skip
"""What each field is of an axis."""


class AxesEditor(QtCore.QObject):
    """``group`` is what to show; ``draft`` the machine as it stands. ``edited`` tells that the user changed
    it."""

    edited = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self.draft: MachineDraft | None = None
        self.filling = False
        self.group = FoldingGroup("axes", translate("FiveAxis", "Axes"), "machine-editor_axes")
        heads = (
            translate("FiveAxis", "Axis"), translate("FiveAxis", "Side"), translate("FiveAxis", "From"),
            translate("FiveAxis", "To"), translate("FiveAxis", "Largest rate"),
        )  # fmt: skip
        self.table = Table("axes_table", translate("FiveAxis", "Axes, from the work to the tool"), heads)
        self.buttons = _buttons()
        self.fields: dict[str, Field] = {field.name: field for field in _fields()}
        self.group.body.add_wide(self.table)
        self.group.body.add_wide(buttons_row(*self.buttons.values()))
        self.rows = {name: self.group.body.add(field) for name, field in self.fields.items()}
        self.reverse = QtWidgets.QPushButton(translate("FiveAxis", "Reverse the direction"))
        self.reverse.setObjectName("axis_reverse")
        self.group.body.add_wide(self.reverse)
        self._connect()

    def _connect(self) -> None:
        for name, field in self.fields.items():
            field.edited.connect(lambda name=name: self._change(name))
        self.table.itemSelectionChanged.connect(self._fill)
        self.reverse.clicked.connect(lambda *_: self._reverse())
        self.buttons["remove"].clicked.connect(lambda *_: self._remove())
        self.buttons["up"].clicked.connect(lambda *_: self._move(-1))
        self.buttons["down"].clicked.connect(lambda *_: self._move(1))
        menu = QtWidgets.QMenu(self.buttons["add"])
        self.additions = {letter: menu.addAction(letter) for letter in LETTERS}
        for letter, action in self.additions.items():
            action.triggered.connect(lambda *_, letter=letter: self._add(letter))
        self.buttons["add"].setMenu(menu)

    @property
    def at(self) -> int:
        """The row of the chosen axis; -1: none."""
        return int(self.table.at())

    @property
    def axis(self) -> AxisDraft | None:
        """The chosen axis."""
        return (
            self.draft.axes[self.at]
            if self.draft is not None and 0 <= self.at < len(self.draft.axes)
            else None
        )

    def show_draft(self, draft: MachineDraft, at: int | None = None) -> None:
        """Show a draft, its axis ``at`` chosen; None: the same row as before."""
        self.draft = draft
        self.table.show_rows([_cells(axis) for axis in draft.axes], at)
        self._fill()

    def _fill(self) -> None:
        """Put the chosen axis into the fields."""
        axis, draft = self.axis, self.draft
        if draft is None:
            return
        self.filling = True
        free = free_letters(draft)
        for letter, action in self.additions.items():
            action.setEnabled(letter in free)
        self.buttons["add"].setEnabled(bool(free))
        self._enable(axis)
        for name, row in self.rows.items():
            for widget in row:
                widget.setVisible(axis is not None and (axis.rotary or name != "axis_point"))
        self.reverse.setVisible(axis is not None)
        if axis is not None:
            self._show(axis)
        self.filling = False
        self.group.show_state(" ".join(draft.letters()))

    def _enable(self, axis: AxisDraft | None) -> None:
        draft = self.draft
        self.buttons["remove"].setEnabled(axis is not None)
        for name, step in (("up", -1), ("down", 1)):
            self.buttons[name].setEnabled(
                axis is not None and draft is not None and move_axis(draft, self.at, step) != draft
            )

    def _show(self, axis: AxisDraft) -> None:
        fields, kind = self.fields, "angle" if axis.rotary else "length"
        others = {one.letter for one in self.draft.axes} - {axis.letter} if self.draft is not None else set()
        kin = LETTERS[3:] if axis.rotary else LETTERS[:3]
        show_items(fields["axis_letter"], [(letter, letter) for letter in kin if letter not in others])
        for name in ("axis_letter", "axis_side", "axis_direction", "axis_point"):
            fields[name].show_value(getattr(axis, CHANGES[name]))
        for name in ("axis_low", "axis_high"):
            fields[name].show_measure(getattr(axis, CHANGES[name]), kind)
        fields["axis_rate"].show_rate(axis.max_rate, axis.rotary)
        fields["axis_acceleration"].show_acceleration(axis.max_acceleration, axis.rotary)

    def _change(self, name: str) -> None:
        axis, draft = self.axis, self.draft
        if self.filling or axis is None or draft is None:
            return
        value: Any = self.fields[name].value()
        value = tuple(value) if isinstance(value, list) else value
        if value == getattr(axis, CHANGES[name]):
            return
        new = change_axis(draft, self.at, **{CHANGES[name]: value})
        letter = value if name == "axis_letter" else axis.letter
        self.draft = new
        if name in ("axis_letter", "axis_side"):
            self.show_draft(new, new.letters().index(letter))
        else:
            self.table.show_cells(self.at, _cells(new.axes[self.at]))
        self.edited.emit()

    def _reverse(self) -> None:
        if self.axis is not None and self.draft is not None:
            x, y, z = self.axis.direction
            self._put(change_axis(self.draft, self.at, direction=(0.0 - x, 0.0 - y, 0.0 - z)), self.at)

    def _remove(self) -> None:
        if self.draft is not None:
            self._put(remove_axis(self.draft, self.at), self.at)

    def _move(self, step: int) -> None:
        if self.draft is not None and self.at >= 0:
            self._put(move_axis(self.draft, self.at, step), self.at + step)

    def _add(self, letter: str) -> None:
        if self.draft is not None:
            new = add_axis(self.draft, letter)
            self._put(new, new.letters().index(letter))

    def _put(self, draft: MachineDraft, at: int) -> None:
        """Put a changed draft, and the axis that is chosen then."""
        self.show_draft(draft, min(at, len(draft.axes) - 1))
        self.edited.emit()


def measure_text(value: float, rotary: bool) -> str:
    """Return a place of an axis, mm or degrees, in the user's units; "none" for a limit that there is not."""
    if math.isinf(value):
        return str(translate("FiveAxis", "none"))
    return angle_text(value) if rotary else length_text(value)


def side_label(side: str) -> str:
    """Return what an axis of that side carries, in a word."""
    return str(translate("FiveAxis", "table") if side == "table" else translate("FiveAxis", "head"))


def _cells(axis: AxisDraft) -> tuple[str, ...]:
    rate = translate("FiveAxis", "not given")
    if axis.max_rate is not None:
        rate = (
            f"{write_number(f'{axis.max_rate:g}')}{TURNS_A_MINUTE}"
            if axis.rotary
            else feed_text(axis.max_rate)
        )
    return (
        axis.letter,
        side_label(axis.side),
        measure_text(axis.low, axis.rotary),
        measure_text(axis.high, axis.rotary),
        rate,
    )


def _buttons() -> dict[str, Any]:
    add = tool_button("axis_add", translate("FiveAxis", "Add"), translate("FiveAxis", "Add an axis"))
    add.setPopupMode(QtWidgets.QToolButton.InstantPopup)
    return {
        "add": add,
        "remove": tool_button("axis_remove", translate("FiveAxis", "Remove"),
            translate("FiveAxis", "Remove the chosen axis")),
        "up": tool_button(
            "axis_up", "↑", translate("FiveAxis", "Nearer to the work, past its neighbour on the same side")
        ),
        "down": tool_button(
            "axis_down", "↓", translate("FiveAxis", "Nearer to the tool, past its neighbour on the same side")
        ),
    }  # fmt: skip


def _fields() -> list[Field]:
    none = translate("FiveAxis", "none")
    limit = translate("FiveAxis", "The axis's own limit, as its machine coordinates count; empty: none")
    sides = [
        ("table", translate("FiveAxis", "the work (table)")),
        ("head", translate("FiveAxis", "the tool (head)")),
    ]
    return [
        ChoiceField("axis_letter", [], translate("FiveAxis", "X, Y and Z are linear, A, B and C rotary")),
        ChoiceField("axis_side", sides, translate("FiveAxis", "What the axis moves")),
        DirectionField("axis_direction", translate(
            "FiveAxis",
            "Along or about which a positive word moves the tool relative to the work (ISO 841)")),
        TripleField("axis_point", "point", translate(
            "FiveAxis", "Any point of the rotary axis's line in machine coordinates, with all axes at zero")),
        OpenField("axis_low", none, -math.inf, limit),
        OpenField("axis_high", none, math.inf, limit),
        RateField("axis_rate", translate("FiveAxis", "The largest rate that the drive reaches")),
        AccelerationField("axis_acceleration", translate(
            "FiveAxis", "What the drive reaches; it is kept in the file, nothing reckons with it")),
    ]  # fmt: skip
