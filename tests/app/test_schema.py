# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of earlier versions open whole, and what they lacked is added."""

import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, properties, results, schema, toolpath
from freecad_fiveaxis.core.machine import Machine, SafeStart, load_machine, save_machine

LACKED = {
    "Toolpath": [
        "SchemaVersion",
        "Holder",
        "CutterKind",
        "WorkZero",
        "OriginFromMachine",
        "MaxBound",
        "MaxSurfaceDeviation",
        "MaxSurfaceBound",
        "Fingerprint",
        "Blend",
    ],
    "Tessellation": ["SchemaVersion", "AngularDeflection", "FacetRuns", "Facets"],
    "Markers": ["SchemaVersion", "Labels"],
}
"""What the objects of version 0 did not have."""

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def old(doc, ball):
    """A document as version 0 left it."""
    path = app.create_toolpath(doc, ball, **FAST, feed=1500)
    app.annotate(path)
    for name, lacked in LACKED.items():
        for one in lacked:
            assert doc.getObject(name).removeProperty(one), one
    return doc


def test_a_document_of_version_0_opens_and_nothing_is_lost(old, reopen):
    before = {
        name: old.Toolpath.getPropertyByName(name)
        for name in ("Stepover", "Feed", "Machine", "Blocks", "Findings")
    }
    new = reopen(old)
    for name, lacked in LACKED.items():
        assert set(lacked) <= set(new.getObject(name).PropertiesList)
        assert new.getObject(name).SchemaVersion == schema.SCHEMA == 5
    path = new.Toolpath
    assert {name: path.getPropertyByName(name) for name in before} == before
    assert (path.CutterKind, path.Holder, path.OriginFromMachine) == ("ball", "", True)
    assert tuple(path.WorkZero) == (0, 0, 0) and new.Tessellation.AngularDeflection.Value == 15
    assert path.getGroupOfProperty("MaxBound") == "Result" and path.getEditorMode("MaxBound") == ["ReadOnly"]
    assert "recompute" in results.out_of_date(
        path
    )  # a result without a fingerprint: nobody knows what it is of


def test_it_is_recomputed_to_the_same_program(old, reopen, anew):
    blocks = old.Toolpath.Blocks
    anew()
    new = reopen(old)
    new.Toolpath.touch()
    new.recompute()
    assert (
        new.Toolpath.Blocks == blocks
        and results.out_of_date(new.Toolpath) == ""
        and new.Toolpath.MaxBound > 0
    )
    again = reopen(new)
    assert results.out_of_date(again.Toolpath) == "" and list(again.Markers.Labels)


@pytest.mark.thorough
def test_version_1_had_no_cure_and_gets_every_one(doc, ball, reopen, anew):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, **UNCURED)
    blocks, deviation = path.Blocks, path.MaxSegmentDeviation.Value
    for name in ("Singularity", "MaxTilt", "MaxAxisChange"):
        assert path.removeProperty(name)
    path.Linearize, path.ToolAxis = ["off"], ["facet_mean", "step_weighted", "fixed"]
    path.SchemaVersion = 1
    anew()
    path = reopen(doc).Toolpath
    assert (path.SchemaVersion, path.Linearize, path.Singularity, path.ToolAxis) == (
        5,
        "off",
        "report",
        "facet_mean",
    )
    assert (path.MaxTilt.Value, path.MaxAxisChange.Value) == pytest.approx((5, 2))
    path.Document.recompute()
    assert path.Blocks == blocks
    path.Linearize, path.Singularity, path.ToolAxis = "on", "deform", "minimax"
    path.Document.recompute()
    assert path.MaxSegmentDeviation.Value < deviation and path.State == ["Up-to-date"]


def test_until_it_is_computed_again_an_older_document_shows_the_tips_deviation(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8})
    assert results.read_judged(path) == (path.MaxSurfaceDeviation.Value, path.MaxSurfaceBound.Value)
    tip = path.MaxSegmentDeviation.Value, path.MaxBound.Value
    assert path.removeProperty("MaxSurfaceDeviation") and path.removeProperty("MaxSurfaceBound")
    path = reopen(doc).Toolpath
    assert path.MaxSurfaceDeviation == path.MaxSurfaceBound == 0 and results.read_judged(
        path
    ) == pytest.approx(tip)


def test_version_2_knew_three_controllers_and_no_guided_tip(doc, ball, reopen, anew):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8}, controller="fanuc")
    nc = results.nc_of(path)
    for name in ("Rtcp", "HighSpeed", "GuidedBlocks", "Verdict"):
        assert path.removeProperty(name)
    path.Controller = ["machine's own", "fanuc", "linuxcnc"]
    path.Controller = "fanuc"
    path.SchemaVersion = 2
    anew()
    path = reopen(doc).Toolpath
    assert (path.SchemaVersion, path.Controller, path.Rtcp, path.HighSpeed) == (5, "fanuc", "off", "off")
    assert (path.GuidedBlocks, path.Verdict) == (0, "")
    assert results.nc_of(path) == nc, "the same settings give the same program"
    path.Controller, path.Rtcp = "heidenhain", "vectors"
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and path.GuidedBlocks > 0 and b"LN X" in results.nc_of(path)


VERSION_4 = (
    "CutterKind",
    "CutterCorner",
    "CutterTaper",
    "CutterNeck",
    "CutterFlank",
    "Gouge",
    "Shank",
    "Holder",
    "Links",
)
"""What version 3 had not."""


def of_version_3(obj, diameter=40.0, length=60.0):
    """Make it what version 3 saved: ball cutters, and a holder of one cylinder that was only drawn."""
    for name in set(VERSION_4) & set(obj.PropertiesList):
        assert obj.removeProperty(name), name
    for name, size in (("HolderDiameter", diameter), ("HolderLength", length)):
        obj.addProperty("App::PropertyLength", name, "Cutter", "")
        setattr(obj, name, size)
    obj.SchemaVersion = 3


@pytest.mark.parametrize(
    ("sizes", "text"), [((40.0, 60.0), "40x60"), ((31.75, 1 / 3), "31.75x0.333333333333"), ((40.0, 0.0), "")]
)
def test_version_3_had_a_holder_of_one_cylinder_and_ball_cutters_only(doc, ball, reopen, anew, sizes, text):
    path = app.create_toolpath(doc, ball, **FAST, cutter="ball:6:30", links="over")
    nc = results.nc_of(path)
    of_version_3(path, *sizes)
    anew()
    path = reopen(doc).Toolpath
    assert (path.SchemaVersion, path.CutterKind, path.CutterDiameter.Value, path.CutterLength.Value) == (
        5,
        "ball",
        6,
        30,
    )
    assert (path.Holder, path.Shank, path.Gouge) == (text, "", "off")
    assert results.nc_of(path) == nc, "a holder that was only drawn changes no program"
    assert path.HolderDiameter.Value == sizes[0] and "Hidden" in path.getEditorMode("HolderDiameter")
    path.Gouge, path.CutterKind = "report", "bull"
    path.Document.recompute()
    assert path.State == ["Up-to-date"]
    again = reopen(path.Document).Toolpath
    assert (again.Holder, again.CutterKind) == (text, "bull") and "Hidden" in again.getEditorMode(
        "HolderLength"
    )


def test_an_audit_of_version_3_keeps_the_holder_that_is_drawn(doc, reopen, tmp_path):
    (tmp_path / "a.ngc").write_text("G21 G90 G94\nG1 X0 Y0 Z10 A0 C0 F100\nX10 A1\n")
    of_version_3(app.audit(doc, tmp_path / "a.ngc", "trunnion_ac"), 50.0, 25.5)
    judged = reopen(doc).Audit
    assert (judged.SchemaVersion, judged.CutterKind, judged.Holder) == (5, "ball", "50x25.5")


def test_the_groups_of_an_older_document_get_the_names_of_the_trade(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8})
    before = {name: path.getPropertyByName(name) for name in ("Spindle", "Clearance", "Feed")}
    for name, group in (
        ("Linearize", "Cure"),
        ("Spindle", "Head"),
        ("Clearance", "Link"),
        ("WorkZero", "Machine"),
    ):
        path.setGroupOfProperty(name, group)
    again = reopen(doc).Toolpath
    groups = [again.getGroupOfProperty(name) for name in ("Linearize", "Spindle", "Clearance", "WorkZero")]
    assert groups == ["Safety", "Tool", "Safety", "Part"] and "Touched" not in again.State
    assert {name: again.getPropertyByName(name) for name in before} == before
    assert not {"Cure", "Head", "Link"} & set(map(again.getGroupOfProperty, again.PropertiesList))


def test_every_version_has_its_step():
    assert sorted(schema.STEPS) == list(range(schema.SCHEMA))


def test_a_step_runs_before_the_missing_are_added(doc, monkeypatch):
    path = toolpath.make(doc, None, {"machine": "trunnion_ac"}, {})
    path.removeProperty("SchemaVersion")
    path.addProperty("App::PropertyLength", "OldHolder")
    path.OldHolder = 33
    path.removeProperty("Clearance")

    def renamed(obj):
        obj.addProperty("App::PropertyLength", "Clearance")
        obj.Clearance = obj.OldHolder

    monkeypatch.setitem(schema.STEPS, 0, renamed)
    path.Proxy.onDocumentRestored(path)
    assert path.Clearance.Value == 33 and path.OldHolder.Value == 33 and path.SchemaVersion == schema.SCHEMA


def test_an_object_of_a_later_version_is_kept_as_it_is(doc, reopen):
    path = toolpath.make(doc, None, {"machine": "trunnion_ac"}, {})
    path.addProperty("App::PropertyString", "Unheard", "Later", "")
    path.Unheard, path.SchemaVersion = "of", 99
    again = reopen(doc).Toolpath
    assert again.SchemaVersion == 99 and again.Unheard == "of"


def test_the_proxies_are_found_under_their_names_and_save_nothing(doc, ball, reopen, tmp_path):
    path = app.create_toolpath(doc, ball, **FAST)
    marks = app.annotate(path)
    (tmp_path / "a.ngc").write_text("G21 G90 G94\nG1 X0 Y0 Z10 A0 C0 F100\nX10 A1\n")
    judged = app.audit(doc, tmp_path / "a.ngc", "trunnion_ac")
    paths = [
        f"{type(one.Proxy).__module__}.{type(one.Proxy).__name__}" for one in (path.Mesh, path, marks, judged)
    ]
    start = "freecad_fiveaxis.app."
    assert paths == [
        start + name
        for name in ("tessellation.Tessellation", "toolpath.Toolpath", "markers.Markers", "auditing.Audit")
    ]
    assert all(
        one.Proxy.dumps() is None and one.Proxy.__getstate__() is None
        for one in (path.Mesh, path, marks, judged)
    )
    kind = type(judged.Proxy)
    again = reopen(doc).Audit
    assert type(again.Proxy) is kind and again.Blocks == 2


def test_adding_what_is_there_changes_nothing(doc):
    path = toolpath.make(doc, None, {"machine": "trunnion_ac", "lead": 4}, {})
    doc.recompute()
    path.purgeTouched()
    properties.add_missing(path, path.Proxy.properties())
    assert "Touched" not in path.State and path.Lead.Value == 4


def test_what_was_saved_uncured_stays_uncured_whatever_the_defaults_have_become(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST, **UNCURED)
    path = reopen(doc).Toolpath
    assert (path.Linearize, path.Gouge) == ("off", "off") and results.out_of_date(path) == ""
    task = path.Proxy.task(path)
    assert (task.settings.cure.linearize, task.settings.gouge.gouge) == ("off", "off")


def test_what_had_no_cure_at_all_gets_none(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST, **UNCURED)
    blocks, path.SchemaVersion = path.Blocks, 3
    for name in ("Gouge", "Linearize", "Light"):
        assert path.removeProperty(name)
    path = reopen(doc).Toolpath
    assert (path.Linearize, path.Gouge, path.Light) == ("off", "off", "")
    path.touch()
    path.Document.recompute()
    assert path.Blocks == blocks and path.Light == "red"


def test_a_version_below_the_first_is_taken_for_it(doc, reopen):
    path = toolpath.make(doc, None, {"machine": "trunnion_ac"}, {})
    path.removeProperty("Clearance")
    path.SchemaVersion = -5
    again = reopen(doc).Toolpath
    assert again.SchemaVersion == schema.SCHEMA and "Clearance" in again.PropertiesList


def test_a_path_of_version_4_goes_over_the_part_as_it_did(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST)
    assert path.Links == "near"
    assert path.removeProperty("Links")
    path.SchemaVersion = 4
    path = reopen(doc).Toolpath
    assert (path.SchemaVersion, path.Links) == (schema.SCHEMA, "over")


def test_a_path_of_before_the_strategies_keeps_planes_on_the_normals(doc, ball, reopen):
    path = app.create_toolpath(
        doc, ball, machine="trunnion_ac", stepover=4, linear_deflection=0.1, direction=0
    )
    nc = results.nc_of(path)
    assert (path.PassStrategy, path.ToolAxis) == ("planes", "facet_mean")
    assert path.removeProperty("PassStrategy")
    path.SchemaVersion = 4
    path = reopen(doc).Toolpath
    assert (path.SchemaVersion, path.PassStrategy, path.ToolAxis) == (schema.SCHEMA, "planes", "facet_mean")
    path.touch()
    path.Document.recompute()
    assert results.nc_of(path) == nc


def test_a_new_path_says_what_is_cut_with_what_is_not_named(doc, ball, tmp_path):
    given = {"machine": "trunnion_ac", "stepover": 6, "linear_deflection": 0.3}
    path = app.create_toolpath(doc, ball, **given)
    assert (path.PassStrategy, path.ToolAxis) == ("scallop", "auto")
    changed = changes.change_toolpath(path, {**given, "passes": "zlevel"})
    assert (changed.PassStrategy, changed.ToolAxis) == ("zlevel", "facet_mean")
    known, file = load_machine("trunnion_ac"), tmp_path / "three.fcm"
    axes = tuple(axis for axis in known.axes if axis.letter in "XYZ")
    save_machine(Machine("three", axes, safe_start=SafeStart("none")), file)
    upright = app.create_toolpath(doc, ball, **given | {"machine": str(file)})
    assert (upright.PassStrategy, upright.ToolAxis) == ("scallop", "fixed")


def test_a_path_of_before_lead_ins_has_none_and_keeps_its_program(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST)
    nc = results.nc_of(path)
    assert path.getTypeIdOfProperty("LeadIn") == "App::PropertyLength" and path.removeProperty("LeadIn")
    path = reopen(doc).Toolpath
    assert path.LeadIn.Value == 0.0
    path.touch()
    path.Document.recompute()
    assert results.nc_of(path) == nc
    path.LeadIn = "3 mm"
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and results.nc_of(path) != nc


def test_a_path_of_before_spirals_has_none_and_keeps_its_program(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST | {"passes": "zlevel", "stepover": 1})
    nc = results.nc_of(path)
    assert path.Spiral == "off" and path.removeProperty("Spiral")
    path = reopen(doc).Toolpath
    assert path.Spiral == "off"
    path.touch()
    path.Document.recompute()
    assert results.nc_of(path) == nc
    path.Spiral = "on"
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and results.nc_of(path) != nc


def test_a_path_of_before_steep_and_shallow_has_one_strategy_and_keeps_its_program(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **FAST)
    nc = results.nc_of(path)
    assert path.SteepShallow == 0 and path.removeProperty("SteepShallow")
    path = reopen(doc).Toolpath
    assert path.SteepShallow == 0
    path.touch()
    path.Document.recompute()
    assert results.nc_of(path) == nc
    path.SteepShallow = 20
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and results.nc_of(path) != nc
