# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box for a length or an angle, in millimetres or inches as the document has them, with a machine's
decimals.

FreeCAD's own box chooses the unit by the size of the value (10 µm, 0.39 thou), shows fractions of an inch in
one schema and an exponent for small values; a tolerance of 0.01 mm is none of these to a machinist.
"""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_fiveaxis.app.units import INCH, field_text, inches
from freecad_fiveaxis.gui.qt import QtGui, QtWidgets

MOST = 1e7
"""The core knows the ranges, and says them."""
PRECISION = 12
"""Decimals that the box keeps, far more than it shows."""


class MeasureBox(QtWidgets.QDoubleSpinBox):
    """``kind``: "length" or "angle". It reads any unit that FreeCAD knows, and what is reckoned: ``0.5 in``,
    ``10 mm / 3``."""

    def __init__(self, kind: str) -> None:
        super().__init__()
        self.unset = ""  # what 0 is called where it means that nothing is given
        self.measure(kind)
        self.setDecimals(PRECISION)
        self.setRange(-MOST, MOST)

    def measure(self, kind: str) -> None:
        """Measure lengths or angles from now on."""
        self.kind = kind
        inch = kind == "length" and inches()
        self.unit, self.factor, self.places = (
            ("°", 1.0, 4) if kind == "angle" else ("in", INCH, 5) if inch else ("mm", 1.0, 4)
        )
        self.setSingleStep(0.1 if inch else 1.0)
        self.setSuffix("")  # Qt shows the value anew

    def read_measure(self) -> float:
        """mm or degrees."""
        return float(self.value() * self.factor)

    def show_measured(self, value: float) -> None:
        """mm or degrees."""
        self.setValue(value / self.factor)

    def textFromValue(self, value: float) -> str:
        """Qt asks what it shows."""
        if self.unset and value == 0.0:
            return self.unset
        gap = "" if self.unit == "°" else " "
        return f"{field_text(value, self.places)}{gap}{self.unit}".replace(
            ".", str(self.locale().decimalPoint())
        )

    def valueFromText(self, text: str) -> float:
        """Qt asks what was typed."""
        read = self._read(text)
        return float(self.value()) if read is None else read

    def validate(self, text: str, at: int) -> Any:
        """Qt asks whether this may stand there: all may be typed, what cannot be read is put back
        afterwards."""
        good = self._read(text) is not None
        return (QtGui.QValidator.Acceptable if good else QtGui.QValidator.Intermediate), text, at

    def _read(self, text: str) -> float | None:
        """Return a number of the box's unit, or one with a unit of its own; None for anything else."""
        if self.unset and text.strip() == self.unset:
            return 0.0
        given = text.strip().replace(str(self.locale().decimalPoint()), ".")
        try:
            return float(given)
        except ValueError:
            pass
        units = FreeCAD.Units
        kind, unit = (units.Angle, "deg") if self.kind == "angle" else (units.Length, "mm")
        try:
            quantity = units.Quantity(given.replace("°", " deg"))
        except (ValueError, ArithmeticError, OSError):
            return None
        if quantity.Unit == units.Unit() and given:
            return float(quantity.Value)
        return float(quantity.getValueAs(unit)) / self.factor if quantity.Unit == kind else None
