# SPDX-License-Identifier: LGPL-2.1-or-later
"""An audit, and recover, say where a program or its CL file seems to be in another unit than it is read
in."""

import re

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.calibration import tasks as calibration
from freecad_fiveaxis.core.pipeline import job, outputs
from freecad_fiveaxis.core.pipeline.settings import build_settings

LEAN = np.linspace(0.0, 0.5, 40)
TURN = np.linspace(0.2, 1.4, 40)


def cl_text(lean=LEAN, head="UNITS/MM\n", scale=1.0):
    """A path over a dome of 40 mm, first with the tool held still, then with it turning."""
    rows = ["PARTNO A\n" + head + "MULTAX/ON\nFEDRAT/800,MMPM\nRAPID\nGOTO/0,0,60,0,0,1"]
    rows += [
        f"GOTO/{scale * 40 * np.sin(k / 10):.4f},{scale * k:.4f},{scale * 20 * np.cos(k / 10):.4f},0,0,1"
        for k in range(30)
    ]
    for a, c in zip(lean, TURN, strict=True):
        i, j, k = np.sin(a) * np.cos(c), np.sin(a) * np.sin(c), np.cos(a)
        rows.append(
            f"GOTO/{scale * 40 * i:.4f},{scale * 40 * j:.4f},{scale * 40 * k:.4f},{i:.7f},{j:.7f},{k:.7f}"
        )
    return "\n".join(rows) + "\nFINI\n"


def posted(tmp_path, machine="trunnion_ac", **text):
    """The CL file and the program that is posted from it."""
    apt, nc = tmp_path / "part.apt", tmp_path / "part.ngc"
    apt.write_text(cl_text(**text))
    outputs.write_outputs(
        job.run(
            build_settings("post", str(apt), {"machine": machine, "output": str(nc), "tool_length": "80"})
        )
    )
    return apt, nc


def in_radians(nc):
    """The same program with rotary words in radians."""
    nc.write_text(
        re.sub(
            r"\b([ABC])(-?[0-9.]+)", lambda word: f"{word[1]}{np.radians(float(word[2])):.6f}", nc.read_text()
        )
    )


def audited(nc, machine="trunnion_ac", **options):
    result = job.run(build_settings("audit", str(nc), {"machine": machine, "tool_length": "80", **options}))
    return [one for one in result.findings if one.code == "unit-suspected"]


@pytest.mark.parametrize("machine", ["trunnion_ac", "fork_head_bc", "head_b_table_c"])
def test_radians_are_reported_alone_and_against_the_cl_file(tmp_path, machine):
    apt, nc = posted(tmp_path, machine)
    assert audited(nc, machine) == audited(nc, machine, against=str(apt)) == []
    in_radians(nc)
    (found,) = audited(nc, machine, against=str(apt))[-1:]
    assert found.unit == "deg" and found.limit > 20.0 > found.value and "radians" in found.text


def test_radians_are_reported_by_the_way_of_the_tip(tmp_path):
    _, nc = posted(tmp_path, "fork_head_bc")
    in_radians(nc)
    (found,) = audited(nc, "fork_head_bc")
    assert found.unit == "mm" and found.value < 0.5 * found.limit


def test_small_angles_in_degrees_are_no_radians(tmp_path):
    apt, nc = posted(tmp_path, lean=LEAN / 12)
    assert audited(nc) == audited(nc, against=str(apt)) == []


@pytest.mark.parametrize("machine", ["trunnion_ac", "fork_head_bc"])
def test_a_cl_file_25_times_as_large_is_reported(tmp_path, machine):
    apt, nc = posted(tmp_path, machine)
    apt.write_text(cl_text(head="UNITS/INCHES\n"))
    (found,) = audited(nc, machine, against=str(apt))
    assert found.limit == pytest.approx(25.4 * found.value, rel=0.02) and "--units" in found.text


def test_a_program_in_inches_with_numbers_of_mm_is_reported_by_the_travel_and_by_the_part(tmp_path):
    nc = tmp_path / "part.ngc"
    nc.write_text(
        "G20 G90\nG0 X0 Y0 Z60 A0 C0\nG1 Z0 F10\nX50\nY40\n" + "".join(f"X{k}\n" for k in range(20)) + "M30\n"
    )
    (found,) = audited(nc)
    assert found.value == pytest.approx(25.4 * 50) and "50 mm" in found.text
    nc.write_text(nc.read_text().replace("G20", "(G20) G21"))
    assert audited(nc) == []


def test_recover_says_it_too(tmp_path):
    apt, nc = posted(tmp_path)
    apt.write_text(cl_text(head="UNITS/INCHES\n"))
    settings = build_settings(
        "recover", str(apt), {"program": str(nc), "machine_file": str(tmp_path / "new.fcm")}
    )
    with pytest.raises(ProgramError, match=r"can be paired .* is read in inches and means mm"):
        calibration.run(settings)
