# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict of a tool path or an audit, as a coloured line whose words say what its colour says."""

from __future__ import annotations

from typing import Any

from .qt import QtWidgets

ADVICE = "advice"
"""In place of a light: what is recommended is neither safe nor unsafe."""
COLOURS = {"red": "#b3261e", "amber": "#8a5a00", "green": "#0b6b3a", ADVICE: "#37474f"}
"""Of each light: white letters can be read on it, on a light desktop and on a dark one."""


class VerdictLabel(QtWidgets.QLabel):
    """Hidden until there is a verdict; never lower than its words need at its width: what stands about it
    scrolls instead."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setWordWrap(True)
        self.hide()

    def show_verdict(self, obj: Any) -> None:
        """Show the verdict of the last computation of a Toolpath or an Audit; None: hide it."""
        light = getattr(obj, "Light", "")
        self.setText(obj.Verdict if light else "")
        self.setStyleSheet(
            f"background: {COLOURS.get(light, 'none')}; color: white; font-weight: bold; padding: 6px; "
            "border-radius: 4px;"
        )
        self._keep_whole()
        self.setVisible(light in COLOURS)

    def resizeEvent(self, event: Any) -> None:
        """Another width breaks the lines elsewhere."""
        super().resizeEvent(event)
        self._keep_whole()

    def _keep_whole(self) -> None:
        """Keep the label whole: one that wraps tells a layout of its height, and the layout of a low panel
        does not ask again."""
        self.setMinimumHeight(max(self.heightForWidth(self.width()), 0) if self.text() else 0)
