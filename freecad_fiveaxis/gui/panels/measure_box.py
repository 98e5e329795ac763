# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box for a length or an angle, in millimetres or inches as the document has them, with a machine's
decimals.

FreeCAD's own box chooses the unit by the size of the value (10 µm, 0.39 thou), shows fractions of an inch in
one schema and an exponent for small values; a tolerance of 0.01 mm is none of these to a machinist.
"""

from __future__ import annotations

from freecad_fiveaxis.app.units import INCH, field_text, inches

from .typed_box import TypedBox


class MeasureBox(TypedBox):
    """``kind``: "length" or "angle". It reads any unit that FreeCAD knows, and what is reckoned: ``0.5 in``,
    ``10 mm / 3``."""

    factor = 1.0  # Qt asks what it shows before it is given

    def __init__(self, kind: str) -> None:
        super().__init__(kind)
        self.measure(kind)

    def measure(self, kind: str) -> None:
        """Measure lengths or angles from now on."""
        inch = kind == "length" and inches()
        name, self.factor, most = (
            ("°", 1.0, 4) if kind == "angle" else (" in", INCH, 5) if inch else (" mm", 1.0, 4)
        )
        self.places = (0, most)
        self.setSingleStep(0.1 if inch else 1.0)
        self.hold(kind, self.factor, name)

    def read_measure(self) -> float:
        """mm or degrees."""
        return float(self.value() * self.factor)

    def show_measured(self, value: float) -> None:
        """mm or degrees."""
        self.show_number(value / self.factor)

    def digits(self, value: float) -> str:
        """Return a number without zeros at its end."""
        return field_text(value, self.places[1])
