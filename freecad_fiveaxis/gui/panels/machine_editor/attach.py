# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies from what is selected in the user's documents: what carries them, where the machine's zero lies, and
how fine they are.

own       the editor's empty document, in which nothing can be selected.
before    the document that was active before it: the one whose solids are meant, as a rule.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.machine.bodies import BASE
from freecad_fiveaxis.gui.panels.fields import ChoiceField, Field, QuantityField
from freecad_fiveaxis.gui.panels.folding import FoldingGroup
from freecad_fiveaxis.gui.panels.picking import PointField
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate

from .table import show_items


class AttachFields(QtCore.QObject):
    """``group`` is what to show. ``found`` gives labels and meshes (mm, machine frame), ``refused`` what to
    do instead."""

    found = QtCore.Signal(object)
    refused = QtCore.Signal(str)

    def __init__(self) -> None:
        super().__init__()
        self.own = self.before = ""
        self.group = FoldingGroup(
            "attach", translate("FiveAxis", "From a document"), "machine-editor_attach", False
        )
        self.fields: dict[str, Field] = {field.name: field for field in _fields()}
        self.button = QtWidgets.QPushButton(translate("FiveAxis", "Attach the selected solid"))
        self.button.setObjectName("attach")
        self.button.clicked.connect(lambda *_: self.attach())
        self.group.body.add_wide(_hint())
        for field in self.fields.values():
            self.group.body.add(field)
        self.group.body.add_wide(self.button)

    @property
    def carrier(self) -> str:
        """What carries that which is attached."""
        return str(self.fields["attach_carrier"].value() or BASE)

    def show_carriers(self, items: Sequence[tuple[str, str]]) -> None:
        """Offer these carriers, value and text; the one that is chosen stays so while there is one of its
        name."""
        chosen = self.carrier
        show_items(self.fields["attach_carrier"], items)
        self.fields["attach_carrier"].show_value(chosen if chosen in dict(items) else BASE)

    def stand_beside(self, own: str, before: str) -> None:
        """Name the editor's document, and the one that was active before; points may be picked in documents
        opened later, too."""
        self.own, self.before = own, before
        button = self.fields["machine_zero"].button
        button.setEnabled(True)
        button.setToolTip("")

    def attach(self) -> None:
        """Attach what is selected."""
        from freecad_fiveaxis.app import attaching

        try:
            chosen = attaching.paths(self._find_selected())
            if not chosen:
                self.refused.emit(self._what_to_select())
                return
            for field in self.fields.values():
                field.check()
            zero, deviation = (self.fields[name].value() for name in ("machine_zero", "attach_deviation"))
            self.found.emit(attaching.surfaces(chosen, zero, deviation))
        except Cancelled:
            return
        except FiveAxisError as error:
            self.refused.emit(wording.localize(error))

    def _find_selected(self) -> list[tuple[Any, Sequence[str]]]:
        """Return what is selected in the user's documents, from the outermost object on."""
        rows = FreeCADGui.Selection.getSelectionEx("*", 0)
        return [(row.Object, row.SubElementNames) for row in rows if row.Object.Document.Name != self.own]

    def _what_to_select(self) -> str:
        documents = {name: doc for name, doc in FreeCAD.listDocuments().items() if name != self.own}
        if not documents:
            return str(translate(
                "FiveAxis",
                "No document of yours is open: open the one that holds the solid, select it there, and press "
                "this again.",
            ))  # fmt: skip
        doc = documents.get(self.before) or next(iter(documents.values()))
        text = translate(
            "FiveAxis",
            "Nothing is selected: select solids, meshes, parts or links of “{}” in the tree or a view, then "
            "press this again.",
        )
        return str(text.format(doc.Label))

    def stop(self) -> None:
        """Pick no point any more: the panel closes."""
        self.fields["machine_zero"].pick.stop()


def _hint() -> Any:
    label = QtWidgets.QLabel(translate(
        "FiveAxis",
        "Select solids, meshes, parts or links in any document. Its coordinates are taken for the "
        "machine's, with all axes at zero. Saving writes them as STL files beside the machine's file.",
    ))  # fmt: skip
    label.setObjectName("attach_hint")
    label.setWordWrap(True)
    return label


def _fields() -> list[Field]:
    deviation = QuantityField("attach_deviation", "length", translate(
        "FiveAxis",
        "About how far facets may lie beside the solid; a clearance makes up for it"))  # fmt: skip
    deviation.show_value(0.1)
    return [
        ChoiceField("attach_carrier", [], translate("FiveAxis", "The axis that moves what is attached, or "
            "the spindle")),
        PointField("machine_zero", translate("FiveAxis", "The point of the document that is the machine's "
            "zero")),
        deviation,
    ]  # fmt: skip
