# SPDX-License-Identifier: LGPL-2.1-or-later
"""Between two free contacts the tool turns: what it meets there, against dense samples of the turn, and what
`auto` makes of it."""

import numpy as np
import pytest
from gouge_examples import prism
from mesh_shapes import box
from one_field import keep_fields
from plain import PLAIN
from test_axis_field import NODES as FEW
from test_axis_field import take_nodes
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation import axis_field, free_turns
from freecad_fiveaxis.core.orientation.auto_axis import Free
from freecad_fiveaxis.core.orientation.free_turns import find_blocked_turns, lead_out
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter

STEP = [(0, 0), (40, 0), (40, 40), (20, 40), (20, 10), (0, 10)]
LEAN = np.radians(50.0)
BAR = np.array([[-1.0, -6.0, 30.0], [1.0, 6.0, 34.0]])  # low and high corner, mm


def result_on(mesh, up, **options):
    faces = (mesh.normal[:, 2] > 0.9) & (mesh.vertex[mesh.face][..., 2].max(axis=1) <= up)
    given = {"machine": "trunnion_ac", "stepover": 2, "clearance": 10, **options}
    return job.make(build_settings("mill", "part", given), mesh=mesh, faces=faces)


def distance_to_bar(point):
    return np.linalg.norm(point - np.clip(point, *BAR), axis=-1)


def test_a_turn_through_a_bar_over_a_floor_is_found_and_one_beside_it_is_not():
    mesh = from_triangles(np.concatenate([box((-20, -20, -5), (20, 20, 0)), box(*BAR)]))
    path = result_on(mesh, 0.0, **PLAIN, gouge="off", direction=0, linearize="off").offset
    side = np.where(np.arange(len(path.point)) % 2 == 0, 1.0, -1.0)
    axis = np.column_stack([side * np.sin(LEAN), np.zeros(len(side)), np.full(len(side), np.cos(LEAN))])
    found = find_blocked_turns(path, axis, mesh, Reacher(Cutter(4.0, 60.0)))

    share, up = np.linspace(0.0, 1.0, 400), np.linspace(0.0, 58.0, 400)
    for row in range(1, len(axis)):
        if path.polyline[row] != path.polyline[row - 1]:
            assert not found[row]
            continue
        centre = path.centre[row - 1] + share[:, None] * (path.centre[row] - path.centre[row - 1])
        lean = LEAN * side[row - 1] * (1.0 - 2.0 * share)
        turned = np.column_stack([np.sin(lean), np.zeros(len(lean)), np.cos(lean)])
        least = distance_to_bar(centre[:, None] + up[None, :, None] * turned[:, None]).min()
        if abs(least - 2.0) > 0.3:  # the samples of the turn are 5 deg apart
            assert found[row] == (least < 2.0), (row, least)
    assert found.any() and not found[1:][np.diff(path.polyline) == 0].all()


def test_small_turns_and_ends_of_polylines_are_not_requested():
    mesh = from_triangles(box((-20, -20, -5), (20, 20, 0)))
    path = result_on(mesh, 0.0, **PLAIN, gouge="off").offset
    assert not find_blocked_turns(
        path, np.tile([0.0, 0.0, 1.0], (len(path.point), 1)), mesh, Reacher(Cutter(4.0))
    ).any()


def test_only_moves_at_pieces_with_a_way_out_are_requested():
    none, here, out = (int(one) for one in Free)
    free = np.array([none, none, here, out, here, none, none, here, here, none, out, none, here, here, out])
    polyline = np.array([0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2])
    wanted = lead_out(polyline, free)
    assert np.flatnonzero(wanted).tolist() == [2, 3, 4, 5, 10, 11, 13, 14]
    for row in range(1, len(free)):  # walked one by one
        piece = [row - 1, row] if polyline[row] == polyline[row - 1] else [row]
        while piece[0] and free[piece[0]] and free[piece[0] - 1] and polyline[piece[0] - 1] == polyline[row]:
            piece.insert(0, piece[0] - 1)
        while (
            piece[-1] + 1 < len(free)
            and free[piece[-1]]
            and free[piece[-1] + 1]
            and polyline[piece[-1] + 1] == polyline[row]
        ):
            piece.append(piece[-1] + 1)
        assert wanted[row] == (free[piece] == out).any(), row
    assert not lead_out(polyline[:0], free[:0]).any()


@pytest.mark.thorough
@some_in_core("nodes", [FEW, axis_field.NODES])
def test_a_short_tool_does_not_turn_its_holder_through_the_part(nodes, monkeypatch):
    """And where its turns are not asked, it does."""

    def met():
        result = result_on(
            prism(STEP, length=11.0), 40.0, cutter="ball:6:12", holder="40x30", gouge="report", stepover=6
        )
        return [one.code for one in job.prove(result).findings if one.code in ("holder-collision", "overcut")]

    take_nodes(monkeypatch, nodes)
    keep_fields(monkeypatch)
    assert not met()
    monkeypatch.setattr(free_turns, "find_blocked_turns", lambda path, axis, *_: np.zeros(len(axis), bool))
    assert met()
