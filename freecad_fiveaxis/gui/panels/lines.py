# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of text under a field, hidden until they say something: its error, a warning, a note."""

from __future__ import annotations

from typing import Any

from freecad_fiveaxis.gui.qt import QtWidgets, translate


def error_line(name: str) -> Any:
    """Return a line in red, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setAccessibleDescription(translate("FiveAxis", "Error"))
    label.setWordWrap(True)
    label.setStyleSheet("color: #d0342c;")
    label.hide()
    return label


def warning_line(name: str) -> Any:
    """Return a line in amber, hidden until it says something."""
    label = error_line(name)
    label.setAccessibleDescription(translate("FiveAxis", "Warning"))
    label.setStyleSheet("color: #b06000;")
    return label


def note_line(name: str) -> Any:
    """Return a line in small letters, hidden until it says something."""
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setStyleSheet("color: #6b7785; font-size: small;")
    label.hide()
    return label
