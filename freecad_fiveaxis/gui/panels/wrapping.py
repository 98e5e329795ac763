# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons beside each other as far as their texts have room, the others below, and texts of buttons in as
many lines as they need: a task panel may be 220 pixels wide, the letters large, and what stands outside it
cannot be reached.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, flags

SPACING = 3
"""Pixels between them."""


class WrappingRow(QtWidgets.QWidget):
    """Holds ``widgets`` in as few lines as their texts allow; ``stretched``: they fill these."""

    def __init__(self, widgets: Sequence[Any], stretched: bool = False) -> None:
        super().__init__()
        self.widgets, self.stretch = tuple(widgets), int(stretched)
        self.at = list(range(len(widgets)))
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(SPACING)
        self.lines = [QtWidgets.QHBoxLayout() for _ in widgets]
        for line, one in zip(self.lines, widgets, strict=True):
            line.setSpacing(SPACING)
            one.resize(one.sizeHint())  # until it is laid out, when it is shown: Qt begins with 640 by 480
            line.addWidget(one, self.stretch)
            if not stretched:
                line.addStretch()
            column.addLayout(line)

    def resizeEvent(self, event: Any) -> None:
        """Place them anew where the width asks for it."""
        super().resizeEvent(event)
        self._place()

    def minimumSizeHint(self) -> Any:
        """As narrow as the widest of them, however they stand now: else a panel could not become narrower."""
        widest = max((one.minimumSizeHint().width() for one in self.widgets), default=0)
        return QtCore.QSize(widest, super().minimumSizeHint().height())

    def _place(self) -> None:
        """Move each to its line; nothing is done where all stand so already."""
        wanted = find_lines([one.sizeHint().width() for one in self.widgets], self.width())
        if wanted == self.at:
            return
        for one, at in zip(self.widgets, self.at, strict=True):
            self.lines[at].removeWidget(one)
        self.at = wanted
        for k, (one, at) in enumerate(zip(self.widgets, wanted, strict=True)):
            self.lines[at].insertWidget(wanted[:k].count(at), one, self.stretch)


class _Wrapped:
    """Breaks the text of a button or a tick box between its words where it has no room in one line."""

    whole = ""  # Qt asks for sizes before there is a text

    def __init__(self, text: str = "") -> None:
        super().__init__()
        narrow = QtWidgets.QSizePolicy  # by itself a button is never narrower than its text in one line
        self.setSizePolicy(narrow.Preferred, narrow.Fixed)  # type: ignore[attr-defined]
        self.setText(text)

    def text(self) -> str:
        """Return the text as it was given."""
        return self.whole

    def setText(self, text: str) -> None:
        """Show a text."""
        self.whole = text
        super().setText(text)  # type: ignore[misc]
        self._break()

    def resizeEvent(self, event: Any) -> None:
        """Break the text anew where the width asks for it."""
        super().resizeEvent(event)  # type: ignore[misc]
        self._break()

    def changeEvent(self, event: Any) -> None:
        """Another font, or style, needs other room."""
        super().changeEvent(event)  # type: ignore[misc]
        self._break()

    def sizeHint(self) -> Any:
        """As wide as the text in one line, as high as its lines are now."""
        return self._hint(self.whole)

    def minimumSizeHint(self) -> Any:
        """As narrow as the widest word."""
        return self._hint(self.whole.replace(" ", "\n"))

    def _hint(self, text: str) -> Any:
        size = super().sizeHint()  # type: ignore[misc]
        return QtCore.QSize(self._frame() + self._measure(text), size.height())

    def _frame(self) -> int:
        """Pixels beside the text."""
        return int(super().sizeHint().width()) - self._measure(super().text())  # type: ignore[misc]

    def _measure(self, text: str) -> int:
        shown = flags(QtCore.Qt.TextShowMnemonic)
        return int(self.fontMetrics().size(shown, text).width())  # type: ignore[attr-defined]

    def _break(self) -> None:
        words = self.whole.split(" ")
        room = self.width() - self._frame()  # type: ignore[attr-defined]
        lines = find_lines([self._measure(word) for word in words], room, self._measure(" "))
        shown = "\n".join(
            " ".join(word for word, at in zip(words, lines, strict=True) if at == line)
            for line in range(max(lines) + 1)
        )
        shown = self.whole if self._measure(self.whole) <= room else shown
        if shown != super().text():  # type: ignore[misc]
            super().setText(shown)  # type: ignore[misc]


class WrappedButton(_Wrapped, QtWidgets.QPushButton):
    """A button whose text may have several lines."""


class WrappedTick(_Wrapped, QtWidgets.QCheckBox):
    """A tick box whose text may have several lines."""


def find_lines(widths: Sequence[int], room: int, spacing: int = SPACING) -> list[int]:
    """Return the line, from 0 on, of each of these widths (pixels), where a line has that ``room`` and so
    much ``spacing`` stands between two."""
    lines: list[int] = []
    line, left = -1, 0
    for width in widths:
        left -= width + spacing
        if line < 0 or left < 0:
            line, left = line + 1, room - width
        lines.append(line)
    return lines
