# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways over facets that are not machined: found, in closed form; and no feed block of a program touches a
strip between two floors."""

import numpy as np
import pytest
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.gouge.left_alone import BESIDE, lead_over_others
from freecad_fiveaxis.core.pipeline import build_path, job
from freecad_fiveaxis.core.toolpath.cl_path import Motion

OPTIONS = {
    "machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:4", "stepover": 1.5, "max_axis_angle": 30, "passes": "planes",
    "direction": 90, "tool_axis": "facet_mean",
}  # fmt: skip
LENGTH, HEIGHT = 20.0, 5.0


def plate(wide):
    """A plate whose top is two floors, 10 mm wide, with a strip ``wide`` mm between them at x = 10; and which
    facets are no strip."""
    x = np.array([0.0, 10.0, 10.0 + wide, 20.0 + wide])
    y, z = np.array([0.0, LENGTH]), np.array([0.0, HEIGHT])
    at = lambda i, j, k: (i * 2 + j) * 2 + k  # noqa: E731
    vertex = [(a, b, c) for a in x for b in y for c in z]
    quads = [
        (at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)),
        (at(3, 0, 0), at(3, 1, 0), at(3, 1, 1), at(3, 0, 1)),
    ]
    strip = [False, False]
    for i in range(3):
        n = i + 1
        quads += [
            (at(i, 0, 1), at(n, 0, 1), at(n, 1, 1), at(i, 1, 1)), (at(i, 0, 0), at(i, 1, 0), at(n, 1, 0), at(n, 0, 0)),
            (at(i, 0, 0), at(n, 0, 0), at(n, 0, 1), at(i, 0, 1)), (at(i, 1, 0), at(i, 1, 1), at(n, 1, 1), at(n, 1, 0)),
        ]  # fmt: skip
        strip += [i == 1, False, False, False]
    face = np.array([(q[a], q[b], q[c]) for q in quads for a, b, c in ((0, 1, 2), (0, 2, 3))])
    return from_faces(np.array(vertex), face), ~np.repeat(strip, 2)


def test_ways_over_the_strip_are_found_and_those_along_its_border_are_none():
    mesh, chosen = plate(2.0)
    begin = np.array([(9.0, 5.0), (10.0, 3.0), (2.0, 2.0), (10.0, 5.0), (12.0, 1.0), (9.0, 5.0)])
    end = np.array(
        [(13.0, 5.0), (10.0, 7.0), (8.0, 9.0), (12.0, 5.0), (12.0, 8.0), (10.0 + 0.5 * BESIDE, 5.0)]
    )
    on_top = [np.column_stack([one, np.full(len(one), HEIGHT)]) for one in (begin, end)]
    np.testing.assert_array_equal(
        lead_over_others(*on_top, mesh, chosen), [True, False, False, True, False, False]
    )
    assert not lead_over_others(*on_top, mesh, np.ones(len(chosen), bool)).any()
    assert not len(lead_over_others(on_top[0][:0], on_top[1][:0], mesh, chosen))


def touched(result, wide):
    """How many of a hundred places a feed block the ball touches the strip at."""
    path, share = result.path, np.linspace(0.0, 1.0, 101)[:, None, None]
    at = np.flatnonzero(path.motion[1:] != Motion.RAPID)
    tip = (path.tip[at] * (1.0 - share) + path.tip[at + 1] * share).reshape(-1, 3)
    assert (path.axis[:, 2] > 1.0 - 1e-9).all(), "the tip of an upright ball is what touches a level floor"
    return int(((tip[:, 0] > 10.05) & (tip[:, 0] < 9.95 + wide) & (tip[:, 2] < HEIGHT + 0.01)).sum())


@pytest.mark.thorough
@pytest.mark.parametrize("wide", [0.5, 1.0, 3.0])
def test_no_feed_block_touches_a_narrow_strip_that_is_left_alone(wide, monkeypatch):
    mesh, chosen = plate(wide)
    make = lambda: job.make(build_settings("mill", "part", OPTIONS), mesh=mesh, faces=chosen)  # noqa: E731
    result = make()
    assert touched(result, wide) == 0 and result.keep.sum() == 4
    monkeypatch.setattr(build_path, "lead_over_others", lambda begin, *_: np.zeros(len(begin), bool))
    assert (touched(make(), wide) > 0) == (wide < 2.0), "one narrower than the radius would be touched"
