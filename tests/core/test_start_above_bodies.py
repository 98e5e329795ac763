# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs begin and end above all that the axes of a machine carry, wherever the axes stand before; what is
not known of that is said."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from plain import build_settings
from scipy.spatial.transform import Rotation

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.gouge.above_bodies import find_clearings
from freecad_fiveaxis.core.gouge.machine_check import InMachine
from freecad_fiveaxis.core.machine import SafeStart, load_machine, save_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import scope, summary
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of
from freecad_fiveaxis.core.toolpath.apt import ClHead, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

MACHINE, LENGTH, RADIUS = "trunnion_with_bodies", 100.0, 3.0
PIVOT = np.array([0.0, 0.0, -50.0])
STEEP = math.radians(80.0)
PART = np.array([-10.0, -10.0, -100.0]), np.array([10.0, 10.0, 0.0])


def needs(name, length, **changes):
    """The words of Z from which on the tool is above each body, work zero in the machine's zero."""
    machine = replace(load_machine(name), **changes)
    setup = Setup((0.0, 0.0, 0.0), length)
    given = InMachine(machine, setup, chain(machine, setup), body_of(Cutter(2 * RADIUS, RADIUS)), length)
    return {one.name: one for one in find_clearings(given, PART, 0.0)}


def limited(name, letter, low, high):
    axes = load_machine(name).axes
    return tuple(replace(one, low=low, high=high) if one.letter == letter else one for one in axes)


@pytest.mark.parametrize("most", [120.0, 90.0, 40.0])
def test_the_plane_is_that_of_the_closed_form(most):
    """At |A| a corner that stands y beside and z above A's axis is y sin|A| + z cos A above it."""
    axes = limited(MACHINE, "A", -math.radians(most), math.radians(most))
    found = needs(MACHINE, LENGTH, axes=axes)
    angle = np.radians(np.linspace(0.0, most, 100_001))

    def top(y, *heights):
        return max(float((y * np.sin(angle) + z * np.cos(angle)).max()) for z in heights) + PIVOT[2]

    rim = 90.0 / math.cos(math.pi / 48)  # flat sides go round it from outside
    assert top(90.0, -85.0, -50.0) - 1e-9 <= found["platter"].z <= top(rim, -85.0, -50.0) + 0.2
    assert top(90.0, -120.0, -85.0) - 1e-9 <= found["bridge"].z <= top(90.0, -120.0, -85.0) + 0.2
    assert top(60.0, -120.0, 100.0) - 1e-9 <= found["left cheek"].z <= top(60.0, -120.0, 100.0) + 0.2
    assert found["left post"].z == pytest.approx(60.0) and found["left post"].still
    assert not found["platter"].still


@pytest.mark.parametrize("length", [150.0, 5.0])
def test_a_head_that_leans_reaches_down_by_what_it_carries(length):
    """B turns 120 mm above the gauge point: with a short tool the spindle's nose, 45 mm in radius, is lowest
    where it leans by atan(45 / 120)."""
    found = needs("head_table_with_bodies", length)
    tip, nose = 120.0 + length, math.hypot(45.0 / math.cos(math.pi / 48), 120.0)
    want = -140.0 + max(nose, tip) - tip
    assert want - 1e-9 <= found["platter"].z <= want + 0.15


def test_a_wall_that_nothing_reaches_in_x_and_y_needs_no_height():
    far, near = (
        MachineBody(name, "base", "box", ((x, -900.0, -400.0), (x + 50.0, 900.0, 300.0)))
        for name, x in (("far", 566.0), ("near", 564.0))  # X goes to 500, the spindle is 65 mm wide
    )
    bodies = (*load_machine(MACHINE).bodies, far, near)
    found = needs(MACHINE, LENGTH, bodies=bodies)
    assert "far" not in found
    assert found["near"].z == pytest.approx(300.0 - LENGTH - 60.0), "the spindle alone reaches it"


# Programs.


def cl_file(folder):
    """A cut with a steeply leaning axis, below A's axis."""
    axis = np.tile((0.0, math.sin(STEEP), math.cos(STEEP)), (4, 1))
    tip = np.array([(0, 40, -60), (0, 20, -60), (4, 20, -61), (4, 40, -61)], float)
    motion = np.array([Motion.RAPID, Motion.CUT, Motion.CUT, Motion.RAPID], np.int8)
    feed, none = np.where(motion == Motion.RAPID, 0.0, 500.0), np.full(4, -1)
    path = CLPath(tip, axis, motion, feed, tip, axis, none, none, none)
    (folder / "a.apt").write_bytes(write_apt(path, Cutter(2 * RADIUS, RADIUS), "a", head=ClHead()))
    return str(folder / "a.apt")


def posted(folder, **changes):
    """The result of a post on the machine with these changes."""
    save_machine(replace(load_machine(MACHINE), **changes), folder / "m.fcm", overwrite=True)
    given = {"machine": str(folder / "m.fcm"), "tool_length": LENGTH, "controller": "linuxcnc"}
    wanted = given | {"spindle": 8000.0, "cutter": f"ball:{2 * RADIUS:g}"}
    return job.prove(job.make(build_settings("post", cl_file(folder), wanted)))


def ends_of(nc):
    """The rapids before the first feed, and behind the last, as (letter, value) words."""
    lines = [re.findall(r"([XYZAC])(-?[\d.]+)", line) for line in nc.decode().splitlines()
             if line.startswith(("G0 ", "G1 "))]  # fmt: skip
    feeds = [k for k, line in enumerate(line for line in nc.decode().splitlines()
             if line.startswith(("G0 ", "G1 "))) if line.startswith("G1")]  # fmt: skip
    return lines[: feeds[0]], lines[feeds[-1] + 1 :]


def tool_points(x, y, z):
    """Points of tool, spindle nose and spindle, mm, machine frame, for a tip (n,) there."""
    shapes = ((0.3, 60.0, RADIUS - 0.3, 24), (LENGTH, LENGTH + 60.0, 32.0, 8),
              (LENGTH + 60.0, LENGTH + 260.0, 65.0, 12))  # fmt: skip
    turn = np.linspace(0.0, 2.0 * math.pi, 13)
    one = np.concatenate([
        np.stack([(r * np.outer(np.ones(n), np.cos(turn))).ravel(), (r * np.outer(np.ones(n), np.sin(turn))).ravel(),
                  np.repeat(np.linspace(low, high, n), len(turn))], 1)
        for low, high, r, n in shapes
    ])  # fmt: skip
    return np.stack([x, y, z], -1)[:, None, :] + one


def is_hit(q):
    """Whether tool or spindle are in platter, cheeks, bridge or posts with the tip at words q (n, 5), X Y Z A
    C, by turns of its own: what A carries sees the tool turned the other way, which A's words do."""
    place = tool_points(*q[:, :3].T)
    off = place - PIVOT
    seen = np.stack(
        [
            Rotation.from_rotvec((a, 0.0, 0.0)).apply(one)
            for a, one in zip(np.radians(q[:, 3]), off, strict=True)
        ]
    )
    seen += PIVOT
    x, y, z = np.moveaxis(seen, -1, 0)
    hit = (np.hypot(x, y) < 90.0) & (z > -135.0) & (z < -100.0)
    hit |= (np.abs(y) < 60.0) & (z > -170.0) & (z < 50.0) & (np.abs(x) > 160.0) & (np.abs(x) < 190.0)
    hit |= (np.abs(x) < 160.0) & (np.abs(y) < 90.0) & (z > -170.0) & (z < -135.0)
    x, y, z = np.moveaxis(place, -1, 0)
    hit |= (np.abs(y) < 90.0) & (np.abs(x) > 200.0) & (np.abs(x) < 280.0) & (z < 60.0)
    return bool(hit.any())


def drive(start, lines, count=400):
    """Drive from words ``start`` (5,) along lines, and tell whether something is hit on a line."""
    at, hit = np.array(start, float), False
    for line in lines:
        to = at.copy()
        for letter, value in line:
            to["XYZAC".index(letter)] = float(value)
        hit |= is_hit(at + np.linspace(0.0, 1.0, count)[:, None] * (to - at))
        at = to
    return hit


STARTS = [(0, 400, 0, 0), (400, 0, 0, 0), (-450, 450, 0, 90), (300, -300, 120, 0), (0, -400, -120, 30),
          (0, 80, 0, 0), (0, -70, 60, 0), (170, 0, 100, -200), (0, 0, -119, 0), (0, 100, 0, 45)]  # fmt: skip


def begin(nc, start, plane):
    """Whether the first lines of a program hit something, Z being on the plane already: nobody knows its way
    up."""
    first, _ = ends_of(nc)
    x, y, a, c = start
    return drive((x, y, plane, a, c), first)


@pytest.mark.thorough
@pytest.mark.oldest
def test_from_unknown_places_nothing_is_hit_and_the_plane_of_the_part_alone_would_hit(tmp_path):
    result = posted(tmp_path)
    plane = result.draft.plane.z
    assert plane == 93.0 and result.draft.plane.above.z == 93.0  # the bridge at A 120, 88, and the clearance
    assert result.draft.nc.count(b"\nG0 Z93.0000\n") == 2
    assert [begin(result.draft.nc, start, plane) for start in STARTS] == [False] * len(STARTS)
    assert not drive(result.draft.program.words[-1], ends_of(result.draft.nc)[1])
    bare = posted(tmp_path, bodies=())
    old = bare.draft.plane.z
    assert old < 40.0 and bare.draft.plane.above is None
    assert sum(begin(bare.draft.nc, start, old) for start in STARTS) >= 4
    moved = [line for line in result.draft.nc.splitlines() if line != b"G0 Z93.0000"]
    same = [line for line in bare.draft.nc.splitlines() if line != f"G0 Z{old:.4f}".encode()]
    assert moved[1:] == same[1:], "only the plane is another one"


def scope_of(result):
    figures = job.figures(result)
    return scope(figures, summary(figures))


def test_what_is_proven_of_start_and_end_is_stated_and_what_is_not_known(tmp_path):
    found = scope_of(posted(tmp_path))
    assert any(one.startswith("from the first block to the last tool and spindle") for one in found.proven)
    assert any(one.startswith("where the program begins and ends, at Z 93,") for one in found.proven)
    assert any("the way of Z up to 93" in one for one in found.unknown)
    for retract in ("reference", "none"):
        found = scope_of(posted(tmp_path, safe_start=SafeStart(retract)))
        assert not any("begins and ends" in one for one in found.proven)
        assert any("how the axes come to the first block" in one for one in found.unknown)


@pytest.mark.parametrize("changes", [{}, {"bodies": ()}], ids=["bodies", "bare"])
def test_an_audit_says_that_the_lines_before_the_first_block_were_not_looked_at(changes, tmp_path):
    result = posted(tmp_path, **changes)
    (tmp_path / "a.ngc").write_bytes(result.draft.nc)
    given = {"machine": str(tmp_path / "m.fcm"), "tool_length": LENGTH, "cutter": f"ball:{2 * RADIUS:g}"}
    audited = job.prove(job.make(build_settings("audit", str(tmp_path / "a.ngc"), given)))
    found = scope_of(audited)
    assert not any("begins and ends" in one for one in found.proven)
    assert any("how the axes come to the first block" in one for one in found.unknown)


def test_where_z_ends_below_the_bodies_that_is_a_warning_and_not_called_proven(tmp_path):
    result = posted(tmp_path, axes=limited(MACHINE, "Z", -500.0, 150.0))
    (one,) = [one for one in result.findings if one.code == "start-below-bodies"]
    assert one.severity is Severity.WARNING and one.value == pytest.approx(93.0, abs=0.1)
    assert one.limit == 50.0 and result.draft.nc.count(b"\nG0 Z50.0000\n") == 2
    assert "bridge" in one.text and "bed" not in one.text and "shorter tool" in one.text
    found = scope_of(result)
    assert not any("begins and ends" in one for one in found.proven)
    assert any("how the axes come to the first block" in one for one in found.unknown)


@pytest.mark.parametrize(("z", "clear"), [(193.1, True), (192.5, False)])
def test_a_machine_coordinate_is_held_against_the_bodies_too(z, clear, tmp_path):
    result = posted(tmp_path, safe_start=SafeStart("machine", z))
    assert ("start-below-bodies" in [one.code for one in result.findings]) == (not clear)
    assert (result.draft.plane.above is not None) == clear
    if clear:
        assert result.draft.plane.above.z == pytest.approx(z - LENGTH)


def test_a_wall_that_z_cannot_pass_raises_nothing_and_is_named(tmp_path):
    wall = MachineBody("wall", "base", "box", ((-400.0, 400.0, -400.0), (400.0, 480.0, 700.0)))
    result = posted(tmp_path, bodies=(*load_machine(MACHINE).bodies, wall))
    assert result.draft.plane.z == 93.0 and result.draft.plane.above.but_for == ("wall",)
    assert any("meet wall on the way" in one for one in scope_of(result).unknown)


def test_a_roof_through_which_z_comes_down_is_an_error_at_the_first_block(tmp_path):
    top = LENGTH + 260.0
    first = posted(tmp_path).draft.program.words[0]
    x, y, z = (float(one) for one in first[:3])
    roof = ((x - 20.0, y - 20.0, z + top + 5.0), (x + 20.0, y + 20.0, z + top + 15.0))
    result = posted(
        tmp_path, bodies=(*load_machine(MACHINE).bodies, MachineBody("roof", "base", "box", roof))
    )
    hits = [one for one in result.findings if one.code == "machine-collision"]
    assert hits and all("Where Z comes down to the first block" in one.text for one in hits)
    assert {one.block for one in hits} <= {0, len(result.draft.program.words) - 1} and "roof" in hits[0].text
    assert all(one.severity is Severity.ERROR for one in hits)
