# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one crossing between FreeCAD and the core: properties <-> Settings, meshes -> Mesh, figures ->
properties.

work frame   parallel to the document; its zero is the object's WorkZero.
STL bytes    the mesh as 32-bit facets. The core's mesh is always read from them, so that a file with the same
             bytes gives the same program on the command line.
"""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import FreeCAD
import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.quantity import parse_stack
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.pipeline.option_values import read_option
from freecad_fiveaxis.core.pipeline.settings import AUDIT, Settings, build_settings, with_current_names
from freecad_fiveaxis.core.report import Figures, find_largest_judged, summary, verdict
from freecad_fiveaxis.core.tool import SIZES, Cutter, parse_cutter, sizes_text
from freecad_fiveaxis.core.tool.body import Body, body_of

from . import wording
from .facets import STL, Facets, kernel_of
from .properties import (
    MACHINES_OWN,
    cutter_values,
    default_value,
    list_options,
    property_name,
    property_value,
)
from .result_properties import RESULTS
from .selection import empty, holder_of

_HEADER = 84


class Tool(NamedTuple):
    """A cutter, and the body of cutter, shank and holder that must not enter the part."""

    cutter: Cutter
    body: Body


CHOSEN = ("passes", "tool_axis")
"""Options that the core chooses by the others where they are not given."""
UNKNOWN = 1e9
"""mm or s, shown where the core found no finite number: no property can hold one that is infinite."""

# ------------------------------------------------------------------------------------------------ settings


def settings_of(obj: Any, task: str, source: str) -> Settings:
    """Return the core's settings out of the object's properties; all checks are the core's. Raises
    SettingsError.

    A property at its default is not given at all, so that the core's own default stands to the last bit.
    """
    return build_settings(task, source, options_of(obj, task))


def options_of(obj: Any, task: str) -> dict[str, Any]:
    """Return the options of the task that differ from their defaults, as a job file would hold them (mm, deg,
    mm/min). Those whose default hangs on others are always given: the property says what is cut."""
    options: dict[str, Any] = {}
    for _, leaf in list_options(task):
        kind = leaf.metadata["kind"]
        if kind == "cutter":
            options |= _cutter_option(obj, task, leaf)
        elif kind == "point":
            if not getattr(obj, property_name(leaf.name) + "FromMachine"):
                options[leaf.name] = plain(getattr(obj, property_name(leaf.name)))
        elif (value := plain(getattr(obj, property_name(leaf.name)))) != plain(
            default_value(leaf)
        ) or leaf.name in CHOSEN:
            options[leaf.name] = (
                float(f"{value * 60.0:.11g}") if kind == "feed" else value
            )  # of mm/s 12 digits are known
    return options


def convert_options(task: str, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options that an object with these would ask for: a field that shows a property's default
    asks for nothing. Raises SettingsError."""
    given = with_current_names(options)
    for _, leaf in list_options(task):
        name, kind = leaf.name, leaf.metadata["kind"]
        if given.get(name) is None or name in CHOSEN or kind in ("cutter", "point"):
            continue
        if plain(property_value(leaf, read_option(leaf, given[name]))) == plain(default_value(leaf)):
            del given[name]
    return given


def _cutter_option(obj: Any, task: str, leaf: Any) -> dict[str, Any]:
    """Return the cutter; none where an audit takes that which the program names: only what is not said does
    the core look for."""
    unsaid = task == AUDIT and obj.CutterFromProgram
    return {} if unsaid else {leaf.name: cutter_of(obj)}


def cutter_of(obj: Any) -> str:
    """Return the cutter of the object's properties as an option; whether there can be such a one is the
    core's to say."""
    sizes = {name: plain(getattr(obj, "Cutter" + name.capitalize())) for name in SIZES}
    return sizes_text(obj.CutterKind, sizes)


def tool_of(obj: Any) -> Tool:
    """Cutter, shank and holder of a Toolpath or an Audit, as the gouge check looks at them. Raises
    SettingsError."""
    shank, holder = (
        parse_stack(text, name) if (text := getattr(obj, name)) else () for name in ("Shank", "Holder")
    )
    cutter = parse_cutter(cutter_of(obj))
    return Tool(cutter, body_of(cutter, shank, holder))


def plain(value: Any) -> Any:
    """Return a property's value as numbers and text, in the property's own unit (mm, deg, mm/s).

    FreeCAD's files keep 16 digits of a number, fewer than a float has: 12 are taken, so that a reopened
    document asks for the same as before.
    """
    if isinstance(value, (FreeCAD.Vector, tuple)):
        return tuple(plain(float(part)) for part in value)
    number = getattr(value, "Value", value)
    return float(f"{number:.12g}") if isinstance(number, float) else number


def put_options(obj: Any, task: str, options: Mapping[str, Any]) -> None:
    """Set the properties from options as people write them. Raises SettingsError, and then has set none."""
    fields, options = {leaf.name: leaf for _, leaf in list_options(task)}, with_current_names(options)
    for name in options:
        if name not in fields:
            raise SettingsError(
                say(
                    "{name} is no setting of a document object; it is not one of {fields}",
                    name=name,
                    fields=", ".join(fields),
                ),
                name,
            )
    given = {name: value for name, value in options.items() if value is not None}
    read = {name: read_option(fields[name], value) for name, value in given.items()}
    for name, value in read.items():
        _put(obj, fields[name], value)


def _put(obj: Any, leaf: Any, value: Any) -> None:
    name, kind = property_name(leaf.name), leaf.metadata["kind"]
    if kind == "cutter":
        put_cutter(obj, value)
        if hasattr(obj, "CutterFromProgram"):
            obj.CutterFromProgram = False
        return
    if kind == "point":
        setattr(obj, name + "FromMachine", False)
    held = property_value(leaf, value)
    if isinstance(held, str) and (choices := obj.getEnumerationsOfProperty(name)):
        held = _choice(leaf.name, held, choices)
    setattr(obj, name, FreeCAD.Vector(*held) if isinstance(held, tuple) else held)


def put_cutter(obj: Any, cutter: Cutter) -> None:
    """Show a cutter in the object's properties."""
    for name, size in cutter_values(cutter).items():
        setattr(obj, name, size)


def _choice(option: str, value: str, choices: Sequence[str]) -> str:
    """Return the choice of that name, in any case. Raises SettingsError."""
    found = [one for one in choices if one.lower() == value.lower()]
    if not found:
        known = ", ".join(one for one in choices if one != MACHINES_OWN)
        raise SettingsError(
            say(
                "unknown {option} {value}; choose one of {known}",
                option=option.replace("_", " "),
                value=repr(value),
                known=known,
            ),
            value,
        )
    return found[0]


# ------------------------------------------------------------------------------------------------ meshes


def stl_bytes(obj: Any, work_zero: Sequence[float] = (0.0, 0.0, 0.0)) -> bytes:
    """Return the mesh object's facets as a binary STL, relative to ``work_zero`` (mm, document). Raises
    SelectionError."""
    return facets_of(obj, work_zero).stl()


def facets_of(obj: Any, work_zero: Sequence[float] = (0.0, 0.0, 0.0)) -> Facets:
    """Return the mesh object's facets, relative to ``work_zero`` (mm, document). Raises SelectionError."""
    place, holder = obj.getLinkedObject().Placement, holder_of(obj)
    place = move_to_zero(place if holder.isIdentity() else holder.multiply(place), work_zero)
    facets = Facets(kernel_of(obj), tuple(place.Matrix.A))
    if not facets.facet_count:
        raise empty(obj.Label)
    return facets


def move_to_zero(place: Any, work_zero: Sequence[float]) -> Any:
    """Return a placement in the document, relative to ``work_zero`` (mm, document)."""
    zero = FreeCAD.Vector(*plain(tuple(work_zero)))
    return FreeCAD.Placement(-zero, FreeCAD.Rotation()).multiply(place) if zero.Length else place


def mesh_and_mask(
    stl: bytes, runs: Sequence[int], avoided: Sequence[int], allowance: float, progress: Progress = silent
) -> tuple[Mesh, Bools | None]:
    """Return the core's mesh of a binary STL, with an ``allowance`` mm on its facets in the runs ``avoided``,
    and which of its facets lie in the ``runs``, as :func:`facet_mask`. Raises MeshError."""
    mesh = mesh_of(stl, progress)
    off = facet_mask(stl, mesh, avoided) if allowance > 0.0 else None
    with_room = mesh if off is None else replace(mesh, allowance=np.where(off, allowance, 0.0))
    return with_room, facet_mask(stl, mesh, runs)


def mesh_of(stl: bytes, progress: Progress = silent) -> Mesh:
    """Return the core's mesh of a binary STL. Raises MeshError."""
    progress("weld", 0.0)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.stl")
        with open(path, "wb") as file:
            file.write(stl)
        return read_stl(path, progress)


def facet_mask(stl: bytes, mesh: Mesh, runs: Sequence[int]) -> Bools | None:
    """Which facets of the core's mesh lie in the ``runs`` (start, stop, start, stop ...) of the STL's; None:
    no runs, so all.

    The core leaves out facets without area. What is left keeps its order, so a facet is known again by its
    three corners.
    """
    if not runs:
        return None
    corner = np.frombuffer(stl, STL, offset=_HEADER)["corner"]
    chosen = np.zeros(len(corner), bool)
    for start, stop in zip(runs[::2], runs[1::2], strict=True):
        chosen[start:stop] = True
    if len(corner) == len(mesh.face):
        return chosen
    return chosen[_find_kept(_signature(corner.astype(float) + 0.0), _signature(mesh.vertex[mesh.face]))]


def _find_kept(before: Any, after: Any) -> Ints:
    return np.flatnonzero(np.isin(before, after))


def _signature(corner: Any) -> Any:
    """One comparable value a facet (f,) of its corners (f, 3, 3), in whatever order they come."""
    order = np.lexsort((corner[..., 2], corner[..., 1], corner[..., 0]), axis=-1)
    rows = np.ascontiguousarray(np.take_along_axis(corner, order[..., None], axis=1).reshape(len(corner), 9))
    return rows.view(np.dtype((np.void, rows.itemsize * 9)))[:, 0]


# ------------------------------------------------------------------------------------------------ results


def put_result(obj: Any, figures: Figures, fingerprint: str) -> None:
    """Show the figures in the result properties."""
    numbers = summary(figures)
    whole = verdict(figures, numbers)
    surface, proven_below = find_largest_judged(numbers)
    values = {
        "Passes": numbers["passes"], "Blocks": numbers["blocks"],
        "SingularBlocks": numbers["singular_blocks"],
        "GuidedBlocks": numbers["guided_blocks"], "Verdict": wording.localize(whole.text),
        "Light": whole.light.value,
        "OverTolerance": numbers["over_tolerance"],
        "WorstLine": numbers["worst_line"] or 0, "Time": numbers["time_s"],
        "CutLength": numbers["cut_length"], "MaxSurfaceDeviation": surface, "MaxSurfaceBound": proven_below,
        "MaxSegmentDeviation": numbers["max_segment_deviation"],
        "MaxLineDeviation": numbers["max_line_deviation"], "MaxBound": numbers["max_bound"],
        "Proven": numbers["proven"],
        "Findings": [wording.localize(finding.text) for finding in figures.findings],
        "Fingerprint": fingerprint,
    }  # fmt: skip
    for name, value in values.items():
        setattr(obj, name, UNKNOWN if isinstance(value, float) and not math.isfinite(value) else value)


def clear_result(obj: Any, why: str) -> None:
    """There is no result: old numbers would be taken for those of the present settings."""
    for one in RESULTS:
        setattr(obj, one.name, one.default)
    obj.Findings = [why]
    mark_users(obj)


def mark_users(obj: Any) -> None:
    """Mark what hangs on an object that failed as out of date: FreeCAD does not recompute it, and NC files
    would look up to date."""
    for user in obj.InList:
        if hasattr(user, "UpToDate"):
            user.UpToDate = False
