# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's Test workbench runs of this add-on; also ``freecadcmd --run-test
freecad_fiveaxis.app.self_test``.

``Init.py`` names this module in ``FreeCAD.__unit_test__``; nothing of it is loaded before somebody asks for
it. The tests in :class:`SelfTest` need nothing but the add-on. Those of ``tests/app`` come along, one case a
file, where FreeCAD's Python has pytest and FreeCAD has no window, for which they are not made.
"""

from __future__ import annotations

import contextlib
import importlib.util
import io
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path

import FreeCAD

ROOT = Path(__file__).resolve().parents[2]
TOLERANCE = 0.01
"""mm; the tolerance of the settings as they come."""


class SelfTest(unittest.TestCase):
    """From a solid to an audited NC file, in a document of its own that is closed afterwards."""

    def setUp(self) -> None:
        """Make a box of 20 x 12 x 6 mm."""
        self.doc = FreeCAD.newDocument("FiveAxisSelfTest")
        self.addCleanup(FreeCAD.closeDocument, self.doc.Name)
        self.box = self.doc.addObject("Part::Box", "Box")
        self.box.Length, self.box.Width, self.box.Height = 20, 12, 6
        self.doc.recompute()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_box_is_milled_posted_and_audited(self) -> None:
        """Every block of the toolpath is within the tolerance, and the audit of the file agrees."""
        from freecad_fiveaxis import app

        path = app.create_toolpath(
            self.doc, self.box, machine="trunnion_ac", cutter="ball:6", stepover=2, tolerance=TOLERANCE
        )
        self.assertGreater(path.Blocks, 10)
        self.assertEqual(path.OverTolerance, 0)
        file = self.folder / "box.ngc"
        app.post_process(path, str(file))
        self.assertIn("\nM2", file.read_text(encoding="ascii"))
        audit = app.audit(self.doc, str(file), machine="trunnion_ac", tolerance=TOLERANCE)
        self.assertGreaterEqual(audit.Blocks, path.Blocks)  # its start and end are blocks too
        self.assertEqual(audit.OverTolerance, 0)

    def test_a_machine_that_is_not_known_is_named(self) -> None:
        """And the document stays as it was."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.core.base.errors import FiveAxisError

        with self.assertRaisesRegex(FiveAxisError, "no_such_machine"):
            app.create_toolpath(self.doc, self.box, machine="no_such_machine", stepover=2)
        self.assertEqual([obj.Name for obj in self.doc.Objects], ["Box"])


def load_tests(
    loader: unittest.TestLoader, tests: unittest.TestSuite, pattern: str | None
) -> unittest.TestSuite:
    """Return the tests of this module and, where they can run, those of ``tests/app``: unittest's own
    protocol."""
    for file in sorted((ROOT / "tests" / "app").glob("test_*.py")):
        tests.addTest(unittest.FunctionTestCase(_by_pytest(file), description=f"tests/app/{file.name}"))
    return tests


def _by_pytest(file: Path) -> Callable[[], None]:
    def run() -> None:
        if FreeCAD.GuiUp:
            raise unittest.SkipTest(f"for FreeCAD without a window: freecadcmd --run-test {__name__}")
        if importlib.util.find_spec("pytest") is None:
            raise unittest.SkipTest("FreeCAD's Python has no pytest")
        import pytest

        output = io.StringIO()  # FreeCAD's own stdout is no file
        options = ["-c", str(ROOT / "tests" / "freecad" / "pytest.ini"), "--rootdir", str(ROOT), "-s"]
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(output):
            code = pytest.main([*options, str(file)])
        if code not in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED):
            raise AssertionError(output.getvalue())

    return run
