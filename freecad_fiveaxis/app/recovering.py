# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine that a post had in mind, found from a CL file and the program made of it. No document is
needed, none is changed.

folder    a machine file written to the user's folder of machines (:mod:`machines`) stands in every chooser
          from then on.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.calibration import tasks as workshop
from freecad_fiveaxis.core.pipeline import outputs
from freecad_fiveaxis.core.pipeline.settings import RECOVER, Settings, build_settings

from . import machines, reports
from .long_work import run


def settings_of(cl_file: Any, nc_file: Any, fcm_file: Any, options: Mapping[str, Any]) -> Settings:
    """Return what is asked of the core. ``fcm_file`` None: a new name in the user's folder of machines.
    Raises SettingsError."""
    named = fcm_file if fcm_file else machines.free_file(Path(os.fspath(nc_file)).stem)
    files = {"program": os.fspath(nc_file), "machine_file": os.fspath(named)}
    return build_settings(RECOVER, os.fspath(cl_file), {**options, **files})


def recover(
    cl_file: Any, nc_file: Any, fcm_file: Any, options: Mapping[str, Any], progress: Progress | None = None
) -> workshop.Recovered:
    """Return the machine, not yet written. Raises FiveAxisError for files that cannot be used and for a name
    that is taken."""
    settings = settings_of(cl_file, nc_file, fcm_file, options)
    if not machines.is_new_folder(settings.recover.machine_file):
        outputs.check_outputs(settings)
    return run(lambda progress: workshop.recover_machine(settings, progress), progress)


def write(done: workshop.Recovered) -> str:
    """Write the machine file, never over another one; returns its name. Raises FileError."""
    if file := done.settings.recover.machine_file:
        machines.make_folder(file)
    return workshop.write_outputs(done)[0]


def write_report(done: workshop.Work, file: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Write what was found, as a page (.html), for scripts (.json) or as text (.txt). Raises FileError for a
    file that is there."""
    reports.write_report(workshop.REPORTS, lambda: done, file, overwrite)
