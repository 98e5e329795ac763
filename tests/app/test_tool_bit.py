# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool bits' files and the tools of a CAM Job become cutters, or an error that names the remedy."""

import json
import math
from pathlib import Path
from types import SimpleNamespace

import FreeCAD
import pytest
from cam_jobs import make_job

from freecad_fiveaxis.app.tool_bit import JobTool, cutter_of_file, cutter_of_tool, cutters_of_job
from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.tool import Cutter


def bit_file(folder, shape="ballend.fcstd", **sizes):
    path = folder / "bit.fctb"
    parameter = {"Diameter": "6.0000 mm", "CuttingEdgeHeight": "40.0000 mm", "Length": "50.0000 mm"} | sizes
    path.write_text(
        json.dumps({"version": 2, "name": "bit", "shape": shape, "parameter": parameter, "attribute": {}})
    )
    return path


@pytest.mark.parametrize(
    "shape", ["ballend.fcstd", "Ballend", "/usr/share/Shape/ballend.fcstd", "C:\\Shape\\BallEnd.FCStd"]
)
def test_a_ball_end_of_any_spelling_is_a_cutter(tmp_path, shape):
    assert cutter_of_file(bit_file(tmp_path, shape)) == Cutter(6.0, 40.0)


@pytest.mark.parametrize(
    ("text", "mm"),
    [
        ("6.0000 mm", 6),
        ("0.25 in", 6.35),
        ('1/4"', 6.35),
        ("1 cm", 10),
        ("8", 8),
        (8.5, 8.5),
        ("6,5 mm", 6.5),
    ],
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


@pytest.mark.parametrize("shape", ["drill.fcstd", "v-bit.fcstd", "chamfer.fcstd", ""])
def test_another_shape_is_named_with_the_remedy(tmp_path, shape):
    with pytest.raises(SettingsError, match=f"shape {shape or '.none.'}; ball ends, end mills"):
        cutter_of_file(bit_file(tmp_path, shape))


def test_the_new_key_for_the_shape_wins(tmp_path):
    path = bit_file(tmp_path, "my own.fcstd")
    path.write_text(json.dumps(json.loads(path.read_text()) | {"shape-type": "Ballend"}))
    assert cutter_of_file(path) == Cutter(6.0, 40.0)


@pytest.mark.parametrize("shape", ["endmill.fcstd", "Endmill"])
def test_an_end_mill_is_flat(tmp_path, shape):
    assert cutter_of_file(bit_file(tmp_path, shape)) == Cutter(6.0, 40.0, corner=0.0)


@pytest.mark.parametrize("sizes", [{"CornerRadius": "1.0000 mm"}, {"FlatRadius": "2.0000 mm"}])
@pytest.mark.parametrize("shape", ["bullnose.fcstd", "torus"])
def test_a_bull_nose_has_its_corner_radius_or_its_flat(tmp_path, shape, sizes):
    assert cutter_of_file(bit_file(tmp_path, shape, **sizes)) == Cutter(6.0, 40.0, corner=1.0)


@pytest.mark.parametrize("text", ["10.0000 °", "10 deg", 10])
def test_the_angle_of_a_tapered_ball_nose_is_that_of_both_flanks(tmp_path, text):
    result = cutter_of_file(
        bit_file(tmp_path, "taperedballnose.fcstd", TaperAngle=text, TaperDiameter="12 mm")
    )
    assert (result.diameter, result.length, result.ring) == (6.0, 40.0, 0.0) and math.degrees(
        result.taper
    ) == pytest.approx(5.0)


@pytest.mark.parametrize(
    ("shape", "sizes", "says"),
    [
        ("bullnose.fcstd", {}, "no corner radius"),
        ("bullnose.fcstd", {"CornerRadius": "4 mm"}, "corner radius is 4 mm; give 0 to 3 mm"),
        ("taperedballnose.fcstd", {}, "no taper angle"),
        ("taperedballnose.fcstd", {"TaperAngle": "6 mm"}, "TaperAngle '6 mm' is no angle"),
        ("taperedballnose.fcstd", {"TaperAngle": "150 deg"}, "taper is 75 deg"),
    ],
)
def test_a_size_that_is_missing_or_impossible_is_stated(tmp_path, shape, sizes, says):
    with pytest.raises(SettingsError, match=says):
        cutter_of_file(bit_file(tmp_path, shape, **sizes))


def test_the_bits_that_come_with_freecad_are_cutters_or_stated_to_be_none():
    mods = Path(FreeCAD.getHomePath()) / "Mod"
    (folder,) = (found for name in ("CAM", "Path") if (found := mods / name / "Tools" / "Bit").is_dir())
    assert cutter_of_file(folder / "6mm_Bullnose.fctb") == Cutter(6.0, 40.0, corner=1.5)
    assert cutter_of_file(folder / "5mm_Endmill.fctb") == Cutter(5.0, 30.0, corner=0.0)
    with pytest.raises(SettingsError, match="shape"):
        cutter_of_file(folder / "5mm_Drill.fctb")


@pytest.mark.parametrize("sizes", [{"CornerRadius": "3.0000 mm"}, {"FlatRadius": "0.0000 mm"}])
def test_a_bull_nose_without_a_flat_is_a_ball(tmp_path, sizes):
    assert cutter_of_file(bit_file(tmp_path, "bullnose.fcstd", **sizes)) == Cutter(6.0, 40.0)


def test_without_a_cutting_edge_the_default_counts(tmp_path):
    path = bit_file(tmp_path)
    bit = json.loads(path.read_text())
    del bit["parameter"]["CuttingEdgeHeight"]
    path.write_text(json.dumps(bit))
    assert cutter_of_file(path) == Cutter(6.0)


@pytest.mark.parametrize(
    "content", [b"", b"{", b"[]", b"\xff\xfe", b'{"shape": "ballend.fcstd"}', b"[" * 100_000]
)
def test_a_file_that_is_no_tool_bit_is_stated_so(tmp_path, content):
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
    assert default.cutter == Cutter(5.0, default.cutter.length, corner=0.0) and not default.error
    assert ball == JobTool("Ball", 3, Cutter(6.0, 40.0), "", feed=1000.0, plunge_feed=200.0, spindle=12000.0)
