# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this at start-up, with and without a window. ``import freecad_fiveaxis.app`` is all a macro
needs; what is set up here is the name of our tests for FreeCAD's Test workbench, which loads them when it is
asked to."""

import FreeCAD

FreeCAD.__unit_test__ += ["freecad_fiveaxis.app.self_test"]
