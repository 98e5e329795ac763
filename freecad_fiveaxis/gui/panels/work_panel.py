# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels share whose work is about files and not about a document: a form, Calculate, the result, OK
and Cancel.

result    what was found, to be read before anything is written; OK writes it.
stale     the form says something else than what was calculated last; OK then calculates first.
lent      an empty document that is open only while the panel is: FreeCAD 1.1 lays its task panels over a
          view, and hides them where there is none.
"""

from __future__ import annotations

import os
from typing import Any, TypeVar

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.gui.messages import ask, status
from freecad_fiveaxis.gui.qt import QtWidgets, flags, later, translate
from freecad_fiveaxis.gui.waiting import waiting

from .form import Form
from .panel_widget import PanelWidget
from .path_panel import reveal, show

P = TypeVar("P", bound="WorkPanel")

TALL, LOW = 300, 60
"""Pixels of the result, and of the line that says there is none."""
OVERLAYS = (1, 0)
"""The version of FreeCAD from which on the task view may lie over a view, as the user likes."""


class WorkPanel:
    """A task panel. A subclass says how to ``compute``, what to ``tell`` of it (HTML), which ``files`` OK
    writes and how to ``write`` them; ``buttons`` are enabled while there is a result."""

    def __init__(self, title: str, form: Form, buttons: tuple[Any, ...] = ()) -> None:
        self.title, self.options, self.buttons = title, form, buttons
        self.done: Any = None
        self.temporary_document = ""
        self.calculated: dict[str, Any] | None = None
        self.calculate_button = QtWidgets.QPushButton(translate("FiveAxis", "Calculate"))
        self.calculate_button.setObjectName("calculate")
        self.result = QtWidgets.QTextBrowser()
        self.result.setObjectName("result")
        self.result.setOpenLinks(False)
        self.form = self._widget(title)
        self.calculate_button.clicked.connect(lambda *_: self.calculate())
        form.edited.connect(self._on_edit)
        self._on_edit()

    def _widget(self, title: str) -> Any:
        head = (self.calculate_button, self.result, *self.buttons, self.options.error)
        return PanelWidget(title, head, self.options.widget)

    @property
    def stale(self) -> bool:
        """Whether OK has to calculate."""
        return self.calculated is None or self.calculated != self.options.read_values()

    def compute(self) -> Any:
        """Do the work; nothing is written. Raises FiveAxisError."""
        raise NotImplementedError

    def tell(self, done: Any) -> str:
        """Return what was found, as HTML."""
        raise NotImplementedError

    def files(self, done: Any) -> list[str]:
        """Return the files that OK writes."""
        raise NotImplementedError

    def write(self, done: Any, overwrite: bool) -> None:
        """Write the files. Raises FiveAxisError; then none is written."""
        raise NotImplementedError

    def calculate(self) -> bool:
        """Do the work and show what was found; whether that went well."""
        self.options.want()
        if not self.options.check():
            return False
        try:
            with waiting(self.title):
                self.done = self.compute()
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self.done = self.calculated = None
            self._on_edit()
            self.show_error(error)
            return False
        self.calculated = self.options.read_values()
        self._on_edit()
        reveal(self.form)
        return True

    def show_error(self, error: BaseException) -> None:
        """Why there is no result, or why it cannot be written, in red; errors that are not of our kind go
        on."""
        from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

        if isinstance(error, Cancelled):
            status(translate("FiveAxis", "Stopped; nothing was written."))
            return
        if not isinstance(error, FiveAxisError):
            raise error
        self.options.show_error(wording.localize(error))
        reveal(self.form)

    def _on_edit(self) -> None:
        self.options.check()
        shown = not self.stale
        page = (
            self.tell(self.done)
            if shown
            else translate("FiveAxis", "Press Calculate to see what is found. OK writes it.")
        )
        self.result.setHtml(page)
        self.result.setFixedHeight(TALL if shown else LOW)
        for button in self.buttons:
            button.setEnabled(shown)

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        """OK: calculate if that is not done, write, close. The panel stays where something cannot be used or
        is not agreed to."""
        if self.stale and not self.calculate():
            return False
        files = self.files(self.done)
        there = [path for path in files if os.path.lexists(path)]
        question = translate("FiveAxis", "These files are there already. Replace them?")
        if there and not ask(question + "\n\n" + "\n".join(there), translate("FiveAxis", "Replace")):
            return False
        try:
            with waiting(self.title):
                self.write(self.done, bool(there))
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self.show_error(error)
            return False
        status(translate("FiveAxis", "Written: {}").format(", ".join(files)))
        self._close()
        return True

    def reject(self) -> bool:
        """Cancel or Esc: nothing is written."""
        self._close()
        return True

    def _close(self) -> None:
        for field in self.options.fields.values():
            if hasattr(field, "pick"):
                field.pick.stop()
        FreeCADGui.Control.closeDialog()
        if self.temporary_document:
            later(lambda: give_back(self.temporary_document))


def open_panel(panel: P) -> P:
    """Open the panel in the task view; with a lent document where it would be hidden without one."""
    if not FreeCADGui.Control.activeDialog() and not FreeCAD.listDocuments() and may_lie_over_a_view():
        panel.temporary_document = FreeCAD.newDocument().Name
    return show(panel)


def may_lie_over_a_view() -> bool:
    """Whether this FreeCAD may hide the task view where there is no view. It is not asked of its windows:
    under PySide2 a panel's fields die with the wrappers of the windows around them."""
    return tuple(int(part) for part in FreeCAD.Version()[:2]) >= OVERLAYS


def give_back(name: str) -> None:
    """Close an empty document that was open for a panel alone, unless the user has made it his own."""
    doc = FreeCAD.listDocuments().get(name)
    if doc is not None and not doc.Objects and not doc.FileName:
        FreeCAD.closeDocument(name)
