# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in the window: stage, percent and a Cancel button, while the window goes on being painted.

The work runs in a thread of its own (:mod:`freecad_fiveaxis.app.long_work`); the window's thread shows what
is told of it and handles events. Cancel and Esc raise ``Cancelled`` out of ``pump``. The dialog is modal, so
that nothing can be changed under the work.

FreeCAD keeps keys and mouse from all windows while it recomputes a document. Esc still comes, as a shortcut
of the dialog; where the mouse is pressed is asked for instead.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCAD

from . import keys
from .qt import QtCore, QtGui, QtWidgets, main_window, translate

REPAINT = 0.05
"""s between two looks at the window's events; more often would cost more than the work."""
STILL = 1.0
"""s after which a fraction that does not move is shown as work without one: the bar runs to and fro."""
UNSEEN = 0.1
"""s of work that nobody asked for, as a recompute, before the dialog comes up."""


class Waiting:
    """A listener for progress that shows a dialog, after ``delay`` s of work."""

    def __init__(self, text: str, delay: float = 0.0) -> None:
        dialog = QtWidgets.QProgressDialog(text, translate("FiveAxis", "Cancel"), 0, 100, main_window())
        self.button = dialog.findChild(QtWidgets.QPushButton)
        dialog.setObjectName("FiveAxisWaiting")
        dialog.setWindowTitle(text)
        dialog.setWindowModality(QtCore.Qt.ApplicationModal)
        dialog.setMinimumDuration(0)
        dialog.setMinimumWidth(420)
        dialog.setAutoClose(False)
        dialog.setAutoReset(False)
        dialog.reset()  # Qt would show it by itself after a while
        self.dialog, self.text, self._due, self._stage = dialog, text, 0.0, ""
        self._reported, self._moved = ("", 0.0), time.monotonic()
        self._shown, self._pressed, self._show_at = False, False, time.monotonic() + delay

    def start(self) -> None:
        """Show the dialog before the work begins."""
        self._shown = True
        self.dialog.setValue(0)
        self.dialog.show()
        QtWidgets.QApplication.processEvents()

    def __call__(self, stage: str, fraction: float) -> None:
        """Show the stage (a word of the core) and its fraction, 0 to 1. Raises Cancelled once the user wants
        to stop."""
        now = time.monotonic()
        if (stage, fraction) != self._reported:
            self._reported, self._moved = (stage, fraction), now
        if now < self._due and stage == self._stage:
            return
        self._due, self._stage = now + REPAINT, stage
        self.dialog.setLabelText(f"{self.text}\n{stage_words().get(stage, stage)}")
        if self._shown and now - self._moved <= STILL:
            self.dialog.setMaximum(100)
            self.dialog.setValue(round(100 * min(max(fraction, 0.0), 1.0)))
        self.pump()

    def pump(self) -> None:
        """Handle the window's events. Raises Cancelled once the user wants to stop."""
        if not self._shown:
            if time.monotonic() < self._show_at:
                return
            self.start()
        if time.monotonic() - self._moved > STILL:
            self.dialog.setMaximum(0)
        QtWidgets.QApplication.processEvents()
        if self.dialog.wasCanceled() or self._is_cancel_clicked():
            from freecad_fiveaxis.core.base.errors import Cancelled

            raise Cancelled(translate("FiveAxis", "stopped by the user"))

    def _is_cancel_clicked(self) -> bool:
        """Whether the mouse was pressed and let go over Cancel while FreeCAD keeps its events from all
        windows."""
        if not any(doc.Recomputing for doc in FreeCAD.listDocuments().values()):
            return False
        over = self.button.rect().contains(self.button.mapFromGlobal(QtGui.QCursor.pos()))
        pressed = bool(QtWidgets.QApplication.mouseButtons() & QtCore.Qt.LeftButton)
        clicked, self._pressed = self._pressed and over and not pressed, over and pressed
        return clicked

    def stop(self) -> None:
        """Take the dialog away."""
        self.dialog.close()
        self.dialog.deleteLater()


def stage_words() -> dict[str, str]:
    """Return what the stages of the core are called; one that is new says its own name."""
    return {
        "tessellate": translate("FiveAxis", "meshing the solid"),
        "read STL": translate("FiveAxis", "reading the mesh"),
        "weld": translate("FiveAxis", "joining facets"),
        "placing planes": translate("FiveAxis", "placing the passes"),
        "placing passes": translate("FiveAxis", "placing the passes"),
        "slice": translate("FiveAxis", "cutting the mesh"),
        "closing co-edges": translate("FiveAxis", "closing gaps at edges"),
        "linking passes": translate("FiveAxis", "linking the passes"),
        "joint path": translate("FiveAxis", "turning the axes"),
        "linearize": translate("FiveAxis", "dividing blocks"),
        "minimax axes": translate("FiveAxis", "seeking the axes of least deviation"),
        "axis field": translate("FiveAxis", "seeking axes that are free of the part"),
        "leading past the pole": translate("FiveAxis", "turning the axis past the pole"),
        "driving what is led": translate("FiveAxis", "driving the turned axes"),
        "trade of axis change": translate("FiveAxis", "comparing axis changes"),
        "gouge": translate("FiveAxis", "looking where the tool enters the part"),
        "lift": translate("FiveAxis", "lifting the tool out of the part"),
        "tilt": translate("FiveAxis", "tilting the tool out of the part"),
        "what is left": translate("FiveAxis", "measuring what is left"),
        "reach": translate("FiveAxis", "looking where the tool gets"),
        "setup map": translate("FiveAxis", "trying setups"),
        "compare": translate("FiveAxis", "comparing machines"),
        "feeds": translate("FiveAxis", "setting feeds"),
        "writing text": translate("FiveAxis", "writing NC blocks"),
        "reading NC": translate("FiveAxis", "reading the NC file"),
        "reading CL": translate("FiveAxis", "reading the CL file"),
        "recover": translate("FiveAxis", "fitting machines"),
        "prove signs": translate("FiveAxis", "planning safe moves"),
        "deviation": translate("FiveAxis", "proving the deviation"),
        "deviation by So et al.": translate("FiveAxis", "deviation by So et al."),
    }


@contextmanager
def waiting(text: str) -> Iterator[Waiting]:
    """Show a dialog of that title for all long work within a ``with``; the work can be stopped there."""
    from freecad_fiveaxis.app.long_work import reporting

    listener = Waiting(text)
    listener.start()
    try:
        with reporting(listener):
            yield listener
    finally:
        listener.stop()
        keys.give_back()


def find_for_drawing(obj: Any, find: Callable[[Any, Waiting], Any]) -> tuple[Any, str]:
    """Find what is to be drawn of an object, after its document was opened; or give None and why that failed,
    for the legend: the object is touched then, and the report view says why too."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

    try:
        with waiting(translate("FiveAxis", "Draw {label}").format(label=obj.Label)) as listener:
            return find(obj, listener), ""
    except Cancelled:
        return None, translate("FiveAxis", "Not drawn, as you stopped it: recompute to draw it")
    except FiveAxisError as error:
        obj.touch()
        FreeCAD.Console.PrintError(f"{obj.Label}: {error}\n")
        return None, wording.localize(error)


@contextmanager
def busy() -> Iterator[None]:
    """Yield the pointer says that a panel is on its way: its many fields take up to half a second, the first
    time more."""
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    finally:
        QtWidgets.QApplication.restoreOverrideCursor()


@contextmanager
def recomputing() -> Iterator[Waiting]:
    """Yield the dialog of long work that no command began, as of a recompute; short work shows none."""
    listener = Waiting(translate("FiveAxis", "Recompute"), UNSEEN)
    try:
        yield listener
    finally:
        listener.stop()


def register() -> None:
    """Long work that nobody else listens to is shown here."""
    from freecad_fiveaxis.app.progress_window import show_progress_in

    show_progress_in(recomputing)
