# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of the page: blocks, entries into the part, axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .figures import Figures, table_of_deviations, worst_of_audit
from .html_elements import section, table
from .part_facts import deepest_entries
from .text import number

BALL = ("ball's centre off its segment, mm", "its proven bound, mm")
"""The columns of what is judged where that is not the tip; the deviation after them is then the tip's."""

BALL_FIRST = " of the ball's centre"


def worst_blocks(figures: Figures) -> str:
    """Return the blocks with the largest deviations."""
    rows = table_of_deviations(figures)
    if not rows:
        return ""
    letters, ball = list(rows[0]["turn_deg"]), figures.surface is not None
    head = [
        "NC line",
        "motion",
        *BALL[: 2 * ball],
        "deviation, mm",
        "at u",
        "proven bound, mm",
        "line deviation, mm",
        "axis deviation, deg",
    ]
    head += [f"{letter} turns, deg" for letter in letters] + ["near the pole", "place X Y Z, mm"]
    return table(
        head,
        [
            [
                str(row["line"]),
                row["motion"],
                *(number(row[name], 6) for name in ("surface_deviation", "surface_bound")[: 2 * ball]),
                number(row["segment_deviation"], 6),
                number(row["u_segment"], 4),
                number(row["bound"], 6),
                number(row["line_deviation"], 6),
                number(row["axis_deviation_deg"], 4),
                *(number(row["turn_deg"][letter], 3) for letter in letters),
                "yes" if row["singular"] else "no",
                " ".join(number(value, 3) for value in row["place"]),
            ]
            for row in rows
        ],
        f"The largest deviation{BALL_FIRST * ball} from the commanded segment first.",
    )


def entries(figures: Figures) -> str:
    """Return the deepest places."""
    if figures.gouge is None:
        return ""
    rows = deepest_entries(figures.program, figures.gouge)
    if not rows:
        return "<p>Nowhere.</p>"
    head = ["kind", "what", "depth, mm", "proven bound, mm", "NC line", "block", "at u", "place X Y Z, mm"]
    return table(
        head,
        [
            [
                row["kind"], row["part"], number(row["depth"], 4), number(row["bound"], 4), str(row["line"]),
                str(row["block"]),
                number(row["u"], 3), " ".join(number(value, 3) for value in row["place"]),
            ]
            for row in rows
        ],
        "The deepest places; of neighbouring blocks that all enter only the deepest is told.",
    )  # fmt: skip


HEADINGS = {
    "deviation": "The worst lines by deviation: what they say, and what they ask of the axes",
    "limits": "The worst lines beyond a limit",
    "rates": "The worst lines that ask more of an axis than it can",
    "off": "The worst lines off the CL path, or in the part",
}


def audit_sections(figures: Figures) -> list[str]:
    """Return the worst lines of an audit, by each kind of trouble that there is."""
    if figures.audit is None:
        return []
    tables = {"deviation": table_of_deviations(figures)} | worst_of_audit(figures)
    return [section(HEADINGS[name], _option_table(rows)) for name, rows in tables.items() if rows]


def _option_table(rows: Sequence[Mapping[str, Any]]) -> str:
    letters = list(rows[0]["rate"])
    head = [
        "NC line",
        "words",
        "F",
        "deviation, mm",
        "proven bound, mm",
        "feed over the part",
        *(f"{one} rate" for one in letters),
    ]
    head += ["share of the largest rate", "beyond a limit", "off path or in part, mm", "its bound, mm"]
    return table(
        head,
        [
            [
                str(row["line"]),
                " ".join(f"{letter}{number(value, 4)}" for letter, value in row["words"].items()),
                number(row["feed"], 3),
                number(row["segment_deviation"], 6),
                number(row["bound"], 6),
                number(row["tip_feed"], 1),
                *(number(row["rate"][letter], 1) for letter in letters),
                f"{row['rate_axis']} {row['rate_ratio']:.3g}",
                number(row["limit_excess"], 4),
                number(row["off"], 6),
                number(row["off_bound"], 6),
            ]
            for row in rows
        ],
        "Words and excess in mm and deg, feeds and rates in mm/min and deg/min. A feed of 0: a rapid, or no "
        "time is known.",
    )


def axes_table(axes: Mapping[str, Mapping[str, Any]]) -> str:
    """Return how far and how fast each axis goes."""
    head = ["axis", "from", "to", "low limit", "high limit", "total travel", "peak rate", "max rate"]
    fields = ("least", "largest", "low_limit", "high_limit")
    rates = ("travel", "peak_rate", "max_rate")
    rows = [
        [
            f"{letter}, {row['unit']}",
            *(number(row[name], 3) for name in fields),
            *(number(row[name], 1) for name in rates),
        ]
        for letter, row in axes.items()
    ]
    return table(
        head,
        rows,
        "Rates are per minute; the peak is the largest mean over a feed block. A dash: no limit is known.",
    )
