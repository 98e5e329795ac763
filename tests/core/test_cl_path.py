# SPDX-License-Identifier: LGPL-2.1-or-later
"""The linked path: order, provenance, feeds, and rapids against the inflated box by an independent
segment-box test."""

from dataclasses import replace

import numpy as np
import pytest
from offset_examples import ball, field, hull, joined, prism

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.passes import slice_mesh
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import LinkOptions, Motion, link_passes
from freecad_fiveaxis.core.toolpath.cl_path.linking import keepout, way_out
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

CUTTER = Cutter(10.0)
UP = AxisOptions()
MESH = from_faces([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
LOW, HIGH = np.array([-20.0, -20, 0]), np.array([20.0, 20, 20])


def three_passes():
    """Two polylines, then one, then two; each of two facets with an arc between."""
    parts = [prism([(x, 0), (x + 5, 2), (x + 10, 0)]) for x in (0.0, 20.0, 5.0, 0.0, 20.0)]
    path = joined(*parts)
    shift = np.repeat([0.0, 0, 1, 2, 2], 4)
    path = replace(path, pass_=shift.astype(int), point=path.point + shift[:, None] * (0, 1, 0))
    return close_gaps(path, MESH, 5.0, 1.0)


def linked(path, axis, low=LOW, high=HIGH, **options):
    return link_passes(path, axis, CUTTER, low, high, LinkOptions(**options))


def on_the_part(path):
    return path.pass_ >= 0


def upright(path):
    return tool_axes(path, "fixed", UP)


def crosses_box(start, end, low, high, samples=None):
    """Does the open inside of the box meet the segment? By clipping its parameter range with one slab after
    the other."""
    near, far = 0.0, 1.0
    for k in range(3):
        step = end[k] - start[k]
        if step == 0.0:
            if not low[k] < start[k] < high[k]:
                return False
            continue
        a, b = sorted(((low[k] - start[k]) / step, (high[k] - start[k]) / step))
        near, far = max(near, a), min(far, b)
    return near < far


def check_rapids(path, low, high, clearance, radius=0.0):
    """Every rapid's chord of the tip, and of the ball's centre with its radius, against the inflated box."""
    count = 0
    for row in np.flatnonzero(path.motion == Motion.RAPID):
        if row:
            count += 1
            for off, more in ((0.0, 0.0), (radius, radius)):
                ends = path.tip[row - 1 : row + 1] + off * path.axis[row - 1 : row + 1]
                assert not crosses_box(*ends, low - clearance - more, high + clearance + more), row
    return count


def test_the_segment_box_test_can_tell():
    low, high = np.zeros(3), np.ones(3)
    assert crosses_box((-1, 0.5, 0.5), (2, 0.5, 0.5), low, high)
    assert crosses_box((0.5, 0.5, 0.5), (0.5, 0.5, 0.6), low, high)
    assert not crosses_box((-1, 1.0, 0.5), (2, 1.0, 0.5), low, high)
    assert not crosses_box((-1, 0.5, 0.5), (-0.1, 0.5, 0.5), low, high)
    assert not crosses_box((-1, 0.9, 0.5), (0.5, 2.5, 0.5), low, high)


# ---- order
# -----------------------------------------------------------------------------------------------------------


def test_the_passes_keep_their_order():
    offset = three_passes()
    path = linked(offset, upright(offset))
    on = on_the_part(path)
    np.testing.assert_allclose(path.contact[on], offset.point)
    assert path.pass_[on].tolist() == offset.pass_.tolist()
    assert (path.motion[on] == Motion.FILL).tolist() == offset.fill.tolist()


def test_fill_is_the_move_that_stays_where_it_is():
    offset = three_passes()
    path = linked(offset, upright(offset))
    for row in np.flatnonzero(on_the_part(path) & (path.motion != Motion.LINK)):
        still = np.allclose(path.contact[row], path.contact[row - 1], atol=1e-12)
        assert (path.motion[row] == Motion.FILL) == still


# ---- tip, feeds, rows between
# ----------------------------------------------------------------------------------------


def test_the_tip_lies_one_radius_behind_the_centre_and_the_centre_can_be_driven():
    offset = three_passes()
    axis = tool_axes(offset, "facet_mean", UP)
    tip, centre = (linked(offset, axis, control_point=point) for point in ("tip", "centre"))
    np.testing.assert_allclose(tip.tip + 5 * tip.axis, centre.tip, atol=1e-12)
    np.testing.assert_allclose(centre.tip[on_the_part(centre)], offset.centre)


def test_motions_and_feeds_of_one_link():
    offset = close_gaps(joined(prism([(0, 0), (10, 0)]), prism([(0, 0), (10, 0)])), MESH, 5.0, 1.0)
    path = linked(offset, upright(offset), feed=900.0, plunge_feed=200.0, clearance=3.0)
    names = "".join("CFLR"[k] for k in path.motion)
    assert names == "RRLC" + "LRRRLC" + "LR"
    assert path.feed.tolist() == [0, 0, 200, 900, 900, 0, 0, 0, 200, 900, 900, 0]
    clear, safe = 20 + 3 + 0.001, 20 + 3 + 0.001 + 2
    np.testing.assert_allclose(
        path.tip[:, 2], [safe, clear, 0, 0, clear, safe, safe, clear, 0, 0, clear, safe]
    )
    np.testing.assert_allclose(path.tip[:, 0], [0, 0, 0, 10, 10, 10, 0, 0, 0, 10, 10, 10])


def test_rows_between_have_no_provenance_and_those_on_the_part_do():
    offset = three_passes()
    path = linked(offset, tool_axes(offset, "facet_mean", UP))
    off = ~on_the_part(path)
    assert (path.face[off] == -1).all() and (path.coedge[off] == -1).all() and (path.face[~off] >= 0).all()
    np.testing.assert_array_equal(path.contact[off], path.tip[off])
    np.testing.assert_array_equal(path.normal[off], path.axis[off])
    assert (path.motion[off] >= Motion.LINK).all()
    assert np.count_nonzero(~off & (path.motion == Motion.LINK)) == 5  # the end of each approach


def test_polylines_that_touch_go_on_without_a_retract():
    parts = joined(prism([(0, 0), (10, 0)]), prism([(10, 0), (20, 0)]), prism([(20, 0), (30, 1)]))
    offset = close_gaps(parts, MESH, 5.0, 1.0)
    path = linked(offset, upright(offset), feed=900.0, plunge_feed=200.0)
    assert "".join("CFLR"[k] for k in path.motion) == "RRLC" + "LC" + "LRRRLC" + "LR"
    assert path.feed[4] == 900


# ---- rapids
# ----------------------------------------------------------------------------------------------------------


def test_the_path_begins_and_ends_with_a_rapid_on_the_safe_plane():
    offset = three_passes()
    path = linked(offset, upright(offset))
    assert path.motion[0] == path.motion[-1] == Motion.RAPID
    assert min(path.tip[0, 2], path.tip[-1, 2]) > HIGH[2] + 5


def test_links_run_along_the_tool_axis():
    mesh = ball(150)
    offset = close_gaps(slice_mesh(mesh, np.linspace(-12, 12, 4), 0.3), mesh, 5.0, 0.1)
    path = linked(offset, tool_axes(offset, "facet_mean", UP), mesh.vertex.min(0), mesh.vertex.max(0))
    for row in np.flatnonzero(path.motion == Motion.LINK):
        move = path.tip[row] - path.tip[row - 1]
        np.testing.assert_allclose(np.cross(move, path.axis[row]), 0, atol=1e-9)
        np.testing.assert_allclose(path.axis[row], path.axis[row - 1], atol=1e-12)


def random_part(seed):
    """A random part, cut on all sides or from above, with random passes and axes that may be horizontal or
    look down."""
    rng = np.random.default_rng(seed)
    kind = seed % 3
    if kind == 0:
        mesh = ball(60, rng.uniform(5, 30, 3), seed)
    elif kind == 1:
        corner = rng.uniform(3, 20, 3)
        mesh = hull(np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * corner)
    else:
        mesh = field(lambda x, y: 2 * np.sin(x / 5 + seed) * np.cos(y / 6), 12)
    across = mesh.vertex @ (-np.sin(seed), np.cos(seed), 0)
    offsets = np.linspace(across.min(), across.max(), 7)[1:-1]
    path = close_gaps(slice_mesh(mesh, offsets, float(seed)), mesh, 5.0, 0.1)
    options = AxisOptions(tuple(rng.normal(size=3)), *rng.uniform(-1, 1, 2))
    strategy = ("facet_mean", "step_weighted", "fixed")[seed // 3 % 3]
    return mesh, path, tool_axes(path, strategy, options)


@pytest.mark.parametrize("clearance", [0.0, 1.0, 5.0])
@pytest.mark.parametrize("seed", range(18))
def test_rapids_never_cross_the_inflated_box(seed, clearance):
    mesh, offset, axis = random_part(seed)
    low, high = mesh.vertex.min(0), mesh.vertex.max(0)
    path = linked(offset, axis, low, high, clearance=clearance)
    assert check_rapids(path, low, high, clearance, CUTTER.radius) >= 4
    centre = linked(offset, axis, low, high, clearance=clearance, control_point="centre")
    np.testing.assert_allclose(centre.tip, path.tip + 5 * path.axis, atol=1e-9)


@pytest.mark.parametrize("seed", range(9))
def test_the_axis_turns_only_on_the_safe_plane(seed):
    mesh, offset, axis = random_part(seed)
    high = mesh.vertex.max(0)
    path = linked(offset, axis, mesh.vertex.min(0), high, clearance=2.0)
    rapid = np.flatnonzero(path.motion == Motion.RAPID)
    rapid = rapid[(rapid > 0)]
    turns = rapid[np.abs(path.axis[rapid] - path.axis[rapid - 1]).max(axis=1) > 1e-12]
    centre = path.tip + 5 * path.axis
    assert (np.minimum(centre[turns, 2], centre[turns - 1, 2]) >= high[2] + 2 + 5 + 2).all()
    assert (np.minimum(path.tip[turns, 2], path.tip[turns - 1, 2]) >= high[2] + 2 + 2).all()
    steep = np.setdiff1d(rapid, turns)
    across = np.abs(path.tip[steep, :2] - path.tip[steep - 1, :2]).max(axis=1) > 1e-9
    below = centre[steep, 2] < mesh.vertex[:, 2].min()
    assert ((centre[steep, 2] >= high[2] + 9) | ~across | below).all()


def test_a_horizontal_axis_retracts_sideways_and_goes_straight_up():
    offset = close_gaps(prism([(0, 0), (0, 10)]), MESH, 5.0, 1.0)  # travels up a wall that looks to -x
    low, high = np.array([0.0, -10, 0]), np.array([30.0, 10, 10])
    path = linked(offset, tool_axes(offset, "facet_mean", UP), low, high, clearance=2.0)
    assert "".join("CFLR"[k] for k in path.motion) == "RRLCLR"
    np.testing.assert_allclose(path.axis, np.tile((-1.0, 0, 0), (6, 1)))
    np.testing.assert_allclose(path.tip[[0, 1, 4, 5], 0], -2.001)
    np.testing.assert_allclose(path.tip[:, 2], [19.001, 0, 0, 10, 10, 19.001])


def test_an_axis_that_looks_down_gets_out_sideways_and_says_so():
    offset = close_gaps(prism([(10, 0), (0, 0)]), MESH, 5.0, 1.0)  # the underside
    axis = tool_axes(offset, "facet_mean", UP)
    np.testing.assert_allclose(axis[:, 2], -1)
    low, high = np.array([0.0, -10, 0]), np.array([30.0, 10, 10])
    path = linked(offset, axis, low, high, clearance=2.0)
    assert check_rapids(path, low, high, 2.0, 5.0) == 4
    assert [(finding.code, finding.severity, finding.value) for finding in path.findings] == [
        ("retract-below-part", Severity.WARNING, 2.0)
    ]


def test_a_path_that_looks_up_has_no_findings():
    offset = three_passes()
    assert linked(offset, upright(offset)).findings == ()


# ---- settings
# --------------------------------------------------------------------------------------------------------


def test_no_passes_is_stated():
    offset = three_passes()
    empty = replace(
        offset,
        **{
            name: getattr(offset, name)[:0]
            for name in offset.__dataclass_fields__
            if name not in ("findings", "middle")
        },
    )
    with pytest.raises(SettingsError, match="no passes"):
        linked(empty, np.empty((0, 3)))


@pytest.mark.parametrize(
    "options",
    [
        {"clearance": -1.0}, {"clearance": np.nan}, {"feed": 0.0}, {"feed": np.inf}, {"plunge_feed": -3.0},
        {"control_point": "gauge"},
    ],
)  # fmt: skip
def test_options_out_of_range_are_refused_by_name(options):
    with pytest.raises(SettingsError, match=next(iter(options))):
        LinkOptions(**options)


def test_an_axis_that_leans_by_less_than_any_number_tells_leaves_the_part_as_an_upright_one_does():
    keep = keepout((0.0, 0.0, -5.0), (10.0, 10.0, 0.0), 3.0, 5.0)
    centre = np.array([[5.0, 5.0, 1.5], [5.0, 5.0, 1.5]])
    axis = np.array([[0.0, 0.0, 1.0], [1e-320, -1e-320, 1.0]])
    upright, leaning = way_out(centre, axis, keep).station
    np.testing.assert_array_equal(leaning, upright)
