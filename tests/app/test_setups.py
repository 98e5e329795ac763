# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of setups and the comparison of machines, on the document side."""

import json

import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import comparing, setups
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError, SettingsError

SMALL = {"region": (50, 50, 50), "grid": (3, 3, 2)}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def path(doc, ball):
    """A coarse path over the half ball, its work zero 40 mm off the document's."""
    return app.create_toolpath(doc, ball, **{**FAST, "stepover": 6}, **UNCURED, work_zero=(0, 0, 40))


def test_the_map_says_where_to_clamp_and_applying_it_lowers_the_deviation(path):
    result = app.setup_map(path, **SMALL)
    before = path.MaxSurfaceDeviation.Value
    assert result.DeviationBefore.Value == pytest.approx(before, abs=1e-9)
    assert result.DeviationAfter.Value < 0.5 * before and result.UpToDate
    assert result.Kinds[:2] == ["setup-best", "setup-present"] and len(result.Places) == 2 + 18
    assert tuple(result.Places[1]) == pytest.approx((0, 0, 40))  # where the work zero is drawn
    best, present = result.Recommended, result.Centre
    assert tuple(result.Places[0] - result.Places[1]) == pytest.approx(tuple(best - present))
    app.apply_setup(result)
    assert tuple(path.Origin) == pytest.approx(tuple(best)) and not path.OriginFromMachine
    assert path.MaxSurfaceDeviation.Value == pytest.approx(result.DeviationAfter.Value, abs=1e-9)
    assert result.UpToDate, "the map is of the same path about the same centre"


def test_a_map_survives_and_is_out_of_date_only_when_its_path_is_another(path, reopen):
    result = app.setup_map(path, **SMALL, turns=1)
    kept = {
        name: result.getPropertyByName(name)
        for name in ("Verdict", "Kinds", "Deviations", "Fingerprint", "UpToDate")
    }
    doc = reopen(path.Document)
    result = doc.SetupMap
    assert {name: result.getPropertyByName(name) for name in kept} == kept and result.Proxy.last is None
    doc.Toolpath.Spindle = 5000  # is nothing to a setup
    doc.recompute()
    assert result.UpToDate and result.Proxy.last is None
    doc.Toolpath.Stepover = 7
    doc.recompute()
    assert not result.UpToDate and result.Proxy.last is None, "a change of the path tries no setups"
    with pytest.raises(SelectionError, match="try the setups again"):
        app.apply_setup(result)
    result.Region = (20, 0, 0)
    doc.recompute()
    assert result.UpToDate and len(result.Places) < len(kept["Kinds"])


@pytest.fixture
def jaw(doc):
    """A block 5 mm beside the half ball, as high as half of it."""
    result = doc.addObject("Part::Box", "Jaw")
    result.Length, result.Width, result.Height = 20, 40, 10
    result.Placement.Base = (25, -20, 0)
    doc.recompute()
    return result


@pytest.mark.thorough
def test_what_holds_the_part_goes_into_the_map_and_a_change_of_it_makes_the_map_old(path, jaw):
    path.Holder = "30x20"
    path.recompute()
    free = app.setup_map(path, **SMALL)
    assert any("stick-out" in text for text in free.Findings)
    assert not any("Jaws" in text for text in free.Findings)
    result = app.setup_map(path, **SMALL, fixtures=[jaw])
    assert result is free and path.Fixtures == [jaw] and result.UpToDate and "Touched" not in path.State
    (text,) = [text for text in result.Findings if text.startswith("Jaws 40 mm thick")]
    assert all(side in text for side in ("-X: ", "+X: ", "-Y: ", "+Y: "))
    kept = result.Proxy.last
    jaw.Height = 15
    path.Document.recompute()
    assert not result.UpToDate and result.Proxy.last is kept, (
        "a change of what holds the part tries no setups"
    )
    again = app.setup_map(path, **SMALL)
    assert again.UpToDate and path.Fixtures == [jaw], "they stay unless others are named"
    app.setup_map(path, **SMALL, fixtures=[])
    assert result.UpToDate and not path.Fixtures and not any("Jaws" in text for text in result.Findings)


@pytest.mark.thorough
def test_fixtures_of_a_map_that_cannot_be_stay_what_they_were(path, jaw, ball):
    app.setup_map(path, **SMALL, fixtures=[jaw])
    shown = path.Fingerprint
    for wrong, words in (
        ({"fixtures": [ball]}, "is the part that is milled"),
        ({"fixtures": [], "table_height": 1e4}, "on the table"),
    ):
        with pytest.raises(FiveAxisError, match=words):
            app.setup_map(path, **SMALL, **wrong)
        assert path.Fixtures == [jaw] and path.Fingerprint == shown and "Touched" not in path.State


def test_what_cannot_be_leaves_nothing_behind(path):
    for settings, words in (({"region": (0, 0, 0)}, "one setup only"), ({"grid": (0, 1, 1)}, "out of range")):
        with pytest.raises(SettingsError, match=words):
            app.setup_map(path, **settings)
    with pytest.raises(SelectionError):
        app.setup_map(path.Mesh)
    assert not [obj for obj in path.Document.Objects if "SetupMap" in obj.Name]


def test_a_turned_part_is_requested_not_built(path):
    result = app.setup_map(path, **SMALL)
    result.RecommendedTurn = 90
    with pytest.raises(SettingsError, match="turn the part by 90 deg"):
        setups.apply(result)


def test_the_page_replaces_nothing_unasked(path, tmp_path):
    result = app.setup_map(path, region=(50, 50, 0), grid=(2, 2, 1))
    file = tmp_path / "map.html"
    setups.write_page(result, file)
    assert "Where the part should stand" in file.read_text(encoding="utf-8")
    file.write_text("mine")
    with pytest.raises(FileError, match="exists"):
        setups.write_page(result, file)
    assert file.read_text() == "mine"
    setups.write_page(result, file, overwrite=True)
    assert "mine" not in file.read_text(encoding="utf-8")[:10]
    with pytest.raises(FileError, match="endings"):
        setups.write_page(result, tmp_path / "map.png")


def test_the_scale_runs_from_the_least_to_the_largest_deviation(path):
    result = app.setup_map(path, **SMALL)
    scale, values = setups.scale(result), list(result.Deviations)
    assert scale.marks[0][1] == pytest.approx(min(values)) and scale.marks[-1][1] == pytest.approx(
        max(values)
    )
    assert scale.level[values.index(min(values))] == 0.0 and scale.level[
        values.index(max(values))
    ] == pytest.approx(1.0)
    assert list(scale.good) == [value <= path.Tolerance.Value for value in values]
    result.Deviations = [0.5] * len(values)
    assert not setups.scale(result).level.any() and len(setups.scale(result).marks) == 1


def test_machines_are_compared_on_the_same_path(path, tmp_path):
    path.Linearize, path.Origin, path.OriginFromMachine = "on", (1, 2, 3), False
    path.recompute()
    comparison = comparing.compare(path, ["trunnion_ac", "trunnion_bc"], ["none", "linearize"])
    rows = {(row.machine, row.cure, row.tool_centre): row for row in comparison.rows}
    assert len(rows) == 2 * 2 * 2 and not any(row.problem for row in rows.values())
    path.Linearize, path.OriginFromMachine = "off", True
    path.recompute()
    assert rows["trunnion_ac", "none", False].deviation == pytest.approx(
        path.MaxSurfaceDeviation.Value, abs=1e-12
    )
    assert rows["trunnion_ac", "none", False].blocks == path.Blocks
    path.Linearize = "on"
    path.recompute()
    assert rows["trunnion_ac", "linearize", False].deviation == pytest.approx(
        path.MaxSurfaceDeviation.Value, abs=1e-12
    )
    file = tmp_path / "table.json"
    comparing.write(comparison, file)
    assert len(json.loads(file.read_text(encoding="utf-8"))["rows"]) == 8


def test_machines_are_compared_on_the_path_around_what_holds_the_part(path, jaw):
    before = app.compare(path, ["trunnion_ac"], ["none"])
    path.Fixtures = [jaw]
    path.recompute()
    around = app.compare(path, ["trunnion_ac"], ["none"])
    assert around[0].blocks == path.Blocks and not around[0].problem and len(around) == len(before)


def test_what_is_compared_is_proven_against_fixtures_that_need_not_be_the_paths_own(path, jaw):
    """Without them nothing is said of fixtures; beside others than its own the tool path stays as it is."""
    assert {row.fixtures for row in app.compare(path, ["trunnion_ac"], ["none"])} == {None}
    before = path.Fixtures, path.Fingerprint, path.State
    rows = app.compare(path, ["trunnion_ac"], ["none"], fixtures=[jaw])
    assert all(row.fixtures is not None and not row.problem for row in rows)
    assert (path.Fixtures, path.Fingerprint, path.State) == before
    path.Fixtures = [jaw]
    path.recompute()
    assert app.compare(path, ["trunnion_ac"], ["none"]) == rows
    assert {row.fixtures for row in app.compare(path, ["trunnion_ac"], ["none"], fixtures=[])} == {None}
    with pytest.raises(SelectionError, match="is the part that is milled"):
        app.compare(path, ["trunnion_ac"], ["none"], fixtures=[path.Mesh.Base[0]])


def test_what_cannot_be_compared_says_why(path):
    for machines, words in (([], "no machines"), (["no_such"], "no_such")):
        with pytest.raises(Exception, match=words):
            app.compare(path, machines)
    before = [obj.Name for obj in path.Document.Objects]
    assert app.compare(path, ["trunnion_ac"], ["none"])[0].blocks == path.Blocks
    assert [obj.Name for obj in path.Document.Objects] == before
