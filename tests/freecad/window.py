# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside the FreeCAD window: the workbench is listed, becomes active, and imports nothing heavy; a screenshot is kept."""

import os
import subprocess
import sys
import time

import FreeCAD
import FreeCADGui
from PySide import QtCore

sys.path.insert(0, os.path.join(os.environ["FIVEAXIS_ROOT"], "tests", "freecad"))
import checks


def pump(seconds):
    """Let the window work for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtCore.QCoreApplication.processEvents()
        time.sleep(0.005)


def the_workbench_is_listed_with_its_icon():
    bench = FreeCADGui.listWorkbenches()["FiveAxisWorkbench"]
    assert os.path.isfile(bench.Icon), bench.Icon


def the_workbench_becomes_active():
    FreeCADGui.activateWorkbench("FiveAxisWorkbench")
    pump(0.5)
    assert FreeCADGui.activeWorkbench().__class__.__name__ == "FiveAxisWorkbench"


def the_core_is_not_imported_at_start_up():
    assert not [name for name in sys.modules if name.startswith("freecad_fiveaxis.core")]


def a_screenshot_shows_the_window():
    version = ".".join(FreeCAD.Version()[:2])
    path = os.path.join(os.environ["FIVEAXIS_OUT"], f"window-{version}.png")
    pump(0.5)
    subprocess.run(["import", "-window", "root", path], check=True)
    assert os.path.getsize(path) > 5000


def main():
    sys.stdout = sys.stderr = os.fdopen(os.dup(1), "w", buffering=1)
    FreeCADGui.getMainWindow().resize(1590, 990)
    checks.run_and_exit(
        [
            the_workbench_is_listed_with_its_icon, the_workbench_becomes_active, the_core_is_not_imported_at_start_up,
            a_screenshot_shows_the_window,
        ]
    )  # fmt: skip


if not getattr(FreeCAD, "fiveaxis_window_test", False):  # 0.20 runs a file again that raised
    FreeCAD.fiveaxis_window_test = True
    QtCore.QTimer.singleShot(500, main)
