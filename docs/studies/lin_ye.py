# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the tables and pictures of docs/lin-ye.md: ``.venv/bin/python docs/studies/lin_ye.py``, from the
project's folder.

A table stands between ``<!-- table: NAME -->`` and ``<!-- end -->`` and is written anew; the prose is left
alone.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import lin_ye_arc as arc
import lin_ye_curvature as curvature
import lin_ye_parts as parts
import lin_ye_profiles as profiles
import numpy as np

DOCUMENT = Path(__file__).resolve().parents[1] / "lin-ye.md"
IMAGES = DOCUMENT.parent / "images"
PLACE = re.compile(r"(<!-- table: ([a-z-]+) -->\n)(.*?)(<!-- end -->)", re.DOTALL)

Table = list[str]


def heading(*cells: str) -> Table:
    return [row(*cells), "|" + "---|" * len(cells)]


def row(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"


def profiles_table() -> Table:
    """Random profiles: family by rig."""
    lines = heading("profiles", "rotary axis", "facet_mean, mm", "step_weighted, mm", "ratio", "better on")
    head = profiles.head()
    for family in profiles.FAMILIES:
        result = {
            profiles.depth_name(depth): profiles.largest_below(family, depth) for depth in profiles.DEPTHS
        }
        result["in the head"] = profiles.largest(family, lambda points: head)
        for name, worst in result.items():
            (conventional, weighted), ratio = np.median(worst, axis=0), worst[:, 1] / worst[:, 0]
            better = f"{np.count_nonzero(ratio < 1.0)} of {len(ratio)}"
            lines.append(
                row(family, name, f"{conventional:.3f}", f"{weighted:.3f}", f"{np.median(ratio):.2f}", better)
            )
    return lines


def finer_table() -> Table:
    """Hills with every step cut into 1, 2 and 4."""
    lines = heading("steps", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    for cuts in (1, 2, 4):
        worst = [np.median(profiles.largest_below("hill", depth, cuts), axis=0) for depth in profiles.DEPTHS]
        lines.append(row(str(cuts * profiles.COUNT), *(f"{one:.4f} / {two:.4f}" for one, two in worst)))
    return lines


def part_table(part: str, table: str) -> Table:
    """Both methods on one part and machine, by depth."""
    lines = heading(
        "rotary axes", "largest, mm", "ratio", "median, mm", "pass 2, mm", "ratio by passes", "passes better"
    )
    for depth in profiles.DEPTHS:
        one, two = (parts.mill(part, table, method, depth) for method in profiles.METHODS)
        ratio = two.per_pass / one.per_pass
        lines.append(row(
            profiles.depth_name(depth), f"{one.deviation.max():.3f} / {two.deviation.max():.3f}",
            f"{two.deviation.max() / one.deviation.max():.2f}", f"{one.median:.4f} / {two.median:.4f}",
            f"{one.per_pass[1]:.3f} / {two.per_pass[1]:.3f}", f"{np.median(ratio):.2f}",
            f"{np.count_nonzero(ratio < 1.0)} of {len(ratio)}",
        ))  # fmt: skip
    return lines


def pass_table() -> Table:
    """Largest deviation of each pass, mm: facet_mean / step_weighted."""
    lines = heading("pass", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    result = [
        [parts.mill(parts.PART, "table_ab", method, depth).per_pass for method in profiles.METHODS]
        for depth in profiles.DEPTHS
    ]
    for number in range(len(result[0][0])):
        lines.append(row(str(number + 1), *(f"{one[number]:.3f} / {two[number]:.3f}" for one, two in result)))
    return lines


def worst_table() -> Table:
    """The worst block of either method on the A-B table: pass, length of the step on the part, and its
    deviation by both."""
    lines = heading("rotary axes", "worst of", "pass", "step, mm", "facet_mean, mm", "step_weighted, mm")
    for depth in profiles.DEPTHS:
        both = [parts.mill(parts.PART, "table_ab", method, depth) for method in profiles.METHODS]
        for method, result in zip(profiles.METHODS, both, strict=True):
            worst = int(result.deviation.argmax())
            same = (
                f"{parts.deviation_at(other, result.start[worst], result.end[worst]):.3f}" for other in both
            )
            lines.append(
                row(
                    profiles.depth_name(depth),
                    method,
                    str(result.pass_[worst]),
                    f"{result.length[worst]:.2f}",
                    *same,
                )
            )
    return lines


def others_table() -> Table:
    """The other parts on both machines: whole maxima, and in brackets the median ratio by passes."""
    lines = heading("part", "machine", *(profiles.depth_name(depth) for depth in profiles.DEPTHS))
    for part in parts.OTHERS:
        for table in parts.TABLES:
            cells = []
            for depth in profiles.DEPTHS:
                one, two = (parts.mill(part, table, method, depth) for method in profiles.METHODS)
                ratio = np.median(two.per_pass / one.per_pass)
                cells.append(f"{one.deviation.max():.4f} / {two.deviation.max():.4f} ({ratio:.2f})")
            lines.append(row(part, table, *cells))
    return lines


def curvature_table() -> Table:
    """Eq. (8) beside the curvature that spaces the passes."""
    return curvature.table(row, heading)


TABLES: dict[str, Callable[[], Table]] = {
    "curvature": curvature_table,
    "steps": arc.steps_table,
    "beta": arc.beta_table,
    "profiles": profiles_table,
    "finer": finer_table,
    "part-ab": lambda: part_table(parts.PART, "table_ab"),
    "part-ac": lambda: part_table(parts.PART, "trunnion_ac"),
    "passes": pass_table,
    "worst": worst_table,
    "others": others_table,
}


def tables_of(text: str) -> dict[str, Table]:
    """The tables that stand in a document, by name."""
    return {match[2]: match[3].splitlines() for match in PLACE.finditer(text)}


def renewed(text: str) -> str:
    """The document with all its tables made anew. Raises KeyError for a table that nobody makes."""
    return PLACE.sub(lambda match: match[1] + "\n".join([*TABLES[match[2]](), match[4]]), text)


def main() -> None:
    import lin_ye_pictures

    DOCUMENT.write_text(renewed(DOCUMENT.read_text(encoding="utf-8")), encoding="utf-8")
    print(DOCUMENT)
    for name in lin_ye_pictures.draw_all(IMAGES):
        print(IMAGES / name)


if __name__ == "__main__":
    main()
