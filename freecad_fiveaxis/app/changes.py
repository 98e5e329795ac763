# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths and audits that are there already get other settings, and are computed anew."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.quantity import LENGTHS, parse_triple
from freecad_fiveaxis.core.pipeline.settings import AUDIT, MILL, build_settings
from freecad_fiveaxis.core.tool import cutter_text

from . import convert, guides, properties, tessellation, toolpath
from .arguments import names
from .auditing import audit_options, check_fixtures, compare_with
from .job_setup import follow
from .properties import default_value, property_name
from .results import renew_base, result_of

_OF_MESH = {"linear_deflection": "LinearDeflection", "angular_deflection": "AngularDeflection"}


def change_toolpath(obj: Any, settings: Mapping[str, Any]) -> Any:
    """Give a Toolpath all of these settings, as ``create_toolpath`` takes them, and compute it; returns it.

    An option that is not among them goes back to its default; ``work_zero``, ``fixtures``, ``avoid``,
    ``picked`` and the deflections stay unless they are given. Raises FiveAxisError; the caller's transaction
    then takes back what was done.
    """
    apart = (*_OF_MESH, "avoid", "work_zero", "setup", "fixtures", "picked")
    options = {name: value for name, value in settings.items() if name not in apart}
    options = toolpath.with_strategies(options)
    if obj.Mesh is None:
        raise toolpath.mesh_is_gone(obj)
    _put_mesh(obj.Mesh, settings)
    _put(obj, MILL, options, settings.get("work_zero"))
    if "fixtures" in settings and list(obj.Fixtures) != list(settings["fixtures"]):
        obj.Fixtures = list(settings["fixtures"])
    renew_base(obj)
    if "picked" in settings:
        guides.put(obj, settings["picked"])
    if "setup" in settings and obj.Setup is not settings["setup"]:
        obj.Setup = settings["setup"]
    elif obj.Setup is not None:
        follow(obj)
    return compute(obj)


def change_audit(obj: Any, nc_path: str, settings: Mapping[str, Any]) -> Any:
    """Return the same for an Audit: its NC file and its settings; ``part`` and ``fixtures`` stay unless
    they are given; without a cutter that counts which the program names. Raises FiveAxisError."""
    options = {
        name: value for name, value in settings.items() if name not in ("work_zero", "part", "fixtures")
    }
    part = settings.get("part", obj.Part)
    fixtures = check_fixtures(obj.Document, settings.get("fixtures", obj.Fixtures), part)
    build_settings(AUDIT, nc_path, audit_options(options, part, fixtures))
    obj.NCFile = os.path.abspath(nc_path)
    compare_with(obj, part)
    if list(obj.Fixtures) != fixtures:
        obj.Fixtures = fixtures
    _put(obj, AUDIT, options, settings.get("work_zero"))
    obj.CutterFromProgram = options.get("cutter") is None
    return compute(obj)


def read_options(obj: Any, task: str) -> dict[str, Any]:
    """Every option of the task as the object has it (mm, deg, mm/min), None where it is not given."""
    return default_options(task) | convert.options_of(obj, task)


def default_options(task: str) -> dict[str, Any]:
    """Every option of the task with the core's default (mm, deg, mm/min), None where nothing is given."""
    return {leaf.name: _default(leaf) for _, leaf in properties.list_options(task)}


def _default(leaf: Any) -> Any:
    if leaf.metadata["kind"] == "cutter":
        return cutter_text(leaf.default)
    if leaf.default is None:
        return None
    return leaf.default if leaf.metadata["kind"] == "feed" else default_value(leaf)


def _put(obj: Any, task: str, options: Mapping[str, Any], work_zero: Any) -> None:
    for _, leaf in properties.list_options(task):
        if leaf.metadata["kind"] != "cutter" and leaf.name not in options:
            name = property_name(leaf.name)
            if leaf.metadata["kind"] == "point":
                setattr(obj, name + "FromMachine", True)
            else:
                value = default_value(leaf)
                setattr(obj, name, FreeCAD.Vector(*value) if isinstance(value, tuple) else value)
    convert.put_options(obj, task, options)
    if work_zero is not None:
        obj.WorkZero = FreeCAD.Vector(*parse_triple(tuple(work_zero), LENGTHS, "work_zero"))


def _put_mesh(mesh: Any, settings: Mapping[str, Any]) -> None:
    """Other deflections and faces to avoid make another mesh, the same ones leave it; one that could not be
    made is tried again, so that the user hears why."""
    changed = _avoid(mesh, settings.get("avoid")) or (
        hasattr(mesh, "LinearDeflection") and "Invalid" in mesh.State
    )
    for option, name in _OF_MESH.items():
        if settings.get(option) is not None and getattr(mesh, name).Value != settings[option]:
            setattr(mesh, name, settings[option])
            changed = True
    if changed:
        mesh.Proxy.build(mesh)
        mesh.Document.recompute([mesh])


def _avoid(mesh: Any, given: Any) -> bool:
    """Leave these faces alone, where it is said which; whether that is a change. Raises SelectionError for a
    mesh without any."""
    if given is None:
        return False
    faces = names(given)
    if faces and not hasattr(mesh, "LinearDeflection"):
        raise tessellation.no_names(mesh)
    return hasattr(mesh, "LinearDeflection") and tessellation.leave_alone(mesh, faces)


def compute(obj: Any) -> Any:
    """Compute, so that errors reach the caller; the recompute then finds the work done, for what hangs on the
    path too."""
    result_of(obj)
    obj.Document.recompute([obj, *obj.InList])
    return obj
