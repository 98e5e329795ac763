# SPDX-License-Identifier: LGPL-2.1-or-later
"""The audit of a posted impeller-like program of 100,000 lines, from NC text to the proof, against ``%``
formatting in one run.

The aim is 2 s on a machine that makes 0.5 M ``%`` rows a second: no longer than ``%`` needs for a million
rows. With the CL path, with the part's STL, and with the HTML report it is timed too.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import median_seconds, print_table
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, inverse
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import as_html

LINES, BLADES, STEPS = 100_000, 9, 75
MACHINE = "trunnion_ac"
ALLOWED = 1_000_000
"""Rows of ``%`` in whose time the audit should be done: 2 s at 0.5 M a second."""


def blade_rows(lines: int) -> tuple[Floats, Floats]:
    """Tips, unit axes (about ``lines``, 3): zigzag over the flanks of twisted blades; C turns by more than a
    degree a step."""
    passes = max(1, round(lines / (BLADES * STEPS)))
    even = np.linspace(0.0, 1.0, passes), np.linspace(0.0, 1.0, STEPS)
    blade, height, step = np.meshgrid(np.arange(BLADES), *even, indexing="ij")
    step = np.where(np.arange(passes)[None, :, None] % 2 == 0, step, 1.0 - step)
    turn = (2.0 * np.pi / BLADES * blade + 1.6 * step + 0.15 * height).ravel()
    out = (18.0 + 22.0 * step * step + 14.0 * height * (1.0 - 0.5 * step)).ravel()
    up = (45.0 - 38.0 * step + 6.0 * height * step).ravel()
    lean = np.radians(20.0 + 45.0 * step + 6.0 * np.sin(5.0 * step) * height).ravel()
    tip = np.column_stack([out * np.cos(turn), out * np.sin(turn), up])
    way = turn + 0.3
    return tip, np.column_stack([np.sin(lean) * np.cos(way), np.sin(lean) * np.sin(way), np.cos(lean)])


def posted(kinematics: Chain, tip: Floats, axis: Floats) -> Floats:
    """Words (n, 5) mm and deg, one block a row, as a post without linearization writes them."""
    q = inverse(kinematics, tip, axis)[0][0]
    q[:, 3] = np.unwrap(q[:, 3])
    return np.column_stack([q[:, :3], np.degrees(q[:, 3:])])


def nc_text(letters: str, words: Floats) -> str:
    """Five words and F under G94 in every block."""
    form = "G1 " + " ".join(f"{letter}%.4f" for letter in letters) + " F1200\n"
    first = "G21 G90 G94\nG0" + form[2:-7] % tuple(words[0]) + "\n"
    return first + "".join([form % tuple(row) for row in words.tolist()]) + "M2\n"


def cl_text(tip: Floats, axis: Floats) -> str:
    """Return the CL path that the program was posted from."""
    form = "GOTO/" + ",".join(["%.6f"] * 3 + ["%.7f"] * 3) + "\n"
    rows = np.column_stack([tip, axis]).tolist()
    return "UNITS/MM\nMULTAX/ON\nFEDRAT/1200,MMPM\n" + "".join([form % tuple(row) for row in rows]) + "FINI\n"


def hub(path: Path) -> None:
    """Write an STL of the hub below the blades' feet: a surface of revolution of 20k facets."""
    turns, rows = 200, 50
    turn, step = np.meshgrid(
        np.linspace(0.0, 2.0 * np.pi, turns, endpoint=False), np.linspace(0.0, 1.0, rows)
    )
    out, up = 12.0 + 22.0 * step * step, 44.0 - 40.0 * step
    vertex = np.column_stack([(out * np.cos(turn)).ravel(), (out * np.sin(turn)).ravel(), up.ravel()])
    row = np.arange(turns * rows).reshape(rows, turns)
    a, b, c, d = row[:-1], np.roll(row[:-1], -1, 1), np.roll(row[1:], -1, 1), row[1:]
    write_stl(from_faces(vertex, np.stack([a, d, c, a, c, b], -1).reshape(-1, 3)), path)


def percent_rate(letters: str, words: Floats) -> float:
    """Rows a second of plain ``%`` formatting."""
    form = " ".join(f"{letter}%.4f" for letter in letters) + "\n"
    return len(words) / median_seconds(lambda: "".join([form % tuple(row) for row in words]), 3)


def main(lines: int = LINES) -> float:
    """Print the table; returns the audit's time over that of a million ``%`` rows."""
    machine = load_machine(MACHINE)
    kinematics = chain(machine, Setup(machine.origin))
    tip, axis = blade_rows(lines)
    words = posted(kinematics, tip, axis)
    with tempfile.TemporaryDirectory() as folder:
        nc, cl, stl = (Path(folder) / name for name in ("impeller.ngc", "impeller.apt", "hub.stl"))
        nc.write_text(nc_text(kinematics.letters, words))
        cl.write_text(cl_text(tip, axis))
        hub(stl)
        rate = percent_rate(kinematics.letters, words)
        rows, results = [], {}
        for name, more in (
            ("audit", {}),
            ("against its CL path", {"against": str(cl)}),
            ("against an STL", {"against": str(stl)}),
        ):
            settings = build_settings("audit", str(nc), {"machine": MACHINE, "cutter": "ball:4", **more})
            start = time.perf_counter()
            results["last"] = job.run(settings)
            seconds = time.perf_counter() - start
            if not more:
                seconds = median_seconds(lambda settings=settings: job.run(settings), 3)  # type: ignore[misc]
            rows.append((name, seconds))
            results.setdefault("first", results["last"])
        start = time.perf_counter()
        page = as_html(job.figures(results["first"]))
        rows.append(("its HTML page", time.perf_counter() - start))
    table = [
        (name, f"{s:.2f}", f"{len(words) / s / 1e3:.0f}", f"{s * rate / ALLOWED:.2f}") for name, s in rows
    ]
    heads = ("", "s", "k lines/s", f"of the time of {ALLOWED / 1e6:g} M % rows")
    print_table(
        f"Audit of {len(words)} lines, % {rate / 1e6:.2f} M rows/s, HTML {len(page) / 1e3:.0f} kB",
        heads,
        table,
    )
    return rows[0][1] * rate / ALLOWED


if __name__ == "__main__":
    share = main(*(int(argument) for argument in sys.argv[1:]))
    print(f"audit: {share:.2f} of the time that is allowed")
