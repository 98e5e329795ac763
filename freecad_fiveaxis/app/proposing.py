# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the panel of a new audit proposes: the program that was posted last, and what its tool path knows of
it.

newest    the file that was written last, of those that are still there.
"""

from __future__ import annotations

import os
from collections.abc import Collection
from typing import Any

from freecad_fiveaxis.core.pipeline.settings import MILL

from . import changes
from .nc_output import outputs_of
from .toolpath import Toolpath

TAKEN = ("machine", "controller", "origin", "tool_length", "cutter", "shank", "holder", "tolerance")
"""Options of a tool path that are those of the audit of its program."""


def propose_values(doc: Any, chosen: Collection[Any] = ()) -> dict[str, Any]:
    """Values of a form: those of the file that is ``chosen`` or that a chosen tool path wrote, else of the
    document's newest.

    A tool path that has no file gives its values alone; empty where nothing was posted.
    """
    written = [one for one in outputs_of(doc) if one.Path is not None]
    paths = [one for one in chosen if isinstance(getattr(one, "Proxy", None), Toolpath)]
    meant = [one for one in written if one in chosen or one.Path in paths]
    there = [one for one in meant or written * (not paths) if os.path.isfile(one.File)]
    if there:
        newest = max(there, key=lambda one: os.path.getmtime(one.File))
        return {"nc_file": newest.File} | values_of(newest.Path)
    return values_of(paths[0]) if paths else {}


def values_of(path: Any) -> dict[str, Any]:
    """Return what a tool path says of its program, its part and what holds that among it."""
    options = changes.read_options(path, MILL)
    own = {"work_zero": tuple(path.WorkZero), "part": part_of(path), "fixtures": list(path.Fixtures)}
    return {name: options[name] for name in TAKEN} | own


def part_of(path: Any) -> Any:
    """Return the solid that a tool path is made of, or its mesh where there is no solid; None where that was
    deleted."""
    base = getattr(path.Mesh, "Base", None)
    whole = base[0] if isinstance(base, tuple) else base
    return path.Mesh if whole is None else whole
