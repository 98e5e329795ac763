# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form made from the core's settings: one field for each option of a task, in sections.

section   a titled box of fields. MORE is the last one, folded up: every option that no other section names.
options   what the form says, flat, as job files write it; an option that is not given is not in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .choosers import CutterField, MachineField, SpacingField, controller_field, strategy_field
from .fields import Field, error_line, option_field
from .labels import choice_label, option_hint, option_label

SPACING = "spacing"
MORE = "more"

Section = tuple[str, str, Sequence[str]]
"""Name, title, and the names of the fields in their order."""

DEPENDS = (
    ("tool_axis", "fixed", ("axis",), ()),
    ("tool_axis", "minimax", ("max_tilt",), ("lead", "tilt")),
    ("singularity", "deform", ("max_axis_change",), ()),
)
"""A choice and its value; the options that count only then, and those that do not count then."""


class Form(QtCore.QObject):
    """The fields of one task. ``edited`` tells that any of them changed; ``widget`` is what to show."""

    edited = QtCore.Signal()

    def __init__(
        self, task: str, doc: Any, sections: Sequence[Section], extras: Sequence[Field] = (), group: str = "",
        given: Mapping[str, Any] | None = None,
    ) -> None:  # fmt: skip
        """``group``: the settings class whose options alone are asked for; ``given``: options that are settled elsewhere."""
        super().__init__()
        from freecad_fiveaxis.core.settings import option_fields

        self.task, self.given = task, dict(given or {})
        fields = [leaf for cls, leaf in option_fields(task) if group in ("", cls.__name__)]
        self.leaves = {leaf.name: leaf for leaf in fields if leaf.metadata["kind"] not in ("path", "paths")}
        self.extras = {field.name: field for field in extras}
        self.fields = {**self._option_fields(doc), **self.extras}
        self.rows: dict[str, list[Any]] = {}
        self.widget = QtWidgets.QWidget()
        self.error = error_line("form_error")
        self._lay_out(sections)
        for field in self.fields.values():
            field.edited.connect(self._changed)
        self._depend()

    def _option_fields(self, doc: Any) -> dict[str, Field]:
        special = {
            "machine": lambda leaf: MachineField(leaf.name, option_hint(leaf)),
            "controller": lambda leaf: controller_field(leaf.name, option_hint(leaf)),
            "tool_axis": lambda leaf: strategy_field(leaf.name, option_hint(leaf)),
            "cutter": lambda leaf: CutterField(leaf.name, option_hint(leaf), doc),
        }
        made = {}
        for name, leaf in self.leaves.items():
            if name not in SpacingField.KINDS:
                made[name] = special.get(name, _plain)(leaf)
        if SpacingField.KINDS[0] in self.leaves:
            made[SPACING] = SpacingField({kind: option_hint(self.leaves[kind]) for kind in SpacingField.KINDS})
        return made

    def _lay_out(self, sections: Sequence[Section]) -> None:
        column = QtWidgets.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        for name, title, names in sections:
            column.addWidget(self._box(name, title, names))
        named = {name for _, _, names in sections for name in names}
        rest = [name for name in self.fields if name not in named]
        if rest:
            column.addWidget(self._folded(self._box(MORE, translate("FiveAxis", "More settings"), rest)))

    def _box(self, name: str, title: str, names: Sequence[str]) -> Any:
        box = QtWidgets.QGroupBox(title)
        box.setObjectName("section_" + name)
        grid = QtWidgets.QGridLayout(box)
        grid.setColumnStretch(1, 1)
        for field in (self.fields[name] for name in names):
            self._add_row(grid, field)
        return box

    def _add_row(self, grid: Any, field: Field) -> None:
        row = grid.rowCount()
        beside = getattr(field, "browse", None)
        if field.name == "cutter":  # its sizes bear their own labels
            grid.addWidget(field.editor, row, 0, 1, 3)
            self.rows[field.name] = [field.editor]
        else:
            label = QtWidgets.QLabel(translate("FiveAxis", "Spacing by") if field.name == SPACING else option_label(field.name))
            grid.addWidget(label, row, 0)
            grid.addWidget(field.editor, row, 1, 1, 1 if beside else 2)
            self.rows[field.name] = [label, field.editor]
        if beside:
            grid.addWidget(beside, row, 2)
        grid.addWidget(field.error, row + 1, 0, 1, 3)

    def _folded(self, box: Any) -> Any:
        """A box that opens when its title is ticked."""
        box.setCheckable(True)
        inner = [box.layout().itemAt(at).widget() for at in range(box.layout().count())]
        labels = [widget for widget in inner if not widget.objectName().endswith("_error")]

        def fold(opened: bool) -> None:
            for widget in labels:
                widget.setVisible(opened)

        box.toggled.connect(fold)
        box.setChecked(False)
        return box

    def _changed(self) -> None:
        self._depend()
        self.edited.emit()

    def _depend(self) -> None:
        """Show only the fields that count for the machine and the choices made."""
        if "tool_length" in self.rows and "machine" in self.fields:
            self._show_row("tool_length", self.fields["machine"].has_head())
        idle = self._idle()
        for name in (one for _, _, only, never in DEPENDS for one in (*only, *never)):
            if name in self.rows:
                self._show_row(name, name not in idle)

    def _idle(self) -> set[str]:
        """The options that count for nothing as the choices stand: they are not shown, not checked and not given."""
        return {
            name
            for choice, value, only, never in DEPENDS
            if choice in self.fields
            for name in (never if self.fields[choice].value() == value else only)
        }

    def _show_row(self, name: str, shown: bool) -> None:
        for widget in self.rows[name]:
            widget.setVisible(shown)

    def options(self) -> dict[str, Any]:
        """What the form says, without the extras."""
        said: dict[str, Any] = {}
        for name, field in self.fields.items():
            if name not in self.extras:
                said.update(field.value() if name == SPACING else {name: field.value()})
        idle = self._idle()
        return {name: value for name, value in said.items() if value is not None and value != "" and name not in idle}

    def said(self) -> dict[str, Any]:
        """The options and the extras."""
        return self.options() | {name: field.value() for name, field in self.extras.items()}

    def show_options(self, options: Mapping[str, Any]) -> None:
        """Fill the fields; one that the options do not name keeps what it shows."""
        for name, field in self.fields.items():
            if name == SPACING:
                field.show_value({kind: options.get(kind) for kind in SpacingField.KINDS})
            elif name in options:
                field.show_value(options[name])
        self._depend()

    def check(self) -> bool:
        """Whether the core takes the values; where it does not, the fields say why."""
        from freecad_fiveaxis.core.errors import FiveAxisError
        from freecad_fiveaxis.core.settings import build_settings

        options = self.options()
        good = [self._check_field(name, field, options) for name, field in self.fields.items()]
        self.show_error("")
        if all(good):
            try:
                build_settings(self.task, "part", self.given | options)
            except FiveAxisError as error:
                self.show_error(str(error))
                return False
        return all(good)

    def _check_field(self, name: str, field: Field, options: Mapping[str, Any]) -> bool:
        from freecad_fiveaxis.core.errors import FiveAxisError

        field.show_error("")
        try:
            field.check()
            self._try(name, options)
        except FiveAxisError as error:
            field.show_error(str(error))
            return False
        return True

    def _try(self, name: str, options: Mapping[str, Any]) -> None:
        from freecad_fiveaxis.core.errors import SettingsError
        from freecad_fiveaxis.core.machine import load_machine
        from freecad_fiveaxis.core.settings import read_option

        for given in SpacingField.KINDS if name == SPACING else (name,):
            if given in options:
                read_option(self.leaves[given], options[given])
        if name == "machine":
            load_machine(options.get(name, ""))
        if name == "tool_length" and name not in options and self.fields["machine"].has_head():
            raise SettingsError(
                translate("FiveAxis", "This machine's head turns: give the length from the gauge point to the tip.")
            )

    def show_error(self, text: str) -> None:
        """What is wrong with the values together; an empty text takes it away. The panel places the line ``error``."""
        self.error.setText(text)
        self.error.setVisible(bool(text))


def _plain(leaf: Any) -> Field:
    choices = [(name, choice_label(name)) for name in leaf.metadata["choices"]]
    none_text = translate("FiveAxis", "as the machine file says") if leaf.default is None else ""
    if leaf.metadata["kind"] == "counts":
        none_text = translate("FiveAxis", "as many as take some seconds")
    return option_field(leaf, choices, none_text)
