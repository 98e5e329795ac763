# SPDX-License-Identifier: LGPL-2.1-or-later
import dataclasses
import math

import pytest

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.pipeline.option_values import READERS
from freecad_fiveaxis.core.pipeline.settings import (
    RENAMED,
    TASKS,
    Settings,
    build_settings,
    flat_options,
    option_fields,
)


def mill(**options):
    return build_settings("mill", "part.stl", {"machine": "trunnion_ac", **options})


@pytest.mark.parametrize("given", ["fast", "1000 rpm", "OFF?"])
def test_a_spindle_that_is_no_speed_is_reported_of_off(given):
    with pytest.raises(SettingsError, match="is no speed; give a number, 1/min, or off"):
        build_settings("mill", "part.stl", {"machine": "trunnion_ac", "output": "o.ngc", "spindle": given})


def test_units_are_turned_once_at_the_border():
    settings = mill(scallop="0.001in", direction="30", cutter="ball:0.5in", origin="0,0,1in", feed="10ipm")
    assert settings.passes.scallop == pytest.approx(0.0254)
    assert settings.passes.direction == pytest.approx(math.radians(30))
    assert settings.cutter.cutter.diameter == pytest.approx(12.7)
    assert settings.machine.origin == (0.0, 0.0, 25.4)
    assert settings.feeds.feed == pytest.approx(254.0)


@pytest.mark.parametrize(
    "options",
    [{"scallop": "-0.01"}, {"scallop": "0"}, {"stepover": 0}, {"tolerance": "0"}, {"feed": "-1"}, {"cutter": "ball:0"},
     {"cutter": "ball:-3"}, {"cutter": "cone:3"}, {"order": "spiral"}, {"lead": "100"}, {"max_axis_angle": "200"}, {"origin": "1,2"},
     {"clearance": "nan"}, {"scallop": "0.1", "stepover": "1"}, {"scalop": "0.1"}, {"linearize": "maybe"}, {"singularity": "ignore"}, {"tool_length": "-1"},
     {"machine": ""}, {"output": 5}, {"report": [3]}, {"axis": "a,b,c"}],
)  # fmt: skip
def test_a_bad_value_is_refused_and_named(options):
    with pytest.raises(SettingsError) as error:
        mill(**options)
    name, value = next(iter(options.items()))
    message = str(error.value)
    assert name.replace("_", "-") in message or str(value) in message
    assert "\n" not in message


def test_a_misspelt_option_gets_a_suggestion():
    with pytest.raises(SettingsError, match="do you mean 'scallop'"):
        mill(scalop="0.1")


def test_a_former_name_of_an_option_is_taken_as_before():
    assert mill(left="on") == mill(rest="on") != mill() and mill(left="on").explicit == {"machine", "rest"}
    assert mill(left=None, rest="on").gouge.rest == "on"


def test_an_option_under_both_its_names_is_refused():
    with pytest.raises(SettingsError, match="left is the former name of rest; give rest alone"):
        mill(left="on", rest="on")


def test_former_names_are_those_of_no_option_and_lead_to_one():
    names = {leaf.name for _, leaf in option_fields()}
    assert not names & set(RENAMED) and set(RENAMED.values()) <= names


@pytest.mark.parametrize(
    ("options", "passes", "tool_axis"),
    [({}, "scallop", "auto"), ({"stepover": 1}, "scallop", "auto"), ({"lead": 5}, "scallop", "auto"),
     ({"tool_axis": "minimax"}, "scallop", "minimax"), ({"direction": 0}, "planes", "facet_mean"),
     ({"plane_normal": "0,1,1"}, "planes", "facet_mean"), ({"passes": "zlevel"}, "zlevel", "facet_mean"),
     ({"passes": "planes", "tool_axis": "auto"}, "planes", "auto"), ({"direction": 0, "tool_axis": "auto"}, "planes", "auto"),
     ({"direction": 0, "passes": "scallop"}, "scallop", "auto"), ({"cutter": "taperball:4:5deg"}, "scallop", "auto"),
     ({"cutter": "bull:10:2"}, "scallop", "face_normal"), ({"cutter": "flat:6", "tool_axis": "auto"}, "scallop", "auto")],
)  # fmt: skip
def test_strategies_that_are_not_named_are_chosen_by_what_is_requested(options, passes, tool_axis):
    settings = mill(**options)
    assert (settings.passes.passes, settings.tool_axis.tool_axis) == (passes, tool_axis)
    flat = flat_options(settings)
    assert (flat["passes"], flat["tool_axis"]) == (passes, tool_axis)
    assert settings.explicit == {"machine", *options}


def test_an_option_of_another_task_is_refused():
    with pytest.raises(SettingsError, match="unknown option 'scallop' for audit"):
        build_settings("audit", "a.ngc", {"machine": "trunnion_ac", "scallop": 1})


@pytest.mark.parametrize("task", TASKS)
def test_flat_options_make_the_same_settings_again(task):
    name, value, other = {"prove-signs": ("gap", "25", "30"), "recover": ("certainty", "0.02", "0.03")}.get(
        task, ("tolerance", "0.02", "0.03")
    )
    options = {"machines" if task == "compare" else "machine": "trunnion_ac", name: value}
    options |= {"program": "x.ngc"} if task == "recover" else {}
    options |= (
        {"direction": "33.3", "lead": "5", "scallop": "0.0123", "cutter": "ball:7.7"}
        if task == "mill"
        else {}
    )
    settings = build_settings(task, "x", options)
    flat = flat_options(settings)
    again = build_settings(flat.pop("task"), flat.pop("source"), flat)
    assert again == settings
    assert build_settings(task, "x", options | {name: other}) != settings


def test_every_option_is_listed_once_with_help_a_known_kind_and_a_default():
    names = [leaf.name for _, leaf in option_fields()]
    assert len(names) == len(set(names))
    for _, leaf in option_fields():
        assert leaf.metadata["text"] and leaf.metadata["kind"] in READERS and leaf.metadata["tasks"]
        assert leaf.default is not dataclasses.MISSING


def test_defaults_work_for_a_mill_job():
    assert isinstance(mill(), Settings)


@pytest.mark.parametrize(
    ("name", "value", "bound"),
    [("clearance", "1e9", "at most 10000 mm"), ("origin", "1e9,0,0", "at most 1000000 mm"), ("origin", [0, -1e9, 0], "at least -1000000 mm"),
     ("tool_length", "1e9", "at most 1000000 mm"), ("feed", "1e-300", "at least 0.001 mm/min"), ("feed", "1e300", "at most 1000000 mm/min"),
     ("plunge_feed", "0", "at least 0.001 mm/min"), ("axis", "0,0,1e300", "at most 1000000"), ("tolerance", "1e7", "at most 1000000 mm"),
     ("scallop", "1e9", "at most 1000000 mm"), ("stepover", "1e9", "at most 1000000 mm"), ("least_interval", "1e9", "at most 1000000 mm"),
     ("coedge_tolerance", "1e9", "at most 1000000 mm"), ("tool", "100000", "at most 99999"), ("spindle", "1e6", "at most 999999"),
     ("blend", "1000", "at most 999 mm"), ("lead", "91", "at most 90 deg"), ("max_axis_angle", "181", "at most 180 deg"),
     ("cutter", "ball:1e9", "0.001 to 10000 mm"), ("cutter", "ball:10:1e9", "0.001 to 10000 mm")],
)  # fmt: skip
def test_what_is_out_of_range_is_refused_with_the_option_and_its_range(name, value, bound):
    with pytest.raises(SettingsError) as error:
        mill(**{name: value})
    assert name.replace("_", "-") in str(error.value) and bound in str(error.value)


@pytest.mark.parametrize(
    "options",
    [{"clearance": 1e4}, {"origin": "1e6,-1e6,0"}, {"tool_length": 1e6}, {"feed": "0.001"}, {"feed": 1e6}, {"axis": "-1e6,0,0"}, {"tool": 99999},
     {"spindle": 999999}, {"blend": 999}, {"lead": 60}, {"max_axis_angle": 180}],
)  # fmt: skip
def test_the_ends_of_a_range_belong_to_it(options):
    mill(**options)


@pytest.mark.parametrize("axis", ["0,0,0", "1e-300,0,0"])
def test_a_fixed_axis_without_a_direction_is_refused_before_the_work(axis):
    with pytest.raises(SettingsError, match=r"^axis .* has no direction; give I,J,K"):
        mill(tool_axis="fixed", axis=axis)
    mill(axis=axis)  # another strategy does not use it


def test_the_cutter_belongs_to_the_tasks_that_add_rapids_and_to_audits_against_a_part():
    def tasks(name):
        return {task for task in TASKS for _, leaf in option_fields(task) if leaf.name == name}

    assert tasks("cutter") == {"mill", "post", "setup", "compare", "audit", "reach"} and tasks(
        "coedge_tolerance"
    ) == {
        "mill",
        "setup",
        "compare",
    }
    settings = build_settings("post", "a.apt", {"machine": "trunnion_ac", "cutter": "ball:6"})
    assert settings.cutter.cutter.diameter == 6.0


@pytest.mark.parametrize("source", ["a\0b", "a\ud800b", ""])
def test_a_source_that_no_file_can_be_is_refused(source):
    with pytest.raises(SettingsError, match="source"):
        build_settings("mill", source, {"machine": "trunnion_ac"})


@pytest.mark.parametrize("task", ["audit", "recover"])
def test_what_a_program_does_not_say_itself_can_be_stated(task: str) -> None:
    more = {"program": "p.nc"} if task == "recover" else {}
    reported = build_settings(
        task, "p.nc", {"machine": "trunnion_ac", "units": "inch", "decimal": "least-increment", **more}
    )
    assert (reported.reading.units, reported.reading.decimal) == ("inch", "least-increment")
    with pytest.raises(SettingsError, match="not one of file, mm, inch"):
        build_settings(task, "p.nc", {"machine": "trunnion_ac", "units": "cm", **more})
