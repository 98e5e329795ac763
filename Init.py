# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this at start-up, with and without a window. Nothing to set up: ``import freecad_fiveaxis.app`` is all a macro needs."""
