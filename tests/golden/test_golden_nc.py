# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC files that must not change by one byte unless somebody means it.

To renew them after a wanted change: ``python tests/golden/test_golden_nc.py`` and read the difference before
it is committed.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine import BY_CLEARANCE, BY_MACHINE, BY_REFERENCE, Axis, Machine, SafeStart
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import build_program
from freecad_fiveaxis.core.nc.head import PostOptions
from freecad_fiveaxis.core.nc.start import with_start
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

HERE = Path(__file__).parent
CASES = [
    (name, mode, "", "")
    for name, dialect in DIALECTS.items()
    for mode in ("g93", "g94")
    if mode == "g94" or dialect.inverse_time
]
CASES += [(name, "g94", how, "") for name, dialect in DIALECTS.items() for how in dialect.guides]
CASES += [
    (name, "g93", how, "")
    for name, dialect in DIALECTS.items()
    if dialect.inverse_time
    for how in dialect.guides
]
CASES += [(name, "g94", "", retract) for name in DIALECTS for retract in (BY_REFERENCE, BY_CLEARANCE)]
CASES += [(name, "g94", "angles", BY_CLEARANCE) for name, dialect in DIALECTS.items() if dialect.guides]
"""Name of the dialect, feed mode, guide, and how Z retracts where that is not to a machine coordinate."""
PLANE = 95.0


def golden_file(name: str, mode: str, how: str = "", retract: str = "") -> Path:
    return HERE / f"{'_'.join(filter(None, (name, mode, how, retract)))}.nc"


def golden_text(name: str, mode: str, how: str = "", retract: str = "") -> bytes:
    """A retract, an approach, a cut with both table axes, a turn about the tip, a block of nothing, and a
    rapid away."""
    linear = [
        Axis(letter, False, "head", tuple(row), max_rate=8000.0)
        for letter, row in zip("XYZ", np.eye(3), strict=True)
    ]
    c = Axis("C", True, "table", (0, 0, 1), max_rate=float(np.radians(7200.0)))
    a = Axis("A", True, "table", (1, 0, 0), (0, 0, -50), max_rate=float(np.radians(3600.0)))
    kinematics = chain(Machine("trunnion", (c, a, *linear)), Setup())
    words = np.array(
        [
            [0, 0, 80, 0, 0], [10, -5, 80, 30, -20], [10, -5, 12.5, 30, -20], [11.25, -5.125, 12.4375, 31.5, -19.75],
            [12.5, -5.25, 12.375, 33, -19.5], [12.50001, -5.25, 12.375, 33, -19.5], [12.5, -5.25, 12.375, 93, -19.5],
            [-12.5, -5.25, 12.375, 93, -19.5], [-12.5, -5.25, 80, 93, 0],
        ]
    )  # fmt: skip
    q = np.concatenate([words[:, :3], np.radians(words[:, 3:])], axis=1)
    tip, axis = forward(kinematics, q)
    r, link, cut, fill = Motion.RAPID, Motion.LINK, Motion.CUT, Motion.FILL
    motion = np.array([r, r, link, cut, fill, cut, cut, cut, r], np.int8)
    feed = np.where(motion == r, 0.0, np.where(motion == link, 300.0, 1000.0))
    none = np.full(len(q), -1)
    path = CLPath(tip, axis, motion, feed, tip, axis, none, none, none)
    joints = JointPath(path, np.arange(len(q)), q, np.zeros(len(q), np.int8), np.ones(len(q)))
    dialect = with_start(DIALECTS[name], SafeStart(retract) if retract else SafeStart(BY_MACHINE, -1.0))
    dialect = dialect.guide_by(how) if how else dialect
    program = build_program(joints, kinematics, dialect, mode == "g93")
    options = PostOptions(tool=2, speed=12000, coolant=True, cutter="ball 10 mm", length=120.0)
    return write_nc(program, dialect, "golden", options, height=PLANE)


@pytest.mark.parametrize(("name", "mode", "how", "retract"), CASES)
def test_the_nc_file_has_not_changed_by_one_byte(name: str, mode: str, how: str, retract: str) -> None:
    assert golden_text(name, mode, how, retract) == golden_file(name, mode, how, retract).read_bytes()


def test_every_golden_file_belongs_to_a_case() -> None:
    assert sorted(HERE.glob("*.nc")) == sorted(golden_file(*case) for case in CASES)


@pytest.mark.parametrize("at", [0, 100, -3])
def test_the_comparison_sees_one_changed_byte(at: int) -> None:
    golden = bytearray(golden_file("linuxcnc", "g93").read_bytes())
    golden[at] ^= 1
    assert golden_text("linuxcnc", "g93") != bytes(golden)


if __name__ == "__main__":
    for case in CASES:
        golden_file(*case).write_bytes(golden_text(*case))
