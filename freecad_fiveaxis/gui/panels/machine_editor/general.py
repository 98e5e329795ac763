# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a draft says of the machine as a whole: its name, its controller, and where gauge point, work zero and
table are."""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.machine.editing import MachineDraft
from freecad_fiveaxis.gui.panels.choosers import controller_field
from freecad_fiveaxis.gui.panels.fields import Field, TextField
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.panels.triple import TripleField
from freecad_fiveaxis.gui.qt import QtCore, translate

from .boxes import OpenField

CHANGES = {
    "machine_name": "name", "machine_description": "description", "machine_controller": "controller",
    "gauge_point": "gauge_point", "machine_origin": "origin", "table_height": "table",
}  # fmt: skip
"""What each field is of a draft."""


class GeneralFields(QtCore.QObject):
    """``group`` is what to show. ``edited`` tells that the user changed something."""

    edited = QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self.draft: MachineDraft | None = None
        self.filling = False
        self.group = FoldingGroup("machine", translate("FiveAxis", "Machine"), "machine-editor_machine")
        self.fields: dict[str, Field] = {field.name: field for field in _fields()}
        for field in self.fields.values():
            self.group.body.add(field)
            field.edited.connect(self._on_change)

    def _on_change(self) -> None:
        if not self.filling:
            self.edited.emit()

    def show_draft(self, draft: MachineDraft) -> None:
        """Fill the fields."""
        self.filling, self.draft = True, draft
        for name, field in self.fields.items():
            value = getattr(draft, CHANGES[name])
            field.show_value(None if value == "" else value)
        self.filling = False
        self.group.show_state(draft.name)

    def apply(self, draft: MachineDraft) -> MachineDraft:
        """Return the draft with what the fields say."""
        values = {CHANGES[name]: field.value() for name, field in self.fields.items()}
        values = {name: tuple(value) if isinstance(value, list) else value for name, value in values.items()}
        self.group.show_state(values["name"])
        return replace(draft, **(values | {"controller": values["controller"] or ""}))


def _fields() -> list[Field]:
    controller = controller_field(
        "machine_controller", translate("FiveAxis", "The controller that its programs are for")
    )
    controller.editor.setItemText(0, translate("FiveAxis", "not given"))
    return [
        TextField("machine_name", translate("FiveAxis", "What the lists call the machine")),
        TextField("machine_description", translate("FiveAxis", "A line about it")),
        controller,
        TripleField("gauge_point", "point", translate(
            "FiveAxis",
            "Where the spindle's gauge point, from which tools are measured, is with all axes at zero")),
        TripleField("machine_origin", "point", translate(
            "FiveAxis", "Where the work zero usually lies, in machine coordinates with all axes at zero")),
        OpenField("table_height", translate("FiveAxis", "not known"), None, translate(
            "FiveAxis",
            "Z of the face that parts are clamped on, in machine coordinates with all axes at zero")),
    ]  # fmt: skip
