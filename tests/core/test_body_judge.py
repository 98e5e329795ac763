# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another judge of bodies of a machine against each other: python-fcl, where it is installed, on dense
samples of 200 random scenes; of what it finds in a body that is smaller by the tolerance, nothing may be
untold."""

import math
from dataclasses import replace

import numpy as np
import pytest
from test_body_pairs import checked, places, words_at
from test_machine_bodies import LENGTH, MACHINES, ORIGIN

from freecad_fiveaxis.core.gouge.carried_motion import CarriedMotion
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain

fcl = pytest.importorskip("fcl", reason="python-fcl is the judge")
pytestmark = pytest.mark.slow
SCENES, SAMPLES, TOLERANCE = 40, 200, 0.05


def random_body(rng, carrier):
    middle, half = rng.uniform(-40, 40, 3), rng.uniform(10, 30, 3)
    name, kind = f"on {carrier}", rng.integers(3)
    if kind == 0:
        return MachineBody(name, carrier, "box", (tuple(middle - half), tuple(middle + half)))
    if kind == 1:
        return MachineBody(name, carrier, "sphere", (tuple(middle),), (float(half[0]),))
    return MachineBody(
        name, carrier, "cylinder", (tuple(middle - half), tuple(middle + half)), (float(half[1]),)
    )


def shape_of(body, smaller):
    """The shape of fcl that is as much smaller all about, and where it stands."""
    points = np.array(body.points)
    middle = points.mean(axis=0)
    if body.shape == "sphere":
        return fcl.CollisionObject(fcl.Sphere(body.radii[0] - smaller)), np.eye(3), middle
    way = points[1] - points[0]
    if body.shape == "box":
        return fcl.CollisionObject(fcl.Box(*(way - 2.0 * smaller))), np.eye(3), middle
    up = way / np.linalg.norm(way)
    side = np.cross(up, np.eye(3)[np.abs(up).argmin()])
    side /= np.linalg.norm(side)
    solid = fcl.Cylinder(body.radii[0] - smaller, np.linalg.norm(way) - 2.0 * smaller)
    return fcl.CollisionObject(solid), np.stack([side, np.cross(up, side), up], axis=1), middle


def hit_samples(machine, words, smaller):
    """How many samples of a straight way of the joints have both bodies in each other, one of them
    smaller."""
    setup = Setup(ORIGIN, LENGTH)
    zero, letters = words_at(machine, {})[0], chain(machine, setup).letters
    pair, hits = (
        [
            (body.carrier, *shape_of(body, by))
            for body, by in zip(machine.bodies, (0.0, smaller), strict=True)
        ],
        0,
    )
    for share in np.linspace(0.0, 1.0, SAMPLES):
        at = places(machine, dict(zip(letters, words[0] + share * (words[1] - words[0]) - zero, strict=True)))
        for carrier, solid, turn, middle in pair:
            place = at[carrier]
            solid.setTransform(fcl.Transform(place[:3, :3] @ turn, place[:3, :3] @ middle + place[:3, 3]))
        hits += fcl.collide(pair[0][1], pair[1][1], fcl.CollisionRequest(), fcl.CollisionResult()) > 0
    return hits


def judge(name, scenes=SCENES):
    """Missed scenes, how many hit and how many are free, and how deep those are that are told of and that no
    sample hits."""
    rng, plain = np.random.default_rng(13), load_machine(name)
    names = ["base", *(axis.letter for axis in plain.fitted)]
    names[-1] = "spindle"
    missed, hit, free, alone = [], 0, 0, []
    while hit + free < scenes:
        bodies = tuple(random_body(rng, str(one)) for one in rng.choice(names, 2, replace=False))
        machine = replace(plain, bodies=bodies)
        words = words_at(plain, {}, {}) + np.concatenate(
            [rng.uniform(-40, 40, (2, 3)), rng.uniform(-70, 70, (2, 2))], axis=1
        )
        found = checked(machine, words, tolerance=TOLERANCE)
        if any(one.code == "machine-touching" for one in found):
            continue
        reported = [one.value for one in found if "on " in one.hit.enters and "on " in one.hit.entered]
        if reported == [] and hit_samples(machine, words, 2.0 * TOLERANCE):
            missed.append((bodies, words.tolist()))
        if reported and not hit_samples(machine, words, 0.0):
            alone.append(reported[0])
        hit += bool(reported)
        free += not reported
    return missed, hit, free, alone


@pytest.mark.parametrize("name", MACHINES)
def test_fcl_finds_nothing_in_200_samples_a_block_that_is_not_reported(name):
    missed, hit, free, alone = judge(name)
    assert not missed and hit > 3 and free > 3
    assert all(depth < 1.0 for depth in alone), "what is told and never sampled is shallow or short"


def test_an_axis_forgotten_would_be_noticed(monkeypatch):
    """The step next to the moved body stands still."""
    lines = CarriedMotion.lines
    monkeypatch.setattr(
        CarriedMotion, "lines", lambda self, middle: lines(self, middle * (np.arange(middle.shape[1]) > 0))
    )
    assert judge("trunnion_ac")[0]


def test_a_turn_in_degrees_would_be_noticed(monkeypatch):
    lines = CarriedMotion.lines
    monkeypatch.setattr(
        CarriedMotion,
        "lines",
        lambda self, middle: lines(self, middle * np.where(self.rotary, math.pi / 180, 1.0)),
    )
    assert judge("trunnion_ac")[0]
