# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that change under a path: undone and done again, its part or its mesh deleted, closed while it is
computed."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import LEFT, QtCore, QtWidgets
from conftest import _mouse as mouse
from conftest import _tool_button as tool_button
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.app.selection import SelectionError

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def dome(doc):
    """A half ball of 20 mm."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


@pytest.fixture
def planned(select, press, field, choose, type_into, click, until, panel_button, pump, panel_closed):
    """planned(base, button): the panel for a new path, Calculate, and OK or Cancel."""

    def plan(base, button):
        select(base)
        press("FiveAxis_Toolpath")
        choose(field("passes"), "parallel planes")
        choose(field("spacing_kind"), "Stepover")
        type_into(field("stepover"), "5 mm")
        click(field("calculate"))
        until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
        panel_button(button, 500)
        panel_closed()

    return plan


def legend(path):
    """Why the path's picture says that it is out of date."""
    return path.ViewObject.Proxy.picture.checked


def test_a_path_that_is_undone_and_done_again_is_current(dome, doc, planned, press, pump, anew, until):
    planned(dome, "OK")
    nc = results.nc_of(doc.Toolpath)
    press("Std_Undo", 500)
    until(lambda: doc.getObject("Toolpath") is None, 20000, "undone")
    press("Std_Redo", 700)
    until(lambda: doc.getObject("Toolpath"), 20000, "done again")
    anew()
    path = doc.Toolpath
    until(lambda: results.out_of_date(path) == "" == legend(path), 20000, "a path that is current")
    assert path.Mesh.State == ["Up-to-date"] and "Touched" not in path.State
    assert results.nc_of(path) == nc


def test_what_undo_brings_back_out_of_date_stays_so(dome, doc, planned, press, pump, until):
    planned(dome, "OK")
    before = float(doc.Toolpath.Mesh.LinearDeflection)
    doc.openTransaction("other deflection")
    doc.Toolpath.Mesh.LinearDeflection = 0.5
    doc.commitTransaction()
    press("Std_Undo", 500)
    until(lambda: float(doc.Toolpath.Mesh.LinearDeflection) == before, 20000, "undone")
    press("Std_Redo", 500)
    until(lambda: float(doc.Toolpath.Mesh.LinearDeflection) == 0.5, 20000, "done again")
    assert "Tessellation was changed" in results.out_of_date(doc.Toolpath)
    doc.openTransaction("other radius")
    dome.Radius = 15
    doc.commitTransaction()
    doc.recompute([dome])
    doc.undo()
    doc.redo()
    pump(500)
    until(lambda: results.out_of_date(doc.Toolpath), 20000, "a path that is out of date")


def test_cancelled_panels_leave_no_gap_in_the_labels(dome, doc, planned, until):
    allowed = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").GetContents()
    for _ in range(2):
        planned(dome, "Cancel")
        until(lambda: [obj.Label for obj in doc.Objects] == ["Dome"], 20000, "nothing left")
    planned(dome, "OK")
    assert (doc.Toolpath.Label, doc.Toolpath.Mesh.Label) == ("Toolpath", "Tessellation")
    planned(dome, "OK")
    assert doc.getObject("Toolpath001").Label == "Toolpath001"
    assert FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").GetContents() == allowed


def deleted(obj, select, modal, pump):
    """Delete it as a user does; a question whether others may break is answered with Yes."""
    select(obj)
    answer = modal("Yes", 3)
    FreeCADGui.runCommand("Std_Delete")
    pump(900)
    answer.stop()


def test_a_deleted_part_is_called_deleted_and_undo_helps(
    dome, doc, planned, select, modal, press, pump, until
):
    planned(dome, "OK")
    path, blocks = doc.Toolpath, doc.Toolpath.Blocks
    deleted(dome, select, modal, pump)
    until(lambda: doc.getObject("Dome") is None, 20000, "the part deleted")
    until(
        lambda: "was deleted: undo that" in results.out_of_date(path) == legend(path),
        20000,
        "that it was deleted",
    )
    doc.recompute()
    pump(300)
    until(lambda: "was deleted: undo that" in results.out_of_date(path), 20000, "that it was deleted")
    assert path.Blocks == blocks
    assert "The part was deleted: undo that" in path.Mesh.getStatusString()
    press("Std_Undo", 500)
    until(lambda: doc.getObject("Dome"), 20000, "the part back")
    doc.recompute()
    assert results.out_of_date(doc.Toolpath) == ""


def test_a_deleted_mesh_is_not_computed_on(
    dome, doc, planned, select, modal, press, pump, until, field, click, panel_button
):
    from freecad_fiveaxis.gui.panels import toolpath

    planned(dome, "OK")
    path = doc.Toolpath
    deleted(path.Mesh, select, modal, pump)
    until(lambda: doc.getObject("Tessellation") is None, 20000, "the mesh deleted")
    until(
        lambda: "The mesh of Toolpath was deleted: undo that" in results.out_of_date(path),
        20000,
        "that it was deleted",
    )
    with pytest.raises(SelectionError, match="was deleted"):
        results.figures_of(path)
    toolpath.edit(path)
    pump(300)
    click(field("calculate"))
    until(lambda: "was deleted: undo that" in field("form_error").text(), 20000, "what is wrong")
    panel_button("Cancel")
    path.Stepover = 3
    doc.recompute()
    assert "Invalid" in path.State and path.Blocks == 0


def when_computing(act):
    """Call ``act`` once a dialog of long work is shown; gives the timer."""
    timer = QtCore.QTimer()

    def look_again():
        if isinstance(QtWidgets.QApplication.activeModalWidget(), QtWidgets.QProgressDialog):
            timer.stop()
            act()

    timer.timeout.connect(look_again)
    timer.start(20)
    return timer


@pytest.fixture
def slow(anew, dome, doc, select, press, field, choose, type_into):
    """The panel of a path that takes long to compute."""
    select(dome)
    press("FiveAxis_Toolpath")
    choose(field("spacing_kind"), "Stepover")
    type_into(field("stepover"), "0.01 mm")
    return doc


def test_a_document_closed_by_a_macro_while_it_is_computed_ends_the_work(slow, field, click, pump, until):
    name, closed = slow.Name, []
    timer = when_computing(lambda: closed.append(FreeCAD.closeDocument(name)))
    click(field("calculate"))
    until(lambda: closed, 60000, "the document closed while it is computed")
    until(lambda: not timer.isActive() and name not in FreeCAD.listDocuments(), 20000, "the work over")
    until(lambda: QtWidgets.QApplication.activeModalWidget() is None, 20000, "no dialog")
    FreeCADGui.Control.closeDialog()
    pump(500)


@pytest.fixture
def report_view(window):
    """Everything that FreeCAD and we have said since the test began, as the user reads it."""
    (shown,) = [one for one in window.findChildren(QtWidgets.QTextEdit) if one.objectName() == "Report view"]
    shown.clear()
    return shown


@pytest.fixture
def hanging(dome, doc, until, tmp_path):
    """A path with all that may hang on one: setup, NC file, markers, both maps, and an audit that is compared
    with the part."""
    setup = app.create_setup(doc, machine="trunnion_ac")
    plain = {
        "passes": "planes",
        "tool_axis": "facet_mean",
        "stepover": 5.0,
        "spindle": 8000,
        "setup": setup,
        "cutter": "ball:6:30",
    }
    path = app.create_toolpath(doc, dome, **plain)
    nc = tmp_path / "dome.ngc"
    app.post_process(path, nc)
    app.annotate(path)
    app.left_map(path)
    app.setup_map(path, region=(50, 50, 50), grid=(3, 1, 1))
    app.audit(doc, nc, "trunnion_ac", cutter="ball:6:30", part=dome)
    path.ViewObject.Visibility = True
    doc.recompute()
    until(
        lambda: all(drawn(one) for one in (path, doc.Audit, doc.Markers, doc.LeftMap, doc.SetupMap)),
        30000,
        "all drawn",
    )
    return path


def drawn(obj):
    """The picture of an object, once there is one."""
    return obj.ViewObject.Proxy.picture


def ours(doc):
    """Our objects by name, each with why it is out of date."""
    return {
        obj.Name: results.out_of_date(obj)
        for obj in doc.Objects
        if hasattr(obj, "Fingerprint") and hasattr(obj, "Blocks")
    }


@pytest.mark.parametrize(("gone", "message"), [("Dome", "The part was deleted"), ("Tessellation", "The mesh of Toolpath was deleted"),
                                            ("Toolpath", "The path of Markers was deleted")])  # fmt: skip
def test_what_hangs_on_what_was_deleted_says_so_without_a_traceback_and_comes_back(
    gone, message, hanging, doc, select, modal, press, pump, until, report_view, screenshot
):
    before = {obj.Name: obj.State for obj in doc.Objects}
    deleted(doc.getObject(gone), select, modal, pump)
    until(
        lambda: doc.getObject(gone) is None and message in report_view.toPlainText(),
        20000,
        "that it was deleted",
    )
    doc.recompute()
    pump(300)
    screenshot(f"deleted_{gone}")
    assert "Traceback" not in report_view.toPlainText()
    press("Std_Undo", 500)
    until(lambda: doc.getObject(gone), 20000, "all back")
    doc.recompute()
    until(lambda: set(ours(doc).values()) == {""}, 20000, "all current")
    assert {obj.Name for obj in doc.Objects} == set(before) and not [
        obj.Name for obj in doc.Objects if "Invalid" in obj.State
    ]
    assert "Traceback" not in report_view.toPlainText()


def test_an_error_that_nobody_foresaw_keeps_its_trace(dome, doc, planned, monkeypatch, report_view, until):
    planned(dome, "OK")
    monkeypatch.setattr(results, "put_result", lambda *_: 1 / 0)
    doc.Toolpath.touch()
    doc.recompute()
    until(lambda: "ZeroDivisionError" in report_view.toPlainText(), 20000, "the error")
    assert "Traceback" in report_view.toPlainText()


def test_refresh_pressed_again_while_freecad_recomputes_recomputes_nothing_within(
    dome, doc, planned, report_view, press, real_key, parameters, until
):
    """By the mouse and by its key, once the recompute shows its dialog: FreeCAD would say *Recursive calling
    of recompute*.

    The clicks go to the button past the dialog, which a user's cannot; FreeCAD takes them away where a
    recompute can be stopped.
    """
    parameters("User parameter:BaseApp/Preferences/Document").SetBool("CanAbortRecompute", True)
    planned(dome, "OK")
    doc.Toolpath.Stepover = 0.3  # long enough to press something meanwhile
    dome.Radius = 22
    button, pressed = tool_button("Std_Refresh"), []

    def again():
        real_key(FreeCADGui.getMainWindow(), "F5")
        for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
            mouse(button, kind, button.rect().center(), LEFT, LEFT, ms=0)
        pressed.append(doc.Recomputing)

    timer = when_computing(again)
    press("Std_Refresh")
    until(
        lambda: pressed and not doc.Recomputing, 60000, "the recompute over, with Refresh pressed meanwhile"
    )
    timer.stop()
    assert pressed == [True], "while FreeCAD recomputed"
    until(lambda: results.out_of_date(doc.Toolpath) == "", 20000, "the path current")
    assert "Recursive" not in report_view.toPlainText() and "Traceback" not in report_view.toPlainText()
