# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files in other units than mm: a part drawn in inches is the same part once that is named."""

from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, read_stl, write_stl
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.preview import preview_passes
from freecad_fiveaxis.core.studies import study

MM = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "inch": 25.4}
PLATE, TOP, TALL = (box((0, 0, low), (15, 10, high)) for low, high in ((0, 5), (4, 5), (0, 6)))
CLAMP = box((5, -8, 0), (10, -1, 20))
GIVEN = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6:10", "holder": "40x40"}
GIVEN |= {"stepover": 5.0, "gouge": "report"}
FILES = {
    "plate.stl": PLATE,
    "top.stl": TOP,
    "tall.stl": TALL,
    "chip.stl": box((0, 0, 0), (3, 2, 1)),
    "clamp.stl": CLAMP,
}


@pytest.fixture(params=["cm", "m", "inch"])
def unit(request):
    return request.param


@pytest.fixture
def files(tmp_path, unit):
    """The same files in mm and, in a folder of its name, in the unit: text with all digits, so that only the
    scale is another."""
    for name, scale in (("mm", 1.0), (unit, MM[unit])):
        (tmp_path / name).mkdir()
        for file, triangles in FILES.items():
            mesh = from_triangles(triangles)
            write_stl(replace(mesh, vertex=mesh.vertex / scale), tmp_path / name / file, ascii=True)
    return tmp_path


def in_both(files, unit, make):
    """What ``make(folder, units)`` gives of the files in mm, and of those in the unit."""
    return make(files / "mm", {}), make(files / unit, {"stl_units": unit})


def milled(folder, units, **more):
    given = {**GIVEN, **units, "fixture": [str(folder / "clamp.stl")], "faces": str(folder / "top.stl")}
    return job.run(build_settings("mill", str(folder / "plate.stl"), {**given, **more}))


def test_part_faces_and_fixture_make_the_same_program_and_findings(files, unit):
    in_mm, other = in_both(files, unit, milled)
    np.testing.assert_allclose(other.draft.path.tip, in_mm.draft.path.tip, atol=1e-9)
    assert other.draft.nc == in_mm.draft.nc and len(in_mm.draft.program.words) > 10
    assert [(one.code, one.line) for one in other.findings] == [
        (one.code, one.line) for one in in_mm.findings
    ]
    assert "fixture-collision" in {one.code for one in in_mm.findings}


def test_preview_and_reach_take_them_too(files, unit):
    def preview(folder, units):
        given = {**GIVEN, **units, "faces": str(folder / "top.stl")}
        return preview_passes(build_settings("mill", str(folder / "plate.stl"), given)).length

    def reach(folder, units):
        given = {"machine": "trunnion_ac", "cutter": "ball:6", **units}
        return study.try_reach(build_settings("reach", str(folder / "chip.stl"), given)).found.area.sum()

    for look in (preview, reach):
        in_mm, other = in_both(files, unit, look)
        assert other == pytest.approx(in_mm, rel=1e-9)


def test_an_audit_compares_with_the_part_in_its_unit(files, unit):
    nc = files / "part.nc"
    nc.write_bytes(milled(files / "mm", {}).draft.nc)

    def audit(folder, units):
        given = {
            "machine": "trunnion_ac",
            "controller": "linuxcnc",
            "tool_length": 120,
            "cutter": "ball:6",
            **units,
        }
        result = job.run(build_settings("audit", str(nc), {**given, "against": str(folder / "tall.stl")}))
        return sorted((one.code, one.line) for one in result.findings)

    in_mm, other = in_both(files, unit, audit)
    assert other == in_mm and "overcut" in {code for code, _ in in_mm}
    assert audit(files / unit, {}) != in_mm  # taken as mm it is another part


def test_an_stl_of_mm_is_read_as_ever(files, unit):
    mesh = read_stl(files / "mm" / "plate.stl")
    assert np.array_equal(read_stl(files / "mm" / "plate.stl", unit=1.0).vertex, mesh.vertex)
    np.testing.assert_allclose(
        read_stl(files / unit / "plate.stl", unit=MM[unit]).vertex, mesh.vertex, atol=1e-12
    )


def test_a_part_that_is_smaller_than_the_cutter_names_the_option_and_with_it_is_no_more(files, unit, capsys):
    part, out = str(files / unit / "plate.stl"), str(files / "out.nc")
    words = f"mill {part} --machine trunnion_ac --tool-length 120 --cutter ball:6 --stepover".split()
    words += ["0.05" if unit != "m" else "0.01", "--passes", "planes", "--spindle", "off", "-o", out]
    cli.main(words)
    assert "--stl-units" in capsys.readouterr().out
    words[words.index("--stepover") + 1] = "5"
    cli.main([*words[:-1], str(files / "other.nc"), "--stl-units", unit])
    assert "--stl-units" not in capsys.readouterr().out
