# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Toolpath object: a mesh, every setting of the core, and what came out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.jobs import job
from freecad_fiveaxis.core.jobs.fewer_axes import suit_tool_axis
from freecad_fiveaxis.core.jobs.settings import MILL, build_settings
from freecad_fiveaxis.core.machine import load_machine

from . import convert, job_setup, results
from .properties import QT_TRANSLATE_NOOP, RESULTS, WORK_ZERO, Property, setting_properties
from .schema import Proxy
from .selection import SelectionError, is_mesh

MESH = Property(
    "Mesh", "App::PropertyLinkGlobal", "Base", QT_TRANSLATE_NOOP("App::Property", "The tessellation, or any mesh, that is milled")
)


class Toolpath(Proxy):
    """Proxy of a toolpath."""

    last: results.Last | None

    def _begin(self) -> None:
        self.last = None

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """The mesh, the settings of task ``mill``, the work zero and the results."""
        return (MESH, job_setup.LINK, *setting_properties(MILL), WORK_ZERO, *RESULTS)

    def task(self, obj: Any) -> results.Task:
        """What the object asks of the core. Raises FiveAxisError."""
        if obj.Mesh is None:
            raise mesh_is_gone(obj)
        if not is_mesh(obj.Mesh):
            raise SelectionError(
                say("{label} is no mesh: choose a tessellation or a mesh.", label=obj.Mesh.Label), obj.Mesh.Label
            )
        settings = convert.settings_of(obj, MILL, f"{obj.Mesh.Label}.stl")
        facets = convert.facets_of(obj.Mesh, obj.WorkZero)
        return results.Task(settings, facets, tuple(getattr(obj.Mesh, "FacetRuns", ())))

    def made(self, task: results.Task, progress: Progress) -> job.Made:
        """The program, not yet proven."""
        mesh, faces = convert.mesh_and_mask(task.data, task.runs, progress)
        return job.make(task.settings, progress, mesh=mesh, faces=faces)

    def onDocumentRestored(self, obj: Any) -> None:
        """What its setup says cannot be edited."""
        super().onDocumentRestored(obj)
        job_setup.follow(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """Another setup has other values."""
        super().onChanged(obj, name)
        if name == job_setup.LINK.name:
            job_setup.follow(obj)

    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        results.execute(obj)


def mesh_is_gone(obj: Any) -> SelectionError:
    """What to say of a Toolpath whose mesh was deleted."""
    text = say("The mesh of {label} was deleted: undo that, or choose another one in its property Mesh.", label=obj.Label)
    return SelectionError(text, obj.Label)


def with_strategies(options: Mapping[str, Any]) -> dict[str, Any]:
    """The options, and pass strategy and tool axis as the core chooses them where they are left open. Raises FiveAxisError."""
    settings = build_settings(MILL, "mesh", options)
    settings = suit_tool_axis(settings, load_machine(settings.machine.machine))
    return {**options, "passes": settings.passes.passes, "tool_axis": settings.tool_axis.tool_axis}


def make(doc: Any, mesh: Any, options: Mapping[str, Any], extra: Mapping[str, Any]) -> Any:
    """A Toolpath object of a mesh object, not yet computed. ``extra``: properties that are no settings of the core.

    Raises SettingsError, and then leaves no object behind.
    """
    options = with_strategies(options)
    obj = doc.addObject("App::FeaturePython", "Toolpath")
    try:
        Toolpath(obj)
        obj.Mesh = mesh
        convert.put_options(obj, MILL, options)
        for name, value in extra.items():
            setattr(obj, name, FreeCAD.Vector(*value) if isinstance(value, (tuple, list)) else value)
    except BaseException:
        doc.removeObject(obj.Name)
        raise
    return obj
