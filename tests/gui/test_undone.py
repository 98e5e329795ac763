# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that change under a path: undone and done again, its part or its mesh deleted, closed while it is computed."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtCore, QtWidgets
from test_clicks import look

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


def test_a_deleted_part_is_called_deleted_and_undo_helps(dome, doc, planned, select, modal, press, pump, until):
    planned(dome, "OK")
    path, blocks = doc.Toolpath, doc.Toolpath.Blocks
    deleted(dome, select, modal, pump)
    until(lambda: doc.getObject("Dome") is None, 20000, "the part deleted")
    until(lambda: "was deleted: undo that" in results.out_of_date(path) == legend(path), 20000, "that it was deleted")
    doc.recompute()
    pump(300)
    until(lambda: "was deleted: undo that" in results.out_of_date(path), 20000, "that it was deleted")
    assert path.Blocks == blocks
    assert "The part was deleted: undo that" in path.Mesh.getStatusString()
    press("Std_Undo", 500)
    until(lambda: doc.getObject("Dome"), 20000, "the part back")
    doc.recompute()
    assert results.out_of_date(doc.Toolpath) == ""


def test_a_deleted_mesh_is_not_computed_on(dome, doc, planned, select, modal, press, pump, until, field, click, panel_button):
    from freecad_fiveaxis.gui.panels import toolpath

    planned(dome, "OK")
    path = doc.Toolpath
    deleted(path.Mesh, select, modal, pump)
    until(lambda: doc.getObject("Tessellation") is None, 20000, "the mesh deleted")
    until(lambda: "The mesh of Toolpath was deleted: undo that" in results.out_of_date(path), 20000, "that it was deleted")
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
