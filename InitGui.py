# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this when its window starts: it makes the workbench known and imports nothing heavy.

FreeCAD executes this file without ``__file__``, and its top-level names are gone when the methods run: whatever a method
needs it imports itself, and paths come from the package.
"""

import FreeCADGui


class FiveAxisWorkbench(FreeCADGui.Workbench):
    """Five-axis tool paths with a proven deviation for every block."""

    MenuText = "Five-axis"
    ToolTip = "Five-axis tool paths with a proven deviation for every block"

    def __init__(self):
        import os

        import freecad_fiveaxis

        root = os.path.dirname(os.path.dirname(freecad_fiveaxis.__file__))
        self.__class__.Icon = os.path.join(root, "resources", "icons", "fiveaxis.svg")

    def Initialize(self):
        """The commands of the window are not part of this version; the command line does all of the work."""

    def Activated(self):
        """Say where the work is done as yet."""
        import FreeCAD

        FreeCAD.Console.PrintMessage(
            "Five-axis: this version works on the command line, outside the window. "
            "Export the solid as STL, then: python -m freecad_fiveaxis mill PART.stl --machine trunnion_ac -o PART.ngc\n"
        )

    def GetClassName(self):
        """The C++ class behind a workbench that is written in Python."""
        return "Gui::PythonWorkbench"


FreeCADGui.addWorkbench(FiveAxisWorkbench())
