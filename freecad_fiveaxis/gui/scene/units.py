# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers in the user's own units, with as many digits as they have: FreeCAD's own texts would show a micrometre as 0.00."""

from __future__ import annotations

import FreeCAD

DIGITS = 4
ROUNDING = 1e-9
"""mm or mm²; what is less is rounding, and would be read as a measure."""


def length_text(mm: float, digits: int = DIGITS) -> str:
    """A length in the unit of the user's schema, as "2.126 mm", "12.3 µm" or "0.0837 in"."""
    return _text(mm, FreeCAD.Units.Length, "mm", digits)


def area_text(square_mm: float, digits: int = DIGITS) -> str:
    """An area in the unit of the user's schema, as "12.3 mm²"."""
    return _text(square_mm, FreeCAD.Units.Area, "mm^2", digits)


def _text(value: float, kind: object, usual: str, digits: int) -> str:
    value = 0.0 if abs(value) < ROUNDING else value
    _, factor, unit = FreeCAD.Units.Quantity(value, kind).getUserPreferred()
    if not factor or not unit:
        factor, unit = 1.0, usual
    return f"{value / factor:.{digits}g} {unit.replace('^2', '²')}"


def angle_text(degrees: float, digits: int = DIGITS) -> str:
    """An angle, as "27.42°"."""
    return f"{degrees:.{digits}g}°"
