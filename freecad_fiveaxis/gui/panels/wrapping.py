# SPDX-License-Identifier: LGPL-2.1-or-later
"""Buttons beside each other as far as their texts have room, the others below: a task panel may be 232 pixels
wide, and what stands outside it cannot be reached.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.gui.qt import QtCore, QtWidgets

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


def find_lines(widths: Sequence[int], room: int) -> list[int]:
    """Return the line, from 0 on, of each of these widths (pixels), where a line has that ``room``."""
    lines: list[int] = []
    line, left = -1, 0
    for width in widths:
        left -= width + SPACING
        if line < 0 or left < 0:
            line, left = line + 1, room - width
        lines.append(line)
    return lines
