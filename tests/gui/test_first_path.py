# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel shows before and after the first Calculate: no error that nobody has made, and a path that is
in sight."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtCore, QtGui, QtWidgets

from freecad_fiveaxis import app
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.gui.panels import audit, path_panel, post, recover, toolpath
from freecad_fiveaxis.gui.scene import on_screen

COARSE = {
    "passes": "planes",
    "cutter": "ball:6:30",
    "stepover": 6.0,
    "linear_deflection": 0.3,
    "angular_deflection": 30.0,
}


@pytest.fixture
def block(doc):
    part = doc.addObject("Part::Box", "Block")
    part.Length, part.Width, part.Height = 60, 35, 20
    doc.recompute()
    return part


def spot(view, place):
    """A place of the document in the view: 0 to 1 from left to right and from bottom to top where it is
    seen."""
    return [at / size for at, size in zip(view.getPointOnScreen(*place), view.getSize(), strict=True)]


def out_of_sight(view):
    return not -0.5 < spot(view, (0, 0, 20))[0] < 1.5


def turn_away(view, pump):
    """The view shows a place far off, and stays there: FreeCAD may fit it once more when it comes to that."""
    view.viewTop()
    still = 0
    for _ in range(100):
        pump(100)
        still = still + 1 if out_of_sight(view) else 0
        if still == 5:
            return
        if not still:
            camera = view.getCameraNode()
            camera.position.setValue(100.0 * max(camera.height.getValue(), 100.0), 0.0, 500.0)
    raise AssertionError(f"the view comes back: {spot(view, (0, 0, 20))}")


def calculated(part, pump, **values):
    panel = toolpath.create(part)
    panel.options.show_options(COARSE | values)
    pump(300)
    assert panel.calculate()
    pump(path_panel.DRAWN + 500)  # a view that is to be fitted is, and one that is not would have been
    return panel


def test_a_new_path_out_of_sight_is_brought_into_view_once(dome, pump, until, screenshot):
    view = FreeCADGui.ActiveDocument.ActiveView
    turn_away(view, pump)
    panel = calculated(dome, pump)
    for place in ((0, 0, 20), (20, 0, 0), (-20, 0, 0), (0, 20, 0), (0, -20, 0)):
        until(lambda: all(0.0 < at < 1.0 for at in spot(view, place)), 20000, f"{place} in sight")  # noqa: B023
    screenshot("first_path")
    turn_away(view, pump)
    panel.options.show_options({"stepover": 8.0})
    assert panel.calculate()
    pump(path_panel.DRAWN + 500)
    assert out_of_sight(view), "the user has turned away since"
    panel.reject()


def test_a_path_that_is_in_sight_leaves_the_view_alone(dome, pump):
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    pump(600)
    before = view.getCameraNode().position.getValue().getValue()
    panel = calculated(dome, pump)
    assert view.getCameraNode().position.getValue().getValue() == before
    panel.reject()


def test_the_path_over_a_hidden_part_is_brought_into_view(dome, pump, until):
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    pump(600)
    height = view.getCameraNode().height if hasattr(view.getCameraNode(), "height") else None
    if height is None:
        pytest.skip("a camera of perspective has no height")
    height.setValue(70.0)
    dome.ViewObject.Visibility = False
    panel = calculated(dome, pump)
    until(
        lambda: height.getValue() != 70.0 and all(0.0 < at < 1.0 for at in spot(view, (0, 0, 20))),
        20000,
        "the path in view",
    )
    panel.reject()


def test_the_audit_asks_for_its_file_before_it_complains(doc, pump, click, screenshot, until):
    panel = audit.create(doc)
    pump(300)
    assert (
        not panel.file.error.isVisible()
        and panel.file.error.text() == ""
        and panel.file.editor.placeholderText() == "Choose the NC file to audit."
    )
    screenshot("audit_opened")
    click(panel.calculate_button)
    until(panel.file.error.isVisible, 20000, "what is missing")
    assert panel.file.error.text() == "Choose the NC file to audit." and panel.obj is None
    panel.reject()


def test_recover_asks_for_its_files_before_it_complains(window, pump, click, until):
    panel = recover.create()
    pump(300)
    files = [one for one in panel.options.fields.values() if getattr(one, "missing", "")]
    assert len(files) > 1 and not any(one.error.text() for one in files)
    assert panel.options.error.text() == "" and panel.options.error.isHidden(), (
        "nobody has done anything wrong yet"
    )
    click(panel.calculate_button)
    until(lambda: panel.cl_file.error.text() == panel.cl_file.missing, 20000, "what is missing")
    panel.reject()


def test_the_box_of_the_nc_file_is_called_so_by_screen_readers(dome, pump):
    path = app.create_toolpath(dome.Document, dome, **COARSE)
    panel = post.write(path)
    pump(300)
    assert panel.file.editor.accessibleName() == "NC file"
    panel.reject()


def wheel(box):
    """A notch of the wheel over a box."""
    middle = QtCore.QPointF(box.rect().center())
    event = QtGui.QWheelEvent(
        middle, QtCore.QPointF(box.mapToGlobal(box.rect().center())), QtCore.QPoint(), QtCore.QPoint(0, -120),
        QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False,
    )  # fmt: skip
    QtWidgets.QApplication.sendEvent(box, event)


def test_the_cutters_of_the_setup_are_offered(doc, dome, pump, unfold, until):
    setup = app.create_setup(
        doc,
        machine="trunnion_bc",
        tools=["T3 ball:5:20 Small ball", "T7 flat:12:40", "T8 cone:3 Odd", "Nine"],
    )
    panel = toolpath.create(dome)
    pump(300)
    cutter = panel.options.fields["cutter"]
    box = cutter.setup.box
    assert [box.itemText(at) for at in range(box.count())] == [
        "From the setup…", "T3 Small ball", "T7 flat:12:40", "T8 Odd", "T0 Nine",
    ]  # fmt: skip
    until(lambda: box.isVisible() and not cutter.job.box.isVisible(), 20000, "the setup's cutters alone")
    box.activated.emit(1)
    assert cutter.value() == "ball:5.0:20.0" and box.currentIndex() == 0
    for at, message in ((3, "cone"), (4, "Nine is no tool")):
        box.activated.emit(at)
        assert message in cutter.error.text() and cutter.value() == "ball:5.0:20.0"
    box.clearFocus()
    panel.calculate_button.setFocus()
    wheel(box)
    assert (
        cutter.value() == "ball:5.0:20.0"
        and box.focusPolicy() == QtCore.Qt.StrongFocus == cutter.job.box.focusPolicy()
    )
    panel.setup.editor.setCurrentIndex(0)
    until(lambda: not box.isVisible(), 20000, "no cutters of a setup")
    assert setup.Tools[0] == "T3 ball:5:20 Small ball"
    panel.reject()


def test_what_is_shared_can_be_edited_again_where_calculate_takes_the_setup_back(
    doc, dome, pump, click, modal, monkeypatch, until
):
    panel = toolpath.create(dome)
    panel.options.show_options(COARSE | {"machine": "trunnion_bc"})
    pump(300)
    modal(
        lambda dialog: (
            dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Ok).click()
        )
    )
    click(panel.setup.browse)
    machine = panel.options.fields["machine"]
    until(
        lambda: doc.getObject("Setup") is not None and not machine.editor.isEnabled(),
        20000,
        "a setup with the machine",
    )

    def refused(*_):
        raise SettingsError("no such path", "")

    with monkeypatch.context() as patch:
        patch.setattr(app, "create_toolpath", lambda *_, **__: refused())
        assert not panel.calculate()
    pump(50)
    assert panel.options.error.text() == "no such path"
    assert doc.getObject("Setup") is None and panel.setup.value() is None and panel.setup.editor.count() == 1
    assert (
        machine.editor.isEnabled()
        and machine.value() == "trunnion_bc"
        and panel.options.fields["origin"].note.text() == ""
    )
    assert panel.calculate() and panel.obj.Setup is None
    panel.reject()


def test_a_side_that_is_not_machined_is_marked_with_its_area(doc, block, until, monkeypatch, screenshot):
    shown, show = [], on_screen.Labels.show
    monkeypatch.setattr(
        on_screen.Labels, "show", lambda self, labels: shown.append(labels) or show(self, labels)
    )
    path = app.create_toolpath(
        doc, block, cutter="ball:8:40", stepover=3.0, passes="planes", gouge="off", linear_deflection=0.3
    )
    result = app.annotate(path)
    until(lambda: shown and len(shown[-1]) > 1, 20000, "the labels drawn")
    sides = [at for at, kind in enumerate(result.Kinds) if kind == "side-not-machined"]
    assert [result.Areas[at] for at in sides] == pytest.approx([60.0 * 20.0] * 2) and not any(
        result.Depths[at] for at in sides
    )
    assert not any(area for at, area in enumerate(result.Areas) if result.Kinds[at] == "largest-deviation")
    assert [label.text for label in shown[-1]].count("Not machined: 1200 mm²") == 2
    screenshot("side_label")


def test_the_editor_shows_feeds_in_mm_per_minute(doc, dome, pump, select, screenshot):
    path = app.create_toolpath(doc, dome, **COARSE, feed=1200)
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(path)
    pump(700)
    screenshot("feed_editor")
    path.FeedPerMinute = 900.0
    assert FreeCAD.Units.Quantity(path.Feed).getValueAs("mm/min").Value == pytest.approx(900.0)


def test_a_flat_cutter_finishes_a_block_with_what_the_panel_offers(
    block, field, choose, type_into, until, pump, screenshot
):
    """Only cutter and stepover are chosen: the tool axis follows, and the whole block is finished."""
    panel = toolpath.create(block)
    pump(300)
    choose(field("cutter_kind"), "flat end mill")
    until(lambda: panel.options.options()["tool_axis"] == "face_normal", 20000, "face_normal")
    panel.options.show_options({"cutter": "flat:16", "stepover": 10.0, "spindle": 6000, "tool_length": 120.0})
    pump(300)
    screenshot("flat_panel")
    assert panel.calculate()
    pump(path_panel.DRAWN + 500)
    screenshot("flat_block")
    codes = {line.split(":")[0] for line in panel.obj.Findings} if hasattr(panel.obj, "Findings") else set()
    assert panel.obj.Verdict.startswith("SAFE"), (panel.obj.Verdict, codes)
    panel.reject()
