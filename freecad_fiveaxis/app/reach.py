# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ReachMap object: where on a part a tool gets at all, before any pass is computed, and what is in the
way elsewhere.

map       the core's, of the mesh with the object's own settings; the same numbers as ``fiveaxis reach`` gives
          for the same mesh.
stick-out how much farther the tool would have to stick out where only the holder is in the way: the least of
the lengths tried
          that frees ENOUGH of that area, else the one that frees most.

Places and axes are arrays and not saved: after a document was opened they are found again when the map is
drawn.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Any

import FreeCAD
import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.quantity import ANGLES, parse
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Area, Length, Sentence, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Obstacle
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline.settings import REACH, build_settings
from freecad_fiveaxis.core.studies import study
from freecad_fiveaxis.core.studies.reach_map import LONGER_HELPS
from freecad_fiveaxis.core.studies.reach_map import ReachMap as Chart
from freecad_fiveaxis.core.studies.reach_report import (
    flank_remedy,
    name_fixtures,
    name_shut,
    share_reached,
    verdict,
)
from freecad_fiveaxis.core.studies.smaller_ball import smaller_ball

from . import compared, convert, results, selection, tessellation, wording
from .arguments import deflections, names, place
from .job_setup import DEFAULT_MACHINE
from .labels import translate
from .long_work import listening, run, take_back
from .plain_errors import hide_trace
from .previewing import part_of
from .properties import Property, list_options, setting_properties
from .reach_properties import ANY_ANGLE, PROPERTIES
from .schema import Proxy
from .selection import SelectionError
from .spreading import processes
from .toolpath import Toolpath, check_fixtures, mesh_is_gone

ENOUGH = 0.9
"""Of the area that only the holder keeps from being cut."""
AREAS = {
    Obstacle.NONE: "ReachableArea", Obstacle.CUTTER: "TighterThanCutter",
    Obstacle.FLANK: "FlankInTheWay", Obstacle.SHANK: "ShankInTheWay",
    Obstacle.HOLDER: "HolderInTheWay", Obstacle.FIXTURE: "FixtureInTheWay",
    Obstacle.MACHINE: "MachineInTheWay", Obstacle.TABLE: "BelowTable",
    Obstacle.LIMITS: "BeyondMachine", Obstacle.HOLLOW: "InClosedHollow",
}  # fmt: skip
"""The property that holds the area of each reason, in the order of the legend."""
WORTH = 3
"""Processes: to divide the places costs a tenth to a quarter more work, which two do not bring back."""
OWN = (
    "fixtures",
    "largest_axis_angle",
    "work_zero",
    "faces",
    "avoid",
    "linear_deflection",
    "angular_deflection",
)
"""Settings that are no options of the core's task."""
OF_MESH = ("faces", "avoid", "linear_deflection", "angular_deflection")
"""Those of them that are of the mesh."""


@dataclass(frozen=True, eq=False)
class Last:
    """What a map is drawn from, work frame: the ``trial`` over the facets of ``mesh``; ``smaller``: mm, the
    radius of a ball that would be free on ENOUGH of the area where the cutter is too large, as
    :func:`~.smaller_ball`."""

    fingerprint: str
    mesh: Mesh
    trial: study.ReachTrial
    smaller: float | None

    @property
    def chart(self) -> Chart:
        """Places, their reasons and axes."""
        return self.trial.found


class ReachMap(Proxy):
    """Proxy of a reach map."""

    settles = True
    last: Last | None

    def _begin(self) -> None:
        self.last, self.seen = None, dict[str, compared.Seen]()

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the mesh, the fixtures, the settings of task ``reach``, the work zero and the results."""
        return PROPERTIES

    def task(self, obj: Any) -> results.Task:
        """Return what the object asks of the core. Raises FiveAxisError."""
        if obj.Mesh is None:
            raise mesh_is_gone(obj)
        if not selection.is_mesh(obj.Mesh):
            text = say("{label} is no mesh: choose a tessellation or a mesh.", label=obj.Mesh.Label)
            raise SelectionError(text, obj.Mesh.Label)
        if "Invalid" in obj.Mesh.State:  # its facets are those of before: of another solid, or of other faces
            text = say(
                "{label} could not be computed: {why}", label=obj.Mesh.Label, why=obj.Mesh.getStatusString()
            )
            raise SelectionError(text, obj.Mesh.Label)
        fixtures = check_fixtures(obj)
        options = convert.options_of(obj, REACH) | compared.fixture_names(fixtures)
        settings = build_settings(REACH, f"{obj.Mesh.Label}.stl", options)
        most = math.radians(convert.plain(obj.LargestAxisAngle))
        settings = replace(settings, passes=replace(settings.passes, max_axis_angle=most))
        facets, zero = convert.facets_of(obj.Mesh, obj.WorkZero), tuple(obj.WorkZero)
        solids = compared.find_held_parts(fixtures, zero, self.seen)
        return results.Task(settings, facets, *results.runs_of(obj.Mesh, settings), fixtures=solids)

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        obj.UpToDate = False
        _show(obj, find_map(obj))


def reach_map(base: Any, settings: Mapping[str, Any], obj: Any = None) -> Any:
    """See :func:`freecad_fiveaxis.app.reach_map`. ``obj``: a map that is there already and gets these
    settings."""
    if obj is None and isinstance(getattr(base, "Proxy", None), Toolpath):
        settings, base = _of_path(base, settings)
    options = {name: value for name, value in settings.items() if name not in OWN and value is not None}
    options.setdefault("machine", DEFAULT_MACHINE)
    build_settings(REACH, "part.stl", options)
    load_machine(options["machine"])
    own = _own(settings)
    doc, added = _document(base if obj is None else obj), list[Any]()
    fixtures = compared.check_held(doc, settings.get("fixtures"))
    try:
        if obj is None:
            mesh = _mesh_of(base, settings, added)
            obj = doc.addObject("App::FeaturePython", "ReachMap")
            added.append(obj)
            ReachMap(obj)
            obj.Label, obj.Mesh = translate("FiveAxis", "Reach map"), mesh
        _put(obj, options, own | {"Fixtures": fixtures})
        find_map(obj)  # errors reach the caller; the recompute then finds the work done
        obj.touch()
        doc.recompute([obj])
    except BaseException:
        take_back(doc, *added)
        raise
    return obj


def _of_path(path: Any, settings: Mapping[str, Any]) -> tuple[dict[str, Any], Any]:
    """Return the settings with what a Toolpath says, and its mesh; its part where other faces or another mesh
    of that are asked for. Raises SelectionError."""
    whole = take_over(path) | dict(settings)
    if not any(settings.get(name) is not None for name in OF_MESH):
        if path.Mesh is None:
            raise mesh_is_gone(path)
        return whole, path.Mesh
    part = part_of(path, settings)
    sizes = {"linear_deflection": part.linear, "angular_deflection": part.angular}
    chosen = {"faces": part.faces, "avoid": part.avoid}
    return (whole, part.base) if part.mesh is None else (whole | chosen | sizes, part.base)


def _document(given: Any) -> Any:
    """Return the document of an object, or of an object with names of its faces. Raises SelectionError for
    anything else."""
    base = given[0] if isinstance(given, (tuple, list)) and len(given) == 2 else given
    if getattr(base, "Document", None) is None:
        raise SelectionError(say("Nothing is selected: {what}.", what=selection.WHAT), None)
    return base.Document


def _mesh_of(base: Any, settings: Mapping[str, Any], added: list[Any]) -> Any:
    """Return the mesh object of what is selected; of a solid, or of faces of it, a new tessellation."""
    base, chosen = (base[0], base[1]) if isinstance(base, (tuple, list)) else (base, ())
    faces, avoid = names(settings.get("faces") or chosen or ()), names(settings.get("avoid") or ())
    if selection.is_mesh(base) and not faces and not avoid:
        return base
    if base.State != ["Up-to-date"] or base.MustExecute:
        base.Document.recompute([base])
    added.append(tessellation.make(base.Document, base, faces, avoid=avoid, **deflections(settings)))
    return added[-1]


def _own(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Return the properties that are no options of the core's task. Raises SettingsError."""
    zero, angle = settings.get("work_zero"), settings.get("largest_axis_angle")
    degrees = ANY_ANGLE if angle is None else parse(angle, ANGLES, "largest axis angle") / ANGLES["deg"]
    if not 0.0 < degrees <= ANY_ANGLE:
        text = say(
            "largest axis angle {angle} is out of range; it must be above 0 and at most 180", angle=str(angle)
        )
        raise SettingsError(text, angle)
    at = (0.0, 0.0, 0.0) if zero is None else place(zero, "work_zero")
    return {"WorkZero": FreeCAD.Vector(*at), "LargestAxisAngle": degrees}


def _put(obj: Any, options: Mapping[str, Any], own: Mapping[str, Any]) -> None:
    """Give the map all of these settings; an option that is not among them goes back to its default. Raises
    SettingsError."""
    for one in setting_properties(REACH):
        if one.default is not None and one.name not in ("Machine",):
            setattr(
                obj, one.name, FreeCAD.Vector(*one.default) if isinstance(one.default, tuple) else one.default
            )
    convert.put_options(obj, REACH, options)
    for name, value in own.items():
        setattr(obj, name, value)


def take_over(path: Any) -> dict[str, Any]:
    """Return what a Toolpath says of machine, tool and part, as :func:`reach_map` takes it."""
    options, known = convert.options_of(path, "mill"), {leaf.name for _, leaf in list_options(REACH)}
    angle = (
        {"largest_axis_angle": path.MaxAxisAngle.Value}
        if path.ToolAxis == "auto" and path.MaxAxisAngle.Value
        else {}
    )
    shared = {name: value for name, value in options.items() if name in known}
    return (
        shared
        | {"machine": path.Machine, "work_zero": tuple(path.WorkZero), "fixtures": list(path.Fixtures)}
        | angle
    )


def settings_of(obj: Any) -> dict[str, Any]:
    """Return what a map says, as :func:`reach_map` takes it."""
    own = {
        "work_zero": tuple(obj.WorkZero),
        "fixtures": list(obj.Fixtures),
        "largest_axis_angle": obj.LargestAxisAngle.Value,
    }
    return convert.options_of(obj, REACH) | {"machine": obj.Machine} | own


def find_map(obj: Any, progress: Progress | None = None) -> Last:
    """Return the core's map, computed anew only where something has changed.

    Raises FiveAxisError for what cannot be used, Cancelled where the listener stops the work.
    """
    task = obj.Proxy.task(obj)
    fingerprint = task.fingerprint
    if obj.Proxy.last is None or obj.Proxy.last.fingerprint != fingerprint:
        with listening(progress) as listener:
            whole = task.with_fixtures_meshed(listener)
            with processes(WORTH) as executor:
                obj.Proxy.last = run(
                    lambda progress: _compute_map(whole, fingerprint, progress, executor),
                    listener,
                    obj.Document,
                )
    last: Last = obj.Proxy.last
    return last


def _compute_map(task: results.Task, fingerprint: str, progress: Progress, executor: Executor | None) -> Last:
    mesh, faces = task.mesh_and_mask(progress)
    fixtures = task.mesh_fixtures(progress)
    most = task.settings.passes.max_axis_angle
    trial = study.try_reach(task.settings, progress, mesh, faces, fixtures, most or math.pi, executor)
    smaller = smaller_ball(mesh, trial.reacher, trial.found, ENOUGH, fixtures, progress)
    return Last(fingerprint, mesh, trial, smaller)


def find_chosen_facets(found: Last) -> Bools:
    """Return the facets (f,) that the map covers."""
    mask = np.zeros(len(found.mesh.face), np.bool_)
    mask[found.chart.facet] = True
    return mask


def axis_field(found: Last) -> tuple[Floats, Floats]:
    """Return the places (k, 3) mm that are free and the unit axes (k, 3) that are."""
    free = found.chart.obstacle == Obstacle.NONE
    return found.chart.point[free], found.chart.axis[free]


def stick_out(chart: Chart) -> tuple[float, float]:
    """How much farther, mm, the tool should stick out, and the area, mm2, that it reaches then besides;
    zeros: no help."""
    if not chart.longer:
        return 0.0, 0.0
    held = compute_held_area(chart)
    return next((one for one in chart.longer if one[1] >= ENOUGH * held), chart.longer[-1])


def compute_held_area(chart: Chart) -> float:
    """mm2 where holder, fixtures or machine are in the way, and a tool that sticks out farther may help."""
    return sum(chart.area_of(one) for one in LONGER_HELPS)


def radius_too_large(found: Last) -> float:
    """By how much, mm, the ball's radius is too large where the cutter is; 0 where that is nowhere or not
    known."""
    return found.trial.reacher.cutter.radius - found.smaller if found.smaller else 0.0


def advice(found: Last) -> list[Sentence]:
    """Return what would help where the holder is in the way, and where the cutter is too large or its
    flank in the way, and where the tool cannot be withdrawn: a sentence each."""
    chart = found.chart
    held, (step, area) = compute_held_area(chart), stick_out(chart)
    by_machine, by_fixture = (chart.area_of(one) > 0.0 for one in (Obstacle.MACHINE, Obstacle.FIXTURE))
    sentences = []
    if by_fixture and step > 0.0:
        sentences.append(say(
            "Let the tool stick out {step} farther and it reaches {area} of the {held} where holder, fixture "
            "or machine are in the way.",
            step=Length(step), area=Area(area, ".3g"), held=Area(held, ".3g"),
        ))  # fmt: skip
    elif by_fixture:
        sentences.append(
            say(
                "Where holder, fixture or machine are in the way, no tool that sticks out up to 80 mm "
                "farther helps."
            )
        )
    elif by_machine and step > 0.0:
        sentences.append(say(
            "Let the tool stick out {step} farther and it reaches {area} of the {held} where holder or "
            "machine are in the way.",
            step=Length(step), area=Area(area, ".3g"), held=Area(held, ".3g"),
        ))  # fmt: skip
    elif by_machine:
        sentences.append(
            say("Where holder or machine are in the way, no tool that sticks out up to 80 mm farther helps.")
        )
    elif held > 0.0 and step > 0.0:
        sentences.append(say(
            "Let the tool stick out {step} farther and it reaches {area} of the {held} where the holder is "
            "in the way.",
            step=Length(step), area=Area(area, ".3g"), held=Area(held, ".3g"),
        ))  # fmt: skip
    elif held > 0.0:
        sentences.append(
            say("Where the holder is in the way, no tool that sticks out up to 80 mm farther helps.")
        )
    if found.smaller:
        sentences.append(say(
            "Where the cutter is too large, a ball of {diameter}, its radius {more} smaller, fits on 90 % of "
            "that area.",
            more=Length(radius_too_large(found), ".3g"), diameter=Length(2.0 * found.smaller, ".3g"),
        ))  # fmt: skip
    elif found.smaller == 0.0:
        sentences.append(
            say("Where the cutter is too large, no ball down to a tenth of it fits on 90 % of that area.")
        )
    if flank := chart.area_of(Obstacle.FLANK):
        sentences.append(flank_remedy(flank))
    return [*sentences, *name_fixtures(chart), *name_shut(chart)]


def _show(obj: Any, found: Last) -> None:
    """Show the map in the object's properties."""
    chart = found.chart
    values: dict[str, Any] = {name: chart.area_of(obstacle) for obstacle, name in AREAS.items()}
    step, area = stick_out(chart)
    values |= {
        "WholeArea": float(chart.area.sum()), "ReachableShare": 100.0 * share_reached(chart),
        "StickOut": step,
        "StickOutArea": area, "RadiusTooLarge": radius_too_large(found),
        "Advice": " ".join(wording.localize(one) for one in advice(found)),
        "Verdict": wording.localize(verdict(chart)),
        "Findings": [wording.localize(finding.text) for finding in found.trial.findings],
        "Fingerprint": found.fingerprint,
        "UpToDate": True,
    }  # fmt: skip
    for name, value in values.items():
        setattr(obj, name, value)


def out_of_date(obj: Any) -> str:
    """Why the map does not show what the tool reaches now; an empty text where it does."""
    return results.out_of_date(obj)
