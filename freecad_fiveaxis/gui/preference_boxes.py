# SPDX-License-Identifier: LGPL-2.1-or-later
"""The number boxes of the page of preferences: ours, in the places of those that the form has.

FreeCAD's own box of a length or an angle ends the whole program over a text as ``45 deg 30'``, and Qt's read
1/2 as 12.
"""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.app import preferences, wording

from .panels.lines import error_line
from .panels.measure_box import MeasureBox
from .panels.typed_box import TypedBox
from .qt import QtWidgets

ANGLES = ("CutterTaper",)
"""The boxes of the form that hold an angle; FreeCAD's own others hold lengths."""
COUNTS, NUMBERS = ("Processes",), ("Processes", "Feed")
"""Qt's boxes of the form: of whole numbers, and all."""


class PreferenceBoxes:
    """``by_key``: the boxes by the parameters that they show."""

    def __init__(self, form: Any) -> None:
        self.by_key: dict[str, TypedBox] = {}
        for key, default in preferences.DEFAULTS.items():
            if key in NUMBERS or isinstance(default, float):
                self.by_key[key] = _replace(form.findChild(QtWidgets.QWidget, key), key)
        self.error = error_line("preferences_error")
        form.layout().insertWidget(form.layout().count() - 1, self.error)
        for box in self.by_key.values():
            box.refusal_changed.connect(self._tell)

    def refusal(self) -> str:
        """Return why what was typed cannot be read, in the user's language; nothing where it can."""
        reasons = [box.reason for box in self.by_key.values() if box.reason]
        return wording.localize(reasons[0]) if reasons else ""

    def _tell(self) -> None:
        self.error.setText(self.refusal())
        self.error.setVisible(bool(self.refusal()))


def read_box(box: TypedBox) -> float:
    """Return what a box holds, mm, degrees or a number."""
    return box.read_measure() if isinstance(box, MeasureBox) else float(box.value())


def show_in_box(box: TypedBox, value: float) -> None:
    """Show mm, degrees or a number."""
    if isinstance(box, MeasureBox):
        box.show_measured(value)
    else:
        box.show_number(value)


def _replace(old: Any, name: str) -> TypedBox:
    """Put a box of ours in the place of one, under its name."""
    new, whole = _box_like(old, name), old.parentWidget()
    whole.layout().replaceWidget(old, new)
    for label in whole.findChildren(QtWidgets.QLabel):
        if label.buddy() is old or (label.buddy() is not None and label.buddy().objectName() == name):
            label.setBuddy(new)
    old.setObjectName("")
    old.hide()
    old.deleteLater()
    new.setObjectName(name)
    new.setToolTip(old.toolTip())
    return new


def _box_like(old: Any, name: str) -> TypedBox:
    """Return a box of ours with the range of one of the form."""
    low, high = float(old.property("minimum")), float(old.property("maximum"))
    if name not in NUMBERS:
        box = MeasureBox("angle" if name in ANGLES else "length")
        box.setRange(low / box.factor, high / box.factor)
        return box
    number = TypedBox("whole" if name in COUNTS else "feed", (0, 0) if name in COUNTS else (1, 4))
    number.unset = str(old.property("specialValueText"))
    number.setSingleStep(float(old.property("singleStep")))
    number.setRange(low, high)
    return number
