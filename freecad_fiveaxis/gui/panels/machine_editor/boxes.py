# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of the machine editor: a measure that may be left open, a rate of either kind of axis, a
direction."""

from __future__ import annotations

import math
from collections.abc import Sequence

from freecad_fiveaxis.app.units import INCH, inches
from freecad_fiveaxis.core.machine.file_objects import UNLIMITED
from freecad_fiveaxis.gui.panels.fields import ARROW, FeedField, Field, feed_unit, width_of
from freecad_fiveaxis.gui.panels.measure_box import MeasureBox
from freecad_fiveaxis.gui.panels.triple import TripleField
from freecad_fiveaxis.gui.qt import translate

TURNS_A_MINUTE = " °/min"


OPEN = ("∞", "inf", "infinity")
"""What is typed for a limit that there is not."""


class OpenBox(MeasureBox):
    """A measure, or a ``word`` for none: beyond UNLIMITED mm or degrees, on the side of ``sign``, as machine
    files write it. ``endless``: none is an infinity, and may be typed as one."""

    word, sign, endless = "", 1.0, False  # Qt asks what it shows before they are given

    def __init__(self, kind: str, word: str, sign: float, endless: bool) -> None:
        super().__init__(kind)
        self.word, self.sign, self.endless = word, sign, endless

    def is_open(self) -> bool:
        """Whether there is none."""
        return self._is_open(float(self.value()))

    def show_open(self) -> None:
        """Show that there is none."""
        self.show_number(self.sign * UNLIMITED / self.factor)

    def text_of(self, value: float) -> str:
        """Return what the box says of a number."""
        return self.word if self._is_open(value) else super().text_of(value)

    def _is_open(self, value: float) -> bool:
        return abs(value * self.factor) >= UNLIMITED * (1.0 - 1e-9)

    def read(self, text: str) -> float:
        """Return the number that is typed. Raises SettingsError for any other text."""
        if text.strip() in ("", self.word) or (self.endless and self._is_infinity(text.strip().lower())):
            return self.sign * UNLIMITED / self.factor
        return super().read(text)

    def _is_infinity(self, text: str) -> bool:
        """Whether a text is the infinity of this side; without a sign it is."""
        sign = "-" if self.sign < 0.0 else "+"
        return text.replace("−", "-").removeprefix(sign).strip() in OPEN


class OpenField(Field):
    """A length (mm) or an angle (degrees) that may be left open: ``opened`` then, None or an infinity.
    ``word``: what says so."""

    def __init__(self, name: str, word: str, opened: float | None, hint: str) -> None:
        self.opened = opened
        sign = math.copysign(1.0, -1.0 if opened is None else opened)
        super().__init__(name, OpenBox("length", word, sign, opened is not None), hint)
        self._given, self._shown = 0.0, 0.0
        self.editor.valueChanged.connect(self._on_change)

    def value(self) -> float | None:
        """mm or degrees, or ``opened``."""
        if self.editor.is_open():
            return self.opened
        shown = self.editor.read_measure()
        return self._given if shown == self._shown else shown

    def show_value(self, value: float | None) -> None:
        """mm or degrees, or ``opened``."""
        if value is None or math.isinf(value):
            self.editor.show_open()
        else:
            self.editor.show_measured(value)
            self._given = value
        self._shown = self.editor.read_measure()

    def show_measure(self, value: float | None, kind: str) -> None:
        """Show a value of that kind, "length" or "angle"."""
        self.editor.measure(kind)
        self.show_value(value)

    def room(self) -> int:
        """Six digits with their unit."""
        return width_of(self.editor, "-00000.00 mm") + ARROW


class RateField(FeedField):
    """The largest rate of an axis, mm/min or degrees/min; None while it is not given."""

    def __init__(self, name: str, hint: str) -> None:
        super().__init__(name, hint)
        self.editor.unset = translate("FiveAxis", "not given")
        self.show_value(None)

    def value(self) -> float | None:  # type: ignore[override]
        """mm/min or degrees/min."""
        return super().value() or None

    def show_rate(self, rate: float | None, rotary: bool) -> None:
        """Show a rate of that kind of axis."""
        suffix, per_second = (TURNS_A_MINUTE, 60.0) if rotary else feed_unit()
        self.factor = 60.0 / per_second
        self.editor.hold("turns" if rotary else "feed", self.factor / 60.0, suffix)
        self.show_value(rate)


class AccelerationField(RateField):
    """The largest acceleration of an axis, mm/s² or degrees/s² (inches where the user works in them); None
    while it is not given."""

    def show_acceleration(self, acceleration: float | None, rotary: bool) -> None:
        """Show an acceleration of that kind of axis."""
        inch = inches() and not rotary
        self.factor = INCH if inch else 1.0
        tail = " °/s²" if rotary else " in/s²" if inch else " mm/s²"
        self.editor.hold("turning" if rotary else "acceleration", self.factor, tail)
        self.show_value(acceleration)


class DirectionField(TripleField):
    """A direction; a number that is not edited keeps all its digits."""

    def __init__(self, name: str, hint: str) -> None:
        super().__init__(name, "direction", hint)
        self._given = [0.0, 0.0, 0.0]

    def value(self) -> list[float]:
        """Three numbers."""
        numbers = [part.editor.value() for part in self.parts]
        rounded = [
            round(one, part.editor.decimals()) for one, part in zip(self._given, self.parts, strict=True)
        ]
        return [
            old if new == near else new for old, new, near in zip(self._given, numbers, rounded, strict=True)
        ]

    def show_value(self, value: Sequence[float] | None) -> None:
        """Three numbers."""
        self._given = list(value or (0.0, 0.0, 0.0))
        super().show_value(value)
