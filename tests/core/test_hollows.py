# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed hollows of a part: found by their shells, and never called reachable. Areas in closed form."""

import json
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.hollows import find_hollow_facets
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher
from freecad_fiveaxis.core.orientation.no_way_out import report_no_way_out
from freecad_fiveaxis.core.studies.reach_map import reach_map
from freecad_fiveaxis.core.tool import Cutter

BALL = Cutter(6.0, 15.0)
SIDES = [(0, 2, 6, 4), (1, 5, 7, 3), (0, 4, 5, 1), (2, 3, 7, 6), (0, 1, 3, 2), (4, 6, 7, 5)]


def box(low, high, inward=False):
    """The twelve triangles of a box between two corners, mm; all look outward, or all inward."""
    corner = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    corner = low + corner * np.subtract(high, low)
    found = [corner[[*side]][[0, k, k + 1]] for side in SIDES for k in (1, 2)]
    return np.array(found)[:, ::-1] if not inward else np.array(found)


def with_void():
    """60 x 50 x 40 mm with a closed hollow 30 x 24 x 20 inside: 14800 mm2 outside, 3600 mm2 in it."""
    return np.concatenate([box((0, 0, 0), (60, 50, 40)), box((15, 13, 10), (45, 37, 30), True)])


def area_found(triangles):
    """mm2 of the mesh and of what of it looks into a closed hollow."""
    mesh = from_triangles(triangles)
    return float(mesh.area.sum()), float(mesh.area[find_hollow_facets(mesh)].sum())


def test_the_walls_of_a_void_are_in_a_closed_hollow_and_so_is_what_lies_loose_in_it():
    assert area_found(with_void()) == pytest.approx((18400.0, 3600.0))
    loose = box((20, 20, 12), (30, 30, 22))
    assert area_found(np.concatenate([with_void(), loose])) == pytest.approx((19000.0, 4200.0))
    beside = box((70, 0, 0), (80, 10, 10))
    assert area_found(np.concatenate([with_void(), beside])) == pytest.approx((19000.0, 3600.0))


def test_solids_that_touch_along_an_edge_or_a_face_are_closed_all_the_same():
    for other in (box((60, 50, 0), (90, 90, 40)), box((60, 0, 0), (90, 50, 40))):
        assert area_found(np.concatenate([with_void(), other]))[1] == pytest.approx(3600.0)
    at_the_edge = box((5, 5, 30), (15, 13, 35), True)  # two voids that share a corner
    assert area_found(np.concatenate([with_void(), at_the_edge]))[1] == pytest.approx(3600.0 + 340.0)


def test_of_an_open_part_no_room_is_called_closed():
    assert area_found(with_void()[1:])[1] == 0.0


def test_a_void_within_what_lies_in_a_void_is_one_too():
    loose = np.concatenate([box((17, 15, 12), (43, 35, 28)), box((25, 20, 15), (35, 30, 25), True)])
    inner, loose_area = 600.0, 2 * (26 * 20 + 26 * 16 + 20 * 16)
    assert area_found(np.concatenate([with_void(), loose]))[1] == pytest.approx(3600.0 + loose_area + inner)


def test_what_is_open_or_looks_inward_beside_the_part_is_no_hollow():
    outer = box((0, 0, 0), (60, 50, 40))
    assert area_found(outer)[1] == 0.0
    assert area_found(outer[:, ::-1])[1] == 0.0, "all of it turned outward"
    turned = np.concatenate([outer, box((70, 0, 0), (80, 10, 10), True)])
    assert area_found(turned)[1] == 0.0, "inside out, but nothing is round it"
    for side in range(12, 24, 2):
        missing = np.delete(with_void(), [side, side + 1], axis=0)
        assert area_found(missing)[1] == 0.0, "a void with a wall missing encloses nothing"


def test_no_place_of_a_void_is_reachable_and_no_longer_tool_is_proposed_for_it():
    """The ball of 6 mm, and a holder of 30 mm once the tool stands out 80 mm, would stand in it freely."""
    mesh = from_triangles(with_void())
    within = find_hollow_facets(mesh)
    for holder in ((), ((30.0, 30.0),)):
        found = reach_map(mesh, Reacher(BALL, holder=holder))
        hollow = found.obstacle == Obstacle.HOLLOW
        assert found.area_of(Obstacle.HOLLOW) == pytest.approx(3600.0)
        assert (hollow == within[found.facet]).all()
        assert np.isnan(found.tilt[hollow]).all() and np.isnan(found.axis[hollow]).all()
        assert found.area_of(Obstacle.NONE) == pytest.approx(14800.0) and found.longer == ()
    only = reach_map(mesh, Reacher(BALL), within)
    assert only.area_of(Obstacle.HOLLOW) == pytest.approx(only.area.sum()) == pytest.approx(3600.0)


def test_every_report_names_the_hollow(tmp_path, capsys):
    path, report = tmp_path / "part.stl", [tmp_path / f"reach{end}" for end in (".json", ".html")]
    write_stl(from_triangles(with_void()), path)
    words = ["reach", str(path), "--machine", "trunnion_ac", "--cutter", "ball:6:15"]
    assert cli.main([*words, *(word for one in report for word in ("--report", str(one)))]) == cli.DONE
    message, summary = capsys.readouterr().out, json.loads(report[0].read_text())["summary"]
    assert "in a closed hollow" in message and "in a closed hollow" in report[1].read_text()
    assert summary["by_reason"]["closed_hollow"] == pytest.approx(3600.0)
    assert summary["reachable_area"] <= 14800.0 + 1e-6
    assert summary["reachable_area"] + sum(summary["by_reason"].values()) == pytest.approx(summary["area"])


def test_passes_without_a_way_out_are_distinguished_and_name_a_holder_only_where_there_is_one():
    """Ten rows 1 mm apart on facet 0, which is outside, and five on one of the void; the first two stay."""
    mesh = from_triangles(with_void())
    face = np.repeat([0, int(np.flatnonzero(find_hollow_facets(mesh))[0])], [10, 5])
    point = np.arange(15.0)[:, None] * [1.0, 0.0, 0.0]
    path = SimpleNamespace(point=point, polyline=(face > 0).astype(int), face=face)
    rows = np.array([0, 1])
    bare, held = Reacher(BALL), Reacher(BALL, holder=((30.0, 30.0),))
    hollow, other = report_no_way_out(path, rows, mesh, bare)
    assert (hollow.value, other.value) == (4.0, 8.0) and hollow.code == other.code == "no-way-out"
    assert "closed hollow" in hollow.text and "holder" not in hollow.text
    assert "get out along its axis" in other.text and "holder" not in other.text
    assert "smaller holder" in report_no_way_out(path, rows, mesh, held)[1].text
    assert len(report_no_way_out(path, np.arange(10), mesh, held)) == 1
    assert report_no_way_out(path, np.arange(15), mesh, held) == ()
