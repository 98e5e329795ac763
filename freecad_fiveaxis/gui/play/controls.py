# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets of the player: slider, buttons, speed, jumps and the switch between the two pictures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.gui.panels.wrapping import SPACING, WrappingRow
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate
from freecad_fiveaxis.gui.wheel import leave_wheel

SLIDER = 10_000
"""Steps of the slider over the program's time."""
SPEEDS = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""Times real time."""


class Controls:
    """The widgets by name; ``widget`` goes into the panel. What they do is connected by the panel."""

    def __init__(self) -> None:
        self.slider = QtWidgets.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("slider")
        self.slider.setRange(0, SLIDER)
        self.slider.setPageStep(SLIDER // 20)
        icons = QtWidgets.QStyle
        self.begin = self._button(
            "begin", icons.SP_MediaSkipBackward, translate("FiveAxis", "Back to the first position")
        )
        self.back = self._button("back", icons.SP_MediaSeekBackward, translate("FiveAxis", "One block back"))
        self.play = self._button("play", icons.SP_MediaPlay, translate("FiveAxis", "Play and pause"))
        self.forward = self._button(
            "forward", icons.SP_MediaSeekForward, translate("FiveAxis", "One block on")
        )
        self.worst, self.singular = QtWidgets.QPushButton(), QtWidgets.QPushButton()
        self.worst.setText(translate("FiveAxis", "Worst block"))
        self.worst.setToolTip(translate("FiveAxis", "Where the tip is farthest from its commanded segment"))
        self.singular.setText(translate("FiveAxis", "Next singular"))
        self.singular.setToolTip(
            translate("FiveAxis", "The next block where a rotary axis turns far to lean the tool a little")
        )
        self.collision = QtWidgets.QPushButton()
        self.name_stops(collisions=True)
        self.collision.setToolTip(
            translate(
                "FiveAxis",
                "Where tool or spindle go deepest into the next fixture or body of the machine, or come too "
                "near to it",
            )
        )
        self.machine, self.follow = QtWidgets.QCheckBox(), QtWidgets.QCheckBox()
        self.machine.setText(translate("FiveAxis", "On the machine"))
        self.machine.setToolTip(
            translate("FiveAxis", "Table and head move as they really will; otherwise the part stands still")
        )
        self.follow.setText(translate("FiveAxis", "Follow the tip"))
        self.follow.setToolTip(translate("FiveAxis", "Keep the tip of the tool in the middle of the view"))
        for name in ("worst", "singular", "collision", "machine", "follow"):
            getattr(self, name).setObjectName(name)
        self.speed = self._speed()
        self.widget = self._create_widget()

    def each_speed(self) -> float:
        """Return the speed that is chosen, times real time."""
        return float(self.speed.currentData())

    def name_stops(self, collisions: bool) -> None:
        """Name the button after what it leads to: collisions, with near misses between them, or near misses
        alone."""
        collision, near = translate("FiveAxis", "Next collision"), translate("FiveAxis", "Next near miss")
        self.collision.setText(collision if collisions else near)

    def show_share(self, share: float) -> None:
        """Put the slider where the program stands, 0 to 1, without anybody hearing of it."""
        held = self.slider.blockSignals(True)
        self.slider.setValue(round(share * SLIDER))
        self.slider.blockSignals(held)

    def show_playing(self, playing: bool) -> None:
        """Show on the play button what it would do."""
        kind = QtWidgets.QStyle.SP_MediaPause if playing else QtWidgets.QStyle.SP_MediaPlay
        self.play.setIcon(self.play.style().standardIcon(kind))
        self.play.setChecked(playing)

    def connect(self, actions: dict[str, Callable[[], Any]]) -> None:
        """Connect each button with what it does."""
        for name, action in actions.items():
            getattr(self, name).clicked.connect(lambda *_, action=action: action())

    def _button(self, name: str, kind: Any, text: str) -> Any:
        button = QtWidgets.QToolButton()
        button.setObjectName(name)
        button.setIcon(button.style().standardIcon(kind))
        button.setIconSize(QtCore.QSize(18, 18))
        button.setToolTip(text)
        button.setAutoRepeat(name in ("back", "forward"))
        button.setCheckable(name == "play")
        return button

    def _speed(self) -> Any:
        box = QtWidgets.QComboBox()
        box.setObjectName("speed")
        box.setToolTip(translate("FiveAxis", "Speed, in times of real time"))
        for speed in SPEEDS:
            box.addItem(f"× {write_number(f'{speed:g}')}", speed)
        box.setCurrentIndex(SPEEDS.index(1.0))
        leave_wheel(box)
        return box

    def _create_widget(self) -> Any:
        widget = QtWidgets.QWidget()
        column = QtWidgets.QVBoxLayout(widget)
        column.setContentsMargins(0, 0, 0, 0)
        buttons = QtWidgets.QHBoxLayout()
        for button in (self.begin, self.back, self.play, self.forward):
            buttons.addWidget(button)
        buttons.addStretch()
        buttons.addWidget(self.speed)
        buttons.setSpacing(SPACING)
        column.addWidget(self.slider)
        column.addLayout(buttons)
        column.addWidget(WrappingRow((self.worst, self.singular), stretched=True))
        column.addWidget(self.collision)
        column.addWidget(WrappingRow((self.machine, self.follow)))
        return widget
