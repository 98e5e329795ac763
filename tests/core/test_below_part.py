# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways between cuts that lead below the part are counted as there are in the finished path."""

from dataclasses import replace

import numpy as np
from mesh_shapes import box
from revolved import solid_of_revolution

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.below_part import count_below_part
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

PART = from_triangles(box((0, 0, 0), (30, 20, 10)))
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
    """Under a knob on a foot the tool looks down: laid over the part, 24 ways lead below it."""
    knob = solid_of_revolution([(0, 14), (16, 14), (16, 4), (9, 4), (9, 0), (0, 0)], 16)
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 1.5}
    draft = job.make(build_settings("mill", "part", options), mesh=knob)
    counted = [one.value for one in draft.findings if one.code == "retract-below-part"]
    assert (
        counted == [1.0]
        and [one.value for one in draft.path.findings if one.code == "retract-below-part"] > counted
    )
