# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widget of a task panel: a head that stays in sight, and below it the form, which scrolls by itself.

FreeCAD puts the panel into a scroll area of its own, above a stretch. A panel that would like to be taller
than any screen, but can be low, gets just what is left there: so only the form scrolls, and nothing of
FreeCAD's own has to be asked for its height.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

WIDTH, TALL, LOW, LINES = 300, 4000, 110, 80
"""Pixels: as wide as the panel would like to be, taller than any screen, as low as the form may get, and a
text above it."""
MARGIN = 4
TITLE = 168
"""Pixels of a title, beside its icon and arrow in the narrowest task panel."""


class PanelWidget(QtWidgets.QWidget):
    """``head``: what stays in sight; ``body``: what scrolls."""

    def __init__(self, title: str, head: Sequence[Any], body: Any) -> None:
        super().__init__()
        self.setObjectName("FiveAxisPanel")
        self.setWindowTitle(title)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        for part in head:
            column.addWidget(part)
        area = FormArea()
        column.addWidget(area, 1)
        area.fill(body)

    def hasHeightForWidth(self) -> bool:
        """Qt would ask for the whole height of texts that wrap, and scroll the head away."""
        return False

    def sizeHint(self) -> Any:
        """As much as there is."""
        return QtCore.QSize(WIDTH, TALL)


def shorten_title(form: Any) -> None:
    """Give a long title dots: FreeCAD makes the panel as wide as its title, and the screen cuts what is then
    wider than the task panel."""
    font = QtGui.QFont(form.font())
    font.setBold(True)
    title = QtGui.QFontMetrics(font).elidedText(form.windowTitle(), QtCore.Qt.ElideRight, TITLE)
    form.setWindowTitle(title)


class FormArea(QtWidgets.QScrollArea):
    """Scrolls the form up and down, and is never narrower than it."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("form_area")
        self.setWidgetResizable(True)
        self.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setWidget(QtWidgets.QWidget())
        self.verticalScrollBar().rangeChanged.connect(
            lambda *_: self.updateGeometry()
        )  # a group was folded, or a row shown

    def fill(self, body: Any) -> None:
        """Show ``body``. It comes last, when the area stands in its panel: Qt tells every field of each new
        parent (0.1 s)."""
        column = QtWidgets.QVBoxLayout(self.widget())
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(body)
        column.addStretch()

    def sizeHint(self) -> Any:
        """As low as it may get: what stands above it comes first, and the rest of the panel is the form's."""
        return QtCore.QSize(WIDTH, LOW)

    def minimumSizeHint(self) -> Any:
        """Return the form's own width and the scroll bar's."""
        bar = self.verticalScrollBar().sizeHint().width()
        return QtCore.QSize(self.widget().minimumSizeHint().width() + bar, LOW)


class TextArea(QtWidgets.QScrollArea):
    """All of a label's text where there is room for it; elsewhere it scrolls, and no line of it is lost.

    Whoever changes the text calls ``updateGeometry``.
    """

    def __init__(self, label: Any) -> None:
        super().__init__()
        self.setWidgetResizable(True)
        self.setFrameShape(QtWidgets.QFrame.NoFrame)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setSizePolicy(QtWidgets.QSizePolicy.Preferred, QtWidgets.QSizePolicy.Maximum)
        self.label = label
        self.setWidget(label)

    def resizeEvent(self, event: Any) -> None:
        """Another width breaks the lines elsewhere."""
        super().resizeEvent(event)
        self.updateGeometry()

    def sizeHint(self) -> Any:
        """As high as the text at this width."""
        return QtCore.QSize(
            self.minimumSizeHint().width(), self.label.heightForWidth(self.viewport().width())
        )

    def minimumSizeHint(self) -> Any:
        """Return the text's widest word and the scroll bar; some lines."""
        width = self.label.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width()
        return QtCore.QSize(width, min(self.label.heightForWidth(self.viewport().width()), LINES))
