# SPDX-License-Identifier: LGPL-2.1-or-later
"""Audit and markers: the numbers and the places are the core's."""

import Mesh
import numpy as np
import Part
import pytest
from conftest import PLAIN, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, markers, results
from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError, MachineError, SettingsError
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import markers as core_markers

TABLE_2 = "G90 G93\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F60\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\nM2\n"
"""So et al., Table 2: one block near the pole of a Mikron UCP 710."""


@pytest.fixture
def table2(tmp_path):
    file = tmp_path / "table2.ngc"
    file.write_text(TABLE_2)
    return file


def test_table_2_of_so_is_judged(doc, table2):
    result = app.audit(doc, table2, "mikron_ucp710")
    assert result.MaxSegmentDeviation.Value == pytest.approx(2.1264, abs=5e-4)
    assert result.MaxLineDeviation.Value == pytest.approx(0.9384, abs=3e-4)
    assert (result.WorstLine, result.SingularBlocks, result.OverTolerance, result.Proven) == (3, 1, 1, False)
    assert (
        result.State == ["Up-to-date"]
        and results.out_of_date(result) == ""
        and results.nc_of(result) == TABLE_2.encode()
    )
    assert any("2.1264 mm" in text for text in result.Findings)
    assert (result.MaxSurfaceDeviation, result.MaxSurfaceBound) == (
        result.MaxSegmentDeviation,
        result.MaxBound,
    ), "judged by the tip"
    assert not any("centre of the ball" in text for text in result.Findings), (
        "nobody has said that a ball cuts"
    )


def test_of_a_ball_that_is_given_the_centre_is_judged_and_the_tip_stands_beside_it(doc, table2):
    result = app.audit(doc, table2, "mikron_ucp710", cutter="ball:6")
    assert result.MaxSegmentDeviation.Value == pytest.approx(2.1264, abs=5e-4)
    centre = results.figures_of(result).surface.segment
    assert (
        result.MaxSurfaceDeviation.Value == pytest.approx(centre.max(), abs=1e-9)
        and abs(centre.max() - 2.1264) > 0.01
    )


def test_the_marker_stands_at_the_largest_deviation_in_the_document(doc, table2):
    result = app.audit(doc, table2, "mikron_ucp710", work_zero=(100, 0, -5))
    marks = app.annotate(result)
    figures = results.figures_of(result)
    place = figures.deviation.place[figures.worst[0]]
    assert marks.Kinds[0] == "largest-deviation" and marks.Labels[0] == "2.126 mm, line 3"
    np.testing.assert_allclose(tuple(marks.Places[0]), place + (100, 0, -5), atol=1e-9)


def test_a_part_to_compare_with_is_looked_at_by_the_whole_tool_unless_it_is_turned_off(doc, tmp_path):
    program, part = tmp_path / "p.ngc", tmp_path / "box.stl"
    program.write_text("G21 G90 G94\nG0 X-9 Y-9 Z60 A0 C0\nG0 X5 Y5 Z9\nG1 X5 Y5 Z60 F600\nM2\n")
    low, high = np.zeros(3), np.array([10.0, 10.0, 10.0])
    mesh = Part.makeBox(*(high - low)).tessellate(0.1)
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n"
        + "".join(f"vertex {x} {y} {z}\n" for x, y, z in (mesh[0][i] for i in face))
        + "endloop\nendfacet\n"
        for face in mesh[1]
    )
    part.write_text(f"solid box\n{facets}endsolid box\n")
    for given, seen in (({}, True), ({"gouge": "off"}, False)):
        result = app.audit(
            doc, program, "trunnion_ac", cutter="ball:2:4", holder="8x20", against=str(part), **given
        )
        assert any(one.code == "rapid-collision" for one in results.figures_of(result).findings) is seen
    assert app.audit(doc, program, "trunnion_ac", holder="8x20").State == [
        "Up-to-date"
    ]  # drawn, and nothing to check it with


INTO_THE_BALL = "G21 G90 G94\nG0 X0 Y0 Z60 A0 C0\nG1 X0 Y0 Z9 F600\nG1 X5 Y0 Z9\nG1 X5 Y0 Z60\nM2\n"
"""Cuts 11 mm deep into a half ball of 20 mm, about its centre on the ground."""


def test_a_solid_of_the_document_is_compared_with_as_its_stl_is(doc, ball, tmp_path, reopen):
    program = tmp_path / "p.ngc"
    program.write_text(INTO_THE_BALL)
    app.tessellate(ball, tmp_path / "ball.stl")
    given = {"cutter": "ball:4:30", "holder": "8x20"}
    by_file = app.audit(doc, program, "trunnion_ac", against=str(tmp_path / "ball.stl"), **given)
    result = app.audit(doc, program, "trunnion_ac", part=ball, **given)
    assert result.Findings == by_file.Findings and any(
        "too deep into the part" in text for text in result.Findings
    )
    assert results.figures_of(result).inputs["against"] == "Ball.stl" and results.out_of_date(result) == ""
    without = app.audit(doc, program, "trunnion_ac", **given)
    assert not any("too deep" in text for text in without.Findings)
    mesh = doc.addObject("Mesh::Feature", "Facets")
    mesh.Mesh = Mesh.Mesh(str(tmp_path / "ball.stl"))
    assert app.audit(doc, program, "trunnion_ac", part=mesh, **given).Findings == by_file.Findings
    again = reopen(doc).Audit001
    assert again.Part.Name == "Ball" and results.out_of_date(again) == ""
    assert results.figures_of(again).audit is not None, "computed anew, and the solid meshed for that"


def test_a_part_that_changes_puts_the_audit_out_of_date_and_a_recompute_looks_again(doc, tmp_path):
    program = tmp_path / "p.ngc"
    program.write_text(INTO_THE_BALL)
    ball = doc.addObject("Part::Sphere", "Sphere")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    result = app.audit(doc, program, "trunnion_ac", part=ball, cutter="ball:4:30")
    deep = [text for text in result.Findings if "too deep into the part" in text]
    before = result.Fingerprint
    doc.recompute()
    assert result.Fingerprint == before and deep
    ball.Radius = 8
    assert "was changed: recompute the document" in results.out_of_date(result)
    doc.recompute()
    assert result.Fingerprint != before and results.out_of_date(result) == ""
    assert not [text for text in result.Findings if "too deep into the part" in text]
    ball.Placement.Base.z = 6  # moved, and its shape the same
    doc.recompute()
    assert [text for text in result.Findings if "too deep into the part" in text] not in ([], deep)
    result.WorkZero = (0, 0, 12)
    doc.recompute()
    assert not [text for text in result.Findings if "too deep into the part" in text]


def test_a_part_that_is_deleted_is_missed_and_the_audit_does_not_pass_without_it(doc, ball, tmp_path):
    program = tmp_path / "p.ngc"
    program.write_text(INTO_THE_BALL)
    result = app.audit(doc, program, "trunnion_ac", part=ball, cutter="ball:4:30")
    doc.removeObject("Ball")
    assert "Ball, which Audit is compared with, was deleted" in results.out_of_date(result)
    doc.recompute()
    assert "Invalid" in result.State and result.Blocks == 0 and "was deleted" in result.Findings[0]
    changes.change_audit(result, str(program), {"machine": "trunnion_ac", "part": None})
    assert result.State == ["Up-to-date"] and result.Blocks > 0 and results.out_of_date(result) == ""


def test_what_is_no_part_of_the_document_is_refused_and_nothing_is_left(doc, table2):
    sketch = doc.addObject("Part::Plane", "Plane")
    doc.recompute()
    for part in (sketch, "Plane"):
        with pytest.raises(FiveAxisError, match="select a"):
            app.audit(doc, table2, "mikron_ucp710", part=part)
    assert doc.Objects == [sketch]


def test_the_file_that_vanished_or_changed_is_reported(doc, table2, reopen):
    result = app.audit(doc, table2, "mikron_ucp710")
    table2.write_text(TABLE_2.replace("34.8175", "34.8176"))
    assert "recompute the document" in results.out_of_date(result)
    again = reopen(doc).Audit
    again.touch()
    again.Document.recompute()
    assert results.out_of_date(again) == "" and again.Blocks == 2
    table2.unlink()
    again.touch()
    again.Document.recompute()
    assert (
        "Invalid" in again.State
        and "table2.ngc does not exist" in again.getStatusString()
        and again.Blocks == 0
    )


@pytest.mark.parametrize(
    ("machine", "settings", "kind"),
    [
        ("mikron", {}, MachineError),
        ("mikron_ucp710", {"scallop": 1}, SettingsError),
        ("mikron_ucp710", {"controller": "x"}, SettingsError),
        ("", {}, SettingsError),
    ],
)
def test_a_bad_audit_leaves_nothing_behind(doc, table2, machine, settings, kind):
    with pytest.raises(kind):
        app.audit(doc, table2, machine, **settings)
    assert not doc.Objects


def test_a_file_that_is_not_there_leaves_nothing_behind(doc, tmp_path):
    with pytest.raises(FileError, match="does not exist"):
        app.audit(doc, tmp_path / "no.ngc", "mikron_ucp710")
    assert not doc.Objects


DOME = {"machine": "trunnion_ac", "stepover": 8, "tolerance": 0.005, **PLAIN, **UNCURED}


def test_markers_on_a_dome_stand_where_the_core_says(doc, dome, tmp_path):
    path = app.create_toolpath(doc, dome, **DOME, work_zero=(1, 2, 3))
    marks = app.annotate(path)
    moved = dome.Mesh.copy()
    moved.translate(-1, -2, -3)
    moved.write(str(tmp_path / "dome.stl"))
    wanted = core_markers(job.figures(job.run(build_settings("mill", str(tmp_path / "dome.stl"), DOME))))
    assert list(marks.Kinds) == [mark.kind for mark in wanted] and list(marks.Labels) == [
        mark.label for mark in wanted
    ]
    np.testing.assert_allclose(
        [tuple(place) for place in marks.Places],
        np.array([mark.place for mark in wanted]) + (1, 2, 3),
        atol=1e-9,
    )
    kinds = set(marks.Kinds)
    assert {"largest-deviation", "singular-block", "deviation-over-tolerance"} <= kinds
    near = [place for place, kind in zip(marks.Places, marks.Kinds, strict=True) if kind == "singular-block"]
    assert min(np.hypot(place.x, place.y) for place in near) < 8  # the pole stands over the dome's top


def test_a_path_has_one_markers_object_that_follows_it(doc, dome):
    path = app.create_toolpath(doc, dome, **DOME)
    marks = app.annotate(path)
    assert app.annotate(path) is marks is markers.of(path) and marks in path.InList
    before = len(marks.Places)
    path.Tolerance = 1
    doc.recompute()
    assert len(marks.Places) < before and marks.State == ["Up-to-date"]


def test_markers_without_a_path_are_reported(doc, dome, reopen):
    path = app.create_toolpath(doc, dome, **DOME)
    app.annotate(path)
    again = reopen(doc)
    assert list(again.Markers.Labels)
    again.removeObject("Toolpath")
    again.recompute()
    assert "Invalid" in again.Markers.State and "was deleted" in again.Markers.getStatusString()


def test_only_paths_are_annotated(doc, dome):
    with pytest.raises(FiveAxisError, match="no toolpath and no audit"):
        app.annotate(dome)
    with pytest.raises(FiveAxisError, match="no toolpath and no audit"):
        app.annotate(None)
    assert [one.Name for one in doc.Objects] == ["Dome"]
