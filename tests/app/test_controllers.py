# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every controller in the document: its properties, its guided output, and audits of programs of each."""

import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import controllers, results
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.controllers import DIALECTS

pytestmark = pytest.mark.usefixtures("kept")
EVERY = pytest.mark.parametrize("controller", list(DIALECTS))
PLANES = 2
"""The machine's safe start and end: one move of Z to the plane above the part before the path's blocks, and
one after."""
GUIDES = [(name, how) for name, dialect in DIALECTS.items() for how in dialect.guides]


@EVERY
def test_every_controller_writes_a_program_that_an_audit_reads_again(controller, doc, ball, tmp_path):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller=controller, tool=3)
    file = tmp_path / ("ball" + DIALECTS[controller].suffix)
    app.post_process(path, file)
    audit = app.audit(doc, file, "trunnion_ac", controller=controller)
    assert audit.Blocks == path.Blocks + PLANES and audit.Controller == controller
    assert audit.MaxSegmentDeviation.Value == pytest.approx(path.MaxSegmentDeviation.Value, abs=1e-9)


@pytest.mark.parametrize("controller", ["heidenhain", "siemens840d", "fanuc"])
def test_the_text_itself_says_whose_it_is(controller, doc, ball, tmp_path):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller=controller, tool=3)
    app.post_process(path, tmp_path / "ball.txt")
    audit = app.audit(doc, tmp_path / "ball.txt", "trunnion_ac")
    assert audit.Controller == "machine's own" and audit.Blocks == path.Blocks + PLANES


@pytest.mark.parametrize(("controller", "how"), GUIDES)
def test_a_guided_program_is_not_called_proven(controller, how, doc, ball):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller=controller, rtcp=how, tool=3)
    feeds = results.figures_of(path).program.guided.on.sum()
    assert 0 < path.GuidedBlocks <= feeds and not path.Proven
    assert "the path between them is under RTCP" in path.Verdict and path.Rtcp == how
    path.Rtcp = "off"
    doc.recompute()
    assert path.GuidedBlocks == 0 and "RTCP" not in path.Verdict


def test_what_a_controller_lacks_is_stated(doc, ball):
    for options, message in (
        ({"controller": "grbl", "rtcp": "angles"}, "does not guide the tip"),
        ({"controller": "haas", "rtcp": "vectors", "tool": 1}, "no RTCP by vectors"),
        ({"controller": "fanuc", "rtcp": "angles"}, "give --tool"),
        ({"controller": "mach3", "high_speed": "on"}, "no high-speed mode"),
        ({"controller": "heidenhain", "nc_units": "inch"}, "are in mm"),
        ({"controller": "haas", "rtcp": "angles", "linearize": "on"}, "give one"),
    ):
        with pytest.raises(FiveAxisError, match=message):
            app.create_toolpath(doc, ball, **FAST, **options)
    assert [obj.Name for obj in doc.Objects] == ["Ball"]


def test_the_high_speed_mode_stands_in_the_program(doc, ball):
    path = app.create_toolpath(
        doc, ball, **{**FAST, "stepover": 8}, controller="siemens840d", high_speed="on"
    )
    assert path.HighSpeed == "on" and b"CYCLE832" in results.nc_of(path)


def test_a_program_in_inches_says_so_and_the_path_keeps_what_it_is(doc, ball):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller="haas")
    assert path.ProgramUnits == "machine" and controllers.units_of_path(path) == (False, "G21")
    largest, before = path.MaxSurfaceDeviation, results.nc_of(path)
    path.ProgramUnits = "inch"
    doc.recompute()
    nc = results.nc_of(path)
    assert b"G20" in nc and b"G21" not in nc and controllers.units_of_path(path) == (True, "G20")
    assert float(path.MaxSurfaceDeviation) == pytest.approx(float(largest), abs=0.003) and nc != before


def test_a_guided_program_is_compared_and_clamped_as_any_other(doc, ball):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller="heidenhain", rtcp="angles")
    rows = app.compare(path, ["trunnion_ac"], ["none"])
    assert {row.tool_centre for row in rows} == {True, False} and not any(row.problem for row in rows)
    assert app.setup_map(path, region=(5, 0, 0), grid=(2, 1, 1)).Verdict
