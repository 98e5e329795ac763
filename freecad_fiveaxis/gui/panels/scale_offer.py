# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons that scale a part which seems to be drawn in another unit than mm; to be seen only where that is
suspected."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

FACTORS = {"inches": 25.4, "metres": 1000.0}
"""mm of each unit."""


class ScaleOffer(QtWidgets.QWidget):
    """One button for each unit; ``chosen`` tells the factor by which the part is to grow."""

    chosen = QtCore.Signal(float)

    def __init__(self) -> None:
        super().__init__()
        texts = {
            "inches": translate("FiveAxis", "The part is in inches: scale it by 25.4"),
            "metres": translate("FiveAxis", "The part is in metres: scale it by 1000"),
        }
        self.buttons = {unit: QtWidgets.QPushButton(text) for unit, text in texts.items()}
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for unit, button in self.buttons.items():
            button.setObjectName(f"scale_{unit}")
            button.clicked.connect(lambda *_, factor=FACTORS[unit]: self.chosen.emit(factor))
            column.addWidget(button)
        self.show_for(None)

    def show_for(self, obj: Any) -> None:
        """Offer it where the last result of ``obj`` (None: there is none) suspects another unit."""
        last = getattr(getattr(obj, "Proxy", None), "last", None)
        found = () if last is None else last.figures.findings
        self.setVisible(any(one.code == "unit-suspected" for one in found))
