# SPDX-License-Identifier: LGPL-2.1-or-later
import dataclasses
import math

import pytest

from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.settings import READERS, TASKS, Settings, build_settings, flat_options, option_fields


def mill(**options):
    return build_settings("mill", "part.stl", {"machine": "trunnion_ac", **options})


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
     {"cutter": "ball:-3"}, {"cutter": "cone:3"}, {"order": "spiral"}, {"lead": "80"}, {"max_axis_angle": "120"}, {"origin": "1,2"},
     {"clearance": "nan"}, {"scallop": "0.1", "stepover": "1"}, {"scalop": "0.1"}, {"linearize": "on"}, {"tool_length": "-1"},
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


def test_an_option_of_another_task_is_refused():
    with pytest.raises(SettingsError, match="unknown option 'scallop' for audit"):
        build_settings("audit", "a.ngc", {"machine": "trunnion_ac", "scallop": 1})


@pytest.mark.parametrize("task", TASKS)
def test_flat_options_make_the_same_settings_again(task):
    options = {"machine": "trunnion_ac", "tolerance": "0.02"}
    options |= {"direction": "33.3", "lead": "5", "scallop": "0.0123", "cutter": "ball:7.7"} if task == "mill" else {}
    settings = build_settings(task, "x", options)
    flat = flat_options(settings)
    again = build_settings(flat.pop("task"), flat.pop("source"), flat)
    assert again == settings
    assert build_settings(task, "x", options | {"tolerance": "0.03"}) != settings


def test_every_option_is_listed_once_with_help_a_known_kind_and_a_default():
    names = [leaf.name for _, leaf in option_fields()]
    assert len(names) == len(set(names))
    for _, leaf in option_fields():
        assert leaf.metadata["text"] and leaf.metadata["kind"] in READERS and leaf.metadata["tasks"]
        assert leaf.default is not dataclasses.MISSING


def test_defaults_work_for_a_mill_job():
    assert isinstance(mill(), Settings)
