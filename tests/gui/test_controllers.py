# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controllers in the panels: all of them by their names, what one lacks idle with the reason, guided output
not called proven."""

import dataclasses

import pytest
from conftest import QtCore, QtWidgets
from test_clicks import look
from test_workshop import cut, panel_form

from freecad_fiveaxis import app
from freecad_fiveaxis.app import labels, properties, results
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.pipeline.settings import AUDIT, option
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import write_apt
from freecad_fiveaxis.gui.panels import audit, import_machine, prove_signs, recover, toolpath

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture(autouse=True)
def _preferences(parameters, tmp_path):
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetString("OutputFolder", str(tmp_path))
    group.SetString("MachineFolder", str(tmp_path / "machines"))
    group.SetFloat("Scallop", 0.5)


@pytest.fixture
def dome(doc):
    """A half ball of 20 mm."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


def items(combo):
    model = combo.model()
    return {
        combo.itemData(at): bool(model.index(at, 0).flags() & QtCore.Qt.ItemIsEnabled)
        for at in range(combo.count())
    }


def test_every_controller_is_offered_by_a_name_of_its_own(dome, press, tree_row, field, panel_button):
    tree_row("Dome")
    press("FiveAxis_Toolpath")
    combo = field("controller")
    names = [combo.itemText(at) for at in range(1, combo.count())]
    assert [combo.itemData(at) for at in range(1, combo.count())] == list(DIALECTS)
    assert len(set(names)) == len(DIALECTS) and not set(names) & set(DIALECTS), "names, not keys"
    panel_button("Cancel")


def test_what_a_controller_lacks_is_idle_with_the_reason(dome, press, tree_row, field, choose, type_into, click, panel_button, pump,
                                                         screenshot, until):  # fmt: skip
    tree_row("Dome")
    press("FiveAxis_Toolpath")
    choose(field("controller"), "Siemens 840D")
    choose(field("rtcp"), "by tool vectors")
    choose(field("high_speed"), "on")
    until(
        lambda: all(items(field("rtcp")).values()) and field("feed_mode").isEnabled(),
        10000,
        "all that Siemens has",
    )
    choose(field("controller"), "grbl with five axes")
    for name in ("rtcp", "high_speed"):
        until(
            lambda name=name: not field(name).isEnabled() and field(name).currentData() == "off",
            10000,
            f"{name} idle",
        )
    until(
        lambda: "grbl with five axes does not guide the tip" in field("rtcp_note").text(), 10000, "the reason"
    )
    screenshot("controller-lacks")
    choose(field("controller"), "Heidenhain TNC (TCPM)")
    for name, wished in (("rtcp", "vectors"), ("high_speed", "on")):
        until(lambda: field(name).currentData() == wished, 10000, f"{name} as it was wished")  # noqa: B023
    until(lambda: not field("feed_mode").isEnabled(), 10000, "the mode of feeds idle")
    until(lambda: "no inverse time" in field("feed_mode_note").text(), 10000, "the reason")
    choose(field("nc_units"), "mm")
    until(lambda: not items(field("nc_units"))["inch"], 10000, "no choice of inches")
    choose(field("controller"), "Haas")
    until(lambda: items(field("nc_units"))["inch"], 10000, "inches to choose")
    choose(field("nc_units"), "inch")
    choose(field("controller"), "Heidenhain TNC (TCPM)")
    until(lambda: "are in mm" in field("nc_units_error").text(), 10000, "the reason")
    choose(field("controller"), "Haas")
    until(
        lambda: items(field("rtcp")) == {"off": True, "angles": True, "vectors": False},
        10000,
        "no choice of vectors",
    )
    until(lambda: "no RTCP by vectors" in field("rtcp_error").text(), 10000, "the reason")
    choose(field("rtcp"), "by rotary axes")
    until(lambda: "the number of the tool" in field("rtcp_error").text(), 10000, "what is missing")
    click(field("calculate"))
    pump(300)
    assert "Press Calculate" in field("summary").text() and [obj.Name for obj in dome.Document.Objects] == [
        "Dome"
    ]
    panel_button("Cancel")


@pytest.mark.short
def test_guided_output_is_not_called_proven_and_its_file_is_read_again(dome, doc, press, tree_row, field, choose, type_into, click,
                                                                       until, panel_button, screenshot, pump, tmp_path,
                                                                       panel_closed):  # fmt: skip
    tree_row("Dome")
    press("FiveAxis_Toolpath")
    choose(field("controller"), "Heidenhain TNC (TCPM)")
    choose(field("rtcp"), "by rotary axes")
    choose(field("passes"), "parallel planes")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    text = field("summary").text()
    assert "verified at their end points only" in text and "is under RTCP" in field("verdict").text()
    assert "Proven bound" not in text and "Largest deviation" not in text, "zeros that nobody has measured"
    pump(800)
    screenshot("rtcp-summary")
    panel_button("OK", 500)
    panel_closed()
    path = doc.Toolpath
    assert path.Rtcp == "angles" and path.GuidedBlocks > 0 and not path.Proven
    tree_row(path.Label)
    press("FiveAxis_PostProcess")
    until(lambda: field("nc_path").text() == str(tmp_path / "Toolpath.h"), 20000, "the file's name")
    type_into(field("spindle"), "9000")
    panel_button("OK", 800)
    panel_closed()
    nc = (tmp_path / "Toolpath.h").read_bytes()
    assert nc == results.nc_of(path) and b"FUNCTION TCPM" in nc
    press("FiveAxis_Audit")
    until(
        lambda: field("nc_file").text() == str(tmp_path / "Toolpath.h"),
        20000,
        "the audit's panel, and the file proposed",
    )
    choose(field("controller"), "by the text itself")
    click(field("calculate"))
    until(
        lambda: "verified at their end points only" in field("summary").text(),
        60000,
        "a summary of the audit",
    )
    pump(300)
    screenshot("rtcp-audit")
    panel_button("OK", 500)
    panel_closed()
    assert doc.Audit.GuidedBlocks == path.GuidedBlocks


def shown_of(*names):
    return {
        name
        for name in names
        for one in panel_form().findChildren(QtWidgets.QWidget, name)
        if one.isVisibleTo(panel_form())
    }


def test_an_audit_is_compared_with_a_cl_path_or_a_part(dome, doc, press, field, choose, type_into, click, until, panel_button,
                                                       screenshot, tmp_path, pump, panel_closed):  # fmt: skip
    path = app.create_toolpath(
        doc, dome, passes="planes", machine="trunnion_ac", stepover=4, linearize="on", tolerance=0.01, lead=20
    )
    files = {name: str(tmp_path / name) for name in ("a.ngc", "a.apt", "a.stl")}
    app.post_process(path, files["a.ngc"])
    app.tessellate(dome, files["a.stl"])
    found = results.result_of(path)
    (tmp_path / "a.apt").write_bytes(write_apt(found.draft.path, Cutter(10.0), "dome"))
    press("FiveAxis_Audit")
    type_into(field("nc_file"), files["a.ngc"])
    choose(field("machine"), "trunnion_ac")
    choose(field("part"), "none, or a file")
    until(lambda: shown_of("axis_tolerance", "cutter_diameter") == set(), 10000, "neither field")
    type_into(field("against"), files["a.apt"])
    until(
        lambda: shown_of("axis_tolerance", "cutter_diameter") == {"axis_tolerance"},
        10000,
        "the field of a CL path",
    )
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    assert "CL path" not in field("summary").text()
    pump(500)
    type_into(field("against"), files["a.stl"])
    until(
        lambda: shown_of("axis_tolerance", "cutter_diameter") == {"cutter_diameter"},
        10000,
        "the field of a part",
    )
    type_into(field("cutter_diameter"), "14 mm")  # the tip stands as before: 2 mm (1 - cos 20 deg) too deep
    click(field("calculate"))
    # the summary names the first error: the tip of a ball, by which audits are judged, leaves its line where
    # the centre is led straight
    until(lambda: "enters the part" in field("verdict").text(), 60000, "that the larger ball enters the part")
    pump(300)
    screenshot("audit-against")
    panel_button("OK", 500)
    panel_closed()
    assert doc.Audit.Against == files["a.stl"] and any(
        "too deep into the part" in text for text in doc.Audit.Findings
    )


def test_a_path_with_a_wish_that_its_controller_lacks_opens_and_is_mended(dome, doc, pump):
    path = app.create_toolpath(
        doc, dome, passes="planes", machine="trunnion_ac", stepover=8, controller="linuxcnc", rtcp="angles"
    )
    path.Controller = "grbl"
    panel = toolpath.edit(path)
    pump(200)
    assert panel.options.fields["rtcp"].value() == "off" and panel.stale
    assert panel.calculate() and path.Rtcp == "off" and path.GuidedBlocks == 0
    panel.accept()
    panel = toolpath.edit(path)
    assert not panel.stale
    panel.reject()


def test_play_claims_nothing_of_guided_blocks(dome, doc, press, tree_row, window, pump, screenshot, until):
    path = app.create_toolpath(
        doc, dome, passes="planes", machine="trunnion_ac", stepover=8, controller="siemens840d", rtcp="angles"
    )
    tree_row(path.Label)
    press("FiveAxis_Play", 800)
    panel = until(lambda: window.findChild(QtWidgets.QWidget, "FiveAxisPlay"), 20000, "the player")
    message = {name: panel.findChild(QtWidgets.QLabel, name) for name in ("gap", "most", "bound", "note")}
    steps = [one for one in panel.findChildren(QtWidgets.QAbstractButton) if one.objectName() == "forward"]
    assert steps, [one.objectName() for one in panel.findChildren(QtWidgets.QAbstractButton)]
    for _ in range(5):
        steps[0].click()
        pump(100)
    until(
        lambda: [message[name].text() for name in ("gap", "most", "bound")] == ["–", "–", "–"],
        20000,
        "no numbers",
    )
    until(lambda: "guides the tip" in message["note"].text(), 20000, "why there are none")
    screenshot("play-guided")


@dataclasses.dataclass(frozen=True)
class SurfaceSettings:
    """What the program is held against."""

    surface: str | None = option(None, "path", "a CL file or STL that the program should follow", (AUDIT,))
    sideways: float = option(0.5, "length", "farthest that counts as the same pass", (AUDIT,), above=0)


@pytest.fixture
def more_settings(monkeypatch):
    """The core's settings with a group more."""
    known = properties.option_fields

    def fields(task=None):
        yield from known(task)
        yield from (
            (SurfaceSettings, leaf) for leaf in dataclasses.fields(SurfaceSettings) if task in (None, AUDIT)
        )

    monkeypatch.setattr(properties, "option_fields", fields)
    properties.setting_properties.cache_clear()
    yield
    properties.setting_properties.cache_clear()


def test_a_new_group_of_settings_gets_its_section_its_fields_and_its_properties(
    doc, more_settings, field, click, pump, tmp_path, until
):
    audit.create(doc)
    pump(300)
    box = until(
        lambda: panel_form() and panel_form().findChild(QtWidgets.QWidget, "section_surface"),
        20000,
        "a section",
    )
    assert box.title == "Surface"
    until(
        lambda: field("surface_browse").isVisible() and field("sideways").read_measure() == 0.5,
        20000,
        "its fields",
    )
    field("surface").setText(str(tmp_path / "gone.stl"))
    until(lambda: "does not exist" in field("surface_error").text(), 20000, "what is wrong")
    kinds = {one.name: one.kind for one in properties.setting_properties(AUDIT)}
    assert kinds["Surface"] == "App::PropertyFile" and kinds["Sideways"] == "App::PropertyLength"


def test_without_it_the_panel_has_no_such_section(doc, pump):
    audit.create(doc)
    pump(200)
    assert panel_form().findChild(QtWidgets.QWidget, "section_surface") is None


@pytest.mark.parametrize("name", ["toolpath", "audit", "recover", "prove_signs", "import_machine"])
def test_no_german_text_is_cut(name, dome, doc, german, window, pump, screenshot, until):
    opened = {
        "toolpath": lambda: toolpath.create(dome), "audit": lambda: audit.create(doc), "recover": recover.create,
        "prove_signs": prove_signs.create, "import_machine": import_machine.create,
    }[name]()  # fmt: skip
    pump(800)
    if name in ("toolpath", "prove_signs"):
        opened.options.fields["controller"].show_value("grbl")
    pump(500)
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("german-" + name)
    if name == "prove_signs":
        assert opened.calculate()
        pump(500)
        screenshot("german-prove_signs-sheet")
        until(lambda: not cut(panel_form()), 20000, "no text that is cut")
        assert "Sie sehen:" in opened.result.toPlainText()
    opened.reject()


def test_every_label_of_a_controller_belongs_to_one():
    assert set(labels._controllers()) == set(DIALECTS)
