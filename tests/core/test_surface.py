# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a ball leaves on flat faces between sharp edges, on the machine's real way: blocks are divided by the
ball's centre."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings
from scipy.spatial import cKDTree
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import (
    Setup,
    chain,
    forward,
    joint_words,
    lift_of,
    raise_chain,
    words_to_q,
)
from freecad_fiveaxis.core.pipeline import driving, job
from freecad_fiveaxis.core.report import as_html, as_text, blocks_csv, draw, spot, summary
from freecad_fiveaxis.core.report.playback import Playback
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import write_apt
from freecad_fiveaxis.core.toolpath.cl_path import Motion

RADIUS, SCALLOP, STEP = 3.0, 0.02, 0.04
MACHINES = sorted(path.stem for path in (Path(__file__).parents[2] / "resources" / "machines").glob("*.fcm"))


def prism(outline, length):
    """Triangles (f, 3, 3) mm of a closed prism: ``outline`` (n, 2) anticlockwise and convex, from z 0 to
    ``length``."""
    low, high = (np.column_stack([outline, np.full(len(outline), z)]) for z in (0.0, length))
    after, fan = np.roll(low, -1, axis=0), np.arange(1, len(outline) - 1)
    beyond = np.roll(high, -1, axis=0)
    caps = [
        np.stack([high[0 * fan], high[fan], high[fan + 1]], 1),
        np.stack([low[0 * fan], low[fan + 1], low[fan]], 1),
    ]
    return np.concatenate([np.stack([low, after, beyond], 1), np.stack([low, beyond, high], 1), *caps])


def corners(count, radius=10.0):
    """A regular outline (n, 2) mm."""
    turn = 2.0 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(turn), np.sin(turn)])


def roof():
    """A ridge of 90 degrees along X, 20 mm long and 10 mm high."""
    return prism(np.array([[-10.0, 0.0], [10.0, 0.0], [0.0, 10.0]]), 20.0)[:, :, [2, 0, 1]]


SOLIDS = {
    "box": box((-10.0, -8.0, 0.0), (10.0, 8.0, 12.0)), "hexagon": prism(corners(6), 12.0), "dodecagon": prism(corners(12), 12.0),
    "roof": roof(),
}  # fmt: skip


def milled_anew(name, **options):
    """The result of ``mill`` on one of the solids, without reading a file."""
    given = {
        "cutter": f"ball:{2 * RADIUS:g}",
        "scallop": SCALLOP,
        "passes": "scallop",
        "machine": "trunnion_ac",
    }
    settings = build_settings("mill", f"{name}.stl", {**given, "controller": "linuxcnc", **options})
    return job.make(settings, mesh=from_triangles(SOLIDS[name]))


milled = cache(milled_anew)
"""The same, made once for all tests that ask for the same."""


@cache
def proven(name, **options):
    """What is proven of it."""
    return job.prove(milled(name, **options))


@cache
def page(linearize):
    """The page of the report on the box."""
    return as_html(job.figures(proven("box", linearize=linearize))).replace("&#x27;", "'")


def centres(outcome):
    """The ball's centre (n, 3) mm at most STEP apart on the real way of all blocks that cut."""
    q, cut = (
        words_to_q(outcome.program.words),
        np.flatnonzero(np.isin(outcome.program.motion[1:], (Motion.CUT, Motion.FILL))),
    )

    def at(block, u):
        tip, axis = forward(outcome.kinematics, q[block] + u[:, None] * (q[block + 1] - q[block]))
        return tip + RADIUS * axis

    rough = at(np.repeat(cut, 21), np.tile(np.linspace(0.0, 1.0, 21), len(cut))).reshape(-1, 21, 3)
    count = np.ceil(np.linalg.norm(np.diff(rough, axis=1), axis=2).sum(1) / STEP).astype(int) + 2
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return at(np.repeat(cut, count), within / np.repeat(count - 1, count))


def commanded(outcome):
    """The same on the way that the CL path commands, the centre straight from row to row."""
    path = outcome.joints.path
    centre, cut = (
        path.tip + RADIUS * path.axis,
        np.flatnonzero(np.isin(path.motion[1:], (Motion.CUT, Motion.FILL))),
    )
    count = np.ceil(np.linalg.norm(centre[cut + 1] - centre[cut], axis=1) / STEP).astype(int) + 2
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    block, share = np.repeat(cut, count), (within / np.repeat(count - 1, count))[:, None]
    return centre[block] + share * (centre[block + 1] - centre[block])


def rest(outcome, centre, spacing=0.2):
    """What balls at ``centre`` (n, 3) mm leave (k,) mm over points of all facets that do not look down."""
    corner = outcome.mesh.vertex[outcome.mesh.face][outcome.mesh.normal[:, 2] > -0.5]
    count = int(np.ceil(np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max() / spacing))
    i, j = (part.ravel() for part in np.indices((count + 1, count + 1)))
    share = np.stack([i, j, count - i - j], 1)[i + j <= count] / count
    tree = cKDTree(
        centre, balanced_tree=False, compact_nodes=False
    )  # a third of the time, for points as even as these
    return tree.query(np.einsum("ks,fsx->fkx", share, corner).reshape(-1, 3))[0] - RADIUS


@some_in_core("name", list(SOLIDS))
def test_flat_faces_between_sharp_edges_keep_no_more_than_two_scallops(name):
    """But for the middle of the level dodecagon, 0.1 mm across, where its passes end: that is their own
    way's."""
    outcome = milled(name)
    left = rest(outcome, centres(outcome))
    more = left > 2.0 * SCALLOP
    assert more.mean() < (3e-4 if name == "dodecagon" else 1e-12)
    assert (left <= rest(outcome, commanded(outcome)) + 0.01 + 1e-4).all()
    assert left.min() >= -0.01 - 1e-4


def test_corrected_by_its_tip_the_ball_bulges_off_the_same_faces(monkeypatch):
    """The judge sees what was wrong before blocks were divided by the centre."""
    monkeypatch.setattr(driving, "compute_driven_to_surface", lambda settings: 0.0)
    outcome = milled_anew("box")
    left = rest(outcome, centres(outcome), 0.4)
    assert left.max() > 0.2
    assert (left > 2.0 * SCALLOP).mean() > 0.2


def test_either_control_point_gives_the_same_way():
    tip, centre = milled("box"), milled("box", control_point="centre")
    feed = tip.program.motion != Motion.RAPID
    off = np.abs(tip.program.words + (0, 0, RADIUS, 0, 0) - centre.program.words)[feed]
    assert (tip.program.motion == centre.program.motion).all()
    assert off.max() <= 1e-4 + 1e-9


@some_in_core("linearize", ["on", "off"])
def test_the_report_judges_the_centre_and_tells_the_tip_beside_it(linearize):
    result = proven("box", linearize=linearize)
    assert result.draft.settings.cure.linearize == linearize
    figures = job.figures(result)
    numbers, feeds = summary(figures), figures.feeds
    assert numbers["max_surface_deviation"] == result.surface.segment[feeds].max()
    assert numbers["max_surface_bound"] == result.surface.bound[feeds].max()
    assert numbers["max_segment_deviation"] == result.deviation.segment[feeds].max() > 0.01
    assert numbers["over_tolerance"] == (result.surface.segment[feeds] > 0.01).sum()
    assert numbers["proven"] == (linearize == "on") == (numbers["max_surface_bound"] <= 0.01)
    assert numbers["worst_block"] == feeds[result.surface.segment[feeds].argmax()]
    for message in (as_text(figures), page(linearize)):
        assert (
            "largest deviation of the ball's centre" in message and "largest deviation of the tip" in message
        )
    over = [finding for finding in result.findings if finding.code == "deviation-over-tolerance"]
    assert bool(over) == (linearize == "off") and all(len(one.place) == 3 for one in over)
    assert not over or ("ball's centre along a curve" in over[0].text and "RTCP" not in over[0].text)
    table = (
        blocks_csv(result.draft.program, result.deviation, result.singularity, surface=result.surface)
        .decode()
        .splitlines()
    )
    assert table[0].endswith(",surface_deviation,surface_bound")
    rows = np.array([line.split(",")[-2:] for line in table[1:]], float)
    assert (
        np.abs(rows[:, 0] - result.surface.segment).max() <= 1e-6
        and (rows[:, 1] >= result.surface.bound).all()
    )


def test_the_surface_deviation_is_that_of_dense_samples():
    """A second route: plain forward kinematics, 201 points of every block, the centre against its own
    chord."""
    result = proven("box", linearize="off")
    q = words_to_q(result.draft.program.words)
    way = q[:-1, None] + np.linspace(0.0, 1.0, 201)[None, :, None] * np.diff(q, axis=0)[:, None]
    tip, axis = forward(result.draft.kinematics, way.reshape(-1, 5))
    centre = (tip + RADIUS * axis).reshape(len(way), 201, 3)
    start, chord = centre[:, :1], centre[:, -1:] - centre[:, :1]
    share = np.clip(((centre - start) * chord).sum(2) / np.maximum((chord**2).sum(2), 1e-30), 0.0, 1.0)
    far = np.linalg.norm(centre - start - share[:, :, None] * chord, axis=2).max(1)
    assert (far <= result.surface.bound[1:] + 1e-9).all()
    assert np.abs(far - result.surface.segment[1:]).max() < 2e-3


@pytest.mark.parametrize(
    "options",
    [
        {"cutter": "flat:6"},
        {"cutter": "bull:6:1"},
        {"control_point": "centre"},
        {"rtcp": "angles", "controller": "siemens840d"},
    ],
)
def test_what_is_not_corrected_by_another_point_has_no_surface_of_its_own(options):
    result = proven("box", **options)
    assert result.surface is None
    assert summary(job.figures(result))["max_surface_deviation"] is None


@pytest.mark.parametrize(
    ("cutter", "given", "known"), [("6.0, 3.0", {}, True), ("", {}, False), ("", {"cutter": "ball:6"}, True)]
)
def test_post_goes_by_the_centre_where_a_ball_is_known(tmp_path, cutter, given, known):
    lines = [
        "MULTAX/ON",
        "FEDRAT/500, MMPM",
        "GOTO/0, 0, 0, 0, 0, 1",
        "GOTO/10, 0, 0, 0.6, 0, 0.8",
        "GOTO/20, 5, 0, 0, 0.6, 0.8",
        "FINI",
    ]
    source = tmp_path / "way.apt"
    source.write_text("\n".join([f"CUTTER/{cutter}"] * bool(cutter) + lines) + "\n")
    result = job.run(
        build_settings("post", str(source), {"machine": "trunnion_ac", "controller": "linuxcnc", **given})
    )
    feeds = job.figures(result).feeds
    assert (result.surface is not None) == known
    assert (result.surface if known else result.deviation).bound[feeds].max() <= 0.01
    assert not known or result.deviation.segment[feeds].max() > 0.01


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (31.0, -7.0, 55.0)])
def test_the_raised_chain_drives_the_point_above_the_tip(name, origin):
    """Against the forward kinematics of the chain itself, and against a chain set up with a shorter tool."""
    machine = load_machine(name)
    kinematics, height = chain(machine, Setup(origin, 120.0)), 3.175
    lift = lift_of(kinematics, height, 4)
    upper, shorter = raise_chain(kinematics, lift), chain(machine, Setup(origin, 120.0 - height))
    rng = np.random.default_rng(3)
    q = np.column_stack([rng.uniform(-80.0, 80.0, (200, 3)), rng.uniform(-3.0, 3.0, (200, 2))])
    tip, axis = forward(kinematics, q)
    point, same = forward(upper, q + (*lift, 0.0, 0.0))
    assert np.abs(point - tip - height * axis).max() < 1e-9
    assert np.abs(same - axis).max() < 1e-12
    assert np.abs(forward(shorter, q + (*lift, 0.0, 0.0))[0] - point).max() < 1e-9
    assert np.abs(joint_words(upper, point, q[:, 3:]) - q - (*lift, 0.0, 0.0)).max() < 1e-6
    for mine, theirs in ((upper.low, shorter.low), (upper.high, shorter.high)):
        finite = np.isfinite(theirs)
        assert np.allclose(mine[finite], theirs[finite], rtol=0.0, atol=1e-9)


def audited(path, text, **options):
    """The result of ``audit`` on the trunnion; the program stands in ``path`` and names no cutter."""
    path.write_bytes(text.replace(b"(BALL 6 MM)", b"(as the operator has set it)"))
    return job.run(
        build_settings("audit", str(path), {"machine": "trunnion_ac", "controller": "linuxcnc", **options})
    )


@pytest.mark.parametrize(
    ("cutter", "known"), [(f"ball:{2 * RADIUS:g}", True), ("bull:6:1", False), (None, False)]
)
def test_an_audit_judges_the_centre_of_a_ball_that_is_given(tmp_path, cutter, known):
    result = proven("box")
    found = audited(tmp_path / "a.ngc", result.draft.nc, **({"cutter": cutter} if cutter else {}))
    assert (found.surface is not None) == known and found.deviation.segment.max() > 0.01
    over = "deviation-over-tolerance" in {one.code for one in found.findings}
    assert over == (not known), "what mill holds, the audit of the same program holds"
    if known:
        figures = job.figures(found)
        assert figures.judged is found.surface
        assert found.surface.segment[figures.feeds].max() == pytest.approx(
            result.surface.segment[job.figures(result).feeds].max(), abs=1e-9
        )


def test_the_drawn_curves_are_of_the_centre_and_as_far_off_as_is_judged():
    figures = job.figures(proven("box", linearize="off"))
    picture = draw(figures)
    off = np.linalg.norm(picture.spoke[1::2] - picture.spoke[::2], axis=1)
    assert len(off) == len(figures.worst) and off == pytest.approx(
        figures.surface.segment[picture.worst], abs=1e-6
    )
    centre = figures.tip + RADIUS * figures.axis
    ends = np.stack([centre[picture.worst - 1], centre[picture.worst]], axis=1).reshape(-1, 3)
    assert picture.chord == pytest.approx(ends, abs=1e-9)
    assert spot(figures, int(picture.worst[0])).ball


def test_the_player_measures_the_point_that_is_judged():
    figures = job.figures(proven("box", linearize="off"))
    row = int(figures.worst[0])
    for deviation, above in ((figures.surface, RADIUS), (figures.deviation, 0.0)):
        play = Playback(figures.kinematics, figures.program, deviation)
        pose = play.at_block(row, float(deviation.u_segment[row]))
        assert pose.to_chord == pytest.approx(deviation.segment[row], abs=1e-6)
        assert pose.point == pytest.approx(pose.tip + above * pose.axis, abs=1e-9)
        assert play.curve(row)[[0, -1]] == pytest.approx(
            figures.tip[[row - 1, row]] + above * figures.axis[[row - 1, row]]
        )


def test_the_page_shows_the_worst_block_of_the_centre():
    figures = job.figures(proven("box", linearize="off"))
    row, shown = figures.worst[0], page("off")
    assert f"Real path of the ball's centre in NC line {figures.program.line[row]}" in shown
    assert (
        f"largest distance {figures.surface.segment[row]:.4g} mm at u = {figures.surface.u_segment[row]:.4f}"
        in shown
    )


def test_a_program_is_compared_with_its_cl_path_by_the_centre_of_the_ball_that_the_file_names(tmp_path):
    """Its blocks were divided for the centre: the tips between two rows lie off the tip's straight line, the
    centres on theirs."""
    outcome = milled("box")
    (tmp_path / "a.apt").write_bytes(write_apt(outcome.path, Cutter(2 * RADIUS), "box"))
    found = audited(tmp_path / "a.ngc", outcome.nc, against=str(tmp_path / "a.apt"))
    assert not {"off-cl-path", "between-cl-rows", "deviation-over-tolerance"} & {
        one.code for one in found.findings
    }
    assert found.audit.path.off.max() <= 0.01 and found.draft.settings.cutter.cutter.diameter == 2 * RADIUS
    (tmp_path / "a.apt").write_bytes(write_apt(outcome.path, Cutter(2 * RADIUS, corner=1.0), "box"))
    assert (
        audited(tmp_path / "a.ngc", outcome.nc, against=str(tmp_path / "a.apt")).audit.path.off.max() > 0.02
    )
