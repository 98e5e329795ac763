# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD finds the add-on as a user's add-on is found, and its start-up stays light: neither the core nor
numpy is imported."""

import os
import sys
import time
import unittest

import FreeCAD
import pytest

in_window = pytest.mark.skipif(not FreeCAD.GuiUp, reason="needs FreeCAD's window")
late_imports = []
"""What the first panel of the session imported: once for all, because a second one has nothing left to
import."""

pytestmark = pytest.mark.short


def test_freecad_found_this_add_on():
    import freecad_fiveaxis

    folder = os.path.dirname(os.path.dirname(freecad_fiveaxis.__file__))
    assert os.path.realpath(folder) == os.path.realpath(os.environ["FIVEAXIS_ROOT"])
    assert any(
        path.startswith(os.environ["FREECAD_USER_HOME"])
        for path in sys.path
        if path.rstrip("/").endswith("FiveAxis")
    )


def test_starting_up_imported_neither_the_core_nor_numpy():
    loaded = FreeCAD.fiveaxis_modules_at_start
    assert loaded
    heavy = ("numpy", "scipy", "freecad_fiveaxis.core", "freecad_fiveaxis.app.results")
    assert not [name for name in sorted(loaded) if name.startswith(heavy)]


def test_freecads_test_workbench_knows_our_tests_and_loads_them_late():
    name = "freecad_fiveaxis.app.self_test"
    assert FreeCAD.__unit_test__.count(name) == 1
    assert name not in FreeCAD.fiveaxis_modules_at_start
    outcome = unittest.TestResult()
    unittest.defaultTestLoader.loadTestsFromName(f"{name}.SelfTest").run(outcome)
    assert outcome.testsRun >= 2 and outcome.wasSuccessful(), outcome.failures + outcome.errors
    every = unittest.defaultTestLoader.loadTestsFromName(name)
    assert every.countTestCases() >= outcome.testsRun + 20, "one case for each file in tests/app"


@in_window
def test_the_workbench_is_listed_with_its_icon():
    import FreeCADGui

    bench = FreeCADGui.listWorkbenches()["FiveAxisWorkbench"]
    assert bench.MenuText == "Five-axis"
    assert os.path.isfile(bench.Icon), bench.Icon


@in_window
def test_the_workbench_is_active():
    import FreeCADGui

    assert FreeCADGui.activeWorkbench().__class__.__name__ == "FiveAxisWorkbench"


@in_window
def test_the_first_panel_has_nothing_left_to_import():
    """The mesher alone takes 0.12 s, in which the window is silent."""
    from freecad_fiveaxis.gui import warm_up
    from freecad_fiveaxis.gui.qt import QtWidgets

    end = time.monotonic() + 60
    while not warm_up.is_done() and time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.01)
    assert warm_up.is_done()
    late_imports.append(imported_by_a_panel())
    assert not late_imports[0]


def imported_by_a_panel():
    import FreeCADGui

    from freecad_fiveaxis.gui.panels import toolpath

    doc = FreeCAD.newDocument()
    part = doc.addObject("Part::Box", "Box")
    doc.recompute()
    before = set(sys.modules)
    toolpath.create(part)
    try:
        return {
            name for name in set(sys.modules) - before if name.startswith(("freecad_fiveaxis", "MeshPart"))
        }
    finally:
        FreeCADGui.Control.closeDialog()
        FreeCAD.closeDocument(doc.Name)
