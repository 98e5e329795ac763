# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a ball that leans touches the part: what the picture shows."""

import numpy as np
from test_axis_field import NODES, take_nodes
from thorough import some_in_core
from underside_parts import PARTS

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.deepest import nearest_on_facet
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import draw
from freecad_fiveaxis.core.report.contacts import contacts_of
from freecad_fiveaxis.core.toolpath.cl_path import Motion

FLOOR = from_triangles(np.array([[(-50.0, -50.0, 0.0), (50.0, -50.0, 0.0), (0.0, 80.0, 0.0)]]))


def leaning(degrees):
    lean = np.radians(np.asarray(degrees, float))
    return np.column_stack([np.sin(lean), 0.0 * lean, np.cos(lean)])


def test_on_a_floor_the_contact_is_below_the_centre_whatever_the_lean():
    axis = leaning([-60, -20, 20, 40, 60])
    centre = np.column_stack([np.linspace(-10.0, 10.0, 5), np.zeros(5), np.full(5, 3.0)])
    known = contacts_of(centre, np.tile([0.0, 0.0, 1.0], (5, 1)), axis, np.zeros(5, int), FLOOR, 3.0, 3.0)
    tip = centre - 3.0 * axis
    np.testing.assert_allclose(known.find_touched(tip, axis), centre - (0.0, 0.0, 3.0), atol=1e-12)
    up = np.array([0.0, 0.0, 1.0])
    np.testing.assert_allclose(
        known.find_touched(tip + up, axis), centre - 2.0 * up, atol=1e-12
    )  # lifted, as it is
    assert (known.find_touched(tip + 50.0 * up, axis) == tip + 50.0 * up).all(), "far away it touches nothing"
    assert known.find_touched(tip[:0], axis[:0]).shape == (0, 3)


def test_a_tool_on_the_normals_has_tips_for_contacts():
    up = np.tile([0.0, 0.0, 1.0], (4, 1))
    assert contacts_of(3.0 * up, up, up, np.zeros(4, int), FLOOR, 3.0, 3.0) is None


def off_the_part(point, mesh):
    """The distance (n,) mm to the nearest facet, all of them tried."""
    corner = mesh.vertex[mesh.face]
    every = [
        np.linalg.norm(
            nearest_on_facet(np.repeat(one[:, :, None], len(point), axis=2), point.T).T - point, axis=1
        )
        for one in corner
    ]
    return np.min(every, axis=0)


@some_in_core("control_point", ["tip", "centre"], kept=(0,))
def test_strokes_of_a_free_axis_lie_on_the_part_where_tips_do_not(control_point, monkeypatch):
    take_nodes(monkeypatch, NODES)
    options = {
        "machine": "trunnion_ac",
        "tool_length": 120,
        "cutter": "ball:6",
        "stepover": 3,
        "control_point": control_point,
    }
    mesh = PARTS["tee"]()
    figures = job.figures(job.prove(job.make(build_settings("mill", "tee", options), mesh=mesh)))
    drawn = draw(figures)
    cut = figures.program.motion[drawn.block] == Motion.CUT
    ends = drawn.stroke.reshape(-1, 2, 3)[cut]
    assert np.percentile(off_the_part(ends[:, 1], mesh), 90) < 0.02
    driven = figures.tip[drawn.block[cut]]
    assert np.percentile(off_the_part(driven, mesh), 50) > 0.1, "tips would do"
