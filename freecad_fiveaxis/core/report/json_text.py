# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report as JSON, for scripts."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Mapping
from enum import Enum
from pathlib import PurePath
from typing import Any

import numpy as np

from .figures import Figures, summary, worst_of_audit, worst_table
from .part_facts import deepest_entries, rest_report
from .scope import scope
from .verdict import verdict

VERSION = 1
"""Of the JSON report, which scripts rely on. ``proven``, ``over_tolerance``, ``unproven``, ``worst_line`` and
``worst_block`` go by ``max_surface_deviation`` and its bound where these are known; ``worst_lines`` names the
NC line of each ``max_`` number by that number's key, null where there is none."""


def as_json(figures: Figures) -> str:
    """Return the report for scripts; infinite and missing numbers are null, severities lower-case words.

    Bytes of a file name that are no Unicode (Python's lone surrogates) become escapes, which JSON readers
    give back.

    Keys: version, summary (see :func:`~freecad_fiveaxis.core.report.figures.summary`; and ``light``: red,
    amber or green, ``verdict``: the sentence, ``reasons``: its parts), worst_blocks, findings, inputs; scope:
    lists of sentences on what is ``proven``, ``assumed`` for that, and ``unknown``; of an
    audit also ``audit``: its worst lines by limits, rates, and distance off the CL path or depth in the part;
    where the part was looked at also ``gouge``: the deepest entries, and ``left``, the rest material (see
    :mod:`~freecad_fiveaxis.core.report.part_facts`).
    """
    numbers = summary(figures)
    report = {
        "version": VERSION,
        "summary": numbers | _verdict(figures, numbers),
        "worst_blocks": worst_table(figures),
        "scope": scope(figures, numbers)._asdict(),
        **({} if figures.audit is None else {"audit": worst_of_audit(figures)}),
        **_of_part(figures),
        "findings": figures.findings,
        "inputs": figures.inputs,
    }
    text = json.dumps(plain(report), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    return text.encode("utf-8", "backslashreplace").decode("utf-8")


def _verdict(figures: Figures, numbers: Mapping[str, Any]) -> dict[str, Any]:
    facts = verdict(figures, numbers)
    return {"light": facts.light.value, "verdict": facts.text, "reasons": facts.reasons}


def _of_part(figures: Figures) -> dict[str, Any]:
    program, facts = figures.program, {}
    if figures.gouge is not None:
        facts["gouge"] = {"deepest": deepest_entries(program, figures.gouge)}
    if figures.rest is not None:
        facts["left"] = rest_report(program, figures.rest, figures.tolerance, figures.allowed)
    return facts


def plain(value: object) -> Any:
    """Return the same in JSON's own kinds: dict, list, str, int, float, bool and None. Other objects become
    their text."""
    if isinstance(value, np.generic | np.ndarray):
        value = value.tolist()
    if isinstance(value, Enum):
        return str(value) if isinstance(value, str) else value.name.lower()
    if value is None or isinstance(value, str | bool | int):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if dataclasses.is_dataclass(value):
        return {one.name: plain(getattr(value, one.name)) for one in dataclasses.fields(value)}
    if isinstance(value, Mapping):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, Iterable) and not isinstance(value, bytes | PurePath):
        return [plain(one) for one in value]
    return str(value)
