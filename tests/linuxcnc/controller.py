# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's whole controller without hardware, screen or realtime kernel, for a machine with trt kinematics.

The configuration is an ordinary one (switchable kinematics: M429 identity, as it starts; M428 the machine's
own) so that it can be imported as a machine too. Joint positions are sampled in every servo cycle, 1 ms.
Cycles are counted, not timed: on a machine with five other programs at work the same program gave the same
joints in every cycle, to the last bit; they only came later.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import pwd
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
OWN_LOCK = Path(tempfile.gettempdir()) / "fiveaxis-linuxcnc.lock"
LINUXCNC_LOCK = Path("/tmp/linuxcnc.lock")
"""The controller's own: its shared memory has fixed keys, so only one can run on a computer."""
PATIENCE = 300.0
"""Seconds to wait for another LinuxCNC on this computer."""
TOOL, LENGTH = 2, 87.5
"""The tool in the controller's table, and its length, mm."""
SWITCH = "o<{code}remap>sub\n  M68 E3 Q{kind}\n  M66 E0 L0\no<{code}remap>endsub\nM2\n"

HEAD = """[EMC]
VERSION = 1.1
MACHINE = ring {kinematics}
[DISPLAY]
DISPLAY = {display}
[RS274NGC]
PARAMETER_FILE = ring.var
SUBROUTINE_PATH = .
HAL_PIN_VARS = 1
REMAP = M428 modalgroup=10 ngc=428remap
REMAP = M429 modalgroup=10 ngc=429remap
[KINS]
KINEMATICS = {kinematics} sparm=identityfirst
JOINTS = 5
[HAL]
HALFILE = ring.hal
[TRAJ]
COORDINATES = {letters}
LINEAR_UNITS = mm
ANGULAR_UNITS = deg
MAX_LINEAR_VELOCITY = 500
MAX_ANGULAR_VELOCITY = 500
DEFAULT_LINEAR_ACCELERATION = 5000
MAX_LINEAR_ACCELERATION = 5000
[EMCMOT]
EMCMOT = motmod
SERVO_PERIOD = 1000000
COMM_TIMEOUT = 4
[TASK]
TASK = milltask
CYCLE_TIME = 0.001
[EMCIO]
EMCIO = io
CYCLE_TIME = 0.05
TOOL_TABLE = ring.tbl
"""
AXIS = """[AXIS_{letter}]
MIN_LIMIT = -{limit}
MAX_LIMIT = {limit}
MAX_VELOCITY = 500
MAX_ACCELERATION = 5000
[JOINT_{joint}]
TYPE = {kind}
HOME = 0
MIN_LIMIT = -{limit}
MAX_LIMIT = {limit}
MAX_VELOCITY = 500
MAX_ACCELERATION = 5000
HOME_SEARCH_VEL = 0
HOME_SEQUENCE = 0
FERROR = 1000
MIN_FERROR = 1000
"""


@lru_cache
def missing() -> str:
    """Why the controller cannot run here; empty where it can."""
    if sys.platform != "linux" or shutil.which("linuxcnc") is None or shutil.which("halsampler") is None:
        return "LinuxCNC is not installed (Debian: linuxcnc-uspace)"
    found = subprocess.run(["/usr/bin/python3", "-c", "import linuxcnc"], capture_output=True, timeout=60)
    return "" if found.returncode == 0 else "the system's Python has no module linuxcnc"


def write_configuration(folder: Path, kinematics: str, pins: dict[str, float]) -> Path:
    """The configuration's ini file, with its HAL and its switching subroutines beside it."""
    letters = kinematics.split("-")[0].upper()
    ini = HEAD.format(kinematics=kinematics, display=folder / "drive.py", letters=letters)
    for joint, letter in enumerate(letters):
        kind, limit = ("LINEAR", 2000) if letter in "XYZ" else ("ANGULAR", 36000)
        ini += AXIS.format(letter=letter, joint=joint, kind=kind, limit=limit)
    (folder / "ring.ini").write_text(ini)
    (folder / "ring.hal").write_text(_hal(kinematics, pins))
    (folder / "ring.tbl").write_text(f"T{TOOL} P{TOOL} Z{LENGTH} D10\n")
    for code, kind in ((428, 1), (429, 0)):
        (folder / f"{code}remap.ngc").write_text(SWITCH.format(code=code, kind=kind))
    shutil.copy(HERE / "drive.py", folder / "drive.py")
    (folder / "drive.py").write_text("#!/usr/bin/python3\n" + (folder / "drive.py").read_text())
    (folder / "drive.py").chmod(0o755)
    return folder / "ring.ini"


def _hal(kinematics: str, pins: dict[str, float]) -> str:
    lines = [
        f"loadrt {kinematics} sparm=identityfirst",
        "loadrt motmod servo_period_nsec=1000000 num_joints=5",
        "loadrt sampler depth=100000 cfg=sfffff",
        *(
            f"addf {name} servo-thread"
            for name in ("motion-command-handler", "motion-controller", "sampler.0")
        ),
        "net line motion.program-line => sampler.0.pin.0",
        "net kinds motion.analog-out-03 => motion.switchkins-type",
        "net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in",
        "net prepare iocontrol.0.tool-prepare => iocontrol.0.tool-prepared",
        "net change iocontrol.0.tool-change => iocontrol.0.tool-changed",
        *(f"net loop{k} joint.{k}.motor-pos-cmd => joint.{k}.motor-pos-fb" for k in range(5)),
        *(f"net at{k} joint.{k}.pos-cmd => sampler.0.pin.{k + 1}" for k in range(5)),
        f"net length motion.tooloffset.z => {kinematics}.tool-offset",
        *(f"setp {kinematics}.{pin} {value}" for pin, value in pins.items()),
    ]
    return "\n".join(lines) + "\n"


def run_programs(kinematics: str, pins: dict[str, float], programs: list[str]) -> list[np.ndarray]:
    """Run each program on the whole controller; of each the samples (n, 6): line, and joints as the
    controller has them (mm, deg).

    Raises AssertionError with what the controller says where it refuses one.
    """
    with _only_one(), _folder() as folder:
        ini = write_configuration(folder, kinematics, pins)
        orders = []
        for k, text in enumerate(programs):
            (folder / f"{k}.ngc").write_text(text)
            orders.append({"program": str(folder / f"{k}.ngc"), "samples": str(folder / f"{k}.txt")})
        (folder / "orders.json").write_text(json.dumps(orders))
        log = _run(folder, ini)
        assert (folder / "results.json").exists(), (
            f"the controller did not start or did not end: {log[-2000:]}"
        )
        results = json.loads((folder / "results.json").read_text())
        assert not any(results), f"the controller says: {results}"
        return [
            np.loadtxt(order["samples"], usecols=range(1, 7), ndmin=2, comments="overrun") for order in orders
        ]


def _run(folder: Path, ini: Path) -> str:
    """Run the controller; as nobody where we are root, which it refuses to run as."""
    who: dict[str, object] = {}
    if os.geteuid() == 0:
        nobody = pwd.getpwnam("nobody")
        who = {"user": nobody.pw_uid, "group": nobody.pw_gid, "extra_groups": []}
        for path in (folder, *folder.iterdir()):
            os.chown(path, nobody.pw_uid, nobody.pw_gid)
    environment = {"HOME": str(folder), "PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "USER": "nobody"}
    with open(folder / "log.txt", "w") as log:
        controller = subprocess.Popen(
            ["linuxcnc", str(ini)], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
            start_new_session=True, **who
        )  # fmt: skip
        try:
            controller.wait(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            pass
        finally:  # also after Ctrl-C, which does not reach its session
            if controller.poll() is None:
                os.killpg(controller.pid, signal.SIGTERM)
                controller.wait(timeout=30)
    return (folder / "log.txt").read_text()


@contextlib.contextmanager
def _folder() -> Iterator[Path]:
    """A folder that every user can reach (pytest's own are the user's alone)."""
    folder = Path(tempfile.mkdtemp(prefix="fiveaxis-linuxcnc-"))
    try:
        folder.chmod(0o755)
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@contextlib.contextmanager
def _only_one() -> Iterator[None]:
    """Wait until no LinuxCNC runs here, and keep ours alone."""
    with open(OWN_LOCK, "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        end = time.monotonic() + PATIENCE
        while LINUXCNC_LOCK.exists() and time.monotonic() < end:
            time.sleep(0.5)
        assert not LINUXCNC_LOCK.exists(), f"another LinuxCNC runs here; if none does, remove {LINUXCNC_LOCK}"
        yield
