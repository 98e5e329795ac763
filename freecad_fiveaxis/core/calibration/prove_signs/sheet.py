# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet for whoever stands at the machine: what must be seen at each stop, and what a wrong sign looks
like there."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from html import escape

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.sentences import Length, Sentence, say
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.studies.setup_map.sheet import (
    Table,
    findings_list,
    json_text,
    page,
    section,
    table,
    text_table,
)

from .plan import Plan

VERSION = 1
"""Of the JSON record: raised when a key changes its meaning."""
WIDTH = 100
STAND = say(
    "Right is +X of the machine, back is +Y (away from you), up is +Z. If your machine's axes point "
    "elsewhere, stand so that they do."
)
READY = (
    say("Spindle off and locked; no cutter that can hurt: a pointed rod of the tool's length."),
    say("Work offset and tool length set as for the real program; tool centre point control off."),
    say(
        "Feed override at its lowest, single block on, a hand on feed hold. The program waits (M0) after "
        "every line below."
    ),
    say("Jog the tool high above the part, rotary axes at 0, before the first line."),
)
STYLE = "<style>@media print{section{break-inside:avoid}} td{white-space:normal;text-align:left}</style>"


def verdict(plan: Plan) -> Sentence:
    """One plain sentence."""
    return say(
        "At every stop compare what you see with this sheet, and stop for good if it differs. The tip stays "
        "at least {gap} above "
        "the level of the mark, even if a rotary axis turns the wrong way or the two are exchanged.",
        gap=Length(plan.wishes.gap),
    )


def notices(plan: Plan) -> list[str]:
    """Return what stands on the sheet's first line: that nobody has said how high part and clamps reach."""
    return [one.text for one in plan.findings if one.code == Code.MARK_NOT_GIVEN]


def rows(plan: Plan, program: Program) -> list[dict[str, object]]:
    """One for each stop: number, title, line, words (mm and degrees), see, bad."""
    ends = np.cumsum([len(stop.q) for stop in plan.stops]) - 1
    shown = [(stop, int(end)) for stop, end in zip(plan.stops, ends, strict=True) if stop.see]
    return [
        {
            "number": number, "title": stop.title, "line": int(program.line[end]),
            "words": dict(zip(program.letters, program.words[end].tolist(), strict=True)), "see": stop.see,
            "bad": stop.bad,
        }
        for number, (stop, end) in enumerate(shown, 1)
    ]  # fmt: skip


def sheet_text(plan: Plan, program: Program) -> str:
    """For the terminal, or to print."""
    first = [line for one in notices(plan) for line in (*textwrap.wrap(one, WIDTH), "")]
    lines = [
        *first,
        *textwrap.wrap(verdict(plan), WIDTH),
        "",
        *textwrap.wrap(STAND, WIDTH),
        "",
        "Before you start",
    ]
    lines += [
        part
        for one in READY
        for part in textwrap.wrap(one, WIDTH, initial_indent="  - ", subsequent_indent="    ")
    ]
    for row in rows(plan, program):
        lines += [
            "",
            f"[ ] stop {row['number']}, line {row['line']}: {row['title']}",
            f"    {_words(row['words'])}",
        ]
        for name, key in (("see  ", "see"), ("wrong", "bad")):
            lines += textwrap.wrap(
                f"{row[key]}", WIDTH, initial_indent=f"    {name}: ", subsequent_indent=" " * 11
            )
    lines += [
        "",
        "At the last stop, in the part's own directions, the tip would stand off the right place by",
        *text_table(_tabulate_predictions(plan)),
    ]
    for one in plan.findings:
        subtitle = f"{one.severity.name} {one.code}: {one.text}"
        lines += textwrap.wrap(subtitle, WIDTH, initial_indent="  ", subsequent_indent="    ")
    return "\n".join(lines) + "\n"


def sheet_json(plan: Plan, program: Program, inputs: Mapping[str, object] | None = None) -> str:
    """For scripts: mm, degrees. Keys: version, machine, height, distance, stops (as rows), foretold,
    findings, inputs."""
    record = {
        "version": VERSION, "machine": plan.machine.name, "height": plan.height, "distance": plan.distance,
        "stops": rows(plan, program),
        "foretold": [{"wrong": text, "off": off} for text, off in plan.predicted_errors],
        "findings": plan.findings, "inputs": inputs or {},
    }  # fmt: skip
    return json_text(record)


def sheet_html(plan: Plan, program: Program) -> str:
    """One page, to print: a box to tick for each stop."""
    head = ("", "stop", "line", "position", "you must see", "if not")
    cells = [
        [
            "\u2610",
            f"{row['number']}: {row['title']}",
            str(row["line"]),
            _words(row["words"]),
            str(row["see"]),
            str(row["bad"]),
        ]
        for row in rows(plan, program)
    ]
    ready = "<ul>" + "".join(f"<li>{escape(one)}</li>" for one in READY) + "</ul>"
    note = "In the part's own directions, counted from where the tip should stand."
    body = [
        STYLE,
        section("Before you start", ready + f"<p>{escape(STAND)}</p>"),
        section("Stops", table(Table(head, cells))),
        section(
            "If the tool does not point at the cross",
            f'<p class="note">{note}</p>' + table(_tabulate_predictions(plan)),
        ),
        section("Findings", findings_list(plan.findings)),
    ]
    warnings, subtitle = notices(plan), f"{plan.machine.name}, before anything is cut"
    return page(
        "Proving the signs",
        subtitle,
        " ".join([*warnings, verdict(plan)]),
        "bad" if warnings else "open",
        body,
    )


def _words(words: object) -> str:
    assert isinstance(words, dict)
    return " ".join(f"{letter}{value + 0.0:.4f}".rstrip("0").rstrip(".") for letter, value in words.items())


def _tabulate_predictions(plan: Plan) -> Table:
    head = ("if", "X, mm", "Y, mm", "Z, mm", "together, mm")
    cells = [
        [text, *(f"{value + 0.0:.1f}" for value in off.tolist()), f"{float(np.linalg.norm(off)):.1f}"]
        for text, off in plan.predicted_errors
    ]
    return Table(head, cells)
