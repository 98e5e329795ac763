# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of FreeCAD's preferences, pressed by hand; and the German translation in the window."""

from pathlib import Path

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20 keeps them here
    QtWidgets = QtGui

from freecad_fiveaxis.app import preferences
from freecad_fiveaxis.gui.preferences import GROUP, Page

translate = FreeCAD.Qt.translate


@pytest.fixture
def ours(parameters):
    """Our parameter group, empty at first, put back afterwards; OK writes the boxes of FreeCAD's other pages
    too."""
    parameters("User parameter:BaseApp/Preferences/Document")
    found = parameters(preferences.GROUP)
    found.Clear()
    return found


@pytest.fixture
def in_dialog(window, modal, until):
    """in_dialog(work): open FreeCAD's preferences at our page, call work(the page's widgets by name, the
    dialog)."""

    def show(work):
        raised = ["the dialog did not show our page"]

        def meet(dialog):
            try:
                form = until(lambda: visible_form(dialog), 30000, f"our page in {dialog.windowTitle()!r}")
                work({key: form.findChild(QtWidgets.QWidget, key) for key in preferences.DEFAULTS}, dialog)
                raised.clear()
            except BaseException as error:  # Qt would swallow it
                raised.append(error)
            finally:
                dialog.close()

        modal(meet)
        FreeCADGui.showPreferences(GROUP, 0)
        assert not raised, raised

    return show


def visible_form(dialog):
    return next(
        (one for one in dialog.findChildren(QtWidgets.QWidget, "FiveAxisPreferences") if one.isVisible()),
        None,
    )


def press_button(dialog, kind):
    box = next(one for one in dialog.findChildren(QtWidgets.QDialogButtonBox) if one.button(kind))
    box.button(kind).click()


def test_a_default_changed_by_hand_is_kept_and_the_others_are_not_touched(
    ours, in_dialog, choose, type_into, screenshot, pump
):
    def work(widgets, dialog):
        type_into(widgets["Machine"], "trunnion_bc")
        choose(widgets["Controller"], "Fanuc")
        choose(widgets["CutterKind"], "tapered ball")
        type_into(widgets["CutterDiameter"], "6 mm")
        type_into(widgets["CutterTaper"], "3 deg")
        type_into(widgets["Holder"], "40x25,63x50")
        type_into(widgets["Feed"], "1200")
        screenshot("preferences-" + ".".join(FreeCAD.Version()[:2]))
        press_button(dialog, QtWidgets.QDialogButtonBox.Ok)
        pump(200)

    in_dialog(work)
    assert (preferences.machine(), preferences.controller()) == ("trunnion_bc", "fanuc")
    assert (preferences.cutter(), preferences.holder()) == ("taperball:6.0:3deg:50.0", "40x25,63x50")
    assert preferences.feed() == pytest.approx(1200.0)
    assert sorted(name for _, name, _ in ours.GetContents()) == [
        "Controller", "CutterDiameter", "CutterKind", "CutterTaper", "Feed", "Holder", "Machine",
    ]  # fmt: skip


def test_what_cannot_be_read_is_shown_and_keeps_the_default(ours, in_dialog, type_into, until, pump):
    texts = {}

    def work(widgets, dialog):
        type_into(widgets["CutterTaper"], "4 deg 30'")
        type_into(widgets["CutterDiameter"], "45 deg 30'")
        error = dialog.findChild(QtWidgets.QLabel, "preferences_error")
        until(error.isVisible, 5000, "what is wrong")
        texts["diameter"] = error.text(), widgets["CutterDiameter"].text()
        type_into(widgets["CutterDiameter"], "8")
        pump(50)
        texts["then"] = error.isVisible()
        type_into(widgets["Processes"], "1.5")
        texts["processes"] = error.text()
        type_into(widgets["Feed"], "1500,5")
        press_button(dialog, QtWidgets.QDialogButtonBox.Ok)
        pump(200)

    in_dialog(work)
    assert texts["diameter"][0].startswith("45 deg 30' is no length") and texts["diameter"][1] == "45 deg 30'"
    assert not texts["then"] and texts["processes"].startswith("1.5 is no whole number")
    assert preferences.read("CutterTaper") == 4.5 and preferences.read("CutterDiameter") == 8.0
    assert preferences.feed() == pytest.approx(1500.5) and not preferences.read("Processes")


def test_ok_without_a_change_keeps_numbers_that_the_boxes_show_rounded(ours, in_dialog):
    in_dialog(lambda widgets, dialog: press_button(dialog, QtWidgets.QDialogButtonBox.Ok))
    assert not ours.GetContents()
    assert preferences.feed() == 1000.0


def test_feeds_are_shown_in_inches_where_the_user_has_inches(ours, parameters):
    parameters("User parameter:BaseApp/Preferences/Units")
    preferences.write("Feed", 25.4)
    try:
        FreeCAD.Units.setSchema(3)  # imperial decimal
        page = Page()
        page.loadSettings()
        assert page.form.findChild(QtWidgets.QDoubleSpinBox, "Feed").text() == "60.0 in/min"
        assert page.read_shown("Feed") == pytest.approx(25.4)
    finally:
        FreeCAD.Units.setSchema(0)


def test_own_machines_are_in_the_list(ours, window, tmp_path):
    shipped = Page().choices["Machine"]
    folder = Path(__file__).parents[2] / "resources" / "machines"
    (tmp_path / "mine.fcm").write_bytes((folder / "trunnion_ac.fcm").read_bytes())
    (tmp_path / "broken.fcm").write_text("{}")
    preferences.write("MachineFolder", str(tmp_path))
    assert set(Page().choices["Machine"].values()) - set(shipped.values()) == {str(tmp_path / "mine.fcm")}
    assert set(shipped) == {path.stem for path in folder.glob("*.fcm")}


def test_cancel_keeps_nothing(ours, in_dialog, choose):
    def work(widgets, dialog):
        choose(widgets["Controller"], "Fanuc")
        press_button(dialog, QtWidgets.QDialogButtonBox.Cancel)

    in_dialog(work)
    assert not ours.GetContents()


def test_the_page_shows_and_keeps_every_parameter(ours, window):
    given = {
        "Machine": "/my/own.fcm", "Controller": "fanuc", "MachineFolder": "/my", "OutputFolder": "/nc", "CutterKind": "taperbull",
        "CutterDiameter": 6.0, "CutterCorner": 1.5, "CutterTaper": 2.5, "CutterNeck": 2.0, "CutterFlank": 60.0, "Shank": "6x20", "Holder": "40x25",
        "Scallop": 0.02, "Tolerance": 0.05, "Feed": 20.0, "ColourGood": 0x102030FF, "ColourBad": 0x405060FF,
        "ColourSingular": 0x708090FF, "Processes": 3,
    }  # fmt: skip
    assert set(given) == set(preferences.DEFAULTS)
    page, again = Page(), Page()
    page.loadSettings()
    for key, value in given.items():
        page.show_value(key, value)
    page.saveSettings()
    again.loadSettings()
    for key, value in given.items():
        for found in (preferences.read(key), again.read_shown(key)):
            assert found == (pytest.approx(value) if isinstance(value, float) else value), key


def test_reset_shows_the_defaults_again(ours, window):
    preferences.write("Machine", "trunnion_bc")
    page = Page()
    page.loadSettings()
    assert page.read_shown("Machine") == "trunnion_bc"
    page.resetSettingsToDefaults()
    assert page.read_shown("Machine") == preferences.DEFAULTS["Machine"]
    assert not ours.GetContents()


def test_the_page_speaks_german(german, window, screenshot, pump):
    texts = {label.text() for label in Page().form.findChildren(QtWidgets.QLabel)}
    assert {"Maschine", "Kuppenhöhe", "Vorschub"} <= texts
    pump(300)
    screenshot("german-" + ".".join(FreeCAD.Version()[:2]))


def test_menu_properties_and_plain_texts_are_german(german, window, pump, until):
    pump(300)

    def german_menu():
        menus = {
            menu.title().replace("&", ""): menu for menu in window.menuBar().findChildren(QtWidgets.QMenu)
        }
        return menus.get("Fünfachsig")

    menu = until(german_menu, 20000, "a German menu")
    until(
        lambda: "Tessellieren" in [action.text() for action in menu.actions()],
        20000,
        "a German command in it",
    )
    assert translate("FiveAxis", "Tool axis") == "Werkzeugachse"
    assert translate("App::Property", "Work Zero") == "Werkstücknullpunkt"


def test_a_text_that_has_no_translation_stays_as_it_is(german):
    assert translate("FiveAxis", "nobody translated this") == "nobody translated this"
    assert translate("Somewhere", "Tool axis") == "Tool axis"


def test_back_in_english(window):
    assert translate("FiveAxis", "Tool axis") == "Tool axis"
