# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is told once an NC file is written: where it is, how long it is and how long it runs; and the ways to
it."""

from __future__ import annotations

import os

from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets, main_window, translate

from .summary import clock

NAME = "FiveAxisWritten"
_dialogs: dict[str, Written] = {}
open_url = QtGui.QDesktopServices.openUrl
"""What the user's desktop opens files and folders with."""


class Written(QtWidgets.QDialog):
    """A window beside the work: nothing waits for it."""

    def __init__(self) -> None:
        super().__init__(main_window())
        self.setObjectName(NAME)
        self.setWindowTitle(translate("FiveAxis", "NC file written"))
        self.file, self.text = "", QtWidgets.QLabel()
        self.text.setObjectName(NAME + "Text")
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        row = QtWidgets.QHBoxLayout()
        for name, text, act in (
            ("Open", translate("FiveAxis", "Open"), self._open),
            ("Folder", translate("FiveAxis", "Show folder"), self._show_folder),
            ("Close", translate("FiveAxis", "Close"), self.close),
        ):
            button = QtWidgets.QPushButton(text)
            button.setObjectName(NAME + name)
            button.setAutoDefault(name == "Close")
            button.clicked.connect(lambda *_, act=act: act())
            row.addWidget(button)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(self.text)
        column.addLayout(row)
        self.setMinimumWidth(420)

    def tell(self, file: str, lines: int, seconds: float) -> None:
        """Show what was written: the file's whole name, its lines, its run time in s."""
        self.file = file
        template = translate("FiveAxis", "{file}\n{lines} lines, run time {time}")
        self.text.setText(template.format(file=file, lines=lines, time=clock(seconds)))
        self.show()
        self.raise_()

    def _open(self) -> None:
        """In the program that the user's desktop has for such files."""
        open_url(QtCore.QUrl.fromLocalFile(self.file))

    def _show_folder(self) -> None:
        open_url(QtCore.QUrl.fromLocalFile(os.path.dirname(self.file)))


def tell(file: str, lines: int, seconds: float) -> Written:
    """Say what was written, in the one dialog for that; returns it."""
    if NAME not in _dialogs:
        _dialogs[NAME] = Written()
    _dialogs[NAME].tell(file, lines, seconds)
    return _dialogs[NAME]
