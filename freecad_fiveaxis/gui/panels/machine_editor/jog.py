# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slider for each axis of a machine, between its limits, that moves the picture."""

from __future__ import annotations

import math
from typing import Any

from freecad_fiveaxis.core.machine.editing import AxisDraft, MachineDraft
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .axes import LETTERS, measure_text

STEPS = 1000
"""Of a slider from end to end."""
TURN, TRAVEL = 360.0, 500.0
"""Degrees and mm to either side that are shown of an axis without limits."""


class JogSliders(QtCore.QObject):
    """``group`` is what to show; ``joints``: where the axes stand, mm and degrees by their letters. ``moved``
    tells of a move."""

    moved = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self.joints: dict[str, float] = {}
        self.ends: dict[str, tuple[float, float]] = {}
        self.rotary: dict[str, bool] = {}
        self.group = FoldingGroup("jog", translate("FiveAxis", "Move the axes"), "machine-editor_jog")
        self.rows = {letter: _Row(letter) for letter in LETTERS}
        self.zero = QtWidgets.QPushButton(translate("FiveAxis", "All axes to zero"))
        self.zero.setObjectName("jog_zero")
        for letter, row in self.rows.items():
            self.group.body.add_wide(row.widget)
            row.slider.valueChanged.connect(lambda _, letter=letter: self._slide(letter))
        self.group.body.add_wide(self.zero)
        self.zero.clicked.connect(lambda *_: self._to_zero())

    def show_draft(self, draft: MachineDraft) -> None:
        """Sliders for the axes of a draft; an axis stays where it is as far as its limits allow."""
        known = {axis.letter: axis for axis in draft.axes}
        self.ends = {letter: _ends(axis) for letter, axis in known.items()}
        self.rotary = {letter: axis.rotary for letter, axis in known.items()}
        self.joints = {
            letter: min(max(self.joints.get(letter, 0.0), low), high)
            for letter, (low, high) in self.ends.items()
        }
        for letter, row in self.rows.items():
            row.widget.setVisible(letter in known)
            if letter in known:
                self._show(letter)

    def _show(self, letter: str) -> None:
        (low, high), row = self.ends[letter], self.rows[letter]
        row.slider.blockSignals(True)
        row.slider.setValue(round(STEPS * (self.joints[letter] - low) / max(high - low, 1e-9)))
        row.slider.blockSignals(False)
        self._write(letter)

    def _write(self, letter: str) -> None:
        self.rows[letter].text.setText(measure_text(round(self.joints[letter], 2), self.rotary[letter]))

    def _slide(self, letter: str) -> None:
        low, high = self.ends[letter]
        self.joints[letter] = low + (high - low) * self.rows[letter].slider.value() / STEPS
        self._write(letter)
        self.moved.emit()

    def _to_zero(self) -> None:
        self.joints = {letter: min(max(0.0, low), high) for letter, (low, high) in self.ends.items()}
        for letter in self.joints:
            self._show(letter)
        self.moved.emit()


class _Row:
    """The letter, the slider and where the axis stands."""

    def __init__(self, letter: str) -> None:
        self.widget, self.slider, self.text = (
            QtWidgets.QWidget(),
            QtWidgets.QSlider(QtCore.Qt.Horizontal),
            QtWidgets.QLabel(),
        )
        self.slider.setObjectName(f"jog_{letter}")
        self.slider.setAccessibleName(translate("FiveAxis", "Axis {letter}").format(letter=letter))
        self.slider.setRange(0, STEPS)
        self.text.setObjectName(f"jog_{letter}_text")
        self.text.setMinimumWidth(self.text.fontMetrics().boundingRect("-0000.00 mm").width())
        self.text.setAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
        line = QtWidgets.QHBoxLayout(self.widget)
        line.setContentsMargins(0, 0, 0, 0)
        name: Any = QtWidgets.QLabel(letter)
        name.setBuddy(self.slider)
        for part in (name, self.slider, self.text):
            line.addWidget(part, 1 if part is self.slider else 0)


def _ends(axis: AxisDraft) -> tuple[float, float]:
    """Return what a slider covers, mm or degrees; in order, whatever the limits say."""
    most = TURN if axis.rotary else TRAVEL
    low, high = (math.copysign(most, one) if math.isinf(one) else one for one in (axis.low, axis.high))
    return min(low, high), max(low, high)
