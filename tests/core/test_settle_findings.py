# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the map of what is left settles of findings made on the way: the dense judge sides with the map."""

from functools import cache

import numpy as np
from gouge_examples import prism
from plain import build_settings
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job

RIDGE = [(0, 0), (40, 0), (40, 8), (30, 10), (24, 26), (16, 27), (4, 12), (0, 10)]
RADIUS = 3.0


@cache
def milled(rest):
    """A ridge with steep flanks, level planes on these and planes side by side on the rest."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "scallop": 0.2}
    given = {**options, "steep_shallow": 40, "tool_axis": "facet_mean", "rest": rest}
    return job.prove(job.make(build_settings("mill", "part", given), mesh=prism(RIDGE, 30)))


def sampled_heights(result):
    """How far the ball stays off the samples of the map, at 40 places of each feed block and rapid."""
    words = result.draft.program.words
    share = np.linspace(0.0, 1.0, 40)[:, None, None]
    dense = (words[:-1] + share * np.diff(words, axis=0)).reshape(-1, words.shape[1])
    tip, axis = forward(result.draft.kinematics, words_to_q(dense))
    return cKDTree(tip + RADIUS * axis).query(result.rest.point)[0] - RADIUS


def interval(result):
    return next(one for one in result.findings if one.code == "least-interval")


def test_where_the_map_finds_less_left_than_planes_alone_leave_it_is_a_note_of_the_map():
    estimate, settled = interval(milled("off")), interval(milled("on"))
    most = float(milled("on").rest.height.max())
    assert sampled_heights(milled("on")).max() < most + 0.05 < 0.5 * estimate.value
    assert estimate.severity.name == "WARNING" and "stand no closer" in estimate.text
    assert (
        settled.severity.name == "NOTE" and settled.value == most and "Other passes cut there" in settled.text
    )
