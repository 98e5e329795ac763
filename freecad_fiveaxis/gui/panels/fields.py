# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of a task panel: one option of the core's settings each, in the user's units, with its error in place.

field     an editor that holds one value as job files write it: mm, degrees, mm/min, a name, three numbers.
given     the value that the field was shown. Until the user edits the field, it gives that very number back, so that what
          the user's units round away is not lost.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, create, translate
from freecad_fiveaxis.gui.scene.units import angle_text, length_text
from freecad_fiveaxis.gui.wheel import leave_wheel

from .labels import option_hint, option_label

UNITS = {"length": ("mm", "Length"), "angle": ("deg", "Angle")}
"""FreeCAD's unit of a kind of option, which is the core's too, and its quantity."""
DIGITS = 6
SHOWN = {"Precision": DIGITS, "NumberFormat": "g", "Denominator": 8}
"""Six digits, so that 0.01 mm in inches does not read 0.00 in."""

STACK = "40x25,63x50"
"""An example of cylinders upon each other."""

FLAGS, CHOSEN = int(QtCore.Qt.UserRole) - 1, 33
"""The role under which a list's items keep their flags (as QStandardItem.setFlags does), and those of one that can be chosen:
selectable (1) and enabled (32)."""


NARROW, WIDE = 60, 1000
"""Pixels that an editor needs at least, and those of one that never stands beside its label."""
ARROW = 30
"""Pixels of the arrows and the frame of a box."""


class Field(QtCore.QObject):
    """An editor and lines for its error, a warning and a note. ``edited`` tells that the user, or a program, changed the value.

    ``label`` is what the field is called, on the screen and for screen readers; ``has_own_labels``: its parts bear their own.
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
        self.error = error_line(name + "_error")
        self.warning = warning_line(name + "_warning")
        self.note = note_line(name + "_note")

    def focus_widget(self) -> Any:
        """What the field's label leads to."""
        return self.editor

    def room(self) -> int:
        """Pixels that the editor needs beside a label."""
        return NARROW

    def words(self) -> str:
        """What the title of a group says of the field; empty where it says nothing."""
        return ""

    def show_warning(self, text: str) -> None:
        """What to think of before the value is used, in amber under the editor; an empty text takes it away."""
        self.warning.setText(text)
        self.warning.setVisible(bool(text))

    def show_note(self, text: str) -> None:
        """Why the field counts for nothing, in small letters under the editor, which is then idle; an empty text: it counts."""
        self.note.setText(text)
        self.note.setVisible(bool(text))
        self.editor.setEnabled(not text)

    def show_error(self, text: str) -> None:
        """The reason why the value cannot be used, in red under the editor; an empty text takes it away."""
        self.error.setText(text)
        self.error.setVisible(bool(text))

    def check(self) -> None:
        """Raises FiveAxisError for a value that cannot be used, where the core's settings do not know of it."""

    def value(self) -> Any:
        """The option's value as job files write it; None: not given."""
        raise NotImplementedError

    def show_value(self, value: Any) -> None:
        """Show a value as ``value`` gives it."""
        raise NotImplementedError

    def _changed(self, *_: Any) -> None:
        self.edited.emit()


class QuantityField(Field):
    """A length (mm) or an angle (degrees) in the user's units. ``optional``: 0 means not given."""

    def __init__(self, name: str, kind: str, hint: str = "", optional: bool = False) -> None:
        super().__init__(name, create("Gui::QuantitySpinBox"), hint)
        self.unit, self.quantity = UNITS[kind]
        self.optional, self._given, self._text = optional, 0.0, None
        self.editor.setProperty("unit", self.unit)
        self.show_value(0.0)
        self.editor.valueChanged.connect(self._changed)

    def value(self) -> float | None:
        """mm or degrees."""
        untouched = self.editor.property("text") == self._text
        value = self._given if untouched else self.editor.property("rawValue")
        return None if self.optional and value == 0.0 else value

    def show_value(self, value: float | None) -> None:
        """mm or degrees; None: not given."""
        self._given = float(value or 0.0)
        self.editor.setProperty("value", quantity(self._given, self.quantity))
        self._text = self.editor.property("text")

    def room(self) -> int:
        """Six digits with their unit."""
        return width_of(self.editor, "0.000000 mm") + ARROW

    def words(self) -> str:
        """Label and value; of a length or an angle of 0 nothing."""
        value = self.value()
        if not value:
            return ""
        return f"{self.label} {length_text(value, DIGITS) if self.unit == 'mm' else angle_text(value, DIGITS)}"


class FeedField(Field):
    """A feed, typed a minute as machinists do: mm/min, or in/min where the user works in inches."""

    def __init__(self, name: str, hint: str = "") -> None:
        super().__init__(name, QtWidgets.QDoubleSpinBox(), hint)
        suffix, per_second = feed_unit()
        self._given, self._shown, self.factor = 0.0, 0.0, 60.0 / per_second
        self.editor.setDecimals(4 if per_second < 60.0 else 2)
        self.editor.setRange(0.0, 1e7)  # the core knows the range, and says it
        self.editor.setSuffix(suffix)
        self.editor.valueChanged.connect(self._changed)

    def value(self) -> float:
        """mm/min."""
        shown = self.editor.value()
        return self._given if shown == self._shown else shown * self.factor

    def show_value(self, value: float | None) -> None:
        """mm/min."""
        self._given = float(value or 0.0)
        self.editor.setValue(self._given / self.factor)
        self._shown = self.editor.value()

    def room(self) -> int:
        """Seven digits with their unit."""
        return width_of(self.editor, "00000.00" + self.editor.suffix()) + ARROW

    def words(self) -> str:
        """As in a program: ``F 1000``."""
        return f"F {self.editor.value():g}"


def feed_unit() -> tuple[str, float]:
    """The unit of feeds in a box, and how many of it one mm/s is.

    FreeCAD's own boxes take a plain number for mm/s, and refuse "mm/min" letter by letter.
    """
    inches = FreeCAD.Units.Quantity("1 mm/s").getUserPreferred()[2].startswith(("in", "ft", "mil"))
    return (" in/min", 60.0 / 25.4) if inches else (" mm/min", 60.0)


class ChoiceField(Field):
    """One of some names. ``choices``: pairs of the value and what it is called."""

    def __init__(self, name: str, choices: Sequence[tuple[Any, str]], hint: str = "") -> None:
        super().__init__(name, QtWidgets.QComboBox(), hint)
        self.editor.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.editor.setMinimumContentsLength(8)
        for value, text in choices:
            self.editor.addItem(text, value)
        self.editor.currentIndexChanged.connect(self._changed)

    def offer(self, unknown: Collection[Any]) -> None:
        """These values cannot be chosen for now, all others can."""
        model = self.editor.model()  # by indexes: PySide keeps what it hands out of Qt's own items longer than Qt has them
        for at in range(self.editor.count()):
            on = self.editor.itemData(at) not in unknown
            model.setData(model.index(at, 0), CHOSEN if on else 0, FLAGS)

    def explain(self, hints: Mapping[Any, str]) -> None:
        """What each choice means, as the tool tip of its line in the list."""
        for at in range(self.editor.count()):
            self.editor.setItemData(at, hints.get(self.editor.itemData(at), ""), QtCore.Qt.ToolTipRole)

    def value(self) -> Any:
        """The value of the chosen item."""
        return self.editor.currentData()

    def room(self) -> int:
        """The longest item."""
        texts = [self.editor.itemText(at) for at in range(self.editor.count())]
        return max((width_of(self.editor, text) for text in texts), default=0) + ARROW

    def words(self) -> str:
        """The chosen item; of what is switched on its label, of what is off or not given nothing."""
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
        editor = QtWidgets.QSpinBox() if whole else QtWidgets.QDoubleSpinBox()
        super().__init__(name, editor, hint)
        self.optional, self.whole = optional, whole
        editor.setRange(0 if optional else -10_000_000, 10_000_000)  # the core knows the range, and says it
        editor.setSpecialValueText(translate("FiveAxis", "not given") if optional else "")
        editor.valueChanged.connect(self._changed)

    def value(self) -> float | None:
        """The number."""
        return None if self.optional and self.editor.value() == 0 else self.editor.value()

    def show_value(self, value: float | None) -> None:
        """The number, or None."""
        self.editor.setValue(int(value or 0) if self.whole else float(value or 0.0))

    def room(self) -> int:
        """Six digits, or what says that there are none."""
        return width_of(self.editor, self.editor.specialValueText() or "000000") + ARROW


class SpindleField(NumberField):
    """The spindle's speed, 1/min; 0 leaves the spindle off, and the field warns of that."""

    def __init__(self, name: str, hint: str = "") -> None:
        super().__init__(name, hint, whole=True, optional=True)
        self._given = 0.0
        self.editor.setSingleStep(500)
        self.editor.setSuffix(translate("FiveAxis", " 1/min"))
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
        return width_of(self.editor, "00000" + self.editor.suffix()) + ARROW

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
        self.editor.textChanged.connect(self._changed)

    def value(self) -> str:
        """The text."""
        return self.editor.text().strip()

    def show_value(self, value: str | None) -> None:
        """The text."""
        self.editor.setText(value or "")

    def room(self) -> int:
        """What is to be typed there may be long."""
        return width_of(self.editor, self.editor.placeholderText() or "0" * 12)

    def words(self) -> str:
        """Label and text."""
        return f"{self.label} {self.value()}" if self.value() else ""


class TripleField(Field):
    """Three lengths (mm), three numbers, or three counts. ``none_text``: what a box says that, ticked, gives None."""

    def __init__(self, name: str, kind: str, hint: str = "", none_text: str = "", width: int = 60) -> None:
        super().__init__(name, QtWidgets.QWidget(), hint)
        parts = [f"{name}_{letter}" for letter in "xyz"]
        makers = {"point": lambda part: QuantityField(part, "length"), "counts": lambda part: NumberField(part, whole=True)}
        self.parts = [makers.get(kind, RatioField)(part) for part in parts]
        for part, letter in zip(self.parts, "XYZ", strict=True):
            part.editor.setAccessibleName(f"{self.label} {letter}")
        self.none = QtWidgets.QCheckBox(none_text) if none_text else None
        self.width = width
        self._lay_out()
        for part in self.parts:
            part.edited.connect(self._changed)

    def _lay_out(self) -> None:
        self.row = QtWidgets.QGridLayout(self.editor)
        self.row.setContentsMargins(0, 0, 0, 0)
        for at, part in enumerate(self.parts):
            part.editor.setMinimumWidth(self.width)
            self.row.addWidget(part.editor, 1, at)
        if self.none:
            self.row.addWidget(self.none, 0, 0, 1, 3, QtCore.Qt.AlignLeft)
            self.none.toggled.connect(self._toggled)

    def focus_widget(self) -> Any:
        """The first box."""
        return self.parts[0].editor

    def room(self) -> int:
        """Three numbers need the whole width, or their digits are cut."""
        return WIDE

    def words(self) -> str:
        """Label and numbers."""
        if self.value() is None:
            return ""
        texts = [str(part.editor.property("text")) for part in self.parts]
        units = {text.partition(" ")[2] for text in texts}
        if len(units) == 1:  # which need not be said three times
            texts[:2] = [text.partition(" ")[0] for text in texts[:2]]
        return f"{self.label} {', '.join(texts)}"

    def _toggled(self, ticked: bool) -> None:
        for part in self.parts:
            part.editor.setEnabled(not ticked)
        self._changed()

    def value(self) -> list[float] | None:
        """Three numbers, mm where they are lengths."""
        return None if self.none and self.none.isChecked() else [part.value() for part in self.parts]

    def show_value(self, value: Sequence[float] | None) -> None:
        """Three numbers, or None."""
        if self.none:
            self.none.setChecked(value is None)
        for part, number in zip(self.parts, value or (0.0, 0.0, 0.0), strict=True):
            part.show_value(number)


class RatioField(NumberField):
    """A number of a direction."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.editor.setDecimals(6)
        self.editor.setSingleStep(0.1)


def quantity(value: float, kind: str) -> Any:
    """A value in FreeCAD's own unit as a quantity that shows six digits. ``kind``: Length, Angle, Velocity, TimeSpan ..."""
    made = FreeCAD.Units.Quantity(value, getattr(FreeCAD.Units, kind))
    made.Format = dict(SHOWN)
    return made


def width_of(editor: Any, text: str) -> int:
    """Pixels of a text in the editor's font."""
    return int(editor.fontMetrics().boundingRect(text).width())


def error_line(name: str) -> Any:
    """A line in red, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setAccessibleDescription(translate("FiveAxis", "Error"))
    label.setWordWrap(True)
    label.setStyleSheet("color: #d0342c;")
    label.hide()
    return label


def warning_line(name: str) -> Any:
    """A line in amber, hidden until it says something."""
    label = error_line(name)
    label.setAccessibleDescription(translate("FiveAxis", "Warning"))
    label.setStyleSheet("color: #b06000;")
    return label


def note_line(name: str) -> Any:
    """A line in small letters, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setStyleSheet("color: #6b7785; font-size: small;")
    label.hide()
    return label


def option_field(leaf: Any, choices: Sequence[tuple[Any, str]] = (), none_text: str = "") -> Field:
    """The field of one option of the core's settings (a field of its dataclass).

    ``choices`` where it is one of some names; ``none_text`` for a triple that may be left open.
    """
    kind, hint = leaf.metadata["kind"], option_hint(leaf)
    optional = leaf.default is None
    if choices:
        return ChoiceField(leaf.name, choices, hint)
    makers: dict[str, Callable[[], Field]] = {
        "number": lambda: NumberField(leaf.name, hint, optional=optional),
        "count": lambda: NumberField(leaf.name, hint, whole=True, optional=optional),
        "text": lambda: TextField(leaf.name, hint),
        "stack": lambda: TextField(leaf.name, hint, STACK),
        "vector": lambda: TripleField(leaf.name, "vector", hint),
        "point": lambda: TripleField(leaf.name, "point", hint, none_text),
        "lengths": lambda: TripleField(leaf.name, "point", hint, none_text, 90),
        "counts": lambda: TripleField(leaf.name, "counts", hint, none_text),
        "feed": lambda: FeedField(leaf.name, hint),
    }
    return makers[kind]() if kind in makers else QuantityField(leaf.name, kind, hint, optional)
