# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences without a window: defaults, units, folders, colours; and the form shows the same
defaults."""

import math
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

pytest.importorskip("FreeCAD")
from freecad_fiveaxis.app import preferences
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline.options import DEFAULT_SCALLOP
from freecad_fiveaxis.core.pipeline.settings import option_fields
from freecad_fiveaxis.core.tool import parse_cutter

FORM = Path(__file__).parents[2] / "resources" / "ui" / "preferences.ui"


@pytest.fixture(autouse=True)
def kept():
    """What the user prefers is put back."""
    before = {key: preferences.read(key) for key in preferences.DEFAULTS}
    preferences.reset()
    yield
    preferences.reset()
    for key, value in before.items():
        if value != preferences.DEFAULTS[key]:
            preferences.write(key, value)


def test_the_defaults_are_those_of_the_core():
    core = {leaf.name: leaf.default for _, leaf in option_fields("mill")}
    assert preferences.feed() == core["feed"]
    assert preferences.tolerance() == core["tolerance"]
    assert parse_cutter(preferences.cutter()) == core["cutter"]
    assert preferences.shank() == preferences.holder() == "" and core["shank"] == core["holder"] == ()
    assert preferences.scallop() == DEFAULT_SCALLOP
    assert preferences.controller() is core["controller"]
    assert load_machine(preferences.machine()).axes
    assert preferences.machine_folder() is None and preferences.output_folder() is None


def test_what_is_written_is_read_in_the_units_of_the_core(tmp_path):
    given = {
        "Machine": "mikron_ucp710", "Controller": "fanuc", "MachineFolder": str(tmp_path), "OutputFolder": "~/nc",
        "CutterKind": "taperbull", "CutterDiameter": 6.0, "CutterCorner": 1.5, "CutterTaper": 3.0, "Shank": "6x20", "Holder": " 40x25 ",
        "Scallop": 0.02, "Tolerance": 0.005, "Feed": 20.0, "ColourGood": 0x3366CC00, "Processes": 3,
    }  # fmt: skip
    for key, value in given.items():
        preferences.write(key, value)
    assert (preferences.machine(), preferences.controller()) == ("mikron_ucp710", "fanuc")
    assert preferences.machine_folder() == tmp_path
    assert preferences.output_folder() == Path.home() / "nc"
    assert (preferences.scallop(), preferences.tolerance()) == (0.02, 0.005)
    assert parse_cutter(preferences.cutter()) == parse_cutter("taperbull:6:1.5:3deg")
    assert (preferences.shank(), preferences.holder()) == ("6x20", "40x25")
    assert preferences.feed() == 1200.0  # FreeCAD keeps mm/s
    assert preferences.processes() == 3
    assert preferences.colour_good() == pytest.approx((0.2, 0.4, 0.8))


def test_colours_are_distinguished():
    colours = [preferences.colour_good(), preferences.colour_bad(), preferences.colour_singular()]
    assert all(0 <= part <= 1 for colour in colours for part in colour)
    assert min(math.dist(colours[i], colours[i - 1]) for i in range(3)) > 0.4


def test_an_emptied_machine_is_the_default():
    preferences.write("Machine", "  ")
    assert preferences.machine() == preferences.DEFAULTS["Machine"]


def test_a_kind_of_cutter_that_is_not_known_is_the_default():
    preferences.write("CutterKind", "lens")
    assert preferences.cutter() == "ball:10.0:50.0"


def test_reset_forgets_everything():
    for key, default in preferences.DEFAULTS.items():
        preferences.write(key, default + "x" if isinstance(default, str) else default + 1)
        assert preferences.read(key) != default
    preferences.reset()
    assert {key: preferences.read(key) for key in preferences.DEFAULTS} == preferences.DEFAULTS


@pytest.mark.parametrize("call", [preferences.read, lambda key: preferences.write(key, 1.0)])
def test_a_key_that_is_not_ours_is_refused(call):
    with pytest.raises(KeyError):
        call("Colour")


def test_the_form_has_a_widget_for_every_key_with_the_same_default():
    widgets = {widget.get("name"): widget for widget in ET.parse(FORM).iter("widget")}
    for key, default in preferences.DEFAULTS.items():
        reported = {one.get("name"): one for one in widgets[key].findall("property")}
        if widgets[key].get("class").startswith("Gui::"):
            assert reported["prefEntry"].findtext("cstring") == key
            assert (
                "BaseApp/Preferences/" + reported["prefPath"].findtext("cstring")
                == preferences.GROUP.split(":")[1]
            )
        if isinstance(default, float):
            a_minute = 60 if key == "Feed" else 1
            assert float(reported["value"].findtext("double")) == pytest.approx(default * a_minute, rel=1e-12)
        elif key == "Processes":
            assert int(reported["value"].findtext("number")) == default
        elif isinstance(default, int):
            rgb = [int(reported["color"].find("color").findtext(part)) for part in ("red", "green", "blue")]
            assert rgb == [default >> 24, default >> 16 & 255, default >> 8 & 255]
