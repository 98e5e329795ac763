# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that change under a path: undone and done again, its part or its mesh deleted, closed while it is computed."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtCore, QtWidgets
from test_clicks import look

from freecad_fiveaxis.app import results
from freecad_fiveaxis.app.selection import SelectionError


@pytest.fixture
def dome(doc):
    """A half ball of 20 mm."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


@pytest.fixture
def planned(select, press, field, choose, type_into, click, until, panel_button, pump):
    """planned(base, button): the panel for a new path, Calculate, and OK or Cancel."""

    def plan(base, button):
        select(base)
        press("FiveAxis_Toolpath")
        choose(field("spacing_kind"), "Stepover")
        type_into(field("stepover"), "5 mm")
        click(field("calculate"))
        until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
        panel_button(button, 500)

    return plan


def legend(path):
    """Why the path's picture says that it is out of date."""
    return path.ViewObject.Proxy.picture.checked


def test_a_path_that_is_undone_and_done_again_is_current(dome, doc, planned, press, pump):
    planned(dome, "OK")
    nc = results.nc_of(doc.Toolpath)
    press("Std_Undo", 500)
    assert doc.getObject("Toolpath") is None
    press("Std_Redo", 700)
    path = doc.Toolpath
    assert results.out_of_date(path) == "" == legend(path)
    assert path.Mesh.State == ["Up-to-date"] and "Touched" not in path.State
    assert results.nc_of(path) == nc


def test_what_undo_brings_back_out_of_date_stays_so(dome, doc, planned, press, pump):
    planned(dome, "OK")
    doc.openTransaction("other deflection")
    doc.Toolpath.Mesh.LinearDeflection = 0.5
    doc.commitTransaction()
    press("Std_Undo", 500)
    press("Std_Redo", 500)
    assert "Tessellation was changed" in results.out_of_date(doc.Toolpath)
    doc.openTransaction("other radius")
    dome.Radius = 15
    doc.commitTransaction()
    doc.recompute([dome])
    doc.undo()
    doc.redo()
    pump(500)
    assert results.out_of_date(doc.Toolpath)


def test_cancelled_panels_leave_no_gap_in_the_labels(dome, doc, planned):
    allowed = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document").GetContents()
    for _ in range(2):
        planned(dome, "Cancel")
        assert [obj.Label for obj in doc.Objects] == ["Dome"]
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


def test_a_deleted_part_is_called_deleted_and_undo_helps(dome, doc, planned, select, modal, press, pump):
    planned(dome, "OK")
    path, blocks = doc.Toolpath, doc.Toolpath.Blocks
    deleted(dome, select, modal, pump)
    assert doc.getObject("Dome") is None
    assert "was deleted: undo that" in results.out_of_date(path) == legend(path)
    doc.recompute()
    pump(300)
    assert "was deleted: undo that" in results.out_of_date(path) and path.Blocks == blocks
    assert "The part was deleted: undo that" in path.Mesh.getStatusString()
    press("Std_Undo", 500)
    doc.recompute()
    assert results.out_of_date(doc.Toolpath) == ""


def test_a_deleted_mesh_is_not_computed_on(dome, doc, planned, select, modal, press, pump, until, field, click, panel_button):
    from freecad_fiveaxis.gui.panels import toolpath

    planned(dome, "OK")
    path = doc.Toolpath
    deleted(path.Mesh, select, modal, pump)
    assert doc.getObject("Tessellation") is None and "The mesh of Toolpath was deleted: undo that" in results.out_of_date(path)
    with pytest.raises(SelectionError, match="was deleted"):
        results.figures_of(path)
    toolpath.edit(path)
    pump(300)
    click(field("calculate"))
    assert "was deleted: undo that" in field("form_error").text()
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
def slow(dome, doc, select, press, field, choose, type_into):
    """The panel of a path that takes long to compute."""
    select(dome)
    press("FiveAxis_Toolpath")
    choose(field("spacing_kind"), "Stepover")
    type_into(field("stepover"), "0.01 mm")
    return doc


def test_a_document_closed_by_a_macro_while_it_is_computed_ends_the_work(slow, field, click, pump):
    name, closed = slow.Name, []
    timer = when_computing(lambda: closed.append(FreeCAD.closeDocument(name)))
    click(field("calculate"))
    pump(500)
    assert closed and not timer.isActive() and name not in FreeCAD.listDocuments()
    assert QtWidgets.QApplication.activeModalWidget() is None
    FreeCADGui.Control.closeDialog()
    pump(500)
