# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recover, prove the signs, import a machine: pressed without a document, filled, read, and the files that OK
writes."""

import json
from pathlib import Path

import FreeCAD
import FreeCADGui
import Mesh
import pytest
from conftest import QtWidgets, close_all
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import machines, results
from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline import options
from freecad_fiveaxis.core.toolpath.apt import write_apt
from freecad_fiveaxis.gui.panels import prove_signs

ROOT = Path(__file__).resolve().parents[2]
SLID = 1000
"""ms after which FreeCAD 1.1 has slid its task panel in, where no view was open before."""
FAST = {
    "passes": "planes",
    "machine": "trunnion_ac",
    "stepover": 8,
    "linear_deflection": 0.1,
    "origin": (10, -5, 20),
}


@pytest.fixture
def folder(parameters, tmp_path):
    """The user's folder of machines, which is not there yet; NC files go to the test's own folder."""
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetString("MachineFolder", str(tmp_path / "machines"))
    group.SetString("OutputFolder", str(tmp_path))
    return tmp_path / "machines"


@pytest.fixture
def empty(window):
    """No document is open."""
    close_all(*FreeCAD.listDocuments())
    assert FreeCAD.ActiveDocument is None
    yield
    assert not FreeCAD.listDocuments(), "what was lent is given back"
    close_all()


@pytest.fixture(scope="module")
def pair(window, tmp_path_factory):
    """A CL file and the program made of it."""
    doc = FreeCAD.newDocument("Pair")
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    path = app.create_toolpath(doc, ball, **FAST)
    result, result_in = results.result_of(path).draft, tmp_path_factory.mktemp("pair")
    (result_in / "ball.apt").write_bytes(
        write_apt(result.path, result.settings.cutter.cutter, "ball", head=options.cl_head(result.settings))
    )
    app.post_process(path, result_in / "ball.ngc")
    FreeCAD.closeDocument("Pair")
    return result_in / "ball.apt", result_in / "ball.ngc"


def run(*words):
    return cli.main([str(word) for word in words])


def shown(field, name):
    """What a text of the panel says."""
    widget = field(name)
    return widget.toPlainText() if isinstance(widget, QtWidgets.QTextBrowser) else widget.text()


def cut(form):
    """The texts of a panel that are wider than their widgets; those that wrap and those that scroll are
    not."""
    kinds = (QtWidgets.QLabel, QtWidgets.QPushButton, QtWidgets.QCheckBox)
    shown = [one for kind in kinds for one in form.findChildren(kind) if one.isVisible() and one.text()]
    wide = [
        one.text() for one in shown
        if one.sizeHint().width() > one.width() + 2 and not (isinstance(one, QtWidgets.QLabel) and one.wordWrap())
    ]  # fmt: skip
    combos = [one for one in form.findChildren(QtWidgets.QComboBox) if one.isVisible()]
    arrow = 24  # pixels of the button at the right
    return wide + [
        one.currentText()
        for one in combos
        if one.fontMetrics().boundingRect(one.currentText()).width() + arrow > one.width()
    ]


def panel_form():
    return FreeCADGui.getMainWindow().findChild(QtWidgets.QWidget, "FiveAxisPanel")


def test_a_machine_is_recovered_without_a_document(empty, folder, pair, press, field, type_into, choose, click, until, panel_button,
                                                   screenshot, window, tmp_path, pump, panel_closed):  # fmt: skip
    press("FiveAxis_Recover", SLID)
    panel_button("OK")
    until(lambda: "CL file" in shown(field, "cl_file_error"), 20000, "a file that is missing")
    until(lambda: "NC file" in shown(field, "program_error"), 20000, "a file that is missing")
    assert FreeCADGui.Control.activeDialog(), "nothing to write yet"
    type_into(field("cl_file"), str(pair[0]))
    type_into(field("program"), str(pair[1]))
    until(lambda: field("machine_file").text() == str(folder / "ball.fcm"), 20000, "a name for the machine")
    choose(field("machine"), "trunnion_ac")
    for letter, value in zip("xyz", ("10 mm", "-5 mm", "20 mm"), strict=True):
        box = field("origin").findChild(QtWidgets.QCheckBox)
        if box.isChecked():
            click(box)
        type_into(field(f"origin_{letter}"), value)
    assert not field("page").isEnabled()
    click(field("calculate"))
    until(lambda: "table-table" in shown(field, "result"), 60000, "a result")
    assert "trunnion_ac is that machine" in shown(field, "result") and "A line, Y" in shown(field, "result")
    assert "Largest residual" in shown(field, "result") and field("page").isEnabled()
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("recover")
    assert not folder.exists(), "nothing is written before OK"
    panel_button("OK", 800)
    panel_closed()
    until(lambda: "Written" in window.statusBar().currentMessage(), 20000, "what was written")
    until(lambda: FreeCAD.ActiveDocument is None, 20000, "no document")
    assert str(folder / "ball.fcm") in [one.machine for one in machines.choices()]
    words = (
        "recover",
        *pair,
        "--machine",
        "trunnion_ac",
        "--origin",
        "10,-5,20",
        "-o",
        tmp_path / "ball.fcm",
        "--quiet",
    )
    assert run(*words) == cli.DONE
    assert (tmp_path / "ball.fcm").read_bytes() == (folder / "ball.fcm").read_bytes()


def test_another_machine_is_named_and_a_file_that_is_there_is_not_written(empty, folder, pair, press, field, type_into, choose,
                                                                          click, until, panel_button, screenshot, tmp_path):  # fmt: skip
    mine = tmp_path / "mine.fcm"
    mine.write_text("mine")
    press("FiveAxis_Recover", SLID)
    type_into(field("cl_file"), str(pair[0]))
    type_into(field("program"), str(pair[1]))
    type_into(field("machine_file"), str(mine))
    until(lambda: "there already" in shown(field, "machine_file_error"), 20000, "what is wrong")
    panel_button("OK")
    assert FreeCADGui.Control.activeDialog() and mine.read_text() == "mine"
    type_into(field("machine_file"), str(tmp_path / "mine.txt"))
    until(lambda: ".fcm" in shown(field, "machine_file_error"), 20000, "what is wrong")
    type_into(field("machine_file"), str(tmp_path / "other.fcm"))
    type_into(field("certainty"), "0 mm")
    until(lambda: "out of range" in shown(field, "certainty_error"), 20000, "what is wrong")
    type_into(field("certainty"), "0.01 mm")
    choose(field("machine"), "trunnion_bc")
    click(field("calculate"))
    until(lambda: "another machine" in shown(field, "result"), 60000, "a result")
    screenshot("recover-other")
    choose(field("machine"), "none")
    until(
        lambda: "Press Calculate" in shown(field, "result"),
        20000,
        "that what was shown was of other settings",
    )
    panel_button("Cancel")
    assert not (tmp_path / "other.fcm").exists()


def test_files_that_cannot_be_used_and_a_stop_say_so(empty, folder, pair, press, field, type_into, click, panel_button, monkeypatch,
                                                     window, pump, until):  # fmt: skip
    from freecad_fiveaxis.core.base.errors import Cancelled
    from freecad_fiveaxis.gui import waiting

    press("FiveAxis_Recover", SLID)
    type_into(field("cl_file"), str(pair[1].parent / "gone.apt"))
    until(lambda: "does not exist" in shown(field, "cl_file_error"), 20000, "what is wrong")
    type_into(field("cl_file"), str(pair[1]))
    type_into(field("program"), str(pair[0]))
    click(field("calculate"))
    until(lambda: shown(field, "form_error"), 20000, "what is wrong")
    assert "Press Calculate" in shown(field, "result")
    type_into(field("cl_file"), str(pair[0]))
    type_into(field("program"), str(pair[1]))

    def stop(self, stage, fraction):
        raise Cancelled("stopped by the user")

    monkeypatch.setattr(waiting.Waiting, "__call__", stop)
    click(field("calculate"))
    until(lambda: "Stopped" in window.statusBar().currentMessage(), 20000, "that it was stopped")
    assert "Press Calculate" in shown(field, "result")
    panel_button("Cancel")


def test_the_mark_starts_at_the_top_of_the_part_in_work_coordinates(
    doc, press, field, type_into, click, until
):
    box = doc.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height, box.Placement.Base.z = 60, 40, 15, 25
    hidden = doc.addObject("Part::Box", "Tall")
    hidden.Height, hidden.Visibility = 500, False
    doc.recompute()
    press("FiveAxis_ProveSigns", SLID)
    until(
        lambda: [field(f"mark_{letter}").read_measure() for letter in "xyz"] == [30.0, 20.0, 40.0],
        20000,
        "the top of the part",
    )
    type_into(field("work_zero_z"), "25 mm")
    until(lambda: field("mark_z").read_measure() == 15.0, 20000, "the top counted from the work zero")
    click(field("calculate"))
    until(lambda: "Stop 8" in shown(field, "result"), 60000, "a sheet")
    assert "Nothing may stand" not in shown(field, "result")
    type_into(field("mark_z"), "60 mm")
    type_into(field("work_zero_z"), "0 mm")
    assert field("mark_z").read_measure() == 60.0, "what the user has given stays"


def test_without_a_part_the_sheet_says_that_nothing_may_stand_there(
    empty, press, field, click, until, panel_button
):
    press("FiveAxis_ProveSigns", SLID)
    click(field("calculate"))
    until(lambda: "Stop 8" in shown(field, "result"), 60000, "a sheet")
    assert "Nothing may stand above Z 0" in shown(field, "result")[:400], shown(field, "result")[:400]
    panel_button("Cancel")


def test_the_signs_are_proven_without_a_document(empty, folder, press, field, type_into, choose, click, until, panel_button,
                                                 screenshot, tmp_path, monkeypatch, modal, pump, panel_closed):  # fmt: skip
    opened = []
    monkeypatch.setattr(
        prove_signs.QtGui.QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile())
    )
    press("FiveAxis_ProveSigns", SLID)
    until(lambda: not field("mark_pick").isEnabled(), 20000, "that there is nothing to pick from")
    choose(field("controller"), "Heidenhain TNC (TCPM)")
    until(
        lambda: field("nc_file").text().endswith("trunnion_ac signs.h"), 20000, "the controller's own ending"
    )
    nc, sheet = tmp_path / "signs.h", tmp_path / "signs.html"
    type_into(field("nc_file"), str(nc))
    until(lambda: field("sheet").text() == str(sheet), 20000, "the sheet beside the program")
    for letter, value in zip("xyz", ("40 mm", "25 mm", "10 mm"), strict=True):
        type_into(field(f"mark_{letter}"), value)
    type_into(field("gap"), "2 mm")
    until(lambda: "out of range" in shown(field, "gap_error"), 20000, "what is wrong")
    type_into(field("gap"), "30 mm")
    click(field("calculate"))
    until(lambda: "Stop 8" in shown(field, "result"), 60000, "a sheet")
    assert "Only A turns" in shown(field, "result") and not nc.exists()
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("prove-signs")
    click(field("open_sheet"))
    until(lambda: opened, 20000, "the sheet opened")
    assert "Proving the signs" in Path(opened[0]).read_text(encoding="utf-8")
    sheet.write_text("mine")
    met = modal("Cancel")
    panel_button("OK")
    until(lambda: met.texts, 20000, "a question")
    assert "signs.html" in met.texts[0] and sheet.read_text() == "mine" and not nc.exists()
    assert FreeCADGui.Control.activeDialog()
    modal("Replace")
    panel_button("OK", 800)
    panel_closed()
    until(lambda: FreeCAD.ActiveDocument is None, 20000, "no document")
    (tmp_path / "cli").mkdir()
    words = ("--machine", "trunnion_ac", "--controller", "heidenhain", "--mark", "40,25,10", "--gap", "30")
    report = tmp_path / "cli" / "signs.html"
    assert (
        run("prove-signs", *words, "-o", tmp_path / "cli" / "signs.h", "--report", report, "--quiet")
        == cli.DONE
    )
    assert (
        tmp_path / "cli" / "signs.h"
    ).read_bytes() == nc.read_bytes() and report.read_bytes() == sheet.read_bytes()


def test_the_mark_is_picked_on_the_part_and_counts_from_the_tool_path_s_zero(doc, folder, press, field, click, view_click, until,
                                                                             panel_button, screenshot, tmp_path, pump,
                                                                             panel_closed):  # fmt: skip
    box = doc.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 40, 30, 12
    doc.recompute()
    path = app.create_toolpath(
        doc, box, passes="planes", machine="trunnion_bc", stepover=8, work_zero=(10, 5, 0), tool=4
    )
    path.ViewObject.hide()
    look(doc)
    press("FiveAxis_ProveSigns", SLID)
    until(lambda: field("machine").currentText() == "trunnion_bc", 20000, "the path's machine")
    click(field("mark_pick"))
    view_click((40, 0, 12))
    until(
        lambda: field("mark_x").read_measure() == pytest.approx(30, abs=1e-6),
        20000,
        "the corner, from the work zero",
    )
    mark = [field(f"mark_{letter}").read_measure() for letter in "xyz"]
    assert mark == pytest.approx([30, -5, 12], abs=1e-6)
    panel_button("OK", 800)
    panel_closed()
    result = [one.name for one in tmp_path.iterdir()]
    assert sorted(result) == ["trunnion_bc signs.html", "trunnion_bc signs.ngc"]
    assert b"T4 M6" in (tmp_path / "trunnion_bc signs.ngc").read_bytes()
    assert doc.UndoCount == 0 or "Prove" not in str(doc.UndoNames)


def test_a_machine_is_imported_with_its_findings(empty, whole_screen, folder, press, field, type_into, click, until, panel_button,
                                                 screenshot, tmp_path, pump, panel_closed):  # fmt: skip
    source = tmp_path / "theirs.fcm"
    data = json.loads((ROOT / "resources" / "machines" / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    data.pop("fiveaxis", None)
    source.write_text(json.dumps(data))
    press("FiveAxis_ImportMachine", SLID)
    type_into(field("source"), str(tmp_path / "notes.txt"))
    until(lambda: "does not exist" in shown(field, "source_error"), 20000, "what is wrong")
    (tmp_path / "notes.txt").write_text("no machine")
    type_into(field("source"), str(tmp_path / "notes.txt"))
    type_into(field("source"), str(source))
    until(lambda: field("machine_file").text() == str(folder / "theirs.fcm"), 20000, "a name for the machine")
    click(field("calculate"))
    until(lambda: "Prove the signs before cutting" in shown(field, "result"), 20000, "findings")
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("import-machine")
    panel_button("OK", 500)
    panel_closed()
    assert load_machine(str(folder / "theirs.fcm")).rotary
    press("FiveAxis_ImportMachine", SLID)
    type_into(field("source"), str(source))
    until(
        lambda: field("machine_file").text() == str(folder / "theirs-2.fcm"),
        20000,
        "the name of no file that is there",
    )
    panel_button("Cancel")


INI = """[KINS]
KINEMATICS = xyzac-trt-kins
[HAL]
HALFILE = mill.hal
[TRAJ]
LINEAR_UNITS = mm
ANGULAR_UNITS = deg
"""
MILL = """from vismach import *
import hal
c = hal.component("gui")
tip, work = Capture(), Capture()
head = HalTranslate([tip, CylinderZ(0, 20, 60, 30)], c, "spindle-z", 0, 0, 1)
table = HalRotate([work, CylinderZ(-20, 60, 0, 60)], c, "rotate-c", 1, 0, 0, 1)
table = HalRotate([table, Box(-70, -60, -50, 70, 60, -25)], c, "tilt-a", 1, 1, 0, 0)
table = HalTranslate([table], c, "table-x", -1, 0, 0)
table = HalTranslate([table, HalShow([Box(0, 0, 0, 1, 1, 1)], c, 1, "show")], c, "saddle-y", 0, -1, 0)
main(Collection([head, table, Box(-300, 100, -300, 300, 200, 300)]), tip, work)
"""


def test_bodies_come_from_the_vismach_model_that_hal_starts(empty, whole_screen, folder, press, field, type_into, click, until,
                                                            panel_button, screenshot, tmp_path, panel_closed):  # fmt: skip
    limits = "MIN_LIMIT = -200\nMAX_LIMIT = 200\nMAX_VELOCITY = 50\n"
    (tmp_path / "mill.ini").write_text(INI + "".join(f"[JOINT_{joint}]\n{limits}" for joint in range(5)))
    (tmp_path / "mill.hal").write_text(
        "loadusr -W ./gui.py\nsetp xyzac-trt-kins.y-offset 0\nsetp xyzac-trt-kins.z-offset 0\n"
    )
    (tmp_path / "gui.py").write_text(MILL)
    press("FiveAxis_ImportMachine", SLID)
    type_into(field("source"), str(tmp_path / "mill.ini"))
    until(lambda: field("bodies").text() == str(tmp_path / "gui.py"), 20000, "the model that HAL starts")
    until(lambda: field("machine_file").text() == str(folder / "mill.fcm"), 20000, "a name for the machine")
    click(field("calculate"))
    until(lambda: "HalShow" in shown(field, "result"), 20000, "what is left out")
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("import-vismach")
    panel_button("OK", 500)
    panel_closed()
    bodies = load_machine(str(folder / "mill.fcm")).bodies
    assert [(body.name, body.carrier) for body in bodies] == [
        ("head", "spindle"), ("table", "C"), ("table 2", "A"), ("body", "base")
    ]  # fmt: skip


URDF = """<robot name="home trunnion"><link name="base"/>
<link name="cradle"><collision><geometry><mesh filename="cradle.stl" scale="0.001 0.001 0.001"/></geometry></collision></link>
<link name="table"><collision><origin xyz="0 0 -0.065"/><geometry><cylinder radius="0.08" length="0.03"/></geometry></collision></link>
<link name="saddle"/><link name="beam"/><link name="ram"/>
<link name="tool"><collision><origin xyz="0 0 0.04"/><geometry><cylinder radius="0.03" length="0.08"/></geometry></collision></link>
{joints}<joint name="nose" type="fixed"><parent link="ram"/><child link="tool"/><origin xyz="0 0 0.2"/></joint></robot>"""
JOINT = """<joint name="{0}" type="{1}"><parent link="{2}"/><child link="{3}"/><origin xyz="{4}"/><axis xyz="{5}"/>
<limit lower="-1.5" upper="1.5" velocity="0.5"/></joint>"""
JOINTS = (
    ("a", "revolute", "base", "cradle", "0 0 -0.05", "-1 0 0"), ("c", "continuous", "cradle", "table", "0 0 0.05", "0 0 -1"),
    ("x", "prismatic", "base", "saddle", "0 0 0", "1 0 0"), ("y", "prismatic", "saddle", "beam", "0 0 0", "0 1 0"),
    ("z", "prismatic", "beam", "ram", "0 0 0", "0 0 1"),
)  # fmt: skip


def test_a_urdf_file_is_imported_with_its_bodies_which_the_editor_then_shows(
    empty, whole_screen, folder, press, field, type_into, click, until, panel_button, screenshot, tmp_path, pump, panel_closed,
    parameters,
):  # fmt: skip
    Mesh.createBox(200.0, 100.0, 20.0).write(str(tmp_path / "cradle.stl"))
    source = tmp_path / "mill.urdf"
    source.write_text(URDF.format(joints="".join(JOINT.format(*one) for one in JOINTS)))
    press("FiveAxis_ImportMachine", SLID)
    type_into(field("source"), str(source))
    until(lambda: field("machine_file").text() == str(folder / "mill.fcm"), 20000, "a name for the machine")
    click(field("calculate"))
    until(lambda: "cradle (A), table (C), tool (spindle)" in shown(field, "result"), 20000, "bodies")
    assert "the origin of tool" in shown(field, "result")
    until(lambda: not cut(panel_form()), 20000, "no text that is cut")
    screenshot("import-urdf")
    panel_button("OK", 500)
    panel_closed()
    assert sorted(path.name for path in folder.iterdir()) == ["mill cradle.stl", "mill.fcm"]
    assert [body.carrier for body in load_machine(str(folder / "mill.fcm")).bodies] == ["A", "C", "spindle"]
    until(lambda: not FreeCAD.listDocuments(), 20000, "what was lent is given back")
    parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis").SetString(
        "Machine", str(folder / "mill.fcm")
    )
    press("FiveAxis_EditMachine", SLID)
    until(lambda: field("bodies_table").rowCount() == 3, 20000, "its bodies")
    assert "a name of its own" in shown(field, "editor_findings"), (
        "it is in the lists, and its mesh can be read"
    )
    pump(500)
    screenshot("import-urdf-edited")
    panel_button("Close", 500)
    panel_closed()
    until(lambda: not FreeCAD.listDocuments(), 20000, "the editor's document is closed")


def test_escape_writes_nothing(
    empty, folder, press, field, click, real_key, window, pump, tmp_path, until, panel_closed
):
    press("FiveAxis_ProveSigns", SLID)
    click(field("calculate"))
    until(lambda: "Stop 8" in shown(field, "result"), 60000, "a sheet")
    pump(500)
    real_key(window, "Escape")
    panel_closed()
    assert not list(tmp_path.iterdir())


def test_the_report_is_saved_where_the_user_says(empty, folder, pair, press, field, type_into, click, until, panel_button,
                                                 monkeypatch, modal, tmp_path):  # fmt: skip
    from freecad_fiveaxis.gui.panels import recover

    file = tmp_path / "report.html"
    monkeypatch.setattr(recover, "ask_file", lambda *_: str(file))
    press("FiveAxis_Recover", SLID)
    type_into(field("cl_file"), str(pair[0]))
    type_into(field("program"), str(pair[1]))
    click(field("calculate"))
    until(lambda: "table-table" in shown(field, "result"), 60000, "a result")
    click(field("page"))
    until(file.exists, 20000, "the report")
    assert "The machine that the post had in mind" in file.read_text(encoding="utf-8")
    file.write_text("mine")
    met = modal("Cancel")
    click(field("page"))
    until(lambda: met.texts, 20000, "a question")
    assert file.read_text() == "mine"
    panel_button("Cancel")
