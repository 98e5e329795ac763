# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this when its window starts. It runs it without ``__file__``, and forgets its names: all of it
is in the package."""

from freecad_fiveaxis.gui import workbench

workbench.start()
