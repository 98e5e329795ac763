# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures and part against the bodies of the machine on which they are clamped, and units of their files."""

import json
from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box
from test_machine_bodies import ORIGIN, machine_file

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.placing import find_overlap, report_placing
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup

SETUP = Setup(ORIGIN, 80.0)
PLATTER = MachineBody("platter", "C", "cylinder", ((0.0, 0.0, -135.0), (0.0, 0.0, -100.0)), (90.0,))
CRADLE = MachineBody("cradle", "A", "box", ((-160.0, -90.0, -170.0), (160.0, 90.0, -135.0)))
BED = MachineBody("bed", "X", "box", ((-400.0, -300.0, -120.0), (400.0, 300.0, -80.0)))


def solid(low, high):
    """A box of the machine frame as it is in the work frame."""
    return from_triangles(box(low, high) - ORIGIN)


def placed(*bodies, part=None, fixtures=()):
    machine = replace(load_machine("trunnion_ac"), bodies=bodies)
    return report_placing(machine, SETUP, part, [Fixture("vise", one) for one in fixtures])


@pytest.mark.parametrize(
    ("low", "deep"),
    [(-100.0, None), (-100.9, None), (-103.0, 3.0), (-112.0, 12.0), (-130.0, 12.5)],
)
def test_a_vise_in_the_platter_is_reported_with_both_names_and_the_depth(low, deep):
    """25 mm high and 50 wide: it stands on the platter, is sunk, or lies wholly within it."""
    found = placed(PLATTER, CRADLE, BED, fixtures=[solid((-25.0, -25.0, low), (25.0, 25.0, low + 25.0))])
    assert [one.code for one in found] == ["fixture-in-body"] * (deep is not None)
    if deep:
        (one,) = found
        assert "vise" in one.text and "platter" in one.text and one.severity.name == "WARNING"
        least = min(-100.0 - low, low + 160.0, 30.0)
        assert 0.9 * deep <= one.value <= max(least, deep) + 1e-6


def test_a_part_that_is_sunk_in_the_platter_is_reported():
    below = solid((-30.0, -30.0, -108.0), (30.0, 30.0, -60.0))
    (one,) = placed(PLATTER, part=below)
    assert one.code == "part-in-body" and "platter" in one.text and one.value == pytest.approx(8.0, rel=0.1)
    assert not placed(PLATTER, part=solid((-30.0, -30.0, -100.0), (30.0, 30.0, -60.0)))


def test_a_body_of_the_machine_that_lies_within_a_fixture_is_reported():
    (one,) = placed(PLATTER, fixtures=[solid((-200.0, -200.0, -300.0), (200.0, 200.0, 100.0))])
    assert one.code == "fixture-in-body"
    same = solid((-160.0, -90.0, -170.0), (160.0, 90.0, -135.0))
    assert find_overlap(same, same)[0] >= 1.0


@pytest.mark.parametrize(
    ("factor", "suspected"), [(1.0, False), (1 / 25.4, True), (0.001, True), (25.4, True), (1000.0, True)]
)
def test_a_fixture_or_a_body_in_other_units_is_suspected(tmp_path, factor, suspected):
    vise = box((0.0, 0.0, 0.0), (200.0, 100.0, 80.0)) * factor
    path = str(tmp_path / "vise.stl")
    write_stl(from_triangles(vise), path)
    far = from_triangles(vise + (0.0, 0.0, 500.0))
    of_fixture = placed(fixtures=[far])
    of_body = placed(MachineBody("vise", "Z", "file", file=path))
    for found in (of_fixture, of_body):
        assert [one.code for one in found] == ["unit-suspected"] * suspected
        assert not found or "vise" in found[0].text
    if suspected:
        assert "--stl-units" in of_fixture[0].text and "in mm" in of_body[0].text


def test_the_command_line_reports_a_vise_in_the_platter_and_units(tmp_path):
    write_stl(from_triangles(box((-10, -10, 0), (10, 10, 10))), tmp_path / "part.stl")
    write_stl(from_triangles(box((-40, 20, -20), (40, 40, -5))), tmp_path / "vise.stl")
    write_stl(from_triangles(box((0.1, 0, -0.1), (0.2, 0.1, 0))), tmp_path / "small.stl")
    platter = {"low": [0, 0, -60], "high": [0, 0, -15], "radius": 100}
    machine = machine_file(tmp_path, [{"name": "platter", "carrier": "C", "cylinder": platter}])
    given = ["mill", str(tmp_path / "part.stl"), "--machine", str(machine), "--cutter", "ball:6"]
    given += ["--passes", "planes", "--stepover", "4", "--spindle", "off", "--tool-axis", "fixed"]
    given += ["--fixture", str(tmp_path / "vise.stl"), "--fixture", str(tmp_path / "small.stl")]
    given += ["--quiet", "--report", str(tmp_path / "r.json"), "-o", str(tmp_path / "o.ngc")]
    cli.main(given)
    found = json.loads((tmp_path / "r.json").read_text())["findings"]
    codes = [one["code"] for one in found]
    assert codes.count("fixture-in-body") == 1 and codes.count("unit-suspected") == 1
    (one,) = (one for one in found if one["code"] == "fixture-in-body")
    assert one["value"] == pytest.approx(5.0, rel=0.1) and np.isfinite(one["place"]).all()
