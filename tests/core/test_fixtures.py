# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool against fixtures: by closed forms and dense samples of a clamp beside the top of a plate; the path
laid around it; the command line."""

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.fixtures import Fixture, box_with, check_fixtures, join_obstacles
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import tip_to_driven, tool_body
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.report.scope import scope
from freecad_fiveaxis.core.report.verdict import verdict

LOW, HIGH = (10.0, -8.0, 0.0), (20.0, -1.0, 25.0)
"""A clamp 1 mm beside a plate of 30 x 20 x 10 mm, 15 mm higher than its top."""
OPTIONS = {
    "machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 2.0, "passes": "planes", "max_axis_angle": 30,
}  # fmt: skip


def clamp(low=LOW, high=HIGH):
    return from_triangles(box(low, high))


@pytest.fixture
def files(tmp_path):
    write_stl(from_triangles(box((0, 0, 0), (30, 20, 10))), tmp_path / "plate.stl")
    write_stl(clamp(), tmp_path / "clamp.stl")
    write_stl(clamp((10, 25, 0), (20, 32, 25)), tmp_path / "far.stl")
    write_stl(clamp((10, 25, 0), (20, 32, 80)), tmp_path / "tall.stl")
    return tmp_path


def proved(files, *fixtures, **options):
    given = {**OPTIONS, **options, "fixture": [str(files / name) for name in fixtures]}
    return job.run(build_settings("mill", str(files / "plate.stl"), given))


def hits(result):
    return [one for one in result.findings if one.code == "fixture-collision"]


def sampled_depth(outcome, low, high, many=200):
    """By dense samples of the real way, mm: how deep the ball of 6 is in the box, whose faces it meets from
    outside."""
    q, u = words_to_q(outcome.program.words), np.linspace(0.0, 1.0, many)[:, None, None]
    q = (q[:-1] * (1.0 - u) + q[1:] * u).reshape(-1, 5)
    tip, axis = forward(outcome.kinematics, q)
    centre = tip + 3.0 * axis
    out = np.maximum(np.maximum(low - centre, centre - high), 0.0)
    return float((3.0 - np.linalg.norm(out, axis=1)).max())


def test_a_clamp_in_the_way_is_hit_as_deep_as_dense_samples_say(files):
    result = proved(files, "clamp.stl", gouge="report")
    (one,) = hits(result)
    deepest = sampled_depth(result.draft, np.array(LOW), np.array(HIGH))
    assert deepest == pytest.approx(1.0, abs=1e-6)  # the first pass is 1 mm inside the plate's edge: 3 - 2
    assert one.value == pytest.approx(deepest, abs=0.02)
    assert "into the fixture clamp.stl" in str(one.text) and one.line is not None
    assert LOW[1] <= one.place[1] <= HIGH[1]
    assert verdict(job.figures(result), summary(job.figures(result))).light.name == "RED"


def in_part(result):
    return [one for one in result.findings if one.code == "fixture-in-part"]


def write_side_jaw(files, deep):
    """A jaw at the plate's front side, lower than its top, that stands so deep in it, mm."""
    write_stl(clamp((5, -20, 0), (25, deep, 6)), files / "jaw.stl")
    return "jaw.stl"


@pytest.mark.parametrize("deep", [0.0, 0.9])
def test_a_jaw_that_touches_or_is_pressed_into_the_part_changes_nothing(files, deep):
    assert not in_part(proved(files, write_side_jaw(files, deep), gouge="report"))


def test_a_fixture_in_the_part_is_reported_before_anything_else(files):
    """The program that never touches the jaw was called safe but for warnings."""
    result = proved(files, write_side_jaw(files, 5.0), gouge="report")
    first, figures = result.findings[0], job.figures(result)
    assert [first] == in_part(result) and first.severity.name == "ERROR"
    assert "The fixture jaw.stl stands in the part, more than 1 mm deep at" in first.text
    x, y, z = first.place
    assert 5 <= x <= 25 and 0 < y <= 5 and 0 <= z <= 6
    sentence = verdict(figures, summary(figures))
    assert sentence.light.name == "RED" and "NOT SAFE: a fixture stands in the part" in str(sentence.text)


@pytest.mark.parametrize("against", [True, False])
def test_an_audit_tells_it_where_it_knows_the_part(files, against, capsys):
    jaw = str(files / write_side_jaw(files, 5.0))
    nc = files / "a.ngc"
    nc.write_text("G21 G90 G94\nG1 X15 Y10 Z60 A0 C0 F100\nG1 X16\nM2\n")
    words = ["audit", str(nc), "--machine", "trunnion_ac", "--cutter", "ball:6", "--fixture", jaw]
    main(words + ["--against", str(files / "plate.stl")] * against)
    assert ("The fixture jaw.stl stands in the part" in " ".join(capsys.readouterr().out.split())) == against


def test_setup_refuses_it_as_reach_and_compare_do(files, capsys):
    jaw = str(files / write_side_jaw(files, 5.0))
    plate = str(files / "plate.stl")
    assert main(["setup", plate, "--machine", "trunnion_ac", "--fixture", jaw, "--region", "1,1,0"]) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert line.startswith("fiveaxis: --fixture: jaw.stl stands in the part, more than 1 mm deep at")


def test_moved_away_by_as_much_it_is_free_and_a_tenth_nearer_it_is_not(files):
    outcome = proved(files, gouge="report").draft
    (depth,) = [one.value for one in hits(proved(files, "clamp.stl", gouge="report"))]

    def found(away):
        fixture = Fixture("clamp", clamp(np.subtract(LOW, (0, away, 0)), np.subtract(HIGH, (0, away, 0))))
        return check_fixtures(
            (fixture,),
            tool_body(outcome.settings),
            outcome.kinematics,
            outcome.program,
            0.01,
            tip_to_driven(outcome.settings),
        )

    assert not found(depth + 0.01)
    (one,) = found(depth - 0.1)
    assert one.value == pytest.approx(0.1, abs=0.02)


@pytest.mark.parametrize(
    "axes", [{}, {"passes": "scallop", "stepover": None, "scallop": 0.2, "tool_axis": "auto"}]
)
def test_a_path_goes_around_the_fixture_and_still_cuts_what_is_free(files, axes):
    bare, result = proved(files, **axes), proved(files, "clamp.stl", **axes)
    assert hits_of(bare, files)
    assert not hits(result)
    assert sampled_depth(result.draft, np.array(LOW), np.array(HIGH), 50) < 0.011
    assert summary(job.figures(result))["cut_length"] > 0.7 * summary(job.figures(bare))["cut_length"]
    tip, _ = forward(result.draft.kinematics, words_to_q(result.draft.program.words))
    assert tip[:, 2].max() >= 30.0  # 5 mm above the clamp, where the plate alone asks for 15


def hits_of(result, files):
    outcome = result.draft
    fixture = Fixture("clamp", clamp())
    return check_fixtures(
        (fixture,),
        tool_body(outcome.settings),
        outcome.kinematics,
        outcome.program,
        0.01,
        tip_to_driven(outcome.settings),
    )


def test_what_is_proven_of_fixtures_is_stated_and_only_then(files):
    def read_message(result):
        sheets = job.figures(result)
        reported = scope(sheets, summary(sheets))
        return " | ".join(map(str, reported.proven)), " | ".join(map(str, reported.unknown))

    free, hit, none = proved(files, "far.stl"), proved(files, "clamp.stl", gouge="report"), proved(files)
    assert (
        "out of the fixtures: far.stl" in read_message(free)[0] and "other fixtures" in read_message(free)[1]
    )
    assert "fixtures" not in read_message(hit)[0] and "out of the part" in read_message(hit)[0]
    assert "fixtures" not in read_message(none)[0] and "other fixtures" not in read_message(none)[1]


def test_a_holder_that_hits_is_named_where_the_cutter_is_free(files):
    assert not hits(proved(files, "tall.stl", gouge="report", shank="6x6"))
    (one,) = hits(proved(files, "tall.stl", gouge="report", shank="6x6", holder="40x30"))
    assert "holder" in str(one.text)


def test_a_cutter_wholly_inside_a_fixture_touches_no_facet_and_is_found(files):
    outcome = proved(files, gouge="report").draft
    whole = Fixture("stock", clamp((-500, -500, -500), (500, 500, 500)))
    (one,) = check_fixtures((whole,), tool_body(outcome.settings), outcome.kinematics, outcome.program, 0.01)
    assert "whole cutter is inside the fixture stock" in str(one.text)
    assert one.value == len(outcome.program.words) - 1


def test_part_and_fixtures_are_joined_without_being_welded():
    part, touching = from_triangles(box((0, 0, 0), (30, 20, 10))), clamp((0, -7, 0), (30, 0, 10))
    joined = join_obstacles(part, (Fixture("jaw", touching),))
    assert join_obstacles(part, ()) is part
    assert (
        len(joined.face) == 24 and (joined.face[:12] == part.face).all() and (joined.coedge_face >= 0).all()
    )
    np.testing.assert_array_equal(joined.vertex[joined.face[12:]], touching.vertex[touching.face])
    ends = np.sort(joined.coedge_vertex[joined.face_coedge], axis=2)
    sides = np.sort(np.stack([joined.face, np.roll(joined.face, -1, axis=1)], axis=2), axis=2)
    np.testing.assert_array_equal(ends, sides)
    low, high = box_with(part.box, (Fixture("jaw", touching),))
    assert low.tolist() == [0, -7, 0] and high.tolist() == [30, 20, 10]


def test_audit_and_post_look_at_fixtures_too(files, capsys):
    nc, cl = files / "plate.ngc", files / "plate.apt"
    outcome = ["--machine", "trunnion_ac", "--tool-length", "120", "--cutter", "ball:6"]
    path = ["--stepover", "2", "--passes", "planes", "--max-axis-angle", "30", "--spindle", "9000"]
    assert main(["mill", str(files / "plate.stl"), *outcome, *path, "-o", str(nc), "--cl", str(cl)]) == 0
    capsys.readouterr()
    for task, source in (("audit", nc), ("post", cl)):
        written = ["-o", str(files / "again.ngc")] if task == "post" else []
        assert main([task, str(source), *outcome, "--fixture", str(files / "far.stl"), *written]) == 0
        assert "hits a fixture" not in capsys.readouterr().out
        assert main([task, str(source), *outcome, "--fixture", str(files / "clamp.stl"), *written]) == 1
        assert "the tool hits a fixture at 1 place" in capsys.readouterr().out


def test_an_audit_looks_at_the_holder_beside_fixtures_without_a_part(files, capsys):
    given = ["--machine", "trunnion_ac", "--tool-length", "120", "--cutter", "ball:6"]
    path = [
        "--stepover",
        "2",
        "--passes",
        "planes",
        "--max-axis-angle",
        "30",
        "--spindle",
        "9000",
        "-o",
        str(files / "a.ngc"),
    ]
    assert main(["mill", str(files / "plate.stl"), *given, *path]) == 0
    audit = ["audit", str(files / "a.ngc"), *given, "--fixture", str(files / "tall.stl"), "--shank", "6x6"]
    assert main(audit) == 0
    assert main([*audit, "--holder", "40x30"]) == 1
    assert "The holder goes at least" in capsys.readouterr().out
    assert main(["audit", str(files / "a.ngc"), *given, "--holder", "40x30"]) == 2
    assert "--fixture" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "read_message"), [("none.stl", "none.stl"), ("plate.txt", "plate.txt")])
def test_a_file_that_is_no_fixture_is_one_line_with_exit_code_2_and_nothing_is_written(
    files, capsys, name, read_message
):
    (files / "plate.txt").write_text("a vise\n")
    out = files / "never.ngc"
    given = [
        "mill",
        str(files / "plate.stl"),
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "--fixture",
        str(files / name),
    ]
    assert main([*given, "-o", str(out)]) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 1 and read_message in lines[0] and not out.exists()


def nearest(outcome, low, high):
    """By dense samples, mm: how near the ball of 6 comes to the box; 0 in it."""
    return max(-sampled_depth(outcome, np.array(low), np.array(high)), 0.0)


def test_what_comes_nearer_than_the_clearance_is_reported_as_near_as_dense_samples_say(files):
    low, high = np.subtract(LOW, (0, 4, 0)), np.subtract(HIGH, (0, 4, 0))
    write_stl(clamp(low, high), files / "aside.stl")
    result = proved(files, "aside.stl", gouge="report", fixture_clearance=5.0)
    away = nearest(result.draft, low, high)
    assert away == pytest.approx(3.0, abs=1e-6)  # 1 mm in it, moved by 4
    (one,) = [one for one in result.findings if one.code == "fixture-near"]
    assert one.severity.name == "WARNING" and not hits(result)
    assert (
        one.value == pytest.approx(away, abs=0.02)
        and "nearer than" in str(one.text)
        and "5 mm are asked for" in str(one.text)
    )
    assert low[1] <= one.place[1] <= high[1] + 1e-9


def test_what_keeps_the_clearance_is_reported_in_the_scope(files):
    low, high = np.subtract(LOW, (0, 4, 0)), np.subtract(HIGH, (0, 4, 0))
    write_stl(clamp(low, high), files / "aside.stl")
    for clearance, kept in ((2.97, True), (3.03, False)):
        result = proved(files, "aside.stl", gouge="report", fixture_clearance=clearance)
        figures = job.figures(result)
        reported = " ".join(map(str, scope(figures, summary(figures)).proven))
        assert ("away from fixtures" in reported) == kept, clearance
        assert [one.code for one in result.findings if one.code == "fixture-near"] == (
            [] if kept else ["fixture-near"]
        )


def test_a_collision_is_reported_once_and_no_clearance_with_it(files):
    result = proved(files, "clamp.stl", gouge="report", fixture_clearance=5.0)
    assert len(hits(result)) == 1 and not [one for one in result.findings if one.code == "fixture-near"]
