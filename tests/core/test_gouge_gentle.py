# SPDX-License-Identifier: LGPL-2.1-or-later
"""Creased and gentle surfaces after the lift, by another library's distances: where little or nothing of the
path has to be lifted, the machine must not lead the cutter into the part between its rows either."""

import gouge_judge
import numpy as np
import pytest
from gouge_examples import relief
from mesh_shapes import field
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.toolpath.cl_path import Motion

TOLERANCE = 0.01
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "linearize": "on",
    "gouge": "lift",
    "tolerance": TOLERANCE,
}

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
"""Height and width, mm."""

BLOCKS = {f"{shape} {size}": (shape, *SIZES[size]) for shape in SHAPES for size in SIZES}

PATCHES = {
    **{f"{shape} {cutter} {machine}": (shape, 3.0, 4.0, cutter, 12, 0.5, 20, 1.5, machine)
       for machine, cutter in (("head_b_table_c", "bull:10:2:60"), ("trunnion_ac", "bull:20:4:60"), ("trunnion_ac", "ball:20:60"))
       for shape in SHAPES},
}  # fmt: skip
"""Shape, height and width, cutter, cells and their size, direction, stepover, machine. Without rows half-way
the cutter enters six of them by up to 0.034 mm, and nothing has to be lifted there."""


def first(table):
    """The names of a table as parameters: the first of each shape is of the slow ring, the others are of the
    large one besides."""
    shapes = [shape for shape, *_ in table.values()]
    return [
        pytest.param(name, marks=[pytest.mark.large] * (shapes[k] in shapes[:k]))
        for k, name in enumerate(table)
    ]


def milled(mesh, **options):
    return job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=mesh)


def judged(result):
    """The judge's verdict over all cuts."""
    cuts = np.flatnonzero(np.isin(result.program.motion[1:], (Motion.CUT, Motion.FILL)))
    assert len(cuts) > 10
    return gouge_judge.judged(
        result.mesh, result.settings.cutter.cutter, result.kinematics, result.program.words, cuts
    )


@pytest.mark.slow
@pytest.mark.parametrize("block", first(BLOCKS))
def test_no_cut_goes_deeper_into_a_creased_or_gentle_block_than_the_tolerance(block):
    shape, high, wide = BLOCKS[block]
    mesh = relief(lambda x, y: high * SHAPES[shape](x, y, wide), side=16.0, cells=16, floor=-40.0)
    found = judged(milled(mesh, cutter="ball:10:40", stepover=8, direction=20))
    assert found.worst <= TOLERANCE and found.dug <= TOLERANCE


@pytest.mark.slow
@pytest.mark.parametrize("patch", first(PATCHES))
def test_no_cut_goes_deeper_into_a_creased_or_gentle_patch_than_the_tolerance(patch):
    """Cutters whose edge swings far from the tip that is kept on its way."""
    shape, high, wide, cutter, cells, spacing, direction, stepover, machine = PATCHES[patch]
    mesh = from_triangles(field(cells, lambda x, y: high * SHAPES[shape](x, y, wide), spacing))
    result = milled(
        mesh, cutter=cutter, stepover=stepover, direction=direction, machine=machine, origin=(0.0, 0.0, 100.0)
    )
    assert judged(result).worst <= TOLERANCE
