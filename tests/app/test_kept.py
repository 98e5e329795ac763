# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the fixture ``kept`` spares the other tests: the same thing computed twice. Another one is computed,
and so is everything in tests that do not ask for the fixture, or that mark it ``anew``."""

from pathlib import Path

import pytest
from conftest import PLAIN, half_ball

from freecad_fiveaxis import app
from freecad_fiveaxis.app import reach, results
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies import reach_map, study

SETTINGS = {"machine": "trunnion_ac", "stepover": 8.0, "gouge": "off", "linearize": "off", **PLAIN}
REACH = {"machine": "trunnion_ac", "cutter": "ball:6:20", "tolerance": 0.02}
TESTS = Path(__file__).resolve().parents[1]


@pytest.fixture
def computed(anew, monkeypatch):
    """What the core has computed so far, by name; from earlier tests nothing is kept."""
    message = []
    for module, name in ((job, "prove"), (study, "try_reach")):
        act = getattr(module, name)
        monkeypatch.setattr(
            module, name, lambda *given, act=act, name=name: (message.append(name), act(*given))[1]
        )
    return message


def test_the_same_is_computed_once_and_anything_else_is_computed(computed, kept, anew, doc, ball):
    mesh = app.tessellate(ball, linear_deflection=0.3)
    nc = [results.nc_of(app.create_toolpath(doc, mesh, **SETTINGS)) for _ in range(2)]
    assert computed == ["prove"] and nc[0] == nc[1]
    other = app.create_toolpath(doc, mesh, **{**SETTINGS, "stepover": 9.0})
    assert computed == ["prove"] * 2 and results.nc_of(other) != nc[0]
    ball.Shape = half_ball(18.0)
    doc.recompute()
    assert computed == ["prove"] * 4, "the two that are alike are computed once, for the part is another"
    anew()
    app.create_toolpath(doc, mesh, **SETTINGS)
    assert computed == ["prove"] * 5


def test_what_a_fingerprint_forgets_is_computed_all_the_same(computed, kept, doc, ball, monkeypatch):
    """A fault that other tests look for must not be hidden by what is kept."""
    monkeypatch.setattr(results.Task, "fingerprint", "always the same")
    mesh = app.tessellate(ball, linear_deflection=0.3)
    nc = [
        results.nc_of(app.create_toolpath(doc, mesh, **{**SETTINGS, "stepover": step})) for step in (8.0, 9.0)
    ]
    assert computed == ["prove"] * 2 and nc[0] != nc[1]


def test_a_map_of_what_is_reached_is_kept_and_one_of_other_places_is_not(
    computed, kept, doc, ball, monkeypatch
):
    monkeypatch.setattr(reach_map, "PLACES", 60)
    mesh = app.tessellate(ball, linear_deflection=0.3)
    first, again = (reach.find_map(app.reach_map(mesh, **REACH)) for _ in range(2))
    assert computed == ["try_reach"] and first is again
    app.reach_map(mesh, **{**REACH, "cutter": "ball:6:30"})
    monkeypatch.setattr(reach_map, "PLACES", 80)
    app.reach_map(mesh, **REACH)
    assert computed == ["try_reach"] * 3


def test_without_the_fixture_everything_is_computed(computed, doc, ball):
    mesh = app.tessellate(ball, linear_deflection=0.3)
    for _ in range(2):
        app.create_toolpath(doc, mesh, **SETTINGS)
    assert computed == ["prove"] * 2


@pytest.mark.parametrize(
    "name", ["app/test_long_work.py", "gui/test_long_work.py", "app/test_spreading.py", "app/test_batch.py"]
)
def test_tests_of_long_work_threads_and_processes_keep_nothing(name):
    assert '"kept"' not in (TESTS / name).read_text(encoding="utf-8")
