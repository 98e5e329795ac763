# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the meshes of a machine's bodies are written: beside the machine's file, named after both, over no
file."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator
from itertools import count
from pathlib import Path

from freecad_fiveaxis.core.base.files import plain_name

SUFFIX = ".stl"


def free_mesh_file(target: Path, body: str, taken: Collection[str] = ()) -> str:
    """Name an STL file for a ``body`` of the machine file ``target`` that neither is there nor ``taken``."""
    used = {name.casefold() for name in taken}
    return next(
        name for name in _names(target, body) if name.casefold() not in used and not os.path.lexists(name)
    )


def _names(target: Path, body: str) -> Iterator[str]:
    stem = plain_name(f"{target.stem} {body}", "body")
    for number in count(1):
        yield str(target.absolute().parent / f"{stem}{f'-{number}' if number > 1 else ''}{SUFFIX}")
