# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a page of HTML is made of, and how it looks."""

from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from html import escape

from .json_text import plain
from .plots import Plot


def section(title: str, content: str) -> str:
    """Return a titled part of the page; nothing where there is no ``content``."""
    return f"<section><h2>{escape(title)}</h2>\n{content}</section>" if content else ""


def cards(rows: Iterable[tuple[str, str]]) -> str:
    """Return names and values side by side."""
    return (
        '<dl class="cards">'
        + "".join(f"<div><dt>{escape(a)}</dt><dd>{escape(b)}</dd></div>\n" for a, b in rows)
        + "</dl>"
    )


def pairs(rows: Iterable[tuple[str, str]]) -> str:
    """Return a row for each name and value; nothing where there are none."""
    cells = "".join(
        f'<tr><th scope="row">{escape(name)}</th><td>{escape(value)}</td></tr>\n' for name, value in rows
    )
    return f'<div class="scroll"><table class="pairs"><tbody>{cells}</tbody></table></div>' if cells else ""


def value_text(value: object, unit: str = "") -> str:
    """Return an input as people read it: lists with commas, nothing as a dash; numbers with their ``unit``, a
    text of sizes (``ball:10``) with it in brackets, a unit that is written so."""
    value = plain(value)
    if isinstance(value, list):
        text = ", ".join(value_text(one) for one in value)
    else:
        text = "-" if value is None else f"{value:g}" if isinstance(value, float) else str(value)
    many = value if isinstance(value, list) else [value]
    numbers = all(isinstance(one, int | float) and not isinstance(one, bool) for one in many)
    return f"{text} {unit}" if unit and text not in ("", "-") and (numbers or unit[0] == "(") else text or "-"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "") -> str:
    """Return columns under their heads."""
    top = "".join(f'<th scope="col">{escape(cell)}</th>' for cell in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>\n" for row in rows)
    title = f"<caption>{escape(caption)}</caption>" if caption else ""
    return (
        '<div class="scroll"><table '
        f'class="numbers">{title}<thead><tr>{top}</tr></thead>\n<tbody>{body}</tbody></table></div>'
    )


def pictures(drawn: Sequence[Plot], wanted: bool) -> list[str]:
    """Return the plots that are drawn, or how to get them where they are ``wanted``."""
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
