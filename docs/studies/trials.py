# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the tables of docs/setup.md and docs/compare.md and the picture of the former: ``python
docs/studies/trials.py``.

A table stands between ``<!-- table: NAME -->`` and ``<!-- end -->`` and is written anew; the prose is left
alone.
"""

from __future__ import annotations

import re
import runpy
from functools import cache
from pathlib import Path

import numpy as np

from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report.text import duration
from freecad_fiveaxis.core.studies.setup_map import pictures
from freecad_fiveaxis.core.studies.study import SetupTrial, try_machines, try_setups

DOCS = Path(__file__).resolve().parents[1]
PLACE = re.compile(r"(<!-- table: ([a-z-]+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
STEPOVER, LENGTH = 3.0, 120.0
DPI = 95


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def heading(*cells: str) -> list[str]:
    return [row(*cells), "|" + "---|" * len(cells)]


@cache
def mesh(name: str) -> Mesh:
    parts = runpy.run_path(str(DOCS.parent / "resources" / "examples" / "make_parts.py"))
    return from_faces(*parts[name]())


@cache
def setup(part: str, machine: str, turns: int = 1, grid: str = "3,1,1") -> SetupTrial:
    """100 mm off the machine's own work zero along X, with room to go back there."""
    given = {
        "machine": machine,
        "passes": "planes",
        "stepover": STEPOVER,
        "tool_length": LENGTH,
        "origin": (100.0, 0.0, 0.0),
    }
    return try_setups(build_settings("setup", part, given | {"grid": grid, "turns": turns}), mesh=mesh(part))


def setups() -> list[str]:
    lines = heading(
        "part",
        "machine",
        "100 mm off in X",
        "own work zero",
        "recommended",
        "proven least",
        "recommended X, Y, Z",
    )
    for part in ("dome", "saddle", "blade", "freeform_233"):
        for machine in ("trunnion_ac", "head_b_table_c"):
            chart = setup(part, machine).chart
            own, best = int(np.flatnonzero(chart.origin[1:4, 0] == 0.0)[0]) + 1, chart.best
            assert best is not None
            place = ", ".join(f"{value + 0.0:.1f}" for value in chart.origin[best])
            values = [f"{value:.3f}" for value in (*chart.max_deviation[[0, own, best]], chart.least)]
            lines.append(row(part, machine, *values, place))
    return lines


def turns() -> list[str]:
    lines = heading("turn, deg", "least deviation, mm", "rotary travel, deg", "time")
    chart = setup("blade", "trunnion_ac", 4, "1,1,1").chart
    for at in np.flatnonzero(chart.kind == 2):
        turn, travel = np.degrees([chart.turn[at], chart.rotary_travel[at]])
        lines.append(
            row(
                f"{turn:g}",
                f"{chart.max_deviation[at]:.3f}",
                f"{travel:.0f}",
                duration(float(chart.time[at])),
            )
        )
    return lines


def machines() -> list[str]:
    lines = heading("machine", "tip guided", "deviation, mm", "blocks", "time", "peak X Y Z, mm/min")
    names = "trunnion_ac,trunnion_bc,mikron_ucp710,nutating_table_b45,head_b_table_c,fork_head_bc"
    given = {
        "machines": names,
        "passes": "planes",
        "stepover": STEPOVER,
        "tool_length": LENGTH,
        "cures": "none",
        "gouge": "off",
    }
    for one in try_machines(build_settings("compare", "dome", given), mesh=mesh("dome")).rows:
        guided, peak = "yes" if one.tool_centre else "no", max(one.peak_rate[:3])
        lines.append(
            row(
                one.machine,
                guided,
                "ends only" if one.tool_centre else f"{one.deviation:.3f}",
                str(one.blocks),
                duration(one.time),
                f"{peak:.0f}",
            )
        )
    return lines


def _filled(found: re.Match[str]) -> str:
    return found[1] + "\n".join([*TABLES[found[2]](), found[4]])


TABLES = {"setups": setups, "turns": turns, "machines": machines}


def picture() -> None:
    """The dome's map along X and Y, at the stepover whose passes go by the pole."""
    given = {
        "machine": "trunnion_ac",
        "passes": "planes",
        "stepover": 2.0,
        "origin": (100.0, 0.0, -30.0),
        "grid": "9,9,1",
    }
    for reported, figure in pictures(
        try_setups(build_settings("setup", "dome", given), mesh=mesh("dome")).chart
    ):
        figure.savefig(DOCS / "images" / f"setup-{reported[0]}.png", dpi=DPI, metadata={"Software": None})


def main() -> None:
    for name in ("setup.md", "compare.md"):
        page = DOCS / name
        page.write_text(PLACE.sub(_filled, page.read_text(encoding="utf-8")), encoding="utf-8")
    picture()


if __name__ == "__main__":
    main()
