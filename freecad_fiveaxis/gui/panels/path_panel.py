# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panels of a tool path and of an audit share: a form, Calculate, a summary, OK and Cancel.

step      all that the panel does to the document, from the first Calculate to OK, is one step of undo; Cancel
          and Esc take it back.
stale     the form says something else than what was calculated last; OK then calculates first.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import FreeCAD
import FreeCADGui

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.gui import keys
from freecad_fiveaxis.gui.failures import attend
from freecad_fiveaxis.gui.messages import ask, status, warn
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets, flags, later, translate
from freecad_fiveaxis.gui.shown_parts import ShownParts
from freecad_fiveaxis.gui.undo import OpenStep, is_there
from freecad_fiveaxis.gui.waiting import waiting

from .form import Form
from .panel_widget import PanelWidget, shorten_title
from .summary import Summary

DRAWN = 500
"""ms after which something new is drawn."""

FAR = 120 * 1000
"""A thousand notches of the wheel: to the very top."""


class PathPanel:
    """A task panel. A subclass fills ``form``, and says how to ``compute``; it may show another
    ``summary``."""

    SUMMARY: type = Summary
    CREATES_PROGRAM = True
    """The program is made here: one that is not safe is kept only when the user says so."""

    def __init__(self, doc: Any, title: str, form: Form, obj: Any = None) -> None:
        self.doc, self.title, self.options, self.obj = doc, title, form, obj
        self.draft, self.gone = obj is None, False
        self.step = OpenStep(doc, title)
        self.calculated: dict[str, Any] | None = None
        self.calculate_button = QtWidgets.QPushButton(translate("FiveAxis", "Calculate"))
        self.calculate_button.setObjectName("calculate")
        self.summary, self.shown_parts = self.SUMMARY(), ShownParts()
        self.form = self._widget(title)
        self.calculate_button.clicked.connect(lambda *_: self.calculate())
        form.edited.connect(self._on_edit)

    def _widget(self, title: str) -> Any:
        return PanelWidget(
            title,
            (self.calculate_button, self.summary, self.shown_parts, self.options.error),
            self.options.widget,
        )

    def fill(self, values: Mapping[str, Any]) -> None:
        """Show these values; an object that is there shows its last result."""
        self.options.show_options(values)
        self.calculated = self.options.read_values() if not self.draft and self.is_current() else None
        self._on_edit()

    def is_current(self) -> bool:
        """Whether the object that is there shows the result of its part and its settings."""
        from freecad_fiveaxis.app import results

        return self.obj.Blocks > 0 and "Touched" not in self.obj.State and not results.out_of_date(self.obj)

    def look_again(self) -> None:
        """Forget the summary where the part has changed since, or whatever else it is of; not while it is
        being computed, when nothing fits yet."""
        from freecad_fiveaxis.app import long_work

        if long_work.is_running():
            return
        try:
            self.forget_gone()
            if self.calculated is not None and not self.is_current():
                self.calculated = None
                self._on_edit()
        except (ReferenceError, RuntimeError):  # the object was deleted, or the panel closed by somebody else
            return

    @property
    def stale(self) -> bool:
        """Whether OK has to calculate."""
        return self.calculated is None or self.calculated != self.options.read_values()

    def forget_gone(self) -> None:
        """Where the object was undone or deleted, what is computed next is a new one; one that was there
        before is gone for good."""
        if self.obj is None or is_there(self.obj):
            return
        self.obj = self.calculated = None
        self.gone = not self.draft
        self._on_edit()

    def compute(self) -> Any:
        """Make or change the object in the document and compute it; returns it. Raises FiveAxisError."""
        raise NotImplementedError

    def finish(self) -> None:
        """Add what OK adds to a computed object."""

    def calculate(self) -> bool:
        """Compute what the form says and show the summary; whether that went well. Otherwise the document is
        as before."""
        self.options.want()
        self.forget_gone()
        if not self.options.check() or self._say_gone():
            self.summary.forget()
            return False
        self.step.begin()
        try:
            with waiting(self.title):
                self.obj = self.compute()
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._undone()
            self._tell(error)
            return False
        self.calculated = self.options.read_values()
        self._on_edit()
        reveal(self.form)
        return True

    def _say_gone(self) -> bool:
        """Say in red that the object has gone; whether it has."""
        text = translate("FiveAxis", "What this panel changes was deleted or undone meanwhile: press Cancel.")
        if self.gone:
            self.options.show_error(text)
            reveal(self.form)
        return self.gone

    def _undone(self) -> None:
        self.step.take_back()
        self.obj, self.calculated = None if self.draft else self.obj, None
        self.summary.forget()

    def _tell(self, error: BaseException) -> None:
        from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

        if isinstance(error, Cancelled):
            status(translate("FiveAxis", "Stopped; the document is as it was."))
            return
        if not isinstance(error, (FiveAxisError, ReferenceError)):
            raise error
        gone = translate("FiveAxis", "The part was deleted meanwhile: press Cancel, and select another one.")
        self.options.show_error(gone if isinstance(error, ReferenceError) else wording.localize(error))
        reveal(self.form)

    def _on_edit(self) -> None:
        self.forget_gone()
        self.options.check()
        if self.stale:
            self.summary.forget()
        else:
            self.summary.show_result(self.obj)
        self._show_parts()

    def _show_parts(self) -> None:
        """Show the switches of what the view draws of the path."""
        self.shown_parts.show_for(self.obj)

    def getStandardButtons(self) -> int:
        """FreeCAD asks which buttons the panel has."""
        return flags(QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        """OK: calculate if that is not done, keep what there is, close. The panel stays where something
        cannot be used, and where the path is not safe and the user goes back to change that."""
        self.look_again()
        if (self.stale and not self.calculate()) or not self._ask_to_keep() or not self._try_to_finish():
            return False
        self.step.keep()
        self._close()
        return True

    def _ask_to_keep(self) -> bool:
        if not self.CREATES_PROGRAM or self.obj.Light != "red":
            return True
        text = self.obj.Verdict + "\n\n" + translate("FiveAxis", "Keep this path anyway?")
        return ask(text, translate("FiveAxis", "Keep anyway"), translate("FiveAxis", "Go back"))

    def _try_to_finish(self) -> bool:
        try:
            with waiting(self.title):
                self.finish()
        except BaseException as error:  # FreeCADAbort (Esc) is no Exception
            self._undone()
            self._tell(error)
            return False
        return True

    def reject(self) -> bool:
        """Cancel or Esc: the document is as it was."""
        self.step.take_back()
        self._close()
        return True

    def _close(self) -> None:
        for field in self.options.fields.values():
            if hasattr(field, "pick"):
                field.pick.stop()
        _shown.clear()
        FreeCADGui.Control.closeDialog()
        if self.step.has_document() and FreeCADGui.getDocument(self.doc.Name).getInEdit():
            FreeCADGui.getDocument(self.doc.Name).resetEdit()


def show(panel: Any) -> Any:
    """Open a panel in the task view. Only one panel can be open."""
    if FreeCADGui.Control.activeDialog():
        later(
            lambda: warn(translate("FiveAxis", "Another task panel is open: close it first."))
        )  # the pointer is still busy
        return panel
    attend(panel)
    shorten_title(panel.form)
    FreeCADGui.Control.showDialog(panel)
    keys.belong_to(panel.form)
    _shown[:] = [panel]
    return panel


_shown: list[Any] = []
"""The panel that was shown last."""
_due: list[Any] = []
"""It, where it is to look at the document once the window is idle."""


def look_again(doc: Any) -> None:
    """Have the panel that is open over a document see, once the window is idle, whether it is out of date."""
    if _shown and not _due and getattr(_shown[0], "doc", None) is doc and hasattr(_shown[0], "look_again"):
        _due.append(_shown[0])
        later(lambda: _due.pop().look_again())


def fit(name: str) -> None:
    """Show all of a document, unless it was closed meanwhile."""
    if name in FreeCAD.listDocuments() and hasattr(FreeCADGui.getDocument(name).ActiveView, "fitAll"):
        FreeCADGui.getDocument(name).ActiveView.fitAll()


def fit_soon(doc: Any) -> None:
    """Show all of a document once what is new is drawn, unless it was closed meanwhile."""
    name = doc.Name
    QtCore.QTimer.singleShot(DRAWN, lambda: fit(name))


def is_seen(name: str, box: Any) -> bool:
    """Whether half of a box of the document, as it stands on the screen, lies in its view; true where it has
    no 3D view."""
    view = FreeCADGui.getDocument(name).ActiveView
    if not hasattr(view, "getPointOnScreen"):
        return True
    corners = [view.getPointOnScreen(*box.getPoint(at)) for at in range(8)]
    inside, whole = 1.0, 1.0
    for spots, size in zip(zip(*corners, strict=True), view.getSize(), strict=True):
        inside *= max(min(max(spots), size) - max(min(spots), 0), 0)
        whole *= max(max(spots) - min(spots), 1)
    return inside >= whole / 2


def reveal(form: Any) -> None:
    """Scroll the task view to the panel's head, where summary and buttons are.

    The wheel is turned over the panel and Qt hands it on to whatever scrolls it. FreeCAD's own widgets around
    the panel are never touched from here: under PySide2 the wrappers of a panel's fields die with those of
    the widgets around them.
    """
    later(lambda: _scroll_up(form))


def _scroll_up(form: Any) -> None:
    try:
        middle = QtCore.QPointF(form.rect().center())
        around = QtCore.QPointF(form.mapToGlobal(form.rect().center()))
    except RuntimeError:  # PySide: already deleted, the panel was closed meanwhile
        return
    turn = QtGui.QWheelEvent(
        middle, around, QtCore.QPoint(), QtCore.QPoint(0, FAR), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
        QtCore.Qt.NoScrollPhase, False,
    )  # fmt: skip
    QtWidgets.QApplication.sendEvent(form, turn)
