# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forms of the panels: groups that fold and say their state, narrow, found by keys and by screen
readers."""

import FreeCADGui
import pytest
from conftest import QtCore, QtWidgets
from test_workshop import cut

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.gui.panels import audit, import_machine, prove_signs, recover, setup, toolpath
from freecad_fiveaxis.gui.panels.panel_widget import LOW

NARROW = 330
"""Pixels of FreeCAD 1.1's task panel over the view."""
PANELS = ["toolpath", "audit", "recover", "prove_signs", "import_machine", "setup"]
NOVICE = {"machine", "tool", "passes"}
OPTIONS = {"cutter": "ball:6:30", "stepover": 4.0, "linear_deflection": 0.3, "angular_deflection": 30.0}


@pytest.fixture(autouse=True)
def _fresh(parameters):
    """Nobody has folded anything yet."""
    parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis").Clear()


@pytest.fixture
def open_panel(dome, doc, pump):
    """open_panel(name): the panel of that module, opened over the dome."""

    def opened(name):
        result = {
            "toolpath": lambda: toolpath.create(dome), "audit": lambda: audit.create(doc), "recover": recover.create,
            "prove_signs": prove_signs.create, "import_machine": import_machine.create, "setup": lambda: setup.create_over(dome),
        }[name]()  # fmt: skip
        pump(400)
        return result

    return opened


@pytest.fixture
def panel(open_panel, pump):
    """The panel of a new, coarse path over the dome."""
    opened = open_panel("toolpath")
    opened.options.show_options(OPTIONS)
    pump(400)
    return opened


@pytest.fixture(params=["English", "German"])
def language(request, window):
    """The window in one language after the other."""
    FreeCADGui.setLocale(request.param)
    yield request.param
    FreeCADGui.setLocale("English")


@pytest.mark.parametrize("name", PANELS)
def test_nothing_is_cut_where_the_panel_is_narrow(name, language, open_panel, pump, screenshot, until):
    panel = open_panel(name)
    fields = panel.options.fields
    for choice, value in (
        ("machine", "fork_head_bc"),
        ("controller", "heidenhain_m128"),
        ("tool_axis", "minimax"),
    ):
        if choice in fields:
            fields[choice].show_value(value)
    for group in panel.options.groups.values():
        group.unfold()
    pump(300)
    until(lambda: panel.form.minimumSizeHint().width() <= NARROW, 20000, "a form as narrow as the panel")
    screenshot(f"narrow_{name}_{language}")
    panel.reject()
    pump(100)


def test_at_its_narrowest_every_text_of_a_form_is_to_be_read(doc, dome, language, pump, until):
    from freecad_fiveaxis.app import changes

    panel = toolpath.ToolpathPanel(doc, dome)
    panel.fill(changes.default_options("mill") | toolpath.read_preferred())
    for group in panel.options.groups.values():
        group.unfold()
    panel.form.resize(NARROW - 30, 900)  # what FreeCAD 1.1's panel leaves of its width
    panel.form.show()
    try:
        until(
            lambda: panel.form.width() == NARROW - 30 and cut(panel.form) == [], 20000, "no text that is cut"
        )
    finally:
        panel.form.hide()
    wide = [
        one.field.name for group in panel.options.groups.values() for one in group.body.rows if not one.above
    ]
    assert "tolerance" in wide, "short labels stand beside their editors"


def groups(panel):
    return {name for name, group in panel.options.groups.items() if group.is_open()}


def test_a_novices_groups_are_open_and_the_panel_comes_again_as_it_was_left(
    panel, open_panel, click, pump, until
):
    assert list(panel.options.groups) == [
        "part",
        "machine",
        "tool",
        "passes",
        "axis",
        "safety",
        "output",
        "more",
    ]
    assert groups(panel) == NOVICE
    click(panel.options.groups["passes"].header)
    click(panel.options.groups["axis"].header)
    lead, direction = (panel.options.fields[name].editor for name in ("lead", "direction"))
    until(lambda: lead.isVisible() and not direction.isVisible(), 20000, "one group opened, one folded")
    panel.reject()
    pump(100)
    again = open_panel("toolpath")
    assert groups(again) == {"machine", "tool", "axis"}


def test_the_keyboard_goes_from_header_to_field_and_folds(panel, key, pump, until):
    group = panel.options.groups["machine"]
    assert group.header.focusPolicy() & QtCore.Qt.TabFocus
    following, seen = group.header.nextInFocusChain(), []
    while following is not panel.options.groups["tool"].header:
        seen.append(following)
        following = following.nextInFocusChain()
    assert (
        panel.options.fields["machine"].editor in seen and panel.options.fields["controller"].editor in seen
    )
    key(group.header, QtCore.Qt.Key_Space, " ")
    until(
        lambda: not group.is_open() and not panel.options.fields["machine"].editor.isVisible(),
        20000,
        "the group folded",
    )
    key(group.header, QtCore.Qt.Key_Space, " ")
    until(group.is_open, 20000, "the group open")


def test_titles_say_what_their_groups_hold(panel, field, choose, type_into, pump, until):
    reported = {name: group.header.toolTip() for name, group in panel.options.groups.items()}
    assert reported["machine"] == "Machine — trunnion_ac, LinuxCNC"
    assert reported["part"].startswith("Part — Dome, ")
    type_into(field("spindle"), "8000")
    type_into(field("feed"), "1500")
    header = panel.options.groups["tool"].header
    assert header.toolTip().startswith("Tool — ball")
    until(
        lambda: header.toolTip().endswith("6 mm, S 8000, F 1500 mm/min"),
        20000,
        "spindle and feed in the title",
    )
    choose(field("controller"), "Siemens 840D")
    header = panel.options.groups["machine"].header
    until(
        lambda: header.toolTip() == "Machine — trunnion_ac, Siemens 840D",
        20000,
        "the controller in the title",
    )
    assert panel.options.groups["machine"].header.accessibleDescription() == "trunnion_ac, Siemens 840D"
    widest = max(
        group.header.fontMetrics().boundingRect(group.header.text()).width()
        for group in panel.options.groups.values()
    )
    assert widest <= panel.form.width()


def test_an_error_in_a_folded_group_opens_it(panel, pump, until):
    assert not panel.options.groups["safety"].is_open()
    panel.options.fields["tolerance"].show_value(0.0)
    panel.options.fields["tolerance"].edited.emit()
    until(panel.options.groups["safety"].is_open, 20000, "the group opened")
    until(panel.options.fields["tolerance"].error.isVisible, 20000, "what is wrong")


def test_every_field_has_a_name_and_every_label_leads_to_its_field(panel, unfold, pump):
    unfold()
    editors = [field.editor for field in panel.options.fields.values()]
    assert all(editor.accessibleName() for editor in editors)
    cutter, spacing = panel.options.fields["cutter"], panel.options.fields["spacing"]
    parts = [cutter.kind, *cutter.sizes.values(), spacing.kind, *spacing.lengths.values()]
    assert all(part.editor.accessibleName() == part.label for part in parts)
    rows = [
        row for group in panel.options.groups.values() for row in group.body.rows if row.label is not None
    ]
    assert all(
        row.label.buddy() is row.field.focus_widget() and row.label.text() == row.field.label for row in rows
    )
    assert panel.options.fields["work_zero"].focus_widget().accessibleName() == "Work zero X"
    names = [editor.accessibleName() for editor in editors]
    assert len(names) == len(set(names)), "each field is found by its name"


def test_the_spindle_is_requested_and_goes_into_the_program(
    panel, doc, field, type_into, panel_button, until, panel_closed
):
    spindle = panel.options.fields["spindle"]
    assert spindle.editor.text() == "not given" and spindle.warning.isVisible()
    assert spindle.warning.text() == "Spindle speed not given: the program will not start the spindle."
    assert "no spindle speed" in panel.options.groups["tool"].header.toolTip()
    type_into(field("spindle"), "8000")
    type_into(field("tool"), "7")
    until(lambda: not spindle.warning.isVisible(), 20000, "no warning")
    panel_button("OK")
    panel_closed()
    assert (doc.Toolpath.Spindle, doc.Toolpath.Tool) == (8000.0, 7) and b"S8000 M3" in results.nc_of(
        doc.Toolpath
    )


def test_a_spindle_speed_that_is_no_whole_number_comes_back(doc, dome, pump):
    path = app.create_toolpath(doc, dome, **OPTIONS, spindle=1234.5)
    opened = toolpath.edit(path)
    pump(200)
    assert opened.options.options()["spindle"] == 1234.5 and not opened.stale
    opened.reject()


def test_calculate_and_the_summary_stay_where_the_form_is_scrolled(panel, unfold, pump, screenshot, until):
    unfold()
    area = panel.form.findChild(QtWidgets.QScrollArea, "form_area")
    bar = area.verticalScrollBar()
    until(lambda: bar.maximum() > 0, 20000, "a scroll bar")
    bar.setValue(bar.maximum())
    last = panel.options.groups["more"].body
    until(lambda: not last.visibleRegion().isEmpty(), 20000, "the end of the form reached")
    screenshot("form_scrolled_down")
    for head in (panel.calculate_button, panel.summary):
        assert not head.visibleRegion().isEmpty() and head.visibleRegion().boundingRect().height() > 15
    assert area.height() >= LOW and panel.form.visibleRegion().boundingRect().height() == panel.form.height()


@pytest.mark.usefixtures("whole_screen")
def test_a_summary_too_long_for_the_screen_scrolls_and_none_of_it_is_cut(panel, pump, screenshot, until):
    area, label = panel.summary.area, panel.summary.text
    until(lambda: area.verticalScrollBar().maximum() == 0, 20000, "no scroll bar for two lines")
    low = area.height()
    panel.summary.tell("<p>Some words that are told of the path.</p>" * 60)
    form_area = panel.form.findChild(QtWidgets.QScrollArea, "form_area")
    until(lambda: area.verticalScrollBar().maximum() > 0, 20000, "a scroll bar for many lines")
    until(
        lambda: label.height() >= label.heightForWidth(label.width()) > area.height(),
        20000,
        "none of them cut",
    )
    screenshot("summary_long")
    assert form_area.height() >= LOW and panel.calculate_button.visibleRegion().boundingRect().height() > 15
    assert panel.form.visibleRegion().boundingRect().height() == panel.form.height(), (
        "the panel itself does not scroll"
    )
    panel.summary.tell("<p>Some words that are told of the path.</p>" * 3)
    until(lambda: area.verticalScrollBar().maximum() == 0, 20000, "no scroll bar for a few lines")
    until(lambda: low < area.height() < form_area.height(), 20000, "as much room as they need")
