# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another judge of tool and spindle against bodies of the machine: python-fcl, where it is installed, on
dense samples of 200 random scenes; a tool that is smaller by the tolerance must hit nothing that the check
does not tell of."""

from dataclasses import replace

import numpy as np
import pytest
from test_machine_bodies import LENGTH, MACHINES, NOSE, ORIGIN, RADIUS, carriers, checked, frames, joints_at

from freecad_fiveaxis.core.gouge.machine_bodies import make_mesh
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody

fcl = pytest.importorskip("fcl", reason="python-fcl is the judge")
pytestmark = pytest.mark.slow
SCENES, SAMPLES, TOLERANCE = 40, 200, 0.05


def random_body(rng, carrier):
    middle, half = rng.uniform(-25, 25, 3) + ORIGIN, rng.uniform(8, 20, 3)
    if rng.random() < 0.5:
        return MachineBody("body", carrier, "box", (tuple(middle - half), tuple(middle + half)))
    if rng.random() < 0.5:
        return MachineBody("body", carrier, "sphere", (tuple(middle),), (float(half[0]),))
    return MachineBody(
        "body", carrier, "cylinder", (tuple(middle - half), tuple(middle + half)), (float(half[1]),)
    )


def stack(smaller):
    """Shapes of fcl and the heights of their middles, as much smaller all about."""
    rows = ((RADIUS, 40.0, RADIUS), (40.0, LENGTH, 15.0), (LENGTH, LENGTH + 60.0, 35.0))
    found = [
        (fcl.Cylinder(r - smaller, high - low - 2 * smaller), 0.5 * (low + high)) for low, high, r in rows
    ]
    return [*found, (fcl.Sphere(RADIUS - smaller), RADIUS)]


def hit_samples(machine, words, body, smaller):
    """How many of the samples of a straight way of the joints have the tool in the body, whose facets are a
    mesh."""
    gauge = np.array(machine.gauge_point) - (0, 0, LENGTH)
    mesh, model = make_mesh(body, np.zeros(3)), fcl.BVHModel()
    model.beginModel(len(mesh.vertex), len(mesh.face))
    model.addSubModel(mesh.vertex, mesh.face)
    model.endModel()
    solid, tools = (
        fcl.CollisionObject(model),
        [(fcl.CollisionObject(shape), at) for shape, at in stack(smaller)],
    )
    hits = 0
    share = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    carried, tools_at = frames(machine, joints_at(machine, words[0] + share * (words[1] - words[0])))
    for place, tool in zip(np.broadcast_to(carried[body.carrier], tools_at.shape), tools_at, strict=True):
        solid.setTransform(fcl.Transform(place[:3, :3], place[:3, 3]))
        for one, at in tools:
            one.setTransform(fcl.Transform(tool[:3, :3], tool[:3, :3] @ (gauge + (0, 0, at)) + tool[:3, 3]))
        hits += any(
            fcl.collide(one, solid, fcl.CollisionRequest(), fcl.CollisionResult()) > 0 for one, _ in tools
        )
    return hits


def judge(name, scenes=SCENES):
    """Missed scenes, and how many hit and how many are free, and those that are told of though not even the
    tool as it is hits."""
    rng, plain = np.random.default_rng(11), load_machine(name)
    missed, hit, free, alone = [], 0, 0, []
    for scene in range(scenes):
        body = random_body(rng, str(rng.choice(carriers(plain))))
        machine = replace(plain, bodies=(body, NOSE))
        words = np.concatenate([rng.uniform(-60, 60, (2, 3)), rng.uniform(-60, 60, (2, 2))], axis=1)
        reported = [one for one in checked(machine, words, TOLERANCE) if one.code == "machine-collision"]
        sampled = hit_samples(machine, words, body, 1.5 * TOLERANCE)
        missed += [scene] if sampled and not reported else []
        alone += (
            [(scene, reported[0].value)] if reported and not hit_samples(machine, words, body, 0.0) else []
        )
        hit += bool(sampled)
        free += not reported
    return missed, hit, free, alone


@pytest.mark.parametrize("name", MACHINES)
def test_fcl_finds_nothing_in_200_samples_a_block_that_is_not_reported(name):
    missed, hit, free, alone = judge(name)
    assert not missed and hit > 5 and free > 2
    assert all(depth < 1.0 for _, depth in alone), "what is told and never sampled is shallow or short"


def test_a_body_on_another_axis_would_be_noticed(monkeypatch):
    from freecad_fiveaxis.core.gouge import machine_check

    monkeypatch.setattr(machine_check, "find_locked_letters", lambda machine, body: "")
    assert judge("trunnion_ac")[0]


def test_a_forgotten_bend_would_be_noticed(monkeypatch):
    from freecad_fiveaxis.core.gouge import check

    def unbent(*given):
        swept = bent(*given)
        return replace(swept, bend_tip=0.0 * swept.bend_tip, bend_axis=0.0 * swept.bend_axis)

    bent = check.real_motion
    monkeypatch.setattr(check, "real_motion", unbent)
    assert judge("trunnion_ac")[0]
