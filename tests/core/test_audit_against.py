# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program against its CL path and against the part: brute force over all segments and facets, and slips
made on purpose."""

import dataclasses
import math

import numpy as np
import pytest
from mesh_shapes import box, sphere

from freecad_fiveaxis.core.audit import against_part, against_path
from freecad_fiveaxis.core.audit.against_part import _distance
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.geometry.nearest import Facets, Segments, nearest, search
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, inverse
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.program import Guided, Program
from freecad_fiveaxis.core.motion.trajectory import axis_at, tip_at
from freecad_fiveaxis.core.pipeline import job, outputs
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import as_json
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

MACHINE = load_machine("trunnion_ac")
LINKS = chain(MACHINE, Setup(MACHINE.origin))
PASSES, POINTS = 6, 25


def dome(radius=50.0, step=1.5):
    """Tips and axes of passes over a dome about (0, 0, 0): the axis is the normal, off the pole."""
    along = np.linspace(-0.4, 0.4, POINTS)
    rows = [
        np.column_stack([np.full(POINTS, 0.3 + step / radius * i), along if i % 2 == 0 else along[::-1]])
        for i in range(PASSES)
    ]
    a, b = np.concatenate(rows).T
    axis = np.column_stack([np.sin(a) * np.cos(b), np.sin(b), np.cos(a) * np.cos(b)])
    return radius * axis, axis


def path_of(tip, axis, motion=None):
    n = len(tip)
    motion = np.r_[Motion.RAPID, np.zeros(n - 1)].astype(np.int8) if motion is None else motion
    none = np.full(n, -1)
    return CLPath(tip, axis, motion, np.full(n, 1000.0), tip, axis, none, none, none)


def program_of(words, motion=None, guided=None):
    n = len(words)
    motion = np.r_[Motion.RAPID, np.zeros(n - 1)].astype(np.int8) if motion is None else motion
    return Program(
        LINKS.letters, words, np.full(n, 1000.0), np.zeros(n, bool), motion, np.ones(n), np.full(n, -1), np.arange(3, n + 3),
        guided=guided,
    )  # fmt: skip


def words_of(tip, axis, kinematics=LINKS):
    q = inverse(kinematics, tip, axis)[0][0]
    q[:, 3] = np.unwrap(q[:, 3])
    return np.round(np.column_stack([q[:, :3], np.degrees(q[:, 3:])]), 4)


def compare(words, path, tolerance=0.01, program=None):
    program = program_of(words) if program is None else program
    return against_path(LINKS, program, measure(LINKS, words), path, tolerance, math.radians(0.2))


def codes(found):
    return [one.code for one in found.findings]


def to_segments(points, start, end):
    """Distances (n,) by brute force over all segments."""
    best = np.full(len(points), np.inf)
    for a, b in zip(start, end, strict=True):
        along, off = b - a, points - a
        share = np.clip(off @ along / max(along @ along, 1e-300), 0, 1)
        best = np.minimum(best, np.linalg.norm(off - share[:, None] * along, axis=1))
    return best


def to_facets(points, corner):
    """Distances (n,) by brute force over all facets: a fine grid of each, then none is needed where it is
    inside."""
    best = np.full(len(points), np.inf)
    for a, b, c in corner:
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal)
        height = (points - a) @ normal
        foot = points - height[:, None] * normal
        inside = np.ones(len(points), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            inside &= np.cross(q - p, foot - p) @ normal >= 0
        best = np.where(inside, np.minimum(best, np.abs(height)), best)
        best = np.minimum(best, to_segments(points, np.array([a, b, c]), np.array([b, c, a])))
    return best


# ---------------------------------------------------------------------------------------- the nearest element


@pytest.mark.parametrize("seed", range(4))
def test_the_nearest_segment_is_that_of_brute_force(seed):
    rng = np.random.default_rng(seed)
    start = rng.normal(size=(60, 3)) * 10
    end = start + rng.normal(size=(60, 3)) * 10 ** rng.uniform(-3, 1.5, 60)[:, None]
    end[:5] = start[:5]
    lines, points = Segments(start, end), rng.normal(size=(300, 3)) * 25
    found = search(points, lines.pieces(), lines.square_distances, nearest, 2)
    np.testing.assert_allclose(found[:, 0], to_segments(points, start, end), rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_the_nearest_facet_is_that_of_brute_force(seed):
    rng = np.random.default_rng(seed)
    corner = rng.normal(size=(60, 1, 3)) * 15 + rng.normal(size=(60, 3, 3)) * 10 ** rng.uniform(
        -1, 1.3, (60, 1, 1)
    )
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    facets = Facets(corner.transpose(1, 0, 2), normal / np.linalg.norm(normal, axis=1)[:, None])
    pieces, points = facets.pieces(), rng.normal(size=(300, 3)) * 25
    brute = to_facets(points, corner)
    found = search(points, pieces, facets.square_distances, facets.sign_distances, 2)[:, 0]
    np.testing.assert_allclose(np.abs(found), brute, rtol=1e-9, atol=1e-6)
    assert (pieces.clear_by(points) <= brute + 1e-9).all()


def test_far_places_may_be_rough_but_never_too_near():
    rng = np.random.default_rng(8)
    start = rng.normal(size=(400, 3)) * 10
    lines = Segments(start, start + rng.normal(size=(400, 3)))
    pieces, points = lines.pieces(), rng.normal(size=(300, 3)) * rng.choice((10, 400), (300, 1))
    brute = to_segments(points, lines.start, lines.end)
    found = search(points, pieces, lines.square_distances, nearest, 2, 50.0)[:, 0]
    assert (found >= brute - 1e-9).all() and (found <= 1.1 * brute).all()
    near = brute < 40.0 * pieces.reach
    assert near.any() and not near.all()
    np.testing.assert_allclose(found[near], brute[near], rtol=1e-9)


def test_fewer_pieces_than_are_proven_enough_would_be_noticed():
    """The nearest middle is not always the nearest segment's."""
    lines = Segments(np.array([[0.0, 0, 0], [2.0, 1.5, 0]]), np.array([[10.0, 0, 0], [2.1, 1.5, 0]]))
    point = np.array([[2.0, 0.5, 0.0]])
    middle = (lines.start + lines.end) / 2
    assert np.linalg.norm(middle - point, axis=1).argmin() == 1
    assert search(point, lines.pieces(), lines.square_distances, nearest, 2)[0].tolist() == [0.5, 0.0]


@pytest.mark.parametrize("shape", [box, sphere], ids=["box", "sphere"])
def test_inside_and_outside_are_distinguished_at_edges_and_corners(shape):
    mesh = from_triangles(shape())
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    middle = mesh.vertex.mean(axis=0)
    seen = np.concatenate(
        [mesh.vertex, mesh.vertex[mesh.coedge_vertex].mean(axis=1), mesh.vertex[mesh.face].mean(axis=1)]
    )
    for factor, sign in ((1.01, 1.0), (0.99, -1.0)):
        found = search(
            middle + factor * (seen - middle),
            facets.pieces(),
            facets.square_distances,
            facets.sign_distances,
            2,
        )[:, 0]
        assert (np.sign(found) == sign).all()


# ---------------------------------------------------------------------------------------- against the CL path


def test_a_program_that_keeps_to_its_path_has_no_findings_but_its_deviation():
    tip, axis = dome()
    reported = compare(words_of(tip, axis), path_of(tip, axis), 1.0)
    assert reported.findings == () and reported.end.max() < 2e-4 and math.degrees(reported.axis.max()) < 1e-3


@pytest.mark.parametrize("tolerance", [0.1, 0.01, 0.001])
def test_the_distance_is_that_of_dense_samples_and_brute_force(tolerance):
    rng = np.random.default_rng(7)
    tip, axis = dome()
    words = words_of(tip, axis)
    words[40:60, :3] += rng.normal(size=(20, 3)) * 0.3
    path = path_of(tip, axis)
    reported = compare(words, path, tolerance)

    def near(value):
        return max(0.11 * tolerance, 1.1e-3 * value)

    u = np.linspace(0, 1, 301)
    for at in [*range(38, 62), 5, 100]:
        row = int(reported.block[at])
        real = tip_at(
            LINKS, np.repeat(words[row - 1 : row], 301, 0), np.repeat(words[row : row + 1], 301, 0), u
        )
        brute = to_segments(real, tip[:-1], tip[1:]).max()
        assert reported.bound[at] >= brute - 1e-9
        assert reported.off[at] <= brute + 1e-3
        if brute > 1.2 * tolerance:
            assert reported.off[at] >= brute - near(brute)
            assert reported.bound[at] <= reported.off[at] + near(brute)
    # what is not over the tolerance is proven so, to a tenth
    within = reported.off <= tolerance
    assert (
        within.sum() > (100 if tolerance == 0.1 else -1)
        and (reported.bound[within] <= 1.1 * tolerance + 1e-9).all()
    )


def test_one_shifted_block_is_named_with_its_distance_and_its_row_is_missed():
    tip, axis = dome()
    words = words_of(tip, axis)
    normal = axis[60]
    moved = tip.copy()
    moved[60] += 0.3 * normal
    reported = compare(words_of(moved, axis), path_of(tip, axis), 0.1)
    assert codes(reported) == ["off-cl-path", "cl-rows-missed"]
    off, missed = reported.findings
    assert off.value == pytest.approx(0.3, abs=0.02) and off.line in (62, 63, 64)
    assert reported.missed.tolist() == [60] and missed.value == pytest.approx(0.3, abs=0.02)
    assert compare(words, path_of(tip, axis), 0.1).findings == ()


def test_a_way_of_the_posts_own_is_a_note_and_one_into_the_part_an_error():
    tip, axis = dome()
    out = np.array([3.0, 20.0, 20.0, 3.0])[:, None] * axis[40] + np.array([0.0, 0.0, 5.0, 0.0])[
        :, None
    ] * np.cross(axis[40], (0, 0, 1))
    for way, code in ((out, "way-not-in-cl-path"), (-out, "off-cl-path")):
        tips = np.concatenate([tip[:41], tip[40] + way, tip[40:]])
        axes = np.concatenate([axis[:41], np.repeat(axis[40:41], 4, 0), axis[40:]])
        reported = compare(words_of(tips, axes), path_of(tip, axis), 0.1)
        assert codes(reported) == [code]
        assert reported.findings[0].line == 44 + 1 or reported.findings[0].value == pytest.approx(
            np.hypot(20, 5), rel=0.05
        )


def test_a_missing_pass_is_missed_rows():
    tip, axis = dome()
    keep = np.r_[0 : 2 * POINTS, 3 * POINTS : PASSES * POINTS]
    reported = compare(words_of(tip[keep], axis[keep]), path_of(tip, axis), 0.1)
    # the block that leads over the gap passes the ends of the pass, which are rows too
    assert set(reported.missed) == set(range(2 * POINTS, 3 * POINTS)) - set(range(3 * POINTS)) | set(
        reported.missed
    )
    assert (
        set(range(2 * POINTS + 1, 3 * POINTS - 1))
        <= set(reported.missed.tolist())
        <= set(range(2 * POINTS, 3 * POINTS))
    )
    (missed,) = [one for one in reported.findings if one.code == "cl-rows-missed"]
    assert missed.value == pytest.approx(1.5, abs=0.01)  # the stepover


def test_a_block_on_the_next_pass_is_seen_by_the_row_that_it_misses():
    tip, axis = dome()
    moved = tip.copy()
    moved[40] = tip[2 * POINTS + 9]  # straight across: row 40 is at 9 steps from the end of pass 1
    reported = compare(words_of(moved, axis), path_of(tip, axis), 0.1)
    assert reported.missed.tolist() == [40]


def test_a_turned_tool_is_named_with_its_angle():
    tip, axis = dome()
    leaned = axis.copy()
    side = np.cross(axis[70], tip[71] - tip[70])
    side /= np.linalg.norm(side)
    leaned[70] = math.cos(math.radians(1.5)) * axis[70] + math.sin(math.radians(1.5)) * side
    reported = compare(words_of(tip, leaned), path_of(tip, axis), 1.0)
    (found,) = reported.findings
    assert (
        found.code == "axis-off-cl-path" and found.line == 73 and found.value == pytest.approx(1.5, abs=1e-3)
    )


def test_between_the_rows_the_axis_is_that_of_the_great_arc():
    tip, axis = dome()
    tip, axis = tip[[0, 12]], axis[[0, 12]]
    share = np.linspace(0, 1, 9)
    turn = math.acos(axis[0] @ axis[1])
    arc = (
        np.sin((1 - share) * turn)[:, None] * axis[0] + np.sin(share * turn)[:, None] * axis[1]
    ) / math.sin(turn)
    places = tip[0] + share[:, None] * (tip[1] - tip[0])
    reported = compare(words_of(places, arc), path_of(tip, axis), 5.0)
    assert math.degrees(reported.axis.max()) < 1e-3
    straight = axis[0] + share[:, None] * (axis[1] - axis[0])  # a lerp would be noticed
    straight /= np.linalg.norm(straight, axis=1)[:, None]
    assert math.degrees(np.linalg.norm(straight - arc, axis=1).max()) > 0.02


def test_leaving_between_good_ends_is_stated_so():
    tip, axis = dome()
    pick = np.r_[0:POINTS:12]
    reported = compare(words_of(tip[pick], axis[pick]), path_of(tip[pick], axis[pick]), 0.1)
    assert codes(reported) == ["between-cl-rows"] and reported.end.max() < 1e-3
    assert reported.off.max() == pytest.approx(
        measure(LINKS, words_of(tip[pick], axis[pick])).segment.max(), abs=0.011
    )


def test_guided_blocks_are_taken_to_go_straight():
    tip, axis = dome()
    pick = np.r_[0:POINTS:12]
    words = words_of(tip[pick], axis[pick])
    guided = Guided(np.ones(len(words), bool), tip[pick])
    reported = compare(words, path_of(tip[pick], axis[pick]), 0.1, program_of(words, guided=guided))
    assert reported.findings == () and reported.off.max() < 1e-3


def test_a_program_without_feed_blocks_misses_all_rows():
    tip, axis = dome()
    words = words_of(tip[:3], axis[:3])
    reported = compare(words, path_of(tip, axis), 0.1, program_of(words, np.full(3, Motion.RAPID, np.int8)))
    assert len(reported.missed) == len(tip) - 1 and codes(reported) == ["cl-rows-missed"]


def test_posted_for_a_pivot_half_a_millimetre_off_is_off_by_what_the_hand_computes(tmp_path):
    """A's line stands h higher than the post believed: at tilt A the tip is off by h (0, sin A, 1 - cos A)
    before C turns, in all
    |off| = 2 h sin(A / 2)."""
    tip, axis = dome()
    raised = [
        dataclasses.replace(one, point=(one.point[0], one.point[1], one.point[2] + 0.5))
        if one.letter == "A"
        else one
        for one in MACHINE.axes
    ]
    wrong = dataclasses.replace(MACHINE, axes=tuple(raised))
    words = words_of(tip, axis, chain(wrong, Setup(MACHINE.origin)))
    cl, nc, fcm = tmp_path / "p.apt", tmp_path / "p.ngc", tmp_path / "wrong.fcm"
    save_machine(wrong, str(fcm))
    rows = np.column_stack([tip, axis])
    cl.write_text(
        "MULTAX/ON\nFEDRAT/900\n"
        + "".join("GOTO/" + ",".join(f"{v:.7f}" for v in row) + "\n" for row in rows)
        + "FINI\n"
    )
    posted = build_settings("post", str(cl), {"machine": str(fcm), "output": str(nc)})
    outputs.write_outputs(job.run(posted))
    result = job.run(
        build_settings("audit", str(nc), {"machine": "trunnion_ac", "against": str(cl), "tolerance": 0.05})
    )
    tilt = np.radians(words[1:, 4])
    ends = result.audit.path.end
    for at, row in enumerate(result.audit.path.block):
        angle = math.radians(result.draft.program.words[row, 4])
        # to a line of the path that does not run across the error the distance is less
        assert ends[at] <= 2 * 0.5 * abs(math.sin(angle / 2)) + 2e-3
    assert ends.max() == pytest.approx(2 * 0.5 * np.sin(np.abs(tilt) / 2).max(), rel=0.05)
    found = [one for one in result.findings if one.code == "off-cl-path"]
    assert found and "nearly all alike" in found[0].text and "recover" in found[0].text
    right = job.run(
        build_settings("audit", str(nc), {"machine": str(fcm), "against": str(cl), "tolerance": 0.05})
    )
    assert right.audit.path.end.max() < 2e-3 and not [one for one in right.findings if "cl-" in one.code]


@pytest.mark.parametrize("text", ["FINI\n", "GOTO/1,2,3\nFINI\n"])
def test_a_cl_file_without_a_path_is_refused(tmp_path, text):
    nc, cl = tmp_path / "p.ngc", tmp_path / "p.apt"
    nc.write_text("G0 X0 Y0 Z0 A0 C0\nG1 X5 F100\nM2\n")
    cl.write_text(text)
    with pytest.raises(FiveAxisError):
        job.run(build_settings("audit", str(nc), {"machine": "trunnion_ac", "against": str(cl)}))


def test_an_output_must_not_be_what_is_compared_with(tmp_path):
    settings = build_settings(
        "audit",
        "p.ngc",
        {"machine": "trunnion_ac", "against": "p.apt", "rates": str(tmp_path / "../x/p.csv")},
    )
    again = dataclasses.replace(settings, output=dataclasses.replace(settings.output, rates="p.apt"))
    with pytest.raises(FiveAxisError, match="is the file that is read"):
        outputs.check_outputs(again)


# ------------------------------------------------------------------------------------------- against the part


def ball(radius=46.0):
    """A faceted sphere about (0, 0, 0)."""
    return from_triangles(sphere(radius, 24, 36))


@pytest.mark.thorough
def test_the_depth_is_that_of_dense_samples_and_brute_force_over_facets():
    mesh, (tip, axis) = ball(), dome()
    rng = np.random.default_rng(3)
    tip = tip - (3.8 + rng.uniform(-0.2, 0.4, len(tip)))[:, None] * axis
    words = words_of(tip, axis)
    reported = against_part(LINKS, program_of(words), mesh, 4.0, 0.02)
    corner = mesh.vertex[mesh.face]
    for at in (3, 60, 120):
        row = int(reported.block[at])
        both = (
            np.repeat(words[row - 1 : row], 61, 0),
            np.repeat(words[row : row + 1], 61, 0),
            np.linspace(0, 1, 61),
        )
        centre = tip_at(LINKS, *both) + 4.0 * axis_at(LINKS, *both)
        brute = (4.0 - to_facets(centre, corner)).max()
        assert reported.bound[at] >= brute - 1e-9
        if brute > 0.024:
            assert reported.depth[at] == pytest.approx(brute, abs=0.0025)
        else:
            assert reported.depth[at] <= brute + 1e-3
    (found,) = reported.findings
    assert (
        found.code == "overcut"
        and found.value == pytest.approx(reported.depth.max())
        and found.line == reported.block[reported.depth.argmax()] + 3
    )


def test_the_deepest_place_between_two_clear_ends_is_found():
    """The chord passes through the ball's top: both ends are clear by a millimetre and more."""
    mesh = ball(20.0)
    words = np.array([[-15.0, 0, 18.0, 0, 0], [15.0, 0, 18.0, 0, 0]])
    shift = tip_at(LINKS, words[:1], words[:1], np.zeros(1))[0] - words[0, :3]
    np.testing.assert_allclose(shift, 0.0, atol=1e-9)  # words are work coordinates at A0 C0
    reported = against_part(LINKS, program_of(words), mesh, 2.0, 0.01)
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    ends = (
        search(
            words[:, :3] + (0, 0, 2.0), facets.pieces(), facets.square_distances, facets.sign_distances, 2
        )[:, 0]
        - 2.0
    )
    assert (ends > 1.0).all()
    exact = (
        2.0
        - search(
            np.array([[0.0, 0, 20.0]]), facets.pieces(), facets.square_distances, facets.sign_distances, 2
        )[0, 0]
    )
    assert (
        exact > 1.9
        and reported.depth[0] == pytest.approx(exact, abs=0.03)
        and reported.clearance == pytest.approx(ends.max(), abs=1e-9)
    )


def test_a_centre_inside_the_part_counts_as_deeper_than_the_radius():
    mesh = ball(20.0)
    words = np.array([[-1.0, 0, 5.0, 0, 0], [1.0, 0, 5.0, 0, 0]])
    reported = against_part(LINKS, program_of(words), mesh, 2.0, 0.01)
    assert reported.depth[0] == pytest.approx(2.0 + 20.0 - 7.0, rel=0.02)


def test_a_path_that_touches_the_part_is_no_overcut_and_a_hundredth_lower_is(tmp_path):
    nc, stl = tmp_path / "p.ngc", tmp_path / "box.stl"
    write_stl(from_triangles(box((0, 0, 0), (40, 30, 10))), stl)
    for z, count in ((10.0, 0), (9.985, 1)):
        nc.write_text(f"G21 G90 G94\nG0 X5 Y5 Z{z} A0 C0\nG1 X35 F600\nG1 Y25\nM2\n")
        given = {"machine": "trunnion_ac", "against": str(stl), "cutter": "ball:6"}
        result = job.run(build_settings("audit", str(nc), given))
        found = [one for one in result.findings if one.code == "overcut"]
        assert len(found) == count
        assert result.audit.part.depth.max() == pytest.approx(10.0 - z, abs=1e-6)


def test_far_inside_and_far_outside_are_distinguished_whatever_way_the_places_come():
    mesh, rng = ball(20.0), np.random.default_rng(5)
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    pieces, way = facets.pieces(), np.linspace(-40, 40, 300)
    straight = np.column_stack([way, 0 * way, 0 * way + 3])
    for places in (straight, rng.permutation(straight), rng.normal(size=(300, 3)) * 18):
        exact = search(places, pieces, facets.square_distances, facets.sign_distances, 2)[:, 0]
        found = _distance(places, facets, pieces, 1.0)
        assert (np.sign(found) == np.sign(exact)).all() and (found <= exact + 1e-9).all()
        close = exact < 0.9
        np.testing.assert_allclose(found[close], exact[close], atol=1e-9)


# --------------------------------------------------------------------------------- the whole tool in the part


def audited(tmp_path, lines, **options):
    nc, stl = tmp_path / "p.ngc", tmp_path / "box.stl"
    write_stl(from_triangles(box((0, 0, 0), (40, 30, 10))), stl)
    nc.write_text("G21 G90 G94\nG0 X-5 Y10 Z60 A0 C0\n" + lines + "\nM2\n")
    return job.run(
        build_settings("audit", str(nc), {"machine": "trunnion_ac", "against": str(stl), **options})
    )


@pytest.mark.parametrize("cutter", ["flat:6", "bull:6:1", "taperbull:6:1:5deg", "taperball:6:5deg"])
def test_any_cutter_is_held_against_the_part(tmp_path, cutter):
    for z, depth in ((10.0, 0.0), (9.5, 0.5)):
        result = audited(tmp_path, f"G1 X20 Y10 Z{z + 5} F600\nG1 Z{z}\nG1 X30\nG1 Z60", cutter=cutter)
        found = [one for one in result.findings if one.code == "overcut"]
        assert len(found) == (depth > 0) and result.audit.part.depth.max() == pytest.approx(
            depth, rel=0.02, abs=1e-3
        )
        assert math.isnan(result.audit.part.clearance) and "NaN" not in as_json(job.figures(result))
    assert "--origin" in found[0].text and found[0].line == result.draft.program.line[found[0].block]


def test_holder_and_rapids_of_a_program_are_checked_where_they_are_requested(tmp_path):
    lines = "G1 X-4 Y10 Z0 F600\nG1 Y20\nG0 X20 Z9\nG1 Z60"
    alone = audited(tmp_path, lines, cutter="ball:6:8", gouge="off")
    with_all = audited(tmp_path, lines, cutter="ball:6:8", holder="30x20")
    codes_ = {one.code for one in with_all.findings}
    assert not {"holder-collision", "rapid-collision"} & {one.code for one in alone.findings}
    assert {"holder-collision", "rapid-collision"} <= codes_
    without = audited(
        tmp_path, lines, cutter="ball:6:8"
    )  # rapids are looked at unasked, and a ball's deepest place stays its own
    assert "rapid-collision" in {one.code for one in without.findings}
    np.testing.assert_array_equal(without.audit.part.depth, alone.audit.part.depth)
    assert not math.isnan(with_all.audit.part.clearance)  # the ball's own measure still tells what is left


def test_an_audit_with_the_gouge_check_off_says_so_and_one_without_a_part_checks_nothing(tmp_path):
    clear = "G0 Z90\nG1 X20 F600"
    reported = {how: as_json(job.figures(audited(tmp_path, clear, cutter="ball:6", **how_))) for how, how_ in
            {"": {}, "off": {"gouge": "off"}}.items()}  # fmt: skip
    assert (
        "only the cutter's own feed moves were checked" in reported["off"]
        and "only the cutter" not in reported[""]
    )
    assert build_settings("audit", "p.ngc", {"machine": "trunnion_ac"}).gouge.gouge == "off"
    assert (
        build_settings("audit", "p.ngc", {"machine": "trunnion_ac", "against": "a.stl"}).gouge.gouge
        == "report"
    )


@pytest.mark.parametrize(
    ("options", "message"),
    [({"gouge": "lift", "against": "a.stl"}, "use it with `mill`"), ({"gouge": "report"}, "--against"), ({"holder": "30x20"}, "--against"),
     ({"gouge": "report", "against": "a.apt"}, "--against")],
)  # fmt: skip
def test_an_audit_needs_the_part_for_the_gouge_check_and_cures_nothing(options, message):
    with pytest.raises(FiveAxisError, match=message):
        build_settings("audit", "p.ngc", {"machine": "trunnion_ac", **options})
