# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a batch that are no facets yet: STEP, IGES, BREP and FreeCAD documents, meshed by a FreeCAD
without a window.

part      ``blade.step``; of a document the only solid, or the one that is named behind it:
          ``jig.FCStd:Blade`` (label or name).
program   ``freecadcmd`` of the PATH, or the one that FIVEAXIS_FREECAD names; it runs
          :mod:`freecad_fiveaxis.app.mesher`.

A process that makes several jobs of one part keeps its mesh.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import freecad_fiveaxis
from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl

DOCUMENT = ".fcstd"
ENDINGS = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", DOCUMENT)
LINEAR, ANGULAR = 0.02, 15.0
"""mm, deg: the deflections of the mesh, those that the window takes where nothing is asked."""
PROGRAM = "FIVEAXIS_FREECAD"
NAMES = ("freecadcmd", "FreeCADCmd", "freecadcmd-python3", "FreeCADCmd.exe", "freecadcmd.exe")
FOLDER, TASK, MESH, OUTCOME = "FIVEAXIS_MESHER", "task.json", "mesh.stl", "made.json"
"""What :mod:`freecad_fiveaxis.app.mesher` reads and leaves."""
LONGEST = 1800.0
"""s that one part may take."""
TICK = 0.1
"""s between two looks at the process."""
KEPT = 4
"""Meshes that a process keeps."""
NAMED = re.compile(r"(.+\.fcstd):(.+)", re.IGNORECASE | re.DOTALL)


@dataclass(frozen=True)
class Solid:
    """``file``, and the solid in it that is meant: ``named`` by label or name, empty for the only one."""

    file: str
    named: str = ""

    @property
    def is_meshed_first(self) -> bool:
        """Whether FreeCAD has to mesh it."""
        return self.file.lower().endswith(ENDINGS)


def read_part(text: str) -> Solid:
    """Tell the file from the solid that is named behind it."""
    found = NAMED.fullmatch(text)
    return Solid(found[1], found[2]) if found else Solid(text)


def find_freecad() -> str:
    """Name the FreeCAD that meshes. Raises SettingsError where there is none."""
    given = os.environ.get(PROGRAM, "")
    program = shutil.which(given) if given else next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        text = say(
            "a part that is no STL needs FreeCAD, and {given} is no program here; install FreeCAD, name its "
            "freecadcmd in {variable}, or give the part as STL",
            given=given or NAMES[0], variable=PROGRAM,
        )  # fmt: skip
        raise SettingsError(text, given)
    return program


def mesh_solid(part: Solid, progress: Progress = silent) -> Mesh:
    """Mesh a part, mm, LINEAR and ANGULAR at most off its surface. Raises SettingsError where there is no
    FreeCAD, FileError for a file without one solid that is meant; what ``progress`` raises ends the
    process."""
    try:
        at = os.stat(part.file)
    except OSError as error:
        raise FileError(
            say("part {file} cannot be read: {strerror}", file=part.file, strerror=error.strerror), part.file
        ) from error
    key = part, at.st_mtime_ns, at.st_size
    if key not in _kept:
        meshed = _mesh(part, progress)
        while len(_kept) >= KEPT:
            _kept.pop(next(iter(_kept)), None)
        _kept[key] = meshed
    return _kept[key]


_kept: dict[tuple[Solid, int, int], Mesh] = {}
"""By the part, and when its file was changed and how large it was; the oldest first."""


def _mesh(part: Solid, progress: Progress) -> Mesh:
    program = find_freecad()
    with tempfile.TemporaryDirectory(prefix="fiveaxis", ignore_cleanup_errors=True) as folder:
        task = {"file": os.path.abspath(part.file), "named": part.named, "linear": LINEAR, "angular": ANGULAR}
        (Path(folder) / TASK).write_text(json.dumps(task), encoding="ascii")
        _run(program, folder, progress)
        _check_outcome(Path(folder) / OUTCOME, part)
        return read_stl(Path(folder) / MESH, progress)


def _check_outcome(file: Path, part: Solid) -> None:
    ended = {"error": "FreeCAD ended before it was meshed"}
    outcome = json.loads(file.read_text(encoding="ascii")) if file.is_file() else ended
    if "error" in outcome:
        name = part.file + (f":{part.named}" if part.named else "")
        raise FileError(
            say("part {file} cannot be meshed: {reason}", file=name, reason=str(outcome["error"])), part.file
        )


def script() -> str:
    """Name what FreeCAD runs."""
    return str(Path(str(freecad_fiveaxis.__file__)).parent / "app" / "mesher.py")


def _run(program: str, folder: str, progress: Progress) -> None:
    """Run FreeCAD to its end; whatever is raised meanwhile ends it. It is a new user's: no other add-on is
    loaded."""
    environment = {**os.environ, FOLDER: folder, "FREECAD_USER_HOME": folder, "QT_QPA_PLATFORM": "offscreen"}
    flags, nothing = 0, subprocess.DEVNULL
    if sys.platform == "win32":
        flags = subprocess.CREATE_NO_WINDOW
    process = subprocess.Popen(
        [program, script()],
        env=environment,
        cwd=folder,
        stdin=nothing,
        stdout=nothing,
        stderr=nothing,
        creationflags=flags,
    )
    due = time.monotonic() + LONGEST
    try:
        while process.poll() is None and time.monotonic() < due:
            progress("tessellate", 0.0)
            time.sleep(TICK)
    finally:
        process.kill()
        process.wait()
