# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of the machine where the controller guides the tip: closed forms, and dense samples of the way on
which the tip stays on its chord, by turns of the test's own."""

import json
from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box
from test_machine_bodies import (
    LENGTH,
    MACHINES,
    NOSE,
    ORIGIN,
    TOOL,
    carriers,
    dense,
    frames,
    joints_at,
    program_of,
)
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import machine_check, machine_way
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine
from freecad_fiveaxis.core.gouge.machine_way import SHARE, lay_way, plain_way
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.program import Guided, standing
from freecad_fiveaxis.core.report.playback import Playback
from freecad_fiveaxis.core.toolpath.cl_path import Motion

SETUP, TOLERANCE, RADIUS, RAM = Setup((0.0, 0.0, 0.0), LENGTH), 0.01, 50.0, 20.0


def guided(machine, words, setup=SETUP, motion=None, vector=False):
    """A program of these words (m, 5) whose tip the controller guides, first row and all."""
    program = program_of(machine, words, motion)
    tip, axis = forward(chain(machine, setup), words_to_q(words))
    return replace(program, guided=Guided(np.ones(len(words), bool), tip, axis if vector else None))


def checked(machine, program, setup=SETUP, tolerance=TOLERANCE, **given):
    whole = InMachine(machine, setup, chain(machine, setup), TOOL, LENGTH, **given)
    return check_machine(whole, program, None, tolerance)


def codes(found):
    return [one.code for one in found]


def tip_over_work(machine, words, origin):
    """Where the tip is seen from the work at words (..., 5), by the test's own turns: (..., 3) mm."""
    carried, tool = frames(machine, joints_at(machine, words, origin))
    table = [axis.letter for axis in machine.fitted if axis.side == "table"]
    work = carried[table[0] if table else "base"]
    gauge = np.array(machine.gauge_point) - (0, 0, LENGTH)
    tip = tool[..., :3, :3] @ gauge + tool[..., :3, 3] - work[..., :3, 3]
    return np.einsum("...ji,...j->...i", work[..., :3, :3], tip)


def guided_way(machine, words, origin):
    """The words (..., 5) at shares (...,) of a block: the rotary words evenly, the others such that the tip is
    on its chord."""
    ends = tip_over_work(machine, words, origin)

    def way(share):
        share = np.asarray(share)[..., None]
        word = words[0] + share * (words[1] - words[0])
        here = tip_over_work(machine, word, origin)
        columns = np.swapaxes(tip_over_work(machine, word[..., None, :] + np.eye(3, 5), origin), -1, -2)
        columns -= here[..., None]
        off = ends[0] + share * (ends[1] - ends[0]) - here
        word[..., :3] += np.linalg.solve(columns, off[..., None])[..., 0]
        return word

    return way


# --------------------------------------------------------------------------------------------- dense samples


@pytest.mark.thorough
@some_in_core("name", (*MACHINES, "between", "skew"))
def test_dense_samples_of_the_guided_way_find_nothing_deeper_than_what_is_reported(name):
    rng, plain, setup = np.random.default_rng(7), _machine(name), Setup(ORIGIN, LENGTH)
    hit = missed = 0
    for _ in range(24):
        carrier = rng.choice(carriers(plain))
        middle, half = rng.uniform(-25, 25, 3) + ORIGIN, rng.uniform(8, 20, 3)
        body = MachineBody("box", str(carrier), "box", (tuple(middle - half), tuple(middle + half)))
        machine = replace(plain, bodies=(body, NOSE))
        words = np.concatenate([rng.uniform(-30, 30, (2, 3)), rng.uniform(-60, 60, (2, 2))], axis=1)
        program = guided(machine, words, setup)
        found = [
            one
            for one in checked(machine, program, setup, 0.05)
            if one.code == "machine-collision" and one.hit.enters != "nose"
        ]
        sampled = dense(machine, words, body, way=guided_way(machine, words, ORIGIN))
        reported = found[0].value if found else 0.0
        assert reported >= 0.98 * sampled - 0.15, (carrier, reported, sampled)
        assert reported <= sampled + 1.5, (carrier, reported, sampled)
        hit += bool(found)
        missed += not found
    assert hit > 1 and missed > 3


def test_a_way_in_step_where_it_is_guided_would_be_noticed(monkeypatch):
    monkeypatch.setattr(machine_check, "lay_way", lambda kinematics, program, tolerance: _in_step(program))
    with pytest.raises(AssertionError):
        test_dense_samples_of_the_guided_way_find_nothing_deeper_than_what_is_reported("trunnion_ac")


def _in_step(program):
    return plain_way(replace(program, guided=None))


@pytest.mark.parametrize("name", ["trunnion_ac", "head_b_table_c", "fork_head_bc", "between", "skew"])
def test_what_linear_axes_carry_is_off_by_no_more_than_the_bound(name):
    """Everywhere between the rows put in the linear joints are as far from those in step as is said, at most:
    in a unit cube of directions, so for every sum of some of them."""
    machine, rng = _machine(name), np.random.default_rng(3)
    kinematics = chain(machine, Setup(ORIGIN, LENGTH))
    worst = 0.0
    for _ in range(6):
        words = np.concatenate([rng.uniform(-60, 60, (2, 3)), rng.uniform(-50, 50, (2, 2))], axis=1)
        passes = lay_way(kinematics, guided(machine, words, Setup(ORIGIN, LENGTH)), 4.0)
        assert (
            not passes.undecided.any()
            and passes.off <= SHARE * 4.0
            and (passes.begin == np.sort(passes.begin)).all()
        )
        way = guided_way(machine, words, ORIGIN)
        for piece in range(0, len(passes.block), max(1, len(passes.block) // 6)):
            u = np.array([0.25, 0.5, 0.75])
            start, end = passes.in_step.words[piece], passes.in_step.words[piece + 1]
            off = way(passes.begin[piece] + u * passes.width[piece]) - (start + u[:, None] * (end - start))
            assert np.abs(off[:, 3:]).max() < 1e-9
            for some in ((1, 1, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
                moved = np.linalg.norm((off[:, :3] * some) @ kinematics.direction[:3], axis=1).max()
                worst = max(worst, moved)
                assert moved <= passes.off + 1e-9
    assert worst > 0.02 * SHARE * 4.0


def test_rows_that_are_not_put_in_would_be_noticed(monkeypatch):
    monkeypatch.setitem(globals(), "lay_way", lambda kinematics, program, tolerance: _in_step(program))
    with pytest.raises(AssertionError):
        test_what_linear_axes_carry_is_off_by_no_more_than_the_bound("trunnion_ac")


def _machine(name):
    """Machines as they come; one with Y between its rotary axes; one whose X leans."""
    if name == "between":
        plain = load_machine("trunnion_ac")
        axes = {axis.letter: axis for axis in plain.axes}
        y = replace(axes["Y"], side="table")
        return replace(plain, axes=(axes["C"], y, axes["A"], axes["X"], axes["Z"]))
    if name == "skew":
        plain = load_machine("trunnion_ac")
        lean = (np.cos(0.5), np.sin(0.5), 0.0)
        return replace(
            plain,
            axes=tuple(replace(one, direction=lean) if one.letter == "X" else one for one in plain.axes),
        )
    return load_machine(name)


# ---------------------------------------------------------------------------------------------- closed forms


def ram_and(post, carrier="Z"):
    """A trunnion with a ball of 20 mm that goes with the head, or a spindle as wide, and a post of the base,
    as high as these are where the tip is at Z 0."""
    ram = MachineBody("ram", "Z", "sphere", ((0.0, 0.0, 25.0),), (RAM,))
    spindle = MachineBody("ram", "spindle", "cylinder", ((0.0, 0.0, 0.0), (0.0, 0.0, 50.0)), (RAM,))
    return replace(load_machine("trunnion_ac"), bodies=(ram if carrier == "Z" else spindle, post))


def half_turn(machine, start, end):
    """Words of a half turn of C, between two places of the tip over the work."""
    kinematics = chain(machine, SETUP)
    tip = np.array([start, end], float)
    at = kinematics.letters.index("C")
    angles = np.zeros((2, 2))
    angles[1, at - 3] = 180.0
    return standing(kinematics, tip, angles)


def post_at(low, high):
    """Between two Y, mm."""
    return MachineBody("post", "base", "box", ((-8.0, low, 75.0), (8.0, high, 200.0)))


def beside(off):
    """A post so far beside the ram where this is farthest out on the circle."""
    return post_at(-RADIUS - RAM - 40.0, -RADIUS - RAM - off)


MIDDLE = post_at(-8.0, 8.0)
STILL = ((RADIUS, 0.0, 0.0), (RADIUS, 0.0, 0.0))
"""The tip stands over the work while C turns: guided, the head goes round half a circle; in step, straight
through its middle."""


def both_ways(machine, words):
    return [codes(checked(machine, one)) for one in (guided(machine, words), program_of(machine, words))]


def collides(found):
    return "machine-collision" in found


def of_ram(found):
    """What is told of the ram; the tool's holder goes into the post as well, and less deep."""
    return [one for one in found if "ram" in (one.hit.enters, one.hit.entered)]


def test_a_post_in_the_circle_is_hit_in_step_alone_and_one_on_it_where_the_tip_is_guided():
    machine = ram_and(MIDDLE)
    words = half_turn(machine, *STILL)
    reported, in_step = both_ways(machine, words)
    assert not reported and collides(in_step)
    reported, in_step = both_ways(ram_and(beside(-10.0)), words)
    assert collides(reported) and not in_step


@pytest.mark.parametrize(("off", "hits"), [(0.002, False), (0.02, False), (-0.05, True), (-1.0, True)])
@pytest.mark.parametrize("carrier", ["Z", "spindle"])
def test_a_post_just_outside_the_circle_is_missed_and_hit_as_geometry_gives(off, hits, carrier):
    """Of a body of the head, and of the spindle, which the other check looks at. It is nearest in the middle
    of the block, between two rows that are put in or at one of them."""
    machine = ram_and(beside(off), carrier)
    found = checked(machine, guided(machine, half_turn(machine, *STILL)))
    assert codes(found) == ["machine-collision"] * hits
    if hits:
        (one,) = found
        sides = {"spindle", "post"} if carrier == "spindle" else {"ram", "post"}
        assert (one.block, one.line) == (1, 2) and {one.hit.enters, one.hit.entered} == sides
        assert 0.55 * -off <= one.value <= -off + 1e-6 and one.hit.u == pytest.approx(0.5, abs=0.05)


def test_pieces_that_are_too_long_or_an_off_that_is_forgotten_would_be_noticed(monkeypatch):
    monkeypatch.setattr(machine_way, "SHARE", 1000.0)
    passes = machine_way.lay_way
    monkeypatch.setattr(machine_check, "lay_way", lambda *given: passes(*given)._replace(off=0.0))
    with pytest.raises(AssertionError):
        test_a_post_just_outside_the_circle_is_missed_and_hit_as_geometry_gives(-1.0, True, "Z")


def test_the_block_is_reported_that_hits_among_others():
    """A block that turns nothing is one piece; one that turns the other way hits as well, but is not the
    deepest."""
    machine = ram_and(beside(-10.0))
    turn = half_turn(machine, *STILL)
    up = turn[:1] + (0.0, 0.0, 200.0, 0.0, 0.0)
    found = checked(machine, guided(machine, np.concatenate([up, turn, turn[1:] + up - turn[:1]])))
    (one,) = of_ram(found)
    assert (one.block, one.line) == (2, 3) and "of 1 blocks" in one.text
    (one,) = of_ram(checked(machine, guided(machine, np.concatenate([up, turn, turn[:1]]))))
    assert one.block in (2, 3) and "of 2 blocks" in one.text


def test_of_blocks_of_which_only_some_are_guided_each_goes_its_own_way():
    """The same half turn twice: once guided, once in step."""
    words = half_turn(ram_and(MIDDLE), *STILL)
    for post, block in ((MIDDLE, 2), (beside(-10.0), 1)):
        machine = ram_and(post)
        program = guided(machine, np.concatenate([words, words[:1]]))
        on = np.array([False, True, False])
        program = replace(program, guided=replace(program.guided, on=on))
        (one,) = of_ram(checked(machine, program))
        assert (one.code, one.block) == ("machine-collision", block) and "of 1 blocks" in one.text


def test_what_comes_nearer_than_the_clearance_is_reported_with_the_distance():
    for carrier in ("Z", "spindle"):
        machine = ram_and(beside(3.0), carrier)
        (one,) = checked(machine, guided(machine, half_turn(machine, *STILL)), clearance=5.0)
        assert one.code == "machine-near" and one.value == pytest.approx(3.0, abs=0.35)


# ------------------------------------------------------------------------------------- what is not decided


def test_of_vectors_it_is_stated_what_is_taken_for_granted_and_ends_alone_where_no_division_helps(
    monkeypatch,
):
    machine = ram_and(MIDDLE)
    words = half_turn(machine, *STILL)
    (message,) = checked(machine, guided(machine, words, vector=True))
    assert (
        message.code == "machine-unproven" and "vector" in message.text and message.severity is Severity.NOTE
    )
    monkeypatch.setattr(machine_way, "MOST_PARTS", 4)
    (message,) = checked(machine, guided(machine, words))
    assert (
        message.code == "machine-unproven"
        and (message.block, message.line) == (1, 2)
        and "1 blocks" in message.text
    )
    monkeypatch.setattr(machine_way, "MOST_PARTS", 8192)
    monkeypatch.setattr(machine_way, "MOST_ROWS", 3)
    assert codes(checked(machine, guided(machine, words))) == ["machine-unproven"]


def test_of_a_guided_rapid_the_ways_of_independent_axes_are_looked_at_too():
    """In the middle of the circle: on the guided way nothing is hit, on one of independent axes it is."""
    rapid = np.full(2, Motion.RAPID, np.int8)
    for carrier in ("Z", "spindle"):
        machine = ram_and(MIDDLE, carrier)
        program = guided(machine, half_turn(machine, *STILL), motion=rapid)
        assert not checked(machine, program)
        assert collides(codes(checked(machine, program, rapids="independent")))


def test_a_program_of_one_row_or_none_has_no_blocks_to_look_at():
    machine = ram_and(MIDDLE)
    words = half_turn(machine, *STILL)
    assert not checked(machine, guided(machine, words[:1])) and not checked(
        machine, guided(machine, words[:0])
    )


# ---------------------------------------------------------------------------------- played, and by the command


def test_play_shows_the_way_that_was_looked_at():
    machine = ram_and(beside(-1.0))
    words = half_turn(machine, (RADIUS, 0.0, 0.0), (RADIUS, 10.0, 4.0))
    program, kinematics = guided(machine, words), chain(machine, SETUP)
    play = Playback(kinematics, program, measure(kinematics, words))
    way = guided_way(machine, words, (0.0, 0.0, 0.0))
    for u in (0.0, 0.3, 0.5, 1.0):
        pose = play.at_block(1, u)
        assert pose.words == pytest.approx(way(u), abs=1e-9)
        assert pose.tip == pytest.approx([RADIUS, 10.0 * u, 4.0 * u], abs=1e-9) and pose.to_chord < 1e-9
    drawn = play.curve(1)
    assert (
        len(drawn) > 50
        and np.linalg.norm(np.cross(drawn - drawn[0], drawn[-1] - drawn[0]), axis=1).max() < 1e-6
    )
    in_step = Playback(kinematics, program_of(machine, words), measure(kinematics, words))
    assert np.linalg.norm(in_step.at_block(1, 0.5).tip - play.at_block(1, 0.5).tip) > 10.0


SHIPPED = (("trunnion_with_bodies", -90.0, 160.0, True), ("trunnion_with_bodies", -90.0, 35.0, False),
           ("head_table_with_bodies", -60.0, 150.0, True), ("head_table_with_bodies", -140.0, 150.0, False))  # fmt: skip


@some_in_core(("name", "height", "length", "free"), SHIPPED)
def test_a_guided_program_is_milled_on_machines_with_bodies_and_audited_alike(
    tmp_path, name, height, length, free
):
    """What is read again hits what was found when it was written, in the same line."""
    write_stl(from_triangles(box((-30, -20, height), (30, 20, height + 10))), tmp_path / "part.stl")
    given = [
        "--machine",
        name,
        "--cutter",
        "ball:6:30",
        "--tool-length",
        str(length),
        "--controller",
        "fanuc",
    ]
    result = [*["--passes", "planes", "--stepover", "8", "--tool-axis", "facet_mean", "--max-axis-angle", "91", "--spindle", "off"],
            *["--gouge", "off", "--linearize", "off", "--rtcp", "angles", "--tool", "1"]]  # fmt: skip
    nc, report = tmp_path / "p.nc", tmp_path / "r.json"
    found, again = (
        _machine_notes(cli.main([*task, *given, "--report", str(report)]), report)
        for task in (
            ["mill", str(tmp_path / "part.stl"), *result, "-o", str(nc)],
            ["audit", str(nc)],
        )
    )
    assert bool(found) != free and bool(again) != free
    assert {code for code, *_ in (*found, *again)} <= {"machine-collision"} and again <= found


def _machine_notes(code, report):
    """Codes, lines and what enters what, of what a command says of the machine."""
    assert code in (0, 1)
    return {
        (one["code"], one["line"], *(one["hit"] or {}).values())[:4]
        for one in json.loads(report.read_text())["findings"]
        if one["code"] in ("machine-collision", "machine-unproven")
    }
