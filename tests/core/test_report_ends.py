# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first and last moves of the NC file are in the report of the program as in an audit of the file."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.machine import SafeStart, load_machine, save_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import as_html, as_text, summary
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClHead, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion


def write_path(folder):
    """Write a CL file that comes down, cuts with turning axes and rises a little."""
    axis = np.array([(0.6, 0.0, 0.8), (0.6, 0.0, 0.8), (0.0, 0.6, 0.8), (0.0, 0.6, 0.8)])
    tip = np.array([(20.0, 10.0, 40.0), (20.0, 10.0, 30.0), (24.0, 11.0, 30.0), (24.0, 11.0, 35.0)])
    motion, none = np.array([Motion.RAPID, Motion.CUT, Motion.CUT, Motion.RAPID], np.int8), np.full(4, -1)
    path = CLPath(
        tip, axis, motion, np.where(motion == Motion.RAPID, 0.0, 500.0), tip, axis, none, none, none
    )
    (folder / "a.apt").write_bytes(write_apt(path, Cutter(8.0), "a", head=ClHead()))
    return str(folder / "a.apt")


def run(folder, start, **options):
    """Return the post's result and the audit's of the file that it writes."""
    machine = folder / "m.fcm"
    save_machine(replace(load_machine("trunnion_ac"), safe_start=start), machine, overwrite=True)
    given = {"machine": str(machine), "tool_length": 90.0} | options
    posted = job.run(build_settings("post", write_path(folder), given | {"tool": 3, "spindle": 9000.0}))
    nc = folder / ("a.h" if options.get("controller", "").startswith("heid") else "a.nc")
    nc.write_bytes(posted.draft.nc)
    only = {key: value for key, value in given.items() if key != "rtcp"}
    return posted, job.run(build_settings("audit", str(nc), only))


OPTIONS = (
    {"controller": "linuxcnc"},
    {"controller": "linuxcnc", "rtcp": "angles"},
    {"controller": "siemens840d", "rtcp": "vectors"},
    {"controller": "heidenhain", "rtcp": "angles"},
    {"controller": "fanuc", "rtcp": "angles"},
)


@pytest.mark.parametrize("start", [SafeStart(), SafeStart("machine", 200.0), SafeStart("reference")])
@pytest.mark.parametrize("options", OPTIONS, ids=lambda given: "-".join(given.values()))
def test_the_report_counts_the_moves_that_an_audit_of_the_file_counts(start, options, tmp_path):
    posted, audited = run(tmp_path, start, **options)
    ours, theirs = (summary(job.figures(one)) for one in (posted, audited))
    for letter, row in ours["axes"].items():
        for name in ("least", "largest", "travel"):
            assert row[name] == pytest.approx(theirs["axes"][letter][name], abs=2e-3), (letter, name)
    assert ours["rapid_length"] == pytest.approx(theirs["rapid_length"], abs=2e-3)


def test_the_plane_of_the_file_is_the_highest_z_and_the_report_says_from_where_it_counts(tmp_path):
    posted, audited = run(tmp_path, SafeStart(), controller="linuxcnc")
    figures = job.figures(posted)
    numbers, plane = summary(figures), float(posted.draft.nc.split(b"G0 Z")[-1].split()[0])
    words = posted.draft.program.words[:, 2]
    assert plane > words.max() + 1.0 and numbers["start_plane"] == plane == numbers["axes"]["Z"]["largest"]
    own = np.abs(np.diff(words)).sum()
    assert numbers["axes"]["Z"]["travel"] == pytest.approx(own + 2 * plane - words[0] - words[-1])
    for text in (as_html(figures), " ".join(as_text(figures).split())):
        assert f"count Z coming down from {plane:g} mm to the first block" in text
    text = " ".join(as_text(job.figures(audited)).split())
    assert "Where the axes stand before the first known position is not known" in text


def test_a_retract_to_a_machine_position_beyond_the_travel_is_a_warning(tmp_path):
    found = {}
    for z in (499.9, 500.5, -900.0):
        posted, _ = run(tmp_path, SafeStart("machine", z), controller="linuxcnc")
        found[z] = [one for one in posted.findings if one.code == "safe-start-beyond-limit"]
    assert found[499.9] == []
    (high,), (low,) = found[500.5], found[-900.0]
    assert high.severity is Severity.WARNING and high.value - high.limit == pytest.approx(0.5)
    assert low.value < low.limit and "another Z" in low.text
