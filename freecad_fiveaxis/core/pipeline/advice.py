# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would finish more of a part: a few other settings, tried with the whole pipeline before they are
advised.

trial     the same part with some options changed: its program is made and proven, and what it leaves is
          measured.
finished  area of the facets that are cut, less that on which more is left than may be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Area, Choice, Option, Sentence, join_sentences, say
from freecad_fiveaxis.core.tool import cutter_text

from .collision_avoidance import compute_finished_area, compute_unfinished_share
from .over_table import AUTO
from .programs import MilledProgram, Result
from .settings import MILL, Settings, build_settings, flat_options

SCALLOP = "scallop"
LEAST, SHARE = 1.0, 0.01
"""mm2, and share of what is finished, below which a gain is none."""
SMALLER = (0.5, 1.0 / 3.0)
"""Of the diameter of a ball: these are tried."""
SMALLER_LEVEL = (0.5,)
"""The same of a cutter that ends level: a ball of its diameter is tried besides."""
NOT_PLANES = ("plane_normal", "direction")
"""Options that only planes have: who gives one asks for planes."""
NOTHING_TO_TRY = say(
    "For this cutter and these passes there is no other setting that is known to finish more, so none was "
    "tried."
)

Run = Callable[[Settings], Result]


@dataclass(frozen=True)
class Trial:
    """``changes``: the options that differ, as in a job file, None where one is left out; ``finished`` and
    ``gain`` mm2, ``seconds`` of the program; ``error``: why it cannot be made, one line, or empty."""

    changes: Mapping[str, Any]
    finished: float = 0.0
    gain: float = 0.0
    seconds: float = 0.0
    error: str = ""


def measure_finished(result: Result) -> float:
    """Measure the area, mm2, that a program finishes."""
    draft = result.draft
    assert isinstance(draft, MilledProgram)
    return compute_finished_area(result.findings, draft.mesh, draft.keep)


def try_others(result: Result, run: Run) -> tuple[Trial, ...]:
    """Try what may finish more than a program of ``mill`` does, the largest gain first; ``run`` makes and
    proves a program of the same part, faces and fixtures. Raises Cancelled."""
    settings = result.draft.settings
    before = measure_finished(result if result.rest is not None else run(_apply_changes(settings, {})))
    found = [
        _try(_apply_changes(settings, changes), changes, before, run) for changes in find_changes(settings)
    ]
    return tuple(sorted(found, key=lambda one: -one.gain))


def find_changes(settings: Settings) -> Iterator[dict[str, Any]]:
    """Give the changes that are worth a trial: other passes, free tool axes, both, a smaller ball; for a
    cutter that ends level a ball of its diameter with free tool axes, which no other has, and a smaller
    one."""
    passes = {} if settings.passes.passes == SCALLOP else {"passes": SCALLOP, **dict.fromkeys(NOT_PLANES)}
    cutter = settings.cutter.cutter
    ball = cutter.touches_as_ball and cutter.corner > 0.0
    free = {"tool_axis": AUTO, "max_axis_angle": None}
    axes = {} if settings.tool_axis.tool_axis == AUTO or not ball else free
    yield from (one for one in (passes, axes) if one)
    if passes and axes:
        yield passes | axes
    if cutter.has_level_bottom:
        yield {"cutter": cutter_text(replace(cutter, corner=cutter.radius)), **free}
    smaller = SMALLER if ball else SMALLER_LEVEL if cutter.has_level_bottom else ()
    yield from ({"cutter": cutter_text(cutter.scale(share))} for share in smaller)


def _apply_changes(settings: Settings, changes: Mapping[str, Any]) -> Settings:
    """Return the settings with these changes, and what is left measured."""
    options = {**flat_options(settings), "rest": "on", **changes}
    given = {
        name: value
        for name, value in options.items()
        if value is not None and name not in ("task", "source", "advise")
    }
    return build_settings(MILL, settings.source, given)


def _try(settings: Settings, changes: Mapping[str, Any], before: float, run: Run) -> Trial:
    try:
        result = run(settings)
    except Cancelled:
        raise
    except FiveAxisError as error:
        return Trial(changes, error=str(error))
    finished = measure_finished(result)
    return Trial(changes, finished, finished - before, float(result.draft.program.seconds.sum()))


def is_worth(trial: Trial) -> bool:
    """Tell whether a trial finishes more than a little more."""
    return trial.gain >= max(LEAST, SHARE * (trial.finished - trial.gain))


def add_advice(result: Result, run: Run) -> Result:
    """Add what would finish more to the findings of a program that leaves something."""
    draft = result.draft
    if (
        not isinstance(draft, MilledProgram)
        or compute_unfinished_share(result.findings, draft.mesh, draft.keep) < SHARE
    ):
        return result
    found = report_advice(try_others(result, run), float(draft.program.seconds.sum()))
    return replace(result, findings=(*result.findings, found))


def report_advice(trials: tuple[Trial, ...], seconds: float) -> Finding:
    """Tell which of the trials gains most, or that none does; ``seconds`` of the program that was asked
    for."""
    if not trials:
        return report_finding(Code.ADVICE, NOTHING_TO_TRY)
    best = trials[0]
    if not is_worth(best):
        tried = join_sentences([name_changes(one.changes) for one in trials], "; ")
        return report_finding(Code.ADVICE, say("Tried, and none finishes more: {tried}.", tried=tried))
    text = say(
        "Tried: {changes} would finish {gain} more, {finished} in all; the program then takes {time} instead "
        "of {before}.",
        changes=name_changes(best.changes), gain=Area(best.gain, ".4g"), finished=Area(best.finished, ".4g"),
        time=clock(best.seconds), before=clock(seconds),
    )  # fmt: skip
    return report_finding(Code.ADVICE, text, best.gain)


def name_changes(changes: Mapping[str, Any]) -> Sentence:
    """Name options and what they are changed to, as the user asks for it."""
    return join_sentences(
        [_name_change(name, str(value)) for name, value in changes.items() if value is not None], ", "
    )


def _name_change(name: str, value: str) -> Sentence:
    if name == "cutter":
        return Sentence("{option} {value}", {"option": Option(name), "value": value}, translated=False)
    return Sentence("{choice}", {"choice": Choice(name, (value,), flag=True)}, translated=False)


def clock(seconds: float) -> str:
    """Write a time as hours, minutes and seconds."""
    whole = round(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"
