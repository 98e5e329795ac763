# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an audit adds to the figures: numbers for the summary, and its worst lines."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from freecad_fiveaxis.core.audit import Audit, find_timed_feeds
from freecad_fiveaxis.core.audit.rates import DEGREES, RATE_ROUNDING
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.motion.program.feeds import STILL

from .block_table import letter_order


def summarize_audit(program: Program, audit: Audit | None) -> dict[str, Any]:
    """Return the numbers of an audit; empty without one. Feeds mm/min, lengths mm, angles degrees; None where
    nothing is known."""
    if audit is None:
        return {}
    timed = find_timed_feeds(program)
    moving = timed[audit.rates.travel[timed] > STILL]
    feed = audit.rates.tip_feed[moving]
    quickest = int(audit.rates.ratio.argmax()) if len(program.words) else 0
    farthest = int(audit.limits.excess.argmax()) if len(program.words) else 0
    facts = {
        "over_limit_blocks": int((audit.limits.excess > 0.0).sum()),
        "max_limit_excess": _largest(audit.limits.excess),
        "limit_axis": _letter(program, audit.limits.axis, farthest, audit.limits.excess),
        "limit_line": _line(program, farthest, audit.limits.excess),
        "over_rate_blocks": int((audit.rates.ratio > 1.0 + RATE_ROUNDING).sum()),
        "max_rate_ratio": _largest(audit.rates.ratio),
        "rate_axis": _letter(program, audit.rates.axis, quickest, audit.rates.ratio),
        "rate_line": _line(program, quickest, audit.rates.ratio),
        "untimed_blocks": len(feed_blocks(program)) - len(timed),
        "least_tip_feed": float(feed.min()) if len(feed) else None,
        "least_tip_feed_line": int(program.line[moving[feed.argmin()]]) if len(feed) else None,
        "median_tip_feed": float(np.median(feed)) if len(feed) else None,
        "largest_tip_feed": float(feed.max()) if len(feed) else None,
        "largest_tip_feed_line": int(program.line[moving[feed.argmax()]]) if len(feed) else None,
    }
    return facts | _against(program, audit)


def _against(program: Program, audit: Audit) -> dict[str, Any]:
    if (path := audit.path) is not None:
        worst = int(path.block[path.off.argmax()]) if len(path.block) else None
        return {
            "max_off_path": _largest(path.off),
            "off_path_bound": _largest(path.bound),
            "off_path_line": None if worst is None else int(program.line[worst]),
            "max_end_off_path": _largest(path.end),
            "max_axis_off_deg": math.degrees(_largest(path.axis)),
            "missed_rows": len(path.missed),
        }
    if (part := audit.part) is not None:
        worst = int(part.block[part.depth.argmax()]) if len(part.block) else None
        return {
            "max_overcut": _largest(part.depth),
            "overcut_bound": _largest(part.bound),
            "overcut_line": None if worst is None else int(program.line[worst]),
            "largest_clearance": None if math.isnan(part.clearance) else part.clearance,
        }
    return {}


def _largest(values: Floats) -> float:
    return float(values.max(initial=0.0))


def _line(program: Program, row: int, values: Floats) -> int | None:
    return int(program.line[row]) if len(values) and values[row] > 0.0 else None


def _letter(program: Program, axis: Any, row: int, values: Floats) -> str | None:
    return program.letters[int(axis[row])] if len(values) and values[row] > 0.0 else None


def audit_rows(program: Program, audit: Audit, rows: Ints) -> list[dict[str, Any]]:
    """Return what the audit found in the blocks ``rows``: words mm and deg, rates mm/min and deg/min."""
    order, (off, bound) = letter_order(program.letters), audit.off()
    rates = audit.rates.rate[rows] * DEGREES
    return [
        {
            "words": {program.letters[k]: float(program.words[row, k]) for k in order},
            "feed": float(program.feed[row]),
            "tip_feed": float(audit.rates.tip_feed[row]),
            "rate": {program.letters[k]: float(rates[at, k]) for k in order},
            "rate_ratio": float(audit.rates.ratio[row]),
            "rate_axis": program.letters[int(audit.rates.axis[row])],
            "limit_excess": float(audit.limits.excess[row]),
            "off": float(off[row]),
            "off_bound": float(bound[row]),
        }
        for at, row in enumerate(rows.tolist())
    ]


WORST = 10
"""So many lines of each kind are named."""


def worst_of(values: Floats, above: float) -> Ints:
    """Return the rows of the largest of ``values`` (m,) that are above ``above``, the largest first, the
    earlier first among equals."""
    rows = np.flatnonzero(values > above)
    return rows[np.argsort(-values[rows], kind="stable")][:WORST]


def audit_facts(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the numbers of an audit as pairs of name and value with unit; none without one."""
    if "over_limit_blocks" not in numbers:
        return []
    unit = "mm" if (numbers["limit_axis"] or "X") in "XYZ" else "deg"
    beyond = (
        f", at most {numbers['limit_axis']} by {numbers['max_limit_excess']:.4f} {unit} (NC line "
        f"{numbers['limit_line']})"
    )
    most = (
        "" if numbers["rate_axis"] is None else f" ({numbers['rate_axis']}, NC line {numbers['rate_line']})"
    )
    feeds = [
        f"{value:.5g}"
        for value in (numbers[f"{name}_tip_feed"] for name in ("least", "median", "largest"))
        if value is not None
    ]
    untimed = (
        [("feed blocks whose time is not known", f"{numbers['untimed_blocks']}")]
        if numbers["untimed_blocks"]
        else []
    )
    return [
        (
            "blocks beyond a limit",
            f"{numbers['over_limit_blocks']}{beyond if numbers['over_limit_blocks'] else ''}",
        ),
        ("blocks that ask too much of an axis", f"{numbers['over_rate_blocks']}"),
        ("largest share of an axis' maximum rate", f"{numbers['max_rate_ratio']:.3g}{most}"),
        ("feed over the part, least median largest", f"{' '.join(feeds)} mm/min" if feeds else "-"),
        *untimed,
        *_against_facts(numbers),
    ]


def _against_facts(numbers: Mapping[str, Any]) -> list[tuple[str, str]]:
    if "max_off_path" in numbers:
        line = "" if numbers["off_path_line"] is None else f" (NC line {numbers['off_path_line']})"
        return [
            ("largest distance off the CL path", f"{numbers['max_off_path']:.6f} mm{line}"),
            ("its proven upper bound", f"{numbers['off_path_bound']:.6f} mm"),
            ("largest at a block's end", f"{numbers['max_end_off_path']:.6f} mm"),
            ("tool axis off the CL path's, at ends", f"{numbers['max_axis_off_deg']:.4f} deg"),
            ("rows of the CL path that are not cut", f"{numbers['missed_rows']}"),
        ]
    if "max_overcut" in numbers:
        line = "" if numbers["overcut_line"] is None else f" (NC line {numbers['overcut_line']})"
        clear = numbers["largest_clearance"]
        return [
            ("deepest overcut of the cutter", f"{numbers['max_overcut']:.6f} mm{line}"),
            ("its proven upper bound", f"{numbers['overcut_bound']:.6f} mm"),
            *([] if clear is None else [("largest clearance", f"{clear:.4f} mm")]),
        ]
    return []
