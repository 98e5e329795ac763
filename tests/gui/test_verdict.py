# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict on the screen: its colour and words, and what OK and Post-process ask before an unsafe path is
kept or written."""

from types import SimpleNamespace

import FreeCADGui
import pytest
from conftest import picture

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.gui import findings_panel, verdict_label
from freecad_fiveaxis.gui.panels import audit, post, summary, toolpath, written
from freecad_fiveaxis.gui.panels import setup as setup_panel
from freecad_fiveaxis.gui.panels.panel_widget import PanelWidget
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

COARSE = {
    "passes": "planes",
    "cutter": "ball:6:30",
    "stepover": 4.0,
    "linear_deflection": 0.3,
    "angular_deflection": 30.0,
}
UNSAFE = {"linearize": "off", "gouge": "off"}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def dome(doc):
    """The upper half of a ball, 20 mm, standing on the ground."""
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    doc.clearUndos()
    return part


@pytest.fixture
def panel(dome, pump):
    """panel(options): the panel of a new path with these options."""

    def opened(**options):
        result = toolpath.create(dome)
        result.options.show_options({**COARSE, **options})
        pump(300)
        return result

    return opened


@pytest.fixture(autouse=True)
def nothing_written_is_left_open():
    yield
    for dialog in written._dialogs.values():
        dialog.close()


def shown(name):
    return FreeCADGui.getMainWindow().findChild(QtWidgets.QWidget, name)


def coloured(file, light):
    """How many pixels of a screenshot have the colour of a light."""
    colour = verdict_label.COLOURS[light].lstrip("#")
    wanted = [int(colour[k : k + 2], 16) for k in (0, 2, 4)]
    return int((abs(picture(file).astype(int) - wanted).max(axis=2) < 6).sum())


def test_the_summary_shows_the_light_in_its_colour_until_the_settings_change(panel, pump, screenshot, until):
    opened = panel(**UNSAFE)
    assert not shown("verdict").isVisible()
    assert opened.calculate()
    label = shown("verdict")
    until(label.isVisible, 20000, "the verdict")
    assert label.text().startswith("NOT SAFE: ") and label.text() == opened.obj.Verdict
    until(lambda: coloured(screenshot("verdict_red"), "red") > 2000, 30000, "the verdict in red")
    assert coloured(screenshot("verdict_red"), "amber") == 0
    opened.options.show_options({"linearize": "on", "gouge": "lift"})
    opened._on_edit()
    until(lambda: not label.isVisible(), 20000, "no verdict of other settings")
    assert opened.calculate()
    until(lambda: label.text() == opened.obj.Verdict, 20000, "the new verdict")
    assert not label.text().startswith("NOT SAFE")
    until(
        lambda: coloured(screenshot("verdict_cured"), opened.obj.Light) > 2000,
        30000,
        "the verdict in its colour",
    )


@pytest.mark.parametrize("width", [300, 420])
def test_the_verdict_is_whole_in_a_panel_of_any_height_and_the_rest_scrolls(width, until):
    """As whole as where nothing else stands about it."""
    box, lone = summary.Summary(), verdict_label.VerdictLabel("lone")
    reported = SimpleNamespace(
        Light="red", Verdict="NOT SAFE: " + 8 * "the tip leaves its line in block 1234; "
    )
    panel = PanelWidget("Panel", (QtWidgets.QPushButton("Calculate"), box), QtWidgets.QLabel("Form\n" * 40))
    panel.show()
    try:
        box.verdict.show_verdict(reported)
        box.tell("<br>".join(f"Line {line}" for line in range(30)))
        for height in (600, 300, 120):
            panel.resize(width, height)
            lone.show_verdict(reported)
            lone.setFixedWidth(box.verdict.width())
            lone.adjustSize()
            until(
                lambda: box.verdict.height() >= lone.heightForWidth(lone.width()) > 60,
                5000,
                "the whole verdict",
            )
            until(lambda: box.area.verticalScrollBar().maximum() > 0, 5000, "the rest scrolling")
    finally:
        panel.close()
        lone.close()


@pytest.mark.parametrize("answer", ["Go back", "Keep anyway"])
def test_ok_on_an_unsafe_path_asks(panel, doc, panel_button, modal, answer, until):
    panel(**UNSAFE)
    reported = modal(answer)
    panel_button("OK", wait=800)
    until(lambda: reported.texts, 20000, "a question")
    assert (
        len(reported.texts) == 1
        and reported.texts[0].startswith("NOT SAFE: ")
        and "Keep this path anyway?" in reported.texts[0]
    )
    until(
        lambda: bool(FreeCADGui.Control.activeDialog()) == (answer == "Go back"),
        20000,
        "the panel open only to go back",
    )
    assert doc.getObject("Toolpath") is not None and doc.Toolpath.Light == "red"
    if answer == "Go back":
        panel_button("Cancel")
        until(lambda: doc.getObject("Toolpath") is None, 20000, "Cancel to take everything back")


def test_enter_means_go_back(panel, doc, panel_button, modal, until):
    panel(**UNSAFE)

    def enter(dialog):
        assert dialog.defaultButton().text() == "Go back"
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier, "\r")
            QtWidgets.QApplication.postEvent(dialog.defaultButton(), event)

    reported = modal(enter)
    panel_button("OK", wait=800)
    until(lambda: reported.texts, 20000, "a question")
    assert FreeCADGui.Control.activeDialog()


def test_ok_on_a_path_that_is_safe_or_only_to_be_checked_asks_nothing(panel, doc, panel_button, panel_closed):
    panel()
    panel_button("OK", wait=800)
    panel_closed()
    assert doc.Toolpath.Light in ("amber", "green")


def test_an_audit_is_a_judgement_and_asks_nothing(doc, tmp_path, panel_button, pump, panel_closed):
    (tmp_path / "foreign.nc").write_text("G21 G90 G94\nG1 X0 Y0 Z0 A0 C0 F500\nG1 X10 Y0 Z0 A5 C60\nM2\n")
    opened = audit.create(doc)
    opened.file.show_value(str(tmp_path / "foreign.nc"))
    opened.options.show_options({"machine": "mikron_ucp710", "tolerance": 0.02})
    pump(200)
    assert opened.calculate() and shown("verdict").text().startswith("NOT SAFE: ")
    panel_button("OK", wait=800)
    panel_closed()
    assert doc.Audit.Light == "red"


def test_the_choice_of_linearize_is_not_requested_where_the_controller_guides_the_tip(panel):
    opened = panel(controller="heidenhain")
    assert opened.options.options()["linearize"] == "on"
    opened.options.show_options({"rtcp": "angles"})
    assert "linearize" not in opened.options.options() and opened.options.check()
    assert not opened.options.fields["linearize"].editor.isVisible()


@pytest.fixture
def path(doc, dome):
    """path(options): a computed path."""
    return lambda **options: app.create_toolpath(doc, dome, machine="trunnion_ac", **{**COARSE, **options})


@pytest.mark.parametrize("answer", ["Cancel", "Write anyway"])
def test_post_names_the_errors_first_and_writes_only_when_confirmed(
    path, tmp_path, panel_button, modal, screenshot, pump, answer, until
):
    unsafe, file = path(**UNSAFE, linear_deflection=0.1, angular_deflection=15), tmp_path / "part.ngc"
    post.write(unsafe).file.show_value(str(file))
    pump(300)
    until(
        lambda: shown("post_verdict").text() == unsafe.Verdict and shown("post_verdict").isVisible(),
        20000,
        "the verdict",
    )
    listed = shown("post_findings").text()
    assert listed.index("Error:") < listed.index("Warning:")

    def look(dialog):
        screenshot("post_unsafe")
        assert dialog.defaultButton().text().replace("&", "") == "Cancel"
        next(one for one in dialog.buttons() if one.text().replace("&", "") == answer).click()

    reported = modal(look)
    panel_button("OK", wait=800)
    until(lambda: reported.texts, 20000, "a question")
    assert reported.texts[0].startswith("NOT SAFE: ") and reported.texts[0].index("Errors") < reported.texts[
        0
    ].index("Warnings")
    until(
        lambda: bool(FreeCADGui.Control.activeDialog()) == (answer == "Cancel"),
        20000,
        "the panel open only after Cancel",
    )
    assert file.exists() == (answer == "Write anyway")


def test_after_writing_the_file_its_lines_and_its_time_are_reported_and_opened(path, tmp_path, panel_button, pump, click, screenshot,
                                                                          monkeypatch, until, panel_closed):  # fmt: skip
    result, file = path(spindle=8000), tmp_path / "part.ngc"
    post.write(result).file.show_value(str(file))
    pump(300)
    assert not [
        one
        for one in FreeCADGui.getMainWindow().findChildren(QtWidgets.QWidget, "spindle")
        if one.isVisible()
    ]
    panel_button("OK", wait=800)
    panel_closed()  # nothing waits for the window that tells
    until(
        lambda: shown("FiveAxisWritten") and shown("FiveAxisWritten").isVisible(),
        20000,
        "the window that tells",
    )
    text = shown("FiveAxisWrittenText").text()
    lines = len(file.read_bytes().splitlines())
    assert str(file) in text and f"{lines} lines" in text
    assert summary.clock(results.figures_of(result).program.seconds.sum()) in text
    screenshot("post_written")
    opened = []
    monkeypatch.setattr(written, "open_url", lambda url: opened.append(url.toLocalFile()))
    click(shown("FiveAxisWrittenOpen"))
    click(shown("FiveAxisWrittenFolder"))
    until(lambda: opened == [str(file), str(tmp_path)], 20000, "file and folder opened")
    click(shown("FiveAxisWrittenClose"))
    until(lambda: not shown("FiveAxisWritten").isVisible(), 20000, "the window closed")


def test_a_spindle_speed_that_is_missing_is_requested_in_place(
    path, doc, tmp_path, panel_button, pump, type_into, field, panel_closed
):
    result, file = path(), tmp_path / "part.ngc"
    assert b"S9000" not in results.nc_of(result)
    post.write(result).file.show_value(str(file))
    pump(300)
    type_into(field("spindle"), "9000")
    panel_button("OK", wait=800)
    panel_closed()
    assert result.Spindle == 9000 and b"S9000" in file.read_bytes() and results.out_of_date(result) == ""


@pytest.mark.parametrize("answer", ["Cancel", "Write anyway"])
def test_a_program_that_leaves_the_spindle_off_is_written_only_when_confirmed(
    path, tmp_path, panel_button, modal, pump, answer, until
):
    result, file = path(), tmp_path / "part.ngc"
    post.write(result).file.show_value(str(file))
    pump(300)
    reported = modal(
        lambda dialog: next(one for one in dialog.buttons() if one.text().replace("&", "") == answer).click()
    )
    panel_button("OK", wait=800)
    until(lambda: reported.texts, 20000, "a question")
    assert "No spindle speed is given" in reported.texts[0] and "NOT SAFE" not in reported.texts[0]
    until(
        lambda: bool(FreeCADGui.Control.activeDialog()) == (answer == "Cancel"),
        20000,
        "the panel open only after Cancel",
    )
    assert file.exists() == (answer == "Write anyway")


def test_the_list_of_findings_begins_with_the_verdict(path, pump, until):
    result = path(**UNSAFE)
    opened = findings_panel.show(result)
    until(
        lambda: opened.verdict.isVisible() and opened.verdict.text() == result.Verdict, 20000, "the verdict"
    )
    opened.clear()
    until(lambda: not opened.verdict.isVisible(), 20000, "no verdict")


@pytest.fixture
def low_screen(window, pump):
    """The window as large as the screen of a small notebook, without the consoles that FreeCAD hides at
    first."""
    from conftest import SMALL

    docks = [
        dock
        for dock in window.findChildren(QtWidgets.QDockWidget)
        if dock.objectName() in ("Python console", "Report view")
    ]
    shown = [dock for dock in docks if dock.isVisible()]
    for dock in shown:
        dock.hide()
    window.setGeometry(0, 0, 1366, 768)
    pump(300)
    yield
    for dock in shown:
        dock.show()
    window.setGeometry(*SMALL)
    pump(200)


def is_whole(label):
    """Whether all of a label is in sight, and all of its text in it."""
    seen = label.visibleRegion().boundingRect()
    return (
        label.isVisible()
        and seen == label.rect()
        and label.height() >= label.heightForWidth(label.width()) > 0
    )


def bar_at_the_end(area):
    """Scroll to the end, whether there is more than what is seen."""
    bar = area.verticalScrollBar()
    bar.setValue(bar.maximum())
    return bar.maximum() > 0


@pytest.mark.usefixtures("low_screen")
@pytest.mark.parametrize("kind", ["toolpath", "audit", "setup"])
def test_on_a_screen_of_1366_by_768_the_verdict_is_whole_and_the_rest_scrolls(
    kind, dome, doc, tmp_path, until, screenshot, unfold
):
    if kind == "toolpath":
        opened = toolpath.create(dome)
        opened.options.show_options({**COARSE, **UNSAFE})
    else:
        path = app.create_toolpath(doc, dome, machine="trunnion_ac", spindle=8000, **COARSE, **UNSAFE)
        app.post_process(path, tmp_path / "dome.ngc")
        opened = audit.create(doc) if kind == "audit" else setup_panel.create(path)
        opened.options.show_options({} if kind == "audit" else {"region": (20, 20, 20), "grid": (2, 2, 2)})
    assert opened.calculate()
    label = opened.summary.verdict
    until(lambda: is_whole(label), 20000, "the whole verdict")
    screenshot(f"verdict_1366x768_{kind}")
    unfold()
    area = opened.form.findChild(QtWidgets.QScrollArea, "form_area")
    until(lambda: bar_at_the_end(area), 20000, "the rest scrolling")
    until(lambda: is_whole(label), 20000, "the verdict whole beside it")
    screenshot(f"verdict_1366x768_{kind}_end")
