# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as one HTML page that needs nothing else: no network, no scripts, pictures inside.

Every text that comes from outside (titles, findings, inputs) is escaped. The same input gives the same bytes.
"""

from __future__ import annotations

import base64
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent

from .figures import Figures, summary, worst_of_audit, worst_table
from .json_text import plain
from .part_facts import deepest_entries, part_verdict
from .plots import Plot, plots
from .rest_material_picture import rest_svg
from .scope import Scope, scope
from .text import facts, group_findings, number, path_verdict
from .verdict import Light, verdict

NAMED = 11
"""So many findings of one kind are written out: the one for all and the worst ten."""

GLOSSARY = {
    "Block": "One line of the NC program that moves the machine: all axes start together, move evenly, and "
    "arrive together.",
    "Commanded segment, chord": "The straight line from the tip's place at one block's end to that at the "
    "next.",
    "Deviation": (
        "The largest distance between the tip's real path and the commanded segment while a block runs. "
        "Where rotary axes turn, "
        "axes that move evenly carry the tip along a curve, although both ends are right."
    ),
    "Deviation of the ball's centre": (
        "The same of the centre of a ball: its way, not the tip's, makes the surface. Where the tool axis "
        "swings, a tip that runs straight makes the centre bulge. Where the centre is known it is judged, "
        "and the tip's deviation is told beside it."
    ),
    "Proven bound": "A number that the deviation cannot exceed anywhere in the block, by calculation and not "
    "by sampling.",
    "Line deviation": (
        "The distance from the infinite line through both ends. It overlooks a tip that runs past an end, "
        "so it can be much smaller; it stands here for comparison with the literature (So et al. 2008)."
    ),
    "Axis deviation": "How far the tool tilts out of the plane of its two end positions, in degrees.",
    "Feed block, rapid": "A feed block may touch the part. A rapid goes through the air and is not judged "
    "here.",
    "Near the pole": (
        "Where the tool stands almost along the first rotary axis, this axis must turn far to lean the tool "
        "a little, as a compass needle does near the pole of the earth. Textbooks call it a singularity."
    ),
    "Feed over the part": (
        "Length of the tip's real path in a block over the time that the block's F word means: what the "
        "cutter feels. Under G94 F measures other things where rotary axes turn."
    ),
    "u": "The share of a block's time that has passed: 0 at its start, 1 at its end.",
    "RTCP": "Rotation about the tool centre point: the controller itself guides the tip along the straight "
    "segment.",
}


def as_html(figures: Figures, progress: Progress = silent) -> str:
    """Return the whole page. The plots need matplotlib; without it the page says how to get them."""
    numbers = summary(figures)
    whole = verdict(figures, numbers)
    title = escape(f"{figures.title}: {figures.kind} on {figures.machine.name}")
    body = [
        f"<header><h1>{escape(figures.title)}</h1><p>{escape(figures.kind)} on "
        f"{escape(figures.machine.name)}</p></header>",
        f'<p class="verdict {MOOD[whole.light]}">{escape(whole.text)}</p>',
        _grounds(
            [(path_verdict(figures, numbers), _path_mood(numbers)), *part_verdict(numbers, figures.tolerance)]
        ),
        _section("What the verdict rests on", _scope(scope(figures, numbers))),
        _section("Figures", _cards(facts(numbers))),
        _section("Where the tool enters the part", _entries(figures, numbers)),
        *_rest_map(figures, numbers),
        *_pictures(plots(figures, progress), bool(numbers["feed_blocks"])),
        _section("Worst blocks", _worst(figures)),
        *_write_audit(figures),
        _section("Axes", _axes(numbers["axes"])),
        _section("Findings", _findings(figures.findings)),
        _section("Inputs", _pairs((name, _as_text(value)) for name, value in figures.inputs.items())),
        _section("The words used here", _glossary()),
    ]
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width, '
        f'initial-scale=1"><title>{title}</title>'
    )
    page = "\n".join(part for part in body if part)
    head += f"<style>{STYLE}</style>"
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n<body><main>\n{page}\n</main></body></html>\n'
    )


MOOD = {Light.RED: "bad", Light.AMBER: "open", Light.GREEN: "good"}
"""The look of the page for each light."""


def _grounds(statements: Iterable[tuple[str, str]]) -> str:
    """Return what the verdict is made of: one sentence for the path, and one for each thing that was looked
    for on the part."""
    return (
        '<ul class="grounds">'
        + "".join(f'<li class="{mood}">{escape(one)}</li>\n' for one, mood in statements)
        + "</ul>"
    )


def _scope(found: Scope) -> str:
    """Proven, assumed, not known: a row each."""
    rows = [
        (name, "".join(f"<li>{escape(one)}</li>" for one in statements)) for name, statements in found.named
    ]
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td><ul>{statements}</ul></td></tr>\n'
        for name, statements in rows
    )
    return f'<div class="scroll"><table class="pairs scope"><tbody>{cells}</tbody></table></div>'


def _path_mood(numbers: Mapping[str, Any]) -> str:
    return "bad" if numbers["over_tolerance"] else "good" if numbers["proven"] else "open"


def _section(title: str, content: str) -> str:
    return f"<section><h2>{escape(title)}</h2>\n{content}</section>" if content else ""


def _cards(rows: Iterable[tuple[str, str]]) -> str:
    return (
        '<dl class="cards">'
        + "".join(f"<div><dt>{escape(a)}</dt><dd>{escape(b)}</dd></div>\n" for a, b in rows)
        + "</dl>"
    )


def _pairs(rows: Iterable[tuple[str, str]]) -> str:
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td>{escape(value)}</td></tr>\n' for name, value in rows
    )
    return f'<div class="scroll"><table class="pairs"><tbody>{cells}</tbody></table></div>' if cells else ""


def _as_text(value: object) -> str:
    """Return an input as people read it: lists with commas, nothing as a dash."""
    value = plain(value)
    if isinstance(value, list):
        return ", ".join(_as_text(one) for one in value) or "-"
    return "-" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "") -> str:
    top = "".join(f'<th scope="col">{escape(cell)}</th>' for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>\n" for row in rows)
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    return (
        '<div class="scroll"><table '
        f'class="numbers">{title}<thead><tr>{top}</tr></thead>\n<tbody>{body}</tbody></table></div>'
    )


def _pictures(drawn: Sequence[Plot], wanted: bool) -> list[str]:
    if not drawn and wanted:
        note = (
            "The plots are left out because matplotlib is not installed. To get them: <code>pip "
            "install matplotlib</code>"
        )
        return [f'<section><h2>Plots</h2><p class="note">{note}</p></section>']
    return [
        f'<figure><h2>{escape(plot.title)}</h2><div class="card"><img alt="{escape(plot.alt)}" '
        f'src="data:image/svg+xml;base64,{base64.b64encode(plot.svg).decode()}"></div>'
        f"<figcaption>{escape(plot.caption)}</figcaption></figure>"
        for plot in drawn
    ]


BALL = ("ball's centre off its segment, mm", "its proven bound, mm")
"""The columns of what is judged where that is not the tip; the deviation after them is then the tip's."""

BALL_FIRST = " of the ball's centre"


def _worst(figures: Figures) -> str:
    rows = worst_table(figures)
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
    return _table(
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


def _entries(figures: Figures, numbers: Mapping[str, Any]) -> str:
    """Return the deepest places."""
    if figures.gouge is None:
        return ""
    rows = deepest_entries(figures.program, figures.gouge)
    if not rows:
        return "<p>Nowhere.</p>"
    head = ["kind", "what", "depth, mm", "proven bound, mm", "NC line", "block", "at u", "place X Y Z, mm"]
    return _table(
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


def _rest_map(figures: Figures, numbers: Mapping[str, Any]) -> list[str]:
    """Return the map of rest material."""
    if figures.rest is None or figures.mesh is None:
        return []
    statements = (
        "The machined surface, coloured by how far the cutter stays away from it all along its way. Up to "
        f"{figures.allowed:.3g} mm may be left (scallops and tolerance), {figures.tolerance:g} mm too deep "
        "is within tolerance. "
        "Facets that are not machined are grey. Rings: the most that is left, and the deepest place."
    )
    most, deepest = numbers["max_left"], numbers["max_too_deep"]
    alt = f"Map of what is left: at most {most:.4g} mm on the part, at most {deepest:.4g} mm too deep."
    svg = rest_svg(figures.mesh, figures.rest, figures.tolerance, figures.allowed)
    return _pictures([Plot("left", "What is left on the part", statements, alt, svg)], wanted=False)


HEADINGS = {
    "deviation": "The worst lines by deviation: what they say, and what they ask of the axes",
    "limits": "The worst lines beyond a limit",
    "rates": "The worst lines that ask more of an axis than it can",
    "off": "The worst lines off the CL path, or in the part",
}


def _write_audit(figures: Figures) -> list[str]:
    """Return the worst lines of an audit, by each kind of trouble that there is."""
    if figures.audit is None:
        return []
    tables = {"deviation": worst_table(figures)} | worst_of_audit(figures)
    return [_section(HEADINGS[name], _option_table(rows)) for name, rows in tables.items() if rows]


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
    return _table(
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


def _axes(axes: Mapping[str, Mapping[str, Any]]) -> str:
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
    return _table(
        head,
        rows,
        "Rates are per minute; the peak is the largest mean over a feed block. A dash: no limit is known.",
    )


def _findings(findings: Sequence[Finding]) -> str:
    if not findings:
        return "<p>None: nothing needs your attention.</p>"
    parts = []
    for severity in reversed(Severity):
        groups = [group for group in group_findings(findings) if group[0].severity == severity]
        if groups:
            parts.append(
                f'<h3 class="{severity.name.lower()}">{MEANING[severity]}</h3>' + "".join(map(_group, groups))
            )
    return "\n".join(parts)


MEANING = {
    Severity.ERROR: "Errors: will spoil the part or the machine if nobody looks",
    Severity.WARNING: "Warnings: may show on the part",
    Severity.NOTE: "Notes: change nothing on the part",
}


def _group(group: Sequence[Finding]) -> str:
    first, rest = group[0], group[1:NAMED]
    items = "".join(f"<li>{escape(one.text)}</li>\n" for one in rest)
    more = f"<li>and {len(group) - NAMED} more</li>" if len(group) > NAMED else ""
    listed = (
        f"<details open><summary>The single ones, worst first</summary><ul>{items}{more}</ul></details>"
        if rest
        else ""
    )
    return (
        f'<div class="finding"><p><code>{escape(first.code)}</code> {escape(first.text)}</p>{listed}</div>\n'
    )


def _glossary() -> str:
    return (
        "<dl>"
        + "".join(f"<dt>{escape(word)}</dt><dd>{escape(text)}</dd>\n" for word, text in GLOSSARY.items())
        + "</dl>"
    )


STYLE = """
:root{color-scheme:light dark;--ink:#1c2024;--soft:#5b636b;--page:#f6f7f8;--card:#fff;--line:#d9dde1;
--good:#e3f3e6;--good-ink:#14532d;--bad:#fde5e1;--bad-ink:#8a1c0a;--open:#fff1d0;--open-ink:#6b4700}
@media (prefers-color-scheme:dark){:root{--ink:#e7eaed;--soft:#a3abb3;--page:#15181b;--card:#1e2226;--line:#363c42;
--good:#143622;--good-ink:#bdeccb;--bad:#451a12;--bad-ink:#ffc9bd;--open:#40310a;--open-ink:#ffe2a0}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,sans-serif}
main{max-width:66rem;margin:0 auto;padding:1.25rem}
h1{font-size:1.7rem;margin:0;overflow-wrap:anywhere}h2{font-size:1.15rem;margin:0 0 .6rem}h3{font-size:1rem;margin:1rem 0 .4rem}
header p{margin:.1rem 0 1rem;color:var(--soft)}
.verdict{font-size:1.2rem;padding:.9rem 1.1rem;border-radius:.5rem;margin:0 0 1.2rem;border-left:.4rem solid}
.grounds{list-style:none;padding:0;margin:0 0 1.2rem}
.grounds li{padding:.4rem 1.1rem;border-left:.4rem solid;margin:0 0 .3rem;border-radius:.3rem}
.good{background:var(--good);color:var(--good-ink)}.bad{background:var(--bad);color:var(--bad-ink)}
.open{background:var(--open);color:var(--open-ink)}
section,figure{background:var(--card);border:1px solid var(--line);border-radius:.5rem;padding:1rem 1.1rem;margin:0 0 1.2rem}
.card{background:#fff;border-radius:.35rem;overflow-x:auto;padding:.3rem}
.card img{display:block;width:100%;min-width:30rem;height:auto}
figcaption,.note,caption{color:var(--soft);font-size:.92rem}figcaption{margin-top:.6rem}
.scroll{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.92rem}
caption{text-align:left;padding-bottom:.4rem}
th,td{padding:.22rem .7rem .22rem 0;border-bottom:1px solid var(--line);vertical-align:top}
.pairs th{text-align:left;font-weight:500;color:var(--soft);padding-right:1.4rem}
.numbers{width:100%}.numbers th,.numbers td{text-align:right;white-space:nowrap}
.numbers th{white-space:normal;vertical-align:bottom;font-weight:600}
.error{color:#c4320a}.warning{color:#b26a00}
.finding{margin:0 0 .8rem;max-width:60rem}.finding p{margin:.2rem 0}
.finding ul{margin:.3rem 0 .3rem;padding-left:1.2rem;font-size:.92rem}
summary{cursor:pointer;color:var(--soft);font-size:.92rem}
code{font-size:.88em;background:rgba(127,127,127,.16);padding:.05rem .3rem;border-radius:.2rem}
dt{font-weight:600;margin-top:.5rem}dd{margin:0;max-width:52rem}
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(14rem,1fr));gap:.7rem 1.2rem;margin:0}
.cards dt{font-weight:400;color:var(--soft);font-size:.88rem;margin:0}.cards dd{font-weight:600;font-variant-numeric:tabular-nums}
@media (max-width:40rem){main{padding:.7rem}.verdict{font-size:1.05rem}section,figure{padding:.8rem}}
@media print{:root{--page:#fff;--card:#fff;--ink:#000;--line:#bbb}main{max-width:none;padding:0}body{font-size:10.5pt}
section,figure{break-inside:avoid;border:0;padding:.4rem 0}.scroll,.card{overflow:visible}.card img{min-width:0}
.numbers{font-size:7.5pt}.numbers th,.numbers td{padding-right:.35rem}}
"""  # noqa: E501
