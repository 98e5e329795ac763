# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the groups of settings are made of: the tasks, the limits that no number goes beyond, and the field
itself.

task      ``mill``: from an STL to a program; ``post``: from a CL file to a program; ``audit``: a finished
          program; ``setup`` and ``compare``: from an STL or a CL file to many programs, of which one is to be
          chosen; ``reach``: from an STL to where the tool gets; ``recover``: from a CL file and
          its program to the machine; ``prove-signs``: from a machine to a program that proves its signs (no
          source).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from typing import Any

MILL, POST, AUDIT, SETUP, COMPARE = "mill", "post", "audit", "setup", "compare"
RECOVER, PROVE, REACH = "recover", "prove-signs", "reach"
TASKS = (MILL, POST, AUDIT, SETUP, COMPARE, REACH, RECOVER, PROVE)
TRIALS, WORKSHOP = (SETUP, COMPARE, REACH), (RECOVER, PROVE)
"""Tasks that try many jobs, and those that make no program of a part: a package of its own each, loaded for
them alone."""
WITHOUT_SOURCE = (PROVE,)
FROM_SOLID = (MILL, SETUP, COMPARE)
FROM_PATH = (MILL, POST, SETUP, COMPARE)
ONE_PROGRAM = (MILL, POST, AUDIT)

RENAMED = {"left": "rest"}
"""Former names of options, and those of today: scripts, job files and macros that have them are taken as
before."""

LONGEST = 1e6
"""mm; a length, a coordinate or a number of a vector beyond this is a slip of the pen."""
SMALLEST = 1e-6
"""mm; a tolerance or an interval below this is less than any rounding of words, and would divide without
end."""
NEAREST = 1e-3
"""mm; no clearance is less than the step of a machine."""
FARTHEST = 1e4
"""mm; no machine has more room for its rapids."""
WIDEST_LEAD = 100.0
"""mm; an arc of a larger radius is longer than most passes."""
SLOWEST, FASTEST = 1e-3, 1e6
"""mm/min; what a feed can be."""


def option(
    default: Any,
    kind: str,
    text: str,
    tasks: tuple[str, ...] = FROM_SOLID,
    *,
    choices: tuple[str, ...] = (),
    least: float = -math.inf,
    most: float = math.inf,
    above: float = -math.inf,
    bare: str = "",
    by_task: Mapping[str, Any] | None = None,
) -> Any:
    """Return a field of a settings dataclass. ``kind``: how it is read (core/pipeline/option_values.py); the
    range is in the core's units.
    ``bare``: what the option means on the command line without a value, and as ``true`` in a job file;
    ``by_task``: the default in a task that has one of its own."""
    metadata = {
        "kind": kind,
        "text": text,
        "tasks": tasks,
        "choices": choices,
        "least": least,
        "most": most,
        "above": above,
    }
    return field(default=default, metadata=metadata | {"bare": bare, "by_task": dict(by_task or {})})
