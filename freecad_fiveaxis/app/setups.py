# SPDX-License-Identifier: LGPL-2.1-or-later
"""The SetupMap object: where on the machine's table the part of a toolpath could stand, and what each place
costs.

centre     the work zero in the machine frame (mm) about which setups were tried: that of the toolpath when
           they were.
place      where in the document a work zero of the map lies: the part as it is drawn, its work zero shifted
           by so much.
wants_trials  the map's own settings were changed, so that setups are to be tried anew. A change of the
              toolpath only puts the map
           out of date: to try hundreds of setups after every change would hold the user up.

What is recommended is applied to the toolpath by :func:`apply`; the map stays true, for its centre stays
where it was.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import FreeCAD
import numpy as np

from freecad_fiveaxis.core.base.errors import FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import Angle, say
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.pipeline.options import load_setup
from freecad_fiveaxis.core.pipeline.settings import MILL, SETUP, HeadSettings, build_settings
from freecad_fiveaxis.core.studies import study as trials
from freecad_fiveaxis.core.studies.setup_map import SetupMap as Chart
from freecad_fiveaxis.core.studies.setup_map import list_marked_rows, verdict

from . import changes, convert, wording
from .labels import translate
from .long_work import as_before, is_open, listening, run, take_back
from .plain_errors import hide_trace
from .properties import Property, default_value, property_name
from .reports import write_report
from .results import Task
from .schema import Proxy
from .selection import SelectionError
from .setup_properties import LEAVES, OWN, PROPERTIES
from .spreading import processes
from .toolpath import Toolpath, check_fixtures

BEST, PRESENT, BEYOND = "setup-best", "setup-present", "setup-beyond-limits"
"""Kinds of places that have a look of their own."""
FLOOR = 1e-6
"""mm: what is below is coloured as this."""


@dataclass(frozen=True, eq=False)
class Last:
    """What a proxy remembers of the last setups tried."""

    fingerprint: str
    trial: trials.SetupTrial


@dataclass(frozen=True, eq=False)
class Scale:
    """``level`` (k,) of each place: 0 the least deviation of the map, 1 the largest, evenly by its logarithm;
    NaN where the deviation is not known; ``good`` (k,) within the tolerance; ``marks``: level and deviation,
    mm."""

    level: np.ndarray
    good: np.ndarray
    marks: tuple[tuple[float, float], ...]


class SetupMap(Proxy):
    """Proxy of a map of setups."""

    last: Last | None
    wants_trials: bool

    def _begin(self) -> None:
        self.last, self.wants_trials = None, False

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the toolpath, the settings of ``setup`` itself, and the results."""
        return PROPERTIES

    def task(self, obj: Any) -> Task:
        """Return what the object asks of the core, about its Centre. Raises FiveAxisError."""
        if obj.Path is None:
            raise SelectionError(
                say("The toolpath of {label} was deleted: make the map of another one.", label=obj.Label),
                obj.Label,
            )
        path = obj.Path.Proxy.task(obj.Path)
        own = build_settings(
            SETUP, path.settings.source, {"machine": path.settings.machine.machine, **own_options(obj)}
        )
        x, y, z = convert.plain(obj.Centre)
        machine = replace(path.settings.machine, origin=(x, y, z))
        settings = replace(path.settings, task=SETUP, machine=machine, setup=own.setup, head=HeadSettings())
        return Task(settings, path.data, path.runs, path.avoided, fixtures=path.fixtures)

    def onChanged(self, obj: Any, name: str) -> None:
        """Ask for other setups where the map's own settings change."""
        if name in OWN:
            self.wants_trials = True

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        if self.wants_trials or not obj.Fingerprint:
            try_out(obj)
        else:
            obj.UpToDate = is_up_to_date(obj)


def own_options(obj: Any) -> dict[str, Any]:
    """Return the options of ``setup`` itself that differ from their defaults, as a job file would hold
    them."""
    values = {leaf: convert.plain(getattr(obj, property_name(leaf.name))) for leaf in LEAVES}
    return {leaf.name: value for leaf, value in values.items() if value != convert.plain(default_value(leaf))}


def of(path: Any) -> Any:
    """Return the map of a toolpath, or None."""
    return next((one for one in path.InList if isinstance(getattr(one, "Proxy", None), SetupMap)), None)


def setup_map(path: Any, settings: Mapping[str, Any]) -> Any:
    """See :func:`freecad_fiveaxis.app.setup_map`."""
    if not isinstance(getattr(path, "Proxy", None), Toolpath):
        raise SelectionError(say("setups are tried for a toolpath: select a toolpath"), path)
    options = {name: value for name, value in settings.items() if name != "fixtures"}
    build_settings(SETUP, "part.stl", {"machine": path.Machine, **options})
    before, fixtures = list(path.Fixtures), check_fixtures(path, settings.get("fixtures"))
    obj, doc, touched = of(path), path.Document, "Touched" in path.State
    new = obj is None
    if new:
        obj = doc.addObject("App::FeaturePython", "SetupMap")
        SetupMap(obj)
        obj.Label = translate("FiveAxis", "Setup map")
    wanted = obj.Proxy.wants_trials
    try:
        with as_before(obj, (*OWN, "Centre", "UpToDate")):
            if fixtures != before:
                path.Fixtures = fixtures
            _put(obj, path, options)
            try_out(obj)
        if fixtures != before:
            changes.compute(path)
        doc.recompute([obj])
    except BaseException:
        if new:
            take_back(doc, obj)
        else:
            obj.Proxy.wants_trials = wanted  # what it had is put back, and is no change
        if fixtures != before and is_open(doc):
            _hold_again(path, before, touched)
        raise
    return obj


def _put(obj: Any, path: Any, options: Mapping[str, Any]) -> None:
    """Give a map its toolpath and these options; one that is missing goes back to its default."""
    obj.Path = path
    for leaf in LEAVES:
        value = default_value(leaf)
        setattr(obj, property_name(leaf.name), FreeCAD.Vector(*value) if isinstance(value, tuple) else value)
    convert.put_options(obj, SETUP, options)


def _hold_again(path: Any, fixtures: list[Any], touched: bool) -> None:
    """Give a toolpath the fixtures of before, whose results it still shows."""
    path.Fixtures = fixtures
    if not touched:
        path.purgeTouched()


def try_out(obj: Any) -> None:
    """Try the setups about the toolpath's present work zero. Raises FiveAxisError, and then the old map is
    out of date."""
    before, doc = obj.Centre, obj.Document
    obj.UpToDate = False
    try:
        obj.Centre = FreeCAD.Vector(*present_zero(obj.Path))
        trial = trial_of(obj)
    except BaseException:
        if is_open(doc):
            obj.Centre = before
        raise
    _show(obj, trial.chart, obj.Proxy.last.fingerprint)
    obj.Proxy.wants_trials = False


def present_zero(path: Any) -> Vector:
    """Where a toolpath's work zero stands in the machine frame, mm. Raises FiveAxisError."""
    if path is None:
        raise SelectionError(say("the toolpath of the map was deleted: make the map of another one"), path)
    return load_setup(convert.settings_of(path, MILL, "part.stl"))[1].origin


def trial_of(obj: Any, progress: Progress | None = None) -> trials.SetupTrial:
    """Return the core's trial of a map, computed anew only where something has changed. Raises
    FiveAxisError."""
    task = obj.Proxy.task(obj)
    fingerprint = task.fingerprint
    if obj.Proxy.last is None or obj.Proxy.last.fingerprint != fingerprint:
        with listening(progress) as listener, processes() as executor:
            whole = task.with_fixtures_meshed(listener)
            obj.Proxy.last = run(
                lambda progress: _try_setups(whole, fingerprint, progress, executor), listener, obj.Document
            )
    last: Last = obj.Proxy.last
    return last.trial


def _try_setups(task: Task, fingerprint: str, progress: Progress, executor: Executor | None) -> Last:
    mesh, faces = task.mesh_and_mask(progress)
    held = task.mesh_fixtures(progress)
    return Last(fingerprint, trials.try_setups(task.settings, progress, mesh, faces, executor, held))


def is_up_to_date(obj: Any) -> bool:
    """Whether the map is of the toolpath as it is now, wherever that stands."""
    try:
        return bool(obj.Proxy.task(obj).fingerprint == obj.Fingerprint)
    except FiveAxisError:  # a toolpath that is gone or cannot be computed: it says so itself
        return False


def apply(obj: Any) -> Any:
    """Give the toolpath the recommended work zero and compute it; returns it. Raises FiveAxisError.

    A turn of the part is a matter of the solid, which is the user's: it is asked for, not made.
    """
    if not is_up_to_date(obj):
        raise SelectionError(
            say(
                "{label} has changed since: try the setups again",
                label=obj.Path.Label if obj.Path else say("the toolpath"),
            ),
            obj,
        )
    turn = obj.RecommendedTurn.Value
    if turn:
        text = say(
            "turn the part by {turn} about Z through its zero first, counter-clockwise, and try one turn "
            "only",
            turn=Angle(turn),
        )
        raise SettingsError(text, turn)
    convert.put_options(obj.Path.Setup or obj.Path, MILL, {"origin": convert.plain(obj.Recommended)})
    return changes.compute(obj.Path)


def write_page(obj: Any, file: str | os.PathLike[str], overwrite: bool = False) -> None:
    """Write the map as a web page (.html), for scripts (.json) or as text (.txt). Raises FileError for a file
    that is there."""
    write_report(trials.REPORTS, lambda: trial_of(obj), file, overwrite)


def scale(obj: Any) -> Scale:
    """How the places of a map are coloured; from its properties alone."""
    value = np.maximum(np.array(obj.Deviations, float), FLOOR)
    known = value[np.isfinite(value) & (value < convert.UNKNOWN)]
    low, high = (float(known.min()), float(known.max())) if len(known) else (FLOOR, FLOOR)
    spread = math.log(high / low)
    level = np.log(value / low) / spread if spread > 1e-6 else np.zeros(len(value))
    shares = (0.0, 0.25, 0.5, 0.75, 1.0) if spread > 1e-6 else (0.0,)
    tolerance = obj.Path.Tolerance.Value if obj.Path is not None else 0.0
    return Scale(
        np.clip(level, 0.0, 1.0),
        value <= tolerance,
        tuple((at, low * math.exp(at * spread)) for at in shares),
    )


def _show(obj: Any, chart: Chart, fingerprint: str) -> None:
    """Show a map in the object's properties."""
    best = chart.best
    assert best is not None  # the core refuses a region that leaves every limit
    marked = list_marked_rows(chart)
    shift = FreeCAD.Vector(*obj.Path.WorkZero) - FreeCAD.Vector(*chart.base.origin)
    values = {
        "Recommended": FreeCAD.Vector(*chart.origin[best]), "RecommendedTurn": math.degrees(chart.turn[best]),
        "DeviationBefore": _store_number(chart.max_deviation[0]),
        "DeviationAfter": _store_number(chart.max_deviation[best]),
        "TimeBefore": _store_number(chart.time[0]), "TimeAfter": _store_number(chart.time[best]),
        "Verdict": _verdict(obj, chart),
        "Findings": [wording.localize(finding.text) for finding in chart.findings],
        "Places": [FreeCAD.Vector(*chart.origin[row]) + shift for row, _ in marked],
        "Kinds": [kind for _, kind in marked],
        "Deviations": [_store_number(chart.max_deviation[row]) for row, _ in marked],
        "Fingerprint": fingerprint, "UpToDate": True,
    }  # fmt: skip
    for name, value in values.items():
        setattr(obj, name, value)


def divides_blocks(path: Any) -> bool:
    """Whether the program of a toolpath has its blocks divided until they keep the tolerance; setups are
    tried without that."""
    return path is not None and (path.Linearize == "on" or path.Singularity == "linearize")


def _verdict(obj: Any, chart: Chart) -> str:
    text = wording.localize(verdict(chart))
    more = say(
        "These are deviations of blocks that are not yet divided: the program's own keep its tolerance."
    )
    return f"{text} {wording.localize(more)}" if divides_blocks(obj.Path) else text


def _store_number(value: float) -> float:
    return float(value) if math.isfinite(value) else convert.UNKNOWN
