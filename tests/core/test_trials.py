# SPDX-License-Identifier: LGPL-2.1-or-later
"""`setup` and `compare` as the command line has them: exit codes, files, messages."""

import json
import os
import re

import pytest
from plain import build_settings
from setup_examples import cap, milled

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.geometry.mesh import write_stl
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.studies import study as trials
from freecad_fiveaxis.core.toolpath.apt import write_apt

QUICK = ("--stepover", "12", "--passes", "planes")
SMALL = ("--grid", "2,2,1", "--region", "100,100,0")


@pytest.fixture
def part(tmp_path):
    path = tmp_path / "cap.stl"
    write_stl(cap(rings=8, sectors=24), path)
    return path


@pytest.fixture
def path(tmp_path):
    file = tmp_path / "cap.apt"
    result = milled(stepover=12.0, rings=8)
    file.write_bytes(write_apt(result.path, result.settings.cutter.cutter, "cap"))
    return file


def run(*words):
    return cli.main([str(word) for word in words])


@pytest.mark.thorough
def test_setup_prints_the_origin_that_makes_mill_reach_the_deviation_of_the_map(part, tmp_path, capsys):
    words = ("--machine", "trunnion_ac", *QUICK)
    assert (
        run(
            "setup", part, *words, *SMALL, "--gouge", "off", "--origin", "100,0,-40",
            "--report", tmp_path / "s.json",
        )
        == cli.DONE
    )  # fmt: skip
    option = re.search(r"--origin=\S+", capsys.readouterr().out).group()
    record = json.loads((tmp_path / "s.json").read_text())
    uncured = ("--linearize", "off", "--gouge", "off")  # as the map drives the path
    code = run(
        "mill",
        part,
        *words,
        *uncured,
        option,
        "-o",
        tmp_path / "a.ngc",
        "--report",
        tmp_path / "m.json",
        "--quiet",
    )
    assert code in (cli.DONE, cli.DONE_WITH_ERRORS)
    summary = json.loads((tmp_path / "m.json").read_text())["summary"]
    best = record["setups"][record["best"]]
    assert summary["max_surface_deviation"] == pytest.approx(best["max_deviation"], abs=1e-6)
    assert summary["time_s"] == pytest.approx(best["time_s"], abs=1e-6)
    assert best["max_deviation"] < record["setups"][0]["max_deviation"]


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_turned_setup_says_how_to_turn_the_part(part, capsys):
    run("setup", part, "--machine", "head_b_table_c", "--tool-length", "80", *QUICK, *SMALL, "--turns", "3")
    out = capsys.readouterr().out
    assert "at the turns tried" in out
    assert ("turn the part in CAD" in out) == bool(re.search(r"recommended(\s+\S+){3}\s+[1-9]", out))


@pytest.mark.parametrize("task", ["setup", pytest.param("compare", marks=pytest.mark.slow)])
def test_every_report_is_written_and_its_inputs_are_a_job_file(task, part, tmp_path):
    names = [tmp_path / name for name in ("r.json", "r.html", "r.txt")]
    words = ("--machine", "trunnion_ac", *QUICK, *(SMALL if task == "setup" else ()), "--quiet")
    assert run(task, part, *words, *(word for name in names for word in ("--report", name))) == cli.DONE
    record = json.loads(names[0].read_text())
    assert record["inputs"]["task"] == task and names[1].read_text(encoding="utf-8").startswith(
        "<!DOCTYPE html>"
    )
    again = tmp_path / "again.json"
    (tmp_path / "job.json").write_text(json.dumps(record["inputs"] | {"report": str(again)}))
    assert run("run", tmp_path / "job.json", "--quiet") == cli.DONE
    second = json.loads(again.read_text())
    key = "setups" if task == "setup" else "rows"
    assert second[key] == record[key]
    assert sorted(os.listdir(tmp_path)) == ["again.json", "cap.stl", "job.json", "r.html", "r.json", "r.txt"]


@pytest.mark.parametrize(
    "words",
    [("--machine", "trunnion_ac", "--machine", "trunnion_bc"), ("--machines", "trunnion_ac,trunnion_bc")],
)
def test_machines_are_named_one_by_one_or_with_commas(words, path, capsys):
    assert run("compare", path, *words) == cli.DONE
    out = capsys.readouterr().out
    assert re.findall(r"^(trunnion_..) +none +(off|on)", out, re.M) == [
        (machine, guided) for machine in ("trunnion_ac", "trunnion_bc") for guided in ("off", "on")
    ]


def test_a_cl_file_has_a_best_setup_too(path, tmp_path):
    assert (
        run("setup", path, "--machine", "trunnion_ac", *SMALL, "--quiet", "--report", tmp_path / "s.txt")
        == cli.DONE
    )
    assert "--origin=" in (tmp_path / "s.txt").read_text()


def refused(capsys, tmp_path, *words):
    """Exit 2, one line on stderr, no file written; returns the line."""
    before = sorted(os.listdir(tmp_path))
    assert run(*words, "--report", tmp_path / "r.html") == cli.UNUSABLE
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "Traceback" not in error
    assert sorted(os.listdir(tmp_path)) == before
    return error


@pytest.mark.parametrize(
    ("words", "named"),
    [(("--origin", "3000,0,0"), ("X 2900 to 3100", "limits", "Widen the region")),
     (("--region", "0,0,0"), ("region 0,0,0", "--turns")),
     (("--region=-5,10,10",), ("region -5,10,10", "at least 0")),
     (("--region", "10,10"), ("region", "three numbers")), (("--region", "1e9,0,0"), ("region", "at most 10000 mm")),
     (("--grid", "0,3,3"), ("grid 0,3,3", "at least 1")), (("--grid", "2.5,3,3"), ("grid", "whole number")),
     (("--grid", "200,200,200"), ("8000000 setups", "coarser grid")), (("--turns", "0"), ("turns 0", "at least 1")),
     (("--tolerance", "0"), ("tolerance 0", "at least 0.000001 mm"))],
)  # fmt: skip
def test_a_setup_that_cannot_be_is_refused_with_value_and_remedy(words, named, part, tmp_path, capsys):
    error = refused(
        capsys, tmp_path, "setup", part, "--machine", "trunnion_ac", *QUICK, "--grid", "2,1,1", *words
    )
    for word in named:
        assert word in error


@pytest.mark.parametrize(
    ("words", "named"),
    [(("--machines", "trunnion_ac,no_such"), "no_such"), (("--machines", "trunnion_ac,"), "machines ''"), ((), "--machines A,B"),
     (("--machines", "trunnion_ac,fork_head_bc"), "fork_head_bc has a rotary head: give --tool-length"),
     (("--machines", "trunnion_ac", "--cures", "none,magic"), "unknown correction 'magic'"),
     (("--machines", "trunnion_ac,gone.fcm"), "gone.fcm")],
)  # fmt: skip
def test_a_comparison_that_cannot_be_is_refused_and_named(words, named, path, tmp_path, capsys):
    assert named in refused(capsys, tmp_path, "compare", path, *words)


def test_the_source_is_not_overwritten_and_an_unknown_report_is_refused(part, tmp_path, capsys):
    assert "is the file that is read" in refused(
        capsys, tmp_path, "setup", part, "--machine", "trunnion_ac", "--report", part
    )
    assert ".pdf" in refused(
        capsys, tmp_path, "compare", part, "--machines", "trunnion_ac", "--report", tmp_path / "a.pdf"
    )
    assert "gone.stl" in refused(capsys, tmp_path, "setup", tmp_path / "gone.stl", "--machine", "trunnion_ac")


def test_machine_files_of_a_job_file_are_beside_it(path, tmp_path, monkeypatch):
    from freecad_fiveaxis.core.machine import load_machine, save_machine

    save_machine(load_machine("trunnion_ac"), tmp_path / "own.fcm")
    (tmp_path / "sub").mkdir()
    monkeypatch.chdir(tmp_path / "sub")
    for machines in (["own.fcm", "trunnion_bc"], "own.fcm,trunnion_bc"):
        (tmp_path / "job.json").write_text(
            json.dumps({"task": "compare", "source": "cap.apt", "machines": machines, "report": "r.json"})
        )
        assert run("run", "../job.json", "--quiet") == cli.DONE
        assert len(json.loads((tmp_path / "r.json").read_text())["rows"]) == 4 * len(trials.check_cures())


def test_a_cancelled_trial_writes_nothing(part, tmp_path, monkeypatch):
    def stop(settings, progress, executor):
        raise Cancelled("by the user")

    monkeypatch.setattr(trials, "run", stop)
    assert run("setup", part, "--machine", "trunnion_ac", "--report", tmp_path / "r.html") == cli.STOPPED
    assert os.listdir(tmp_path) == ["cap.stl"]


@pytest.mark.parametrize(
    ("rows", "turns", "half", "count"),
    [(1000, 1, (100.0, 100.0, 100.0), (7, 7, 3)), (17_000, 1, (100.0, 100.0, 100.0), (7, 7, 3)), (93_000, 1, (100.0, 100.0, 100.0), (5, 5, 3)),
     (93_000, 1, (100.0, 100.0, 0.0), (7, 7, 1)), (17_000, 4, (100.0, 100.0, 100.0), (5, 5, 3)), (10**7, 1, (1.0, 1.0, 1.0), (3, 3, 3))],
)  # fmt: skip
def test_a_long_path_gets_a_coarser_map(rows, turns, half, count):
    settings = build_settings("setup", "x.stl", {"machine": "trunnion_ac", "region": half, "turns": turns})
    region = trials._region(settings, (1.0, 2.0, 3.0), rows, 0.0)
    assert region.count == count and len(region.turns) == turns
    assert region.low == tuple(centre - way for centre, way in zip((1.0, 2.0, 3.0), half, strict=True))


@pytest.mark.parametrize(
    ("table", "given", "moves"), [(None, {}, 0.0), (0.0, {}, 100.0), (None, {"region": (100, 100, 99)}, 99.0)]
)
def test_z_stays_where_nobody_says_how_high_the_table_is(table, given, moves):
    settings = build_settings("setup", "x.stl", {"machine": "trunnion_ac"} | given)
    region = trials._region(settings, (1.0, 2.0, 3.0), 1000, table)
    assert (region.low[2], region.high[2]) == (3.0 - moves, 3.0 + moves) and region.high[0] == 101.0


def test_the_height_of_the_table_is_the_machine_s_unless_given():
    assert (
        build_settings(
            "setup", "x.stl", {"machine": "trunnion_ac", "table_height": "-2in"}
        ).setup.table_height
        == -50.8
    )
    assert build_settings("setup", "x.stl", {"machine": "trunnion_ac"}).setup.table_height is None
    assert load_machine("trunnion_ac").table == -100.0
