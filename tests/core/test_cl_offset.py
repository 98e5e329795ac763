# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters that are no balls through the whole pipeline: they keep out of the part, leave the scallop asked
for, and say where they do not."""

import json
from dataclasses import replace

import numpy as np
import pytest
from cutter_body import depth, facet_points, inside
from gouge_examples import knob_in_corner
from plain import build_settings
from scipy.spatial import cKDTree
from thorough import some_in_core
from uncured import UNCURED

from freecad_fiveaxis.core.geometry.mesh import from_faces, read_stl, write_stl
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.orientation.spacing_radius import spacing_radius
from freecad_fiveaxis.core.orientation.strategies import AxisOptions
from freecad_fiveaxis.core.pipeline import job, outputs, solve_joints
from freecad_fiveaxis.core.pipeline import options as wanted
from freecad_fiveaxis.core.pipeline.settings import flat_options
from freecad_fiveaxis.core.tool import Cutter, parse_cutter
from freecad_fiveaxis.core.toolpath import cl_offset as seating
from freecad_fiveaxis.core.toolpath.apt import read_apt, read_cl_file, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import Motion

CUTTERS = ("flat:10", "bull:10:2", "taperball:6:5deg", "taperbull:8:1:5deg")


UNASKED = {**UNCURED, "rest": "on"}
"""What stays uncut is the matter of the map of rest material, which is drawn where a program is proven: none
looks for it while the path is made."""


@pytest.fixture(scope="module")
def milled(parts):
    """Results by part, machine and options, each made once, of which none asks what stays uncut: that takes
    longer than all that is looked at here."""
    outcome = {}

    def mill(part, machine, **options):
        key = (part, machine, *sorted(options.items()))
        if key not in outcome:
            given = {"machine": machine, "stepover": 5, "tool_length": 120, **UNCURED, **options}
            with pytest.MonkeyPatch.context() as patched:
                patched.setattr(solve_joints, "find_uncut", lambda context, path: ())
                outcome[key] = job.run(build_settings("mill", str(parts / f"{part}.stl"), given))
        return outcome[key]

    return mill


@pytest.fixture(scope="module")
def points(parts):
    """Points on every facet of an example part, each made once."""
    outcome = {}

    def of(part):
        if part not in outcome:
            outcome[part] = facet_points(read_stl(str(parts / f"{part}.stl")), 0.5)
        return outcome[part]

    return of


def on_part(outcome):
    """Tip and axis of every row that cuts, of the path that is driven."""
    cuts = outcome.path.motion <= Motion.FILL
    return outcome.path.tip[cuts], outcome.path.axis[cuts]


def axes_at_same_contacts(one, other):
    """The axes of two paths where both touch the same point: rows that crowd are merged in each by itself."""
    paths = [(draft.path.contact[cuts], draft.path.axis[cuts]) for draft in (one, other)
             for cuts in [draft.path.motion <= Motion.FILL]]  # fmt: skip
    off, row = cKDTree(paths[1][0]).query(paths[0][0])
    same = off < 1e-9
    assert same.sum() > 20
    return paths[0][1][same], paths[1][1][row[same]]


# --------------------------------------------------------------------------------- through the whole pipeline


@pytest.mark.parametrize("cutter", CUTTERS)
@some_in_core("lead, tilt", [(0, 0), (5, 0), (0, 5)])
def test_on_a_dome_no_cutter_enters_the_facets_and_none_stays_off(cutter, lead, tilt, milled, points):
    """By no more than the dome's facets themselves leave the sphere (0.0085 mm), and every row touches."""
    outcome = milled("dome", "trunnion_ac", cutter=cutter, lead=lead, tilt=tilt, stepover=9).draft
    deep = depth(parse_cutter(cutter), *on_part(outcome), points("dome"))
    assert deep.max() < 0.006
    assert np.quantile(deep, 0.02) > -0.1  # as near as the points on the facets stand to the contact


@pytest.mark.slow
@pytest.mark.parametrize("cutter", CUTTERS)
def test_on_a_saddle_a_lead_keeps_every_cutter_out_of_the_hollow(cutter, milled, points):
    outcome = milled("saddle", "trunnion_ac", cutter=cutter, lead=10).draft
    assert depth(parse_cutter(cutter), *on_part(outcome), points("saddle")).max() < 0.004
    assert not [finding for finding in outcome.findings if finding.code == "heel-in-hollow"]


@pytest.fixture
def estimated(monkeypatch):
    """A list of the deepest heel, mm, that is behind the finding of each path made from now on."""
    seen, heel_depth = [], seating.heel_depth

    def spied(*given):
        depths = heel_depth(*given)
        seen.append(depths.max())
        return depths

    monkeypatch.setattr(seating, "heel_depth", spied)
    return seen


def heels_of(outcome):
    return [finding for finding in outcome.findings if finding.code == "heel-in-hollow"]


@some_in_core("cutter", ["flat:10", "bull:10:2", "taperbull:8:1:5deg"], kept=(1,))
def test_a_heel_in_a_hollow_along_the_pass_is_as_deep_as_estimated(cutter, parts, points, estimated):
    given = {"machine": "trunnion_ac", "cutter": cutter, "stepover": 5, "tool_length": 120, **UNASKED}
    outcome = job.make(build_settings("mill", str(parts / "saddle.stl"), given))
    deep = depth(parse_cutter(cutter), *on_part(outcome), points("saddle"))
    assert len(heels_of(outcome)) == 1 and deep.max() > 0.1
    assert estimated[-1] == pytest.approx(deep.max(), rel=0.15)


@some_in_core("cutter", ["bull:8:1.5", "flat:6"], kept=(1,))
@pytest.mark.parametrize("gouge", ["off", "report"])
def test_across_the_pass_a_heel_may_be_deeper_so_no_depth_is_reported_and_the_check_settles_it(
    cutter, gouge, estimated
):
    """A ball in a corner. With the check on, its own finding says how deep."""
    mesh = knob_in_corner(cells=24)
    given = {"machine": "trunnion_ac", "cutter": cutter, "stepover": 6, "direction": 0, "tool_length": 120}
    given |= {**UNCURED, "tool_axis": "fixed", "max_axis_angle": 60, "gouge": gouge}
    result = job.prove(job.make(build_settings("mill", "knob", given), mesh=mesh))
    heels = heels_of(result)
    assert bool(heels) == (gouge == "off")
    assert all(heel.value is None and "not known" in heel.text and " mm" not in heel.text for heel in heels)
    assert ("overcut" in {one.code for one in result.findings}) == (gouge == "report")
    deep = depth(parse_cutter(cutter), *on_part(result.draft), facet_points(mesh, 0.5)).max()
    assert deep > 1.15 * estimated[0]


@pytest.mark.thorough
def test_after_a_lift_nothing_says_that_the_heel_stands_in_the_part(parts):
    given = {
        "machine": "trunnion_ac",
        "cutter": "bull:10:2",
        "stepover": 20,
        "tool_length": 120,
        **UNCURED,
        "gouge": "lift",
    }
    result = job.prove(job.make(build_settings("mill", str(parts / "saddle.stl"), given)))
    assert heels_of(result.draft) and not heels_of(result)
    assert "lifted" in {one.code for one in result.findings}


@pytest.mark.parametrize(("part", "lead"), [("dome", 5), ("saddle", 10)])
@pytest.mark.parametrize("cutter", CUTTERS)
def test_the_program_is_the_path_and_its_deviation_that_of_a_dense_walk(part, lead, cutter, milled):
    result = milled(part, "trunnion_ac", cutter=cutter, lead=lead)
    words, kinematics, path = result.draft.program.words, result.draft.kinematics, result.draft.joints.path
    read = read_nc(result.draft.nc, kinematics, result.draft.dialect)
    own = np.isin(read.line, result.draft.program.line)  # the others are those of the safe start and end
    assert (~own).sum() == 2
    tip, axis = forward(kinematics, words_to_q(read.words[own]))
    row = result.draft.program.row
    assert (
        np.linalg.norm(tip - path.tip[row], axis=1).max() < 2e-3
        and np.linalg.norm(axis - path.axis[row], axis=1).max() < 1e-5
    )
    block = np.argsort(result.deviation.segment)[[-1, -2, -30, -100, 40]]
    q, u = words_to_q(words), np.linspace(0, 1, 2001)[:, None]
    for b in block[block > 0]:
        walk, _ = forward(kinematics, q[b - 1] + u * (q[b] - q[b - 1]))
        chord = walk[-1] - walk[0]
        foot = np.clip((walk - walk[0]) @ chord / max(chord @ chord, 1e-30), 0, 1)
        dense = np.linalg.norm(walk - walk[0] - foot[:, None] * chord, axis=1).max()
        assert dense <= result.deviation.bound[b] + 1e-9
        assert result.deviation.segment[b] == pytest.approx(dense, rel=1e-5, abs=1e-6)


@some_in_core(
    "cutter, options",
    [("flat:10", {"singularity": "deform"}), ("bull:10:2", {"singularity": "deform"}), ("flat:10", {"tool_axis": "step_weighted"}),
     pytest.param("bull:10:2", {"tool_axis": "minimax", "max_tilt": 3}, marks=pytest.mark.slow)],
    kept=(2,),
)  # fmt: skip
def test_the_tip_follows_an_axis_that_was_corrected(cutter, options, milled, points):
    """The axes are others than the strategy's, and still the cutter touches the dome and does not enter
    it."""
    given = {"cutter": cutter, "stepover": 5, "max_axis_angle": 11}
    outcome = milled("dome", "trunnion_ac", **given, **options).draft
    plain = milled("dome", "trunnion_ac", **given).draft
    assert np.abs(np.subtract(*axes_at_same_contacts(outcome, plain))).max() > 1e-3
    deep = depth(parse_cutter(cutter), *on_part(outcome), points("dome"))
    assert np.quantile(deep, 0.02) > -0.1 and deep.max() < 0.005


def test_a_path_whose_tips_stayed_behind_would_be_noticed(milled, points):
    given = {"cutter": "bull:10:2", "stepover": 17, "max_axis_angle": 40}
    tip, _ = on_part(milled("dome", "trunnion_ac", **given).draft)
    _, axis = on_part(milled("dome", "trunnion_ac", lead=3, **given).draft)
    assert depth(parse_cutter("bull:10:2"), tip, axis, points("dome")).max() > 0.05


@pytest.mark.parametrize("cutter", ["flat:10", "bull:10:2", "ball:10"])
def test_the_driven_point_of_control_point_centre_is_the_hub(cutter, milled):
    tip = milled("dome", "trunnion_ac", cutter=cutter, lead=5, stepover=17).draft.path
    hub = milled("dome", "trunnion_ac", cutter=cutter, lead=5, stepover=17, control_point="centre").draft.path
    np.testing.assert_allclose(hub.tip - parse_cutter(cutter).corner * hub.axis, tip.tip, atol=1e-9)


@pytest.mark.parametrize("shape", [*CUTTERS, "ball:10"])
@pytest.mark.parametrize(("lead", "tilt"), [(0, 0), (15, 0), (10, -20)])
def test_on_a_plane_every_tip_is_that_of_its_contact(shape, lead, tilt, tmp_path):
    write_stl(surface(SURFACES["plane"], count=5), tmp_path / "plane.stl")
    given = {
        "machine": "trunnion_ac",
        "cutter": shape,
        "lead": lead,
        "tilt": tilt,
        "stepover": 5,
        "direction": 20,
        "order": "one_way",
    }
    path, cutter = (
        job.make(build_settings("mill", str(tmp_path / "plane.stl"), given)).path,
        parse_cutter(shape),
    )
    cuts = path.motion <= Motion.FILL
    normal = np.array([[0.0, -0.3, 1.0]]).repeat(cuts.sum(), 0) / np.hypot(1, 0.3)
    feed = np.array([[np.cos(np.radians(20)), np.sin(np.radians(20)), 0.3 * np.sin(np.radians(20))]]).repeat(
        cuts.sum(), 0
    )
    feed /= np.linalg.norm(feed, axis=1)[:, None]
    np.testing.assert_allclose(
        path.tip[cuts], cutter.tip_from_contact(path.contact[cuts], normal, path.axis[cuts], feed), atol=1e-4
    )


def test_a_ball_is_not_seated():
    """Its path comes back as it is, whatever its axes."""
    path, axis = object(), np.zeros((3, 3))
    assert seating.cl_offset_path(path, axis, Cutter(10.0), 0.01) == (path, axis)


# ------------------------------------------------------------------------------------------------ edges


def roof(slope):
    """Two planes that meet in a ridge along y at x = 0, each falling by ``slope`` rad; with sides and a
    bottom."""
    z = 30 - 30 * np.tan(slope)
    top = [(-30, -30, z), (-30, 30, z), (0, -30, 30), (0, 30, 30), (30, -30, z), (30, 30, z)]
    low = [(x, y, 0) for x, y, _ in top]
    quads = [(0, 2, 3, 1), (2, 4, 5, 3), (6, 7, 9, 8), (8, 9, 11, 10), (0, 1, 7, 6), (4, 10, 11, 5), (0, 6, 8, 2), (2, 8, 10, 4), (1, 3, 9, 7), (3, 5, 11, 9)]  # fmt: skip
    face = [(a, b, c) for a, b, c, d in quads] + [(a, c, d) for a, b, c, d in quads]
    return from_faces(np.array([*top, *low], float), np.array(face))


@pytest.mark.parametrize("cutter", ["flat:10", "bull:10:2", "bull:10:0.5"])
@pytest.mark.parametrize("slope", [8, 20, 40])
def test_over_a_ridge_no_cutter_cuts_the_edge(cutter, slope, tmp_path):
    """The axis turns over each long facet; rows between keep the bottom on it within the co-edge
    tolerance."""
    mesh = roof(np.radians(slope))
    write_stl(mesh, tmp_path / "roof.stl")
    given = {"machine": "trunnion_ac", "cutter": cutter, "stepover": 20, "max_axis_angle": 60, **UNASKED}
    outcome = job.make(build_settings("mill", str(tmp_path / "roof.stl"), given))
    tip, axis = on_part(outcome)
    same = np.diff(outcome.path.pass_[outcome.path.motion <= Motion.FILL]) == 0
    half = [0.5 * (part[1:] + part[:-1])[same] for part in (tip, axis)]
    half[1] /= np.linalg.norm(half[1], axis=1)[:, None]
    rows = np.arange(len(half[0]))[:: max(len(half[0]) // 300, 1)]
    top = facet_points(mesh, 1.0)
    assert depth(parse_cutter(cutter), tip, axis, top).max() < 0.011
    assert depth(parse_cutter(cutter), half[0][rows], half[1][rows], top).max() < 0.03


@pytest.mark.parametrize("cutter", ["flat:10", "bull:10:2"])
@pytest.mark.parametrize(("slope", "options", "gouges"), [
    (-5, {}, True), (-5, {"tool_axis": "fixed"}, True), (-5, {"lead": 10}, False), (-20, {"lead": 10}, True), (-45, {}, True),
])  # fmt: skip
def test_in_a_valley_the_bottom_is_reported_of_where_it_cuts_and_only_there(
    cutter, slope, options, gouges, tmp_path, estimated
):
    """Concave edges are trimmed for the corner circle alone; what the rest of the bottom does there is
    said."""
    mesh = roof(np.radians(slope))
    write_stl(mesh, tmp_path / "valley.stl")
    given = {
        "machine": "trunnion_ac",
        "cutter": cutter,
        "stepover": 20,
        "max_axis_angle": 60,
        **UNCURED,
        **options,
    }
    outcome = job.make(build_settings("mill", str(tmp_path / "valley.stl"), given))
    deep = depth(parse_cutter(cutter), *on_part(outcome), facet_points(mesh, 1.0)).max()
    assert (deep > 0.1) == gouges == bool(heels_of(outcome))
    assert not gouges or 0.95 * deep < estimated[-1] < 1.8 * deep


def test_the_flank_of_a_tapered_cutter_stays_out_of_steep_walls(milled, points):
    given = {"cutter": "taperball:6:20deg", "tool_axis": "fixed"}
    outcome = milled("dome", "trunnion_ac", **given).draft
    (left,) = [finding for finding in outcome.findings if finding.code == "flank-into-part"]
    assert left.value > 10.0
    assert depth(parse_cutter("taperball:6:20deg"), *on_part(outcome), points("dome")).max() < 0.004
    assert (outcome.offset.normal @ [0, 0, 1]).min() >= np.sin(np.radians(20)) - 1e-5
    gentle = milled("dome", "trunnion_ac", cutter="ball:6", tool_axis="fixed").draft
    assert not [finding for finding in gentle.findings if finding.code == "flank-into-part"]


# ------------------------------------------------------------------------------------------------ scallops


def surface(height, size=24.0, count=81):
    """A solid block with ``height(x, y)`` on top."""
    x, y = np.meshgrid(*[np.linspace(-size / 2, size / 2, count)] * 2, indexing="ij")
    vertex = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    row = np.arange(count * count).reshape(count, count)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return from_faces(vertex, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


SURFACES = {
    "plane": lambda x, y: 0.3 * y,
    "cylinder across": lambda x, y: np.sqrt(40.0**2 - y * y),
    "cylinder along": lambda x, y: np.sqrt(40.0**2 - x * x),
    "sphere": lambda x, y: np.sqrt(40.0**2 - x * x - y * y),
}


def rest_over(outcome, cutter, height, most):
    """What stands above the surface mid-way along the passes, from the first to the last of them, mm: sampled
    columns of material that every position of the cutter, the passes finely divided, cuts down."""
    path = outcome.path
    cuts = (
        np.flatnonzero(
            (path.motion[1:] <= Motion.FILL) & (path.pass_[1:] == path.pass_[:-1]) & (path.pass_[1:] >= 0)
        )
        + 1
    )
    cuts = cuts[np.abs(path.contact[cuts, 0] - 0.37) < 2 * cutter.ring]
    share = np.linspace(0, 1, 4)[:, None, None]
    tip, axis = (
        ((1 - share) * part[cuts - 1] + share * part[cuts]).reshape(-1, 3) for part in (path.tip, path.axis)
    )
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    y = np.sort(np.unique(np.round(path.contact[cuts, 1], 6)))
    y = np.linspace(y[0], y[-1], 102)[1:-1]
    step, x = 1e-4, np.full(len(y), 0.37)
    foot = np.stack([x, y, height(x, y)], axis=1)
    slope = np.stack(
        [(height(x + step, y) - height(x - step, y)), (height(x, y + step) - height(x, y - step))], axis=1
    ) / (2 * step)
    normal = np.column_stack([-slope, np.ones(len(y))])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    level = np.linspace(0, most, 101)
    hub, rest = tip + cutter.corner * axis, np.full(len(y), most)
    for row in range(len(y)):
        near = np.flatnonzero(np.linalg.norm(hub - foot[row], axis=1) < cutter.radius + 1)
        column = (foot[row] + level[:, None] * normal[row])[None] - hub[near, None]
        cut = (
            inside(cutter, column.reshape(-1, 3), np.repeat(axis[near], len(level), axis=0)).reshape(
                -1, len(level)
            )
            >= 0
        )
        rest[row] = level[cut.any(axis=0).argmax()] if cut.any() else most
    return rest


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "shape", "lead"),
    [("plane", "bull:6:1", 5), ("cylinder across", "flat:6", 5), ("cylinder along", "flat:6", 5), ("cylinder along", "flat:6", 0),
     ("cylinder across", "bull:6:1", 0), ("sphere", "bull:6:1", 5), ("sphere", "flat:6", 0)],
)  # fmt: skip
def test_the_scallop_left_is_what_was_requested(name, shape, lead, tmp_path):
    scallop, cutter = 0.05, parse_cutter(shape)
    write_stl(surface(SURFACES[name]), tmp_path / "part.stl")
    given = {
        "machine": "trunnion_ac",
        "cutter": shape,
        "lead": lead,
        "scallop": scallop,
        "order": "one_way",
        **UNASKED,
    }
    outcome = job.make(build_settings("mill", str(tmp_path / "part.stl"), given))
    rest = rest_over(outcome, cutter, SURFACES[name], 3 * scallop)
    assert rest.max() <= 1.05 * scallop
    assert lead == 0 or rest.max() >= 0.35 * scallop  # no needless passes; a level bottom may leave none
    ball = job.make(build_settings("mill", str(tmp_path / "part.stl"), given | {"cutter": "ball:6"}))
    assert outcome.contact.pass_.max() < ball.contact.pass_.max()  # what such a cutter is taken for


def test_a_scallop_that_is_too_high_would_be_noticed(tmp_path):
    write_stl(surface(SURFACES["plane"]), tmp_path / "part.stl")
    given = {
        "machine": "trunnion_ac",
        "cutter": "bull:6:1",
        "lead": 5,
        "stepover": 5,
        "order": "one_way",
        **UNCURED,
    }
    outcome = job.make(build_settings("mill", str(tmp_path / "part.stl"), given))
    assert rest_over(outcome, parse_cutter("bull:6:1"), SURFACES["plane"], 0.3).max() > 0.1


def test_under_a_fixed_axis_the_narrowest_stand_counts():
    mesh = surface(lambda x, y: np.where(y > 0, 0.5 * y, 0.0), count=13)
    level, every = mesh.normal[:, 2] > 0.999, np.ones(len(mesh.normal), bool)

    def radius(cutter, keep, strategy):
        return spacing_radius(cutter, mesh, keep, 0.0, strategy, AxisOptions(), 0.01)

    flat = parse_cutter("flat:10")
    wide, narrow = (radius(flat, keep, "fixed") for keep in (level, ~level))
    assert wide > 1000.0 and narrow < 0.02
    assert radius(flat, every, "fixed") == pytest.approx(narrow)
    assert radius(flat, ~level, "facet_mean") == pytest.approx(wide, rel=0.02)
    assert radius(Cutter(10.0), ~level, "fixed") == 5.0


# --------------------------------------------------------------------------------- CL files, job files, heads


@pytest.mark.parametrize("shape", [*CUTTERS, "ball:10", "taperbull:8:0:3deg:40"])
def test_a_cl_file_says_the_cutter_and_gives_it_back(shape, milled):
    path, cutter = milled("dome", "trunnion_ac", stepover=20).draft.path, parse_cutter(shape)
    text = write_apt(path, cutter, "dome")
    back = read_cl_file(text).head.cutter
    assert (back.diameter, back.corner, back.taper) == pytest.approx(
        (cutter.diameter, cutter.corner, cutter.taper), abs=2e-4
    )
    assert back.length == (cutter.length if cutter.taper else 50.0)
    np.testing.assert_allclose(read_apt(text).tip, path.tip, atol=1e-6)


@pytest.mark.parametrize(
    ("statement", "sizes"),
    [("CUTTER/10,2", (10, 2, 0)), ("CUTTER/10,5", (10, 5, 0)), ("CUTTER/10,0", (10, 0, 0)), ("CUTTER/10,2,3,2,0,0,40", (10, 2, 0)),
     ("CUTTER/5.49836,3,0,3,0,5,40", (6, 3, 5)), ("CUTTER/5.49836,3,0,3,0,5", (6, 3, 5)), ("UNITS/INCHES\nCUTTER/0.5,0.1", (12.7, 2.54, 0)),
     ("CUTTER/10", None), ("CUTTER/10,2,3,2,30,0,40", None), ("CUTTER/10,2,3,4,0,0,40", None), ("CUTTER/10,2,3,2,0,-5,40", None),
     ("CUTTER/10,6", None), ("CUTTER/10,2,-3,2,0,0,40", None)],
)  # fmt: skip
def test_cutter_statements_of_other_systems(statement, sizes):
    head = read_cl_file(
        f"{statement}\nMULTAX/ON\nFEDRAT/100\nGOTO/0,0,0,0,0,1\nGOTO/1,0,0,0,0,1\nFINI\n"
    ).head
    if sizes is None:
        assert head.cutter is None and head.diameter > 0.0
    else:
        assert (head.cutter.diameter, head.cutter.corner, np.degrees(head.cutter.taper)) == pytest.approx(
            sizes, abs=2e-4
        )


def test_post_notes_another_shape(parts, tmp_path):
    given = {
        "machine": "trunnion_ac",
        "cutter": "bull:10:2",
        "stepover": 15,
        "cl": str(tmp_path / "a.apt"),
        **UNCURED,
    }
    outputs.write_outputs(job.run(build_settings("mill", str(parts / "dome.stl"), given)))

    def notes(cutter):
        outcome = job.make(
            build_settings(
                "post",
                str(tmp_path / "a.apt"),
                {"machine": "trunnion_ac", "cutter": cutter, "linearize": "off"},
            )
        )
        return [finding for finding in outcome.findings if finding.code == "cutter-differs"]

    assert not notes("bull:10:2")
    assert "bull 10 mm, corner 2 mm" in notes("ball:10")[0].text and "retracts" in notes("bull:8:2")[0].text


@some_in_core("shape", CUTTERS, kept=(3,))
def test_a_job_file_and_the_head_name_the_cutter(shape, parts):
    settings = build_settings(
        "mill",
        str(parts / "dome.stl"),
        {"machine": "trunnion_ac", "cutter": shape, "stepover": 20, **UNCURED},
    )
    options = json.loads(json.dumps(flat_options(settings)))
    assert build_settings(options.pop("task"), options.pop("source"), options) == settings
    nc = job.make(settings).nc.decode()
    assert (
        shape.partition(":")[0].replace("taper", "taper ") in nc.lower().partition("g")[0] + nc[:400].lower()
    )


def test_the_tool_length_of_a_head_reaches_to_the_hub():
    given = {"machine": "fork_head_bc", "tool_length": 100, "control_point": "centre"}
    lengths = [
        wanted.load_setup(build_settings("mill", "x.stl", given | {"cutter": cutter}))[1]
        for cutter in ("ball:10", "bull:10:2", "flat:10")
    ]
    assert [setup.tool_length for setup in lengths] == [95.0, 98.0, 100.0]


def test_rows_between_lie_on_the_facet_and_turn_evenly(milled):
    outcome = milled("saddle", "trunnion_ac", cutter="bull:10:2", stepover=20).draft
    bent = outcome.axis + np.where(np.arange(len(outcome.axis)) % 2, 0.3, -0.3)[:, None] * np.array(
        [0.0, 1.0, 0.0]
    )
    bent /= np.linalg.norm(bent, axis=1)[:, None]
    placed, axis = seating.cl_offset_path(outcome.offset, bent, parse_cutter("bull:10:2"), 0.01)
    assert len(axis) > 2 * len(bent)
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1.0, atol=1e-12)
    out = replace(placed, findings=()).centre - placed.point
    assert np.linalg.norm(out, axis=1).max() < 5.0 + 1.0 and np.isfinite(out).all()
