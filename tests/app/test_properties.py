# SPDX-License-Identifier: LGPL-2.1-or-later
"""The setting properties are those of the core, with its defaults, in FreeCAD's units."""

import dataclasses
from dataclasses import astuple

import FreeCAD
import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import auditing, convert, option_texts, properties, toolpath
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.orientation.strategies import STRATEGIES
from freecad_fiveaxis.core.pipeline import options
from freecad_fiveaxis.core.pipeline.settings import (
    AUDIT,
    MILL,
    FacesSettings,
    OutputSettings,
    build_settings,
    option_fields,
)
from freecad_fiveaxis.core.tool import KINDS, Cutter, kind_of, parse_cutter
from freecad_fiveaxis.core.tool.body import body_of


@pytest.fixture
def path(doc):
    return toolpath.make(doc, None, {"machine": "trunnion_ac"}, {})


GROUPS = {"Part", "Machine", "Tool", "Passes", "Axis", "Safety", "Output"}
"""As in the panel."""


def test_every_option_but_files_to_write_or_to_select_has_a_property_with_its_group_and_help(path):
    for cls, leaf in option_fields(MILL):
        kind = leaf.metadata["kind"]
        if cls in (OutputSettings, FacesSettings) or kind in ("path", "paths"):
            assert properties.property_name(leaf.name) not in {
                one.name for one in properties.setting_properties(MILL)
            }
            continue
        names = (
            [one.name for one in properties.CUTTER]
            if kind == "cutter"
            else [properties.property_name(leaf.name)]
        )
        for name in names:
            assert path.getGroupOfProperty(name) == properties.group_of(cls, leaf) in GROUPS
            if kind != "cutter":
                assert path.getDocumentationOfProperty(name) == option_texts.editor_text(leaf)
            assert path.getTypeIdOfProperty(name).startswith("App::Property")


def test_the_property_editor_says_what_its_choices_mean(path):
    """It shows the names of the core, which FreeCAD does not translate."""
    for name in ("ToolAxis", "PassStrategy", "FeedMode", "Order"):
        text = path.getDocumentationOfProperty(name)
        assert all(f"{choice}: " in text for choice in path.getEnumerationsOfProperty(name)), name
    assert "machine's own: " in path.getDocumentationOfProperty("Controller")
    assert path.getDocumentationOfProperty("Blend").startswith("Corner rounding")


def test_the_defaults_are_the_cores_to_the_last_bit(path):
    assert convert.settings_of(path, MILL, "x") == build_settings(MILL, "x", {"machine": "trunnion_ac"})


def test_an_audits_defaults_too(doc, tmp_path):
    result = auditing.make(doc, str(tmp_path / "x.ngc"), {"machine": "mikron_ucp710"}, {})
    assert convert.settings_of(result, AUDIT, "x") == build_settings(AUDIT, "x", {"machine": "mikron_ucp710"})


GIVEN = {
    "machine": "fork_head_bc", "controller": "FANUC", "origin": (1.5, -2.0, 0.25), "tool_length": 123.4, "cutter": "ball:0.5in:2in",
    "feed": 1234.5, "plunge_feed": "12in/min", "passes": "planes", "direction": -30, "scallop": 0.003, "max_axis_angle": 70, "steep_shallow": 40, "lead": 3, "tilt": "-0.1rad",
    "tool": 7, "spindle": 12000, "coolant": "on", "feed_mode": "g94", "work_offset": "G55", "tool_axis": "fixed", "axis": "1,0,2",
    "control_point": "centre", "order": "one_way", "tolerance": "0.0005in", "blend": 0.02, "method": "so2008",
    "lead_in": 2.5, "spiral": "on", "linearize": "on", "singularity": "linearize", "high_speed": "on", "nc_units": "inch", "gouge": "lift", "shank": "8x20", "holder": "1inx2in,63x50.5",
}  # fmt: skip


def test_every_setting_comes_back_as_it_was_given(path):
    convert.put_options(path, MILL, GIVEN)
    got, wanted = convert.settings_of(path, MILL, "x"), build_settings(MILL, "x", GIVEN)
    for one, other in zip(dataclasses.fields(got), dataclasses.fields(wanted), strict=True):
        if one.name in ("task", "source", "explicit"):
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
    assert (
        settings.machine.controller is None and settings.machine.origin is None and settings.head.tool is None
    )
    path.OriginFromMachine = False
    assert convert.settings_of(path, MILL, "x").machine.origin == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("Tolerance", 0, "tolerance"),
        ("CutterDiameter", 0, "cutter diameter"),
        ("Lead", 100, "lead"),
        ("Tool", -1, "tool"),
        ("Machine", "", "machine"),
    ],
)
def test_the_core_checks_the_properties(path, name, value, says):
    setattr(path, name, value)
    with pytest.raises(SettingsError, match=says):
        convert.settings_of(path, MILL, "x")


SHAPES = [
    "ball:10", "flat:10:20", "bull:0.5in:2", "taperball:6:5deg:30", "taperbull:10:1.25:0.1rad", "lollipop:0.5in:6:40",
    "barrel:10:80:2.5",
]  # fmt: skip


@pytest.mark.parametrize("text", SHAPES)
def test_every_cutter_comes_back_as_it_was_given_and_survives_the_file(path, text, reopen):
    convert.put_options(path, MILL, {"cutter": text})
    got, wanted = convert.settings_of(path, MILL, "x").cutter.cutter, parse_cutter(text)
    assert path.CutterKind == kind_of(wanted) == text.partition(":")[0]
    assert astuple(got)[:4] == pytest.approx(astuple(wanted)[:4], rel=1e-11) and (got.neck, got.flank) == (
        wanted.neck,
        wanted.flank,
    )
    assert convert.settings_of(reopen(path.Document).Toolpath, MILL, "x").cutter.cutter == got


def test_another_kind_is_a_cutter_at_once(path):
    for kind in KINDS:
        path.CutterKind = kind
        assert kind_of(convert.settings_of(path, MILL, "x").cutter.cutter) == kind


def test_a_cutters_sizes_have_units(path):
    path.CutterKind, path.CutterCorner, path.CutterTaper = "taperbull", "0.05 in", "0.1 rad"
    cutter = convert.settings_of(path, MILL, "x").cutter.cutter
    assert (cutter.corner, cutter.taper) == pytest.approx((1.27, 0.1))


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"CutterKind": "bull", "CutterCorner": 6}, "corner radius is 6 mm; give 0 to 5 mm"),
        (
            {"CutterKind": "lollipop", "CutterNeck": 10},
            "neck is 10 mm; give 0.001 mm or more, and less than 10 mm",
        ),
        (
            {"CutterKind": "barrel", "CutterFlank": 4},
            "flank radius is 4 mm; give more than 5 mm, half the diameter",
        ),
        ({"CutterKind": "taperball", "CutterTaper": 70}, "taper is 70 deg; give 0 to 60 deg"),
        ({"CutterKind": "taperball", "CutterLength": 2}, "the taper begins"),
        ({"Holder": "40"}, "diameter x length"),
        ({"Shank": "8x0"}, "above 0"),
    ],
)
def test_what_no_tool_has_is_refused_with_the_remedy(path, values, says):
    for name, value in values.items():
        setattr(path, name, value)
    with pytest.raises(SettingsError, match=says):
        convert.settings_of(path, MILL, "x")
    with pytest.raises(SettingsError, match=says):
        convert.tool_of(path)


def test_the_property_editor_shows_the_sizes_that_the_kind_has(path, reopen):
    def hidden(obj):
        return {
            name
            for name in ("CutterDiameter", "CutterCorner", "CutterTaper", "CutterNeck", "CutterFlank")
            if "Hidden" in obj.getEditorMode(name)
        }

    assert hidden(path) == {"CutterCorner", "CutterTaper", "CutterNeck", "CutterFlank"}
    path.Document.recompute()
    path.purgeTouched()
    for kind, lacks in (
        ("bull", {"CutterTaper"}),
        ("taperbull", set()),
        ("flat", {"CutterCorner", "CutterTaper"}),
    ):  # and neither neck nor flank
        path.CutterKind = kind
        assert hidden(path) == lacks | {"CutterNeck", "CutterFlank"}
    path.CutterKind = "lollipop"
    assert hidden(path) == {"CutterCorner", "CutterTaper", "CutterFlank"}
    path.CutterKind = "barrel"
    assert hidden(path) == {"CutterTaper", "CutterNeck"}
    path.CutterKind = "taperball"
    assert hidden(reopen(path.Document).Toolpath) == {"CutterCorner", "CutterNeck", "CutterFlank"}


def test_sizes_that_the_kind_has_not_are_not_looked_at(path):
    path.CutterCorner, path.CutterTaper = 600, 80
    assert convert.settings_of(path, MILL, "x").cutter.cutter == Cutter(10.0)


@pytest.mark.parametrize("text", SHAPES)
def test_the_tool_that_is_drawn_is_the_body_that_is_checked(path, text):
    convert.put_options(path, MILL, {"cutter": text, "shank": "8x20,12x30", "holder": "40x25"})
    drawn, settings = convert.tool_of(path), convert.settings_of(path, MILL, "x")
    assert drawn.body == options.tool_body(settings) and drawn.cutter == settings.cutter.cutter
    assert drawn.body != options.tool_body(
        build_settings(MILL, "x", {"machine": "trunnion_ac", "cutter": text})
    )


def test_an_audit_draws_shank_and_holder_too(doc, tmp_path):
    (tmp_path / "x.ngc").write_text("G21 G90 G94\nG1 X0 Y0 Z10 A0 C0 F100\nX10 A1\n")
    result = app.audit(
        doc, tmp_path / "x.ngc", "trunnion_ac", cutter="bull:10:2", holder="2inx1in", shank="8x20"
    )
    assert (result.Holder, result.Shank, result.CutterKind) == (
        "50.8x25.4",
        "8x20",
        "bull",
    ) and result.State == ["Up-to-date"]
    assert convert.tool_of(result).body == body_of(Cutter(10.0, corner=2.0), [(8, 20)], [(50.8, 25.4)])


def test_macros_may_give_the_holder_as_one_cylinder(doc, ball):
    path = app.create_toolpath(doc, ball, **FAST, holder_diameter="2in")
    assert path.Holder == "50.8x60"
    with pytest.raises(SettingsError, match="holder and holder_length say the same"):
        app.create_toolpath(doc, ball, **FAST, holder_length=30, holder="40x25")


def test_both_spacings_at_once_are_refused(path):
    path.Scallop, path.Stepover = 0.01, 1
    with pytest.raises(SettingsError, match="exclude each other"):
        convert.settings_of(path, MILL, "x")


@pytest.mark.parametrize(
    ("options", "says"),
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
    assert (
        path.getEnumerationsOfProperty("ToolAxis") == [*STRATEGIES, "old_way"] and path.ToolAxis == "old_way"
    )
    path.ToolAxis = "fixed"
    properties.add_missing(path, properties.setting_properties(MILL))
    assert (
        path.getEnumerationsOfProperty("ToolAxis") == [*STRATEGIES, "old_way"][: len(STRATEGIES)]
        and path.ToolAxis == "fixed"
    )


def test_files_that_settings_name_are_part_of_what_a_result_is_of(tmp_path):
    """No document object has such a setting yet but the audited file itself; the task ``recover`` has."""
    from freecad_fiveaxis.app import results
    from freecad_fiveaxis.core.pipeline.settings import RECOVER, build_settings

    (tmp_path / "a.ngc").write_text("G1 X1")
    settings = build_settings(
        RECOVER, "a.apt", {"program": str(tmp_path / "a.ngc"), "machine": "trunnion_ac"}
    )
    before = results.Task(settings, b"").fingerprint
    assert results.Task(settings, b"").fingerprint == before
    (tmp_path / "a.ngc").write_text("G1 X2")
    assert results.Task(settings, b"").fingerprint != before


@pytest.fixture
def undoable(path):
    """The path in a document that keeps steps to undo, computed."""
    path.Document.UndoMode = 1
    path.Document.recompute()
    return path


def feeds_of(path):
    """Both feeds in mm/min: as the core gets them, and as the editor shows them."""
    options = convert.settings_of(path, MILL, "x").feeds
    return (options.feed, options.plunge_feed), (path.FeedPerMinute, path.PlungeFeedPerMinute)


def test_the_editor_shows_feeds_in_mm_per_minute(path):
    assert path.getTypeIdOfProperty("FeedPerMinute") == "App::PropertyFloat"
    for name in ("Feed", "PlungeFeed"):
        assert path.getEditorMode(name) == ["Hidden"] and path.getEditorMode(name + "PerMinute") == []
        assert path.getGroupOfProperty(name + "PerMinute") == path.getGroupOfProperty(name)
        assert "mm/min" in path.getDocumentationOfProperty(name + "PerMinute")
    assert feeds_of(path)[0] == feeds_of(path)[1]


@pytest.mark.parametrize("feed", [1000.0, 1234.5, 1 / 3, 0.1 + 0.2, 25.4 * 60, 999999.0, 12345.678901234567])
def test_both_feeds_are_one_whichever_is_set(undoable, feed):
    path = undoable
    path.FeedPerMinute = feed
    assert (
        path.Feed.Value * 60 == pytest.approx(feed, rel=1e-10) == path.FeedPerMinute
        and "Touched" in path.State
    )
    path.PlungeFeed = f"{feed / 2:.17g} mm/min"
    assert path.PlungeFeedPerMinute == pytest.approx(feed / 2, rel=1e-10)
    assert feeds_of(path)[0] == feeds_of(path)[1]


@pytest.mark.parametrize(("name", "value"), [("Feed", 10.0), ("FeedPerMinute", 600.0)])
def test_undo_and_redo_put_both_feeds_back(undoable, name, value):
    path, doc = undoable, undoable.Document
    before = feeds_of(path)
    doc.openTransaction("feed")
    setattr(path, name, value)
    doc.commitTransaction()
    doc.recompute()
    assert feeds_of(path)[0][0] == feeds_of(path)[1][0] == 600.0
    doc.undo()
    assert feeds_of(path) == before
    doc.redo()
    assert feeds_of(path)[0][0] == feeds_of(path)[1][0] == 600.0


def test_an_expression_on_a_feed_rules_both(undoable):
    path, doc = undoable, undoable.Document
    sheet = doc.addObject("Spreadsheet::Sheet", "Feeds")
    sheet.set("A1", "=700 mm/min")
    doc.recompute()
    path.setExpression("Feed", "Feeds.A1")
    doc.recompute()
    assert feeds_of(path)[0][0] == path.FeedPerMinute == 700.0
    path.FeedPerMinute = 50.0
    doc.recompute()
    assert feeds_of(path)[0][0] == path.FeedPerMinute == 700.0


def test_an_expression_on_a_feed_in_mm_per_minute_rules_both(undoable):
    path = undoable
    path.setExpression("PlungeFeedPerMinute", "2 * 125")
    path.Document.recompute()
    assert feeds_of(path)[0][1] == path.PlungeFeedPerMinute == 250.0


def test_feeds_of_an_older_document_and_of_a_copy_are_shown_in_mm_per_minute(path, reopen):
    path.Feed, path.PlungeFeed = "750 mm/min", "120 mm/min"
    assert path.removeProperty("FeedPerMinute") and path.removeProperty("PlungeFeedPerMinute")
    path.setEditorMode("Feed", [])
    path.purgeTouched()
    again = reopen(path.Document).Toolpath
    assert "Touched" not in again.State
    assert feeds_of(again) == ((750.0, 120.0), (750.0, 120.0)) and again.getEditorMode("Feed") == ["Hidden"]
    copy = again.Document.copyObject(again)
    copy.FeedPerMinute = 800.0
    assert (feeds_of(copy)[0][0], feeds_of(again)[0][0]) == (800.0, 750.0)
    name = copy.Name
    third = reopen(again.Document).getObject(name)
    third.Feed = "90 mm/min"
    assert feeds_of(third)[1] == (90.0, 120.0)
