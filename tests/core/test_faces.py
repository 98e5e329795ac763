# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets of a part that lie on faces from another file: flat and curved, in other facets, and what is
refused."""

import itertools
import json

import numpy as np
import pytest
from gouge_examples import round_groove, step
from plain import build_settings

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.faces import facet_sags, facets_on
from freecad_fiveaxis.core.pipeline import job


def floor(y0, y1, n=3, x0=-20.0, x1=20.0, z=0.0):
    """A level face in n x n squares, looking up."""
    x, y = np.linspace(x0, x1, n + 1), np.linspace(y0, y1, n + 1)
    outcome = []
    for a, b in itertools.pairwise(x):
        for c, d in itertools.pairwise(y):
            outcome += [[(a, c, z), (b, c, z), (b, d, z)], [(a, c, z), (b, d, z), (a, d, z)]]
    return from_triangles(np.array(outcome))


def test_a_face_in_other_facets_chooses_the_facets_that_lie_on_it_and_no_others():
    mesh = step()
    chosen, (message,) = facets_on(mesh, floor(-30, 0), 0.01)
    flat = (np.abs(mesh.vertex[mesh.face][..., 2]).max(axis=1) == 0.0) & (mesh.normal[:, 2] > 0.9)
    assert (chosen == flat).all() and chosen.any()
    assert message.code == "faces-chosen" and message.value == pytest.approx(mesh.area[flat].sum())


def test_a_face_that_covers_half_a_facet_does_not_choose_it_and_says_so():
    mesh = step()
    both = from_triangles(
        np.concatenate([part.vertex[part.face] for part in (floor(-30, 0), floor(0, 15, z=6.0))])
    )
    chosen, message = facets_on(mesh, both, 0.01)
    assert (mesh.vertex[mesh.face[chosen]][..., 2] == 0.0).all()
    assert [one.code for one in message] == ["faces-chosen", "faces-missed"] and message[
        1
    ].value == pytest.approx(15 * 40)


@pytest.mark.parametrize("steps", [16, 40, 200])
def test_a_curved_face_is_found_though_its_facets_are_coarser_or_finer(steps):
    mesh, other = round_groove(5.0, 64), round_groove(5.0, steps)
    curved = (other.normal[:, 2] > 1e-3) & (other.vertex[other.face][..., 2].min(axis=1) < -1e-9)
    chosen, _ = facets_on(mesh, from_triangles(other.vertex[other.face[curved]]), 0.01)
    wanted = (mesh.normal[:, 2] > 1e-3) & (mesh.vertex[mesh.face][..., 2].min(axis=1) < -1e-9)
    assert (chosen == wanted).all() and wanted.sum() > 100


def test_the_sag_is_that_of_the_arc_and_an_edge_has_none():
    mesh = round_groove(5.0, 64, length=0.2)
    curved = (
        (mesh.vertex[mesh.face][..., 2].min(axis=1) < -1e-9)
        & (np.abs(mesh.normal[:, 0]) < 0.5)
        & (mesh.normal[:, 2] > 0.1)
    )
    chord = 2.0 * 5.0 * np.sin(np.pi / 128.0)
    arc = 5.0 - 5.0 * np.cos(np.pi / 128.0)
    assert facet_sags(mesh)[curved] == pytest.approx(arc * np.hypot(chord, 0.2) / chord, rel=1e-3)
    assert facet_sags(step()).max() == 0.0


def test_what_lies_elsewhere_is_refused_with_the_remedy():
    with pytest.raises(SettingsError, match="no facet of the part lies on"):
        facets_on(step(), floor(-30, 0, z=0.5), 0.01)
    with pytest.raises(SettingsError, match="no facet of the part lies on"):
        facets_on(step(), floor(300, 330), 0.01)
    wrong = floor(-30, 0)
    with pytest.raises(SettingsError, match="look into it"):
        facets_on(step(), from_triangles(wrong.vertex[wrong.face[:, ::-1]]), 0.01)


def test_a_larger_tolerance_finds_what_is_a_little_off():
    assert facets_on(step(), floor(-30, 0, z=0.05), 0.06)[0].any()


@pytest.fixture
def files(tmp_path):
    write_stl(step(), tmp_path / "part.stl")
    write_stl(floor(-30, 0), tmp_path / "floor.stl")
    write_stl(floor(-30, 0, z=5.0), tmp_path / "off.stl")
    return tmp_path


def test_only_the_faces_are_machined_and_the_wall_beside_them_is_still_kept_clear_of(files):
    options = {
        "machine": "trunnion_ac",
        "cutter": "ball:8",
        "stepover": 2,
        "gouge": "leave-out",
        "rest": "on",
    }
    options |= {"tool_axis": "fixed", "linearize": "on"}
    settings = build_settings("mill", str(files / "part.stl"), {**options, "faces": str(files / "floor.stl")})
    result = job.run(settings)
    outcome = result.draft
    assert set(outcome.offset.face) <= set(np.flatnonzero(outcome.keep)) and result.rest is not None
    assert set(result.rest.facet) == set(np.flatnonzero(outcome.keep)) and outcome.keep.sum() == 2
    codes = {one.code for one in result.findings}
    assert {"faces-chosen", "left-out"} <= codes and not codes & {"overcut", "rapid-collision"}
    assert (
        outcome.path.tip[outcome.path.motion == 0][:, 1].max() < -4.0 + 0.1
    )  # the wall stands at y = 0, the ball has radius 4


def test_faces_to_be_avoided_are_not_machined_and_the_others_are(files):
    options = {
        "machine": "trunnion_ac",
        "cutter": "ball:8",
        "stepover": 4,
        "passes": "planes",
        "max_axis_angle": 30,
    }
    part = str(files / "part.stl")
    whole, some = (
        job.make(build_settings("mill", part, {**options, **more}))
        for more in ({}, {"avoid": str(files / "floor.stl")})
    )
    lost = np.setdiff1d(np.flatnonzero(whole.keep), np.flatnonzero(some.keep))
    assert (
        len(lost) == 2 and (some.mesh.vertex[some.mesh.face[lost]][..., 2] == 0.0).all() and some.keep.any()
    )
    reported = next(one for one in some.findings if one.code == "faces-avoided")
    assert reported.value == pytest.approx(some.mesh.area[lost].sum()) and "are not machined" in reported.text
    with pytest.raises(
        SettingsError, match=r"all that is to be machined lies on floor\.stl; leave out --avoid"
    ):
        both = {"faces": str(files / "floor.stl"), "avoid": str(files / "floor.stl")}
        job.make(build_settings("mill", part, {**options, **both}))


def test_on_the_command_line_and_in_job_files(files, capsys):
    common = ["--machine", "trunnion_ac", "--cutter", "ball:8", "--stepover", "6", "--passes", "planes"]
    out = str(files / "a.ngc")
    part, faces = str(files / "part.stl"), str(files / "floor.stl")
    assert main(["mill", part, *common, "--faces", faces, "-o", out]) == 0
    assert "lie on floor.stl and are machined" in " ".join(capsys.readouterr().out.split())
    options = {
        "machine": "trunnion_ac",
        "cutter": "ball:8",
        "stepover": 6,
        "passes": "planes",
        "faces": "floor.stl",
    }
    (files / "job.json").write_text(
        json.dumps({"task": "mill", "source": "part.stl", "output": "b.ngc", **options})
    )
    assert main(["run", str(files / "job.json"), "--quiet"]) == 0
    assert (files / "a.ngc").read_bytes() == (files / "b.ngc").read_bytes()


def test_faces_that_do_not_fit_end_with_exit_2_and_no_file(files, capsys):
    given = ["mill", str(files / "part.stl"), "--machine", "trunnion_ac", "-o", str(files / "a.ngc")]
    assert main([*given, "--faces", str(files / "off.stl")]) == 2
    assert "no facet of the part lies on off.stl" in capsys.readouterr().err
    assert main([*given, "--faces", str(files / "nowhere.stl")]) == 2
    assert (
        main(["mill", *given[1:-1], str(files / "floor.stl"), "--faces", str(files / "floor.stl")]) == 2
    )  # would be written over
    assert not (files / "a.ngc").exists()


def test_a_cl_file_has_no_faces():
    with pytest.raises(SettingsError, match="need the part"):
        build_settings("setup", "path.apt", {"machine": "trunnion_ac", "faces": "floor.stl"})
