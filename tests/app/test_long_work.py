# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who hears how far the work is, in which thread it is done, and how it is stopped.

Dialog: stands in for the window's dialog, which there is none of without a window.
"""

import threading
import time

import FreeCAD
import numpy as np
import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import long_work, results
from freecad_fiveaxis.core.base.errors import Cancelled, MeshError
from freecad_fiveaxis.core.base.progress import silent


class Dialog:
    """Hears like the window's dialog; at its ``stop_after``-th turn it is cancelled, or calls ``then``.
    ``turns``: how many it had."""

    def __init__(self, stop_after=10**9, then=None):
        self.heard, self.threads, self.turns = [], set(), 0
        self.stop_after, self.then = stop_after, then

    def __call__(self, stage, fraction):
        self.heard.append((stage, fraction))
        self.pump()

    def pump(self):
        self.threads.add(threading.current_thread())
        self.turns += 1
        if self.turns >= self.stop_after:
            if self.then:
                self.then()
                return
            raise Cancelled("stopped")


def in_python(reported, freed):
    """Work that says nothing and goes on step by step, until it is freed."""
    while not freed.is_set():
        sum(range(1000))


def in_one_call(reported, freed):
    """Work that sits in one call until it is freed."""
    freed.wait(600)


def talking(reported, freed):
    """Work that says where it stands again and again, until it is freed."""
    while not freed.is_set():
        reported("step", 0.5)
        time.sleep(0.01)


@pytest.fixture
def freed():
    """What ends the work above; set at the end of the test."""
    event = threading.Event()
    yield event
    event.set()


def still_at_work():
    """The workers that have not ended."""
    return [one for one in threading.enumerate() if one.name == "FiveAxis"]


def test_without_a_window_nobody_listens():
    assert long_work.progress() is silent


def test_the_innermost_listener_hears():
    heard = []
    with long_work.reporting(lambda *reported: heard.append(("outer", *reported))):
        with (
            long_work.reporting(lambda *reported: heard.append(("inner", *reported))),
            long_work.listening() as listen,
        ):
            listen("a", 0.5)
        long_work.progress()("b", 1.0)
    assert heard == [("inner", "a", 0.5), ("outer", "b", 1.0)] and long_work.progress() is silent


def test_a_listener_is_forgotten_after_an_error():
    with pytest.raises(ValueError), long_work.reporting(lambda *reported: None):
        raise ValueError
    assert long_work.progress() is silent


def test_the_work_is_reported_stage_by_stage(doc, ball):
    heard = []
    with long_work.reporting(lambda stage, fraction: heard.append((stage, fraction))):
        path = app.create_toolpath(doc, ball, **FAST)
    stages = list(dict.fromkeys(stage for stage, _ in heard))
    assert stages[:2] == ["tessellate", "weld"] and len(stages) > 5
    assert all(0.0 <= fraction <= 1.0 for _, fraction in heard)
    heard.clear()
    path.Proxy.last = None
    results.result_of(path, lambda *reported: heard.append(reported))
    assert heard and long_work.progress() is silent


def test_the_core_works_in_a_thread_and_the_dialog_in_the_one_that_requested():
    dialog, threads = Dialog(), set()

    def work(reported):
        threads.add(threading.current_thread())
        for step in range(10):
            reported("weld", step / 10)
            time.sleep(0.05)
        return np.geterr()["over"]

    with np.errstate(over="raise"):
        assert long_work.run(work, dialog) == "raise"
    assert dialog.threads == {threading.main_thread()} and not threads & dialog.threads
    assert dialog.heard[-1] == ("weld", 0.9) and dialog.turns > 5


def test_a_listener_without_a_window_is_reported_in_the_same_thread():
    assert (
        long_work.run(lambda reported: threading.current_thread(), lambda *reported: None)
        is threading.main_thread()
    )


def test_what_the_work_raises_reaches_the_caller():
    def fail(reported):
        raise MeshError("no facets", 0)

    with pytest.raises(MeshError, match="no facets"):
        long_work.run(fail, Dialog())


@pytest.mark.parametrize("work", [in_python, in_one_call, talking])
def test_a_stop_gives_the_thread_back_while_the_work_goes_on(work, freed):
    """No work of these ends by itself: that this test comes to its end is the proof."""
    with pytest.raises(Cancelled):
        long_work.run(lambda reported: work(reported, freed), Dialog(stop_after=10))
    assert long_work.progress() is silent and not freed.is_set()
    assert bool(still_at_work()) == (work is in_one_call), "only what sits in one call is abandoned"
    freed.set()
    for worker in still_at_work():
        worker.join(60)
    assert not still_at_work()


def test_work_that_says_nothing_ends_by_a_stop_with_a_message_and_not_a_word_on_the_console(
    freed, monkeypatch
):
    """What stops it raises the bare class; made without a message that was a TypeError, in red, seldom enough
    to pass by."""
    on_the_console = []
    monkeypatch.setattr(threading, "excepthook", on_the_console.append)
    for _ in range(20):
        worker = long_work.Worker(lambda reported: in_python(reported, freed))
        worker.start()
        worker.stop()
        worker.join(60)
        with pytest.raises(Cancelled, match="nothing was changed"):
            worker.result()
    assert not on_the_console and not still_at_work()


def test_an_abandoned_worker_ends_after_its_call_and_goes_no_further(freed):
    went_on = []

    def work(reported):
        freed.wait(600)
        went_on.append(1)
        reported("never", 1.0)
        went_on.append(2)

    with pytest.raises(Cancelled):
        long_work.run(work, Dialog(stop_after=4))
    (worker,) = still_at_work()
    freed.set()
    worker.join(60)
    assert not went_on and not still_at_work()


def test_stopping_over_and_over_while_the_work_ends_does_no_harm():
    for _ in range(200):
        dialog = Dialog(stop_after=1)
        try:
            assert (
                long_work.run(lambda reported: [reported("a", 0.5), sum(range(20000))][1], dialog)
                == 199990000
            )
        except Cancelled:
            assert dialog.turns
    assert not still_at_work()


def test_a_recompute_that_nobody_listens_to_is_shown_by_the_window(doc, ball, monkeypatch):
    path, dialog = app.create_toolpath(doc, ball, **FAST), Dialog()
    monkeypatch.setattr(long_work, "windows", [lambda: long_work.reporting(dialog)])
    path.Stepover = 3
    doc.recompute()
    assert (
        "Up-to-date" in path.State
        and dict(dialog.heard)["deviation"] == 1.0
        and long_work.progress() is silent
    )


def test_a_stopped_recompute_keeps_the_last_result_and_says_that_it_is_old(doc, ball, monkeypatch):
    path, dialog = app.create_toolpath(doc, ball, **FAST), Dialog(stop_after=1)
    monkeypatch.setattr(long_work, "windows", [lambda: long_work.reporting(dialog)])
    blocks, nc = path.Blocks, results.nc_of(path)
    path.Stepover = 3
    doc.recompute()
    assert path.Blocks == blocks and results.out_of_date(path)
    path.Stepover = 4
    assert results.nc_of(path) == nc
    monkeypatch.setattr(long_work, "windows", [])
    path.Stepover = 3
    doc.recompute()
    assert path.Blocks > blocks and not results.out_of_date(path)


def test_a_document_that_is_closed_under_the_work_stops_it(doc, ball):
    path = app.create_toolpath(doc, ball, **FAST)
    path.Stepover = 0.05
    name = doc.Name
    dialog = Dialog(0.0, then=lambda: name in FreeCAD.listDocuments() and FreeCAD.closeDocument(name))
    with pytest.raises(Cancelled, match="closed"):
        results.result_of(path, dialog)


@pytest.mark.parametrize(
    "make", [app.create_toolpath, lambda doc, ball, **_: app.setup_map(doc.Toolpath)], ids=["path", "map"]
)
def test_what_was_being_built_goes_with_a_document_that_is_closed(doc, ball, make):
    app.create_toolpath(doc, ball, **FAST)
    name = doc.Name
    dialog = Dialog(0.0, then=lambda: name in FreeCAD.listDocuments() and FreeCAD.closeDocument(name))
    with pytest.raises(Cancelled, match="closed"), long_work.reporting(dialog):
        make(doc, ball, **{**FAST, "linear_deflection": 0.05})
    assert name not in FreeCAD.listDocuments()
