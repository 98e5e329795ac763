# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, areas, angles and feeds as a machinist reads them: millimetres, or inches where FreeCAD's unit
schema is imperial.

The schema decides between mm and inches only: no micrometre, thou or metre, no fraction of an inch and no
exponent, which FreeCAD's own texts would choose by the size of the value, and never more decimals than a
machine knows.
"""

from __future__ import annotations

import math
import re

import FreeCAD

from freecad_fiveaxis.core.base.sentences import (
    IN_FULL,
    Angle,
    Area,
    Feed,
    Length,
    Measure,
    Point,
    Turn,
    TurnRate,
    Volume,
    format_number,
)

from .decimal_sign import write_number

INCH = 25.4
DIGITS = 4
ROUNDING = 1e-9
"""What is less is rounding, and would be read as a measure."""
DECIMALS = {Length: 4, Point: 4, Area: 4, Volume: 4, Angle: 4, Turn: 4, TurnRate: 2, Feed: 2}
"""Of what is shown in mm; a length in inches has one more for each mm of its unit."""
POWERS = {Length: 1, Point: 1, Area: 2, Volume: 3, Feed: 1, Turn: -1}
"""How often mm stand in the unit."""
NAMES = {Area: "{}²", Volume: "{}³", Feed: "{}/min", Turn: "°/{}", TurnRate: "°/min", Angle: "°"}
IMPERIAL = ("in", '"', "ft", "'", "thou", "mil", "yd", "mi")
"""Units of FreeCAD's imperial schemas."""


def inches() -> bool:
    """Whether the unit schema in force (the document's own, or the user's) is imperial."""
    unit = str(FreeCAD.Units.Quantity(10.0, FreeCAD.Units.Length).getUserPreferred()[2])
    return unit in IMPERIAL


def measure_text(measure: Measure) -> str:
    """Return a measure of a sentence in the user's units, with as many digits as it has there."""
    kind, inch = type(measure), inches()
    digits, decimals = _precision(measure.form)
    most = DECIMALS.get(kind, 4)
    power = POWERS.get(kind, 0)
    factor = INCH**power if inch else 1.0
    extra = max(power, 0) if inch else 0
    places = most + extra if decimals is None else min(decimals, most) + extra
    whole = measure.form == IN_FULL
    texts = [
        write_number(
            format_number(value / factor, IN_FULL) if whole else number_text(value / factor, digits, places)
        )
        for value in measure.values
    ]
    between = measure.between.replace(",", ";") if "," in "".join(texts) else measure.between
    numbers = between.join(texts)
    unit = NAMES.get(kind, "{}").format("in" if inch else "mm") if kind in DECIMALS else measure.unit
    numbers = f"({numbers})" if isinstance(measure, Point) else numbers
    return numbers + ("" if unit == "°" else " ") + unit


def _precision(form: str) -> tuple[int, int | None]:
    """Significant digits and decimals (None: as many as there are) of a format as ".4g" or ".3f"."""
    found = re.search(r"\.(\d+)([gf])", form)
    if found is None:
        return 6, None
    return (int(found[1]), None) if found[2] == "g" else (15, int(found[1]))


def number_text(value: float, digits: int, decimals: int) -> str:
    """Return a number with at most so many digits, of them so many behind the point; "<0.0001" for less than
    can be shown."""
    if not math.isfinite(value):
        return "∞" if value > 0.0 else "?"
    value = 0.0 if abs(value) < ROUNDING else value
    places = max(min(decimals, digits - 1 - math.floor(math.log10(abs(value)))), 0) if value else 0
    text = f"{value:.{places}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return f"<{10.0**-decimals:.{decimals}f}" if value and text in ("0", "-0") else text


def length_text(mm: float, digits: int = DIGITS) -> str:
    """Return a length in the user's units, as "2.126 mm" or "0.0837 in"."""
    return measure_text(Length(mm, f".{digits}g"))


def area_text(square_mm: float, digits: int = DIGITS) -> str:
    """Return an area in the user's units, as "12.3 mm²"."""
    return measure_text(Area(square_mm, f".{digits}g"))


def feed_text(mm_per_minute: float, digits: int = DIGITS) -> str:
    """Return a feed in the user's units, as "1000 mm/min"."""
    return measure_text(Feed(mm_per_minute, f".{digits}g"))


def angle_text(degrees: float, digits: int = DIGITS) -> str:
    """Return an angle, as "27.42°"."""
    return measure_text(Angle(degrees, f".{digits}g"))


def field_text(value: float, places: int) -> str:
    """Return a number to be edited: at most so many decimals, more only for what would read 0, never an
    exponent."""
    value = 0.0 if abs(value) < ROUNDING else value
    if value and not float(f"{value:.{places}f}"):
        places = 1 - math.floor(math.log10(abs(value)))
    text = f"{value:.{places}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text
