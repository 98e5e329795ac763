# SPDX-License-Identifier: LGPL-2.1-or-later
"""A group of fields that folds: a header with an arrow, a title and what the group says in a few words.

state     what stands behind the title, so that a folded group need not be opened to be read. Where the panel
          is narrow it is cut with dots; the tool tip says all of it.
kept      which groups are open is kept in the preferences: a panel opens as it was left.
"""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets

from .rows import Rows

ARROW = 30
"""Pixels of the header's arrow and its margins."""
STYLE = """
QToolButton { border: 1px solid transparent; border-radius: 2px; padding: 2px; background: rgba(128, 128, 128, 45) }
QToolButton:hover, QToolButton:focus { border-color: palette(highlight) }
"""  # noqa: E501


class FoldingGroup(QtWidgets.QWidget):
    """A header and a ``body`` of rows. ``key``: under which the preferences keep whether it is open;
    ``opened`` until they do."""

    def __init__(self, name: str, title: str, key: str, opened: bool = True) -> None:
        from freecad_fiveaxis.app import preferences

        super().__init__()
        self.setObjectName("section_" + name)
        self.title, self.key, self.state = title, key, ""
        self.header = _header(name, title)
        self.body = Rows()
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self.header)
        column.addWidget(self.body)
        self.header.setChecked(preferences.is_open(key, opened))
        self._turn(self.is_open())
        self.header.toggled.connect(self._turn)
        self.header.clicked.connect(self._keep)
        self._write()

    def is_open(self) -> bool:
        """Whether the fields are shown."""
        return bool(self.header.isChecked())

    def unfold(self) -> None:
        """Show the fields, for once: the preferences keep what the user chose."""
        self.header.setChecked(True)

    def show_state(self, state: str) -> None:
        """Show what the group says, in a few words."""
        self.state = state
        self._write()

    def resizeEvent(self, event: Any) -> None:
        """Cut the title to the new width."""
        super().resizeEvent(event)
        self._write()

    def _turn(self, opened: bool) -> None:
        self.body.setVisible(opened)
        self.header.setArrowType(QtCore.Qt.DownArrow if opened else QtCore.Qt.RightArrow)

    def _keep(self, opened: bool) -> None:
        from freecad_fiveaxis.app import preferences

        preferences.keep_open(self.key, opened)

    def _write(self) -> None:
        text = f"{self.title} — {self.state}" if self.state else self.title
        metrics = self.header.fontMetrics()
        self.header.setText(
            metrics.elidedText(text.replace("&", "&&"), QtCore.Qt.ElideRight, max(self.width() - ARROW, 0))
        )
        self.header.setToolTip(text)
        self.header.setAccessibleDescription(self.state)


def _header(name: str, title: str) -> Any:
    """Return a button as wide as the panel; Tab reaches it, the space bar presses it."""
    button = QtWidgets.QToolButton()
    button.setObjectName("fold_" + name)
    button.setAccessibleName(title)
    button.setCheckable(True)
    button.setFocusPolicy(QtCore.Qt.StrongFocus)
    button.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
    button.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Fixed)
    button.setStyleSheet(STYLE)
    return button
