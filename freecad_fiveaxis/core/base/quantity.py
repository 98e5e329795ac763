# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities as people write them, turned once, at the border, into the core's units.

length    mm inside; ``12``, ``12mm``, ``1.2cm``, ``0.5in``, ``0.5"``.    angle   rad inside; ``30``,
          ``30deg``, ``0.5rad``.
"""

from __future__ import annotations

import math
import re
import reprlib

from .errors import SettingsError
from .sentences import say

LENGTHS = {"": 1.0, "mm": 1.0, "um": 1e-3, "cm": 10.0, "m": 1000.0, "in": 25.4, "inch": 25.4, '"': 25.4}
ANGLES = {"": math.pi / 180.0, "deg": math.pi / 180.0, "°": math.pi / 180.0, "rad": 1.0}
FEEDS = {"": 1.0, "mm/min": 1.0, "m/min": 1000.0, "mm/s": 60.0, "in/min": 25.4, "ipm": 25.4}
NUMBERS = {"": 1.0}

_QUANTITY = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^\s\d]*)\s*")


def parse(text: str | float, units: dict[str, float], what: str) -> float:
    """Return the number of ``text`` in the core's unit. Raises SettingsError that names the text and the
    units known."""
    match = _QUANTITY.fullmatch(str(text)) if isinstance(text, str | float | int) else None
    if not match or match.group(2).lower() not in units or not math.isfinite(float(match.group(1))):
        known = ", ".join(unit for unit in units if unit)
        raise SettingsError(
            say(
                "{what} {text} is not a number with one of the units {known}",
                what=what,
                text=show_given(text),
                known=known,
            )
            if known
            else say("{what} {text} is not a number", what=what, text=show_given(text)),
            text,
        )
    return float(match.group(1)) * units[match.group(2).lower()]


def parse_length(text: str | float, what: str = "length") -> float:
    """Millimetres."""
    return parse(text, LENGTHS, what)


def parse_stack(
    text: str | list[str] | tuple[tuple[float, float], ...], what: str = "stack"
) -> tuple[tuple[float, float], ...]:
    """Cylinders upon each other, mm: ``DIAMETERxLENGTH``, as ``16x30`` or ``40x25,63x50`` (also
    ``0.5inx2in``); (d, l) each."""
    if not isinstance(text, str):
        return tuple(row if isinstance(row, tuple) else _stack_row(row, what) for row in text)
    rows = []
    for part in text.split(","):
        diameter, times, length = part.lower().partition("x")
        if not times:
            raise SettingsError(
                say(
                    "{what} {text} is no stack; write diameter x length from the cutter upwards, as "
                    "40x25,63x50",
                    what=what,
                    text=repr(text),
                ),
                text,
            )
        row = parse_length(diameter, what), parse_length(length, what)
        if not 0.0 < min(row) <= max(row) <= 1e4:
            raise SettingsError(
                say(
                    "{what} {part} is out of range; give diameters and lengths above 0, up to 10000 mm",
                    what=what,
                    part=repr(part),
                ),
                text,
            )
        rows.append(row)
    return tuple(rows)


def _stack_row(text: str, what: str) -> tuple[float, float]:
    """One cylinder of a list. Raises SettingsError for anything but one."""
    rows = parse_stack(text, what) if isinstance(text, str) else ()
    if len(rows) != 1:
        raise SettingsError(
            say(
                "{what} {text} is no cylinder; write diameter x length, as 40x25",
                what=what,
                text=show_given(text),
            ),
            text,
        )
    return rows[0]


def show_given(given: object) -> str:
    """Return what was given, for a message: a text or number as it is, of anything else the beginning."""
    return repr(given) if isinstance(given, str | float) else reprlib.repr(given)


def stack_text(stack: tuple[tuple[float, float], ...]) -> str:
    """Return the stack as :func:`parse_stack` reads it as the same one, mm; empty where there is none."""
    return ",".join("x".join(repr(float(size)).removesuffix(".0") for size in row) for row in stack)


def parse_angle(text: str | float, what: str = "angle") -> float:
    """Radians; a bare number is in degrees."""
    return parse(text, ANGLES, what)


def parse_feed(text: str | float, what: str = "feed") -> float:
    """Millimetres a minute."""
    return parse(text, FEEDS, what)


def parse_triple(
    text: str | list[float] | tuple[float, ...], units: dict[str, float], what: str
) -> tuple[float, float, float]:
    """Three quantities, as ``X,Y,Z``."""
    parts = text.split(",") if isinstance(text, str) else list(text)
    if len(parts) != 3:
        raise SettingsError(
            say("{what} {text} needs three numbers, as 0,0,50", what=what, text=show_given(text)), text
        )
    x, y, z = (parse(part, units, what) for part in parts)
    return x, y, z
