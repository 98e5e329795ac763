# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box for a number that is typed as users type it: comma or point, a fraction, a unit.

refused   a text that was left and cannot be read: it stays as it was typed, the box keeps its number, and
          ``reason`` says why. Qt's own boxes drop the letters that they do not know, and so read 1/2 as 12.
"""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.app.typed import check_range, read_typed
from freecad_fiveaxis.app.units import field_text
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

MOST = 1e7
"""The core knows the ranges, and says them."""
PRECISION = 12
"""Decimals that a box keeps, far more than it shows."""


class TypedBox(QtWidgets.QDoubleSpinBox):
    """``kind`` as ``app.typed`` knows it, ``unit``: base units of its number; ``tail`` stands behind it.

    ``places``: decimals that it shows, at least and at most; ``unset``: what 0 is called where it means that
    nothing is given. ``refusal_changed`` tells that ``reason`` is another.
    """

    refusal_changed = QtCore.Signal()

    def __init__(self, kind: str, places: tuple[int, int] = (2, 6), least: float = -MOST) -> None:
        super().__init__()
        self.kind, self.unit, self.tail, self.places, self.unset = kind, 1.0, "", places, ""
        self.refused: str | None = None
        self.reason, self.kept = "", 0.0
        self.begun: float | None = None  # the number before the typing that goes on
        self.setDecimals(PRECISION)
        self.setRange(least, MOST)
        self.lineEdit().textEdited.connect(lambda *_: self._begin())
        self.editingFinished.connect(self._leave)

    def hold(self, kind: str, unit: float, tail: str) -> None:
        """Hold numbers of that kind and unit from now on."""
        self.kind, self.unit, self.tail = kind, unit, tail
        self.setSuffix("")  # Qt shows the value anew

    def show_number(self, number: float) -> None:
        """Show a number, whatever stands there."""
        self._end()
        self.accept_text()
        self.setValue(number)
        self.setSuffix("")

    def _begin(self) -> None:
        self.accept_text()
        if self.begun is None:
            self.begun = float(self.value())

    def _leave(self) -> None:
        if self.begun is not None:
            self.begun = None
            self.setSuffix("")

    def _end(self) -> None:
        self.begun = None

    def accept_text(self) -> None:
        """Forget what was refused."""
        self._refuse(None, "", float(self.value()))

    def _refuse(self, text: str | None, reason: str, kept: float) -> None:
        """Keep the number before the typing: 30 is not meant by "30 mm" either, though it was read."""
        self.refused, self.kept = text, kept
        if text is not None:
            self.setValue(kept)
        if reason != self.reason:
            self.reason = reason
            self.refusal_changed.emit()

    def textFromValue(self, value: float) -> str:
        """Qt asks what it shows."""
        if self.refused is not None and value == self.kept == self.value():
            return self.refused
        return self.text_of(value)

    def text_of(self, value: float) -> str:
        """Return what the box says of a number."""
        if self.unset and value == 0.0:
            return self.unset
        return self.digits(value).replace(".", str(self.locale().decimalPoint())) + self.tail

    def digits(self, value: float) -> str:
        """Return a number with as many decimals as it is shown with."""
        fewest, most = self.places
        text = field_text(value, most)
        return max(text, f"{value:.{fewest}f}", key=len) if abs(value) > 10.0**-fewest / 2.0 else text

    def valueFromText(self, text: str) -> float:
        """Qt asks what was typed; what the box says itself is the number that it has, and not its rounded
        one."""
        value = float(self.value())
        try:
            return value if text == self.text_of(value) else self.read(text)
        except SettingsError:
            return value

    def validate(self, text: str, at: int) -> Any:
        """Qt asks whether this may stand there: all may be typed."""
        try:
            self.read(text)
        except SettingsError:
            return QtGui.QValidator.Intermediate, text, at
        return QtGui.QValidator.Acceptable, text, at

    def fixup(self, text: str) -> str:
        """Qt asks what to do with a text that was left and cannot be read; one that a program put there is
        put back."""
        try:
            self.read(text)
        except SettingsError as error:
            if self.begun is not None:
                self._refuse(text, error.text, self.begun)
        return text

    def stepBy(self, steps: int) -> None:
        """Qt steps from the number that the box has."""
        super().stepBy(steps)
        self._end()
        self.accept_text()
        self.setSuffix("")

    def read(self, text: str) -> float:
        """Return the number that is typed. Raises SettingsError for any other text."""
        plain = text.strip()
        if plain == self.text_of(float(self.value())).strip():
            return float(self.value())
        if self.unset and plain in ("", self.unset):
            return 0.0
        number = read_typed(plain, self.kind, self.unit, str(self.locale().decimalPoint()), self.tail)
        check_range(plain, number, self.minimum(), self.maximum())
        return number
