# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merged rows through the pipeline: fewer blocks, all proofs within what is asked for; what does not crowd
gives the program that it gave before."""

import numpy as np
import pytest
from plain import build_settings

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.pipeline import build_path, job, merged
from freecad_fiveaxis.core.toolpath.cl_path import Motion

TOLERANCE = 0.01
OPTIONS = {
    "machine": "trunnion_ac", "cutter": "ball:6", "passes": "planes", "stepover": 1.5, "gouge": "report",
    "tool_axis": "facet_mean",
}  # fmt: skip


def wave(count):
    """A cylindrical wave of 12 x 3 mm, ``count`` facets long and two wide."""
    x = np.linspace(0.0, 12.0, count + 1)
    grid = np.stack(
        [np.stack([x, np.full_like(x, y), np.sin(x / 2.0)], axis=1) for y in (0.0, 1.5, 3.0)], axis=1
    )
    at = np.arange(3 * (count + 1)).reshape(-1, 3)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    face = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return from_faces(grid.reshape(-1, 3), face)


def mill(folder, count, **options):
    stl = folder / f"wave{count}.stl"
    write_stl(wave(count), stl)
    return job.run(build_settings("mill", str(stl), {**OPTIONS, **options}))


def codes(result):
    return {one.code for one in result.findings}


def unmerged(context, seated, axis):
    return seated, axis, 0.0


@pytest.mark.parametrize("tool_axis", ["facet_mean", pytest.param("auto", marks=pytest.mark.thorough)])
def test_a_fine_mesh_takes_fewer_blocks_and_keeps_what_is_proven(tmp_path, monkeypatch, tool_axis):
    fine = mill(tmp_path, 400, tool_axis=tool_axis)
    monkeypatch.setattr(build_path, "merge_crowded_rows", unmerged)
    whole = mill(tmp_path, 400, tool_axis=tool_axis)
    assert Code.ROWS_MERGED in codes(fine) and Code.ROWS_MERGED not in codes(whole)
    assert codes(fine) - {Code.ROWS_MERGED, Code.LINEARIZED, Code.ROTARY_WORDS_EVEN} <= codes(whole)
    assert len(fine.draft.program.words) < 0.5 * len(whole.draft.program.words)
    assert not fine.gouge.cutter.depth.any()
    fed = fine.draft.program.motion != Motion.RAPID
    assert fine.surface.bound[fed].max() <= (1.0 - merged.OFF) * TOLERANCE + 1e-4  # a word's last digit


def test_a_coarse_mesh_gives_the_same_program_to_the_byte(tmp_path, monkeypatch):
    given = mill(tmp_path, 20)
    monkeypatch.setattr(build_path, "merge_crowded_rows", unmerged)
    assert mill(tmp_path, 20).draft.nc == given.draft.nc
