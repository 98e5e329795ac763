# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form made from the core's settings: one field for each option of a task, in sections.

section   a titled box of fields. MORE is the last one, folded up: every option that no other section names.
options   what the form says, flat, as job files write it; an option that is not given is not in it.
idle      an option that counts for nothing as the choices stand: hidden where another choice says so, shown with the reason
          where the controller does not know it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .abilities import LACKING, check_guide, reasons, unknown_choices
from .choosers import CutterField, MachineField, SpacingField, controller_field, strategy_field
from .fields import Field, TripleField, error_line, option_field
from .files import any_file
from .labels import choice_label, group_label, option_hint, option_label

SPACING = "spacing"
MORE = "more"

Section = tuple[str, str, Sequence[str]]
"""Name, title, and the names of the fields in their order."""


def _is(value: str) -> Callable[[Any], bool]:
    return lambda chosen: bool(chosen == value)


def _is_not(value: str) -> Callable[[Any], bool]:
    return lambda chosen: bool(chosen != value)


def _is_path(against: Any) -> bool:
    return bool(against) and not _is_part(against)


def _is_part(against: Any) -> bool:
    from freecad_fiveaxis.core.settings import is_part

    return bool(against) and is_part(str(against))


DEPENDS: tuple[tuple[str, Callable[[Any], bool], Sequence[str], Sequence[str]], ...] = (
    ("tool_axis", _is("fixed"), ("axis",), ()),
    ("tool_axis", _is("minimax"), ("max_tilt",), ("lead", "tilt")),
    ("gouge", _is("tilt"), ("max_tilt",), ()),
    ("singularity", _is("deform"), ("max_axis_change",), ()),
    ("rtcp", _is_not("off"), (), ("linearize",)),
    ("against", _is_path, ("axis_tolerance",), ()),
    ("against", _is_part, ("cutter", "gouge"), ()),
)
"""A choice and what is asked of it; the options that count only if that holds (of several such lines: any), and those that do
not count then."""

CHECKS = ("off", "report")
"""The choices of ``gouge`` that change no pass."""

READING = ("audit", "recover")
"""Tasks that read a program: its text may say itself which controller it is for."""
ANY_MACHINE = ("recover",)
"""Tasks that need no machine."""


def group_sections(task: str, less: Sequence[str] = (), only: str = "") -> list[Section]:
    """A section for each group of a task's settings, so that options that are added appear by themselves; but for those in
    ``less``, which are left to MORE. ``only``: of this settings class."""
    from freecad_fiveaxis.app.properties import shown_options

    groups: dict[str, list[str]] = {}
    for cls, leaf in shown_options(task):
        if leaf.name not in less and only in ("", cls.__name__):
            groups.setdefault(cls.__name__, []).append(leaf.name)
    return [(name.removesuffix("Settings").lower(), group_label(name), names) for name, names in groups.items()]


class Form(QtCore.QObject):
    """The fields of one task. ``edited`` tells that any of them changed; ``widget`` is what to show."""

    edited = QtCore.Signal()

    def __init__(
        self, task: str, doc: Any, sections: Sequence[Section], extras: Sequence[Field] = (), group: str = "",
        given: Mapping[str, Any] | None = None,
    ) -> None:  # fmt: skip
        """``group``: the settings class whose options alone are asked for; ``given``: options that are settled elsewhere."""
        super().__init__()
        from freecad_fiveaxis.app.properties import shown_options

        self.task, self.given = task, dict(given or {})
        self.leaves = {leaf.name: leaf for cls, leaf in shown_options(task) if group in ("", cls.__name__)}
        self.extras = {field.name: field for field in extras}
        self.fields = {**self._option_fields(doc), **self.extras}
        self.wished: dict[str, Any] = {}
        self.rows: dict[str, list[Any]] = {}
        self.widget = QtWidgets.QWidget()
        self.error = error_line("form_error")
        self._lay_out(sections)
        for field in self.fields.values():
            field.edited.connect(self._changed)
        if self.task == "audit" and "gouge" in self.fields:  # which changes no pass
            self.fields["gouge"].offer({choice for choice in self.leaves["gouge"].metadata["choices"] if choice not in CHECKS})
        self._depend()

    def _option_fields(self, doc: Any) -> dict[str, Field]:
        special = {
            "machine": lambda leaf: MachineField(leaf.name, option_hint(leaf), self._no_machine()),
            "controller": lambda leaf: controller_field(leaf.name, option_hint(leaf), self.task in READING),
            "tool_axis": lambda leaf: strategy_field(leaf.name, option_hint(leaf)),
            "cutter": lambda leaf: CutterField(leaf.name, option_hint(leaf), doc),
        }
        made = {}
        for name, leaf in self.leaves.items():
            if name not in SpacingField.KINDS and name not in self.extras:
                made[name] = special.get(name, _plain)(leaf)
        if SpacingField.KINDS[0] in self.leaves:
            made[SPACING] = SpacingField({kind: option_hint(self.leaves[kind]) for kind in SpacingField.KINDS})
        return made

    def _no_machine(self) -> str:
        return translate("FiveAxis", "none") if self.task in ANY_MACHINE else ""

    def _lay_out(self, sections: Sequence[Section]) -> None:
        column = QtWidgets.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        for name, title, names in sections:
            column.addWidget(self._box(name, title, names))
        named = {name for _, _, names in sections for name in names}
        rest = [name for name in self.fields if name not in named]
        if rest:
            column.addWidget(self._folded(self._box(MORE, translate("FiveAxis", "More settings"), rest), rest))

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
        if field.name == "cutter":  # kind and sizes bear their own labels
            grid.addWidget(field.editor, row, 0, 1, 3)
            self.rows[field.name] = [field.editor]
        elif isinstance(field, TripleField):  # three numbers need the whole width, or their digits are cut
            label = QtWidgets.QLabel(option_label(field.name))
            grid.addWidget(label, row, 0, 1, 3)
            row += 1
            grid.addWidget(field.editor, row, 0, 1, 3)
            self.rows[field.name] = [label, field.editor]
        else:
            label = QtWidgets.QLabel(translate("FiveAxis", "Spacing by") if field.name == SPACING else option_label(field.name))
            grid.addWidget(label, row, 0)
            grid.addWidget(field.editor, row, 1, 1, 1 if beside else 2)
            self.rows[field.name] = [label, field.editor]
        if beside:
            grid.addWidget(beside, row, 2)
        grid.addWidget(field.error, row + 1, 0, 1, 3)
        grid.addWidget(field.note, row + 2, 0, 1, 3)

    def _folded(self, box: Any, names: Sequence[str]) -> Any:
        """A box with the fields ``names`` that opens when its title is ticked."""
        box.setCheckable(True)
        beside = [self.fields[name].browse for name in names if hasattr(self.fields[name], "browse")]
        inner = [widget for name in names for widget in self.rows[name]] + beside

        def fold(opened: bool) -> None:
            for widget in inner:
                widget.setVisible(opened)

        box.toggled.connect(fold)
        box.setChecked(False)
        return box

    def _changed(self) -> None:
        self._depend()
        self.edited.emit()

    def _depend(self) -> None:
        """Show only the fields that count for the machine and the choices made; those that its controller lacks are idle."""
        if "tool_length" in self.rows and "machine" in self.fields and self.task not in ANY_MACHINE:
            self._show_row("tool_length", self.fields["machine"].has_head())
        self._lack()
        idle = self._idle()
        for name in (one for _, _, only, never in DEPENDS for one in (*only, *never)):
            if name in self.rows:
                self._show_row(name, name not in idle)

    def dialect(self) -> Any:
        """The core's table of the controller that is chosen, or of the machine's own; None where that is not known."""
        if not {"machine", "controller"} <= set(self.fields):
            return None
        from freecad_fiveaxis.app.controllers import dialect_of

        return dialect_of(self.fields["controller"].value(), self.fields["machine"].value())

    def _lack(self) -> None:
        """What the controller does not know cannot be chosen; what was chosen before comes back with a controller that does."""
        dialect = self.dialect()
        if dialect is None:
            return
        said = reasons(dialect)
        for name in ("rtcp", "high_speed", "feed_mode"):
            if name in self.rows:
                self._lack_of(name, self.fields[name], said.get(name, ""))
        for name, unknown in unknown_choices(dialect).items():
            if name in self.rows:
                self.fields[name].offer(unknown)

    def _lack_of(self, name: str, field: Field, reason: str) -> None:
        field.show_note(reason)
        if name not in LACKING:
            return
        if reason and field.value() != LACKING[name]:
            self.wished[name] = field.value()
            _show_quietly(field, LACKING[name])
        elif not reason and name in self.wished:
            _show_quietly(field, self.wished.pop(name))

    def _idle(self) -> set[str]:
        """The options that count for nothing as the choices stand: they are not shown, not checked and not given."""
        asked = [
            (holds(self.fields[choice].value()), only, never) for choice, holds, only, never in DEPENDS if choice in self.fields
        ]
        wanted = {name for true, only, _ in asked if true for name in only}
        return {name for true, only, never in asked for name in (never if true else set(only) - wanted)}

    def _show_row(self, name: str, shown: bool) -> None:
        for widget in self.rows[name]:
            widget.setVisible(shown)

    def options(self) -> dict[str, Any]:
        """What the form says, without the extras that are no options."""
        said: dict[str, Any] = {}
        for name, field in self.fields.items():
            if name in self.leaves or name == SPACING:
                said.update(field.value() if name == SPACING else {name: field.value()})
        idle = self._idle()
        return {name: value for name, value in said.items() if value is not None and value != "" and name not in idle}

    def said(self) -> dict[str, Any]:
        """The options and the extras."""
        return self.options() | {name: field.value() for name, field in self.extras.items() if name not in self.leaves}

    def show_options(self, options: Mapping[str, Any]) -> None:
        """Fill the fields; one that the options do not name keeps what it shows."""
        for name, field in self.fields.items():
            if name == SPACING:
                field.show_value({kind: options.get(kind) for kind in SpacingField.KINDS})
            elif name in options:
                self.wished.pop(name, None)
                field.show_value(options[name])
        self._depend()

    def check(self) -> bool:
        """Whether the core takes the values; where it does not, the fields say why."""
        from freecad_fiveaxis.core.errors import FiveAxisError

        options = self.options()
        good = [self._check_field(name, field, options) for name, field in self.fields.items()]
        self.show_error("")
        if all(good):
            try:
                self.check_together(options)
            except FiveAxisError as error:
                self.show_error(str(error))
                return False
        return all(good)

    def check_together(self, options: Mapping[str, Any]) -> None:
        """Raises FiveAxisError where values contradict each other."""
        from freecad_fiveaxis.app.auditing import asked
        from freecad_fiveaxis.core.settings import build_settings

        options = asked(options) if self.task == "audit" else options
        build_settings(self.task, "part", self.given | dict(options))

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
        from freecad_fiveaxis.core.option_values import read_option

        for given in SpacingField.KINDS if name == SPACING else (name,):
            if given in options and given in self.leaves:
                read_option(self.leaves[given], options[given])
        if name == "machine" and (name in options or self.task not in ANY_MACHINE):
            load_machine(options.get(name, ""))
        if name == "rtcp" and (dialect := self.dialect()) is not None:
            check_guide(dialect, options)
        if name == "tool_length" and name not in options and self.task not in ANY_MACHINE and self.fields["machine"].has_head():
            raise SettingsError(
                translate("FiveAxis", "This machine's head turns: give the length from the gauge point to the tip.")
            )

    def show_error(self, text: str) -> None:
        """What is wrong with the values together; an empty text takes it away. The panel places the line ``error``."""
        self.error.setText(text)
        self.error.setVisible(bool(text))


def _show_quietly(field: Field, value: Any) -> None:
    """Show a value; whoever calls tells himself that the form has changed."""
    field.editor.blockSignals(True)
    field.show_value(value)
    field.editor.blockSignals(False)


def _plain(leaf: Any) -> Field:
    if leaf.metadata["kind"] == "path":
        return any_file(leaf)
    choices = [(name, choice_label(name)) for name in leaf.metadata["choices"]]
    none_text = translate("FiveAxis", "as the machine file says") if leaf.default is None else ""
    if leaf.metadata["kind"] == "counts":
        none_text = translate("FiveAxis", "as many as take some seconds")
    return option_field(leaf, choices, none_text)
