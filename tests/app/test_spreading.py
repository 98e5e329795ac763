# SPDX-License-Identifier: LGPL-2.1-or-later
"""Studies of the document side by processes beside FreeCAD: the same result, and none of them is left."""

import sys
from dataclasses import replace

import FreeCAD
import pytest
from conftest import FAST, UNCURED, half_ball

from freecad_fiveaxis import app
from freecad_fiveaxis.app import comparing, interpreters, meshing, preferences, setups, spreading
from freecad_fiveaxis.core.base import chunks, workers
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.studies import reach_map, study

REGION = {"region": (40, 40, 0), "grid": (2, 2, 1), "turns": 2}


pools = []


class Pool(workers.WorkerProcesses):
    """Gives all trials to its processes."""

    def __init__(self, find, count, patience):
        super().__init__(find, count, 0.0)
        pools.append(self)

    def _work_here(self):
        """Do nothing here."""


@pytest.fixture
def started(monkeypatch):
    """The processes that are started; all trials go to them, two at a time."""
    processes, begin = [], workers.start
    monkeypatch.setattr(workers, "start", lambda *given: processes.append(begin(*given)) or processes[-1])
    monkeypatch.setattr(spreading, "WorkerProcesses", Pool)
    pools.clear()
    preferences.write("Processes", 2)
    yield processes
    FreeCAD.ParamGet(preferences.GROUP).RemUnsigned("Processes")


@pytest.fixture(scope="module")
def coarse():
    """A coarse path over a half ball: made once, for most of the time would go there."""
    doc = FreeCAD.newDocument("Spreading")
    ball = doc.addObject("Part::Feature", "Ball")
    ball.Shape = half_ball()
    doc.recompute()
    yield app.create_toolpath(doc, ball, **{**FAST, "stepover": 12}, **UNCURED)
    FreeCAD.closeDocument(doc.Name)


@pytest.fixture
def path(coarse):
    """It, without a map."""
    for one in [setups.of(coarse)] if setups.of(coarse) else []:
        coarse.Document.removeObject(one.Name)
    return coarse


def in_this_process(monkeypatch, work):
    """What the work gives without processes."""
    with monkeypatch.context() as patch:
        patch.setattr(preferences, "processes", lambda: 1)
        patch.setattr(spreading, "WorkerProcesses", None)
        return work()


known = []


def map_of_this_process(path, monkeypatch):
    """What the map of the path shows without processes; made once."""
    if not known:
        known.append(shown(in_this_process(monkeypatch, lambda: app.setup_map(path, **REGION))))
        path.Document.removeObject("SetupMap")
    return known[0]


def shown(result):
    """What a map shows."""
    names = ("Verdict", "Places", "Deviations", "Recommended", "DeviationAfter", "TimeAfter", "Fingerprint")
    return {name: str(result.getPropertyByName(name)) for name in names}


@pytest.mark.parametrize("without_python", [False, True], ids=["python", "freecad"])
def test_processes_give_the_same_map_and_none_is_left(path, started, monkeypatch, without_python):
    if without_python:
        if not meshing.command():
            pytest.skip("there is no FreeCAD without a window")
        monkeypatch.setattr(interpreters, "_proven", {})
        monkeypatch.setattr(interpreters, "candidates", lambda around: [])
    expected = map_of_this_process(path, monkeypatch)
    assert shown(app.setup_map(path, **REGION)) == expected
    assert len(started) == 2 and all(process.returncode is not None for process in started)
    assert [pool.died for pool in pools] == [0]


def test_processes_give_the_same_comparison(path, started, monkeypatch):
    def compared():
        return study.as_json(comparing.compare(path, ["trunnion_ac", "trunnion_bc"], ["none", "deform"]))

    assert compared() == in_this_process(monkeypatch, compared)
    assert len(started) == 2 and [pool.died for pool in pools] == [0]


def test_a_process_that_is_killed_changes_nothing(path, started, monkeypatch):
    expected = map_of_this_process(path, monkeypatch)
    do = workers._Worker.do
    monkeypatch.setattr(workers._Worker, "do", lambda self, *given: [self.kill(), do(self, *given)])
    assert shown(app.setup_map(path, **REGION)) == expected and pools[0].died == len(started) > 0


def test_a_stop_leaves_no_process(path, started):
    def stop(stage, fraction):
        if started:
            raise Cancelled("enough")

    with pytest.raises(Cancelled, match="enough"):
        comparing.compare(path, ["trunnion_ac"], ["none", "deform"], progress=stop)
    assert all(process.wait(60) is not None for process in started)


def test_fewer_processes_than_pay_are_this_one(monkeypatch):
    for count, least, here in ((1, 2, True), (2, 2, False), (2, 3, True), (3, 3, False)):
        monkeypatch.setattr(preferences, "processes", lambda count=count: count)
        with spreading.processes(least) as executor:
            assert (executor is None) == here


def test_processes_give_the_same_reach_map(path, started, monkeypatch):
    """Of three processes; two would not be worth it."""
    monkeypatch.setattr(reach_map, "PLACES", 80)
    preferences.write("Processes", 3)
    tool = {"machine": "trunnion_ac", "cutter": "ball:6:20", "holder": "40x30"}

    def mapped():
        result = app.reach_map(path.Mesh, **tool)
        found = result.Proxy.last.trial
        path.Document.removeObject(result.Name)
        return study.as_json(found)

    assert mapped() == in_this_process(monkeypatch, mapped) and started and pools[0].died == 0


def test_where_no_python_is_found_the_study_is_done_here(path, started, monkeypatch):
    """And the next time nobody is asked again."""
    monkeypatch.setattr(interpreters, "_proven", {})
    monkeypatch.setattr(
        spreading,
        "Around",
        lambda home, program: replace(interpreters.Around(""), executables=(), prefixes=()),
    )
    rows = app.compare(path, ["trunnion_ac"], ["none"])
    assert rows[0].blocks == path.Blocks and not started
    with spreading.processes() as executor:
        assert executor is None


def test_freecad_itself_is_never_taken_for_a_python():
    found = interpreters.candidates(interpreters.Around(FreeCAD.getHomePath(), meshing.command()))
    assert all("freecad" not in one.name.lower() for one in found)
    assert chunks.PROCESSORS and (sys.platform != "linux" or found)
