# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where bodies of a machine's file are drawn: by the joints' own turns, in the machine's frame, on machines
of five kinds."""

from dataclasses import replace

import numpy as np
import pytest
from five_kinds import KINDS
from mesh_shapes import box
from scipy.spatial.distance import cdist
from test_body_pairs import places
from test_machine_bodies import EXAMPLE, LENGTH, MACHINES, ORIGIN, carriers, frames

from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.geometry.solids import frustum_facets
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.report import standing_bodies
from freecad_fiveaxis.core.report.machine_sketch import ToolRoom, sketch
from freecad_fiveaxis.core.report.playback import placements
from freecad_fiveaxis.core.report.standing_bodies import find_edges, leave_out, stand_bodies

SETUP = Setup(ORIGIN, LENGTH)
PART = np.array([-30.0, -20.0, -5.0]), np.array([42.0, 25.0, 28.0])


def with_bodies(name, head=False):
    """The machine with a box on each carrier, those of the ``head`` too, and a cone on the spindle."""
    plain = Machine(name, KINDS[name]) if name in KINDS else load_machine(name)
    on = [*carriers(plain), *(axis.letter for axis in plain.fitted if head and axis.side == "head")]
    boxes = [MachineBody(f"on {one}", one, "box", ((-30.0, -20.0, -60.0), (10.0, 40.0, 15.0))) for one in on]
    low = np.array(plain.gauge_point)
    nose = MachineBody("nose", "spindle", "cone", (tuple(low), tuple(low + (0.0, 0.0, 60.0))), (35.0, 50.0))
    return replace(plain, bodies=(*boxes, nose))


def move(place, points):
    return points @ place[:3, :3].T + place[:3, 3]


def drawn_and_true(name):
    """Of every body at random words: its vertices as drawn, and as the joints carry them, both in the
    picture's frame."""
    machine = with_bodies(name, head=True)
    kinematics = chain(machine, SETUP)
    gauge = np.array(machine.gauge_point)
    shift = np.linalg.solve(kinematics.direction[:3].T, np.array(ORIGIN) - (gauge - (0.0, 0.0, LENGTH)))
    rng = np.random.default_rng(3)
    words = np.concatenate([rng.uniform(-80, 80, (6, 3)), rng.uniform(-100, 100, (6, 2))], axis=1)
    words[:, [not axis.fitted for axis in kinematics.axes]] = 0.0
    carried = placements(kinematics, words)["machine_from_carried"]
    joints = [
        dict(zip(kinematics.letters, word + np.concatenate([shift, (0, 0)]), strict=True))
        for word in [np.zeros(5), *words]
    ]
    innermost = (*carriers(machine)[1:], "base")[0]
    zero = move(frames(machine, joints[0])[0][innermost], np.array(ORIGIN)[None])[0]
    for at, q in enumerate(joints[1:]):
        found, tool = places(machine, q), frames(machine, q)[1]
        for body, stand in zip(machine.bodies, stand_bodies(machine, SETUP, kinematics, LENGTH), strict=True):
            points = np.array(body.points)
            if body.carrier == "spindle":
                facets, true = frustum_facets(*points, *body.radii), tool
            else:
                facets, true = box(*points), found[body.carrier]
            here = np.eye(4) if stand.carrier is None else carried[at, stand.carrier]
            assert stand.name == body.name
            yield move(here, stand.mesh.vertex), move(true, np.unique(facets.reshape(-1, 3), axis=0)) - zero


def check_places(name):
    for drawn, true in drawn_and_true(name):
        apart = cdist(drawn, true)
        assert len(drawn) == len(true) and max(apart.min(axis=0).max(), apart.min(axis=1).max()) < 1e-9


@pytest.mark.parametrize("name", [*MACHINES, "linear_axes_everywhere"])
def test_every_body_is_drawn_where_the_joints_carry_it(name):
    check_places(name)


def test_a_body_that_is_not_taken_back_to_words_zero_would_be_noticed(monkeypatch):
    monkeypatch.setattr(standing_bodies, "zero_words", lambda *_: np.zeros(5))
    with pytest.raises(AssertionError):
        check_places("linear_axes_everywhere")


def test_without_the_tools_length_the_spindle_is_not_drawn_and_the_table_is():
    machine = with_bodies("trunnion_ac")
    setup = Setup(ORIGIN)
    names = [one.name for one in stand_bodies(machine, setup, chain(machine, setup), None)]
    assert names == ["on base", "on C", "on A"]
    moving = Machine(
        "Z on the table",
        (*KINDS["table_table"][:2], Axis("Z", False, "table", (0, 0, 1)), *KINDS["table_table"][2:4]),
    )
    moving = replace(
        moving,
        bodies=tuple(MachineBody(one, one, "sphere", ((0.0, 0.0, 0.0),), (5.0,)) for one in ("base", "A")),
    )
    position = stand_bodies(moving, setup, chain(moving, setup), None)
    assert [one.name for one in position] == ["A"], (
        "how low the base is under the tip depends on the tool's length"
    )
    plain = load_machine("trunnion_ac")
    assert stand_bodies(plain, setup, chain(plain, setup), LENGTH) == ()


def test_the_sketch_keeps_what_no_body_stands_for():
    machine = load_machine(EXAMPLE)
    setup = Setup((0.0, 0.0, 0.0), LENGTH)
    kinematics = chain(machine, setup)
    whole = sketch(kinematics, *PART, ToolRoom(90.0, 20.0), -100.0)
    assert {one.name for one in whole} >= {"platter", "riser", "cradle", "base", "spindle", "ram"}
    standing = stand_bodies(machine, setup, kinematics, LENGTH)
    assert {one.place for one in standing} == {"platter", "cradle", "base", "spindle"}
    assert leave_out(whole, standing, kinematics) == ()
    assert leave_out(whole, (), kinematics) == whole
    no_spindle = [one for one in standing if one.place != "spindle"]
    assert {one.name for one in leave_out(whole, no_spindle, kinematics)} == {"spindle", "ram"}
    base = [one for one in standing if one.place == "base"]
    assert {one.name for one in leave_out(whole, base, kinematics)} == {
        "platter",
        "riser",
        "cradle",
        "spindle",
        "ram",
    }
    head = with_bodies("head_b_table_c")
    chained = chain(head, SETUP)
    left = leave_out(
        sketch(chained, *PART, ToolRoom(90.0, 20.0)), stand_bodies(head, SETUP, chained, LENGTH), chained
    )
    assert {one.name for one in left} >= {"fork", "ram"} and "spindle" not in {one.name for one in left}
    head = with_bodies("head_b_table_c", head=True)
    left = leave_out(
        sketch(chained, *PART, ToolRoom(90.0, 20.0)), stand_bodies(head, SETUP, chained, LENGTH), chained
    )
    assert not {one.name for one in left} & {"fork", "ram", "spindle"}


def test_drawn_edges_are_those_of_a_box_the_rims_of_a_cylinder_and_a_border():
    machine = replace(
        load_machine("trunnion_ac"),
        bodies=(
            MachineBody("box", "base", "box", ((0.0, 0.0, 0.0), (1.0, 2.0, 3.0))),
            MachineBody("post", "base", "cylinder", ((0.0, 0.0, 0.0), (0.0, 0.0, 5.0)), (2.0,)),
            MachineBody("ball", "base", "sphere", ((0.0, 0.0, 0.0),), (2.0,)),
        ),
    )
    cube, post, ball = (one.mesh for one in stand_bodies(machine, SETUP, chain(machine, SETUP), LENGTH))
    length = np.linalg.norm(np.diff(find_edges(cube), axis=1)[:, 0], axis=1)
    assert len(length) == 12 and np.allclose(np.sort(length), np.repeat([1.0, 2.0, 3.0], 4))
    rims = find_edges(post)
    assert len(rims) == 2 * 48 and np.allclose(rims[:, 0, 2], rims[:, 1, 2])
    assert len(find_edges(ball)) == 0
    assert len(find_edges(from_triangles(np.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]])))) == 3


def test_a_file_is_drawn_as_it_is(tmp_path):
    facets = box((-5.0, -6.0, -7.0), (8.0, 9.0, 10.0))
    write_stl(from_triangles(facets), tmp_path / "vise.stl")
    body = MachineBody("vise", "C", "file", file=str(tmp_path / "vise.stl"))
    machine = replace(load_machine("trunnion_ac"), bodies=(body,))
    (found,) = stand_bodies(machine, SETUP, chain(machine, SETUP), LENGTH)
    low, high = found.mesh.box
    assert np.allclose(low, np.array((-5, -6, -7)) - ORIGIN) and np.allclose(
        high, np.array((8, 9, 10)) - ORIGIN
    )
    assert (found.place, found.carrier) == ("platter", chain(machine, SETUP).letters.index("C"))
