# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the tables and picture of docs/minimax.md: ``.venv/bin/python docs/studies/minimax.py``, from the
project's folder."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import lin_ye_parts as parts
import lin_ye_profiles as profiles
import minimax_cases as cases
import numpy as np

DOCUMENT = Path(__file__).resolve().parents[1] / "minimax.md"
PICTURE = DOCUMENT.parent / "images" / "minimax-tilt.png"
PLACE = re.compile(r"(<!-- table: ([a-z-]+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)
LATTICE = 0.05
"""deg between the leans of the dynamic programme."""

Table = list[str]


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def heading(*cells: str) -> Table:
    return [row(*cells), "|" + "---|" * len(cells)]


def parts_table() -> Table:
    """Largest deviation of the posted program, mm, by part, machine and depth."""
    lines = heading("part, machine", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    for name, part, table, others in (
        ("233 facets, A carrying B", parts.PART, "table_ab", {}),
        ("233 facets, `trunnion_ac`", parts.PART, "trunnion_ac", {}),
        ("half cylinder, one axis turns", "half_cylinder", "table_ab", cases.HALF),
    ):
        result = [cases.part(part, table, depth, **others) for depth in profiles.DEPTHS]
        digits = 5 if part == "half_cylinder" else 3
        lines.append(row(name, *(
            f"{one.deviation.max():.{digits}f} / {two.deviation.max():.{digits}f} "
            f"(**{cases.ratio((one, two)):.1f}**)"
            for one, two in result
        )))  # fmt: skip
    return lines


def optimum_table() -> Table:
    """Profiles on one rotary axis: the gain, and the result in units of the optimum; medians and ranges over
    the seeds."""
    lines = heading(
        "profile",
        "rotary axis",
        "facet_mean, mm",
        "minimax, mm",
        "times smaller",
        "over the lattice's optimum",
    )
    for family in cases.FAMILIES:
        for depth in profiles.DEPTHS:
            result = [cases.profile(family, seed, depth) for seed in cases.SEEDS]
            mean, found = (
                np.array([case.largest(getattr(case, name)) for case in result]) for name in ("mean", "found")
            )
            best = np.array([cases.optimum(case, cases.TILT, LATTICE) for case in result])
            lines.append(row(
                family, profiles.depth_name(depth), f"{np.median(mean):.3f}", f"{np.median(found):.4f}",
                _spread(mean / found, 1),
                _spread(found / best, 2),
            ))  # fmt: skip
    return lines


def _spread(values: Any, digits: int) -> str:
    low, middle, high = np.percentile(values, [0, 50, 100])
    return f"{middle:.{digits}f} ({low:.{digits}f} to {high:.{digits}f})"


TABLES: dict[str, Callable[[], Table]] = {"parts": parts_table, "optimum": optimum_table}


def tables_of(text: str) -> dict[str, Table]:
    """The tables that stand in a document, by name."""
    return {match[2]: match[3].splitlines() for match in PLACE.finditer(text)}


def draw() -> None:
    """Largest deviation over the tilt allowed, rotary axes 150 mm below."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from freecad_fiveaxis.core.report.plot_style import BLUE, GREEN, ORANGE, STYLE, WIDE

    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(WIDE * 0.7, 3.6), layout="constrained")
        for label, part, table, others, colour in (
            ("233 facets, trunnion_ac", parts.PART, "trunnion_ac", {}, ORANGE),
            ("233 facets, A carrying B", parts.PART, "table_ab", {}, BLUE),
            ("half cylinder, one axis turns", "half_cylinder", "table_ab", cases.HALF, GREEN),
        ):
            both = [cases.part(part, table, 150.0, tilt, **others) for tilt in cases.TILTS]
            axes.plot(cases.TILTS, [two.deviation.max() for _, two in both], "o-", color=colour, label=label)
            axes.axhline(both[0][0].deviation.max(), color=colour, linestyle=":")
        axes.set(
            xscale="log", yscale="log", xlabel="largest tilt allowed, deg", ylabel="largest deviation, mm",
            title="Rotary axes 150 mm below; dotted: facet_mean",
        )  # fmt: skip
        axes.set_xticks(cases.TILTS, [f"{tilt:g}" for tilt in cases.TILTS])
        axes.minorticks_off()
        axes.legend(loc="center left", bbox_to_anchor=(0.0, 0.44))
        figure.savefig(PICTURE, dpi=95, metadata={"Software": None})
        plt.close(figure)


def main() -> None:
    text = DOCUMENT.read_text(encoding="utf-8")
    result = PLACE.sub(lambda match: match[1] + "\n".join([*TABLES[match[2]](), match[4]]), text)
    DOCUMENT.write_text(result, encoding="utf-8")
    print(DOCUMENT)
    draw()
    print(PICTURE)


if __name__ == "__main__":
    main()
