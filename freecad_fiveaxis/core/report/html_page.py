# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as one HTML page that needs nothing else: no network, no scripts, pictures inside.

Every text that comes from outside (titles, findings, inputs) is escaped. The same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape
from typing import Any

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent

from .ends import state_ends
from .figures import Figures, summary
from .html_elements import STYLE, cards, pairs, pictures, section, value_text
from .html_tables import audit_sections, axes_table, entries, worst_blocks
from .part_facts import part_verdict
from .plots import Plot, plots
from .rest_material_picture import rest_svg
from .scope import Scope, scope
from .text import facts, group_findings, path_verdict
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
    "Feed block, rapid": (
        "A feed block may touch the part, and its deviation is held against the tolerance. A rapid goes "
        "through the air: its largest deviation is told among the figures and held against nothing. Whether "
        "the tool stays out of the part on rapids too stands under what the verdict rests on."
    ),
    "cut, fill, link": "What a feed block does: it cuts along a pass, closes the gap between two pieces of "
    "one at an edge, or leads from one pass to the next.",
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
        section("What the verdict rests on", _scope(scope(figures, numbers))),
        section("Figures", cards(facts(numbers))),
        section("Where the tool enters the part", entries(figures)),
        *_rest_map(figures, numbers),
        *pictures(plots(figures, progress), bool(numbers["feed_blocks"])),
        section("Worst blocks", worst_blocks(figures)),
        *audit_sections(figures),
        section("Axes", axes_table(numbers["axes"]) + f"<p>{escape(state_ends(numbers))}</p>"),
        section("Findings", _findings(figures.findings)),
        section("Inputs", pairs(_inputs(figures))),
        section("The words used here", _glossary()),
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


def _inputs(figures: Figures) -> Iterator[tuple[str, str]]:
    for name, value in figures.inputs.items():
        yield name, value_text(value, figures.units.get(name, ""))


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
    return pictures([Plot("left", "What is left on the part", statements, alt, svg)], wanted=False)


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
