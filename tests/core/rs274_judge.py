# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's own interpreter as a judge: where its moves end, in mm and degrees."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

needs_rs274 = pytest.mark.skipif(
    shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"
)
CALL = re.compile(
    r"\d+ N\S*\s+(USE_LENGTH_UNITS|SET_G92_OFFSET|STRAIGHT_FEED|STRAIGHT_TRAVERSE|ARC_FEED|SELECT_PLANE|PROGRAM_END)\(([^)]*)\)"
)
ARC_AXES = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}


@dataclass
class Judged:
    """``ends`` (k, 6) X Y Z A B C of all moves up to the program's end, ``kinds`` of them (rapid, cut, arc),
    the refusal or ''; how far the printed ends may be ``off``: four decimals of millimetres or of inches."""

    ends: np.ndarray
    kinds: list[str]
    refused: str
    off: float


def judged(file: Path, timeout: float = 60) -> Judged:
    """What the interpreter makes of a file."""
    run = subprocess.run(
        ["rs274", "-g", str(file)],
        capture_output=True,
        text=True,
        errors="replace",
        cwd=file.parent,
        env={
            **os.environ,
            "HOME": str(file.parent),
        },  # it keeps its tools there, and two at a time spoil each other's
        timeout=timeout,
        stdin=subprocess.DEVNULL,
    )
    ends, kinds, plane, scale, zero = [], [], "XY", 1.0, np.zeros(6)
    for name, reported in CALL.findall(run.stdout):
        if name == "USE_LENGTH_UNITS":
            scale = 25.4 if "INCHES" in reported else 1.0
        elif name == "SET_G92_OFFSET":  # the moves behind it are told from there
            zero = np.array(_end([float(number) for number in reported.split(",")], name, plane, scale))
        elif name == "SELECT_PLANE":
            plane = reported[-2:]
        elif name == "PROGRAM_END":
            break
        else:
            ends.append(zero + _end([float(number) for number in reported.split(",")], name, plane, scale))
            kinds.append({"STRAIGHT_FEED": "cut", "STRAIGHT_TRAVERSE": "rapid", "ARC_FEED": "arc"}[name])
    off = 1.5e-3 if "UNITS_INCHES" in run.stdout else 2e-4
    return Judged(np.array(ends).reshape(-1, 6), kinds, run.stderr if run.returncode else "", off)


def _end(number: list[float], name: str, plane: str, scale: float) -> list[float]:
    if name == "ARC_FEED":  # ends along the plane's axes, centre, sense, end along the third axis
        where = [0.0] * 3
        for axis, value in zip(ARC_AXES[plane], (number[0], number[1], number[5]), strict=True):
            where[axis] = value
        number = where + number[6:9]
    return [value * (scale if k < 3 else 1.0) for k, value in enumerate(number[:6])]


def moving(ends: np.ndarray, off: float) -> np.ndarray:
    """The rows that differ from the one before."""
    return (
        np.flatnonzero(np.append(True, np.abs(np.diff(ends, axis=0)).max(axis=1) > off))
        if len(ends)
        else np.arange(0)
    )


def difference(words: np.ndarray, message: Judged) -> str:
    """Where the ends (m, 5) X Y Z A C of our blocks, arcs in chords, leave those of the judge; '' where they
    never do."""
    theirs, off = message.ends[:, [0, 1, 2, 3, 5]], message.off
    near = np.flatnonzero(np.abs(theirs[:12] - words[0]).max(axis=1) <= off)
    if not len(near):
        return f"starts at {words[0]}, not {theirs[:3]}"
    row, begin = 0, int(near[0])
    for end, kind in zip(theirs[begin + 1 :], message.kinds[begin + 1 :], strict=True):
        if np.abs(end - words[row]).max() <= off and kind != "arc":
            continue  # no way to go
        ahead = np.flatnonzero(np.abs(words[row + 1 : row + 20001] - end).max(axis=1) <= off)
        if not len(ahead):
            return f"after block {row} at {words[row]} the judge goes to {end} ({kind})"
        if kind != "arc" and np.abs(words[row + 1 : row + 1 + ahead[0]] - words[row]).max(initial=0.0) > off:
            return f"after block {row} at {words[row]} there are more moves before {end}"
        row += 1 + int(ahead[0])
    return (
        f"after block {row} the judge has no more moves"
        if np.abs(words[row:] - words[row]).max() > off
        else ""
    )
