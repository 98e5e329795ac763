# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline that is drawn is the border of the body that is checked."""

import numpy as np
import pytest

from freecad_fiveaxis.core.gouge import outline
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.tool.body import CUTTER, HOLDER, SHANK, body_of, depth_of

CUTTERS = ("ball:10:30", "flat:10:30", "bull:10:2:30", "taperball:6:5deg:30", "taperbull:10:2:15deg:30", "lollipop:10:4:30",
           "barrel:10:40:2:30")  # fmt: skip
SHANK_OF, HOLDER_OF = ((8.0, 20.0), (14.0, 5.0)), ((40.0, 25.0), (63.0, 50.0))


def depths(body, points):
    place = np.stack([points[:, 0], np.zeros(len(points)), points[:, 1]], axis=1)
    return depth_of(body, np.zeros(3), np.array([0.0, 0.0, 1.0]), place)


@pytest.mark.parametrize("text", CUTTERS)
@pytest.mark.parametrize("above", [((), ()), (SHANK_OF, ()), (SHANK_OF, HOLDER_OF)])
def test_every_point_of_the_outline_lies_on_the_body_and_points_away_from_it(text, above):
    body = body_of(parse_cutter(text), *above)
    result = outline(body)
    middle, outward = (result.start + result.end) / 2, result.start_normal + result.end_normal
    assert np.abs(depths(body, result.end)).max() < 1e-9 and np.abs(depths(body, result.start)).max() < 1e-9
    assert np.all(depths(body, middle + 0.05 * outward) < 0.0) and np.all(
        depths(body, middle - 0.05 * outward) > 0.0
    )


@pytest.mark.parametrize("text", CUTTERS)
def test_it_is_one_line_from_the_tip_to_the_axis_again(text):
    result = outline(body_of(parse_cutter(text), SHANK_OF, HOLDER_OF))
    assert np.allclose(result.start[0], 0.0, atol=1e-12) and result.end[-1, 0] == 0
    assert np.allclose(result.end[:-1], result.start[1:], atol=1e-12)
    assert list(dict.fromkeys(result.part)) == [CUTTER, SHANK, HOLDER]


def test_turned_about_the_axis_it_has_the_volume_of_a_ball_end_with_shank_and_holder():
    result = outline(body_of(parse_cutter("ball:10:30"), ((8.0, 20.0),), ((40.0, 25.0),)))
    (r0, z0), (r1, z1) = result.start.T, result.end.T
    volume = float((np.pi / 3 * (z1 - z0) * (r0 * r0 + r0 * r1 + r1 * r1)).sum())
    truth = np.pi * (2 / 3 * 125 + 25 * 25 + 16 * 20 + 400 * 25)
    assert volume == pytest.approx(truth, rel=1e-4)
    assert volume != pytest.approx(truth, rel=1e-7), (
        "arcs are polygons: a comparison that takes anything would pass here too"
    )
