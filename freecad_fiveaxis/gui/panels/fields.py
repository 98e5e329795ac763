# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of a task panel: one option of the core's settings each, in the user's units, with its error in
place.

field     an editor that holds one value as job files write it: mm, degrees, mm/min, a name, three numbers.
given     the value that the field was shown. Until the user edits the field, it gives that very number back,
          so that what the user's units round away is not lost.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.app.labels import option_label
from freecad_fiveaxis.app.units import INCH, inches
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate
from freecad_fiveaxis.gui.scene.units import angle_text, length_text
from freecad_fiveaxis.gui.wheel import leave_wheel

from .lines import error_line, note_line, warning_line
from .measure_box import MeasureBox
from .typed_box import MOST, TypedBox

UNITS = {"length": "mm", "angle": "deg"}
"""The core's unit of a kind of option."""
DIGITS = 6

FLAGS, CHOSEN = int(QtCore.Qt.UserRole) - 1, 33
"""The role under which a list's items keep their flags (as QStandardItem.setFlags does), and those of one
that can be chosen: selectable (1) and enabled (32)."""


LINES = {"error": error_line, "warning": warning_line, "note": note_line}
"""The lines under a field, in their order, and what makes them."""
NARROW = 60
"""Pixels that an editor needs at least."""
ARROW = 30
"""Pixels of the arrows and the frame of a box."""


class Field(QtCore.QObject):
    """An editor and lines for its error, a warning and a note. ``edited`` tells that the user, or a program,
    changed the value.

    ``label`` is what the field is called, on the screen and for screen readers; ``has_own_labels``: its parts
    bear their own.
    """

    edited = QtCore.Signal()
    has_own_labels = False

    def __init__(self, name: str, editor: Any, hint: str = "") -> None:
        super().__init__()
        self.name, self.editor, self.label = name, editor, option_label(name)
        editor.setObjectName(name)
        editor.setAccessibleName(self.label)
        editor.setToolTip(hint)
        editor.setMinimumWidth(NARROW)
        leave_wheel(editor)
        if hasattr(editor, "refusal_changed"):
            editor.refusal_changed.connect(self._on_change)
        self.nested, self.refusing = False, False
        self.lines: dict[str, Any] = {}
        self.place_line: Callable[[str, Any], Any] = lambda kind, line: None

    def line_of(self, kind: str) -> Any:
        """Return the label of that kind, one of LINES, made and placed when it is asked for first: most
        fields never say anything, and a panel of sixty fields opens in half the time without their lines."""
        if kind not in self.lines:
            self.lines[kind] = LINES[kind](f"{self.name}_{kind}")
            self.place_line(kind, self.lines[kind])
        return self.lines[kind]

    @property
    def error(self) -> Any:
        """The label that says why the value cannot be used."""
        return self.line_of("error")

    @property
    def warning(self) -> Any:
        """The label that says what to think of before the value is used."""
        return self.line_of("warning")

    @property
    def note(self) -> Any:
        """The label that says why the field counts for nothing."""
        return self.line_of("note")

    def says(self, kind: str) -> str:
        """Return what the line of that kind says; nothing where there is none yet."""
        return str(self.lines[kind].text()) if kind in self.lines else ""

    def _say(self, kind: str, text: str) -> None:
        if text != self.says(kind):
            line = self.line_of(kind)
            line.setText(text)
            line.setVisible(bool(text))

    def focus_widget(self) -> Any:
        """Return what the field's label leads to."""
        return self.editor

    def room(self) -> int:
        """Pixels that the editor needs beside a label."""
        return NARROW

    def words(self) -> str:
        """Return what the title of a group says of the field; empty where it says nothing."""
        return ""

    def show_warning(self, text: str) -> None:
        """Show what to think of before the value is used, in amber under the editor; an empty text takes it
        away."""
        self._say("warning", text)

    def show_note(self, text: str) -> None:
        """Why the field counts for nothing, in small letters under the editor, which is then idle; an empty
        text: it counts."""
        self._say("note", text)
        self.editor.setEnabled(not text)

    def show_error(self, text: str) -> None:
        """Show the reason why the value cannot be used, in red under the editor; an empty text takes it
        away."""
        self._say("error", text)

    def want(self) -> None:
        """Call what the user has not given yet missing from now on: he has asked for the result."""

    def parts_of(self) -> Sequence[Field]:
        """Return the fields that this one is made of and that count as it stands."""
        return ()

    def nest(self) -> None:
        """Say nothing of what is typed here: the field around it does."""
        self.nested = True

    def refusal(self) -> str:
        """Return why what was typed cannot be read; nothing where it can."""
        own: str = getattr(self.editor, "reason", "")
        return own or next((reason for part in self.parts_of() if (reason := part.refusal())), "")

    def check(self) -> None:
        """Raise FiveAxisError for a value that cannot be used, where the core's settings do not know of
        it."""
        from freecad_fiveaxis.core.base.errors import SettingsError

        if self.refusal():
            raise SettingsError(self.refusal())

    def value(self) -> Any:
        """Return the option's value as job files write it; None: not given."""
        raise NotImplementedError

    def show_value(self, value: Any) -> None:
        """Show a value as ``value`` gives it."""
        raise NotImplementedError

    def _on_change(self, *_: Any) -> None:
        self._tell_refusal()
        self.edited.emit()

    def _tell_refusal(self) -> None:
        """Say why what was typed cannot be read, and take that away again; forms say their errors
        themselves."""
        reason = "" if self.nested else self.refusal()
        if reason or self.refusing:
            self.show_error(wording.localize(reason))
        self.refusing = bool(reason)


FOUND = ("max_axis_angle",)
"""Options that are found where they are not given."""
OFF = ("steep_shallow",)
"""Options that do nothing where they are not given."""


class QuantityField(Field):
    """A length (mm) or an angle (degrees) in the user's units. ``optional``: 0 means not given."""

    def __init__(self, name: str, kind: str, hint: str = "", optional: bool = False) -> None:
        super().__init__(name, MeasureBox(kind), hint)
        self.unit = UNITS[kind]
        self.optional, self._given, self._shown = optional, 0.0, 0.0
        self.editor.unset = _word_for_none(name) if optional else ""
        self.show_value(0.0)
        self.editor.valueChanged.connect(self._on_change)

    def value(self) -> float | None:
        """mm or degrees."""
        shown = self.editor.read_measure()
        value = self._given if shown == self._shown else shown
        return None if self.optional and value == 0.0 else value

    def show_value(self, value: float | None) -> None:
        """mm or degrees; None: not given."""
        self._given = float(value or 0.0)
        self.editor.show_measured(self._given)
        self._shown = self.editor.read_measure()

    def room(self) -> int:
        """Six digits with their unit."""
        return width_of(self.editor, "0.000000 mm") + ARROW

    def words(self) -> str:
        """Label and value; of a length or an angle of 0 nothing."""
        value = self.value()
        if not value:
            return ""
        return (
            f"{self.label} {length_text(value, DIGITS) if self.unit == 'mm' else angle_text(value, DIGITS)}"
        )


def _word_for_none(name: str) -> str:
    """Return what an option is called that is not given; nothing where 0 says it."""
    if name in FOUND:
        return translate("FiveAxis", "automatic")
    return translate("FiveAxis", "off") if name in OFF else ""


class FeedField(Field):
    """A feed, typed a minute as machinists do: mm/min, or in/min where the user works in inches."""

    def __init__(self, name: str, hint: str = "") -> None:
        suffix, per_second = feed_unit()
        places = 4 if per_second < 60.0 else 2
        super().__init__(name, TypedBox("feed", (places, places), 0.0), hint)
        self._given, self._shown, self.factor = 0.0, 0.0, 60.0 / per_second
        self.editor.hold("feed", self.factor / 60.0, suffix)
        self.editor.valueChanged.connect(self._on_change)

    def value(self) -> float:
        """mm/min."""
        shown = self.editor.value()
        return self._given if shown == self._shown else shown * self.factor

    def show_value(self, value: float | None) -> None:
        """mm/min."""
        self._given = float(value or 0.0)
        self.editor.show_number(self._given / self.factor)
        self._shown = self.editor.value()

    def room(self) -> int:
        """Seven digits with their unit."""
        return width_of(self.editor, "00000.00" + self.editor.tail) + ARROW

    def words(self) -> str:
        """As in a program, with its unit: ``F 1000 mm/min``."""
        return f"F {write_number(f'{self.editor.value():g}')}{self.editor.tail}"


def feed_unit() -> tuple[str, float]:
    """Return the unit of feeds in a box, and how many of it one mm/s is.

    FreeCAD's own boxes take a plain number for mm/s, and refuse "mm/min" letter by letter.
    """
    return (" in/min", 60.0 / INCH) if inches() else (" mm/min", 60.0)


class ChoiceField(Field):
    """One of some names. ``choices``: pairs of the value and what it is called."""

    def __init__(self, name: str, choices: Sequence[tuple[Any, str]], hint: str = "") -> None:
        super().__init__(name, QtWidgets.QComboBox(), hint)
        self.editor.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.editor.setMinimumContentsLength(8)
        for value, text in choices:
            self.editor.addItem(text, value)
        self.editor.currentIndexChanged.connect(self._on_change)

    def offer(self, unknown: Collection[Any]) -> None:
        """Offer all values but these, which cannot be chosen for now."""
        model = (
            self.editor.model()
        )  # by indexes: PySide keeps what it hands out of Qt's own items longer than Qt has them
        for at in range(self.editor.count()):
            on = self.editor.itemData(at) not in unknown
            model.setData(model.index(at, 0), CHOSEN if on else 0, FLAGS)

    def explain(self, hints: Mapping[Any, str]) -> None:
        """Explain what each choice means, as the tool tip of its line in the list."""
        for at in range(self.editor.count()):
            self.editor.setItemData(at, hints.get(self.editor.itemData(at), ""), QtCore.Qt.ToolTipRole)

    def value(self) -> Any:
        """Return the value of the chosen item."""
        return self.editor.currentData()

    def room(self) -> int:
        """Return the longest item."""
        texts = [self.editor.itemText(at) for at in range(self.editor.count())]
        return max((width_of(self.editor, text) for text in texts), default=0) + ARROW

    def words(self) -> str:
        """Return the chosen item; of what is switched on its label, of what is off or not given nothing."""
        chosen = self.value()
        return "" if chosen in (None, "off") else self.label if chosen == "on" else self.editor.currentText()

    def show_value(self, value: Any) -> None:
        """Choose the item of that value; one that is not in the list joins it under its own name."""
        at = next((i for i in range(self.editor.count()) if self.editor.itemData(i) == value), -1)
        if at < 0:
            self.editor.addItem(str(value), value)
            at = self.editor.count() - 1
        self.editor.setCurrentIndex(at)


class NumberField(Field):
    """A plain number. ``whole``: a count; ``optional``: 0 means not given."""

    def __init__(self, name: str, hint: str = "", whole: bool = False, optional: bool = False) -> None:
        kind, places = ("whole", (0, 0)) if whole else ("number", (2, 6))
        editor = TypedBox(kind, places, 0.0 if optional else -MOST)
        super().__init__(name, editor, hint)
        self.optional, self.whole = optional, whole
        editor.unset = translate("FiveAxis", "not given") if optional else ""
        editor.show_number(0.0)
        editor.valueChanged.connect(self._on_change)

    def value(self) -> float | None:
        """Return the number."""
        number = int(self.editor.value()) if self.whole else float(self.editor.value())
        return None if self.optional and number == 0 else number

    def show_value(self, value: float | None) -> None:
        """Show the number, or None."""
        self.editor.show_number(float(int(value or 0)) if self.whole else float(value or 0.0))

    def room(self) -> int:
        """Six digits, or what says that there are none."""
        return width_of(self.editor, self.editor.unset or "000000") + ARROW


class SpindleField(NumberField):
    """The spindle's speed, 1/min; 0 leaves the spindle off, and the field warns of that."""

    def __init__(self, name: str, hint: str = "") -> None:
        super().__init__(name, hint, whole=True, optional=True)
        self._given = 0.0
        self.editor.setSingleStep(500)
        self.editor.hold("whole", 1.0, translate("FiveAxis", " 1/min"))
        self.edited.connect(self._warn)
        self._warn()

    def value(self) -> float:
        """1/min; a speed that is no whole number comes back as it was given."""
        shown = self.editor.value()
        return self._given if shown == round(self._given) else float(shown)

    def show_value(self, value: float | None) -> None:
        """1/min."""
        self._given = float(value or 0.0)
        super().show_value(round(self._given))
        self._warn()

    def room(self) -> int:
        """Five digits with their unit."""
        return width_of(self.editor, "00000" + self.editor.tail) + ARROW

    def words(self) -> str:
        """As in a program: ``S 8000``."""
        return f"S {self.value():g}" if self.value() else translate("FiveAxis", "no spindle speed")

    def _warn(self) -> None:
        missing = translate("FiveAxis", "Spindle speed not given: the program will not start the spindle.")
        self.show_warning("" if self.value() else missing)


class TextField(Field):
    """A line of text. ``example``: stands there in grey while it is empty."""

    def __init__(self, name: str, hint: str = "", example: str = "") -> None:
        super().__init__(name, QtWidgets.QLineEdit(), hint)
        self.editor.setPlaceholderText(example)
        self.editor.textChanged.connect(self._on_change)

    def value(self) -> str:
        """Show the text."""
        return self.editor.text().strip()

    def show_value(self, value: str | None) -> None:
        """Show the text."""
        self.editor.setText(value or "")

    def room(self) -> int:
        """Return what is to be typed there may be long."""
        return width_of(self.editor, self.editor.placeholderText() or "0" * 12)

    def words(self) -> str:
        """Label and text."""
        return f"{self.label} {self.value()}" if self.value() else ""


def width_of(editor: Any, text: str) -> int:
    """Pixels of a text in the editor's font."""
    return int(editor.fontMetrics().boundingRect(text).width())
