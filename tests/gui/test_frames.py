# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often the tests have the window painted: seldom, but the last change always; and at once where a test
asks for that."""

import pytest
from conftest import FRAME, QtWidgets


class Seen(QtWidgets.QLabel):
    """A label that notes each text that is painted."""

    def __init__(self):
        super().__init__()
        self.seen = []

    def paintEvent(self, event):
        self.seen.append(self.text())
        super().paintEvent(event)


@pytest.fixture
def label(window, until):
    """One in the window's status bar, that was painted once."""
    shown = Seen()
    window.statusBar().addWidget(shown)
    shown.setText("first")
    shown.show()
    until(lambda: "first" in shown.seen, 20000, "the label painted")
    shown.seen.clear()
    yield shown
    window.statusBar().removeWidget(shown)
    shown.deleteLater()


def count_up(label, pump):
    for number in range(10):
        label.setText(f"number {number}")
        pump(30)


def test_changes_are_painted_together_and_the_last_one_always(label, frames, pump, until, monkeypatch):
    assert frames.between == FRAME
    monkeypatch.setattr(frames, "between", 3000)
    count_up(label, pump)
    assert len(set(label.seen)) <= 5
    until(lambda: label.seen and label.seen[-1] == "number 9", 20000, "the last change painted")


def test_every_frame_is_painted_where_a_test_asks_for_it(every_frame, frames, label, pump):
    assert frames.between == 0
    count_up(label, pump)
    assert len(set(label.seen)) >= 8
