# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program that proves a machine's signs before anything is cut, and its sheet. No document is needed,
none is changed."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.calibration import tasks as workshop
from freecad_fiveaxis.core.pipeline import outputs
from freecad_fiveaxis.core.pipeline.settings import PROVE, Settings, build_settings

from . import selection
from .long_work import run


def settings_of(nc_file: Any, options: Mapping[str, Any], sheet: Any = None) -> Settings:
    """Return what is asked of the core. Raises SettingsError."""
    files = {"output": os.fspath(nc_file), "report": [os.fspath(sheet)] if sheet else []}
    return build_settings(PROVE, "", {**options, **files})


def prove(
    nc_file: Any, options: Mapping[str, Any], sheet: Any = None, progress: Progress | None = None
) -> workshop.Proof:
    """Program and sheet, not yet written. Raises FiveAxisError where the limits leave no room."""
    settings = settings_of(nc_file, options, sheet)
    outputs.check_outputs(settings)
    return run(lambda progress: workshop.prove(settings, progress), progress)


def top_of(objects: Iterable[Any]) -> float | None:
    """Return the highest Z of the solids and meshes among the objects, mm in the document; None where there
    is none."""
    solids = [one.Shape for one in objects if getattr(getattr(one, "Shape", None), "Solids", ())]
    meshes = [
        mesh
        for one in objects
        if selection.is_mesh(one) and (mesh := selection.copy_of_mesh(one)).CountFacets
    ]
    return max((shape.BoundBox.ZMax for shape in (*solids, *meshes)), default=None)


def targets(done: workshop.Proof) -> list[str]:
    """Return the files that ``write`` writes."""
    output = done.settings.output
    return [name for name in (output.output, *output.report) if name]


def write(done: workshop.Proof, overwrite: bool = False) -> list[str]:
    """Write program and sheet; returns their names. Raises FileError for a file that is there, unless
    ``overwrite``."""
    there = [] if overwrite else [name for name in targets(done) if os.path.lexists(name)]
    if there:
        raise FileError(
            say("{file} exists; choose another name, or ask for it to be overwritten", file=there[0]),
            there[0],
        )
    return workshop.write_outputs(done)
