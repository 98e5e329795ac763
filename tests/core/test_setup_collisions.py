# SPDX-License-Identifier: LGPL-2.1-or-later
"""No setup is recommended in which tool or spindle hit the machine."""

import json
from dataclasses import replace

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.machine import load_machine, machine_file
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.studies.setup_map.collisions import MOST_LOOKED_AT, choose_free

PLACES = np.array([(x, 0.0, 0.0) for x in range(10)], float)
GIVEN = (
    "--cutter",
    "ball:6",
    "--holder",
    "40x30",
    "--passes",
    "planes",
    "--tool-axis",
    "facet_mean",
    "--max-axis-angle",
    "10",
    "--stepover",
    "5",
)


def looked_at(depth):
    """choose_free over ten places in a row, the first best, with that depth of a hit (10,) in each; and where
    it looked."""
    seen = []

    def look(turn, origin):
        row = int(origin[0])
        seen.append(row)
        near = report_finding(Code.MACHINE_NEAR, f"near {row}", 1.0)
        return (
            (near, report_finding(Code.MACHINE_COLLISION, "hit", float(depth[row])))
            if depth[row]
            else (near,)
        )

    def choose(able):
        return int(able.argmax()) if able.any() else None

    return choose_free(choose, PLACES, np.zeros(10), np.ones(10, bool), True, look), seen


def test_the_first_that_is_free_is_chosen_and_what_is_nearer_than_a_hit_is_deep_is_not_looked_at():
    choice, seen = looked_at(np.array([2.5, 2.0, 1.0, 0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0]))
    assert seen == [0, 3, 4, 5] and choice.best == 5
    np.testing.assert_array_equal(choice.hits, [2.5, 1.5, 0.5, 0.5, 0.5, 0.0, *[np.nan] * 4])
    assert [one.code for one in choice.findings] == [
        "machine-near",
        "setups-hit-machine",
    ] and choice.findings[1].value == 3.0


def test_where_the_present_one_is_free_and_best_nothing_else_is_looked_at():
    choice, seen = looked_at(np.zeros(10))
    assert seen == [0] and choice.best == 0 and [one.text for one in choice.findings] == ["near 0"]


def test_where_none_is_free_none_is_chosen_and_the_least_hit_is_named():
    choice, seen = looked_at(np.linspace(0.9, 0.1, 10))
    assert choice.best is None and seen == list(range(10)) and (choice.hits > 0.0).all()
    assert [one.code for one in choice.findings] == ["no-setup-free"] and choice.findings[
        0
    ].value == pytest.approx(0.1)


def test_so_many_are_looked_at_and_no_more():
    places = np.arange(100.0)[:, None] * (1.0, 0.0, 0.0)
    count = []
    hit = report_finding(Code.MACHINE_COLLISION, "hit", 0.5)
    choice = choose_free(
        lambda able: int(able.argmax()),
        places,
        np.zeros(100),
        np.ones(100, bool),
        False,
        lambda *_: count.append(1) or (hit,),
    )
    assert choice.best is None and len(count) == MOST_LOOKED_AT


def test_where_no_setup_keeps_the_limits_these_are_why_and_not_what_the_present_one_hits():
    hit = report_finding(Code.MACHINE_COLLISION, "hit", 0.5)
    choice = choose_free(lambda able: None, PLACES, np.zeros(10), np.zeros(10, bool), True, lambda *_: (hit,))
    assert choice.best is None and choice.hits[0] == 0.5 and choice.findings == ()


def test_without_bodies_nobody_looks():
    choice = choose_free(lambda able: 3, PLACES, np.zeros(10), np.ones(10, bool), True, None)
    assert choice.best == 3 and np.isnan(choice.hits).all() and choice.findings == ()


@pytest.fixture
def given(tmp_path):
    """given(body): a part, and a trunnion with such a body on its base."""
    half = np.array([(12, 0, 0), (0, 12, 0), (0, 0, 6)], float)
    corners = (
        np.array([[(x, y, z) for z in (0, 1) for y in (-1, 1) for x in (-1, 1)]], float).reshape(-1, 3) @ half
    )
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    facets = [corners[[a, b, c]] for a, b, c, d in quads] + [corners[[a, c, d]] for a, b, c, d in quads]
    write_stl(from_triangles(np.array(facets)), tmp_path / "part.stl")

    def make(low, high):
        machine = load_machine("trunnion_ac")
        body = MachineBody("post", "base", "box", (low, high))
        machine_file.save_machine(replace(machine, bodies=(body,)), tmp_path / "trunnion_ac.fcm")
        return [str(tmp_path / "part.stl"), *GIVEN, "--machine", str(tmp_path / "trunnion_ac.fcm"), "--quiet"]

    return make


def run_setup(given, tmp_path):
    """The map's record of three work zeros in a row along X, and a search between."""
    words = [
        "setup",
        *given,
        "--origin=0,0,0",
        "--region",
        "80,0,0",
        "--grid",
        "3,1,1",
        "--report",
        str(tmp_path / "map.json"),
    ]
    assert cli.main(words) == 0
    return json.loads((tmp_path / "map.json").read_text())


def mill_at(given, tmp_path, origin):
    """The findings of the whole program with the work zero there: the second route."""
    report = tmp_path / "mill.json"
    place = "--origin=" + ",".join(f"{value:.6f}" for value in origin)
    cli.main(
        ["mill", *given, place, "--spindle", "off", "-o", str(tmp_path / "o.ngc"), "--report", str(report)]
    )
    return [one for one in json.loads(report.read_text())["findings"] if one["code"] == "machine-collision"]


def test_the_recommended_setup_is_free_where_the_present_one_hits_a_post(given, tmp_path):
    words = given((25.0, -60.0, -200.0), (60.0, 60.0, 60.0))
    record = run_setup(words, tmp_path)
    best, now = record["setups"][record["best"]], record["setups"][0]
    assert best["machine_hit"] == 0.0 and now["machine_hit"] > 1.0
    assert mill_at(words, tmp_path, best["origin"]) == []
    hit = mill_at(words, tmp_path, now["origin"])
    assert now["machine_hit"] == pytest.approx(max(one["value"] for one in hit), abs=0.02)
    assert [one["code"] for one in record["findings"] if "hit" in one["text"]] in ([], ["setups-hit-machine"])


def test_far_bodies_change_nothing_but_that_somebody_has_looked(given, tmp_path):
    words = given((900.0, -60.0, -200.0), (960.0, 60.0, 60.0))
    beside = run_setup(words, tmp_path)
    plain = run_setup([word if not word.endswith(".fcm") else "trunnion_ac" for word in words], tmp_path)
    assert beside["best"] == plain["best"] and beside["setups"][beside["best"]]["machine_hit"] == 0.0
    assert all(one["machine_hit"] is None for one in plain["setups"])
    for one, other in zip(beside["setups"], plain["setups"], strict=True):
        assert one | {"machine_hit": None} == other


@pytest.mark.oldest
@pytest.mark.thorough
def test_where_a_longer_tool_is_free_it_is_reported_and_mill_with_it_hits_nothing(given, tmp_path, capsys):
    """The holder of 20 mm radius over the part's top, at 6 mm, goes into a post that is 60 mm high and 25 mm
    beside the part's middle, wherever the part stands; over it a tool of 54 mm is free."""
    words = given((25.0, -60.0, -200.0), (60.0, 60.0, 60.0))[:-1]  # what is told is read
    report = tmp_path / "map.json"
    where = ["--origin=0,0,0", "--region", "3,0,0", "--grid", "3,1,1", "--report", str(report)]
    assert cli.main(["setup", *words, *where]) == 1
    reported = " ".join(capsys.readouterr().out.split())
    record = json.loads(report.read_text())
    codes = [one["code"] for one in record["findings"]]
    assert "no-setup-free" in codes and "stick-out-too-short" in codes
    assert "the machine is hit in every setup that was tried. With one that sticks out 54" in reported
    found, best = record["stick_out"], record["setups"][record["best"]]
    assert found["enough"] == pytest.approx(54.0, abs=0.15) and found["met"]["entered"] == "post"
    assert best["machine_hit"] == pytest.approx(4.0, abs=0.1)
    assert mill_at(words, tmp_path, best["origin"])
    longer = [*words, "--shank", found["options"]["shank"]]
    assert mill_at(longer, tmp_path, best["origin"]) == []
    assert cli.main(["setup", *longer, *where]) == 0


def test_where_the_cutter_hits_the_machine_too_no_longer_tool_is_proposed(given, tmp_path, capsys):
    """The post of above, but 13 mm beside the part's middle: the ball reaches 15 mm, whatever is over it."""
    words = given((13.0, -60.0, -200.0), (60.0, 60.0, 60.0))
    assert cli.main(["setup", *words, "--origin=0,0,0", "--region", "0.5,0,0", "--grid", "3,1,1"]) == 2
    assert "the machine is hit" in capsys.readouterr().err


def test_where_the_machine_is_hit_everywhere_the_map_is_refused_in_one_line(given, tmp_path, capsys):
    words = given((-900.0, -900.0, -100.0), (900.0, 900.0, 40.0))
    code = cli.main(
        [
            "setup",
            *words,
            "--origin=0,0,0",
            "--region",
            "80,0,0",
            "--grid",
            "3,1,1",
            "--report",
            str(tmp_path / "map.json"),
        ]
    )
    message = capsys.readouterr().err
    assert code == 2 and message.count("\n") == 1 and "In all" in message and "post" in message
    assert not (tmp_path / "map.json").exists()
