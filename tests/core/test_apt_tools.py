# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files of several tools: that they are told, how one is chosen, and the cutter that a file says."""

from __future__ import annotations

import json

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import ProgramError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt, read_cl_file
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

NX = """TOOL PATH/A,TOOL,T10
TLDATA/MILL,10.0000,0.0000,50.0000,0.0000,0.0000
MSYS/0,0,0,1,0,0,0,1,0
PAINT/PATH
RAPID
GOTO/0,0,50,0,.6,.8
FEDRAT/MMPM,500.0
GOTO/10,0,0
END-OF-PATH
TOOL PATH/B,TOOL,T8
TLDATA/MILL,8.0000,4.0000,80.0000,0.0,0.0
MSYS/0,0,0,1,0,0,0,1,0
RAPID
GOTO/20,0,50
GOTO/20,10,0
END-OF-PATH
TOOL PATH/C,TOOL,T10
TLDATA/MILL,10.0000,0.0000,50.0000,0.0000,0.0000
GOTO/30,0,0
END-OF-PATH
"""
CATIA = """UNITS/INCHES
CUTTER/ 1.0, 0.25
TOOLNO/3,MILL, 1.0
LOADTL/3,1
SPINDL/500,RPM
FEDRAT/10,IPM
GOTO/0,0,1
CYCLE/TAP,5
GOTO/1,0,1
CYCLE/OFF
CUTTER/ 0.5, 0.25
TOOLNO/7,MILL, 0.5
LOADTL/7,1
GOTO/2,0,1
GOTO/3,0,1
"""
MACHINE = {"machine": "linuxcnc_xyzac_trt"}


def _list_reported(path: CLPath) -> list[tuple[str, Severity, int | None]]:
    return [(one.code, one.severity, one.line) for one in path.findings]


def test_tools_that_only_names_tell_apart_are_reported() -> None:
    path = read_apt(NX)
    assert _list_reported(path) == [("several-tools", Severity.ERROR, 10)] and len(path.tip) == 5
    assert "1 (T10), 2 (T8)" in path.findings[0].text and "--cl-tool" in path.findings[0].text
    nameless = NX.replace(",TOOL,", ",")
    assert "2 (MILL,8,4,80,0,0)" in read_apt(nameless).findings[0].text
    assert (
        read_apt(
            NX.replace("T8", "T10")
            .replace("8.0000,4.0000,80", "10.0000,0.0000,50")
            .replace("80.0000,0.0,", "50.0000,0.0000,")
        ).findings
        == ()
    )


def test_one_number_for_two_names_does_not_hide_the_second_tool() -> None:
    text = NX.replace("PAINT/PATH", "LOAD/TOOL,4")
    assert "1 (T10), 2 (T8)" in read_apt(text).findings[0].text
    every = text.replace("FEDRAT", "FEDRAT").replace("RAPID\nGOTO/20", "LOAD/TOOL,9\nRAPID\nGOTO/20")
    assert "(4, 9)" in read_apt(every).findings[0].text


@pytest.mark.parametrize(("tool", "x", "cutter"), [(1, [0, 10, 30], 10.0), (2, [20, 20], 8.0)])
def test_the_moves_of_the_tool_chosen_are_taken_with_their_axes_and_feeds(
    tool: int, x: list[float], cutter: float
) -> None:
    file = read_cl_file(NX, ClReading(tool=tool))
    assert file.path.tip[:, 0].tolist() == x and np.allclose(file.path.axis, (0, 0.6, 0.8))
    assert file.path.feed[1:].tolist() == [500] * (len(x) - 1) and file.head.diameter == cutter
    assert (
        _list_reported(file.path) == [("tool-chosen", Severity.NOTE, None)]
        and f"{len(x)} of 5" in file.path.findings[0].text
    )


def test_by_number_with_what_stands_before_the_number() -> None:
    both = read_apt(CATIA)
    assert ("several-tools", Severity.ERROR, 13) in _list_reported(both) and "(3, 7)" in both.findings[
        -1
    ].text
    assert read_cl_file(CATIA).tools == (3, 7) and read_cl_file("GOTO/0,0,1\nGOTO/1,0,1\n").tools == ()
    file = read_cl_file(CATIA, ClReading(tool=7))
    assert [one.code for one in file.path.findings] == ["tool-chosen"]  # and no word of the other's tap
    assert np.allclose(file.path.tip[:, 0], [50.8, 76.2]) and file.head.diameter == pytest.approx(12.7)
    assert (file.head.tool, file.head.speed) == (7, 500) and np.allclose(file.path.feed, 254)
    assert "statement-not-interpreted" in [one.code for one in read_apt(CATIA, ClReading(tool=3)).findings]
    assert (
        "(3, 7)" in read_apt(CATIA.replace("LOADTL/3,1\n", "").replace("LOADTL/7,1\n", "")).findings[-1].text
    )


def test_a_tool_that_is_not_there_names_those_that_are() -> None:
    with pytest.raises(ProgramError, match=r"no tool 5; it has 1 \(T10\), 2 \(T8\)"):
        read_apt(NX, ClReading(tool=5))
    with pytest.raises(ProgramError, match="names no tool"):
        read_apt("GOTO/1,2,3\n", ClReading(tool=1))
    one = read_apt("LOADTL/4\nFEDRAT/9\nGOTO/1,2,3\n", ClReading(tool=4))
    assert one.findings == () and len(one.tip) == 1


def test_nx_says_the_shape_of_the_cutter() -> None:
    def cutter(data: str) -> object:
        return read_cl_file(f"TLDATA/{data}\nGOTO/1,2,3\n").head.cutter

    flat, ball = cutter("MILL,10.0,0.0,50.0,0.0,0.0"), cutter("MILL,30.0,15.0,75.0,0.0,0.0")
    assert (flat.diameter, flat.corner) == (10, 0) and (ball.diameter, ball.corner) == (30, 15)
    bull = cutter("MILL,32.0,5.0,75.0,0.0,0.0")
    assert (bull.diameter, bull.corner, bull.taper) == (32, 5, 0)
    assert cutter("MILL,30.0,0.0,30.0,0.0,45.0") is None and cutter("TCUTTER,MILL,30,1,2,3,4,5") is None
    assert read_cl_file("TLDATA/DRILL,MILL,63.0,0.0,239.0,178.0,35.0\nGOTO/1,2,3\n").head.diameter == 63


def _post(tmp_path, text: str, **options: str) -> tuple[job.ProgramDraft, list[Finding]]:
    (tmp_path / "in.cls").write_text(text)
    result = job.make(build_settings("post", str(tmp_path / "in.cls"), MACHINE | options))
    return result, [one for one in result.findings if one.code.startswith("cutter")]


def test_the_files_cutter_is_taken_where_none_is_given(tmp_path) -> None:
    result, (found,) = _post(tmp_path, NX, cl_tool="2")
    assert (result.settings.cutter.cutter.diameter, result.settings.cutter.cutter.corner) == (8, 4)
    assert (found.code, found.severity) == (
        "cutter-from-cl-file",
        Severity.NOTE,
    ) and "ball 8 mm" in found.text
    result, (found,) = _post(tmp_path, NX, cl_tool="2", cutter="ball:10")
    assert result.settings.cutter.cutter.diameter == 10 and found.code == "cutter-differs"
    result, found = _post(tmp_path, "GOTO/1,2,3\nGOTO/2,2,3\n")
    assert result.settings.cutter.cutter.diameter == 10 and found == []


def test_the_command_line_chooses_the_tool_and_refuses_what_is_not_there(tmp_path, capsys) -> None:
    (tmp_path / "in.cls").write_text(NX)
    wanted = [
        "post",
        str(tmp_path / "in.cls"),
        "--machine",
        MACHINE["machine"],
        "-o",
        str(tmp_path / "out.ngc"),
        "--quiet",
    ]
    assert cli.main([*wanted, "--cl-tool", "3"]) == 2
    assert (
        "no tool 3; it has 1 (T10), 2 (T8)" in capsys.readouterr().err and not (tmp_path / "out.ngc").exists()
    )
    assert cli.main([*wanted, "--cl-tool", "2"]) == 0 and cli.main(wanted) == 1


@pytest.mark.parametrize("option", [{"units": "mm"}, {"cl_tool": "1"}])
def test_a_part_has_neither_units_to_ask_for_nor_tools(option: dict[str, str]) -> None:
    with pytest.raises(SettingsError, match=r"is of a CL file, part\.stl is a part"):
        build_settings("setup", "part.stl", MACHINE | option)
    assert build_settings("setup", "path.apt", MACHINE | option)


def test_an_audit_tells_what_is_wrong_with_the_cl_file(tmp_path) -> None:
    (tmp_path / "in.cls").write_text(NX.replace(",0,.6,.8", ""))
    (tmp_path / "p.ngc").write_text("G21 G0 X20 Y0 Z50 A0 C0\nG1 F500 X20 Y10 Z0\nM2\n")
    wanted = [
        "audit",
        str(tmp_path / "p.ngc"),
        "--machine",
        MACHINE["machine"],
        "--against",
        str(tmp_path / "in.cls"),
    ]
    report = tmp_path / "r.json"
    assert cli.main([*wanted, "--quiet", "--report", str(report)]) == 1
    found = {one["code"]: one for one in json.loads(report.read_text())["findings"]}
    assert (
        found["several-tools"]["text"].startswith("CL file, line 10: The file changes tools")
        and "cl-rows-missed" in found
    )
    assert found["several-tools"].get("line") is None
    assert cli.main([*wanted, "--quiet", "--report", str(report), "--cl-tool", "2"]) == 0
    assert {one["code"] for one in json.loads(report.read_text())["findings"]} >= {"tool-chosen"}
