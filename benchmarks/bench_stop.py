# SPDX-License-Identifier: LGPL-2.1-or-later
"""How soon a long ``mill`` ends after Ctrl+C, at several places of its work, as a share of the one second
that it may take.

Run: ``python benchmarks/bench_stop.py [seconds ...]``: after how many each is stopped. The target is less
than the whole of it.
"""

from __future__ import annotations

import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from timing import print_table

ROOT = Path(__file__).parents[1]

WORDS = ["--machine", "trunnion_ac", "--scallop", "0.002", "--cutter", "ball:4"]
MOST = 1.0
"""s from the signal to the end."""


def hear_ctrl_c() -> None:
    """Hear SIGINT again, since a process takes over what its parent ignores: SIGINT behind an ampersand."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def seconds_to_stop(part: Path, after: float) -> float:
    """From SIGINT, sent ``after`` seconds of work, to the end of the process."""
    words = [
        sys.executable,
        "-m",
        "freecad_fiveaxis",
        "mill",
        str(part),
        *WORDS,
        "-o",
        str(part.with_suffix(".ngc")),
    ]
    with subprocess.Popen(words, stderr=subprocess.DEVNULL, cwd=ROOT, preexec_fn=hear_ctrl_c) as mill:
        time.sleep(after)
        sent = time.perf_counter()
        mill.send_signal(signal.SIGINT)
        if mill.wait(timeout=60) != 130:
            sys.exit(f"stopped after {after:g} s the mill ended with {mill.returncode}, not with 130")
    return time.perf_counter() - sent


def main(*after: float) -> float:
    """Print the table of times; returns the longest as a share of what it may take."""
    sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "core")]
    from gouge_examples import blade_beside_hub

    from freecad_fiveaxis.core.geometry.mesh import write_stl

    with tempfile.TemporaryDirectory() as folder:
        part = Path(folder) / "part.stl"
        write_stl(blade_beside_hub(cells=120), part)
        taken = {one: seconds_to_stop(part, one) for one in after or (2.0, 3.5, 5.0, 8.0, 12.0)}
    rows = [(f"{one:g}", f"{took:.2f}", f"{took / MOST:.2f}") for one, took in taken.items()]
    print_table("mill, stopped by Ctrl+C", ("after s", "s to the end", "share"), rows)
    longest = max(taken.values()) / MOST
    print(f"  target below 1: {'reached' if longest < 1.0 else 'MISSED'}")
    return longest


if __name__ == "__main__":
    main(*(float(argument) for argument in sys.argv[1:]))
