# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages and tables in the style of the report, for results that are no single program (setups,
comparisons)."""

from __future__ import annotations

import base64
import json
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.report.html_elements import STYLE
from freecad_fiveaxis.core.report.json_text import plain
from freecad_fiveaxis.core.report.plots import Plot
from freecad_fiveaxis.core.report.text import WIDTH

NO_PLOTS = (
    "The pictures are left out because matplotlib is not installed. To get them: <code>pip "
    "install matplotlib</code>"
)


@dataclass(frozen=True)
class Table:
    """Cells as text: ``head`` and ``rows`` of the same length; the first column names the row."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]


def page(title: str, subtitle: str, verdict: str, mood: str, body: Sequence[str]) -> str:
    """Return a whole page. ``mood`` good, bad or open colours the verdict; ``body`` is HTML, the other texts
    are not."""
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">'
    head += f"<title>{escape(title)}</title><style>{STYLE}</style>"
    top = f"<header><h1>{escape(title)}</h1><p>{escape(subtitle)}</p></header>"
    parts = [top, f'<p class="verdict {mood}">{escape(verdict)}</p>', *(part for part in body if part)]
    main = "\n".join(parts)
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body><main>\n{main}\n</main></body></html>\n'
    )


def json_text(record: object) -> str:
    """Return a record as JSON; bytes of a file name that are no Unicode become escapes, as in the report."""
    text = json.dumps(plain(record), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def section(title: str, content: str) -> str:
    """Return a section of HTML ``content``; nothing where that is empty."""
    return f"<section><h2>{escape(title)}</h2>\n{content}</section>" if content else ""


def table(given: Table) -> str:
    """Return a table as HTML."""
    top = "".join(f'<th scope="col">{escape(cell)}</th>' for cell in given.head)
    rows = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>\n" for row in given.rows
    )
    return (
        '<div class="scroll"><table '
        f'class="numbers"><thead><tr>{top}</tr></thead>\n<tbody>{rows}</tbody></table></div>'
    )


def text_table(given: Table) -> list[str]:
    """Return a table as lines of text, right-aligned but for the first column."""
    cells = [given.head, *given.rows]
    wide = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  ".join(
            [
                row[0].ljust(wide[0]),
                *(cell.rjust(width) for cell, width in zip(row[1:], wide[1:], strict=True)),
            ]
        ).rstrip()
        for row in cells
    ]


def figures(pictures: Sequence[Plot], wanted: bool) -> list[str]:
    """Return the pictures, inside the page; where there are none though ``wanted``, how to get them."""
    if not pictures and wanted:
        return [section("Pictures", f'<p class="note">{NO_PLOTS}</p>')]
    return [
        f'<figure><h2>{escape(plot.title)}</h2><div class="card"><img alt="{escape(plot.alt)}" '
        f'src="data:image/svg+xml;base64,{base64.b64encode(plot.svg).decode()}"></div>'
        f"<figcaption>{escape(plot.caption)}</figcaption></figure>"
        for plot in pictures
    ]


def findings_list(findings: Sequence[Finding]) -> str:
    """Return the findings, one after the other; nothing where there are none."""
    return "".join(
        f'<div class="finding"><p><code>{escape(one.code)}</code> {one.severity.name.lower()}: '
        f"{escape(one.text)}</p></div>\n"
        for one in findings
    )


def findings_text(findings: Sequence[Finding]) -> list[str]:
    """Return the findings as lines of text, indented."""
    texts = (f"{one.severity.name} {one.code}: {one.text}" for one in findings)
    return [
        line
        for one in texts
        for line in textwrap.wrap(one, WIDTH, initial_indent="  ", subsequent_indent="    ")
    ]
