# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that change nothing beside the others are named, and what counts is not."""

import pytest
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
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


def find_in(task, **given):
    source = "a.ngc" if task == "audit" else "a.stl"
    machine = {"machines": ("trunnion_ac",)} if task == "compare" else {"machine": "trunnion_ac"}
    return [str(one) for one in find_unused(build_settings(task, source, machine | given))]


@pytest.mark.parametrize(
    ("task", "given", "needed"),
    [
        ("mill", {"boundary_by": "centre"}, {"boundary": "c.csv"}),
        ("reach", {"boundary_axis": "1,0,0"}, {"boundary": "c.csv"}),
        ("mill", {"fixture_clearance": 5}, {"fixture": ("v.stl",)}),
        ("audit", {"fixture_clearance": 5}, {"machine": "trunnion_with_bodies"}),
        ("compare", {"fixture_clearance": 5}, {"fixture": ("v.stl",)}),
        ("setup", {"jaw_thickness": 20}, {"fixture": ("v.stl",)}),
        ("audit", {"axis_tolerance": 2}, {"against": "a.apt"}),
        ("setup", {"frames": 3, "passes": "planes"}, {"passes": "frames"}),
        ("compare", {"pass_axis": "0,1,0"}, {"tool_axis": "from_axis", "passes": "planes"}),
    ],
)
def test_each_task_names_what_has_no_effect_and_not_what_has(task, given, needed):
    (sentence,) = find_in(task, **given)
    assert sentence.startswith("--" + next(iter(given)).replace("_", "-") + " has no effect")
    assert find_in(task, **(given | needed)) == []
    assert find_in(task) == []


def test_studies_complain_on_the_terminal(tmp_path, capsys):
    write_stl(from_triangles(box((-9, -9, 0), (9, 9, 9))), tmp_path / "a.stl")
    part = str(tmp_path / "a.stl")
    assert cli.main(["reach", part, "--machine", "trunnion_ac", "--boundary-axis", "1,0,0"]) == 0
    assert "--boundary-axis has no effect without --boundary" in capsys.readouterr().err
