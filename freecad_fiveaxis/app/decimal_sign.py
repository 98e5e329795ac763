# SPDX-License-Identifier: LGPL-2.1-or-later
"""The decimal sign of what a window shows: that of FreeCAD's own fields. Without a window it is the point."""

from __future__ import annotations

from collections.abc import Callable

_find: list[Callable[[], str]] = [lambda: "."]


def use_decimal_sign(find: Callable[[], str]) -> None:
    """Write numbers with the decimal sign that ``find`` gives whenever it is asked."""
    _find[:] = [find]


def write_number(number: object) -> str:
    """Return a number, or the text of one, with the decimal sign in force."""
    return str(number).replace(".", _find[0]())
