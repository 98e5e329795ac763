# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool bits' files and the tools of a CAM Job become cutters, or an error that names the remedy."""

import json
from types import SimpleNamespace

import FreeCAD
import pytest
from cam_jobs import make_job

from freecad_fiveaxis.app.tool_bit import JobTool, cutter_of_file, cutter_of_tool, cutters_of_job
from freecad_fiveaxis.core.cutter import Cutter
from freecad_fiveaxis.core.errors import FileError, SettingsError


def bit_file(folder, shape="ballend.fcstd", **sizes):
    path = folder / "bit.fctb"
    parameter = {"Diameter": "6.0000 mm", "CuttingEdgeHeight": "40.0000 mm", "Length": "50.0000 mm"} | sizes
    path.write_text(json.dumps({"version": 2, "name": "bit", "shape": shape, "parameter": parameter, "attribute": {}}))
    return path


@pytest.mark.parametrize("shape", ["ballend.fcstd", "Ballend", "/usr/share/Shape/ballend.fcstd", "C:\\Shape\\BallEnd.FCStd"])
def test_a_ball_end_of_any_spelling_is_a_cutter(tmp_path, shape):
    assert cutter_of_file(bit_file(tmp_path, shape)) == Cutter(6.0, 40.0)


@pytest.mark.parametrize(
    "text, mm", [("6.0000 mm", 6), ("0.25 in", 6.35), ('1/4"', 6.35), ("1 cm", 10), ("8", 8), (8.5, 8.5), ("6,5 mm", 6.5)]
)
def test_sizes_are_texts_with_units_inches_too(tmp_path, text, mm):
    assert cutter_of_file(bit_file(tmp_path, Diameter=text)).diameter == pytest.approx(mm, abs=1e-9)


@pytest.mark.parametrize("text", ["", "six", "6 kg", None, [6], "30 deg"])
def test_a_size_that_is_no_length_is_named(tmp_path, text):
    with pytest.raises(SettingsError, match=r"bit\.fctb: Diameter"):
        cutter_of_file(bit_file(tmp_path, Diameter=text))


@pytest.mark.parametrize("text", ["0 mm", "-6 mm", "20 m"])
def test_a_size_that_no_cutter_has_is_refused(tmp_path, text):
    with pytest.raises(SettingsError, match="cutter diameter"):
        cutter_of_file(bit_file(tmp_path, Diameter=text))


@pytest.mark.parametrize("shape", ["endmill.fcstd", "drill.fcstd", "v-bit.fcstd", "taperedballnose.fcstd", ""])
def test_another_shape_is_named_with_the_remedy(tmp_path, shape):
    with pytest.raises(SettingsError, match=f"shape {shape or '.none.'}; only ball ends"):
        cutter_of_file(bit_file(tmp_path, shape))


def test_the_new_key_for_the_shape_wins(tmp_path):
    path = bit_file(tmp_path, "my own.fcstd")
    path.write_text(json.dumps(json.loads(path.read_text()) | {"shape-type": "Ballend"}))
    assert cutter_of_file(path) == Cutter(6.0, 40.0)


@pytest.mark.parametrize("sizes", [{"CornerRadius": "1.0000 mm"}, {"FlatRadius": "2.0000 mm"}])
def test_a_bull_nose_is_refused_with_its_corner_radius(tmp_path, sizes):
    with pytest.raises(SettingsError, match="bull nose of 6 mm with a corner radius of 1 mm"):
        cutter_of_file(bit_file(tmp_path, "bullnose.fcstd", **sizes))


@pytest.mark.parametrize("sizes", [{"CornerRadius": "3.0000 mm"}, {"FlatRadius": "0.0000 mm"}])
def test_a_bull_nose_without_a_flat_is_a_ball(tmp_path, sizes):
    assert cutter_of_file(bit_file(tmp_path, "bullnose.fcstd", **sizes)) == Cutter(6.0, 40.0)


def test_without_a_cutting_edge_the_default_counts(tmp_path):
    path = bit_file(tmp_path)
    bit = json.loads(path.read_text())
    del bit["parameter"]["CuttingEdgeHeight"]
    path.write_text(json.dumps(bit))
    assert cutter_of_file(path) == Cutter(6.0)


@pytest.mark.parametrize("content", [b"", b"{", b"[]", b"\xff\xfe", b'{"shape": "ballend.fcstd"}', b"[" * 100_000])
def test_a_file_that_is_no_tool_bit_is_said_so(tmp_path, content):
    path = tmp_path / "bit.fctb"
    path.write_bytes(content)
    with pytest.raises(SettingsError, match=r"bit\.fctb"):
        cutter_of_file(path)


def test_a_missing_file_is_a_file_error(tmp_path):
    with pytest.raises(FileError, match="tool bit"):
        cutter_of_file(tmp_path / "none.fctb")


def tool(shape, **more):
    mm = FreeCAD.Units.Quantity
    return SimpleNamespace(Label="T", Diameter=mm("6 mm"), CuttingEdgeHeight=mm("40 mm"), **shape, **more)


@pytest.mark.parametrize(
    "shape",
    [
        {"ShapeType": "Ballend"},
        {"BitShape": "/x/ballend.fcstd"},
        {"BitShape": "", "ShapeName": "ballend"},
        {"ToolType": "BallEndMill"},
    ],
)
def test_a_tool_of_any_version_is_a_cutter(shape):
    assert cutter_of_tool(tool(shape)) == Cutter(6.0, 40.0)


def test_the_tools_of_a_real_job(doc):
    default, ball = cutters_of_job(make_job(doc, doc.addObject("Part::Box", "Box")))
    assert default.cutter is None and "only ball ends" in default.error
    assert ball == JobTool("Ball", 3, Cutter(6.0, 40.0), "", feed=1000.0, plunge_feed=200.0, spindle=12000.0)
