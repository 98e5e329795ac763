# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another spindle speed for a proven program is the whole job with that speed, to the last byte and
finding."""

import numpy as np
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.new_speed import change_speed, without_speed
from freecad_fiveaxis.core.report import as_json

GABLE = from_faces(
    np.array([[x, y, z] for x in (0.0, 20.0) for y, z in ((0.0, 6.0), (10.0, 10.0), (20.0, 6.0), (20.0, 0.0), (0.0, 0.0))]),
    np.array([(0, 5, 6), (0, 6, 1), (1, 6, 7), (1, 7, 2), (2, 7, 8), (2, 8, 3), (3, 8, 9), (3, 9, 4), (4, 9, 5), (4, 5, 0),
              (0, 1, 2), (0, 2, 3), (0, 3, 4), (5, 7, 6), (5, 8, 7), (5, 9, 8)]),
)  # fmt: skip
SPEEDS = ({}, {"spindle": "off"}, {"spindle": 9000, "coolant": "on"})


def settings(controller: str, **options):
    given = {
        "machine": "trunnion_ac",
        "controller": controller,
        "cutter": "ball:6",
        "stepover": 6,
        "tool": 3,
        **options,
    }
    return build_settings("mill", "gable.stl", given)


@some_in_core("controller", DIALECTS, kept=(0, 2, 4, 6))
def test_a_new_speed_gives_the_bytes_and_the_report_of_the_whole_job(controller) -> None:
    whole = [job.prove(job.make(settings(controller, **speed), mesh=GABLE)) for speed in SPEEDS]
    reported = [as_json(job.figures(one)) for one in whole]
    assert len({one.draft.nc for one in whole}) == 2 and len(set(reported)) == 3
    for given in whole:
        for wanted, message in zip(whole, reported, strict=True):
            result = change_speed(given, wanted.draft.settings)
            assert result.draft.nc == wanted.draft.nc and result.findings == wanted.findings
            assert as_json(job.figures(result)) == message


def test_jobs_differ_in_their_heads_only_where_nothing_but_speed_and_coolant_differs() -> None:
    plain, fast = settings("fanuc"), settings("fanuc", **SPEEDS[2])
    assert plain != fast and without_speed(plain) == without_speed(fast)
    for other in ({"feed": 700}, {"tool": 4}, {"work_offset": "G55"}, {"stepover": 5}):
        assert without_speed(settings("fanuc", **other)) != without_speed(fast)
