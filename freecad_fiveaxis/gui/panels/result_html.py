# SPDX-License-Identifier: LGPL-2.1-or-later
"""What was found, as HTML for a narrow panel: a recovered machine, the sheet that proves signs, an imported
machine."""

from __future__ import annotations

import html
import math
from collections.abc import Iterable, Sequence
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.gui.qt import translate
from freecad_fiveaxis.gui.scene.units import angle_text, length_text, write_number
from freecad_fiveaxis.gui.scene.words import severity_name

COLOURS = ("#4a5a6a", "#b06000", "#d0342c")
"""Of notes, warnings and errors."""


def describe_recovered(found: Any) -> str:
    """Return the sentence, the numbers with their certainty, and the findings; ``found`` is the core's
    Recovery."""
    from freecad_fiveaxis.core.calibration.recover import parameters, verdict

    estimates = parameters(found)
    compared = any(one.given is not None for one in estimates)
    head = ["", translate("FiveAxis", "found"), translate("FiveAxis", "certain within")]
    head += [found.start.name] if compared else []
    worst = length_text(float(found.fit.miss[found.fit.good].max(initial=0.0)), 3)
    residual = translate("FiveAxis", "Largest residual of the rows used: {length}").format(length=worst)
    rows = table([head, *(_cells(one, compared) for one in estimates)])
    return (
        paragraph(wording.localize(verdict(found)), bold=True)
        + paragraph(residual)
        + rows
        + findings(found.findings)
    )


def _cells(one: Any, compared: bool) -> list[str]:
    if not one.fitted:
        sure = translate("FiveAxis", "taken as 0")
    else:
        sure = (
            _value(one.certainty, one.unit, 3) if one.determined else translate("FiveAxis", "not determined")
        )
    value = _value(round(one.value, 4) + 0.0, one.unit, 8) if one.fitted or one.value else "0"
    given = (
        [] if not compared else ["" if one.given is None else _value(round(one.given, 4) + 0.0, one.unit, 8)]
    )
    return [parameter_label(one.name), value, sure, *given]


def _value(value: float, unit: str, digits: int) -> str:
    return length_text(value, digits) if unit == "mm" else angle_text(value, digits)


def parameter_label(name: str) -> str:
    """Return ``A line, Y`` and ``X zero`` of the core in the user's language; any other name as it is."""
    letter, _, rest = name.partition(" ")
    if rest == "zero":
        return translate("FiveAxis", "{letter} zero").format(letter=letter)
    if rest.startswith("line, "):
        return translate("FiveAxis", "{letter} line, {way}").format(
            letter=letter, way=rest.removeprefix("line, ")
        )
    return name


def sheet(proof: Any) -> str:
    """Return what must be seen at each stop; ``proof`` is the core's Proof."""
    from freecad_fiveaxis.core.calibration.prove_signs import READY, STAND, notices, rows, verdict

    plan = proof.plan
    parts = [paragraph(wording.localize(one), bold=True) for one in (*notices(plan), verdict(plan))]
    parts += [
        heading(translate("FiveAxis", "Before you start")),
        items(map(wording.localize, READY)),
        paragraph(wording.localize(STAND)),
    ]
    parts += [findings(plan.findings), heading(translate("FiveAxis", "Stops"))]
    parts += [_stop(row) for row in rows(plan, proof.program)]
    parts.append(heading(translate("FiveAxis", "If the tool does not point at the cross, it is off by")))
    parts.append(
        table(
            [
                ["", "X", "Y", "Z"],
                *(
                    [wording.localize(text), *(length_text(part) for part in off.tolist())]
                    for text, off in plan.predicted_errors
                ),
            ]
        )
    )
    return "".join(parts)


def _stop(row: Any) -> str:
    place = " ".join(f"{letter}{value + 0.0:.10g}" for letter, value in row["words"].items())
    title = translate("FiveAxis", "Stop {number}, NC line {line}: {title}").format(
        number=row["number"], line=row["line"], title=wording.localize(row["title"])
    )
    seen, wrong = translate("FiveAxis", "You see: {text}"), translate("FiveAxis", "Wrong: {text}")
    texts = [f"<b>{html.escape(title)}</b>", html.escape(place)]
    texts += [
        html.escape(text.format(text=wording.localize(row[key])))
        for text, key in ((seen, "see"), (wrong, "bad"))
    ]
    return f"<p>{'<br/>'.join(texts)}</p>"


def describe_imported(found: Any) -> str:
    """Return the axes and what the source leaves open; ``found`` is the core's Imported."""
    machine = found.machine
    head = [translate("FiveAxis", "axis"), translate("FiveAxis", "carries"), translate("FiveAxis", "along"),
            translate("FiveAxis", "through"), translate("FiveAxis", "limits")]  # fmt: skip
    sides = {"table": translate("FiveAxis", "the table"), "head": translate("FiveAxis", "the head")}
    rows = [
        [
            axis.letter,
            sides[axis.side],
            numbers(axis.direction),
            numbers(axis.point) if axis.rotary else "",
            _limits(axis),
        ]
        for axis in machine.fitted
    ]
    named = paragraph(f"{machine.name}: {machine.description}", bold=True)
    return named + table([head, *rows]) + _bodies(machine.bodies) + findings(found.findings)


def _bodies(bodies: Sequence[Any]) -> str:
    if not bodies:
        return ""
    named = ", ".join(f"{body.name} ({body.carrier})" for body in bodies)
    return paragraph(translate("FiveAxis", "Bodies, and what carries them: {}").format(named))


def _limits(axis: Any) -> str:
    if not math.isfinite(axis.high - axis.low):
        return translate("FiveAxis", "none")
    if not axis.rotary:
        return f"{length_text(axis.low, 8)} … {length_text(axis.high, 8)}"
    return write_number(f"{math.degrees(axis.low):g}…{math.degrees(axis.high):g}") + "°"


def numbers(values: Iterable[float]) -> str:
    """Numbers with blanks between them."""
    return " ".join(write_number(f"{value + 0.0:.6g}") for value in values)


def paragraph(text: str, bold: bool = False) -> str:
    """Return a paragraph of plain text."""
    return f"<p><b>{html.escape(text)}</b></p>" if bold else f"<p>{html.escape(text)}</p>"


def heading(text: str) -> str:
    """Return a heading of plain text."""
    return f"<h4>{html.escape(text)}</h4>"


def items(texts: Iterable[str]) -> str:
    """Return a list of plain texts."""
    return "<ul>" + "".join(f"<li>{html.escape(text)}</li>" for text in texts) + "</ul>"


def table(rows: Sequence[Sequence[str]]) -> str:
    """Return a table of plain texts; the first row is its head."""
    head, *body = rows
    top = "".join(f"<th align='left'>{html.escape(cell)}&nbsp;&nbsp;</th>" for cell in head)
    lines = "".join(
        "<tr>" + "".join(f"<td>{html.escape(cell)}&nbsp;&nbsp;</td>" for cell in row) + "</tr>"
        for row in body
    )
    return f"<table cellspacing='1'><tr>{top}</tr>{lines}</table>"


def findings(found: Iterable[Any]) -> str:
    """Return the findings, the gravest first."""
    ordered = sorted(found, key=lambda one: -one.severity)
    return "".join(
        f"<p><span style='color: {COLOURS[one.severity]}'><b>{html.escape(severity_name(one.severity))}:</b> "
        f"{html.escape(wording.localize(one.text))}</span></p>"
        for one in ordered
    )
