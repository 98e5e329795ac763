# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's own interpreter as a judge: where its moves end, in mm and degrees."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

needs_rs274 = pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
CALL = re.compile(r"\d+ N\S*\s+(USE_LENGTH_UNITS|STRAIGHT_FEED|STRAIGHT_TRAVERSE|ARC_FEED|SELECT_PLANE|PROGRAM_END)\(([^)]*)\)")
ARC_AXES = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}


def judged(file: Path, timeout: float = 60) -> tuple[np.ndarray, list[str], str]:
    """Ends (k, 6) X Y Z A B C of all moves up to the program's end, what they are (rapid, cut, arc), and the refusal or ''."""
    run = subprocess.run(
        ["rs274", "-g", str(file)],
        capture_output=True,
        text=True,
        errors="replace",
        cwd=file.parent,
        timeout=timeout,
        stdin=subprocess.DEVNULL,
    )
    ends, kinds, plane, scale = [], [], "XY", 1.0
    for name, told in CALL.findall(run.stdout):
        if name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCHES" in told else 1.0
        elif name == "SELECT_PLANE":
            plane = told[-2:]
        elif name == "PROGRAM_END":
            break
        else:
            ends.append(_end([float(number) for number in told.split(",")], name, plane, scale))
            kinds.append({"STRAIGHT_FEED": "cut", "STRAIGHT_TRAVERSE": "rapid", "ARC_FEED": "arc"}[name])
    return np.array(ends).reshape(-1, 6), kinds, run.stderr if run.returncode else ""


def _end(number: list[float], name: str, plane: str, scale: float) -> list[float]:
    if name == "ARC_FEED":  # ends along the plane's axes, centre, sense, end along the third axis
        where = [0.0] * 3
        for axis, value in zip(ARC_AXES[plane], (number[0], number[1], number[5]), strict=True):
            where[axis] = value
        number = where + number[6:9]
    return [value * (scale if k < 3 else 1.0) for k, value in enumerate(number[:6])]


def moving(ends: np.ndarray) -> np.ndarray:
    """The rows that differ from the one before."""
    return np.flatnonzero(np.append(True, np.abs(np.diff(ends, axis=0)).max(axis=1) > 1.5e-4)) if len(ends) else np.arange(0)
