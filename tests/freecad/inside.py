# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given to freecadcmd or freecad as its start file: runs pytest inside it and leaves with pytest's own exit
code.

FreeCAD exits with 0 after an uncaught exception and may run this file twice; its window replaces sys.stdout.
So the code is written to ``$FIVEAXIS_FINISHED`` and given to os._exit, which also spares the dialogs and
crashes of a shut-down. A test that does not end within ``$FIVEAXIS_TEST_LIMIT`` seconds is photographed and
its stack printed; then the process ends. The test that runs is named in ``$FIVEAXIS_AT``; with
``$FIVEAXIS_FROM`` the tests before the one of that name are left out. ``$FIVEAXIS_AGAIN``: see SecondTry.
``$FIVEAXIS_PART``, as 2/3: of the tests in their order, the second of three equal parts.
``$FIVEAXIS_MARKED``: which tests run, by their marks, in the words of pytest's -m.
"""

import faulthandler
import os
import shlex
import subprocess
import sys
import threading
import traceback

import FreeCAD

ROOT = os.environ["FIVEAXIS_ROOT"]
LIMIT = int(os.environ.get("FIVEAXIS_TEST_LIMIT") or 240)
HUNG = 70


class Watch:
    """pytest plugin: ends the process, with picture and stack, when one test takes longer than LIMIT
    seconds."""

    def __init__(self, out, folder):
        self._out, self._folder = out, folder
        self._timer = None

    def _end(self, name):
        print(f"\nfreecad: KILLED, {name} takes longer than {LIMIT} s", file=self._out, flush=True)
        if FreeCAD.GuiUp:
            picture = os.path.join(self._folder, "hung.png")
            subprocess.run(["import", "-window", "root", picture], timeout=20, check=False)
            print(f"freecad: the screen at that time: {picture}", file=self._out, flush=True)
        faulthandler.dump_traceback(file=self._out)
        leave(HUNG)

    def pytest_collection_modifyitems(self, items):
        part, parts = map(int, os.environ.get("FIVEAXIS_PART", "1/1").split("/"))
        items[:] = items[len(items) * (part - 1) // parts : len(items) * part // parts]
        first = os.environ.get("FIVEAXIS_FROM")
        if first:
            del items[: [item.nodeid for item in items].index(first)]

    def pytest_runtest_logstart(self, nodeid, location):
        self.stop()
        with open(os.environ["FIVEAXIS_AT"], "w", encoding="utf-8") as file:
            file.write(nodeid)
        self._timer = threading.Timer(LIMIT, self._end, [nodeid])
        self._timer.daemon = True
        self._timer.start()
        faulthandler.dump_traceback_later(
            LIMIT + 30, exit=True, file=self._out
        )  # for code that keeps Python's lock

    def stop(self):
        """Whoever came to an end is not watched any longer."""
        if self._timer:
            self._timer.cancel()
        faulthandler.cancel_dump_traceback_later()


def leave(code):
    """Say that the tests came to their end, with which code, and end the process at once."""
    with open(os.environ["FIVEAXIS_FINISHED"], "w", encoding="ascii") as file:
        file.write(str(int(code)))
    sys.stdout.flush()
    os._exit(code)


class SecondTry:
    """pytest plugin for the window: a test that fails is tried once more, and said so.

    Real clicks in a real window race with redraws; on a busy machine one may come too early. What fails twice
    has failed. Where ``$FIVEAXIS_AGAIN`` names a file the test's name goes there instead: whoever reads it
    tries again, on a quieter machine.
    """

    def __init__(self, out):
        self._out = out

    def pytest_runtest_protocol(self, item, nextitem):
        from _pytest.runner import runtestprotocol

        item.ihook.pytest_runtest_logstart(nodeid=item.nodeid, location=item.location)
        reports = runtestprotocol(item, nextitem=nextitem, log=False)
        failed, elsewhere = any(report.failed for report in reports), os.environ.get("FIVEAXIS_AGAIN")
        if failed and elsewhere:
            with open(elsewhere, "a", encoding="utf-8") as file:
                file.write("::".join([os.path.relpath(item.path, ROOT), *item.nodeid.split("::")[1:]]) + "\n")
        elif failed:
            first = next(report for report in reports if report.failed)
            print(
                f"\nfreecad: {item.nodeid} failed, tried once more\n{first.longreprtext[-2000:]}",
                file=self._out,
                flush=True,
            )
            item._initrequest()
            reports = runtestprotocol(item, nextitem=nextitem, log=False)
        for report in reports:
            item.ihook.pytest_runtest_logreport(report=report)
        item.ihook.pytest_runtest_logfinish(nodeid=item.nodeid, location=item.location)
        return True


def output_folder():
    """out/freecad/VERSION, where the pictures go."""
    folder = os.path.join(ROOT, "out", "freecad", ".".join(FreeCAD.Version()[:2]))
    os.makedirs(folder, exist_ok=True)
    return folder


def run_pytest(out):
    """pytest's exit code."""
    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.activateWorkbench("FiveAxisWorkbench")
    if os.environ.get("FIVEAXIS_PYTEST"):
        sys.path.insert(0, os.environ["FIVEAXIS_PYTEST"])
    import pytest

    os.chdir(ROOT)
    folder = os.environ["FIVEAXIS_OUT"] = output_folder()
    options = [
        "-c",
        "tests/freecad/pytest.ini",
        "--rootdir",
        ROOT,
        "--confcutdir",
        ROOT,
        *shlex.split(os.environ["FIVEAXIS_PYTEST_ARGUMENTS"]),
        *(["-m", os.environ["FIVEAXIS_MARKED"]] if os.environ.get("FIVEAXIS_MARKED") else []),
    ]
    watch = Watch(out, folder)
    code = pytest.main(options, plugins=[watch, SecondTry(out)] if FreeCAD.GuiUp else [watch])
    watch.stop()
    return code


def main():
    """Whatever happens, leave with a code that tells."""
    out = os.fdopen(os.dup(1), "w", buffering=1)
    sys.stdout = sys.stderr = sys.__stdout__ = sys.__stderr__ = out
    print(
        "freecad:",
        ".".join(FreeCAD.Version()[:2]),
        "Python",
        sys.version.split()[0],
        "window" if FreeCAD.GuiUp else "headless",
    )
    code = HUNG
    faulthandler.enable(file=out)  # where the process was when something inside FreeCAD or Qt aborts it
    try:
        code = run_pytest(out)
    except BaseException:
        traceback.print_exc(file=out)
    leave(code)


if not hasattr(FreeCAD, "fiveaxis_modules_at_start"):
    FreeCAD.fiveaxis_modules_at_start = frozenset(
        sys.modules
    )  # the workbench is open; what it imports later is not start-up
    if FreeCAD.GuiUp:
        from PySide import QtCore

        QtCore.QTimer.singleShot(500, main)
    else:
        main()
