# SPDX-License-Identifier: LGPL-2.1-or-later
"""After a macro that failed the document is as it was, and what it tells of a path is true."""

import FreeCAD
import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import reach, rest, results, setups
from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError

pytestmark = pytest.mark.usefixtures("kept")
SMALL = {"region": (20, 20, 0), "grid": (3, 3, 1)}


@pytest.fixture
def mapped(doc, ball):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 6}, **UNCURED)
    return path, app.left_map(path), app.setup_map(path, **SMALL)


def looks(doc):
    return [(one.Name, one.Label, one.State) for one in doc.Objects]


def test_maps_of_a_path_whose_part_is_gone_stay_as_they_were(doc, ball, mapped):
    path, left, where = mapped
    doc.removeObject(ball.Name)
    doc.recompute()
    before, values = looks(doc), [left.Verdict, where.Verdict, tuple(where.Recommended), tuple(where.Grid)]
    for call in (lambda: app.left_map(path), lambda: app.setup_map(path, **{**SMALL, "grid": (2, 2, 1)})):
        with pytest.raises(FiveAxisError):
            call()
        assert looks(doc) == before
    assert [left.Verdict, where.Verdict, tuple(where.Recommended), tuple(where.Grid)] == values


def test_a_map_with_settings_that_cannot_be_is_still_that_of_before(doc, mapped):
    where, before = mapped[2], looks(doc)
    with pytest.raises(SettingsError):
        app.setup_map(mapped[0], region=(0, 0, 0))
    assert looks(doc) == before and tuple(where.Region) == (20, 20, 0) and where.UpToDate
    assert not where.Proxy.wants_trials and setups.is_up_to_date(where)


def test_a_path_that_came_without_its_mesh_does_not_say_that_this_was_deleted(doc, mapped, reopen):
    path, other = mapped[0], FreeCAD.newDocument("Other")
    try:
        copied = other.copyObject(path, False)
        for call in (results.result_of, app.left_map, app.reach_map):
            with pytest.raises(FiveAxisError, match="has no mesh: choose one"):
                call(copied)
        whole = other.copyObject(path, True)
        whole = whole[-1] if isinstance(whole, (tuple, list)) else whole
        assert whole.Mesh is not None
        other.removeObject(whole.Mesh.Name)
        with pytest.raises(FiveAxisError, match="was deleted: undo that"):
            results.result_of(whole)
    finally:
        FreeCAD.closeDocument(other.Name)
    name = path.Name
    again = reopen(doc)
    again.removeObject(again.getObject(name).Mesh.Name)
    with pytest.raises(FiveAxisError, match="was deleted: undo that"):
        results.result_of(again.getObject(name))


def test_the_names_of_maps_are_in_the_users_language(doc, ball, monkeypatch):
    for module in (rest, reach, setups):
        monkeypatch.setattr(module, "translate", lambda context, text: f"{context}: {text}")
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 6}, **UNCURED)
    maps = app.left_map(path), app.setup_map(path, **SMALL), app.reach_map(path)
    assert [one.Label for one in maps] == [
        f"FiveAxis: {text}" for text in ("What is left", "Setup map", "Reach map")
    ]
