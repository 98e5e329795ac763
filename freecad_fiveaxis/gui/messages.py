# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user is told: a message box for what cannot be done, the status bar for what was stopped."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD

from .qt import QtWidgets, execute, main_window, translate


def warn(text: str) -> None:
    """Show a message box with one sentence that says what to do."""
    box = QtWidgets.QMessageBox(main_window())
    box.setObjectName("FiveAxisMessage")
    box.setIcon(QtWidgets.QMessageBox.Warning)
    box.setWindowTitle(translate("FiveAxis", "Five-axis"))
    box.setText(text)
    FreeCAD.Console.PrintWarning(text + "\n")
    execute(box)


def ask(text: str, yes: str, no: str = "") -> bool:
    """Whether the user answers with ``yes``, the text of that button; the other one, which Enter and Esc
    mean, is ``no``, or Cancel."""
    box = QtWidgets.QMessageBox(main_window())
    box.setObjectName("FiveAxisQuestion")
    box.setIcon(QtWidgets.QMessageBox.Question)
    box.setWindowTitle(translate("FiveAxis", "Five-axis"))
    box.setText(text)
    agreed = box.addButton(yes, QtWidgets.QMessageBox.AcceptRole)
    other = (
        box.addButton(no, QtWidgets.QMessageBox.RejectRole)
        if no
        else box.addButton(QtWidgets.QMessageBox.Cancel)
    )
    box.setDefaultButton(other)
    box.setEscapeButton(other)
    execute(box)
    return box.clickedButton() is agreed or box.clickedButton() == agreed


def status(text: str) -> None:
    """Show the text for a few seconds in the status bar."""
    main_window().statusBar().showMessage(text, 8000)


@contextmanager
def telling() -> Iterator[None]:
    """Yield what the work within cannot use is told in a message box; stopped work in the status bar. Other
    errors go on."""
    from freecad_fiveaxis.app import wording
    from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError

    try:
        yield
    except Cancelled:
        status(translate("FiveAxis", "Stopped; the document is as it was."))
    except FiveAxisError as error:
        warn(wording.localize(error))
