# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine against each other, part and fixtures: closed forms, and dense samples with turns of
their own."""

import json
import math
from dataclasses import replace
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from mesh_shapes import box
from test_machine_bodies import LENGTH, MACHINES, ORIGIN, TOOL, machine_file, moved, program_of, skin_of
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.base.findings import Hit
from freecad_fiveaxis.core.geometry.convex import convex_hull
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import body_search
from freecad_fiveaxis.core.gouge.body_pairs import which_meet
from freecad_fiveaxis.core.gouge.carried_motion import CarriedMotion, steps_between
from freecad_fiveaxis.core.gouge.carried_pieces import carry_tool, pair_up
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_check import (
    InMachine,
    carry_all,
    check_machine,
    pair_check,
    zero_words,
)
from freecad_fiveaxis.core.gouge.machine_in_pose import machine_in_pose
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.tool import body as tool_body
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion

FILES = Path(__file__).resolve().parents[2] / "resources" / "machines"
SETUP = Setup(ORIGIN, LENGTH)
TOLERANCE = 0.01
CRADLE = MachineBody("cradle", "A", "box", ((-100.0, -60.0, -170.0), (100.0, 60.0, -140.0)))
"""On trunnion_ac, whose A turns about X through (0, 0, -50)."""
CORNER = math.hypot(60.0, 120.0)
"""mm, from that line to the cradle's lower edge."""


def wall(at, name="wall", carrier="base"):
    """Everything behind Y = at."""
    return MachineBody(name, carrier, "box", ((-200.0, at, -400.0), (200.0, at + 100.0, 400.0)))


def words_at(machine, *rows):
    """Words (n, 5) at joints that are named by letter; the others stand at zero."""
    kinematics = chain(machine, SETUP)
    found = np.tile(zero_words(machine, SETUP, kinematics), (len(rows), 1))
    for row, joints in zip(found, rows, strict=True):
        for letter, value in joints.items():
            row[kinematics.letters.index(letter)] += value
    return found


def checked(
    machine,
    words,
    *,
    length=LENGTH,
    part=None,
    fixtures=(),
    rapids="interpolated",
    clearance=0.0,
    tolerance=TOLERANCE,
):
    given = InMachine(
        machine,
        SETUP,
        chain(machine, SETUP),
        TOOL,
        length,
        rapids=rapids,
        clearance=clearance,
        fixtures=tuple(fixtures),
    )
    motion = np.full(len(words), Motion.RAPID, np.int8) if rapids != "interpolated" else None
    return check_machine(given, program_of(machine, words, motion), part, tolerance)


def trunnion(*bodies):
    return replace(load_machine("trunnion_ac"), bodies=bodies)


def pairs_of(*bodies):
    """Give what :func:`which_meet` is asked of a trunnion with these bodies, in five blocks of its cradle."""
    machine = trunnion(*bodies)
    given = InMachine(machine, SETUP, chain(machine, SETUP), TOOL, LENGTH)
    program = program_of(machine, words_at(machine, *({"A": 20.0 * k} for k in range(6))))
    return pair_check(given, program, TOLERANCE), pair_up(machine, carry_all(given, None))[0]


def test_a_question_of_yes_or_no_tells_how_far_it_is_and_can_be_stopped():
    reported, (check, pairs) = [], pairs_of(CRADLE, wall(100.0), wall(110.0, "post"))
    which_meet(check, pairs, np.arange(5), lambda stage, share: reported.append((stage, share)))
    assert len(pairs) > 1 and reported == [("gouge", k / len(pairs)) for k in range(len(pairs))]

    def stop(stage, share):
        raise Cancelled

    with pytest.raises(Cancelled):
        which_meet(check, pairs, np.arange(5), stop)


def test_of_a_way_that_is_not_known_its_end_alone_is_looked_at():
    """With A at 0 and -180 the cradle is clear of the wall, between them it is not."""
    machine = trunnion(CRADLE, wall(100.0))
    given = InMachine(machine, SETUP, chain(machine, SETUP), TOOL, LENGTH)
    program = program_of(machine, words_at(machine, {"A": 0.0}, {"A": -180.0}))
    unknown = replace(program, unknown_way=np.array([False, True]))
    met = [codes(check_machine(given, one, None, TOLERANCE)) for one in (program, unknown)]
    assert met == [["machine-collision"], []]


def codes(found):
    return [one.code for one in found]


# ----------------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize(("off", "hits"), [(0.002, False), (-0.005, False), (-0.05, True)])
def test_the_edge_of_a_cradle_passes_a_wall_that_it_just_misses_and_cuts_one_that_stands_nearer(off, hits):
    """The edge comes nearest to the wall in the middle of the block; at both ends it is far from it."""
    machine = trunnion(CRADLE, wall(CORNER + off))
    found = checked(machine, words_at(machine, {"A": 0.0}, {"A": -110.0}))
    found += checked(machine, words_at(machine, {"A": 0.0}, {"A": 110.0}))
    assert codes(found) == ["machine-collision"] * hits
    if hits:
        (one,) = found
        assert 0.8 * -off < one.value <= -off and (one.block, one.line) == (1, 2)
        assert (
            (one.hit.enters, one.hit.entered) == ("cradle", "wall")
            and "cradle" in one.text
            and "wall" in one.text
        )
        assert one.hit.u * 110.0 == pytest.approx(math.degrees(math.atan2(120.0, 60.0)), abs=3.0)


@pytest.mark.parametrize("off", [-0.02, 0.02])
def test_a_cradle_hits_at_the_angle_that_geometry_gives(off):
    """In degrees; 0.02 deg too far are 0.03 mm, in blocks of one degree."""
    machine, at = (
        trunnion(CRADLE, wall(100.0)),
        math.degrees(math.atan2(120.0, 60.0) - math.acos(100.0 / CORNER)),
    )
    turned = [*np.arange(0.0, at, 1.0).tolist(), at + off]
    ways = [words_at(machine, *({"A": sign * one} for one in turned)) for sign in (1.0, -1.0)]
    found = [one for words in ways for one in checked(machine, words)]
    assert codes(found) == ["machine-collision"] * (off > 0.0)
    assert not found or found[0].block == len(turned) - 1


def test_a_forgotten_bend_would_be_noticed(monkeypatch):
    """What swings away from a wall about the middle of a block stands still there: by its speed alone it
    never comes near."""

    def straight(self, lines, half):
        bend, far = travel(self, lines, half)
        return 0.0 * bend, far

    travel = CarriedMotion.travel
    beside = MachineBody("wall", "base", "box", ((100.0, -80.0, -400.0), (200.0, 20.0, 400.0)))
    machine = trunnion(MachineBody("knob", "A", "sphere", ((150.0, -120.0, -50.0),), (10.0,)), beside)
    words = words_at(machine, {"A": -60.0}, {"A": 60.0})
    assert codes(checked(machine, words)) == ["machine-collision"]
    monkeypatch.setattr(CarriedMotion, "travel", straight)
    assert not checked(machine, words)


def test_spheres_meet_at_the_sum_of_their_radii():
    """One on Z of the head, one on the base beside its way; what is round is no polytope."""
    for off, hits in ((0.002, False), (-0.05, True)):
        bodies = (
            MachineBody("low", "base", "sphere", ((300.0, 0.0, 0.0),), (30.0,)),
            MachineBody("high", "Z", "sphere", ((300.0 + 50.0 + off, 0.0, 200.0),), (20.0,)),
        )
        machine = trunnion(*bodies)
        found = checked(machine, words_at(machine, {"Z": 0.0}, {"Z": -390.0}))
        assert codes(found) == ["machine-collision"] * hits
        if hits:
            assert 0.8 * 0.05 < found[0].value <= 0.05 and found[0].hit.u == pytest.approx(
                200.0 / 390.0, abs=0.02
            )


@pytest.mark.parametrize(("stop", "hits"), [(-59.99, False), (-60.05, True)])
def test_a_housing_on_the_spindle_goes_down_to_a_post_of_the_table_and_no_farther(stop, hits):
    housing = MachineBody("housing", "spindle", "box", ((-80.0, 50.0, 0.0), (80.0, 200.0, 300.0)))
    post = MachineBody("post", "C", "box", ((-10.0, 90.0, -160.0), (10.0, 110.0, -60.0)))
    machine = trunnion(housing, post)
    found = checked(machine, words_at(machine, {"Z": 100.0}, {"Z": stop}))
    assert codes(found) == ["machine-collision"] * hits
    assert not hits or (
        found[0].value == pytest.approx(0.05, rel=0.2) and found[0].hit.u == pytest.approx(1.0, abs=0.01)
    )


def test_the_housing_is_kept_out_of_part_and_fixture_and_needs_the_tools_length():
    housing = MachineBody("housing", "spindle", "box", ((-80.0, 50.0, 0.0), (80.0, 200.0, 300.0)))
    machine, low = trunnion(housing), np.array([-10.0, 90.0, -100.0])
    block = from_triangles(box(low, low + (20.0, 20.0, 40.0)) - ORIGIN)
    words = words_at(machine, {"Z": 100.0}, {"Z": -63.0})
    (of_part,), (of_fixture,) = (
        checked(machine, words, part=block),
        checked(machine, words, fixtures=[Fixture("vise", block)]),
    )
    assert of_part.value == of_fixture.value == pytest.approx(3.0, rel=0.1)
    assert (of_part.hit, of_fixture.hit) == (
        Hit("housing", "", of_part.hit.u),
        Hit("housing", "vise", of_part.hit.u),
    )
    (blind,) = checked(machine, words, part=block, length=None)
    assert blind.code == "machine-unproven" and "housing" in blind.text and "--tool-length" in blind.text


def test_a_part_that_swings_into_a_column_is_reported():
    """It stands out beside the table, and C turns it."""
    machine = trunnion(wall(150.0))
    bar = from_triangles(box((100.0, -10.0, 0.0), (170.0, 10.0, 20.0)) - ORIGIN)
    (one,) = checked(machine, words_at(machine, {"C": 0.0}, {"C": -120.0}), part=bar)
    assert one.code == "machine-collision" and one.hit == Hit("wall", "", one.hit.u) and one.value > 9.0
    assert not checked(machine, words_at(machine, {"C": 0.0}, {"C": -30.0}), part=bar)


def test_the_holder_is_kept_out_of_a_body_that_an_axis_of_the_head_carries():
    """A fork whose cheek is 20 mm beside the tool where that stands upright, with the holder of 30 mm."""
    plain = load_machine("fork_head_bc")
    first = next(axis for axis in plain.fitted if axis.side == "head" and axis.rotary)
    arm = MachineBody("arm", first.letter, "box", ((40.0, -10.0, -30.0), (60.0, 10.0, -10.0)))
    machine = replace(plain, bodies=(arm,))
    letter = next(axis.letter for axis in plain.fitted if axis.rotary and axis is not first)
    swing = words_at(machine, {letter: -60.0}, {letter: 60.0})
    found = checked(machine, swing)
    assert codes(found) == ["machine-collision"] and (found[0].hit.enters, found[0].hit.entered) == (
        "holder",
        "arm",
    )
    assert not checked(machine, words_at(machine, {first.letter: -60.0}, {first.letter: 60.0}))


# ------------------------------------------------------------------------------------------ what is looked at


def test_neighbours_that_touch_at_zero_and_go_no_deeper_are_stated():
    base = MachineBody("bearing", "base", "box", ((-150.0, -60.0, -170.0), (-100.0, 60.0, -140.0)))
    machine = trunnion(CRADLE, base, wall(100.0))
    (note, hit) = checked(machine, words_at(machine, {"A": 0.0}, {"A": 50.0}, {"A": -50.0}))
    assert note.code == "machine-touching" and "cradle, bearing" in note.text and note.severity.name == "NOTE"
    assert hit.code == "machine-collision" and "wall" in hit.text


def test_across_from_table_to_head_nothing_is_a_neighbour():
    """At all joints zero the head may stand in the table, where no program goes."""
    machine = trunnion(CRADLE, MachineBody("head", "Z", "box", ((-10.0, -10.0, -160.0), (10.0, 10.0, 0.0))))
    assert codes(checked(machine, words_at(machine, {"Z": 200.0}, {"Z": 0.0}))) == ["machine-collision"]
    assert not checked(machine, words_at(machine, {"Z": 200.0}, {"Z": 100.0}))


def test_what_comes_nearer_than_the_clearance_is_reported_with_the_distance():
    machine = trunnion(CRADLE, wall(CORNER + 5.0))
    words = words_at(machine, {"A": 0.0}, {"A": -110.0}, {"A": 110.0})
    assert not checked(machine, words) and not checked(machine, words, clearance=4.9)
    (one,) = checked(machine, words, clearance=8.0)
    (own,) = checked(trunnion(replace(CRADLE, clearance=8.0), wall(CORNER + 5.0)), words)
    assert one.code == own.code == "machine-near" and one.severity.name == "WARNING"
    assert 5.0 <= one.value <= 5.6 and one.limit == 8.0 and one.near == own.near
    assert (one.near.enters, one.near.entered, one.hit) == ("cradle", "wall", None)


def test_a_rapid_of_independent_axes_goes_every_way():
    """In step the housing passes over the post; were Z first, it would go through it."""
    housing = MachineBody("housing", "spindle", "box", ((-20.0, 50.0, 0.0), (20.0, 90.0, 300.0)))
    post = MachineBody("post", "base", "box", ((190.0, 60.0, -200.0), (210.0, 80.0, 0.0)))
    machine = trunnion(housing, post)
    low, high = (words_at(machine, {"Z": 100.0}, {"X": 400.0, "Z": z}) for z in (-20.0, 5.0))
    assert not checked(machine, low) and not checked(machine, high, rapids="independent")
    found = checked(machine, low, rapids="independent")
    assert codes(found) == ["machine-collision"] and found[0].hit.u is None and found[0].value > 9.0


def test_of_a_block_that_takes_too_many_cells_it_is_reported_that_it_is_not_proven(monkeypatch):
    monkeypatch.setattr(body_search, "MOST_CELLS", 2)
    machine = trunnion(CRADLE, wall(CORNER + 0.002))
    (one,) = checked(machine, words_at(machine, {"A": 0.0}, {"A": -110.0}, {"A": 110.0}))
    assert (
        one.code == "machine-unproven" and "cradle" in one.text and "wall" in one.text and one.line in (2, 3)
    )


def test_of_a_machine_without_bodies_nothing_is_requested(monkeypatch):
    from freecad_fiveaxis.core.gouge import machine_check

    monkeypatch.setattr(machine_check, "check_pairs", None)
    plain = load_machine("trunnion_ac")
    assert checked(plain, words_at(plain, {"A": 0.0}, {"A": 90.0})) == ()


# ---------------------------------------------------------------------------------------------- dense samples


def places(machine, joints):
    """Where each carrier stands in the machine frame (..., 4, 4): from the base outwards; a table's axis moves
    what it carries the other way."""
    found = {"base": np.eye(4)}
    for side, sign in (("table", -1.0), ("head", 1.0)):
        place = np.eye(4)
        for axis in machine.fitted[::-1] if side == "table" else machine.fitted:
            if axis.side == side:
                place = place @ moved(axis, sign * joints[axis.letter])
                found[axis.letter] = place
        found["spindle"] = place
    return found


def depth_of(points, body):
    """How deep the deepest of points (..., 3) mm is in a box."""
    low, high = np.array(body.points)
    return float(np.minimum(points - low, high - points).min(axis=-1).max())


def sampled_depth(machine, words, one, other, count=60):
    """How deep a point of each box is in the other at most, on a straight way of the joints."""
    zero, letters = words_at(machine, {})[0], chain(machine, SETUP).letters
    share = np.linspace(0.0, 1.0, count)[:, None]
    at = places(machine, dict(zip(letters, (words[0] + share * (words[1] - words[0]) - zero).T, strict=True)))
    deepest = -math.inf
    for a, b in ((one, other), (other, one)):
        seen = np.linalg.inv(at[b.carrier]) @ at[a.carrier]
        points = skin_of(a, 11) @ seen[..., :3, :3].swapaxes(-1, -2) + seen[..., None, :3, 3]
        deepest = max(deepest, depth_of(points, b))
    return deepest


def random_scene(rng, plain):
    """Two boxes on two axes, and a block; those that touch at zero are none."""
    names = ["base", *(axis.letter for axis in plain.fitted)]
    names[-1] = "spindle"  # which the last axis of the head carries
    bodies = []
    for name in rng.choice(names, 2, replace=False):
        middle, half = rng.uniform(-40, 40, 3), rng.uniform(10, 30, 3)
        bodies.append(
            MachineBody(f"on {name}", str(name), "box", (tuple(middle - half), tuple(middle + half)))
        )
    words = words_at(plain, {}, {}) + np.concatenate(
        [rng.uniform(-40, 40, (2, 3)), rng.uniform(-70, 70, (2, 2))], axis=1
    )
    return replace(plain, bodies=tuple(bodies)), words


def compare(name, scenes):
    rng, plain = np.random.default_rng(7), load_machine(name)
    hit = missed = 0
    for _ in range(scenes):
        machine, words = random_scene(rng, plain)
        found = checked(machine, words)
        if any(one.code == "machine-touching" for one in found):
            continue
        reported = max(
            (one.value for one in found if "on " in one.hit.enters and "on " in one.hit.entered), default=0.0
        )
        sampled = sampled_depth(machine, words, *machine.bodies)
        if sampled > 0.02:
            assert reported > 0.0, (machine.bodies, sampled)
        if reported > 1.5:
            assert sampled > 0.0, (machine.bodies, reported)
        hit += reported > 0.0
        missed += reported == 0.0
    return hit, missed


@pytest.mark.thorough
@some_in_core("name", MACHINES)
def test_dense_samples_find_no_meeting_that_is_not_reported_and_what_is_reported_is_there(name):
    hit, missed = compare(name, 40)
    assert hit > 3 and missed > 3


def test_an_axis_that_turns_the_other_way_would_be_noticed(monkeypatch):
    from freecad_fiveaxis.core.gouge import carried_motion

    there = carried_motion.carriers_from_base
    monkeypatch.setattr(
        carried_motion, "carriers_from_base", lambda machine, carrier: (there(machine, carrier)[0], 1.0)
    )
    with pytest.raises(AssertionError):
        compare("trunnion_ac", 40)


def in_long_program(grids=True):
    """Which blocks of 400, to and fro, have a cradle in a wall: with grids, or block by block."""
    rng, motion = (
        np.random.default_rng(6),
        CarriedMotion(steps_between(trunnion(), "base", "C"), convex_hull(skin_of(CRADLE, 11))),
    )
    joints = np.stack(
        [np.cumsum(rng.uniform(-0.1, 0.1, 401)), np.cumsum(rng.uniform(-0.3, 0.3, 401))], axis=1
    )
    with pytest.MonkeyPatch.context() as patch:
        if not grids:
            patch.setattr(body_search, "open_blocks", lambda pair, low, high: np.arange(len(low)))
        pair = body_search.Pair(motion, convex_hull(skin_of(wall(100.0), 11)))
        return body_search.find_meetings(pair, joints[:-1], joints[1:], True, 0.001).met


def test_grids_of_joints_change_nothing_of_what_is_met():
    with_grids, without = in_long_program(), in_long_program(False)
    assert 0 < np.count_nonzero(without) < len(without) and (with_grids == without).all()


def test_cells_of_a_grid_that_are_too_small_would_be_noticed(monkeypatch):
    def look(pair, cells, joined):
        return there(pair, cells if joined else cells._replace(half=0.0 * cells.half), joined)

    there = body_search._look
    monkeypatch.setattr(body_search, "_look", look)
    assert (in_long_program() != in_long_program(False)).any()


# ------------------------------------------------------------------------------------------------ programs


def test_the_command_line_tells_of_a_cradle_in_a_column(tmp_path):
    """Of a part that is tilted to both sides; farther away the column is free, and the NC file is the
    same."""
    write_stl(from_triangles(box((-10, -10, 0), (10, 10, 10))), tmp_path / "part.stl")
    cradle = {"name": "cradle", "carrier": "A", "box": {"low": [-100, -60, -170], "high": [100, 60, -140]}}
    codes_, texts = [], []
    given = [
        "mill",
        str(tmp_path / "part.stl"),
        "--cutter",
        "ball:6",
        "--passes",
        "planes",
        "--stepover",
        "4",
        "--spindle",
        "off",
    ]
    given += [
        "--tool-axis",
        "facet_mean",
        "--max-axis-angle",
        "91",
        "--quiet",
        "--report",
        str(tmp_path / "r.json"),
    ]
    for name, at in (("near", 100), ("far", 400)):
        column = {
            "name": "column",
            "carrier": "base",
            "box": {"low": [-200, at, -300], "high": [200, at + 50, 300]},
        }
        machine = machine_file(tmp_path, [cradle, column])
        codes_.append(cli.main([*given, "--machine", str(machine), "-o", str(tmp_path / f"{name}.ngc")]))
        texts.append([one["text"] for one in json.loads((tmp_path / "r.json").read_text())["findings"]])
    assert codes_[0] == 1 and any(
        "The cradle goes at least" in text and "column" in text for text in texts[0]
    )
    assert not any("goes at least" in text for text in texts[1])
    assert (tmp_path / "near.ngc").read_bytes() == (tmp_path / "far.ngc").read_bytes()
    audit = [
        "audit",
        str(tmp_path / "near.ngc"),
        "--quiet",
        "--report",
        str(tmp_path / "a.json"),
        "--machine",
    ]
    machine = machine_file(
        tmp_path, [cradle, {**column, "box": {"low": [-200, 100, -300], "high": [200, 150, 300]}}]
    )
    assert cli.main([*audit, str(machine)]) == 1
    assert "machine-collision" in [
        one["code"] for one in json.loads((tmp_path / "a.json").read_text())["findings"]
    ]


def test_the_head_table_machine_of_the_examples_moves_free_and_hits_where_it_leans_low():
    """Its fork and housing stay out of everything while it leans to both sides above the table, and lean into
    it below."""
    machine = load_machine(FILES / "head_table_with_bodies.fcm")
    above = [
        {"Z": 50.0},
        {"Z": 50.0, "B": 90.0, "C": 200.0},
        {"Z": 40.0, "B": -90.0, "X": 200.0},
        {"Z": 45.0, "Y": 150.0},
    ]
    found = checked(machine, words_at(machine, *above), rapids="independent")
    assert codes(found) == ["machine-touching"] and "table slide, platter" in found[0].text
    low = checked(machine, words_at(machine, {"Z": 50.0}, {"Z": 50.0, "B": 90.0}, {"Z": -220.0, "B": 90.0}))
    met = {(one.hit.enters, one.hit.entered) for one in low if one.hit}
    assert ("housing", "platter") in {tuple(sorted(pair)) for pair in met}
    assert any({"platter", "rear cheek"} == set(pair) for pair in met)


@pytest.mark.thorough
@pytest.mark.parametrize(("height", "free"), [(-60.0, True), (-140.0, False)])
def test_a_part_is_milled_free_of_bodies_on_that_machine_where_it_stands_high_enough(tmp_path, height, free):
    from freecad_fiveaxis.core.pipeline import job
    from freecad_fiveaxis.core.pipeline.settings import build_settings

    write_stl(from_triangles(box((-30, -20, height), (30, 20, height + 10))), tmp_path / "part.stl")
    given = {
        "machine": str(FILES / "head_table_with_bodies.fcm"),
        "cutter": "ball:6:30",
        "passes": "planes",
        "stepover": 6,
    }
    given |= {
        "tool_axis": "facet_mean",
        "max_axis_angle": 91,
        "spindle": "off",
        "linearize": "off",
        "gouge": "off",
    }
    found = job.run(
        build_settings("mill", str(tmp_path / "part.stl"), {**given, "tool_length": 150})
    ).findings
    met = {(one.hit.enters, one.hit.entered) for one in found if one.code == "machine-collision"}
    assert (not met) == free and (free or any("table slide" in pair and "housing" in pair for pair in met))


@pytest.mark.parametrize(
    "text", ["ball:10", "flat:10", "bull:10:2", "taperbull:8:1.5:8deg", "lollipop:10:5", "barrel:10:85:2"]
)
def test_what_the_tool_carries_holds_all_of_it(text):
    """Points of the tool's own body, at all heights, are in one of its convex pieces."""
    machine, body = load_machine("trunnion_ac"), tool_body.body_of(parse_cutter(text))
    pieces = [one.piece for one in carry_tool(machine, body, 120.0)]
    tip = np.array(machine.gauge_point) - (0.0, 0.0, 120.0)
    at = np.random.default_rng(2).uniform((-6.0, -6.0, -1.0), (6.0, 6.0, 40.0), (20000, 3))
    inside = at[tool_body.depth_of(body, np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]]), at) > 0.0] + tip
    off = [
        (inside @ one.plane[:, :3].T + one.plane[:, 3]).max(axis=1) - one.round
        for one in pieces
        if len(one.plane)
    ]
    off += [np.linalg.norm(inside - np.clip(inside, one.corner.min(axis=0), one.corner.max(axis=0)), axis=1) - one.round
            for one in pieces if not len(one.plane)]  # fmt: skip
    assert len(inside) > 1000 and np.min(off, axis=0).max() < 1e-6


# ------------------------------------------------------------------------------------------------ neighbours


BEARING = MachineBody("bearing", "base", "box", ((-150.0, -60.0, -170.0), (-100.0, 60.0, -140.0)))
FLOOR = MachineBody("floor", "base", "box", ((-150.0, -150.0, -200.0), (150.0, 150.0, -170.0)))
"""On which the cradle lies with A at zero."""


def test_neighbours_that_touch_at_zero_are_looked_at_as_soon_as_they_go_into_each_other():
    """The cradle's lower edge goes down from the floor as A turns: CORNER sin(a + atan2(120, 60)) - 120."""
    machine = trunnion(CRADLE, BEARING, FLOOR)
    (note, one) = checked(machine, words_at(machine, {"A": 0.0}, {"A": 10.0}))
    turned = math.radians(10.0) + math.atan2(120.0, 60.0)
    assert one.value == pytest.approx(CORNER * math.sin(turned) - 120.0, rel=0.1)
    assert (one.code, one.block, {one.hit.enters, one.hit.entered}) == (
        "machine-collision",
        1,
        {"cradle", "floor"},
    )
    assert note.code == "machine-touching" and "bearing" in note.text and "floor" not in note.text
    assert "in each other" not in one.text
    assert not any(one.hit for one in checked(machine, words_at(machine, {"X": 0.0}, {"X": 50.0})))


@pytest.mark.parametrize("sunk", [0.0, 4.0])
def test_a_slide_goes_along_its_bed_and_no_deeper(sunk):
    """On it, or sunk in it."""
    slide = MachineBody("slide", "X", "box", ((-50.0, -50.0, -300.0 - sunk), (50.0, 50.0, -260.0)))
    bed = MachineBody("bed", "base", "box", ((-300.0, -80.0, -360.0), (300.0, 80.0, -300.0)))
    machine = replace(load_machine("head_b_table_c"), bodies=(slide, bed))
    (note,) = checked(machine, words_at(machine, {"X": -90.0}, {"X": 90.0}))
    assert note.code == "machine-touching" and "slide" in note.text


def test_what_is_granted_to_neighbours_is_what_they_are_in_each_other_at_zero_and_no_more():
    """A ram 3 mm in a post: 2 mm farther is a collision of 5 mm, 2 mm back none."""
    ram = MachineBody("ram", "Y", "box", ((-20.0, -40.0, 100.0), (20.0, 40.0, 300.0)))
    machine = replace(load_machine("head_b_table_c"), bodies=(ram, wall(37.0)))
    letter = next(axis for axis in machine.fitted if axis.letter == "Y")
    sign = 1.0 if letter.side == "head" else -1.0
    assert codes(checked(machine, words_at(machine, {"Y": 0.0}, {"Y": -2.0 * sign}))) == ["machine-touching"]
    (one,) = checked(machine, words_at(machine, {"Y": 0.0}, {"Y": 2.0 * sign}))
    assert one.code == "machine-collision" and one.value == pytest.approx(5.0, rel=0.1)
    assert one.limit == pytest.approx(3.0 + TOLERANCE, abs=0.01) and "3 mm in each other" in one.text


def test_a_round_platter_turns_beside_what_it_touches():
    """Its flat sides stand out by 0.2 % of its radius, and turn."""
    platter = MachineBody("platter", "C", "cylinder", ((0.0, 0.0, -135.0), (0.0, 0.0, -100.0)), (200.0,))
    cheek = MachineBody("cheek", "A", "box", ((-50.0, 200.0, -170.0), (50.0, 260.0, -90.0)))
    machine = trunnion(platter, cheek)
    (note,) = checked(machine, words_at(machine, {"C": 0.0}, {"C": 360.0}))
    assert note.code == "machine-touching" and "platter" in note.text


def test_a_hollow_neighbour_is_not_looked_at_and_stated(tmp_path):
    """A cradle hangs between the cheeks of a fork, in its hull but not in it."""
    sides = [box((x, -80.0, -200.0), (x + 40.0, 80.0, 0.0)) for x in (-160.0, 120.0)]
    floor = box((-120.0, -80.0, -240.0), (120.0, 80.0, -200.0))
    write_stl(from_triangles(np.concatenate([*sides, floor])), tmp_path / "fork.stl")
    fork = MachineBody("fork", "base", "file", file=str(tmp_path / "fork.stl"))
    machine = trunnion(CRADLE, fork)
    (note,) = checked(machine, words_at(machine, {"A": 0.0}, {"A": 30.0}))
    assert note.code == "machine-touching" and "cradle, fork" in note.text and "hollow" in note.text


def depths_both_ways(machine, words, count):
    """How deep points of the one box are in the other at most, and the other way round, on a straight way."""
    one, other = machine.bodies
    zero, letters = words_at(machine, {})[0], chain(machine, SETUP).letters
    share = np.linspace(0.0, 1.0, count)[:, None]
    at = places(machine, dict(zip(letters, (words[0] + share * (words[1] - words[0]) - zero).T, strict=True)))
    found = []
    for a, b in ((one, other), (other, one)):
        seen = np.linalg.inv(at[b.carrier]) @ at[a.carrier]
        points = solid_of(a) @ seen[..., :3, :3].swapaxes(-1, -2) + seen[..., None, :3, 3]
        found.append(depth_of(points, b))
    return np.array(found)


def solid_of(body, count=21):
    """Points (n, 3) mm on a grid in a box."""
    share = np.stack(np.meshgrid(*(np.linspace(0.0, 1.0, count),) * 3, indexing="ij"), -1).reshape(-1, 3)
    low, high = np.array(body.points)
    return low + share * (high - low)


def test_a_fixture_is_no_neighbour_of_what_it_passes():
    """With X at zero the post of the base stands in the vise; no program goes there, but to its edge."""
    post = MachineBody("post", "base", "box", ((-20.0, -20.0, -360.0), (20.0, 20.0, -260.0)))
    vise = Fixture("vise", from_triangles(box((-50.0, -50.0, -300.0), (50.0, 50.0, -200.0)) - ORIGIN))
    machine = replace(load_machine("head_b_table_c"), bodies=(post,))
    words = words_at(machine, {"X": 90.0}, {"X": 65.0})
    found = [one for one in checked(machine, words, fixtures=[vise]) if "vise" in one.text]
    assert codes(found) == ["machine-collision"] and found[0].value == pytest.approx(5.0, rel=0.1)
    assert not any(
        "vise" in one.text for one in checked(machine, words[:1].repeat(2, axis=0), fixtures=[vise])
    )


GRID = 2.0
"""mm by which depths of points on a grid are too small."""


@pytest.mark.thorough
@some_in_core("name", MACHINES[:3])
def test_of_random_neighbours_dense_samples_find_nothing_deeper_that_is_not_reported(name):
    """Boxes that are in each other at zero, on a way that begins there."""
    rng, plain = np.random.default_rng(11), load_machine(name)
    met = kept = 0
    for _ in range(120):
        machine, words = random_scene(rng, plain)
        words[0] = words_at(plain, {})[0]
        names = [", ".join(order) for order in permutations(one.name for one in machine.bodies)]
        found = checked(machine, words)
        kept_out = any("nowhere deeper" in one.text and two in one.text for one in found for two in names)
        collisions = [one for one in found if one.hit and one.limit > TOLERANCE]
        collisions = [one for one in collisions if "on " in one.hit.enters and "on " in one.hit.entered]
        if not (kept_out or collisions):
            continue
        still, on_way = (depths_both_ways(machine, words, count) for count in (1, 60))
        met, kept = met + bool(collisions), kept + kept_out
        if collisions:
            assert collisions[0].value > collisions[0].limit - TOLERANCE and (on_way > still - GRID).any()
        else:
            assert (on_way < still + GRID).any()
    assert met > 1 and kept > 0


def test_a_pose_in_which_neighbours_go_into_each_other_is_blocked():
    """As a tool axis is chosen by: free with A at zero, where the cradle lies on the floor, not turned."""
    machine = trunnion(CRADLE, FLOOR)
    kinematics = chain(machine, SETUP)
    given = InMachine(machine, SETUP, kinematics, TOOL, LENGTH)
    words = words_at(machine, {"Z": 300.0}, {"Z": 300.0, "A": 10.0})
    tip, axis = forward(kinematics, words_to_q(words))
    for margin in (0.0, 2.0):
        pose = machine_in_pose(given, None, TOLERANCE, margin=margin)
        assert pose.is_blocked(tip, axis, np.deg2rad(words[:, 3:])).tolist() == [False, True]
    check, pairs = pairs_of(CRADLE, FLOOR)  # from 53.1 deg on the edge is above the floor again
    assert which_meet(check, pairs, np.arange(5)).tolist() == [True, True, True, False, False]
