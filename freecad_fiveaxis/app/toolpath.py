# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Toolpath object: a mesh, every setting of the core, and what came out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.fewer_axes import suit_tool_axis
from freecad_fiveaxis.core.pipeline.programs import ProgramDraft
from freecad_fiveaxis.core.pipeline.settings import MILL, build_settings

from . import compared, convert, guides, job_setup, results
from .plain_errors import hide_trace
from .properties import QT_TRANSLATE_NOOP, WORK_ZERO, Property, setting_properties
from .result_properties import RESULTS
from .schema import Proxy
from .selection import SelectionError, is_mesh

MESH = Property(
    "Mesh",
    "App::PropertyLinkGlobal",
    "Base",
    QT_TRANSLATE_NOOP("App::Property", "The tessellation, or any mesh, that is milled"),
)

FIXTURES = Property(
    "Fixtures", "App::PropertyLinkListGlobal", "Safety",
    QT_TRANSLATE_NOOP("App::Property", "Solids and meshes of the document that hold the part: the path goes "
        "around them"),
)  # fmt: skip


class Toolpath(Proxy):
    """Proxy of a toolpath."""

    last: results.Last | None
    had_mesh = False
    """Whether it had a mesh since its document was opened."""

    def _begin(self) -> None:
        self.last, self.seen = None, dict[str, compared.Seen]()

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the mesh, the fixtures, the settings of task ``mill``, the work zero and the results."""
        return (
            MESH,
            FIXTURES,
            job_setup.LINK,
            *setting_properties(MILL),
            *guides.LINKS.values(),
            WORK_ZERO,
            *RESULTS,
        )

    def task(self, obj: Any) -> results.Task:
        """Return what the object asks of the core. Raises FiveAxisError."""
        if obj.Mesh is None:
            raise mesh_is_gone(obj)
        if not is_mesh(obj.Mesh):
            raise SelectionError(
                say("{label} is no mesh: choose a tessellation or a mesh.", label=obj.Mesh.Label),
                obj.Mesh.Label,
            )
        if "Invalid" in obj.Mesh.State:  # its facets are those of before: of another solid, or of other faces
            text = say(
                "{label} could not be computed: {why}", label=obj.Mesh.Label, why=obj.Mesh.getStatusString()
            )
            raise SelectionError(text, obj.Mesh.Label)
        fixtures = check_fixtures(obj)
        named = guides.options_of(guides.links_of(obj), tuple(obj.WorkZero)) | compared.fixture_names(
            fixtures
        )
        settings = build_settings(MILL, f"{obj.Mesh.Label}.stl", convert.options_of(obj, MILL) | named)
        facets, zero = convert.facets_of(obj.Mesh, obj.WorkZero), tuple(obj.WorkZero)
        solids = compared.find_held_parts(fixtures, zero, self.seen)
        return results.Task(settings, facets, *results.runs_of(obj.Mesh, settings), fixtures=solids)

    def make_draft(self, task: results.Task, progress: Progress) -> ProgramDraft:
        """Return the program, not yet proven."""
        mesh, faces = task.mesh_and_mask(progress)
        return job.make(
            task.settings, progress, mesh=mesh, faces=faces, fixtures=task.mesh_fixtures(progress)
        )

    def onDocumentRestored(self, obj: Any) -> None:
        """Lock what its setup says."""
        super().onDocumentRestored(obj)
        self.had_mesh = obj.Mesh is not None
        job_setup.follow(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """Another setup has other values."""
        super().onChanged(obj, name)
        self.had_mesh = self.had_mesh or (name == MESH.name and obj.Mesh is not None)
        if name == job_setup.LINK.name:
            job_setup.follow(obj)

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        results.execute(obj)


def check_fixtures(obj: Any, fixtures: Any = None) -> list[Any]:
    """Give the fixtures of a Toolpath, or those that it is to get. Raises SelectionError for what is no solid
    and no mesh, and for the part itself."""
    part = getattr(obj.Mesh, "Base", None)
    given = compared.check_held(obj.Document, obj.Fixtures if fixtures is None else fixtures)
    for one in given:
        if one is obj.Mesh or (part and one is part[0]):
            text = say(
                "{label} is the part that is milled: choose what holds it, or no fixture.", label=one.Label
            )
            raise SelectionError(text, one.Label)
    return given


def mesh_is_gone(obj: Any) -> SelectionError:
    """Return what to say of a Toolpath whose mesh was deleted, or that came into the document without it."""
    if not getattr(obj.Proxy, "had_mesh", True):
        text = say(
            "{label} has no mesh: choose one in its property Mesh, or copy the path together with its mesh.",
            label=obj.Label,
        )
        return SelectionError(text, obj.Label)
    text = say(
        "The mesh of {label} was deleted: undo that, or choose another one in its property Mesh.",
        label=obj.Label,
    )
    return SelectionError(text, obj.Label)


def with_strategies(options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options, and pass strategy and tool axis as the core chooses them where they are left open.
    Raises FiveAxisError."""
    settings = build_settings(MILL, "mesh", options)
    settings = suit_tool_axis(settings, load_machine(settings.machine.machine))
    return {**options, "passes": settings.passes.passes, "tool_axis": settings.tool_axis.tool_axis}


def make(doc: Any, mesh: Any, options: Mapping[str, Any], extra: Mapping[str, Any]) -> Any:
    """Return a Toolpath object of a mesh object, not yet computed. ``extra``: properties that are no settings
    of the core.

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
