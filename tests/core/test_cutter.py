# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter and how it is written."""

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.tool import Cutter, cutter_sizes, kind_of, parse_cutter, sizes_text


@pytest.mark.parametrize(
    ("text", "diameter", "length"),
    [
        ("ball:10", 10, 50),
        ("ball:0.5in", 12.7, 50),
        (" Ball:6mm:2cm ", 6, 20),
        ("ball:.25in:1in", 6.35, 25.4),
    ],
)
def test_a_cutter_is_read_with_its_units(text, diameter, length):
    cutter = parse_cutter(text)
    assert (cutter.diameter, cutter.length) == pytest.approx((diameter, length))
    assert cutter.radius == cutter.diameter / 2


@pytest.mark.parametrize("text", ["cone:10", "lens:10", "10", "", "ball10"])
def test_another_shape_is_refused_with_those_on_offer(text):
    with pytest.raises(
        SettingsError,
        match="only ball, flat, bull, taperball, taperbull, lollipop, barrel cutters are on offer",
    ) as caught:
        parse_cutter(text)
    assert caught.value.value == text


@pytest.mark.parametrize(
    "text",
    [
        "ball:",
        "ball",
        "ball:10:20:30",
        "ball:ten",
        "ball:0",
        "ball:-3",
        "ball:10deg",
        "ball:10:0",
        "ball:inf",
    ],
)
def test_sizes_that_cannot_be_used_are_refused(text):
    with pytest.raises(SettingsError, match="cutter"):
        parse_cutter(text)


def test_the_tip_lies_one_radius_behind_the_centre():
    tip = Cutter(10.0).tip_at(np.array([[1.0, 2, 3], [0, 0, 0]]), np.array([[0.0, 0, 1], [0.6, 0, 0.8]]))
    np.testing.assert_allclose(tip, [[1, 2, -2], [-3, 0, -4]])


@pytest.mark.parametrize(
    "sizes", [(1e5, 50.0), (1e-4, 50.0), (10.0, 1e5), (10.0, 0.0), (float("nan"), 50.0), (10.0, float("nan"))]
)
def test_sizes_out_of_range_are_refused_with_the_range(sizes):
    with pytest.raises(SettingsError, match=r"give 0\.001 to 10000 mm"):
        Cutter(*sizes)


def test_the_ends_of_the_range_belong_to_it():
    assert Cutter(1e-3, 1e4).length == 1e4 and Cutter(1e4, 1e-3).radius == 5e3


ALL_SIZES = {"diameter": 10.0, "corner": 2.0, "taper": 7.5, "length": 30.0}


@pytest.mark.parametrize(
    "text",
    [
        "ball:10.0:30.0",
        "flat:10.0:30.0",
        "bull:10.0:2.0:30.0",
        "taperball:10.0:7.5deg:30.0",
        "taperbull:10.0:2.0:7.5deg:30.0",
    ],
)
def test_kind_and_sizes_make_the_text_and_come_out_of_it(text):
    kind = text.partition(":")[0]
    assert sizes_text(kind, ALL_SIZES) == text and kind_of(parse_cutter(text)) == kind
    found, sizes = cutter_sizes(text)
    in_degrees = {name: np.degrees(size) if name == "taper" else size for name, size in sizes.items()}
    assert found == kind and in_degrees == pytest.approx({name: ALL_SIZES[name] for name in sizes})


def test_sizes_that_no_cutter_has_are_read_all_the_same():
    assert cutter_sizes("bull:10:6") == ("bull", {"diameter": 10.0, "corner": 6.0})
    with pytest.raises(SettingsError, match="give 0 to 5 mm"):
        parse_cutter("bull:10:6")
