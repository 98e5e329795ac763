# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part, fixtures and machine in the tasks that write no program: what stands in a body and what is in other
units is reported by each of them, and no setup is recommended for which the fixtures would have to move."""

import json

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings
from test_machine_bodies import machine_file

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies.study import as_html, as_text, run, try_machines, try_setups

GIVEN = {
    "cutter": "ball:6", "holder": "40x30", "passes": "planes", "stepover": 8.0,
    "tool_length": 120.0, "region": (0.0, 0.0, 100.0), "grid": (1.0, 1.0, 9.0),
}  # fmt: skip
PLATTER = {
    "name": "platter",
    "carrier": "C",
    "cylinder": {"low": [0, 0, -60], "high": [0, 0, -15], "radius": 99},
}


def solid(*boxes):
    return from_triangles(np.concatenate([box(*one) for one in boxes]))


def block():
    """A part whose sides are milled with the rotary axes about 90 deg from the top's."""
    return solid(((-30, -20, 0), (30, 20, 40)))


def setup_of(mesh, fixtures, **more):
    given = build_settings("setup", "part.stl", {"machine": "trunnion_with_bodies", **GIVEN} | more)
    return try_setups(given, mesh=mesh, fixtures=tuple(Fixture(name, one) for name, one in fixtures.items()))


@pytest.fixture
def files(tmp_path):
    write_stl(solid(((-10, -10, 0), (10, 10, 10))), tmp_path / "part.stl")
    write_stl(solid(((-40, 20, -20), (40, 40, -5))), tmp_path / "vise.stl")
    write_stl(solid(((0.1, 12.0, -0.1), (0.2, 12.1, 0.0))), tmp_path / "small.stl")
    write_stl(solid(((0, 0, 0), (1, 1, 1))), tmp_path / "inches.stl")
    machine_file(tmp_path, [PLATTER])
    return tmp_path


HITS = ("machine-collision", "fixture-in-body")
OF_TASK = {
    "setup": ["--region", "0,0,5", "--grid", "1,1,2", "--passes", "planes", "--stepover", "4"],
    "reach": [],
    "compare": ["--passes", "planes", "--stepover", "4", "--cures", "none"],
}


def findings_of(task, files, source, *fixtures):
    machine = next(files.glob("*.fcm"))
    given = [task, str(files / source), f"--{'machines' if task == 'compare' else 'machine'}", str(machine)]
    given += ["--cutter", "ball:6", *OF_TASK[task], "--quiet", "--report", str(files / "r.json")]
    given += ["--report", str(files / "r.txt"), "--report", str(files / "r.html")]
    given += [word for one in fixtures for word in ("--fixture", str(files / one))]
    assert cli.main(given) in (0, 1)
    found = json.loads((files / "r.json").read_text())["findings"]
    text, page = (" ".join((files / f"r.{kind}").read_text().split()) for kind in ("txt", "html"))
    return {one["code"]: one for one in found}, text, page


@pytest.mark.parametrize("task", OF_TASK)
def test_a_vise_in_the_platter_and_one_in_other_units_are_reported_by_each_task(files, task):
    found, text, page = findings_of(task, files, "part.stl", "vise.stl", "small.stl")
    assert found["fixture-in-body"]["value"] == pytest.approx(5.0, abs=1.5)
    assert "small.stl" in found["unit-suspected"]["text"]
    for written in (text, page):
        assert "vise.stl stands in platter" in written and "--stl-units" in written


@pytest.mark.parametrize("task", OF_TASK)
def test_a_part_smaller_than_the_cutter_is_suspected_by_each_task(files, task):
    found, text, page = findings_of(task, files, "inches.stl")
    assert "whole part is 1 mm" in found["unit-suspected"]["text"]
    assert "whole part is 1 mm" in text and "whole part is 1 mm" in page


def test_what_is_placed_well_is_not_mentioned(files):
    write_stl(solid(((-40, 20, -15), (40, 40, -5))), files / "vise.stl")
    for task in OF_TASK:
        found, *_ = findings_of(task, files, "part.stl", "vise.stl")
        assert not {"fixture-in-body", "part-in-body", "unit-suspected"} & set(found)


def test_machines_are_named_where_something_stands_in_one_of_them(files):
    write_stl(solid(((-40, 20, -120), (40, 40, -5))), files / "vise.stl")
    given = build_settings(
        "compare", str(files / "part.stl"),
        {"machines": ("trunnion_with_bodies", "trunnion_ac"), "cutter": "ball:6", "passes": "planes",
         "stepover": 4.0, "cures": ("none",), "fixture": (str(files / "vise.stl"),)},
    )  # fmt: skip
    found = try_machines(given).findings
    texts = [one.text for one in found if one.code == "fixture-in-body"]
    assert texts and all(one.startswith("On trunnion_with_bodies: ") for one in texts)


@pytest.mark.parametrize(("low", "least"), [(-90.0, -10.0), (-110.0, 0.0)])
def test_no_setup_is_recommended_that_sinks_the_fixture_deeper_than_now(low, least):
    """The platter's face is at -100: a vise down to -90 may go 10 mm lower; one that reaches 10 mm into it
    already, as bolts in its slots, no lower at all. The deviation alone would have both
    lower."""
    vise = solid(((-60, 25, low), (60, 40, -5)))
    trial = setup_of(block(), {"vise.stl": vise})
    z = trial.chart.origin[trial.chart.best, 2]
    assert least - 1.2 <= z <= least + 30.0
    assert ("fixture-in-body" in [one.code for one in trial.findings]) == (low < -100.0)
    bare = setup_of(block(), {})
    assert bare.chart.origin[bare.chart.best, 2] < -15.0


def test_a_fixture_without_bodies_of_the_machine_stays_over_the_table():
    vise = {"vise.stl": solid(((-60, 25, -90.0), (60, 40, -5)))}
    trial = setup_of(block(), vise, machine="trunnion_ac", table_height=-100.0)
    assert trial.chart.origin[trial.chart.best, 2] >= -10.0 - 1e-6
    sunk = setup_of(block(), vise, machine="trunnion_ac", table_height=-80.0)
    assert sunk.chart.origin[sunk.chart.best, 2] >= -1e-6


def test_a_bar_that_swings_into_a_post_is_no_setup_and_mill_agrees():
    """Posts of the trunnion reach up to Z 60 at X 200; the bar turns with A over them."""
    bar = {"bar.stl": solid(((-230, -60, -5), (230, -22, 0)))}
    trial = setup_of(block(), bar, origin=(0.0, 0.0, 80.0), region=(0.0, 0.0, 60.0))
    chart = trial.chart
    assert (chart.hits > 0.0).any()
    x, y, z = chart.origin[chart.best].tolist()

    def hit_at(origin):
        options = {name: value for name, value in GIVEN.items() if name not in ("region", "grid")}
        more = {"machine": "trunnion_with_bodies", "origin": origin, "output": "o.ngc"}
        given = build_settings("mill", "part.stl", options | more)
        draft = job.make(given, mesh=block(), fixtures=tuple(Fixture(name, one) for name, one in bar.items()))
        found = [one for one in job.prove(draft).findings if one.code in HITS]
        return [one.text for one in found]

    assert not hit_at((x, y, z))
    deepest = int(np.nanargmax(chart.hits))
    assert any("bar.stl" in one for one in hit_at(tuple(chart.origin[deepest].tolist())))


def test_the_spindle_is_proven_against_the_platter_and_not_against_a_plane_beyond_it():
    """At A 90 deg the spindle, 65 mm wide, reaches 30 mm below the platter's face far beside the platter:
    `mill` proves it free of the platter, and so does the stick-out."""
    high = solid(((-20, -20, 0), (20, 20, 60)))
    given = {"max_axis_angle": 100.0, "region": (0.0, 1.0, 0.0), "grid": (1.0, 2.0, 1.0), "stepover": 12.0}
    trial = setup_of(high, {}, origin=(0.0, 0.0, -70.0), **given)
    met = trial.chart.stick_out
    assert met is not None and (met.met is None or met.met.entered != "table")


def test_the_task_names_the_findings_as_text_and_page(files):
    given = build_settings("reach", str(files / "inches.stl"), {"machine": "trunnion_ac", "cutter": "ball:6"})
    trial = run(given)
    assert "unit-suspected" in as_text(trial) and "unit-suspected" in as_html(trial)
