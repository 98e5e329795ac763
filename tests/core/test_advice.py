# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would finish more is tried before it is advised: by closed forms on a block, and by a direct run of
what is advised."""

import json

import numpy as np
import pytest
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.pipeline import advice, job
from freecad_fiveaxis.core.pipeline.settings import build_settings

SIZE = np.array([24.0, 16.0, 10.0])
TOP, SIDES = SIZE[0] * SIZE[1], 2.0 * (SIZE[0] + SIZE[1]) * SIZE[2]
GIVEN = {
    "machine": "trunnion_ac",
    "cutter": "ball:6",
    "scallop": 0.5,
    "spindle": "off",
    "gouge": "off",
    "linearize": "off",
}


@pytest.fixture(scope="module")
def block(tmp_path_factory):
    path = tmp_path_factory.mktemp("advice") / "block.stl"
    write_stl(from_triangles(box(-SIZE / 2, SIZE / 2)), path)
    return str(path)


def proven(block, **more):
    return job.run(build_settings("mill", block, {**GIVEN, "rest": "on", **more}))


@pytest.fixture(scope="module")
def planes(block):
    return proven(block, passes="planes")


def run(settings):
    return job.prove(job.make(settings))


@pytest.mark.slow
def test_what_gains_is_what_a_direct_run_of_it_finishes_more(block, planes):
    """Planes along X leave the two sides at the ends of the passes; free axes and constant scallop finish all
    but the underside."""
    trials = advice.try_others(planes, run)
    assert sorted(trials[0].changes) == ["direction", "max_axis_angle", "passes", "plane_normal", "tool_axis"]
    best, before = trials[0], advice.measure_finished(planes)
    assert best.finished == pytest.approx(TOP + SIDES, rel=0.02) and best.gain == pytest.approx(
        best.finished - before
    )
    direct = proven(block)
    assert (
        advice.measure_finished(direct) == pytest.approx(best.finished)
        and direct.draft.settings.passes.passes == "scallop"
    )
    assert float(direct.draft.program.seconds.sum()) == pytest.approx(best.seconds)
    assert [one.gain for one in trials] == sorted((one.gain for one in trials), reverse=True)
    assert any(one.changes.get("cutter", "").startswith("ball:3") for one in trials)
    found = advice.report_advice(trials, 68.0)
    assert found.value == best.gain and "`" not in found.text
    assert (
        "--passes scallop, --tool-axis auto would finish" in found.text and "instead of 0:01:08" in found.text
    )


def test_where_nothing_gains_that_is_stated(planes):
    small = [advice.Trial({"passes": "scallop"}, 1000.0, 5.0), advice.Trial({"cutter": "ball:3"}, 0.0, -20.0)]
    assert (
        advice.report_advice(tuple(small), 10.0).text
        == "Tried, and none finishes more: --passes scallop; --cutter ball:3."
    )
    more = advice.report_advice((advice.Trial({"passes": "scallop"}, 1000.0, 15.0, 61.0),), 10.0)
    assert (
        more.text.startswith("Tried: --passes scallop would finish 15 mm2 more, 1000 mm2 in all")
        and "0:01:01" in more.text
    )


def test_what_cannot_be_built_gains_nothing_and_cancel_ends_it(planes):
    def refuse(settings):
        raise SettingsError("no facet can be cut", None)

    def cancel(settings):
        raise Cancelled("stopped")

    assert {one.error for one in advice.try_others(planes, refuse)} == {"no facet can be cut"}
    with pytest.raises(Cancelled):
        advice.try_others(planes, cancel)


def test_nothing_is_tried_that_is_requested_already():
    whole = build_settings("mill", "x.stl", {**GIVEN, "tool_axis": "auto"})
    assert [list(one) for one in advice.find_changes(whole)] == [["cutter"], ["cutter"]]
    bull = build_settings("mill", "x.stl", {**GIVEN, "cutter": "bull:6:1", "passes": "zlevel"})
    assert [one["passes"] for one in advice.find_changes(bull) if "passes" in one] == ["scallop"]


@pytest.mark.parametrize(
    ("cutter", "ball", "half"),
    [
        ("flat:6", "ball:6.0:50.0", "flat:3.0:50.0"),
        ("bull:6:1", "ball:6.0:50.0", "bull:3.0:0.5:50.0"),
        ("taperbull:6:1:5deg", "taperball:6.0:5deg:50.0", "taperbull:3.0:0.5:5deg:50.0"),
    ],
)
def test_a_level_bottom_is_tried_as_a_ball_of_its_size_and_smaller(cutter, ball, half):
    """Bottoms that lie level leave walls beside them, which a ball with free axes gets at."""
    level = build_settings("mill", "x.stl", {**GIVEN, "cutter": cutter, "passes": "scallop"})
    tried = list(advice.find_changes(level))
    assert tried == [
        {"cutter": ball, "tool_axis": "auto", "max_axis_angle": None},
        {"cutter": half},
    ]
    assert all(advice._apply_changes(level, one) for one in tried)


def test_where_nothing_can_be_tried_a_whole_sentence_says_so():
    barrel = build_settings("mill", "x.stl", {**GIVEN, "cutter": "barrel:10:85:2", "passes": "scallop"})
    assert list(advice.find_changes(barrel)) == []
    read_message = advice.report_advice((), 10.0).text
    assert read_message.startswith("For this cutter") and read_message.endswith("none was tried.")


@pytest.mark.oldest
@pytest.mark.thorough
def test_for_an_upright_flat_cutter_the_ball_that_was_tried_is_named(block):
    """A box under a flat cutter whose axis stays upright keeps its sides."""
    upright = proven(block, cutter="flat:6", passes="scallop", tool_axis="fixed")
    trials = advice.try_others(upright, run)
    assert trials[0].changes["cutter"].startswith("ball:6") and advice.is_worth(trials[0])
    assert trials[0].finished == pytest.approx(TOP + SIDES, rel=0.02)


@pytest.mark.slow
def test_the_command_line_advises_where_something_is_left_and_where_it_is_requested_to(
    block, tmp_path, monkeypatch
):
    def read_message(*more):
        report = tmp_path / "report.json"
        given = [f"--{name}={value}" for name, value in GIVEN.items()]
        assert cli.main(
            ["mill", block, *given, "--quiet", "-o", str(tmp_path / "x.ngc"), "--report", str(report), *more]
        ) in (
            0,
            1,
        )
        return [one for one in json.loads(report.read_text())["findings"] if one["code"] == "advice"]

    monkeypatch.setattr(advice, "SMALLER", ())
    assert read_message("--passes", "planes") == [] == read_message("--advise")
    (found,) = read_message("--passes", "planes", "--advise")
    assert found["severity"] == "note" and found["unit"] == "mm2" and found["value"] > 400.0
