# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contract of a cutter, held by every kind on offer: it touches at its contact and nowhere deeper, its
body is what touches, its effective radius is that of what it sweeps, and its texts bring it back."""

import math

import numpy as np
import pytest

from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.tool import KINDS, SIZES, cutter_name, cutter_text, kind_of, parse_cutter
from freecad_fiveaxis.core.tool.body import CUTTER, body_of, body_support, depth_of
from freecad_fiveaxis.core.tool.text import FORMS
from freecad_fiveaxis.core.toolpath.apt import read_cl_file, write_apt
from freecad_fiveaxis.core.toolpath.apt.head import ClHead
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

every_kind = pytest.mark.parametrize("form", FORMS)


def stands(cutter, count=400, seed=1):
    """Contacts, unit normals, axes and feeds: the axis leans from the normal by anything that the flank
    allows."""
    rng = np.random.default_rng(seed)
    normal, side, feed = (v / np.linalg.norm(v, axis=1)[:, None] for v in rng.normal(size=(3, count, 3)))
    side = np.cross(normal, side)
    side /= np.linalg.norm(side, axis=1)[:, None]
    lean = rng.uniform(0.02, 0.5 * math.pi - cutter.taper - 1e-3, count)[:, None]
    return rng.uniform(-50.0, 50.0, (count, 3)), normal, np.cos(lean) * normal + np.sin(lean) * side, feed


def lowest(cutter, contact, normal, axis, tip):
    """How high (n,) mm the lowest point of what cuts is above the plane of the contact."""
    along = np.einsum("ij,ij->i", normal, axis)
    return np.einsum("ij,ij->i", tip - contact, normal) - body_support(body_of(cutter).only(CUTTER), -along)


def test_an_example_of_every_kind_is_on_offer():
    assert [kind_of(parse_cutter(form)) for form in FORMS] == list(KINDS)
    assert {size for sizes in KINDS.values() for size in sizes} | {"length"} == set(SIZES)


@every_kind
def test_it_is_tangent_at_the_contact_and_never_below_it(form):
    cutter = parse_cutter(form)
    contact, normal, axis, feed = stands(cutter)
    tip = cutter.tip_from_contact(contact, normal, axis, feed)
    np.testing.assert_allclose(lowest(cutter, contact, normal, axis, tip), 0.0, atol=1e-9)
    np.testing.assert_allclose(depth_of(body_of(cutter).only(CUTTER), tip, axis, contact), 0.0, atol=1e-9)


def test_a_tip_beside_its_place_would_be_noticed():
    cutter = parse_cutter("bull:10:2")
    contact, normal, axis, feed = stands(cutter)
    tip = cutter.tip_from_contact(contact, normal, axis, feed) - 1e-6 * normal
    assert (lowest(cutter, contact, normal, axis, tip) < -5e-7).all()


@every_kind
def test_the_hub_is_shifted_from_where_one_corner_circle_would_stand(form):
    cutter = parse_cutter(form)
    contact, normal, axis, feed = stands(cutter)
    hub = contact + cutter.corner * normal + cutter.hub_shift(normal, axis, feed)
    np.testing.assert_allclose(
        cutter.tip_at(hub, axis), cutter.tip_from_contact(contact, normal, axis, feed), atol=1e-9
    )
    assert cutter.touches_as_ball == (not np.any(cutter.hub_shift(normal, axis, feed)))
    assert (np.linalg.norm(contact - hub, axis=1) <= cutter.contact_reach + 1e-9).all()


@every_kind
def test_its_effective_radius_is_how_its_outline_bends_across_its_way(form):
    """The support's second derivative at the contact, plus the support itself, is the radius of the
    shadow."""
    cutter, step = parse_cutter(form), 1e-3
    contact, normal, axis, feed = stands(cutter, seed=2)
    across = np.cross(normal, feed)
    across /= np.linalg.norm(across, axis=1)[:, None]
    body, tip = body_of(cutter).only(CUTTER), cutter.tip_from_contact(contact, normal, axis, feed)
    centre = contact - tip  # supports are taken from the contact, where the support itself is 0
    supports = []
    for turn in (-step, 0.0, step):
        way = -np.cos(turn) * normal + np.sin(turn) * across
        supports.append(
            body_support(body, np.einsum("ij,ij->i", way, axis)) - np.einsum("ij,ij->i", way, centre)
        )
    bent = (supports[0] - 2.0 * supports[1] + supports[2]) / step**2
    reported = cutter.effective_radius(normal, axis, across)
    inner = np.abs(bent - reported) <= 1e-2 * reported + 2e-3
    assert inner.mean() > 0.95, "but for the few stands next to where one round ends and another begins"


@every_kind
def test_its_option_brings_it_back(form):
    cutter = parse_cutter(form)
    assert parse_cutter(cutter_text(cutter)) == cutter


@every_kind
def test_a_cl_file_brings_it_back(form):
    cutter, none, one = parse_cutter(form), np.zeros(1, np.int64), np.zeros((1, 3))
    path = CLPath(
        one, one + (0, 0, 1), np.zeros(1, np.int8), np.full(1, 500.0), one, one + (0, 0, 1), none, none, none
    )
    got = read_cl_file(write_apt(path, cutter, "A", head=ClHead(tool=1)).decode()).head.cutter
    for size in ("diameter", "corner", "taper", "neck", "flank"):
        assert getattr(got, size) == pytest.approx(getattr(cutter, size), abs=1e-4)


@every_kind
def test_an_audit_reads_it_from_the_head_of_a_program(form):
    cutter = parse_cutter(form)
    assert find_named_cutter(f"(T1 {cutter_name(cutter).upper()}, L 100.000)\n".encode()) == cutter
