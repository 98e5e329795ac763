# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units of CL files: what they say, what they do not, and what is asked for."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.apt import ClReading, read_apt, read_cl_file

SILENT = "PARTNO X\nGOTO/0,0,1\nFEDRAT/10.0,IPM\nGOTO/1,2,1\nFINI\n"
"""CAMWorks prints such files."""


@pytest.mark.parametrize("word", ["UNITS/INCHES", "UNIT/INCHES", "UNIT/INCH", "UNITS / INCH"])
def test_inches_are_inches(word: str) -> None:
    path = read_apt(SILENT.replace("GOTO", word + "\nGOTO", 1))
    assert np.allclose(path.tip, 25.4 * np.array([[0, 0, 1], [1, 2, 1]]))
    assert [found.code for found in path.findings] == ["no-feed"] and path.feed[1] == pytest.approx(254)


@pytest.mark.parametrize(
    "message",
    ["FEDRAT/10.0,IPM", "FEDRAT/IPR,.01", "SPINDL/300,SFM,CLW", "CYCLE/DRILL,DEPTH,1,IPM,5,CLEAR,.1"],
)
def test_a_file_that_speaks_of_inches_and_says_no_unit_is_reported(message: str) -> None:
    path = read_apt("SPINDL/500,CLW\nFEDRAT/5\nGOTO/0,0,1\n" + message + "\nFEDRAT/5\nGOTO/1,2,1\n")
    (found,) = [one for one in path.findings if one.code == "units-not-said"]
    assert (found.severity, found.line) == (Severity.WARNING, 4)
    assert "mm is taken" in found.text and message.replace(" ", "") in found.text and "--units" in found.text


@pytest.mark.parametrize(
    "text",
    ["UNITS/MM\n" + SILENT, "UNIT/MM\n" + SILENT, SILENT.replace("IPM", "MMPM"), SILENT.replace(",IPM", "")],
)
def test_a_file_that_says_its_unit_or_nothing_of_inches_is_not_reported(text: str) -> None:
    assert [found.code for found in read_apt(text).findings] == ["no-feed"]


def test_what_is_requested_holds_until_the_file_says_its_own() -> None:
    inch, mm = ClReading(5.0, units="inch"), ClReading(5.0, units="mm")
    assert np.allclose(read_apt(SILENT, inch).tip, 25.4 * read_apt(SILENT, mm).tip)
    assert read_apt(SILENT, inch).findings == read_apt(SILENT, mm).findings == ()
    assert np.array_equal(read_apt("UNITS/MM\n" + SILENT, inch).tip, read_apt(SILENT, mm).tip)
    assert read_cl_file("CUTTER/.5,.25\nFEDRAT/2\nGOTO/0,0,0\n", inch).head.diameter == pytest.approx(12.7)
    assert read_apt("FEDRAT/2\nGOTO/0,0,0\n", inch).feed.tolist() == [pytest.approx(50.8)]


def test_every_task_that_reads_a_cl_file_takes_the_units(tmp_path) -> None:
    (tmp_path / "in.apt").write_text(SILENT)
    draft = job.make(
        build_settings(
            "post",
            str(tmp_path / "in.apt"),
            {"machine": "linuxcnc_xyzac_trt", "units": "inch", "output": "x"},
        )
    )
    assert draft.program.words[-1, :3] == pytest.approx([25.4, 50.8, 25.4], abs=1e-3)
    for task in ("setup", "recover"):
        more = (
            {"machine_file": "m.fcm", "program": "p.nc"}
            if task == "recover"
            else {"machine": "linuxcnc_xyzac_trt"}
        )
        assert build_settings(task, "in.apt", {"units": "inch", **more}).reading.units == "inch"


def test_an_audit_reads_program_and_cl_file_in_the_units_requested(tmp_path) -> None:
    (tmp_path / "in.apt").write_text(SILENT.replace(",IPM", ""))
    (tmp_path / "p.ngc").write_text("G1 F10 X0 Y0 Z1 A0 C0\nX1 Y2 Z1\nM2\n")
    wanted = [
        "audit",
        str(tmp_path / "p.ngc"),
        "--machine",
        "linuxcnc_xyzac_trt",
        "--against",
        str(tmp_path / "in.apt"),
        "--quiet",
    ]
    assert cli.main([*wanted, "--units", "inch"]) == 0
    (tmp_path / "p.ngc").write_text("G21\nG1 F10 X0 Y0 Z25.4 A0 C0\nX25.4 Y50.8 Z25.4\nM2\n")
    assert cli.main([*wanted, "--units", "inch"]) == 0 and cli.main(wanted) == 1
