# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines under fields can be read on a light desktop and on a dark one."""

import pytest

from freecad_fiveaxis.gui.panels.lines import error_line, note_line, warning_line
from freecad_fiveaxis.gui.qt import QtGui, QtWidgets

ENOUGH = 4.5
"""Contrast that small letters need at least."""


def luminance(colour):
    """Relative luminance (0 to 1), as WCAG has it."""
    parts = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in colour.getRgbF()[:3]
    ]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


@pytest.fixture
def desktop(window):
    """desktop(ground, letters): the colours of all widgets, as FreeCAD's themes set them."""
    before = QtWidgets.QApplication.instance().styleSheet()
    yield lambda ground, letters: QtWidgets.QApplication.instance().setStyleSheet(
        f"QWidget {{ background: {ground}; color: {letters}; }}"
    )
    QtWidgets.QApplication.instance().setStyleSheet(before)


@pytest.mark.parametrize(("ground", "letters"), [("#f5f5f5", "#000000"), ("#2b2b2b", "#e6e6e6")])
def test_lines_can_be_read_on_any_desktop(desktop, ground, letters):
    desktop(ground, letters)
    behind = luminance(QtGui.QColor(ground))
    for line in (error_line("error"), warning_line("warning"), note_line("note")):
        line.ensurePolished()
        written = luminance(line.palette().color(QtGui.QPalette.WindowText))
        low, high = sorted((behind, written))
        assert (high + 0.05) / (low + 0.05) >= ENOUGH, (ground, line.objectName())
