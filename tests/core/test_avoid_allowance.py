# SPDX-License-Identifier: LGPL-2.1-or-later
"""The allowance on faces to avoid: by dense samples of the way that the machine goes the tool keeps off, and
cuts all else as before."""

import numpy as np
import pytest
from gouge_examples import step
from mesh_shapes import box
from plain import build_settings
from test_axis_field import NODES, take_nodes
from thorough import some_in_core

from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import find_rest_material, program_motion
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.passes.keep_off import KeepOff
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.avoided import check_keep_off
from freecad_fiveaxis.core.pipeline.collision_avoidance import cutting
from freecad_fiveaxis.core.pipeline.options import tip_to_driven
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.report.scope import scope
from freecad_fiveaxis.core.report.verdict import verdict
from freecad_fiveaxis.core.studies.study import try_reach
from freecad_fiveaxis.core.tool.body import body_of

TOLERANCE = 0.01
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:6",
    "scallop": 0.1,
    "linearize": "on",
}
PLATE = box((-10.0, -8.0, 0.0), (10.0, 8.0, 12.0))


def wall_of(mesh):
    """The facets of the step's wall, or of the floor beside it."""
    return (mesh.normal[:, 1] < -0.9) & (np.abs(mesh.vertex[mesh.face][..., 1]).max(axis=1) == 0.0)


def floor_of(mesh):
    return (mesh.normal[:, 2] > 0.9) & (np.abs(mesh.vertex[mesh.face][..., 2]).max(axis=1) == 0.0)


def side_of(mesh):
    """The plate's side at x = 10 mm."""
    return mesh.normal[:, 0] > 0.9


PARTS = {"wall": (step(), wall_of), "floor": (step(), floor_of), "plate": (from_triangles(PLATE), side_of)}


@pytest.fixture(scope="module")
def outcome(tmp_path_factory):
    """The proven program of a part some of whose faces are avoided."""
    folder = tmp_path_factory.mktemp("avoided")
    known = {}
    for name, (mesh, find) in PARTS.items():
        write_stl(mesh, folder / f"{name}.stl")
        write_stl(from_triangles(mesh.vertex[mesh.face[find(mesh)]]), folder / f"{name}_faces.stl")

    def run(name, allowance, **options):
        key = name, allowance, *sorted(options.items())
        if key not in known:
            given = {
                **OPTIONS,
                "avoid": str(folder / f"{name}_faces.stl"),
                "avoid_allowance": allowance,
                **options,
            }
            with pytest.MonkeyPatch.context() as patch:
                take_nodes(patch, NODES)
                known[key] = job.run(build_settings("mill", str(folder / f"{name}.stl"), given))
        return known[key]

    run.folder = folder
    return run


def nearest_way(result, name, many=60):
    """How near, mm, the middle of the ball comes to the avoided rectangle, by dense samples of the real way
    with all rapids."""
    mesh, find = PARTS[name]
    corner = mesh.vertex[mesh.face[find(mesh)]].reshape(-1, 3)
    program = result.draft.program
    q, u = words_to_q(program.words), np.linspace(0.0, 1.0, many)[:, None, None]
    tip, axis = forward(result.draft.kinematics, (q[:-1] * (1.0 - u) + q[1:] * u).reshape(-1, 5))
    centre = tip + 3.0 * axis
    out = np.maximum(np.maximum(corner.min(axis=0) - centre, centre - corner.max(axis=0)), 0.0)
    return float(np.linalg.norm(out, axis=1).min())


def codes(result):
    return [one.code for one in result.findings]


@pytest.mark.parametrize("axis", ["auto", "facet_mean"])
@some_in_core("name", list(PARTS), kept=(2,))
def test_on_its_real_way_the_ball_keeps_the_allowance_and_without_one_it_comes_nearer(outcome, name, axis):
    result = outcome(name, 1.0, tool_axis=axis)
    near = nearest_way(result, name)
    assert 4.0 - TOLERANCE <= near < 4.0 + 0.05, "and no farther off than it must"
    assert "avoided-faces-near" not in codes(result)
    assert nearest_way(outcome(name, 0.0, tool_axis=axis), name) < 3.0 + 0.05


@some_in_core("options", [
    {"passes": "planes", "stepover": 1.5}, {"passes": "zlevel", "stepover": 1.5}, {"passes": "frames", "tool_axis": "auto"}, {"spiral": "on", "passes": "scallop"},
    {"links": "over"}, {"lead_in": 1.0}, {"gouge": "tilt", "tool_axis": "facet_mean"}, {"gouge": "leave-out"}, {"rapids": "independent"},
    {"steep_shallow": np.radians(45.0)},
], ids=lambda given: "-".join(map(str, given.values())))  # fmt: skip
def test_whatever_lays_the_passes_and_links_them_the_allowance_is_kept(outcome, options):
    if "stepover" in options:
        options = {**options, "scallop": None}
    result = outcome("wall", 1.0, **options)
    assert 4.0 - TOLERANCE <= nearest_way(result, "wall", 20) < 4.2
    assert not {"avoided-faces-near", "avoided-faces-unproven", "overcut", "rapid-collision"} & set(
        codes(result)
    )


def test_which_places_the_ball_can_touch_is_what_the_exact_room_says():
    """Most places are told by the nearest piece alone; about the line where the room is 0 it is asked for."""
    mesh = step(6.0)
    keep_off = KeepOff.of(mesh, np.abs(mesh.normal[:, 1]) > 0.9, 1.0, 3.0)
    random = np.random.default_rng(2)
    facet = random.integers(len(mesh.face), size=4000)
    point = random.uniform((-20.0, -34.0, -12.0), (20.0, 34.0, 10.0), (4000, 3))
    room = keep_off.room(point + 3.0 * mesh.normal[facet])
    assert (np.abs(room) < 0.05).any() and (keep_off.allows(mesh, point, facet) == (room >= -1e-6)).all()
    assert 0.1 < (room >= 0.0).mean() < 0.9


def heights(result, mesh, some):
    """What is left, mm, at places far enough from the faces, and where."""
    program, settings = result.draft.program, result.draft.settings
    swept = program_motion(result.draft.kinematics, program, tip_to_driven(settings))
    body = body_of(settings.cutter.cutter)
    keep_off = KeepOff.of(mesh, some, 1.0, 3.0)

    def counts(point, facet):
        return keep_off.allows(mesh, point, facet)

    return find_rest_material(
        mesh, body, swept, cutting(program.motion), 0.7, result.draft.keep & ~some, counts=counts
    ).height


@pytest.mark.thorough
@some_in_core("name", list(PARTS))
def test_everywhere_else_it_cuts_as_before(outcome, name):
    mesh, find = PARTS[name]
    with_room, without = (
        heights(outcome(name, room, tool_axis="auto", passes="scallop"), mesh, find(mesh))
        for room in (1.0, 0.0)
    )
    finished = [float(np.mean(one <= 0.2 + TOLERANCE)) for one in (with_room, without)]
    assert finished[0] > 0.985 and finished[0] > finished[1] - 0.01


@pytest.mark.thorough
@pytest.mark.oldest
def test_the_strip_is_reported_with_its_area_and_the_verdict_names_it(outcome):
    """4 mm of the floor 40 mm long, and of shelf and ends where the ball over them is no more than 4 mm from
    the wall."""
    result = outcome("wall", 1.0, tool_axis="facet_mean")
    (strip,) = [one for one in result.findings if one.code == "near-avoided-faces"]
    aside = np.sqrt(4.0**2 - 3.0**2)
    end = 6.0 * aside + 0.5 * np.pi * aside**2
    assert strip.value == pytest.approx(40.0 * (4.0 + aside) + 2.0 * end, rel=0.03)
    figures = job.figures(result)
    assert "beside the faces to avoid" in " ".join(map(str, verdict(figures, summary(figures)).reasons))
    assert any(
        "keep 1 mm off the faces to avoid" in str(one) for one in scope(figures, summary(figures)).proven
    )
    assert "near-avoided-faces" not in codes(outcome("wall", 0.0, tool_axis="auto"))


@pytest.mark.thorough
def test_shank_and_holder_keep_off_too(outcome):
    """A holder as wide as it is near: upright over the floor it stands beside the wall's top."""
    options = {
        "cutter": "ball:6:4",
        "holder": ((24.0, 20.0),),
        "tool_axis": "facet_mean",
        "max_axis_angle": np.radians(30.0),
    }
    result = outcome("wall", 1.0, **options)
    result_ = result.draft
    assert not {"avoided-faces-near"} & set(codes(result))
    q, u = words_to_q(result_.program.words), np.linspace(0.0, 1.0, 40)[:, None, None]
    tip, axis = forward(result_.kinematics, (q[:-1] * (1.0 - u) + q[1:] * u).reshape(-1, 5))
    beside = (np.abs(axis[:, 2] - 1.0) < 1e-9) & (tip[:, 2] + 4.0 < 6.0)
    assert beside.any() and tip[beside, 1].max() <= -13.0 + TOLERANCE
    assert outcome("wall", 0.0, **options).draft.program.words[:, 1].max() is not None


def test_the_proof_finds_a_program_that_comes_nearer(outcome):
    """The program without an allowance, looked at with one."""
    result = outcome("wall", 0.0, tool_axis="auto")
    context = result.draft.context(silent)
    mesh, find = PARTS["wall"]
    object.__setattr__(context, "keep_off", KeepOff.of(mesh, find(mesh), 1.0, 3.0))
    (found,) = check_keep_off(context, result.draft.program)
    assert found.code == "avoided-faces-near" and found.severity.name == "ERROR"
    assert found.value == pytest.approx(nearest_way(result, "wall") - 3.0, abs=0.05)
    assert "1 mm are asked for" in str(found.text)


@pytest.mark.thorough
def test_an_allowance_of_nothing_gives_the_same_bytes(outcome, tmp_path):
    part, faces = (str(outcome.folder / name) for name in ("wall.stl", "wall_faces.stl"))
    given = [
        "mill",
        part,
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "--scallop",
        "0.5",
        "--avoid",
        faces,
        "--quiet",
    ]
    for name, more in (("one", []), ("two", ["--avoid-allowance", "0"])):
        assert main([*given, *more, "-o", str(tmp_path / f"{name}.ngc")]) in (0, 1)
    assert (tmp_path / "one.ngc").read_bytes() == (tmp_path / "two.ngc").read_bytes()


@pytest.mark.parametrize(("allowance", "avoid", "message"), [
    ("-1", True, "avoid-allowance"), ("500", True, "larger than the part"), ("1", False, "there are none: give them with --avoid"),
    ("nan", True, "avoid-allowance"), ("59", True, "nothing of what is to be machined can be cut"),
])  # fmt: skip
@pytest.mark.parametrize("task", ["mill", "reach"])
def test_bad_allowances_are_refused_in_one_line_and_leave_no_file(
    outcome, tmp_path, capsys, allowance, avoid, message, task
):
    part, faces = (str(outcome.folder / name) for name in ("wall.stl", "wall_faces.stl"))
    given = [task, part, "--machine", "trunnion_ac", "--cutter", "ball:6", f"--avoid-allowance={allowance}"]
    given += ["--avoid", faces] if avoid else []
    out = tmp_path / "out.ngc"
    assert main([*given, *(["-o", str(out)] if task == "mill" else [])]) == 2
    err = capsys.readouterr().err
    assert message in err and len(err.strip().splitlines()) <= 3 and not out.exists()


def test_cutters_with_a_ring_keep_off_with_the_whole_of_it(outcome):
    result = outcome("wall", 1.0, cutter="bull:8:1", tool_axis="facet_mean", max_axis_angle=np.radians(30.0))
    result_ = result.draft
    q, u = words_to_q(result_.program.words), np.linspace(0.0, 1.0, 40)[:, None, None]
    tip, axis = forward(result_.kinematics, (q[:-1] * (1.0 - u) + q[1:] * u).reshape(-1, 5))
    upright = (np.abs(axis[:, 2] - 1.0) < 1e-9) & (tip[:, 2] < 5.0)
    assert upright.any() and -9.0 < tip[upright, 1].max() <= -5.0 + TOLERANCE
    assert "avoided-faces-near" not in codes(result)


def test_reach_leaves_out_what_the_cutter_cannot_touch_for_the_allowance(outcome):
    part, faces = (str(outcome.folder / name) for name in ("wall.stl", "wall_faces.stl"))
    given = {"machine": "trunnion_ac", "cutter": "ball:6", "avoid": faces}
    plain, trial = (
        try_reach(build_settings("reach", part, {**given, "avoid_allowance": room})) for room in (0.0, 1.0)
    )
    assert [one.code for one in trial.findings if "avoided" in one.code] == [
        "faces-avoided",
        "near-avoided-faces",
    ]
    point = trial.found.point
    on_floor = (point[:, 2] == 0.0) & (point[:, 1] < 0.0)
    assert (
        point[on_floor, 1].max() <= -4.0 and plain.found.point[plain.found.point[:, 2] == 0.0, 1].max() > -1.0
    )
