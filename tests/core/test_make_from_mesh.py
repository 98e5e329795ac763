# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh at hand is milled like its file, and faces can be chosen."""

import numpy as np
import pytest
from plain import build_settings

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces, read_stl, write_stl
from freecad_fiveaxis.core.pipeline import job

OPTIONS = {"machine": "trunnion_ac", "cutter": "ball:4", "stepover": 2.0}


@pytest.fixture
def block() -> Mesh:
    """A block of 20 x 20 x 10 mm with a roof of two slopes: facets 0 and 1 are the slope towards -y, 2 and 3
    towards +y."""
    vertex = [
        [x, y, z]
        for x in (0.0, 20.0)
        for y, z in ((0.0, 10.0), (10.0, 14.0), (20.0, 10.0), (20.0, 0.0), (0.0, 0.0))
    ]
    quads = [(0, 5, 6, 1), (1, 6, 7, 2), (2, 7, 8, 3), (3, 8, 9, 4), (4, 9, 5, 0)]
    face = [facet for a, b, c, d in quads for facet in ((a, b, c), (a, c, d))]
    face += [(0, 1, 2), (0, 2, 3), (0, 3, 4), (5, 7, 6), (5, 8, 7), (5, 9, 8)]
    return from_faces(np.array(vertex), np.array(face))


def test_a_mesh_at_hand_gives_the_bytes_of_its_file_whatever_the_name(block, tmp_path) -> None:
    write_stl(block, tmp_path / "a.stl")
    from_file = job.make(build_settings("mill", str(tmp_path / "a.stl"), OPTIONS))
    at_hand = job.make(build_settings("mill", "elsewhere.stl", OPTIONS), mesh=read_stl(tmp_path / "a.stl"))
    assert isinstance(from_file, job.PostedProgram) and isinstance(at_hand, job.PostedProgram)
    assert from_file.nc == at_hand.nc and b"a.stl" not in from_file.nc


def test_only_the_chosen_facets_are_cut(block) -> None:
    settings = build_settings("mill", "block.stl", OPTIONS)
    chosen = np.arange(len(block.face)) < 2
    draft = job.make(settings, mesh=block, faces=chosen)
    whole = job.make(settings, mesh=block)
    assert isinstance(draft, job.MilledProgram) and isinstance(whole, job.MilledProgram)
    assert set(np.unique(draft.offset.face)) == {0, 1}
    assert set(np.unique(whole.offset.face)) > {0, 1, 2, 3}
    assert not [finding for finding in draft.findings if finding.code == "facets-looking-down"]


def test_a_choice_that_cannot_be_cut_is_refused(block) -> None:
    bottom = block.normal[:, 2] < -0.5
    assert bottom.any()
    with pytest.raises(ReachError, match="no facet"):
        job.make(build_settings("mill", "block.stl", OPTIONS), mesh=block, faces=bottom)
