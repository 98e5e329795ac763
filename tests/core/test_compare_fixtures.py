# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strategies compared beside a fixture: each program's own entry into it, as a run of ``mill`` proves it and as
dense samples see it; where there is none, the table is as before."""

import json
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import dense_points, sampled_depth
from mesh_shapes import box
from plain import build_settings
from uncured import UNCURED

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import straight_motion
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.pipeline import driving, job
from freecad_fiveaxis.core.studies import study
from freecad_fiveaxis.core.studies.compare import compare_html, compare_json, compare_text, stations, verdict
from freecad_fiveaxis.core.studies.compare.beside_fixtures import hits_fixture
from freecad_fiveaxis.core.studies.study import as_text, try_machines
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of
from freecad_fiveaxis.core.toolpath.cl_path import Motion

PLATE = from_triangles(box((0, 0, 0), (30, 20, 10)))
CLAMP = Fixture("clamp.stl", from_triangles(box((10, -8, 10.5), (20, 4, 25))))
"""Over the edge of the plate, half a mm above its top."""
PATH = {"cutter": "ball:6", "stepover": 5.0, "passes": "planes", "tool_length": 120.0, "feed_mode": "g94"}


def compared(cures, fixtures=(CLAMP,), machines="trunnion_ac", **options):
    given = {"machines": machines, "cures": cures, **PATH, **options}
    return try_machines(build_settings("compare", "plate.stl", given), mesh=PLATE, fixtures=fixtures)


def milled(fixtures=(CLAMP,), **options):
    given = {"machine": "trunnion_ac", **PATH, "linearize": "off", **options}
    settings = build_settings("mill", "plate.stl", given)
    return job.prove(job.make(settings, mesh=PLATE, fixtures=fixtures))


def worst(findings):
    (found,) = [one for one in findings if one.code == Code.FIXTURE_COLLISION]
    return found.value, found.place, found.hit


@pytest.mark.parametrize("more", [{}, {"holder": "40x30"}], ids=["cutter", "holder"])
def test_each_row_meets_the_fixture_as_the_program_that_mill_makes(more):
    """Nothing is lifted: the path goes through the clamp."""
    row = compared("none", gouge="off", **more).rows[0]
    result = milled(**UNCURED, **more)
    assert row.blocks == len(result.draft.program.words) and row.time == result.draft.program.seconds.sum()
    assert worst(row.fixtures) == worst(result.findings) and row.fixtures[0].value > 1.0


@pytest.mark.thorough
@pytest.mark.oldest
def test_unless_another_cure_is_named_the_path_is_lifted_out_of_the_fixture_as_in_mill():
    row, result = compared("none").rows[0], milled()
    assert row.blocks == len(result.draft.program.words) and row.fixtures == ()
    assert not [one for one in result.findings if one.code == Code.FIXTURE_COLLISION]
    off = compared("none", gouge="off")
    assert off.settings.gouge.gouge == "off" and compared("none").settings.gouge.gouge == "lift"
    assert compared("none", fixtures=()).settings.gouge.gouge == "lift", "without fixtures too"


def test_where_the_controller_guides_the_tip_dense_samples_of_its_way_find_the_same_depth(tmp_path):
    """The tip on its chord, the axis on the great arc from one end to the other, past a clamp: the cutter leans
    away from it as it goes. Where the machine's axes lead the tip it leaves the chord, and goes elsewhere."""
    source = tmp_path / "a.apt"
    source.write_text("CUTTER/6,3\nFEDRAT/500\nGOTO/0,5,12,0,0,1\nGOTO/30,6,12,0.6,0.3,0.74162\nFINI\n")
    given = {"machines": "trunnion_ac", "cures": "none", "tool_length": 120.0, "cutter": "ball:6:30"}
    found = try_machines(build_settings("compare", str(source), given), fixtures=(CLAMP,))
    free, guided = found.rows
    path = found.draft.path
    swept = straight_motion(path.tip[-2:], path.axis[-2:])
    deepest = sampled_depth(body_of(Cutter(6.0, 30.0)), dense_points(CLAMP.mesh, 0.25), swept, 0, 200)
    assert worst(guided.fixtures)[0] == pytest.approx(deepest, abs=0.05) and 0.5 < deepest < 2.9
    assert abs(worst(free.fixtures)[0] - deepest) > 0.1


def test_what_hits_a_fixture_is_not_among_the_ways_that_hold_and_the_table_says_how_deep():
    found = compared("none,linearize", gouge="off")
    text, record = as_text(found), json.loads(compare_json(found.rows))
    assert all(hits_fixture(row.fixtures) for row in found.rows) and len(found.rows) == 4
    assert "stays out of the fixtures" in text and "In 4 of 4 ways the tool hits a fixture." in text
    assert text.count("in clamp.stl") == 4 and " fixtures" in text
    assert [len(row["fixtures"]) for row in record["rows"]] == [1] * 4
    assert "mm in clamp.stl" in compare_html(found.rows) and "Fixtures: how deep" in compare_html(found.rows)
    (hit,) = found.findings
    assert hit.code == Code.FIXTURE_COLLISION and hit.severity is Severity.ERROR and "clamp.stl" in hit.text
    free = compared("linearize")
    assert free.findings == () and "hits a fixture" not in as_text(free)
    assert verdict(free.rows, 0.01).startswith("2 of 2 ways hold 0.01 mm")
    assert compare_text(free.rows, 0.01).count(" free\n") == 2


def test_without_fixtures_nothing_of_them_is_reported():
    found = compared("none", fixtures=())
    assert [row.fixtures for row in found.rows] == [None, None]
    for text in (as_text(found), compare_json(found.rows), compare_html(found.rows)):
        assert "ixture" not in text


def test_a_fixture_far_away_changes_nothing_of_what_is_cut():
    """Links and rapids go over the box of all that stands there, as in mill."""
    far = Fixture("far", from_triangles(box((400, 0, -300), (410, 20, -290))))
    one, other = (
        found.draft.path for found in (compared("none", (), gouge="lift"), compared("none", (far,)))
    )
    cut, also = one.motion == Motion.CUT, other.motion == Motion.CUT
    for column in ("tip", "axis", "feed"):
        np.testing.assert_array_equal(getattr(one, column)[cut], getattr(other, column)[also])
    assert compared("none", (far,)).rows[0].fixtures == ()


def test_what_comes_nearer_than_the_clearance_stands_in_the_table():
    aside = Fixture("aside", from_triangles(box((10, -12, 0), (20, -5, 25))))
    found = compared("none", fixtures=(aside,), fixture_clearance=5.0)
    assert [one.code for one in found.rows[0].fixtures] == [Code.FIXTURE_NEAR]
    assert "mm from aside" in as_text(found) and "hits" not in as_text(found)


@pytest.mark.oldest
@pytest.mark.thorough
def test_the_spindle_of_each_machine_is_looked_at_where_the_tools_length_is_known(monkeypatch):
    """A nose 60 mm wide, 20 mm above the tip of a short tool, over a wall beside the plate that the cutter
    never comes near."""
    nose = MachineBody("nose", "spindle", "cylinder", ((0, 0, 0), (0, 0, 80)), radii=(60.0,))
    machine = replace(load_machine("trunnion_ac"), bodies=(nose,))
    wall = Fixture("wall", from_triangles(box((60, 0, 0), (64, 20, 45))))
    monkeypatch.setattr(study, "load_machine", lambda name: machine)
    monkeypatch.setattr("freecad_fiveaxis.core.pipeline.options.load_machine", lambda name: machine)
    rows = {}
    for length in (20.0, None):
        rows[length] = compared("none", (wall,), tool_length=length).rows[0].fixtures
    assert worst(rows[20.0])[2].enters == "spindle" and rows[None] == ()


@pytest.fixture
def files(tmp_path):
    write_stl(PLATE, tmp_path / "plate.stl")
    write_stl(CLAMP.mesh, tmp_path / "clamp.stl")
    write_stl(from_triangles(box((0, 0, 0), (10, 12, 14.5))), tmp_path / "own.stl")
    return tmp_path


FLAGS = ["--machines", "trunnion_ac", "--cures", "none", "--cutter", "ball:6", "--stepover", "5"]
FLAGS += ["--tool-length", "120"]


def test_the_command_line_takes_fixtures_for_a_part_and_for_a_cl_file(files, capsys):
    part, report = str(files / "plate.stl"), files / "r.json"
    fixture = ["--fixture", f"{files / 'own.stl'}@10,-8,10.5"]
    planes = ["--passes", "planes"]
    out = ["--report", str(report)]
    assert (
        cli.main(["compare", part, *FLAGS, *planes, *fixture, "--gouge", "off", *out]) == cli.DONE_WITH_ERRORS
    )
    text, record = capsys.readouterr().out, json.loads(report.read_text())
    assert "mm in own.stl@10,-8,10.5" in text and record["inputs"]["fixture"] == [fixture[1]]
    assert cli.main(["compare", part, *FLAGS, *planes, *fixture]) == cli.DONE
    assert " free" in capsys.readouterr().out
    source = files / "a.apt"
    source.write_text("CUTTER/6,3\nFEDRAT/500\nGOTO/15,-4,13,0,0,1\nGOTO/15,10,13,0,0,1\nFINI\n")
    assert cli.main(["compare", str(source), *FLAGS[:4], *fixture]) == cli.DONE_WITH_ERRORS
    assert "mm in own.stl@10,-8,10.5" in capsys.readouterr().out


def test_a_fixture_in_the_part_is_one_line_with_exit_code_2_before_the_work(files, capsys):
    report = files / "never.json"
    given = ["--fixture", f"{files / 'own.stl'}@10,5,-5", "--report", str(report)]
    assert cli.main(["compare", str(files / "plate.stl"), *FLAGS, *given]) == cli.UNUSABLE
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert "own.stl" in line and "stands in the part" in line and not report.exists()


def test_retracts_keep_off_the_box_of_part_and_fixture_as_in_mill(monkeypatch):
    """What the joint paths of both are asked to keep off, and with which tool."""
    calls = []
    for module in (stations, driving):
        whole = module.solve
        monkeypatch.setattr(
            module, "solve", lambda *given, whole=whole, **more: calls.append(given) or whole(*given, **more)
        )
    compared("none", holder="40x30")
    assert len(calls) == 2, "the program of the draft, which is the row's own, and where the tip is guided"
    (_, _, low, high, *_, milled_tool, _), (_, _, also_low, also_high, *_, tool, _) = calls
    assert low.tolist() == also_low.tolist() == [0, -8, 0]
    assert high.tolist() == also_high.tolist() == [30, 20, 25]
    assert tool == milled_tool and len(tool.pieces) > 1
