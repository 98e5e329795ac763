# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of menu and toolbar, one file each. To add one, write its file and list it here."""

from __future__ import annotations

import FreeCADGui

from freecad_fiveaxis.gui.failures import guarded

from .annotate import Annotate
from .audit import Audit
from .compare import Compare
from .import_machine import ImportMachine
from .left import Left
from .play import Play
from .post_process import PostProcess
from .prove_signs import ProveSigns
from .recover import Recover
from .setup import Setup
from .tessellate import Tessellate
from .toolpath import Toolpath

COMMANDS = (
    Tessellate, Toolpath, Setup, Compare, PostProcess, Annotate, Left, Audit, Play, ProveSigns, Recover, ImportMachine,
)  # fmt: skip
NAMES = [command.NAME for command in COMMANDS]


def register() -> None:
    """Make the commands known to FreeCAD."""
    for command in COMMANDS:
        made = command()
        made.Activated = guarded(made.Activated)
        FreeCADGui.addCommand(command.NAME, made)
