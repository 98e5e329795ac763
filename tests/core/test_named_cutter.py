# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter that a program names: what our posts write is read again, and nothing else is taken for one."""

import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.tool import parse_cutter

CUTTERS = (
    "ball:10",
    "ball:3.175",
    "flat:10",
    "bull:10:2",
    "taperball:6:5deg",
    "taperbull:10:1:5deg",
    "lollipop:10:6",
)


def posted(**options):
    given = {
        "machine": "trunnion_ac",
        "tool_length": 120,
        "stepover": 4,
        "gouge": "off",
        "linearize": "off",
        **options,
    }
    return job.make(
        build_settings("mill", "part", given), mesh=from_triangles(box((-10, -10, 0), (10, 10, 10)))
    ).nc


@pytest.mark.parametrize("cutter", CUTTERS)
def test_what_a_post_writes_is_read_again(cutter):
    wanted = parse_cutter(cutter)
    found = find_named_cutter(posted(cutter=cutter, tool=3))
    assert (found.diameter, found.corner, found.ring) == (wanted.diameter, wanted.corner, wanted.ring)
    assert found.taper == pytest.approx(wanted.taper)


@pytest.mark.parametrize("controller", sorted(DIALECTS))
def test_every_controllers_head_names_it(controller):
    assert find_named_cutter(posted(cutter="ball:6", controller=controller)) == parse_cutter("ball:6")


@pytest.mark.parametrize(
    "text",
    [b"", b"G1 X1 F100\n", b"(BALL)\n", b"(BALL 10 MM OR SO)\n", b"(BALL 10 IN)\n", b"(T1 BALL 10 MM)\n(T2 BALL 6 MM)\n",
     b"(BALL 0 MM)\n", b"(BALL 1.2.3 MM)\n", b"(NO BALL 10 MM)\n", b"(BALL 10 MM, CENTRE DRIVEN)\n"],
)  # fmt: skip
def test_nothing_else_is_taken_for_one(text):
    assert find_named_cutter(text) is None


def test_where_the_centre_is_driven_the_head_says_so_and_no_audit_takes_it_for_the_tip():
    text = posted(cutter="ball:6", control_point="centre")
    assert b"BALL 6 MM, CENTRE DRIVEN, L 120.000" in text and find_named_cutter(text) is None


def test_an_audit_without_a_cutter_takes_the_programs_and_says_so(tmp_path):
    (tmp_path / "a.ngc").write_bytes(posted(cutter="ball:6", linearize="on"))

    def audited(**options):
        return job.run(
            build_settings("audit", str(tmp_path / "a.ngc"), {"machine": "trunnion_ac", **options})
        )

    taken, given = audited(), audited(cutter="ball:8")
    assert taken.draft.settings.cutter.cutter.diameter == 6 and taken.surface.segment.max() > 0.0
    assert [one.code for one in taken.findings].count("cutter-from-program") == 1
    assert given.draft.settings.cutter.cutter.diameter == 8
    assert "cutter-from-program" not in {one.code for one in given.findings}
