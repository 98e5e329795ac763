# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparison as text, JSON and a page."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from html import escape

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.sentences import Choice, Length, Number, Sentence, join_sentences, plural, say
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.report.text import duration, number
from freecad_fiveaxis.core.studies.setup_map.sheet import (
    Table,
    findings_list,
    findings_text,
    json_text,
    page,
    section,
    table,
    text_table,
)

from .beside_fixtures import find_worst_meeting, hits_fixture
from .beside_part import enters_part, find_deepest
from .stations import Row

VERSION = 1
"""Of the JSON record: raised when a key changes its meaning."""

HEAD = (
    "machine", "cure", "tip guided", "deviation, mm", "bound, mm", "axis, deg", "blocks", "time",
    "X Y Z, mm/min", "1st rotary, deg/min", "2nd rotary, deg/min", "limits", "part",
)  # fmt: skip

SHORT_HEAD = (
    "machine", "cure", "TCP", "dev. mm", "bound mm", "axis deg", "blocks", "time", "XYZ mm/min",
    "1st deg/min", "2nd deg/min",
    "limits", "part",
)  # fmt: skip
"""For the terminal. TCP: tool-centre control; XYZ, 1st, 2nd: peak rates of the linear and of the two rotary
axes."""


def compare_text(
    rows: Sequence[Row], tolerance: float | None = None, findings: Sequence[Finding] = ()
) -> str:
    """Return the table for the terminal, why cells are empty, and the ``findings``, of which no row
    tells."""
    lines = [
        headline(rows, tolerance),
        "",
        *text_table(_table(rows, SHORT_HEAD)),
        *(f"{key}: {text}" for key, text in (*_problems(rows), *_shares(rows))),
        *findings_text(findings),
    ]
    return "\n".join(lines) + "\n"


def compare_json(
    rows: Sequence[Row], inputs: Mapping[str, object] | None = None, findings: Sequence[Finding] = ()
) -> str:
    """Return the rows for scripts: mm, degrees, seconds, rates a minute by letter; no number is null.
    ``inputs``: a job file; ``findings``: of which no row tells."""
    records = [_record(row) for row in rows]
    return json_text({"version": VERSION, "rows": records, "findings": findings, "inputs": inputs or {}})


def compare_html(
    rows: Sequence[Row], title: str = "", tolerance: float | None = None, findings: Sequence[Finding] = ()
) -> str:
    """Return the table as a page that needs nothing else. ``tolerance`` mm: what is within it is named in the
    first sentence; ``findings``: of which no row tells."""
    body = [
        section("Findings", findings_list(findings)),
        section("The table", table(_table(rows)) + f'<p class="note">{escape(_note(rows))}</p>'),
        section(
            "What could not be done",
            "".join(
                f"<p><b>{escape(key)}</b>: {escape(text)}</p>"
                for key, text in (*_problems(rows), *_shares(rows))
            ),
        ),
    ]
    mood = "open" if tolerance is None else "good" if _good(rows, tolerance) else "bad"
    return page("The same path, compared", title, headline(rows, tolerance), mood, body)


NOTE = (
    "Tip guided: the controller has tool-centre control (RTCP, TCPM, G43.4). Deviation: the largest "
    "distance of the tip's real path from the segment that a block commands, of all blocks at feed, as "
    "rounded; of a guided tip only the end points of blocks are verified, the path between them is under "
    "RTCP. Axis: how far the tool leaves the plane of a block's two end axes. "
    "Rates are the peaks within feed blocks, at the programmed feed where no axis is too slow for it. Time "
    "includes rapids. Part: how deep the tool goes into it, or below the table, on the real way of each "
    "block; free: by no more than the tolerance."
)
FIXTURES_NOTE = (
    "Fixtures: how deep tool or spindle go into one on the real way of each block, or how near they come "
    "where less than the clearance is left; free: by no more than the tolerance. Rapids are taken as "
    "interpolated."
)


def _note(rows: Sequence[Row]) -> str:
    return f"{NOTE} {FIXTURES_NOTE}" if _has_fixtures(rows) else NOTE


def _has_fixtures(rows: Sequence[Row]) -> bool:
    return any(row.fixtures is not None for row in rows)


def verdict(rows: Sequence[Row], tolerance: float | None = None) -> Sentence:
    """One plain sentence: what holds the tolerance soonest; without one, what deviates least. Others say in
    how many ways the tool goes into the part, and hits a fixture."""
    entered, hit = (
        sum(enters_part(row.part) for row in rows), sum(hits_fixture(row.fixtures) for row in rows)
    )  # fmt: skip
    more = [_say_entered(entered, len(rows))] if entered else []
    more += [_say_hit(hit, len(rows))] if hit else []
    less = len([row for row in rows if not row.problem]) - len(_whole(rows))
    more += [_say_less(less, len(rows))] if less else []
    least = min((row.left_out for row in rows if not row.problem), default=0.0)
    more += [_say_all_leave(least)] if least >= WORTH else []
    return join_sentences((_name_best(rows, tolerance), *more))


def say_unchecked(rows: Sequence[Row]) -> Sentence | None:
    """Say in how many ways nobody has looked whether the tool goes into the part; None where all were looked
    at."""
    open_ = sum(not row.problem and row.part is None for row in rows)
    if not open_:
        return None
    return plural(
        open_,
        "In 1 of {all} ways it is not checked whether the tool goes into the part.",
        "In {count} of {all} ways it is not checked whether the tool goes into the part.",
        all=len(rows),
    )


def headline(rows: Sequence[Row], tolerance: float | None) -> Sentence:
    """Return the verdict, and in how many ways nobody has looked whether the tool goes into the part."""
    unchecked = say_unchecked(rows)
    found = verdict(rows, tolerance)
    return found if unchecked is None else join_sentences((found, unchecked))


def _say_less(count: int, every: int) -> Sentence:
    return plural(
        count,
        "In 1 of {all} ways more of the surface is left out than in others.",
        "In {count} of {all} ways more of the surface is left out than in others.",
        all=every,
    )


def _say_all_leave(share: float) -> Sentence:
    return say(
        "Every way leaves out at least {share} % of the surface: no free axis of the machine is there.",
        share=Number(100.0 * share, ".2g"),
    )


WORTH = 0.01
"""Of the surface, which every way leaves out: worth a sentence."""


def _whole(rows: Sequence[Row]) -> list[Row]:
    """Return the ways that leave out no more of the surface than the one that leaves out least."""
    able = [row for row in rows if not row.problem]
    least = min((row.left_out for row in able), default=0.0)
    return [row for row in able if row.left_out <= least + SHARE_SHOWN]


SHARE_SHOWN = 1e-3
"""Of the surface; less is no difference between ways."""


def _say_entered(count: int, every: int) -> Sentence:
    return plural(
        count,
        "In 1 of {all} ways the tool goes into the part.",
        "In {count} of {all} ways the tool goes into the part.",
        all=every,
    )


def _say_hit(count: int, every: int) -> Sentence:
    return plural(
        count,
        "In 1 of {all} ways the tool hits a fixture.",
        "In {count} of {all} ways the tool hits a fixture.",
        all=every,
    )


def _name_best(rows: Sequence[Row], tolerance: float | None) -> Sentence:
    able = [row for row in rows if not row.problem]
    if not able:
        return say("None of the machines can drive this path.")
    plain_ones = [row for row in able if not row.tool_centre] or able
    if tolerance is None:
        best = min(plain_ones, key=lambda row: (_hits(row), row.deviation))
        return say(
            "Least deviation: {way}, {deviation} in {time}.",
            way=_name(best),
            deviation=Length(best.deviation, ".4g"),
            time=duration(best.time),
        )
    good = _good(able, tolerance)
    holding = [row for row in able if row.bound <= tolerance and not row.over > LIMIT_SHOWN]
    if not good and any(hits_fixture(row.fixtures) for row in holding):
        return say(
            "Nothing here holds {tolerance} within the limits of its machine and stays out of the fixtures.",
            tolerance=Length(tolerance),
        )
    if not good and holding:
        return say(
            "Nothing here holds {tolerance} within the limits of its machine, stays out of the part and cuts "
            "as much as the others.",
            tolerance=Length(tolerance),
        )
    if not good:
        return say(
            "Nothing here holds {tolerance} within the limits of its machine.", tolerance=Length(tolerance)
        )
    best = min([row for row in good if not row.imagined] or good, key=lambda row: row.time)
    held = plural(
        len(good),
        "1 of {all} ways holds {tolerance}; the quickest is {way}, {time}.",
        "{count} of {all} ways hold {tolerance}; the quickest is {way}, {time}.",
        all=len(rows),
        tolerance=Length(tolerance),
        way=_name(best),
        time=duration(best.time),
    )
    guided = sum(row.tool_centre and not row.imagined for row in good)
    imagined = [row.imagined for row in good if row.imagined]
    return join_sentences((held, *([_say_guided(guided)] if guided else []), *_say_imagined(imagined)))


def _say_imagined(names: Sequence[str]) -> list[Sentence]:
    """Say in how many ways the controller would do what it cannot, by the ``names`` of controllers."""
    if not names:
        return []
    one = plural(
        len(names),
        "In 1 of these the controller would have to guide the tip, which {names} cannot.",
        "In {count} of these the controller would have to guide the tip, which {names} cannot.",
        names=", ".join(dict.fromkeys(names)),
    )
    return [one]


def _say_guided(count: int) -> Sentence:
    return plural(
        count,
        "In 1 of these the controller guides the tip: only the end points of blocks are verified there, the "
        "path between them is under RTCP.",
        "In {count} of these the controller guides the tip: only the end points of blocks are verified "
        "there, the path between them is under RTCP.",
    )


def _good(rows: Sequence[Row], tolerance: float) -> list[Row]:
    return [
        row
        for row in _whole(rows)
        if row.bound <= tolerance and not row.over > LIMIT_SHOWN and not _hits(row)
    ]


def _hits(row: Row) -> bool:
    return hits_fixture(row.fixtures) or enters_part(row.part)


LIMIT_SHOWN = 5e-4
"""mm; less beyond a limit than the table shows is none."""


def _name(row: Row) -> Sentence:
    cure = say("no correction") if row.cure == "none" else Choice("cures", (row.cure,), alone=True)
    if row.tool_centre:
        return say("{machine} with {cure}, tool-centre control", machine=row.machine, cure=cure)
    return say("{machine} with {cure}", machine=row.machine, cure=cure)


def _table(rows: Sequence[Row], head: tuple[str, ...] = HEAD) -> Table:
    if not _has_fixtures(rows):
        return Table(head, [_cells(row) for row in rows])
    return Table((*head, "fixtures"), [[*_cells(row), name_hit(row)] for row in rows])


def name_hit(row: Row) -> str:
    """Say in a cell how deep the tool goes into which fixture, or how near it comes."""
    if row.fixtures is None:
        return "-"
    met = find_worst_meeting(row.fixtures)
    if met is None:
        return "free"
    if hits_fixture((met.found,)):
        return f"wholly in {met.fixture}" if math.isinf(met.room) else f"{-met.room:.3f} mm in {met.fixture}"
    return f"{met.room:.3f} mm from {met.fixture}"


def _cells(row: Row) -> list[str]:
    named = [row.machine, row.cure, "on" if row.tool_centre else "off"]
    if row.problem:
        return [*named, *["-"] * 8, "impossible", "-"]
    return [
        *named,
        *(["ends only"] * 2 if row.tool_centre else [number(row.deviation, 5), number(row.bound, 5)]),
        number(math.degrees(row.axis_deviation), 3),
        str(row.blocks),
        duration(row.time),
        number(max(row.peak_rate[:3]), 0),
        *(_rate(row, column) for column in (3, 4)),
        f"over by {row.over:.3f} mm" if row.over > LIMIT_SHOWN else "within",
        name_entry(row),
    ]


def name_entry(row: Row) -> str:
    """Say in a cell how deep the tool goes into the part, or that nobody has looked."""
    if row.part is None:
        return "not checked"
    deepest = find_deepest(row.part)
    if deepest is None:
        return "free"
    if deepest.code == Code.BURIED:
        return "wholly in it"
    if deepest.code == Code.AVOIDED_FACES_NEAR:
        return "near faces to avoid"
    place = "in table" if deepest.code == Code.TABLE_COLLISION else "deep"
    return f"{deepest.value or 0.0:.3f} mm {place}"


def _rate(row: Row, column: int) -> str:
    if column not in find_physical_columns(row.letters):
        return "-"
    return f"{row.letters[column]} {math.degrees(row.peak_rate[column]):.0f}"


def _record(row: Row) -> dict[str, object]:
    rates = [*row.peak_rate[:3], *(math.degrees(rate) for rate in row.peak_rate[3:])]
    return {
        "machine": row.machine, "cure": row.cure, "tool_centre": row.tool_centre, "deviation": row.deviation,
        "bound": row.bound,
        "axis_deviation_deg": math.degrees(row.axis_deviation), "blocks": row.blocks,
        "feed_blocks": row.feed_blocks,
        "time_s": row.time,
        "peak_rate": {row.letters[k]: rates[k] for k in find_physical_columns(row.letters)},
        "over_limits": row.over,
        "problem": row.problem, "part_checked": row.part is not None, "part": row.part or (),
        "left_out": row.left_out, "length": row.length,
    } | ({} if row.fixtures is None else {"fixtures": row.fixtures})  # fmt: skip


def _problems(rows: Sequence[Row]) -> list[tuple[str, str]]:
    """Each machine and cure that failed, once, with its reason."""
    return list(dict.fromkeys((f"{row.machine}, {row.cure}", row.problem) for row in rows if row.problem))


def _shares(rows: Sequence[Row]) -> list[tuple[str, str]]:
    """Each machine and cure that leaves out some of the surface, once, with how much."""
    out = [row for row in rows if not row.problem and row.left_out > SHARE_SHOWN]
    return list(
        dict.fromkeys(
            (f"{row.machine}, {row.cure}", f"{100.0 * row.left_out:.1f} % of the surface is left out")
            for row in out
        )
    )
