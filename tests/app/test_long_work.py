# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who hears how far the work is, and how FreeCAD's own bar stops it."""

from typing import ClassVar

import FreeCAD
import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import long_work, results
from freecad_fiveaxis.core.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.progress import silent


class Bar:
    """Stands in for FreeCAD's bar, which shows nothing without a window."""

    made: ClassVar[list] = []
    stop_at = 10**9

    def __init__(self):
        self.steps, self.running = 0, False
        Bar.made.append(self)

    def start(self, text, steps):
        self.text, self.running = text, True

    def next(self, can_stop):
        assert can_stop and self.running
        self.steps += 1
        if self.steps >= Bar.stop_at:
            raise FreeCAD.Base.FreeCADAbort("Esc")

    def stop(self):
        self.running = False


@pytest.fixture
def bar(monkeypatch):
    Bar.made, Bar.stop_at = [], 10**9
    monkeypatch.setattr(long_work, "_Indicator", Bar)
    monkeypatch.setattr(long_work, "_has_window", lambda: True)
    return Bar


def test_without_a_window_nobody_listens():
    assert long_work.progress() is silent


def test_the_innermost_listener_hears():
    heard = []
    with long_work.reporting(lambda *told: heard.append(("outer", *told))):
        with long_work.reporting(lambda *told: heard.append(("inner", *told))), long_work.listening() as listen:
            listen("a", 0.5)
        long_work.progress()("b", 1.0)
    assert heard == [("inner", "a", 0.5), ("outer", "b", 1.0)] and long_work.progress() is silent


def test_a_listener_is_forgotten_after_an_error():
    with pytest.raises(ValueError), long_work.reporting(lambda *told: None):
        raise ValueError
    assert long_work.progress() is silent


def test_the_work_is_told_stage_by_stage(doc, ball):
    heard = []
    with long_work.reporting(lambda stage, fraction: heard.append((stage, fraction))):
        path = app.create_toolpath(doc, ball, **FAST)
    stages = list(dict.fromkeys(stage for stage, _ in heard))
    assert stages[:2] == ["tessellate", "weld"] and len(stages) > 5
    assert all(0.0 <= fraction <= 1.0 for _, fraction in heard)
    heard.clear()
    path.Proxy.last = None
    results.result_of(path, lambda *told: heard.append(told))
    assert heard and long_work.progress() is silent


def test_freecads_bar_runs_and_is_taken_away(doc, ball, bar):
    app.create_toolpath(doc, ball, **FAST)
    assert len(bar.made) > 5 and not any(one.running for one in bar.made)
    assert bar.made[0].text == "Five-axis: tessellate" and all(one.steps < 100 for one in bar.made)


def test_esc_stops_the_work_and_leaves_the_document_as_it_was(doc, ball, bar):
    bar.stop_at = 20
    with pytest.raises(Cancelled, match="stopped") as stopped:
        app.create_toolpath(doc, ball, **FAST)
    assert isinstance(stopped.value, FiveAxisError) and isinstance(stopped.value.__cause__, BaseException)
    assert [one.Name for one in doc.Objects] == ["Ball"] and not any(one.running for one in bar.made)


def test_the_real_bar_of_this_freecad_counts(monkeypatch):
    monkeypatch.setattr(long_work, "_has_window", lambda: True)
    with long_work.listening() as listen:
        for step in range(11):
            listen("weld", step / 10)
        listen("passes", 0.5)
    assert long_work.progress() is not silent
