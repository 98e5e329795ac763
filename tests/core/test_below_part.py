# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways between cuts that lead below the part are counted as there are in the finished path."""

from dataclasses import replace

import numpy as np
from mesh_shapes import box
from revolved import solid_of_revolution

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.passes import standing_facets
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.below_part import count_below_part
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

PART = from_triangles(box((0, 0, 0), (30, 20, 10)))
KNOB = solid_of_revolution([(0, 14), (16, 14), (16, 4), (9, 4), (9, 0), (0, 0)], 16)
SUSPECTED = report_finding(Code.RETRACT_BELOW_PART, "197 retracts.", 197.0)
OTHER = report_finding(Code.LIFTED, "Lifted.", 1.0)


def path_of(*rows):
    """A path of rows of a motion and the height of the tip, mm, with level axes."""
    count = len(rows)
    tip = np.array([(0.0, 0.0, z) for _, z in rows])
    axis, none = np.tile((1.0, 0.0, 0.0), (count, 1)), np.full(count, -1)
    motion = np.array([one for one, _ in rows], np.int8)
    return CLPath(tip, axis, motion, np.ones(count), tip, axis, none, none, none)


def test_a_stretch_below_the_part_counts_once_and_cuts_do_not():
    path = path_of(
        (Motion.RAPID, 15.0), (Motion.LINK, -8.0), (Motion.LINK, -9.0), (Motion.CUT, 0.0), (Motion.CUT, -4.0),
        (Motion.LINK, 5.0), (Motion.RAPID, -3.5), (Motion.LINK, -2.5), (Motion.CUT, 0.0),
    )  # fmt: skip
    other, one = count_below_part((OTHER, SUSPECTED), path, PART, 3.0, 3.0)
    assert other == OTHER and (one.code, one.value) == ("retract-below-part", 2.0)
    assert one.text.startswith("2 times") and one.place == (0.0, 0.0, -8.0)


def test_nothing_is_reported_where_links_near_the_part_took_their_place():
    path = path_of((Motion.RAPID, 15.0), (Motion.LINK, -2.0), (Motion.CUT, 0.0))
    assert count_below_part((OTHER, SUSPECTED), path, PART, 3.0, 3.0) == (OTHER,)
    assert count_below_part((OTHER,), path_of((Motion.LINK, -9.0)), PART, 3.0, 3.0) == (OTHER,)


def test_what_passes_beside_the_part_is_not_below_it():
    path = path_of((Motion.RAPID, 15.0), (Motion.LINK, -8.0), (Motion.CUT, 0.0))
    aside = replace(path, tip=path.tip - (8.0, 0.0, 0.0))
    assert count_below_part((SUSPECTED,), path, PART, 3.0, 3.0)
    assert not count_below_part((SUSPECTED,), aside, PART, 3.0, 3.0)


def test_a_program_tells_of_fewer_where_links_stay_near_the_part():
    """Under a knob on a foot, with its faces chosen, the tool looks down: laid over the part, 24 ways lead
    below it."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 1.5}
    faces = ~standing_facets(KNOB)
    draft = job.make(build_settings("mill", "part", options), mesh=KNOB, faces=faces)
    counted = [one.value for one in draft.findings if one.code == "retract-below-part"]
    (over,) = [one.value for one in draft.path.findings if one.code == "retract-below-part"]
    assert sum(counted) <= 1.0  # one or none, by the last digits of the field
    assert over > 10.0


def dips(mesh, **more):
    """What a job reports of the tool below what the part stands on, and its path."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 1.5} | more
    draft = job.make(build_settings("mill", "part", options), mesh=mesh)
    return [one for one in draft.findings if one.code == "dip-below-part"], draft.path


def test_beside_a_wall_the_end_of_the_cutter_dips_below_the_part_and_a_note_says_how_deep():
    (one,), path = dips(PART)
    low = (path.tip + 3.0 * path.axis)[:, 2].min() - 3.0
    assert one.severity == Severity.NOTE and one.limit == 3.0 and 2.0 < one.value <= 3.05
    assert abs(one.value + low) < 1e-9 and abs(one.place[2] - low) < 1e-9


def test_a_holder_that_goes_below_the_part_is_a_warning_with_its_depth():
    (one,), path = dips(PART, holder="40x30", shank="6x20", tool_axis="facet_mean")
    assert one.severity == Severity.WARNING and one.value > 3.05
    place, depth = path.tip + 76.0 * path.axis, 20.0 * np.sqrt(1.0 - path.axis[:, 2] ** 2)
    assert abs(one.value + (place[:, 2] - depth).min()) < 12.0 and "Raise the part" in one.text


def test_a_part_that_stands_on_nothing_or_is_cut_from_below_or_has_a_fixture_there_has_no_dip(tmp_path):
    turned = PART.vertex[PART.face] @ np.array([(0.8, 0, 0.6), (0, 1, 0), (-0.6, 0, 0.8)])
    assert not dips(from_triangles(turned))[0]
    assert not dips(PART, max_axis_angle=180)[0]
    write_stl(from_triangles(box((8, 6, -20), (22, 14, 0))), tmp_path / "rest.stl")
    assert not dips(PART, fixture=str(tmp_path / "rest.stl"))[0]
