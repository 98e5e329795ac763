# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the keys go after long work: to the task panel that is open, so that Esc closes it.

FreeCAD hears Esc where the focus is within its task view. FreeCAD 1.1 lays that over the 3D view, and hands
the focus to the view when the window comes to life again after the dialog of long work; there Esc closes
nothing. The panel as a whole gets the keys, and none of its buttons: Space would press it.
"""

from __future__ import annotations

from typing import Any

from .qt import QtCore, later

AGAIN, TRIES = 50, 20
"""ms between two looks whether the window is active and the panel has the keys, and how many: a second, for
slow desktops."""

_open: list[Any] = []
"""The widget of the panel that was opened last."""


def belong_to(form: Any) -> None:
    """``form`` is the widget of the task panel that is open from now on."""
    _open[:] = [form]


def give_back() -> None:
    """Give the keys to the panel that is open, if one is, as soon as its window is active."""
    later(lambda: _give_back(TRIES))


def _give_back(tries: int) -> None:
    try:
        kept = [
            form for form in _open if form.isVisible() and not (form.isActiveWindow() and form.hasFocus())
        ]
        for form in kept:
            form.setFocus(QtCore.Qt.OtherFocusReason)
    except RuntimeError:  # PySide: already deleted, that panel was closed
        _open.clear()
        return
    if kept and tries:
        QtCore.QTimer.singleShot(AGAIN, lambda: _give_back(tries - 1))
