# SPDX-License-Identifier: LGPL-2.1-or-later
"""Legends and labels as pictures painted by Qt, sharp at any zoom. ``on_screen`` puts them into the view."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.gui.qt import QtCore, QtGui

from . import nodes

PAPER, INK, WARN = (22, 26, 32, 205), (245, 245, 245), (255, 205, 70)
"""Red, green, blue, 0 to 255 (and alpha): dark paper that shows on any background."""
FONT, SMALL, PAD, BAR = 13, 12, 10, 18
"""Pixels: text, smaller text, border, width of the colour bar."""
BAR_HEIGHT = 152
WARNING_WIDTH = 44
"""Letters in a line of a warning: wider ones would cover the part."""
FOLDED_WIDTH = 72
"""Letters in a legend of one line."""
STRIPE = 5
"""Width of the bar at the side of a label."""


@dataclass(frozen=True)
class Legend:
    """What the legend says. ``marks``: level (0 to 1) and text of the scale's marks; ``keys``: colour and
    text of the kinds of markers; ``halves``: texts of the calm and the loud half, the second empty where
    there is none; ``notes``: lines below; ``warning``: lines on top in a warning colour, empty for none;
    ``gist``: what the title says besides when it stands alone; ``ink``: of the title."""

    title: str
    ramp: np.ndarray
    marks: Sequence[tuple[float, str]]
    halves: tuple[str, str]
    keys: Sequence[tuple[nodes.Colour, str]]
    notes: Sequence[str]
    warning: str = ""
    gist: str = ""
    ink: tuple[int, int, int] = INK

    def fold(self) -> Legend:
        """Return the same in one line, in the warning colour where there is a warning."""
        line = f"{self.title}: {self.warning or self.gist}" if self.warning or self.gist else self.title
        if len(line) > FOLDED_WIDTH:
            line = line[:FOLDED_WIDTH].rstrip() + "…"
        return Legend(line, np.zeros((0, 3)), (), ("", ""), (), (), ink=WARN if self.warning else INK)


def image(picture: QtGui.QImage) -> Any:
    """Return a picture as a node: its lower left corner stands at the origin."""
    upright = picture.convertToFormat(QtGui.QImage.Format_RGBA8888)
    rows = np.frombuffer(upright.constBits(), np.uint8, upright.bytesPerLine() * upright.height())
    rows = rows.reshape(upright.height(), upright.bytesPerLine())[::-1, : 4 * upright.width()]
    image_node = coin.SoImage()
    image_node.image.setValue(coin.SbVec2s(upright.width(), upright.height()), 4, rows.tobytes())
    image_node.horAlignment, image_node.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    return image_node


def _font(pixels: int, bold: bool = False) -> QtGui.QFont:
    font = QtGui.QFont()
    font.setPixelSize(pixels)
    font.setBold(bold)
    return font


def _width(text: str, font: QtGui.QFont) -> int:
    return int(QtGui.QFontMetrics(font).boundingRect(text).width()) + 4


def _paper(width: int, height: int) -> QtGui.QImage:
    picture = QtGui.QImage(width, height, QtGui.QImage.Format_ARGB32)
    picture.fill(QtCore.Qt.transparent)
    return picture


def _painter(picture: QtGui.QImage) -> QtGui.QPainter:
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setRenderHint(QtGui.QPainter.TextAntialiasing)
    return painter


def label_picture(text: str, colour: nodes.Colour | None = None) -> QtGui.QImage:
    """Return a short text on paper; at its left side a bar in the ``colour`` of its marker, where it has
    one."""
    font, side = _font(FONT, bold=True), STRIPE if colour else 0
    width, height = side + _width(text, font) + 2 * PAD, FONT + PAD
    picture = _paper(width, height)
    painter = _painter(picture)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(*PAPER))
    painter.drawRoundedRect(0, 0, width, height, 5, 5)
    if colour:
        painter.fillRect(0, 3, side, height - 6, QtGui.QColor(*(round(255 * part) for part in colour)))
    painter.setPen(QtGui.QColor(*INK))
    painter.setFont(font)
    painter.drawText(QtCore.QRect(side, 0, width - side, height), QtCore.Qt.AlignCenter, text)
    painter.end()
    return picture


def legend_picture(legend: Legend) -> QtGui.QImage:
    """From the top: warning, title, bar with marks, keys, notes."""
    line = FONT + 6
    bold, plain = _font(FONT, bold=True), _font(SMALL)
    head = [(text, WARN) for text in textwrap.wrap(legend.warning, WARNING_WIDTH)] + [
        (legend.title, legend.ink)
    ]
    words = [_width(text, bold) for text, _ in head] + [_width(text, plain) for text in legend.notes]
    words += [BAR + 12 + _width(text, plain) for _, text in (*legend.marks, *legend.keys)]
    marks = max((_width(text, plain) for _, text in legend.marks), default=0)
    words += [BAR + 12 + marks + 14 + _width(text, plain) for text in legend.halves]
    below = line * (len(legend.keys) + len(legend.notes))
    bar = BAR_HEIGHT + PAD if len(legend.ramp) else 0
    gap = PAD if bar or below else 0
    height = 2 * PAD + line * len(head) + gap + bar + below
    picture = _paper(max(words) + 2 * PAD, height)
    painter = _painter(picture)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(*PAPER))
    painter.drawRoundedRect(0, 0, picture.width(), height, 6, 6)
    top = PAD
    painter.setFont(bold)
    for text, ink in head:
        painter.setPen(QtGui.QColor(*ink))
        painter.drawText(PAD, top + FONT, text)
        top += line
    painter.setFont(plain)
    if bar:
        _paint_bar(painter, legend, top + PAD, marks)
    _paint_below(painter, legend, top + PAD + bar, line)
    painter.end()
    return picture


def _paint_bar(painter: QtGui.QPainter, legend: Legend, top: int, marks: int) -> None:
    for y in range(BAR_HEIGHT):
        level = 1.0 - (y + 0.5) / BAR_HEIGHT
        shade = legend.ramp[min(int(level * len(legend.ramp)), len(legend.ramp) - 1)]
        painter.fillRect(PAD, top + y, BAR, 1, QtGui.QColor(*(round(255 * float(part)) for part in shade)))
    painter.setPen(QtGui.QColor(*INK))
    for level, text in legend.marks:
        y = top + round((1.0 - level) * BAR_HEIGHT)
        painter.drawLine(PAD + BAR, y, PAD + BAR + 6, y)
        painter.drawText(PAD + BAR + 12, y + SMALL // 2 - 1, text)
    left = PAD + BAR + 12 + marks + 14
    for share, text in zip((0.75, 0.25) if legend.halves[1] else (0.5, 0.5), legend.halves, strict=True):
        painter.drawText(left, top + round(share * BAR_HEIGHT) + SMALL // 2 - 1, text)


def _paint_below(painter: QtGui.QPainter, legend: Legend, top: int, line: int) -> None:
    for colour, text in legend.keys:
        painter.setPen(QtGui.QPen(QtGui.QColor(*INK), 1))
        painter.setBrush(QtGui.QColor(*(round(255 * part) for part in colour)))
        painter.drawRect(PAD + 4, top + 2, 10, 10)
        painter.drawText(PAD + BAR + 12, top + SMALL, text)
        top += line
    for text in legend.notes:
        painter.drawText(PAD, top + SMALL, text)
        top += line
