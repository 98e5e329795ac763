# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report for the terminal: the verdict and its grounds, the figures, the worst blocks first, the findings
in full."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from freecad_fiveaxis.core.base.findings import Finding

from .audited import audit_facts
from .ends import state_ends
from .figures import Figures, summary, table_of_deviations
from .part_facts import part_facts, part_verdict
from .scope import scope
from .verdict import find_largest_judged, verdict

WIDTH = 100
"""Columns of the text report."""
NAMED = 3
"""So many findings of one kind are written out; the JSON report has all."""


def as_text(figures: Figures) -> str:
    """Return the report for the terminal, at most WIDTH columns, worst blocks first."""
    numbers: dict[str, Any] = summary(figures)
    parts = [
        [
            *_wrap(f"{figures.title}: {figures.kind} on {figures.machine.name}"),
            *_wrap(verdict(figures, numbers).text),
            "",
            *_wrap(path_verdict(figures, numbers)),
            *_on_part(figures, numbers),
        ],
        _scope_lines(figures, numbers),
        _worst_lines(figures),
        _facts(numbers),
        [*_axis_lines(numbers["axes"]), *_wrap(state_ends(numbers), "  ")],
        _finding_lines(figures.findings),
    ]
    return "\n\n".join("\n".join(part) for part in parts if part) + "\n"


def _on_part(figures: Figures, numbers: Mapping[str, Any]) -> list[str]:
    return [line for sentences, _ in part_verdict(numbers, figures.tolerance) for line in _wrap(sentences)]


def _scope_lines(figures: Figures, numbers: Mapping[str, Any]) -> list[str]:
    lines = ["What the verdict rests on"]
    for name, sentences in scope(figures, numbers).named:
        lines += [line for one in sentences for line in _wrap(f"{name.lower()}: {one}", "  ")]
    return lines


def path_verdict(figures: Figures, numbers: Mapping[str, Any]) -> str:
    """One plain sentence: does the program keep to its path? ``numbers``: the summary."""
    limit, feeds, over = f"{figures.tolerance:g} mm", numbers["feed_blocks"], numbers["over_tolerance"]
    if not feeds:
        return "Nothing to prove: the program has no feed blocks."
    if over:
        share = "1 block leaves" if over == 1 else f"{over} of {feeds} feed blocks leave"
        worst = f"line {numbers['worst_line']}, by {find_largest_judged(numbers)[0]:.4g} mm"
        return f"{share} the commanded path by more than {limit}; the worst, {worst}."
    if guided := numbers["guided_blocks"]:
        which = f"all {feeds}" if guided == feeds else f"{guided} of {feeds}"
        rest = (
            ""
            if guided == feeds
            else f" The other {feeds - guided} were not found to leave theirs by more than {limit}."
        )
        return (
            f"Only block end points are verified in {which} feed blocks: the path between them is under "
            "RTCP, so the controller "
            f"answers for it.{rest}"
        )
    if numbers["unproven"]:
        return (
            f"Not proven: no block was found to leave its commanded segment by more than {limit}, but for "
            f"{numbers['unproven']} of {feeds} feed blocks the proven bound does not exclude it."
        )
    whole = (
        "The one feed block does not leave its"
        if feeds == 1
        else f"None of the {feeds} feed blocks leaves its"
    )
    deviation, bound = find_largest_judged(numbers)
    whose = "" if numbers["max_surface_deviation"] is None else " of the ball's centre"
    largest = f"largest deviation{whose} {deviation:.4g} mm, proven bound {bound:.4g} mm"
    return f"{whole} commanded segment by more than {limit}, and that is proven ({largest})."


def group_findings(findings: Sequence[Finding]) -> list[tuple[Finding, ...]]:
    """Return findings of one code together, the gravest first, in the order in which they came."""
    first = {one.code: at for at, one in reversed(list(enumerate(findings)))}
    ordered = sorted(findings, key=lambda one: (-one.severity, first[one.code]))
    return [tuple(group) for _, group in groupby(ordered, key=lambda one: (one.severity, one.code))]


def duration(seconds: float) -> str:
    """As "1 h 02 min 03 s"; below a minute with one decimal."""
    if seconds < 60.0:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes:02} min {rest:02} s" if hours else f"{minutes} min {rest:02} s"


def number(value: float | None, decimals: int) -> str:
    """Return a fixed-point number, or "-" where there is none or no limit."""
    return (
        f"{round(value, decimals) + 0.0:.{decimals}f}" if value is not None and math.isfinite(value) else "-"
    )


def facts(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the summary as pairs of name and value with unit, the most wanted first."""
    turned = ", ".join(f"{letter} {value:.1f} deg" for letter, value in numbers["rotary_travel_deg"].items())
    guided = (
        [("blocks whose tip the controller guides", f"{numbers['guided_blocks']}")]
        if numbers["guided_blocks"]
        else []
    )
    return [
        *guided,
        ("tolerance", f"{numbers['tolerance']:g} mm"),
        *(
            _not_measured()
            if numbers["guided_blocks"] == numbers["feed_blocks"] > 0
            else _deviations(numbers)
        ),
        ("largest deviation of a rapid", f"{numbers['max_rapid_deviation']:.4f} mm"),
        ("blocks near the pole", f"{numbers['singular_blocks']}"),
        ("blocks", f"{numbers['blocks']}, of them {numbers['feed_blocks']} at feed"),
        ("passes, length cut", f"{numbers['passes']}, {numbers['cut_length']:.1f} mm"),
        ("length of links, of rapids", f"{numbers['link_length']:.1f} mm, {numbers['rapid_length']:.1f} mm"),
        ("time", f"{duration(numbers['time_s'])} ({_shares(numbers['time_shares'])})"),
        ("rotary travel", turned),
        *_name_unfinished(numbers),
        *audit_facts(numbers),
        *part_facts(numbers, numbers["tolerance"]),
    ]


def _name_unfinished(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the share that stays unfinished, and what of it is out of reach, left by the settings, missed;
    nothing where all is finished or nothing known."""
    parts = numbers.get("unfinished_parts")
    if parts is None or not numbers["unfinished_share"]:
        return []
    whole, (beyond, left, missed) = (
        100.0 * numbers["unfinished_share"],
        (100.0 * one for one in parts.values()),
    )
    by_why = f"out of reach {beyond:.1f} %, left by the settings {left:.1f} %, missed {missed:.1f} %"
    return [("stays unfinished", f"{whole:.1f} % ({by_why})")]


def _not_measured() -> list[tuple[str, str]]:
    """Return the same where the controller guides the tip in all feed blocks: a zero would be taken for a
    proof."""
    return [
        (
            "largest deviation from the segment",
            "- (the controller guides the tip: only block ends are verified)",
        )
    ]


def _deviations(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return what is judged (:func:`_state_judged`), and the others."""
    others = [
        ("blocks over tolerance", f"{numbers['over_tolerance']} of {numbers['feed_blocks']}"),
        (
            "largest deviation from the infinite line",
            f"{numbers['max_line_deviation']:.6f} mm" + _name_line(numbers, "max_line_deviation"),
        ),
        ("largest deviation of the tool axis", f"{numbers['max_axis_deviation_deg']:.4f} deg"),
    ]
    return _state_judged(numbers) + others


def _state_judged(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return what is judged, with its bound and line; where that is a ball's centre the tip's deviation after
    it."""
    worst = "" if numbers["worst_line"] is None else f" (NC line {numbers['worst_line']})"
    deviation, bound = (f"{value:.6f} mm" for value in find_largest_judged(numbers))
    if numbers["max_surface_deviation"] is None:
        return [("largest deviation from the segment", deviation + worst), ("its proven upper bound", bound)]
    return [
        ("largest deviation of the ball's centre", deviation + worst),
        ("its proven upper bound", bound),
        (
            "largest deviation of the tip",
            f"{numbers['max_segment_deviation']:.6f} mm" + _name_line(numbers, "max_segment_deviation"),
        ),
    ]


def _name_line(numbers: Mapping[str, Any], name: str) -> str:
    """As " (NC line 7)": where the number of that name is; nothing where it is 0."""
    line = numbers["worst_lines"][name]
    return "" if line is None else f" (NC line {line})"


def _shares(shares: Mapping[str, float]) -> str:
    """As "cut 65 %, link 28 %, rapid 7 %"."""
    return ", ".join(f"{kind} {100.0 * share:.0f} %" for kind, share in shares.items())


def _wrap(text: str, indent: str = "") -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent=indent, subsequent_indent=indent) or [""]


def _facts(numbers: Mapping[str, Any]) -> list[str]:
    rows = facts(numbers)
    wide = max(len(name) for name, _ in rows)
    return [line for name, value in rows for line in _wrap(f"{name:<{wide}}  {value}", "  ")]


def _worst_lines(figures: Figures) -> list[str]:
    rows = table_of_deviations(figures)
    if not rows:
        return []
    letters = list(rows[0]["turn_deg"])
    ball = figures.surface is not None
    head = ["NC line", "motion", "deviation", "bound", "tip dev." if ball else "line dev.", "axis dev."]
    names = ("segment_deviation", "bound", "line_deviation")
    names = ("surface_deviation", "surface_bound", "segment_deviation") if ball else names
    table = [[*head, *(f"{letter} turns" for letter in letters), "near pole"]]
    for row in rows:
        values = [number(row[name], 6) for name in names]
        turns = [number(row["turn_deg"][letter], 3) for letter in letters]
        near = "yes" if row["singular"] else "no"
        table.append(
            [str(row["line"]), row["motion"], *values, number(row["axis_deviation_deg"], 4), *turns, near]
        )
    whose = " of the ball's centre" if ball else ""
    return [
        f"Worst blocks, the largest deviation{whose} from the commanded segment first (mm, deg):",
        *_columns(table),
    ]


def _axis_lines(axes: Mapping[str, Mapping[str, Any]]) -> list[str]:
    table = [["axis", "from", "to", "limits", "", "travel", "peak rate", "max rate"]]
    for letter, row in axes.items():
        spans = [number(row[name], 3) for name in ("least", "largest", "low_limit", "high_limit")]
        rates = [number(row[name], 1) for name in ("travel", "peak_rate", "max_rate")]
        table.append([f"{letter} {row['unit']}", *spans, *rates])
    return ["Axes (rates per minute; the peak is over feed blocks):", *_columns(table)]


def _columns(table: Sequence[Sequence[str]]) -> list[str]:
    """Right-aligned columns."""
    wide = [max(len(cell) for cell in column) for column in zip(*table, strict=True)]
    return [
        "  " + "  ".join(cell.rjust(width) for cell, width in zip(row, wide, strict=True)) for row in table
    ]


def _finding_lines(findings: Sequence[Finding]) -> list[str]:
    if not findings:
        return ["No findings."]
    lines = ["Findings:"]
    for group in group_findings(findings):
        count = f" ({len(group)})" if len(group) > 1 else ""
        lines += _wrap(f"{group[0].severity.name} {group[0].code}{count}", "  ")
        for one in group[:NAMED]:
            lines += _wrap(one.text, "    ")
        if len(group) > NAMED:
            lines += _wrap(f"... and {len(group) - NAMED} more in the JSON and HTML reports.", "    ")
    return lines
