# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shipped machines, each chain once: those with bodies are two of the others with bodies about them."""

from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.machine_file import list_shipped_machines

BARE = tuple(name for name in list_shipped_machines() if not load_machine(name).bodies)
