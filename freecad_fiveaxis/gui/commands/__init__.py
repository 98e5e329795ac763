# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of menu and toolbar, one file each, in the order of the work. To add one, write its file and
list it here."""

from __future__ import annotations

from typing import Any

import FreeCADGui

from freecad_fiveaxis.gui.failures import guard_slot

from .annotate import Annotate
from .audit import Audit
from .compare import Compare
from .edit_machine import EditMachine
from .import_machine import ImportMachine
from .job_setup import JobSetup
from .play import Play
from .post_process import PostProcess
from .prove_signs import ProveSigns
from .reach import Reach
from .recover import Recover
from .rest import Rest
from .setup import Setup
from .tessellate import Tessellate
from .toolpath import Toolpath

WORK = (
    (JobSetup, Tessellate, Reach, Toolpath, Setup, Compare),
    (Play, Rest, Annotate),
    (PostProcess, Audit),
)  # fmt: skip
"""The way of a part, in groups: plan, look, write and judge."""
MACHINES = (ProveSigns, Recover, ImportMachine, EditMachine)
"""What is about a machine and needs no part."""
COMMANDS = (*(command for group in WORK for command in group), *MACHINES)
NAMES = [command.NAME for command in COMMANDS]
SEPARATOR = "Separator"
"""FreeCAD's name of a line between commands."""


def work_names() -> list[str]:
    """Return the commands of a part in the order of the work, with a line between the groups."""
    return [name for group in WORK for name in (SEPARATOR, *(command.NAME for command in group))][1:]


def machine_names() -> list[str]:
    """Return the commands about machines."""
    return [command.NAME for command in MACHINES]


def register() -> None:
    """Make the commands known to FreeCAD."""
    for command in COMMANDS:
        instance: Any = command()
        instance.Activated = guard_slot(instance.Activated)
        FreeCADGui.addCommand(command.NAME, instance)
