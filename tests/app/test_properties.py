# SPDX-License-Identifier: LGPL-2.1-or-later
"""The setting properties are those of the core, with its defaults, in FreeCAD's units."""

import dataclasses

import FreeCAD
import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import auditing, convert, properties, toolpath
from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.post import DIALECTS
from freecad_fiveaxis.core.settings import AUDIT, MILL, build_settings, option_fields
from freecad_fiveaxis.core.tool_axis import STRATEGIES


@pytest.fixture
def path(doc):
    return toolpath.make(doc, None, {"machine": "trunnion_ac"}, {})


def test_every_option_that_is_no_file_has_a_property_with_its_group_and_help(path):
    for cls, leaf in option_fields(MILL):
        kind = leaf.metadata["kind"]
        if kind in ("path", "paths"):
            assert "Output" not in map(path.getGroupOfProperty, path.PropertiesList)
            continue
        name = "CutterDiameter" if kind == "cutter" else properties.property_name(leaf.name)
        assert path.getGroupOfProperty(name) + "Settings" == cls.__name__
        if kind != "cutter":
            assert path.getDocumentationOfProperty(name) == leaf.metadata["text"]
        assert path.getTypeIdOfProperty(name).startswith("App::Property")


def test_the_defaults_are_the_cores_to_the_last_bit(path):
    assert convert.settings_of(path, MILL, "x") == build_settings(MILL, "x", {"machine": "trunnion_ac"})


def test_an_audits_defaults_too(doc, tmp_path):
    made = auditing.make(doc, str(tmp_path / "x.ngc"), {"machine": "mikron_ucp710"}, {})
    assert convert.settings_of(made, AUDIT, "x") == build_settings(AUDIT, "x", {"machine": "mikron_ucp710"})


GIVEN = {
    "machine": "fork_head_bc", "controller": "FANUC", "origin": (1.5, -2.0, 0.25), "tool_length": 123.4, "cutter": "ball:0.5in:2in",
    "feed": 1234.5, "plunge_feed": "12in/min", "direction": -30, "scallop": 0.003, "max_axis_angle": 70, "lead": 3, "tilt": "-0.1rad",
    "tool": 7, "spindle": 12000, "coolant": "on", "feed_mode": "g94", "work_offset": "G55", "tool_axis": "fixed", "axis": "1,0,2",
    "control_point": "centre", "order": "one_way", "tolerance": "0.0005in", "blend": 0.02, "method": "so2008",
    "linearize": "on", "singularity": "linearize", "high_speed": "on",
}  # fmt: skip


def test_every_setting_comes_back_as_it_was_given(path):
    convert.put_options(path, MILL, GIVEN)
    got, wanted = convert.settings_of(path, MILL, "x"), build_settings(MILL, "x", GIVEN)
    for one, other in zip(dataclasses.fields(got), dataclasses.fields(wanted), strict=True):
        if one.name in ("task", "source"):
            continue
        group, group_wanted = vars(getattr(got, one.name)), vars(getattr(wanted, other.name))
        for name, value in group_wanted.items():
            if name == "controller":
                assert group[name] == "fanuc"
            elif isinstance(value, float):
                assert group[name] == pytest.approx(value, rel=1e-11), name
            elif name == "cutter":
                assert (group[name].diameter, group[name].length) == pytest.approx((12.7, 50.8), rel=1e-12)
            else:
                assert group[name] == value, name


def test_the_settings_survive_the_file(path, reopen):
    convert.put_options(path, MILL, GIVEN)
    path.Clearance = 1 / 3
    path.WorkZero = FreeCAD.Vector(0.1 + 0.2, 1 / 7, 2 / 3)
    before, zero = convert.settings_of(path, MILL, "x"), convert.plain(path.WorkZero)
    again = reopen(path.Document).Toolpath
    assert convert.settings_of(again, MILL, "x") == before
    assert convert.plain(again.WorkZero) == zero


def test_properties_have_units(path):
    path.Feed = "2 m/min"
    path.Tolerance = "0.001 in"
    path.Direction = "1 rad"
    settings = convert.settings_of(path, MILL, "x")
    assert settings.feeds.feed == pytest.approx(2000.0)
    assert settings.proof.tolerance == pytest.approx(0.0254)
    assert settings.passes.direction == pytest.approx(1.0)
    FreeCAD.Units.setSchema(3)
    try:
        assert path.CutterDiameter.UserString.endswith(("in", '"'))
        assert "in/min" in path.Feed.UserString
    finally:
        FreeCAD.Units.setSchema(0)


def test_choices_are_those_of_the_core(path):
    assert path.getEnumerationsOfProperty("Controller") == [properties.MACHINES_OWN, *DIALECTS]
    assert path.getEnumerationsOfProperty("ToolAxis") == list(STRATEGIES)
    assert path.getEnumerationsOfProperty("FeedMode") == ["g93", "g94"]


def test_nothing_given_is_0_or_the_machines_own(path):
    settings = convert.settings_of(path, MILL, "x")
    assert settings.machine.controller is None and settings.machine.origin is None and settings.head.tool is None
    path.OriginFromMachine = False
    assert convert.settings_of(path, MILL, "x").machine.origin == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    "name, value, says",
    [
        ("Tolerance", 0, "tolerance"),
        ("CutterDiameter", 0, "cutter diameter"),
        ("Lead", 80, "lead"),
        ("Tool", -1, "tool"),
        ("Machine", "", "machine"),
    ],
)
def test_the_core_checks_the_properties(path, name, value, says):
    setattr(path, name, value)
    with pytest.raises(SettingsError, match=says):
        convert.settings_of(path, MILL, "x")


def test_both_spacings_at_once_are_refused(path):
    path.Scallop, path.Stepover = 0.01, 1
    with pytest.raises(SettingsError, match="exclude each other"):
        convert.settings_of(path, MILL, "x")


@pytest.mark.parametrize(
    "options, says",
    [
        ({"tolerence": 1}, "do you mean 'tolerance'"), ({"feed": "fast"}, "feed 'fast'"), ({"output": "x.ngc"}, "no setting of a document"),
        ({"tool_axis": "upright"}, "facet_mean"), ({"controller": "hal9000"}, "linuxcnc"), ({"work_zero": (1, 2)}, "three numbers"),
        ({"work_zero": 5}, "three numbers"), ({"linear_deflection": 0}, "linear deflection"), ({"angular_deflection": "x"}, "angular deflection"),
        ({"machine": "trunion_ac"}, "did you mean trunnion_ac"),
    ],
)  # fmt: skip
def test_a_bad_setting_leaves_nothing_behind(doc, ball, options, says):
    with pytest.raises(ValueError, match=says):
        app.create_toolpath(doc, ball, **{**FAST, **options})
    assert [one.Name for one in doc.Objects] == ["Ball"]


def test_choices_of_an_older_document_are_renewed_and_its_own_is_kept(path):
    path.ToolAxis = ["old_way", "facet_mean"]
    path.ToolAxis = "old_way"
    properties.add_missing(path, properties.setting_properties(MILL))
    assert path.getEnumerationsOfProperty("ToolAxis") == [*STRATEGIES, "old_way"] and path.ToolAxis == "old_way"
    path.ToolAxis = "fixed"
    properties.add_missing(path, properties.setting_properties(MILL))
    assert path.getEnumerationsOfProperty("ToolAxis") == [*STRATEGIES, "old_way"][: len(STRATEGIES)] and path.ToolAxis == "fixed"


def test_files_that_settings_name_are_part_of_what_a_result_is_of(tmp_path):
    """No document object has such a setting yet but the audited file itself; the task ``recover`` has."""
    from freecad_fiveaxis.app import results
    from freecad_fiveaxis.core.settings import RECOVER, build_settings

    (tmp_path / "a.ngc").write_text("G1 X1")
    settings = build_settings(RECOVER, "a.apt", {"program": str(tmp_path / "a.ngc"), "machine": "trunnion_ac"})
    before = results.Task(settings, b"").fingerprint
    assert results.Task(settings, b"").fingerprint == before
    (tmp_path / "a.ngc").write_text("G1 X2")
    assert results.Task(settings, b"").fingerprint != before
