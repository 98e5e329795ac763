# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the tables and pictures of docs/lin-ye.md: ``.venv/bin/python docs/studies/lin_ye.py``, from the project's folder.

A table stands between ``<!-- table: NAME -->`` and ``<!-- end -->`` and is written anew; the prose is left alone.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import lin_ye_arc as arc
import lin_ye_parts as parts
import lin_ye_profiles as profiles
import numpy as np

DOCUMENT = Path(__file__).resolve().parents[1] / "lin-ye.md"
IMAGES = DOCUMENT.parent / "images"
PLACE = re.compile(r"(<!-- table: ([a-z-]+) -->\n).*?(\n<!-- end -->)", re.DOTALL)

Table = list[str]


def heading(*cells: str) -> Table:
    return [row(*cells), "|" + "---|" * len(cells)]


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def profiles_table() -> Table:
    """Random profiles: family by depth."""
    lines = heading("profiles", "rotary axis", "facet_mean, mm", "step_weighted, mm", "ratio", "better on")
    for family in profiles.FAMILIES:
        for depth in profiles.DEPTHS:
            worst = profiles.largest(family, depth)
            (conventional, weighted), ratio = np.median(worst, axis=0), worst[:, 1] / worst[:, 0]
            better = f"{np.count_nonzero(ratio < 1.0)} of {len(ratio)}"
            lines.append(
                row(family, profiles.depth_name(depth), f"{conventional:.3f}", f"{weighted:.3f}", f"{np.median(ratio):.2f}", better)
            )
    return lines


def part_row(part: str, table: str, depth: float | None) -> str:
    """Both methods on one part: whole maxima, ratio, medians, second pass, passes on which step_weighted is better."""
    one, two = (parts.mill(part, table, method, depth) for method in profiles.METHODS)
    better = np.count_nonzero(two.per_pass < one.per_pass)
    return row(
        profiles.depth_name(depth), f"{one.deviation.max():.3f}", f"{two.deviation.max():.3f}",
        f"{two.deviation.max() / one.deviation.max():.2f}", f"{one.median:.4f}", f"{two.median:.4f}",
        f"{one.per_pass[1]:.3f}", f"{two.per_pass[1]:.3f}", f"{better} of {len(one.per_pass)}",
    )  # fmt: skip


def part_table(table: str) -> Table:
    """The 233-facet part on one machine."""
    lines = heading("rotary axes", "max fm", "max sw", "ratio", "median fm", "median sw", "pass 2 fm", "pass 2 sw", "passes better")
    return lines + [part_row(parts.PART, table, depth) for depth in profiles.DEPTHS]


def pass_table() -> Table:
    """Largest deviation of each pass, mm: facet_mean / step_weighted."""
    lines = heading("pass", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    made = [[parts.mill(parts.PART, "table_ab", method, depth).per_pass for method in profiles.METHODS] for depth in profiles.DEPTHS]
    for number in range(len(made[0][0])):
        lines.append(row(str(number + 1), *(f"{one[number]:.3f} / {two[number]:.3f}" for one, two in made)))
    return lines


def others_table() -> Table:
    """Whole maxima of the other parts on both machines."""
    lines = heading("part", "machine", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    for part in parts.OTHERS:
        for table in parts.TABLES:
            cells = []
            for depth in profiles.DEPTHS:
                one, two = (parts.mill(part, table, method, depth).deviation.max() for method in profiles.METHODS)
                cells.append(f"{one:.3f} / {two:.3f} ({two / one:.2f})")
            lines.append(row(part, table, *cells))
    return lines


TABLES: dict[str, Callable[[], Table]] = {
    "steps": arc.steps_table,
    "beta": arc.beta_table,
    "profiles": profiles_table,
    "part-ab": lambda: part_table("table_ab"),
    "part-ac": lambda: part_table("trunnion_ac"),
    "passes": pass_table,
    "others": others_table,
}


def tables_of(text: str) -> dict[str, Table]:
    """The tables that stand in a document, by name."""
    found = {}
    for match in PLACE.finditer(text):
        found[match[2]] = match[0].split("\n")[1:-1]
    return found


def renewed(text: str) -> str:
    """The document with all its tables made anew. Raises KeyError for a table that nobody makes."""
    return PLACE.sub(lambda match: match[1] + "\n".join(TABLES[match[2]]()) + match[3], text)


def main() -> None:
    import lin_ye_pictures

    DOCUMENT.write_text(renewed(DOCUMENT.read_text(encoding="utf-8")), encoding="utf-8")
    print(DOCUMENT)
    for name in lin_ye_pictures.draw_all(IMAGES):
        print(IMAGES / name)


if __name__ == "__main__":
    main()
