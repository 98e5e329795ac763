# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creased and gentle surfaces after the lift, by another library's distances: where little or nothing of the path has to be
lifted, the machine must not lead the cutter into the part between its rows either."""

import gouge_judge
import numpy as np
import pytest
from gouge_examples import relief

from freecad_fiveaxis.core import job
from freecad_fiveaxis.core.cl_path import Motion
from freecad_fiveaxis.core.settings import build_settings

TOLERANCE = 0.01
OPTIONS = {"machine": "trunnion_ac", "tool_length": 120, "linearize": "on", "gouge": "lift", "tolerance": TOLERANCE}

SHAPES = {
    "ridges": lambda x, y, w: abs(np.sin(x / w)),
    "troughs": lambda x, y, w: -abs(np.sin(x / w)),
    "waves": lambda x, y, w: np.sin(x / w),
    "hills": lambda x, y, w: np.cos(x / w) * np.cos(y / w),
    "roof": lambda x, y, w: -abs(x / w),
    "valley": lambda x, y, w: abs(x / w),
    "saddle": lambda x, y, w: (x * x - y * y) / (w * w) / 4.0,
    "cap": lambda x, y, w: -(x * x + y * y) / (w * w) / 4.0,
    "twist": lambda x, y, w: x * y / (w * w) / 4.0,
}
SIZES = {"low": (1.0, 4.0), "long": (2.0, 8.0), "steep": (5.0, 4.0)}
CUTTERS = {"ball 10": "ball:10:40", "ball 6": "ball:6:40"}

SURFACES = {
    f"{shape} {size} {cutter}": (shape, *SIZES[size], CUTTERS[cutter])
    for shape in SHAPES for size in SIZES for cutter in CUTTERS
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("surface", SURFACES)
def test_no_cut_goes_deeper_into_a_creased_or_gentle_surface_than_the_tolerance(surface):
    shape, high, wide, cutter = SURFACES[surface]
    mesh = relief(lambda x, y: high * SHAPES[shape](x, y, wide), side=20.0, cells=20, floor=-40.0)
    made = job.make(build_settings("mill", "part", {**OPTIONS, "cutter": cutter, "stepover": 5, "direction": 20}), mesh=mesh)
    cuts = np.flatnonzero(np.isin(made.program.motion[1:], (Motion.CUT, Motion.FILL)))
    found = gouge_judge.judged(mesh, made.settings.cutter.cutter, made.links, made.program.words, cuts)
    assert len(cuts) > 20 and found.worst <= TOLERANCE and found.dug <= TOLERANCE
