# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the first sentence of a comparison says: why nothing holds, what every way leaves out, and which entry
is the deepest."""

from dataclasses import replace

import pytest
from mesh_shapes import box

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.studies.compare.beside_part import find_deepest
from freecad_fiveaxis.core.studies.compare.stations import Row
from freecad_fiveaxis.core.studies.compare.words import headline
from freecad_fiveaxis.core.studies.compare_beside import report_entries
from freecad_fiveaxis.core.studies.study import try_machines

ROW = Row("trunnion", "none", False, tuple("XYZAC"), deviation=0.004, bound=0.005, axis_deviation=0.0, blocks=10, feed_blocks=9, time=60.0,
          peak_rate=(1.0,) * 5, over=0.0, part=())  # fmt: skip
DEEP = report_finding(Code.OVERCUT, "5 mm deep.", 5.0)
WHOLE = report_finding(Code.BURIED, "The whole cutter.", 2)
NEAR = report_finding(Code.AVOIDED_FACES_NEAR, "Too near.", 9.0)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([ROW, ROW], "2 of 2 ways hold 0.01 mm"),
        ([replace(ROW, bound=0.05)], "Nothing here holds 0.01 mm within the limits of its machine."),
        ([replace(ROW, part=(DEEP,))], "within the limits of its machine, stays out of the part and cuts"),
        ([replace(ROW, bound=0.05, left_out=0.1), replace(ROW, left_out=0.5)], "cuts as much as the others"),
        ([replace(ROW, left_out=0.4), replace(ROW, left_out=0.4)], "at least 40 % of the surface"),
    ],
)
def test_the_reason_is_that_which_is_true(rows, words):
    assert words in headline(rows, 0.01)


def test_where_a_way_cuts_all_no_share_is_given():
    assert "leaves out" not in headline([ROW, replace(ROW, left_out=0.4)], 0.01)


def test_what_the_controller_cannot_do_is_not_the_quickest_way():
    guided = replace(ROW, cure="minimax", tool_centre=True, time=50.0, imagined="mach3")
    text = headline([ROW, guided, replace(guided, time=55.0)], 0.01)
    assert text.startswith(
        "3 of 3 ways hold 0.01 mm; the quickest is trunnion with no correction, 1 min 00 s."
    )
    assert text.endswith("In 2 of these the controller would have to guide the tip, which mach3 cannot.")
    able = headline([ROW, guided, replace(guided, imagined="")], 0.01)
    assert "the quickest is trunnion with minimax, tool-centre control" in able
    assert (
        "In 1 of these the controller guides the tip" in able and "In 1 of these the controller would" in able
    )


def test_a_row_says_whether_its_controller_can_guide_the_tip():
    options = {"machines": "trunnion_ac", "cutter": "ball:6", "stepover": 6.0, "cures": "none"}
    for controller, name in (("mach3", "mach3"), ("linuxcnc", "")):
        settings = build_settings("compare", "part", options | {"controller": controller})
        rows = try_machines(settings, mesh=from_triangles(box((0, 0, 0), (20, 20, 8)))).rows
        assert {row.tool_centre: row.imagined for row in rows} == {False: "", True: name}


@pytest.mark.parametrize("found", [(WHOLE, DEEP, NEAR), (DEEP, NEAR), (NEAR,)])
def test_the_deepest_entry_is_one_of_the_whole_cutter_and_the_distance_to_faces_is_none(found):
    assert find_deepest(found[::-1]) is found[0]
    rows = [replace(ROW, machine=str(at), part=(one,)) for at, one in enumerate(found[::-1])]
    assert found[0].text in next(report_entries(rows)).text


def test_where_no_axis_is_free_for_a_fixture_in_the_part_that_is_the_message():
    part, stock = (from_triangles(box((-by, -by, 0), (20 + by, 20 + by, 8 + by))) for by in (0, 3))
    settings = build_settings("mill", "part", {"machine": "trunnion_ac", "cutter": "ball:6", "scallop": 0.3})
    with pytest.raises(ReachError, match="stock stands in the part"):
        job.make(settings, mesh=part, fixtures=(Fixture("stock", stock),))
