# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines are edited as drafts and written as new files of the user's. No document is needed, none is
changed."""

from __future__ import annotations

import os
from collections.abc import Collection
from typing import Any

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.editing import (
    AttachedMeshes,
    MachineDraft,
    Problem,
    check_draft,
    read_draft,
    save_draft,
)

from . import importing, machines


def open_draft(machine: Any) -> MachineDraft:
    """Return the draft of a machine, by its shipped name or its file. Raises FiveAxisError."""
    return read_draft(os.fspath(machine))


def list_known_names() -> frozenset[str]:
    """Return what the machines of the lists are called."""
    return frozenset(choice.label for choice in machines.choices())


def check(draft: MachineDraft, names: Collection[str] = ()) -> tuple[Machine | None, tuple[Problem, ...]]:
    """Return the machine of a draft, None where it is none yet, and what is wrong or open, errors first.
    ``names``: of other machines."""
    machine, problems = check_draft(draft)
    if draft.name.strip() in names:
        text = say(
            "the lists have a machine called {name}; give this one a name of its own", name=draft.name.strip()
        )
        problems = (*problems, Problem("machine", text, Severity.WARNING))
    return machine, tuple(sorted(problems, key=lambda one: -one.severity))


def write(draft: MachineDraft, fcm_file: Any = None, attached: AttachedMeshes | None = None) -> str:
    """Write the machine file and the meshes ``attached`` to it, never over another file; returns its name.
    None: in the user's folder. Raises FiveAxisError."""
    target = os.fspath(fcm_file) if fcm_file else machines.free_file(draft.name)
    importing.check_target(target)
    machines.make_folder(target)
    save_draft(draft, target, attached)
    return target
