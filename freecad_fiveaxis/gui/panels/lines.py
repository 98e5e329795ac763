# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of text under a field, hidden until they say something: its error, a warning, a note."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtGui, QtWidgets, translate

LIGHT = {"error": "#d0342c", "warning": "#a05600", "note": "#5f6b78"}
DARK = {"error": "#ff8a80", "warning": "#ffb74d", "note": "#a9b4c0"}
"""The colours of the lines on a light desktop and on a dark one; each can be read on its own."""


def ink(kind: str) -> str:
    """Return the colour of a kind of line on the desktop as it is: FreeCAD's dark themes are style sheets, of
    which only a widget that has taken them on knows."""
    probe = QtWidgets.QLabel()
    probe.ensurePolished()
    dark = probe.palette().color(QtGui.QPalette.WindowText).lightness() > 127
    return (DARK if dark else LIGHT)[kind]


def error_line(name: str) -> Any:
    """Return a line in red, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setAccessibleDescription(translate("FiveAxis", "Error"))
    label.setWordWrap(True)
    label.setStyleSheet(f"color: {ink('error')};")
    label.hide()
    return label


def warning_line(name: str) -> Any:
    """Return a line in amber, hidden until it says something."""
    label = error_line(name)
    label.setAccessibleDescription(translate("FiveAxis", "Warning"))
    label.setStyleSheet(f"color: {ink('warning')};")
    return label


def note_line(name: str) -> Any:
    """Return a line in small letters, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setStyleSheet(f"color: {ink('note')}; font-size: small;")
    label.hide()
    return label
