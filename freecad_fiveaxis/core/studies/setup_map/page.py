# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said of a map of setups: one sentence, text, JSON, a page with heat maps, and places for the 3D
view."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping
from html import escape

import numpy as np

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.sentences import Angle, Length, Number, Sentence, join_sentences, say
from freecad_fiveaxis.core.report.json_text import plain
from freecad_fiveaxis.core.report.markers import MARKERS, Marker
from freecad_fiveaxis.core.report.text import WIDTH, duration, number

from .heat_map import heat_maps
from .jaws import jaws_record
from .setups import Kind, SetupMap
from .sheet import Table, figures, findings_list, findings_text, json_text, page, section, table, text_table
from .stick_out import stick_out_record

VERSION = 1
"""Of the JSON record: raised when a key changes its meaning."""

HEAD = (
    "setup",
    "X, mm",
    "Y, mm",
    "Z, mm",
    "turn, deg",
    "deviation, mm",
    "rotary travel, deg",
    "time",
    "rewinds",
    "limits",
)


def verdict(chart: SetupMap) -> Sentence:
    """One plain sentence: where the part should stand, and what that brings."""
    if chart.best is None:
        return say("No setup of the region keeps all axes within their limits and the part on the table.")
    best, now = float(chart.max_deviation[chart.best]), float(chart.max_deviation[0])
    place, on_table = _place(chart, chart.best), _on_table(chart, chart.best)
    alone = say(
        "Stand {place}: largest deviation {whose} {deviation}.",
        place=place, whose=_whose(chart), deviation=Length(best, ".4g"),
    )  # fmt: skip
    if chart.hits[chart.best] > 0.0:
        return join_sentences((_longer_tool(chart), alone, on_table))
    if not math.isfinite(now) or not chart.able[0]:
        leaves = say("In the present setup the axes leave their limits.")
        below = say("In the present setup the part reaches below the table.")
        hits = say("In the present setup the machine is hit.")
        return join_sentences(
            (alone, hits if chart.hits[0] > 0.0 else below if chart.within_limits[0] else leaves, on_table)
        )
    if chart.best == 0:
        good = say(
            "The present setup is as good as any of the region: largest deviation {whose} {deviation}.",
            whose=_whose(chart), deviation=Length(now, ".4g"),
        )  # fmt: skip
        return join_sentences((good, on_table))
    return join_sentences((_compare(chart, chart.best, place), on_table))


def _compare(chart: SetupMap, row: int, place: Sentence) -> Sentence:
    """Tell where the part should stand, and what that brings against the present setup: less deviation, or
    where that one is as good by :attr:`SetupMap.level` what else."""
    best, now = float(chart.max_deviation[row]), float(chart.max_deviation[0])
    figures = {"place": place, "whose": _whose(chart), "deviation": Length(best, ".4g")}
    if now > chart.level:
        return say(
            "Stand {place}: largest deviation {whose} {deviation} instead of {now}, {times} times less.",
            **figures, now=Length(now, ".4g"), times=Number(now / max(best, 1e-9), ".3g"),
        )  # fmt: skip
    return say(
        "Stand {place}: largest deviation {whose} {deviation}, as good as {now} in the present setup, which "
        "{why}.",
        **figures, now=Length(now, ".4g"), why=_why_not_present(chart, row),
    )  # fmt: skip


def _why_not_present(chart: SetupMap, row: int) -> Sentence:
    """Tell, as what follows "which", what speaks against a present setup of as little deviation."""
    if not chart.region.holds(chart.origin[:1])[0]:
        return say("lies outside the region")
    if chart.rewinds[0] > chart.rewinds[row]:
        return say("turns back more often")
    if chart.time[0] > chart.time[row]:
        return say("takes longer")
    return say("is turned farther")


def _whose(chart: SetupMap) -> Sentence:
    """Name the point whose deviations the map gives, in the genitive."""
    return say("of the ball's centre") if chart.above else say("of the tip")


def _longer_tool(chart: SetupMap) -> Sentence:
    """Tell that what is recommended is for a longer tool."""
    assert chart.stick_out is not None and chart.stick_out.enough is not None  # it is why there is a setup
    return say(
        "With the tool as it is the machine is hit in every setup that was tried. With one that "
        "sticks out {enough} instead of {present}:",
        enough=Length(chart.stick_out.enough, ".6g"), present=Length(chart.stick_out.present, ".6g"),
    )  # fmt: skip


def _on_table(chart: SetupMap, row: int) -> Sentence:
    """How high over the table the part then stands."""
    if chart.table is None:
        return say("The height of the table is not known: check that the part stands on it.")
    above = float(chart.origin[row, 2]) + chart.bottom - chart.table
    return say(
        "The part's lowest place is then {height} above the table.", height=Length(max(above, 0.0), ".3f")
    )


def _place(chart: SetupMap, row: int) -> Sentence:
    x, y, z = (chart.origin[row] + 0.0).tolist()  # no -0
    sentence = say(
        "the work zero at X {x} Y {y} Z {z} of the machine",
        x=Length(x, ".3f", bare=True),
        y=Length(y, ".3f", bare=True),
        z=Length(z, ".3f"),
    )
    turn = math.degrees(chart.turn[row])
    return sentence + say(" and the part turned by {turn}", turn=Angle(turn)) if turn else sentence


def advice(chart: SetupMap) -> tuple[str, ...]:
    """Return what to do to get the recommended setup, step by step; nothing where there is none."""
    if chart.best is None:
        return ()
    turn = math.degrees(chart.turn[chart.best])
    place = f"give to mill and post: {origin_option(chart)}"
    if not turn:
        return (place, *tool_options(chart))
    return (
        f"turn the part in CAD by {turn:g} deg about Z through its zero, counter-clockwise seen from above, "
        "and export it",
        f"add {turn:g} deg to --direction, so that the passes turn with the part",
        place,
        *tool_options(chart),
    )


def tool_options(chart: SetupMap) -> tuple[str, ...]:
    """How the shortest tool that is free is stated, where it is another than the one that is set."""
    if chart.stick_out is None or not chart.stick_out.options:
        return ()
    words = [(f"--{name.replace('_', '-')}", value) for name, value in chart.stick_out.options]
    given = " ".join(f"{name}={value}" for name, value in words if value)
    dropped = "".join(f", without {name}" for name, value in words if not value)
    return (f"for a tool that sticks out {chart.stick_out.enough:g} mm{dropped}: {given}",)


def origin_option(chart: SetupMap) -> str:
    """Return the recommended work zero as an option of the command line, ``--origin=X,Y,Z`` mm; empty where
    there is none."""
    if chart.best is None:
        return ""
    return "--origin=" + ",".join(
        f"{round(value, 4) + 0.0:.12g}" for value in chart.origin[chart.best].tolist()
    )


def setup_text(chart: SetupMap) -> str:
    """Return the map for the terminal: the sentence, the setups worth naming, the findings."""
    lines = [
        *textwrap.wrap(verdict(chart), WIDTH),
        *(f"  {step}" for step in advice(chart)),
        "",
        *text_table(_table_named(chart)),
        "",
    ]
    lines += textwrap.wrap(_say_proven(chart), WIDTH)
    lines += findings_text(chart.findings)
    return "\n".join(lines) + "\n"


def setup_json(chart: SetupMap, inputs: Mapping[str, object] | None = None) -> str:
    """Return the map for scripts: mm, degrees, seconds. Keys: version, machine, tool_length, best
    (index into setups), deviation_of (centre of the ball, or tip), least, setups, stick_out and jaws
    (of the recommended setup), findings, inputs (a job file)."""
    columns = {
        "origin": chart.origin, "turn_deg": np.degrees(chart.turn), "max_deviation": chart.max_deviation,
        "rotary_travel_deg": np.degrees(chart.rotary_travel), "time_s": chart.time, "over_limits": chart.over,
        "within_limits": chart.within_limits, "on_table": chart.stands, "rewinds": chart.rewinds,
        "machine_hit": chart.hits,
    }  # fmt: skip
    kinds = [Kind(kind).name.lower() for kind in chart.kind]
    setups = [
        {"kind": kinds[row]} | {name: plain(column[row]) for name, column in columns.items()}
        for row in range(len(kinds))
    ]
    record = {
        "version": VERSION, "machine": chart.machine, "tool_length": chart.base.tool_length,
        "table": chart.table,
        "bottom": chart.bottom, "best": chart.best,
        "deviation_of": "centre" if chart.above else "tip",
        "least": chart.least, "setups": setups, "stick_out": stick_out_record(chart.stick_out),
        "jaws": jaws_record(chart.clamping),
        "findings": chart.findings, "inputs": inputs or {},
    }  # fmt: skip
    return json_text(record)


def heat_map_html(chart: SetupMap, title: str = "") -> str:
    """Return the map as one page that needs nothing else. The heat maps need matplotlib; without it the page
    says how to get them."""
    pictures = figures(heat_maps(chart), bool(np.isfinite(chart.max_deviation).any()))
    body = [
        section("What to do", "".join(f"<p><code>{escape(step)}</code></p>" for step in advice(chart))),
        section("Setups", table(_table_named(chart)) + f'<p class="note">{_say_proven(chart)}</p>'),
        *pictures,
        section("Turns", table(_turn_table(chart)) if len(chart.region.turns) > 1 else ""),
        section("Findings", findings_list(chart.findings)),
        section("The words used here", WORDS),
    ]
    bad = chart.best is None or any(one.severity == Severity.ERROR for one in chart.findings)
    return page(
        "Where the part should stand",
        f"{title} on {chart.machine}".lstrip(),
        verdict(chart),
        "bad" if bad else "good",
        body,
    )


def setup_markers(chart: SetupMap) -> tuple[Marker, ...]:
    """Places for the 3D view, in the work frame of the present setup: where the work zero should stand, where
    it stands, and the grid at the recommended turn, the best first."""
    place = chart.origin - np.array(chart.base.origin)
    turn = math.degrees(chart.turn[chart.best]) if chart.best is not None else 0.0
    turned = f", turned by {turn:g} deg" if turn else ""
    words = {"setup-best": f"best work zero: {{}}{turned}", "setup-present": "work zero now: {}"}

    def marker(row: int, kind: str) -> Marker:
        x, y, z = place[row].tolist()
        return Marker((x, y, z), kind, words.get(kind, "{}").format(_mm(chart, row)))

    return tuple(marker(row, kind) for row, kind in list_marked_rows(chart))


def list_marked_rows(chart: SetupMap) -> tuple[tuple[int, str], ...]:
    """Return the row and the kind of each of :func:`setup_markers`."""
    best = () if chart.best is None else ((chart.best, "setup-best"),)
    at = chart.turn[chart.best] if chart.best is not None else chart.region.turns[0]
    rows = np.flatnonzero((chart.kind == Kind.GRID) & (chart.turn == at) & np.isfinite(chart.max_deviation))
    rows = rows[np.argsort(chart.max_deviation[rows], kind="stable")][:MARKERS]
    grid = [(row, "setup" if chart.able[row] else "setup-beyond-limits") for row in rows.tolist()]
    return (*best, (0, "setup-present"), *grid)


def _mm(chart: SetupMap, row: int) -> str:
    return f"{number(float(chart.max_deviation[row]), 4)} mm"


def _table_named(chart: SetupMap) -> Table:
    """Return the setups worth naming: recommended, present, best and worst of the grid."""
    rows = [("present", 0)] if chart.best is None else [("recommended", chart.best), ("present", 0)]
    grid = np.flatnonzero((chart.kind == Kind.GRID) & np.isfinite(chart.max_deviation))
    if len(grid):
        order = grid[np.argsort(chart.max_deviation[grid], kind="stable")]
        rows += [("best of the grid", int(order[0])), ("worst of the grid", int(order[-1]))]
    return Table(HEAD, [_cells(chart, name, row) for name, row in rows])


def _turn_table(chart: SetupMap) -> Table:
    """Return the setup that was found at each turn."""
    rows = np.flatnonzero(chart.kind == Kind.FOUND)
    return Table(HEAD, [_cells(chart, "best at this turn", int(row)) for row in rows])


def _cells(chart: SetupMap, name: str, row: int) -> list[str]:
    limits = "within" if chart.stands[row] else "below the table"
    limits = (
        f"hits the machine by {number(float(chart.hits[row]), 3)} mm" if chart.hits[row] > 0.0 else limits
    )
    limits = limits if chart.within_limits[row] else f"over by {number(float(chart.over[row]), 3)} mm"
    if not math.isfinite(chart.max_deviation[row]):
        return [
            name,
            *(number(value, 3) for value in chart.origin[row]),
            f"{math.degrees(chart.turn[row]):g}",
            *"----",
            "rotary",
        ]
    return [
        name,
        *(number(value, 3) for value in chart.origin[row]),
        f"{math.degrees(chart.turn[row]):g}",
        number(float(chart.max_deviation[row]), 6),
        number(math.degrees(chart.rotary_travel[row]), 1),
        duration(float(chart.time[row])),
        str(chart.rewinds[row]),
        limits,
    ]


def _say_proven(chart: SetupMap) -> str:
    if not math.isfinite(chart.least):
        return ""
    turns = "at the turns tried" if len(chart.region.turns) > 1 else "at this turn"
    where = "" if chart.table is None else " above the table"
    proven = (
        f"Proven: no work zero of the region{where} has less than {chart.least:.4g} mm {turns}, but "
        "for the rounding of words."
    )
    return proven + _say_equal(chart)


def _say_equal(chart: SetupMap) -> str:
    """Say why another setup of the map than that of the least deviation is recommended; nothing where it is
    that one."""
    able = chart.max_deviation[chart.able & chart.region.holds(chart.origin)]
    if chart.best is None or not len(able) or chart.max_deviation[chart.best] <= np.nanmin(able):
        return ""
    return (
        " Setups of 1 % more, or within the tolerance, are equally good: of these the one of the fewest "
        "rewinds, then the shortest time, the least turn and the shortest way from the present one."
    )


WORDS = """<dl><dt>Work zero</dt><dd>The zero of the program's coordinates, as it stands in the machine's frame: what a work
offset (G54) says. The part stands where its own zero does.</dd>
<dt>Turn</dt><dd>The part turned counter-clockwise about Z through the work zero, seen from above.</dd>
<dt>Deviation</dt><dd>The largest distance of the real path from the commanded segments, of all blocks at feed: of the ball's centre, which
makes the surface, where the cutter is a ball, else of the tip.</dd>
<dt>Rewind</dt><dd>A retract inside a cut or between two, because a rotary axis has to turn back.</dd></dl>"""  # noqa: E501
