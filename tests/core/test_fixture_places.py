# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures with a place behind their file: a box that is placed is the box that was moved by hand."""

import json

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.fixture_places import parse_fixture
from freecad_fiveaxis.core.gouge.fixtures import read_fixtures
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.job_file import read_job
from freecad_fiveaxis.core.pipeline.outputs import files_read
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.report.scope import scope

LOW, HIGH = (10.0, -8.0, 0.0), (20.0, -1.0, 25.0)
"""A clamp 1 mm beside a plate of 30 x 20 x 10 mm, 15 mm higher than its top."""
TOOL = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6"}
PATH = {"stepover": 2.0, "passes": "planes", "max_axis_angle": 30, "gouge": "report"}
FLAGS = ["--machine", "trunnion_ac", "--tool-length", "120", "--cutter", "ball:6"]
PASSES = ["--stepover", "6", "--passes", "planes", "--max-axis-angle", "30", "--spindle", "9000"]


@pytest.fixture
def files(tmp_path):
    write_stl(from_triangles(box((0, 0, 0), (30, 20, 10))), tmp_path / "plate.stl")
    write_stl(from_triangles(box(LOW, HIGH)), tmp_path / "clamp.stl")
    write_stl(from_triangles(box((0, 0, 0), np.subtract(HIGH, LOW))), tmp_path / "own.stl")
    write_stl(from_triangles(box((0, 0, 0), (7, 25, 10))), tmp_path / "lying.stl")
    return tmp_path


def hits(files, fixture, **options):
    given = {**TOOL, **PATH, **options, "fixture": [str(files / fixture)]}
    result = job.run(build_settings("mill", str(files / "plate.stl"), given))
    return result, [
        (one.code, one.value, one.block, one.line, one.place)
        for one in result.findings
        if one.code.startswith("fixture")
    ]


def test_a_placed_box_gives_the_findings_of_the_box_moved_by_hand(files):
    _, by_hand = hits(files, "clamp.stl", fixture_clearance=2.0)
    result, placed = hits(files, "own.stl@10,-8,0", fixture_clearance=2.0)
    assert placed == by_hand != []
    (text,) = [str(one.text) for one in result.findings if one.code == "fixture-collision"]
    assert "into the fixture own.stl@10,-8,0 at" in text
    assert hits(files, "own.stl@10,-18,0")[1] == hits(files, "own.stl")[1][:0] == []


def test_a_turned_box_gives_the_findings_of_the_box_moved_by_hand(files):
    """The box lies along Y: about X it is stood up (y becomes z, z becomes -y), then about Z (x becomes y, y
    becomes -x): from (x, y, z) to (z, x, y) in all."""
    _, by_hand = hits(files, "clamp.stl")
    _, placed = hits(files, "lying.stl@10,-8,0,90,0,90")
    assert [one[:4] for one in placed] == [one[:4] for one in by_hand] != []
    # which height of the upright edge is named is a matter of rounding: all are as deep
    assert placed[0][4][:2] == pytest.approx(by_hand[0][4][:2], abs=1e-9)
    assert hits(files, "lying.stl@10,-8,0,0,90,90")[1] != placed


def test_turns_go_about_x_then_y_then_z_of_the_work_frame(files):
    """Against turns by complex numbers, one axis after the other."""
    write_stl(from_triangles(box((1, 2, 3), (5, 9, 11))), files / "one.stl")
    (plain,) = read_fixtures((str(files / "one.stl"),))
    (placed,) = read_fixtures((str(files / "one.stl@100,0.5in,-3,10,-20,30deg"),))
    x, y, z = plain.mesh.vertex.T.copy()
    for angle, plane in ((10, (1, 2)), (-20, (2, 0)), (30, (0, 1))):
        point = [x, y, z]
        turned = (point[plane[0]] + 1j * point[plane[1]]) * np.exp(1j * np.radians(angle))
        point[plane[0]], point[plane[1]] = turned.real, turned.imag
        x, y, z = point
    np.testing.assert_allclose(placed.mesh.vertex, np.stack([x + 100, y + 12.7, z - 3], axis=1), atol=1e-12)
    outward = placed.mesh.vertex[placed.mesh.face].mean(axis=1) - placed.mesh.vertex.mean(axis=0)
    assert (np.einsum("ij,ij->i", outward, placed.mesh.normal) > 0.0).all()


@pytest.mark.parametrize("name", ["vise@2.stl", "@home.STL", "vise.stl@1,2,3", "shop@2/vise.stl"])
def test_a_name_that_holds_the_mark_is_a_name_and_can_have_a_place_too(files, monkeypatch, name):
    monkeypatch.chdir(files)
    (files / name).parent.mkdir(exist_ok=True)
    write_stl(from_triangles(box((0, 0, 0), (1, 2, 3))), files / name)
    assert parse_fixture(name).path == name and parse_fixture(name).place == ""
    (placed,) = read_fixtures((f"{name}@0, 5 ,0",))
    assert placed.name == f"{name.rpartition('/')[2]}@0,5,0"
    assert placed.mesh.box[1].tolist() == [1.0, 7.0, 3.0]


@pytest.mark.parametrize(
    "place",
    ["", "1,2", "1,2,3,4", "1,2,3,4,5,6,7", "1,2,three", "1,2,nan", "1,2,3deg", "1,2,3,0,0,9mm", "home"],
)
def test_what_says_no_place_is_one_line_with_the_remedy_and_nothing_is_written(files, capsys, place):
    out, given = files / "never.ngc", f"{files / 'own.stl'}@{place}"
    assert main(["mill", str(files / "plate.stl"), *FLAGS, "--fixture", given, "-o", str(out)]) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 1 and not out.exists()
    assert f"'{place}' is no place; write X,Y,Z in mm behind the @" in lines[0]


@pytest.mark.parametrize("place", ["1e9,0,0", "0,0,0,0,0,361", "0,-100001,0"])
def test_a_place_out_of_range_is_refused_with_the_range(files, place):
    with pytest.raises(SettingsError, match="at most 100000 mm and angles of at most 360 degrees"):
        parse_fixture(f"own.stl@{place}")
    assert parse_fixture("own.stl@0,-100000,0,0,0,-360").turns[2] == pytest.approx(-2.0 * np.pi)


def test_a_file_that_is_not_there_is_named_without_its_place(files, capsys):
    given = ["--fixture", f"{files}/none.stl@1,2,3", "-o", str(files / "never.ngc")]
    assert main(["mill", str(files / "plate.stl"), *FLAGS, *given]) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert "none.stl" in line and "@" not in line


def test_a_job_file_has_places_relative_to_it_and_its_report_is_a_job_file_again(files, capsys):
    given = TOOL | PATH | {"task": "mill", "source": "plate.stl", "fixture": ["own.stl@10,-8,0"]}
    (files / "job.json").write_text(json.dumps(given))
    settings = read_job(str(files / "job.json"))
    assert settings.gouge.fixture == (f"{files}/own.stl@10,-8,0",)
    assert f"{files}/own.stl" in files_read(settings)
    result = job.run(settings)
    figures = job.figures(result)
    reported = " ".join(
        map(str, (*scope(figures, summary(figures)).proven, *(one.text for one in result.findings)))
    )
    assert "own.stl@10,-8,0" in reported
    (files / "again.json").write_text(json.dumps(figures.inputs))
    again = job.run(read_job(str(files / "again.json")))
    assert again.findings == result.findings and again.draft.nc == result.draft.nc


def test_post_audit_and_setup_take_places_and_reports_name_them(files, capsys):
    nc, cl = files / "plate.ngc", files / "plate.apt"
    assert main(["mill", str(files / "plate.stl"), *FLAGS, *PASSES, "-o", str(nc), "--cl", str(cl)]) == 0
    capsys.readouterr()
    for task, source, place, code, ends in (
        ("audit", nc, "10,-8,0", 1, ("json", "html")), ("audit", nc, "10,-58,0", 0, ("json",)), ("post", cl, "10,-8,0", 1, ("json",)),
    ):  # fmt: skip
        written = ["-o", str(files / "again.ngc")] if task == "post" else []
        report = [one for end in ends for one in ("--report", str(files / f"r.{end}"))]
        fixture = ["--fixture", f"{files / 'own.stl'}@{place}"]
        assert main([task, str(source), *FLAGS, *fixture, *written, *report]) == code
        reported = *((files / f"r.{end}").read_text() for end in ends), capsys.readouterr().out
        assert all(f"own.stl@{place}" in one for one in reported)
    grid = ["--grid", "1,1,1", "--turns", "1", "--gouge", "off", "--fixture", f"{files / 'own.stl'}@10,-8,0"]
    assert main(["setup", str(files / "plate.stl"), *FLAGS, *PASSES[:-2], *grid]) in (0, 1)
    assert "own.stl@10,-8,0" in capsys.readouterr().out


def test_a_report_over_the_file_of_a_placed_fixture_is_refused(files, capsys):
    before = (files / "own.stl").read_bytes()
    given = ["--fixture", f"{files / 'own.stl'}@10,-8,0", "-o", str(files / "own.stl")]
    assert main(["mill", str(files / "plate.stl"), *FLAGS, *given]) == 2
    assert "is the file that is read" in capsys.readouterr().err
    assert (files / "own.stl").read_bytes() == before
