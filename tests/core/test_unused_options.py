# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that change nothing beside the others are named, and what counts is not."""

import pytest

from freecad_fiveaxis.core.orientation.strategies import STRATEGIES as AXES
from freecad_fiveaxis.core.passes.strategies import PASS_STRATEGIES as PASSES
from freecad_fiveaxis.core.pipeline.settings import build_settings, option_fields
from freecad_fiveaxis.core.pipeline.unused_options import USERS, find_unused


def unused(**given):
    return [str(one) for one in find_unused(build_settings("mill", "a.stl", {"machine": "m", **given}))]


@pytest.mark.parametrize(
    ("given", "counts"),
    [
        ({"frames": 3, "passes": "planes"}, {"passes": "frames"}),
        ({"plane_normal": "0,1,0", "passes": "scallop"}, {"passes": "planes"}),
        ({"direction": 20, "passes": "zlevel"}, {"passes": "radial"}),
        ({"from": "0,0,8", "passes": "planes"}, {"passes": "scallop"}),
        ({"to": "0,0,8"}, {"passes": "morph"}),
        ({"pass_axis": "0,1,0"}, {"tool_axis": "from_axis", "passes": "planes"}),
        ({"axis": "0,1,1"}, {"tool_axis": "fixed"}),
        ({"max_tilt": 9}, {"gouge": "tilt"}),
        ({"max_axis_change": 5}, {"singularity": "deform"}),
    ],
)
def test_what_has_no_effect_is_named_with_what_it_is_for(given, counts):
    sentences = unused(**given)
    assert len(sentences) == 1 and sentences[0].startswith(
        "--" + next(iter(given)).replace("_", "-") + " has no effect"
    )
    assert all(value in sentences[0] for value in [counts.get("tool_axis") or next(iter(counts.values()))])
    assert unused(**{**given, **counts}) == []


def test_nothing_is_named_where_nothing_was_given_and_a_direction_alone_means_planes():
    assert (
        unused()
        == []
        == unused(direction=30)
        == unused(plane_normal="0,1,0", tool_axis="minimax", max_tilt=9)
    )


def test_names_and_values_are_those_of_settings_and_strategies():
    leaves = {leaf.name: leaf for _, leaf in option_fields("mill")}
    known = {"passes": PASSES, "tool_axis": AXES}
    for name, users in USERS.items():
        for user, values in users:
            assert name in leaves and set(values) <= set(known.get(user) or leaves[user].metadata["choices"])
