# SPDX-License-Identifier: LGPL-2.1-or-later
"""A button that tries what would finish more of the part, and one that takes it over; seen where something
stays unfinished."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate


class AdviceOffer(QtWidgets.QWidget):
    """``requested``: the user wants to know; ``chosen`` tells that the settings in ``changes`` are to be
    used."""

    requested, chosen = QtCore.Signal(), QtCore.Signal()

    def __init__(self) -> None:
        super().__init__()
        self.changes: Mapping[str, Any] = {}
        self.ask = QtWidgets.QPushButton(translate("FiveAxis", "What would finish more?"))
        self.ask.setToolTip(
            translate(
                "FiveAxis",
                "Try other passes, free tool axes and smaller balls on this part; takes as long as some "
                "paths",
            )
        )
        self.line = QtWidgets.QLabel()
        self.line.setWordWrap(True)
        self.use = QtWidgets.QPushButton(translate("FiveAxis", "Use these settings"))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget, name in ((self.ask, "advice_ask"), (self.line, "advice_line"), (self.use, "advice_use")):
            widget.setObjectName(name)
            column.addWidget(widget)
        self.ask.clicked.connect(lambda *_: self.requested.emit())
        self.use.clicked.connect(lambda *_: self.chosen.emit())
        self.show_for(None)

    def show_for(self, obj: Any) -> None:
        """Offer it where the last result of ``obj`` (None: there is none) leaves something; what was said is
        forgotten."""
        self.show_advice("", {})
        last = getattr(getattr(obj, "Proxy", None), "last", None)
        if last is None:
            self.hide()
            return
        from freecad_fiveaxis.app import (
            advising,
        )  # here, for it brings the whole pipeline: a panel opens without

        self.setVisible(advising.leaves_something(last.figures))

    def show_advice(self, text: str, changes: Mapping[str, Any]) -> None:
        """Say what was tried, and offer the ``changes``, where there are any."""
        self.changes = changes
        self.line.setText(text)
        self.line.setVisible(bool(text))
        self.use.setVisible(bool(changes))
