# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog of a Setup, which opens beside a task panel too, and the field of a tool path that chooses
one."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from freecad_fiveaxis.gui.qt import QtWidgets, execute, translate
from freecad_fiveaxis.gui.undo import transaction

from .fields import ChoiceField, TextField
from .form import Form, Section
from .panel_widget import PanelWidget
from .triple import TripleField

FIELDS = ("setup_name", "machine", "controller", "tool_length", "origin", "work_offset", "work_zero")
SHARED = FIELDS[1:]
"""What the paths of a setup take from it."""
FAR = ("origin", "work_offset", "work_zero")
"""Of these the fields that stand in other groups than the setup's own: they say whence they are."""


class SetupDialog(QtWidgets.QDialog):
    """Edits the values of a Setup; ``options`` is the form that holds them."""

    def __init__(self, doc: Any, values: dict[str, Any], obj: Any = None) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setObjectName("FiveAxisSetup")
        title = (
            translate("FiveAxis", "New setup") if obj is None else translate("FiveAxis", "Edit setup {name}")
        )
        self.setWindowTitle(title.format(name=values["setup_name"]))
        extras = [TextField("setup_name"), TripleField("work_zero", "point", _zero_hint())]
        section = Section("setup", translate("FiveAxis", "Setup"), FIELDS)
        self.options = Form("mill", doc, [section], extras, only=SHARED[:-1])
        buttons = QtWidgets.QDialogButtonBox(
            QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel
        )
        form = PanelWidget(self.windowTitle(), (self.options.error,), self.options.widget)
        form.setObjectName("setup_form")
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(form)
        column.addWidget(buttons)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self.options.edited.connect(self.options.check)
        self.options.show_options(values)
        self.resize(420, 420)

    def accept(self) -> None:
        """Accept the fields; the dialog stays where something cannot be used."""
        from freecad_fiveaxis.app import job_setup, wording
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        if not self.options.check():
            return
        try:
            job_setup.check(self.options.options())
        except FiveAxisError as error:
            self.options.show_error(wording.localize(error))
            return
        super().accept()


def ask(doc: Any, obj: Any = None, values: dict[str, Any] | None = None) -> Any:
    """Return the Setup ``obj`` with other values, or a new one that begins with ``values``, as the user
    wishes; None: he cancels."""
    from freecad_fiveaxis.app import job_setup

    name = obj.Label if obj is not None else translate("FiveAxis", "Setup")
    begun = read_values(obj) if obj is not None else first_values() | (values or {})
    dialog = SetupDialog(doc, {"setup_name": name} | begun, obj)
    agreed, values = execute(dialog), dialog.options.read_values()
    dialog.deleteLater()
    if not agreed:
        return None
    name, zero = values.pop("setup_name"), values.pop("work_zero")
    if obj is None:
        obj = job_setup.create(doc, values | {"work_zero": zero})
    else:
        job_setup.put(obj, values, zero)
    obj.Label = name or obj.Name
    return obj


def edit(doc: Any, obj: Any = None) -> Any:
    """Make or change a Setup in one step of undo, and compute its paths; returns it, or None."""
    with transaction(doc, translate("FiveAxis", "Setup")):
        setup = ask(doc, obj)
        if setup is not None:
            doc.recompute()
    return setup


def read_values(obj: Any) -> dict[str, Any]:
    """Every value of a Setup as a form shows it, None where it is not given."""
    from freecad_fiveaxis.app import job_setup

    return dict.fromkeys(SHARED) | job_setup.options_of(obj)


def first_values() -> dict[str, Any]:
    """Of a new Setup: the user's preferences."""
    from freecad_fiveaxis.app import preferences

    values = {"machine": preferences.machine(), "controller": preferences.controller(), "work_offset": "G54"}
    return dict.fromkeys(SHARED) | values | {"work_zero": (0.0, 0.0, 0.0)}


class SetupField(ChoiceField):
    """The Setup that a path takes its machine from, or none; the button edits it, or makes one of what the
    form says."""

    def __init__(self, doc: Any) -> None:
        from freecad_fiveaxis.app import job_setup

        own = translate("FiveAxis", "own values")
        choices = [(None, own), *((one.Name, one.Label) for one in job_setup.setups_of(doc))]
        super().__init__(
            "setup",
            choices,
            translate("FiveAxis", "Machine, controller and work zero that several paths share"),
        )
        self.doc = doc
        self.browse = QtWidgets.QToolButton()
        self.browse.setObjectName("setup_edit")
        self.edited.connect(self._name_button)
        self._name_button()

    def value(self) -> Any:
        """Return the Setup, or None."""
        name = super().value()
        return self.doc.getObject(name) if name else None

    def show_value(self, value: Any) -> None:
        """Show a Setup, which joins the list where it is new, or None."""
        if value is not None and self.editor.findData(value.Name) < 0:
            self.editor.addItem(value.Label, value.Name)
        super().show_value(value.Name if value is not None else None)
        self._name_button()

    def forget_gone(self) -> None:
        """Setups that are no longer in the document leave the list; where one was chosen, there is none
        now."""
        for at in reversed(range(1, self.editor.count())):
            if self.doc.getObject(self.editor.itemData(at)) is None:
                if self.editor.currentIndex() == at:
                    self.editor.setCurrentIndex(0)
                self.editor.removeItem(at)

    def words(self) -> str:
        """Its name."""
        return self.value().Label if self.value() is not None else ""

    def _name_button(self) -> None:
        edits = self.value() is not None
        self.browse.setText(translate("FiveAxis", "Edit") if edits else translate("FiveAxis", "Share"))
        change = translate("FiveAxis", "Edit the setup: all its paths follow")
        share = translate("FiveAxis", "Make a setup of these values, so that other paths take them too")
        self.browse.setToolTip(change if edits else share)


def _zero_hint() -> str:
    return translate("FiveAxis", "The point of the part that is the program's zero")
