# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of the ways that were tried on a part leaves least, and is done soonest.

rank      1 for the best of the jobs of a part. Those that leave and take the same share a rank, and the next
          ones are left out. A job that failed, or whose program is NOT SAFE, has none; nor has the only job
          of a part.
finish    the scallop or stepover asked for. Unfinished is what keeps more than twice the scallop, so that the
          coarsest passes would leave least: jobs of another finish are ranked apart.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from freecad_fiveaxis.core.base.sentences import Number, Sentence, say
from freecad_fiveaxis.core.report.verdict import Light

from .task import FAILED

SHARE_DIGITS = 1
"""Decimals of a percentage that stays unfinished: less than that is no reason to mill longer."""

Row = Mapping[str, Any]


def rank_rows(rows: Sequence[Row]) -> list[Row]:
    """Return the rows of the report with their ``rank``; those of one part and finish together, the best
    first, without a rank last, otherwise in their order."""
    return [row for own in _by_finish(rows).values() for row in _rank_part(own)]


def best_lines(rows: Sequence[Row]) -> list[Sentence]:
    """One sentence for each part and finish that was milled in several ways; ``rows`` as ranked gives
    them."""
    own = _by_finish(rows)
    several = Counter(part for part, _ in own)
    return [
        _best_line(
            say("{part} with {finish}", part=part, finish=finish) if finish and several[part] > 1 else part,
            jobs,
        )
        for (part, finish), jobs in own.items()
        if len(jobs) > 1
    ]


def _by_finish(rows: Sequence[Row]) -> dict[tuple[str, str], list[Row]]:
    """Return the rows of each part and finish, the parts in their order; what failed stands with the first
    of its part."""
    parts = dict[str, dict[str, list[Row]]]()
    for row in sorted(rows, key=_has_failed):
        own = parts.setdefault(str(row["part"]), {})
        finish = next(iter(own), "") if _has_failed(row) else _name_finish(row)
        own.setdefault(finish, []).append(row)
    order = dict.fromkeys(str(row["part"]) for row in rows)
    return {(part, finish): jobs for part in order for finish, jobs in parts[part].items()}


def _has_failed(row: Row) -> bool:
    return bool(row["verdict"] == FAILED)


def _name_finish(row: Row) -> str:
    """Return what was asked of the passes; empty where an older report does not tell."""
    named = (("scallop", row.get("scallop_mm")), ("stepover", row.get("stepover_mm")))
    return ", ".join(f"{name} {float(value):g} mm" for name, value in named if value is not None)


def _rank_part(rows: Sequence[Row]) -> list[Row]:
    if len(rows) < 2:
        return [{**row, "rank": None} for row in rows]
    found, place = list[Row](), 1
    for merit, group in groupby(sorted(rows, key=_merit), _merit):
        same = list(group)
        rank = place if _is_usable(merit) else None
        found += [{**row, "rank": rank} for row in same]
        place += len(same)
    return found


def _merit(row: Row) -> tuple[int, float, float]:
    """Return what is smaller is better: 0 for a program that may be used, 1 for one that is NOT SAFE, 2 for
    none; the percentage that stays unfinished; minutes. A number that is not known is worse than any
    other."""
    grave = {FAILED: 2, Light.RED.value: 1}.get(str(row["verdict"]), 0)
    return grave, round(_read_number(row, "unfinished_percent"), SHARE_DIGITS), _read_number(row, "minutes")


def _is_usable(merit: tuple[int, float, float]) -> bool:
    return merit[0] == 0


def _read_number(row: Row, name: str) -> float:
    value = row.get(name)
    return math.inf if value is None else float(value)


def _best_line(part: str | Sentence, rows: Sequence[Row]) -> Sentence:
    best = [row for row in rows if row["rank"] == 1]
    if not best:
        return say("{part}: none of {count} ways makes a program that is safe", part=part, count=len(rows))
    names = ", ".join(map(_place, best))
    return say(
        "{part}: best of {count}: {names}, {share} % unfinished, {minutes} min",
        part=part, count=len(rows), names=names,
        share=_number(best[0], "unfinished_percent", f".{SHARE_DIGITS}f"),
        minutes=_number(best[0], "minutes", ".4g"),
    )  # fmt: skip


def _place(row: Row) -> str:
    """Return the name of a job; where reports are merged, with the folder of its files."""
    return str(row["name"]) if row.get("folder", ".") == "." else f"{row['folder']}/{row['name']}"


def _number(row: Row, name: str, form: str) -> Number | str:
    return "?" if row.get(name) is None else Number(float(row[name]), form)
