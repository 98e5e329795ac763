# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calculate, and beside it the button that lays the passes alone: they are drawn over the part, and one line
says how many there are, how long they are, and how long cutting them takes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from freecad_fiveaxis.app.units import length_text
from freecad_fiveaxis.gui.qt import QtWidgets, translate

from .summary import clock


class PreviewRow(QtWidgets.QWidget):
    """``calculate``: the button that stands first; ``ask`` is called when the other one is pressed."""

    def __init__(self, doc: Any, calculate: Any, ask: Callable[[], object]) -> None:
        super().__init__()
        self.doc = doc
        self.picture: Any = None
        self.button = QtWidgets.QPushButton(translate("FiveAxis", "Preview passes"))
        self.button.setObjectName("preview_passes")
        self.button.setToolTip(
            translate("FiveAxis", "Lay the passes alone and draw them over the part: quick, before Calculate")
        )
        self.button.clicked.connect(lambda *_: ask())
        self.line = QtWidgets.QLabel()
        self.line.setObjectName("preview_line")
        self.line.setWordWrap(True)
        grid = QtWidgets.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.addWidget(calculate, 0, 0)
        grid.addWidget(self.button, 0, 1)
        grid.addWidget(self.line, 1, 0, 1, 2)
        self.line.hide()

    def show_passes(self, found: Any, origin: Sequence[float]) -> None:
        """Draw the passes of a Preview about the work zero ``origin``, mm, and say what they come to."""
        from freecad_fiveaxis.gui.preview_picture import PreviewPicture

        if self.picture is None:
            self.picture = PreviewPicture(self.doc, self._forget_line)
        self.picture.show(found, origin)
        self.line.setText(summarize(found))
        self.line.show()

    def clear(self) -> None:
        """Take lines and words away: they are of other settings, or of another part."""
        if self.picture is not None:
            self.picture.clear()
        self._forget_line()

    def _forget_line(self) -> None:
        self.line.setText("")
        self.line.hide()


def summarize(found: Any) -> str:
    """Return what the passes of a Preview come to, in one line; estimates where only some of them are
    laid."""
    one = translate("FiveAxis", "1 pass, {length}, {time} of cutting at the feed, links not counted")
    many = translate("FiveAxis", "{count} passes, {length}, {time} of cutting at the feed, links not counted")
    some = translate(
        "FiveAxis",
        "About {length}, {time} of cutting at the feed, links not counted; 1 in {one_in} passes is drawn",
    )
    text = some if found.one_in > 1 else one if found.passes == 1 else many
    return text.format(
        count=found.passes, length=length_text(found.length), time=clock(found.time), one_in=found.one_in
    )
