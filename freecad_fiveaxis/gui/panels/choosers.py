# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that choose among what there is: the machine, the controller, the cutter, and scallop or
stepover."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.labels import choice_hint, choice_label, controller_label, option_label
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate
from freecad_fiveaxis.gui.wheel import leave_wheel

from .fields import ChoiceField, Field, QuantityField
from .files import machine_files
from .rows import Rows

LONG = 110
"""Pixels of a machine's name beside a label."""


class MachineField(ChoiceField):
    """The machines of the program, of the user's folder and of FreeCAD's, and a button for any other file.

    ``none_text``: the first item, which leaves the machine open; without it one has to be chosen.
    """

    def __init__(self, name: str, hint: str = "", none_text: str = "") -> None:
        from freecad_fiveaxis.app import machines

        super().__init__(name, [(None, none_text)] if none_text else [], hint)
        for at, choice in enumerate(machines.choices(), self.editor.count()):
            self.editor.addItem(choice.label, choice.machine)
            self.editor.setItemData(at, choice.error or choice.machine, QtCore.Qt.ToolTipRole)
        self.browse = QtWidgets.QToolButton()
        self.browse.setText("…")
        self.browse.setToolTip(translate("FiveAxis", "Choose a machine file (.fcm)"))
        self.browse.clicked.connect(self._browse)

    def room(self) -> int:
        """Names of files may be long: what is cut in the box, the list shows."""
        return min(super().room(), LONG)

    def has_head(self) -> bool:
        """Whether the chosen machine needs the tool's length."""
        return has_head(self.value() or "")

    def _browse(self, *_: Any) -> None:
        title = translate("FiveAxis", "Choose a machine file (.fcm)")
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.editor, title, "", machine_files())
        if path:
            self.show_value(path)


def has_head(machine: str) -> bool:
    """Whether a machine carries a rotary axis in its head, and so needs the tool's length."""
    from freecad_fiveaxis.core.base.errors import FiveAxisError
    from freecad_fiveaxis.core.machine import load_machine

    try:
        return bool(load_machine(machine).has_head)
    except FiveAxisError:
        return False  # whoever uses the machine tells why it cannot be used


class SpacingField(Field):
    """The distance of the passes: by the scallop they leave, or constant. Its values are ``scallop`` and
    ``stepover``."""

    KINDS = ("scallop", "stepover")
    has_own_labels = True

    def __init__(self, hints: dict[str, str]) -> None:
        super().__init__("spacing", QtWidgets.QWidget())
        self.kind = ChoiceField("spacing_kind", [(kind, option_label(kind)) for kind in self.KINDS])
        self.lengths = {kind: QuantityField(kind, "length", hints[kind]) for kind in self.KINDS}
        row = QtWidgets.QHBoxLayout(self.editor)
        row.setContentsMargins(0, 0, 0, 0)
        self.kind.editor.setMinimumWidth(self.kind.room())  # neither name is cut
        row.addWidget(self.kind.editor)
        for field in self.lengths.values():
            row.addWidget(field.editor, 1)
            field.nest()
            field.edited.connect(self._on_change)
        self.kind.edited.connect(self._turn)
        self._turn()

    def _turn(self) -> None:
        for kind, field in self.lengths.items():
            field.editor.setVisible(kind == self.kind.value())
        self._on_change()

    def parts_of(self) -> Sequence[Field]:
        """Return the one that counts."""
        return (self.lengths[self.kind.value()],)

    def value(self) -> dict[str, float | None]:
        """Return the one that counts, mm, by its name."""
        kind = self.kind.value()
        return {kind: self.lengths[kind].value()}

    def words(self) -> str:
        """Return the one that counts."""
        return self.lengths[self.kind.value()].words()

    def show_value(self, value: dict[str, float | None]) -> None:
        """``scallop`` and ``stepover`` in mm, None for the one that does not count."""
        for kind in self.KINDS:
            if value.get(kind) is not None:
                self.lengths[kind].show_value(value[kind])
                self.kind.show_value(kind)


CUTTER_SIZES = {
    "diameter": "length",
    "corner": "length",
    "taper": "angle",
    "neck": "length",
    "flank": "length",
    "length": "length",
}
"""The sizes of all kinds of cutters, and what each is."""


class ToolList(QtCore.QObject):
    """A list of tools under a ``title``, shown while there are any. ``chosen`` tells of one, a JobTool; the
    title comes back."""

    chosen = QtCore.Signal(object)

    def __init__(self, name: str, title: str) -> None:
        super().__init__()
        self.title, self.box = title, QtWidgets.QComboBox()
        self.tools: list[Any] = []
        self.box.setObjectName(name)
        self.box.setAccessibleName(title)
        self.box.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        leave_wheel(self.box)
        self.box.activated.connect(self._choose)
        self.offer([])

    def offer(self, tools: Sequence[Any]) -> None:
        """Offer the tools to choose from."""
        self.tools = list(tools)
        self.box.clear()
        self.box.addItem(self.title)
        self.box.addItems([f"T{tool.number} {tool.label}" for tool in self.tools])
        self.box.setVisible(bool(self.tools))

    def _choose(self, at: int) -> None:
        if at > 0:
            self.chosen.emit(self.tools[at - 1])
        self.box.setCurrentIndex(0)


def _tools_of_jobs(doc: Any) -> list[Any]:
    from freecad_fiveaxis.app import cam, tool_bit

    return [tool for job in cam.jobs_of(doc) for tool in tool_bit.cutters_of_job(job)]


class CutterField(Field):
    """A cutter: its kind and the sizes that it has, by hand, from a tool bit's file, or from a tool of a CAM
    Job or of the path's setup."""

    has_own_labels = True

    def __init__(self, name: str, hint: str, doc: Any) -> None:
        from freecad_fiveaxis.app.properties import CORNER, CUTTER, FLANK, NECK, TAPER
        from freecad_fiveaxis.core.tool import KINDS

        super().__init__(name, Rows(indent=0), hint)
        hints = {one.name: translate("App::Property", one.text) for one in CUTTER}
        self.kind = ChoiceField(
            "cutter_kind", [(kind, choice_label(kind)) for kind in KINDS], hints["CutterKind"]
        )
        self.sizes = {
            size: QuantityField("cutter_" + size, kind, hints["Cutter" + size.capitalize()])
            for size, kind in CUTTER_SIZES.items()
        }
        self.sizes["corner"].show_value(CORNER)
        self.sizes["taper"].show_value(TAPER)
        self.sizes["neck"].show_value(NECK)
        self.sizes["flank"].show_value(FLANK)
        self.file = QtWidgets.QPushButton(translate("FiveAxis", "From a tool file…"))
        self.job = ToolList("cutter_job", translate("FiveAxis", "From a CAM Job…"))
        self.setup = ToolList("cutter_setup", translate("FiveAxis", "From the setup…"))
        self._lay_out()
        self.job.offer(_tools_of_jobs(doc))
        self.file.clicked.connect(self._from_file)
        for chooser in (self.job, self.setup):
            chooser.chosen.connect(self._from_list)
        self.kind.edited.connect(self._turn)
        for part in self.sizes.values():
            part.nest()
            part.edited.connect(self._on_change)
        self._turn()

    def parts_of(self) -> Sequence[Field]:
        """Return the sizes that the kind has."""
        return [self.sizes[size] for size in self._list_sizes()]

    def _list_sizes(self) -> tuple[str, ...]:
        from freecad_fiveaxis.core.tool import KINDS

        return ("diameter", *KINDS[self.kind.value()], "length")

    def _lay_out(self) -> None:
        self.rows = {part.name: self.editor.add(part) for part in (self.kind, *self.sizes.values())}
        for chooser in (self.file, self.job.box, self.setup.box):
            self.editor.add_wide(chooser)

    def _turn(self) -> None:
        """Show the sizes that the kind has."""
        shown = self._list_sizes()
        for size, field in self.sizes.items():
            for widget in self.rows[field.name]:
                widget.setVisible(size in shown)
        self._on_change()

    def _from_list(self, tool: Any) -> None:
        self.show_error(tool.error)
        if tool.cutter:
            self._take(tool.cutter)

    def _from_file(self, *_: Any) -> None:
        title, kinds = (
            translate("FiveAxis", "Choose a tool file (.fctb)"),
            translate("FiveAxis", "Tool files (*.fctb)"),
        )
        path, _ = QtWidgets.QFileDialog.getOpenFileName(self.editor, title, "", kinds)
        if path:
            self.read_file(path)

    def read_file(self, path: str) -> None:
        """Take the cutter of a tool bit's file; one of no use here says why under the field."""
        from freecad_fiveaxis.app import tool_bit
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        try:
            self._take(tool_bit.cutter_of_file(path))
        except FiveAxisError as error:
            self.show_error(wording.localize(error))

    def _take(self, cutter: Any) -> None:
        self.show_value(cutter)
        self.edited.emit()

    def value(self) -> str:
        """As job files write it, ``ball:10.0:50.0``, mm and degrees; whether there can be such a cutter is
        the core's to say."""
        from freecad_fiveaxis.core.tool import sizes_text

        return sizes_text(
            self.kind.value(), {size: field.value() or 0.0 for size, field in self.sizes.items()}
        )

    def words(self) -> str:
        """Kind and diameter."""
        return f"{self.kind.words()} {self.sizes['diameter'].editor.property('text')}"

    def show_value(self, value: Any) -> None:
        """As job files write it (a missing length is the core's default), or the core's Cutter."""
        from freecad_fiveaxis.core.tool import Cutter, cutter_sizes, cutter_text

        kind, sizes = cutter_sizes(value if isinstance(value, str) else cutter_text(value))
        given = {"length": Cutter(1.0).length} | sizes
        for size, number in given.items():
            self.sizes[size].show_value(round(math.degrees(number), 12) if size == "taper" else number)
        self.kind.show_value(kind)


def controller_field(name: str, hint: str, reads: bool = False) -> ChoiceField:
    """Return the controllers; the first item leaves it to the machine, and where a text is read, to the text
    before that."""
    from freecad_fiveaxis.core.controllers import DIALECTS

    own = translate("FiveAxis", "by the text itself") if reads else translate("FiveAxis", "the machine's own")
    choices = [(None, own), *((dialect, controller_label(dialect)) for dialect in DIALECTS)]
    return ChoiceField(name, choices, hint)


def strategy_field(name: str, hint: str) -> ChoiceField:
    """Return the strategies for the tool axis, or for the passes."""
    from freecad_fiveaxis.core.orientation.strategies import STRATEGIES
    from freecad_fiveaxis.core.passes import PASS_STRATEGIES

    known = tuple(PASS_STRATEGIES if name == "passes" else STRATEGIES)
    field = ChoiceField(name, [(strategy, choice_label(strategy)) for strategy in known], hint)
    field.explain({strategy: choice_hint(name, strategy) for strategy in known})
    return field
