# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lin & Ye reproduced: the half circle, eq. (6), and what docs/lin-ye.md says of eqs. (9) and (10)."""

import sys
from pathlib import Path

import numpy as np
import pytest

STUDIES = Path(__file__).parents[2] / "docs" / "studies"
sys.path.insert(0, str(STUDIES))

import lin_ye  # noqa: E402
import lin_ye_arc as arc  # noqa: E402
import lin_ye_parts as parts  # noqa: E402
import lin_ye_profiles as profiles  # noqa: E402

from freecad_fiveaxis.core.motion.deviation import lin_ye_deviation  # noqa: E402

STEP = np.radians(20.0)
DOCUMENT = lin_ye.DOCUMENT.read_text(encoding="utf-8")


# -------------------------------------------------------------------------------------------- the half circle


def test_the_half_circle_deviates_by_the_papers_2_70_mm_with_the_r0_solved_from_it():
    """The paper prints no R0; PAPER_R0 is solved from its 2.70 mm by eq. (6). Tested is that the simulated
    path agrees."""
    assert arc.shift_measured(arc.PAPER_R0, STEP) == pytest.approx(2.70, abs=0.01)


def test_the_largest_deviation_is_an_overcut_at_90_deg():
    psi = arc.half_circle(STEP)
    off = arc.off_the_arc(arc.trunnion(arc.PAPER_R0), arc.ARC + arc.BALL, psi)
    step, sample = np.unravel_index(off.argmin(), off.shape)
    place = psi[step] + (psi[step + 1] - psi[step]) * sample / (arc.SAMPLES - 1)
    assert np.degrees(place) == pytest.approx(90.0, abs=1e-6)
    assert off[step, sample] == pytest.approx(-2.70, abs=0.01)
    assert off.max() < 1e-9


@pytest.mark.parametrize("distance", [50.0, arc.PAPER_R0, 300.0])
@pytest.mark.parametrize("step", [2.5, 10.0, 20.0])
def test_eq_6_is_exact_where_the_normal_is_along_r0(distance, step):
    exact = distance * (1.0 - np.cos(0.5 * np.radians(step)))  # by hand: the chord of a circle of radius R0
    assert float(lin_ye_deviation(distance, np.radians(step))) == pytest.approx(exact, rel=1e-12)
    assert arc.deviation_simulated(distance, np.radians(step), 0.0) == pytest.approx(exact, rel=1e-9)
    assert arc.shift_measured(distance, np.radians(step)) == pytest.approx(exact, rel=1e-5)


def test_eq_6_is_of_first_order_elsewhere():
    quarter = np.pi / 4
    assert arc.deviation_simulated(arc.PAPER_R0, STEP, quarter) == pytest.approx(1.880, abs=0.001)
    assert float(lin_ye_deviation(arc.PAPER_R0, STEP, quarter)) == pytest.approx(1.909, abs=0.001)
    miss = [
        float(lin_ye_deviation(arc.PAPER_R0, step, quarter))
        / arc.deviation_simulated(arc.PAPER_R0, step, quarter)
        - 1.0
        for step in (STEP, STEP / 2)
    ]
    assert miss[0] / miss[1] == pytest.approx(4.0, abs=0.2)


def test_the_whole_tool_is_shifted_by_the_same_way_wherever_on_the_arc():
    assert arc.shift_measured(arc.PAPER_R0, STEP, 1.0) == pytest.approx(
        arc.shift_measured(arc.PAPER_R0, STEP), rel=1e-6
    )


def test_an_arc_about_the_rotary_axis_is_cut_without_deviation():
    assert arc.shift_measured(0.0, STEP) < 1e-9
    assert arc.deviation_simulated(0.0, STEP, 0.5) < 1e-9


def test_r0_to_the_contact_point_would_be_noticed():
    """The paper words R0 so; the contact point is 60 mm farther from the axis than the arc's centre."""
    assert (
        float(lin_ye_deviation(arc.PAPER_R0 + arc.ARC, STEP))
        - arc.deviation_simulated(arc.PAPER_R0, STEP, 0.0)
        > 0.9
    )


def test_an_audit_measures_from_the_chord_and_the_document_says_so():
    """At the top: (R0 - R) (1 - cos(step / 2)); with the chord's own depth below the arc that is eq. (6)
    again."""
    sagitta = (arc.ARC + arc.BALL) * (1.0 - np.cos(0.5 * STEP))
    found = arc.off_the_chords(arc.PAPER_R0, STEP)
    assert found + sagitta == pytest.approx(2.70, abs=0.01)
    assert f"says {found:.2f} mm" in DOCUMENT and f"lies {sagitta:.2f} mm inside" in DOCUMENT


# ------------------------------------------------------------------------------------------ eqs. (9) and (10)


@pytest.mark.thorough
@pytest.mark.parametrize("family", profiles.FAMILIES)
@pytest.mark.parametrize("method", profiles.METHODS)
def test_the_estimate_is_within_6_percent_of_the_largest_deviation(family, method):
    for seed in range(0, profiles.PROFILES, 3):
        points = profiles.profile(family, seed)
        path = profiles.offset_path(points)
        for depth in profiles.DEPTHS:
            height = profiles.axis_height(points, depth)
            measured = profiles.deviations(path, method, profiles.table(height))
            miss = np.abs(profiles.estimated(path, method, height) - measured)
            assert miss.max() < 0.06 * measured.max()


def test_without_its_second_term_the_estimate_fails():
    points = profiles.profile("hill", 0)
    path, height = profiles.offset_path(points), profiles.axis_height(points, None)
    measured = profiles.deviations(path, "facet_mean", profiles.table(height))
    turn = np.diff(profiles.leans(path, "facet_mean"))
    alone = np.abs(path.centre[1:, 2] - height) * turn**2 / 8.0
    assert np.abs(alone - measured[1:]).max() > 0.5 * measured.max()


def test_in_the_head_only_the_angle_counts():
    """L alpha^2 / 8 with L from the pivot to the ball: 150 mm of the head and the tool."""
    path = profiles.offset_path(profiles.profile("wavy", 1))
    rig = profiles.head()
    pivot = 150.0 + profiles.TOOL
    for method in profiles.METHODS:
        alpha = np.diff(profiles.leans(path, method))
        still = np.linalg.norm(np.diff(path.centre, axis=0), axis=1) > 0.1
        got = profiles.deviations(path, method, rig)[1:]
        np.testing.assert_allclose(got[still], (pivot * alpha**2 / 8.0)[still], rtol=0.02, atol=1e-3)


def test_on_hills_it_helps_near_the_axis_and_harms_far_from_it():
    ratios = {depth: np.divide(*profiles.largest_below("hill", depth).T[::-1]) for depth in (None, 150.0)}
    assert np.median(ratios[None]) < 0.9 and np.count_nonzero(ratios[None] < 1.0) >= 18
    assert np.median(ratios[150.0]) > 1.4 and np.count_nonzero(ratios[150.0] < 1.0) <= 4


def test_on_arcs_the_methods_are_even_at_about_1_25_radii():
    near, far = (np.median(np.divide(*profiles.largest_on_arcs(height).T[::-1])) for height in (1.0, 1.5))
    assert near < 1.0 < far


def test_the_part_has_the_papers_233_facets():
    from freecad_fiveaxis.core.geometry.mesh import read_stl

    assert len(read_stl(str(parts.workshop() / f"{parts.PART}.stl")).face) == 233


@pytest.mark.thorough
def test_on_the_part_most_passes_gain_through_it_and_lose_far_from_it():
    for depth, gains in ((None, True), (60.0, False), (150.0, False), (300.0, False)):
        one, two = (parts.mill(parts.PART, "table_ab", method, depth).per_pass for method in profiles.METHODS)
        assert (np.median(two / one) < 1.0) == gains, depth
        assert (two / one).min() > 0.5  # no pass of ours gains more than 2 times


def test_the_worst_block_of_step_weighted_is_a_sliver():
    for depth in profiles.DEPTHS:
        one, two = (parts.mill(parts.PART, "table_ab", method, depth) for method in profiles.METHODS)
        assert two.length[two.deviation.argmax()] < 0.5 < one.length[one.deviation.argmax()]


# ----------------------------------------------------------------------------------------------- the document


def drifted(text, names):
    """The tables of the document that a fresh run would write otherwise, beyond the last digit."""
    standing = lin_ye.tables_of(text)
    return [name for name in names if not same_numbers(standing[name], lin_ye.TABLES[name]())]


def same_numbers(one, two):
    """Cell by cell: the same words, and numbers within one step of their last digit (rounding may differ by
    platform)."""
    words = [
        " ".join(lines).replace("/", " ").replace("(", " ").replace(")", " ").split() for lines in (one, two)
    ]
    return len(words[0]) == len(words[1]) and all(near(a, b) for a, b in zip(*words, strict=True))


def near(one, two):
    try:
        return abs(float(one) - float(two)) <= 1.01 * 10.0 ** -len(two.partition(".")[2])
    except ValueError:
        return one == two


def test_the_documents_tables_are_those_of_a_fresh_run():
    """If this fails: .venv/bin/python docs/studies/lin_ye.py writes them anew; then read the prose beside
    them again."""
    assert drifted(DOCUMENT, ["beta", "steps", "part-ab", "passes", "worst"]) == []


def test_a_drifted_cell_would_be_noticed():
    cell = lin_ye.tables_of(DOCUMENT)["passes"][2].split("|")[2].split("/")[0].strip()
    changed = DOCUMENT.replace(f"| 1 | {cell} /", f"| 1 | {float(cell) + 0.01:.3f} /")
    assert changed != DOCUMENT and drifted(changed, ["passes"]) == ["passes"]


def test_every_table_and_picture_of_the_document_is_there():
    assert set(lin_ye.tables_of(DOCUMENT)) == set(lin_ye.TABLES)
    assert all(len(lines) > 2 for lines in lin_ye.tables_of(DOCUMENT).values())
    for name in ("half-circle", "steps", "height", "pass-2", "part"):
        assert f"(images/lin-ye-{name}.png)" in DOCUMENT
        assert 0 < (lin_ye.IMAGES / f"lin-ye-{name}.png").stat().st_size < 150_000
