# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines under fields can be read on a light desktop and on a dark one."""

import re

import pytest

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.gui import comparison_table
from freecad_fiveaxis.gui.panels import machine_editor, result_html
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


GROUNDS = pytest.mark.parametrize(("ground", "letters"), [("#f5f5f5", "#000000"), ("#2b2b2b", "#e6e6e6")])


def contrast(one, other):
    """How much one colour stands out from the other, 1 to 21, as WCAG has it."""
    low, high = sorted((luminance(QtGui.QColor(one)), luminance(QtGui.QColor(other))))
    return (high + 0.05) / (low + 0.05)


@GROUNDS
def test_lines_can_be_read_on_any_desktop(desktop, ground, letters):
    desktop(ground, letters)
    for line in (error_line("error"), warning_line("warning"), note_line("note")):
        line.ensurePolished()
        written = line.palette().color(QtGui.QPalette.WindowText)
        assert contrast(ground, written) >= ENOUGH, (ground, line.objectName())


def colours_of(text):
    """The colours that a style sheet or HTML names for its letters."""
    return re.findall(r"(?<!-)color: (#\w{6})", text)


@GROUNDS
def test_findings_in_a_text_can_be_read_on_any_desktop(desktop, ground, letters):
    desktop(ground, letters)
    written = colours_of(
        result_html.findings([Finding(severity, "gouge", "Raise it.") for severity in Severity])
    )
    assert len(set(written)) == 3
    assert min(contrast(ground, one) for one in written) >= ENOUGH


@GROUNDS
def test_what_the_machine_editor_says_can_be_read_on_any_desktop(desktop, pump, ground, letters):
    desktop(ground, letters)
    opened = machine_editor.create()
    pump(200)
    note = colours_of(opened.findings.text())
    opened._tell("Give it a name.")
    error = colours_of(opened.findings.text())
    assert note and error
    assert min(contrast(ground, one) for one in (*note, *error)) >= ENOUGH
    opened.reject()
    pump(200)


@GROUNDS
def test_the_error_beside_a_comparison_can_be_read_on_any_desktop(desktop, window, ground, letters):
    desktop(ground, letters)
    dock = QtWidgets.QDockWidget()
    table = comparison_table.Table(dock)
    table.say_error("The folder is not there.")
    assert contrast(ground, colours_of(table.error.styleSheet())[0]) >= ENOUGH
    dock.deleteLater()


def test_long_sentences_over_a_comparison_do_not_widen_the_window(window):
    dock = QtWidgets.QDockWidget()
    table = comparison_table.Table(dock)
    narrow = dock.widget().minimumSizeHint().width()
    table.verdict.setText("24 of 40 ways hold 0.01 mm; the quickest is trunnion_ac. " * 5)
    table.say_error("The folder is not there. " * 10)
    assert dock.widget().minimumSizeHint().width() < narrow + 300
    dock.deleteLater()
