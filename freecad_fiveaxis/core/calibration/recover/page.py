# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of a recovered machine: one sentence, text, JSON and a page."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping
from html import escape

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.studies.setup_map.sheet import (
    Table,
    findings_list,
    json_text,
    page,
    section,
    table,
    text_table,
)

from .parameters import Parameter, parameters
from .recovery import Recovery
from .verdicts import describe

VERSION = 1
"""Of the JSON record: raised when a key changes its meaning."""
WIDTH = 100


def verdict(found: Recovery) -> str:
    """One plain sentence: which machine, and how well it explains the rows."""
    fit = found.fit
    worst = float(fit.miss[fit.good].max(initial=0.0))
    text = say(
        "The post had in mind: {layout}. It explains {count} of {all} rows within {worst}.",
        layout=describe(fit.layout),
        count=int(fit.good.sum()),
        all=len(fit.good),
        worst=Length(worst, ".2g"),
    )
    if found.start is None:
        return text
    same = not any(one.code == Code.POST_AND_MACHINE_DIFFER for one in found.findings)
    name = found.start.name
    return text + (
        say(" {name} is that machine.", name=name) if same else say(" {name} is another machine.", name=name)
    )


def recovery_text(found: Recovery) -> str:
    """For the terminal: the sentence, the parameters, the findings."""
    lines = [*textwrap.wrap(verdict(found), WIDTH), "", *text_table(_table(found)), ""]
    for one in found.findings:
        summary_line = f"{one.severity.name} {one.code}: {one.text}"
        lines += textwrap.wrap(summary_line, WIDTH, initial_indent="  ", subsequent_indent="    ")
    return "\n".join(lines) + "\n"


def recovery_json(found: Recovery, inputs: Mapping[str, object] | None = None) -> str:
    """For scripts: mm, degrees. Keys: version, layout (kind, letters, directions), parameters, rows, scale,
    largest_miss, left_out (NC lines), others, start_miss, findings, inputs (a job file)."""
    fit, layout = found.fit, found.fit.layout
    record = {
        "version": VERSION,
        "layout": _layout_record(found),
        "parameters": [vars(one) | {"determined": one.determined} for one in parameters(found)],
        "rows": len(fit.good),
        "rows_used": int(fit.good.sum()),
        "scale": fit.scale,
        "largest_miss": float(fit.miss[fit.good].max(initial=0.0)),
        "left_out": found.pairs.line[~fit.good],
        "others": [describe(other.layout) for other in found.others],
        "start": None if found.start is None else found.start.name,
        "start_miss": found.start_miss,
        "points": {axis.letter: axis.point for axis in found.machine.rotary},
        "letters": layout.letters,
        "findings": found.findings,
        "inputs": inputs or {},
    }
    return json_text(record)


def _layout_record(found: Recovery) -> dict[str, object]:
    layout = found.fit.layout
    ways = dict(zip(layout.letters, (layout.direction1, layout.direction2), strict=True))
    return {"kind": layout.kind, "letters": layout.letters, "directions": ways}


def recovery_html(found: Recovery, title: str = "") -> str:
    """As one page that needs nothing else."""
    bad = any(one.severity == Severity.ERROR for one in found.findings)
    body = [
        section("Parameters", table(_table(found)) + f'<p class="note">{escape(NOTE)}</p>'),
        section("Findings", findings_list(found.findings)),
        section("The words used here", WORDS),
    ]
    return page(
        "The machine that the post had in mind", title, verdict(found), "bad" if bad else "good", body
    )


NOTE = (
    "Certain within: the true value lies that near in 95 of 100 cases, by the rounding of the printed "
    "digits and the residuals. The last column: were the zeros of all words unknown too."
)


def _table(found: Recovery) -> Table:
    rows = parameters(found)
    given = any(one.given is not None for one in rows)
    head = [
        "parameter",
        "value",
        "certain within",
        "were zeros unknown",
        *(["machine given", "apart"] if given else []),
    ]
    return Table(head, [_cells(one, given) for one in rows])


def _cells(one: Parameter, given: bool) -> list[str]:
    value = f"{round(one.value, 4) + 0.0:.4f} {one.unit}"
    fixed = "taken as 0" if not one.fitted else f"{one.certainty:.2g}" if one.determined else "not determined"
    free = f"{one.certainty_free:.2g}" if math.isfinite(one.certainty_free) else "not determined"
    more = ["-", "-"] if one.given is None else [f"{one.given:.4f}", f"{one.apart:.4f}"]
    return [one.name, value if one.fitted or one.value else "0", fixed, free, *(more if given else [])]


WORDS = """<dl><dt>Line</dt><dd>The line about which a rotary axis turns, with all words at zero: its coordinates across its
direction, in the machine's frame as in the machine file. Along its direction any point will do.</dd>
<dt>Zero</dt><dd>The word at which the axis stands where the CL path's zero takes it to be.</dd>
<dt>Layout</dt><dd>Which rotary axis is nearer to the work, which carry the table, which the tool, and which way they turn.</dd>
<dt>Row</dt><dd>One tip and tool axis of the CL path with the five words of the program that go with it.</dd></dl>"""  # noqa: E501
