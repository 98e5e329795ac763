# SPDX-License-Identifier: LGPL-2.1-or-later
"""A form made from the core's settings: one field for each option of a task, in sections.

section   a group of fields that folds. MORE is the last one: every option that no other section names.
options   what the form says, flat, as job files write it; an option that is not given is not in it.
idle      an option that counts for nothing as the choices stand: hidden where another choice says so, shown
          with the reason where the controller does not know it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.labels import choice_hint, choice_label, controller_label, group_label, option_hint
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .abilities import LACKING, check_guide, reasons, unknown_choices
from .choosers import CutterField, MachineField, SpacingField, controller_field, strategy_field
from .depends import DEPENDS, idle_options
from .fields import Field
from .files import any_file
from .folding import FoldingGroup
from .lines import error_line
from .option_fields import option_field

SPACING = "spacing"
MORE = "more"


class Section(NamedTuple):
    """``names`` of the fields in their order; ``in_title``: of those whose words stand in the title;
    ``opened`` until the user folds it; ``about``: words before them."""

    name: str
    title: str
    names: Sequence[str]
    in_title: Sequence[str] = ()
    opened: bool = True
    about: str = ""


CHECKS = ("off", "report")
"""The choices of ``gouge`` that change no pass."""

READING = ("audit", "recover")
"""Tasks that read a program: its text may say itself which controller it is for."""
ANY_MACHINE = ("recover",)
"""Tasks that need no machine."""


def group_sections(task: str, less: Sequence[str] = ()) -> list[tuple[str, str, list[str]]]:
    """Name, title and options of each group of a task's settings, so that options that are added appear by
    themselves; but for those in ``less``, which are left to MORE."""
    from freecad_fiveaxis.app.properties import group_of, list_options

    groups: dict[str, list[str]] = {}
    for cls, leaf in list_options(task):
        if leaf.name not in less:
            groups.setdefault(group_of(cls, leaf), []).append(leaf.name)
    return [(name.lower(), group_label(name), names) for name, names in groups.items()]


class Form(QtCore.QObject):
    """The fields of one task. ``edited`` tells that any of them changed; ``widget`` is what to show."""

    edited = QtCore.Signal()

    def __init__(
        self, task: str, doc: Any, sections: Sequence[Any], extras: Sequence[Field] = (), group: str = "",
        given: Mapping[str, Any] | None = None, only: Sequence[str] = (),
    ) -> None:  # fmt: skip
        """``sections``: Sections, or plain tuples of their first fields; ``group``: the settings class whose
        options alone are asked for, ``only``: the options that alone are; ``given``: options that are settled
        elsewhere."""
        super().__init__()
        from freecad_fiveaxis.app.properties import list_options

        self.task, self.given = task, dict(given or {})
        self.leaves = {leaf.name: leaf for cls, leaf in list_options(task) if group in ("", cls.__name__)}
        self.leaves = {name: leaf for name, leaf in self.leaves.items() if not only or name in only}
        self.extras = {field.name: field for field in extras}
        self.fields = {**self._option_fields(doc), **self.extras}
        self.wished: dict[str, Any] = {}
        self.filling = False
        self.rows: dict[str, list[Any]] = {}
        self.groups: dict[str, FoldingGroup] = {}
        self.widget = QtWidgets.QWidget()
        self.error = error_line("form_error")
        self.sections = self._with_more([Section(*given) for given in sections])
        self._lay_out()
        for field in self.fields.values():
            field.edited.connect(self._on_change)
        if self.task == "audit" and "gouge" in self.fields:  # which changes no pass
            self.fields["gouge"].offer(
                {choice for choice in self.leaves["gouge"].metadata["choices"] if choice not in CHECKS}
            )
        self._depend()

    def _option_fields(self, doc: Any) -> dict[str, Field]:
        special: dict[str, Callable[[Any], Field]] = {
            "machine": lambda leaf: MachineField(leaf.name, option_hint(leaf), self._no_machine()),
            "controller": lambda leaf: controller_field(leaf.name, option_hint(leaf), self.task in READING),
            "tool_axis": lambda leaf: strategy_field(leaf.name, option_hint(leaf)),
            "passes": lambda leaf: strategy_field(leaf.name, option_hint(leaf)),
            "cutter": lambda leaf: CutterField(leaf.name, option_hint(leaf), doc),
        }
        fields = {}
        for name, leaf in self.leaves.items():
            if name not in SpacingField.KINDS and name not in self.extras:
                fields[name] = special.get(name, _plain)(leaf)
        if SpacingField.KINDS[0] in self.leaves:
            fields[SPACING] = SpacingField(
                {kind: option_hint(self.leaves[kind]) for kind in SpacingField.KINDS}
            )
        return fields

    def _no_machine(self) -> str:
        return translate("FiveAxis", "none") if self.task in ANY_MACHINE else ""

    def _with_more(self, sections: list[Section]) -> list[Section]:
        """Return the sections, and one with the fields that none of them names."""
        named = {name for section in sections for name in section.names}
        rest = [name for name in self.fields if name not in named]
        return [
            *sections,
            *([Section(MORE, translate("FiveAxis", "More settings"), rest, opened=False)] if rest else []),
        ]

    def _lay_out(self) -> None:
        column = QtWidgets.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        for section in self.sections:
            group = FoldingGroup(section.name, section.title, f"{self.task}_{section.name}", section.opened)
            column.addWidget(group)  # while it is empty: Qt tells all that stands in a widget of a new parent
            for name in section.names:
                self.rows[name] = group.body.add(self.fields[name])
            self.groups[section.name] = group

    def _tell(self) -> None:
        """Tell what the fields say in the titles of their groups."""
        for section in self.sections:
            shown = [name for name in section.in_title if not self.rows[name][0].isHidden()]
            words = [section.about, *(self._words(name) for name in shown)]
            self.groups[section.name].show_state(", ".join(filter(None, words)))

    def _words(self, name: str) -> str:
        dialect = self.dialect() if name == "controller" else None
        return controller_label(dialect.name) if dialect else self.fields[name].words()

    def _unfold_errors(self) -> None:
        for section in self.sections:
            if any(self.fields[name].says("error") for name in section.names):
                self.groups[section.name].unfold()

    def _on_change(self) -> None:
        if not self.filling:
            self._depend()
            self.edited.emit()

    def _depend(self) -> None:
        """Show only the fields that count for the machine and the choices made; those that its controller
        lacks are idle."""
        if "tool_length" in self.rows and "machine" in self.fields and self.task not in ANY_MACHINE:
            self._show_row("tool_length", self.fields["machine"].has_head())
        self._lack()
        idle = idle_options(self.fields)
        for name in (one for _, _, only, never in DEPENDS for one in (*only, *never)):
            if name in self.rows:
                self._show_row(name, name not in idle)
        self._tell()

    def dialect(self) -> Any:
        """Return the core's table of the controller that is chosen, or of the machine's own; None where that
        is not known."""
        if not {"machine", "controller"} <= set(self.fields):
            return None
        from freecad_fiveaxis.app.controllers import dialect_of

        return dialect_of(self.fields["controller"].value(), self.fields["machine"].value())

    def _lack(self) -> None:
        """Keep what the controller does not know from being chosen; what was chosen before comes back with a
        controller that does."""
        dialect = self.dialect()
        if dialect is None:
            return
        texts = reasons(dialect)
        for name in ("rtcp", "high_speed", "feed_mode"):
            if name in self.rows:
                self._lack_of(name, self.fields[name], texts.get(name, ""))
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

    def _show_row(self, name: str, shown: bool) -> None:
        for widget in self.rows[name]:
            widget.setVisible(shown)

    def options(self) -> dict[str, Any]:
        """Return what the form says, without the extras that are no options."""
        values: dict[str, Any] = {}
        for name, field in self.fields.items():
            if name in self.leaves or name == SPACING:
                values.update(field.value() if name == SPACING else {name: field.value()})
        idle = idle_options(self.fields)
        return {
            name: value
            for name, value in values.items()
            if value is not None and value != "" and name not in idle
        }

    def read_values(self) -> dict[str, Any]:
        """Return the options and the extras."""
        values = self.options() | {
            name: field.value() for name, field in self.extras.items() if name not in self.leaves
        }
        links = {name: field.link for name, field in self.fields.items() if hasattr(field, "link")}
        return values | (
            {"picked": {name: link for name, link in links.items() if link and name in values}}
            if links
            else {}
        )

    def show_options(self, options: Mapping[str, Any]) -> None:
        """Fill the fields; one that the options do not name keeps what it shows. ``edited`` tells of it once,
        at the end."""
        self.filling = True
        for name, field in self.fields.items():
            if name == SPACING:
                field.show_value({kind: options.get(kind) for kind in SpacingField.KINDS})
            elif name in options:
                self.wished.pop(name, None)
                field.show_value(options[name])
            if "picked" in options and hasattr(field, "show_link"):
                field.show_link(options["picked"].get(name))
        self.filling = False
        self._on_change()

    def want(self) -> None:
        """Call a file that is not named yet an error from now on: the user asks for the result."""
        for field in self.fields.values():
            field.want()

    def check(self) -> bool:
        """Whether the core takes the values; where it does not, the fields say why."""
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        options = self.options()
        good = [self._check_field(name, field, options) for name, field in self.fields.items()]
        self._unfold_errors()
        self.show_error("")
        if all(good) and not self._lacks_file():
            try:
                self.check_together(options)
            except FiveAxisError as error:
                self.show_error(wording.localize(error))
                return False
        return all(good)

    def _lacks_file(self) -> bool:
        """Whether an option names a file that is needed and not named yet: nobody has done anything wrong so
        far."""
        files: list[Any] = [
            field for name, field in self.fields.items() if name in self.leaves and hasattr(field, "missing")
        ]
        return any(field.missing and not field.value() and not field.wanted for field in files)

    def check_together(self, options: Mapping[str, Any]) -> None:
        """Raise FiveAxisError where values contradict each other."""
        from freecad_fiveaxis.app.auditing import audit_options
        from freecad_fiveaxis.core.pipeline.settings import build_settings

        part = self.extras["part"].value() if "part" in self.extras else None
        options = audit_options(options, part) if self.task == "audit" else options
        build_settings(self.task, "part", self.given | dict(options))

    def _check_field(self, name: str, field: Field, options: Mapping[str, Any]) -> bool:
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        field.show_error("")
        try:
            field.check()
            self._try(name, options)
        except FiveAxisError as error:
            field.show_error(wording.localize(error))
            return False
        return True

    def _try(self, name: str, options: Mapping[str, Any]) -> None:
        from freecad_fiveaxis.core.base.errors import SettingsError
        from freecad_fiveaxis.core.machine import load_machine
        from freecad_fiveaxis.core.pipeline.option_values import read_option

        for given in SpacingField.KINDS if name == SPACING else (name,):
            if given in options and given in self.leaves:
                read_option(self.leaves[given], options[given])
        if name == "machine" and (name in options or self.task not in ANY_MACHINE):
            load_machine(options.get(name, ""))
        if name == "rtcp" and (dialect := self.dialect()) is not None:
            check_guide(dialect, options)
        if name == "nc_units" and options.get(name) == "inch" and (dialect := self.dialect()) is not None:
            dialect.in_inches()
        if (
            name == "tool_length"
            and name not in options
            and self.task not in ANY_MACHINE
            and self.fields["machine"].has_head()
        ):
            raise SettingsError(
                translate(
                    "FiveAxis", "This machine's head turns: give the length from the gauge point to the tip."
                )
            )

    def show_error(self, text: str) -> None:
        """Show what is wrong with the values together; an empty text takes it away. The panel places the line
        ``error``."""
        self.error.setText(text)
        self.error.setVisible(bool(text))


def _show_quietly(field: Field, value: Any) -> None:
    """Show a value; whoever calls tells himself that the form has changed."""
    field.editor.blockSignals(True)
    field.show_value(value)
    field.editor.blockSignals(False)


def _plain(leaf: Any) -> Field:
    if leaf.metadata["kind"] in ("path", "curve"):
        return any_file(leaf)
    choices = [(name, choice_label(name)) for name in leaf.metadata["choices"]]
    none_text = translate("FiveAxis", "as the machine file says") if leaf.default is None else ""
    if leaf.metadata["kind"] == "counts":
        none_text = translate("FiveAxis", "automatic (some seconds)")
    field = option_field(leaf, choices, none_text)
    if choices:
        field.explain({name: choice_hint(leaf.name, name) for name, _ in choices})
    return field
