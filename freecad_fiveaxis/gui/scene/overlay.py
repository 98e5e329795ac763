# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend at the edge of the view and the label at a place: pictures painted by Qt, sharp at any zoom.

Both are drawn over everything else, cannot be picked, and are not part of the scene's box.
"""

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
BAR_HEIGHT = 190
WARNING_WIDTH = 44
"""Letters in a line of a warning: wider ones would cover the part."""
LEFT, SLOT, BESIDE = -0.985, 0.0, 0.42
"""Where the legend stands in the view, -1 to 1 both ways."""


@dataclass(frozen=True)
class Legend:
    """What the legend says. ``marks``: level (0 to 1) and text of the scale's marks; ``keys``: colour and text of the kinds of
    markers; ``halves``: texts of the calm and the loud half; ``notes``: lines below; ``warning``: a line on top in a warning
    colour, empty for none."""

    title: str
    ramp: np.ndarray
    marks: Sequence[tuple[float, str]]
    halves: tuple[str, str]
    keys: Sequence[tuple[nodes.Colour, str]]
    notes: Sequence[str]
    warning: str = ""


def label_node(place: Sequence[float], text: str) -> Any:
    """A text at a place of the scene, with a small pointer to it."""
    place_node = coin.SoTranslation()
    place_node.translation.setValue(*place)
    image = _image(_label_picture(text))
    image.horAlignment, image.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    return _over_all(place_node, image)


def label_nodes(labels: Sequence[tuple[Sequence[float], str]]) -> Any:
    """Several texts, each at its place."""
    return nodes.separate(*(nodes.separate(label_node(place, text)) for place, text in labels))


def legend_node(legend: Legend, slot: int = 0, right: bool = False) -> Any:
    """The legend at the left or the ``right`` edge; ``slot``: how many other legends stand before it."""
    camera = coin.SoOrthographicCamera()
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.position.setValue(0.0, 0.0, 1.0)
    camera.height, camera.nearDistance, camera.farDistance = 2.0, 0.0, 2.0
    picture = _legend_picture(legend)
    place_node = coin.SoTranslation()
    place = LEFT + BESIDE * slot
    place_node.translation.setValue(-place if right else place, SLOT, 0.0)
    image = _image(picture)
    image.horAlignment, image.vertAlignment = coin.SoImage.RIGHT if right else coin.SoImage.LEFT, coin.SoImage.HALF
    made = coin.SoGroup()
    for child in (_over_all(camera, place_node, image), _view_s_own_ray()):
        made.addChild(child)
    return made


def _view_s_own_ray() -> Any:
    """The legend has a camera of its own, and Coin aims the mouse's ray anew at every camera it meets. Aimed with that one, it
    would miss all that comes later in the scene: here it is aimed once more, with the view's camera."""
    made = coin.SoCallback()
    made.setCallback(_aim)
    return made


def _aim(_data: Any, action: Any) -> None:
    if action.isOfType(coin.SoRayPickAction.getClassTypeId()):
        picking = action if hasattr(action, "computeWorldSpaceRay") else coin.cast(action, "SoRayPickAction")
        picking.computeWorldSpaceRay()


def _over_all(*children: Any) -> Any:
    over = coin.SoAnnotation()
    for child in (nodes.unpickable(), *children):
        over.addChild(child)
    return nodes.without_box(over)


def _image(picture: QtGui.QImage) -> Any:
    upright = picture.convertToFormat(QtGui.QImage.Format_RGBA8888)
    rows = np.frombuffer(upright.constBits(), np.uint8, upright.bytesPerLine() * upright.height())
    rows = rows.reshape(upright.height(), upright.bytesPerLine())[::-1, : 4 * upright.width()]
    made = coin.SoImage()
    made.image.setValue(coin.SbVec2s(upright.width(), upright.height()), 4, rows.tobytes())
    return made


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


def _label_picture(text: str) -> QtGui.QImage:
    font, tail = _font(FONT, bold=True), 14
    width, height = _width(text, font) + 2 * PAD, FONT + PAD
    picture = _paper(width + tail, height + tail)
    painter = _painter(picture)
    painter.setPen(QtGui.QPen(QtGui.QColor(*PAPER), 2))
    painter.drawLine(0, height + tail - 1, tail, height - 1)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(*PAPER))
    painter.drawRoundedRect(tail, 0, width, height, 5, 5)
    painter.setPen(QtGui.QColor(*INK))
    painter.setFont(font)
    painter.drawText(QtCore.QRect(tail, 0, width, height), QtCore.Qt.AlignCenter, text)
    painter.end()
    return picture


def _legend_picture(legend: Legend) -> QtGui.QImage:
    """From the top: warning, title, bar with marks, keys, notes."""
    line = FONT + 6
    bold, plain = _font(FONT, bold=True), _font(SMALL)
    head = [(text, WARN) for text in textwrap.wrap(legend.warning, WARNING_WIDTH)] + [(legend.title, INK)]
    words = [_width(text, bold) for text, _ in head] + [_width(text, plain) for text in legend.notes]
    words += [BAR + 12 + _width(text, plain) for _, text in (*legend.marks, *legend.keys)]
    marks = max((_width(text, plain) for _, text in legend.marks), default=0)
    words += [BAR + 12 + marks + 14 + _width(text, plain) for text in legend.halves]
    below = line * (len(legend.keys) + len(legend.notes))
    bar = BAR_HEIGHT + PAD if len(legend.ramp) else 0
    height = 2 * PAD + line * len(head) + PAD + bar + below
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
    for share, text in zip((0.75, 0.25), legend.halves, strict=True):
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
