# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of toolpaths and audits, computed when somebody needs them.

result        the core's Result: arrays, not saved with the document. The proxy keeps the last one.
fingerprint   what a result is of: the mesh or NC file, the settings, the machine. The same fingerprint gives
              the same bytes.
current       the object shows the result of what its base and its settings now are.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, fields, replace
from typing import Any

from freecad_fiveaxis import __version__
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.base.sentences import Sentence, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.machine import Machine, load_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.new_speed import change_speed, without_speed
from freecad_fiveaxis.core.pipeline.outputs import curve_files
from freecad_fiveaxis.core.pipeline.programs import MilledProgram, PostedProgram, Result
from freecad_fiveaxis.core.pipeline.settings import AUDIT, Settings
from freecad_fiveaxis.core.report import Figures

from . import convert, wording
from .compared import Part
from .convert import clear_result, mark_users, mesh_of, put_result
from .facets import Facets
from .long_work import listening, run
from .properties import list_options
from .selection import SelectionError
from .tessellation import Tessellation, has_moved


@dataclass(frozen=True)
class Task:
    """What an object asks of the core: the ``settings``, and the ``data`` (a mesh's facets, or the NC file)
    with the chosen facets' ``runs``, and those of the facets to avoid (``avoided``); ``part``: what an audit
    compares with, where that is in the document; ``fixtures``: what holds the part."""

    settings: Settings
    data: Any
    runs: tuple[int, ...] = ()
    avoided: tuple[int, ...] = ()
    part: Part | None = None
    fixtures: tuple[Part, ...] = ()

    def mesh_and_mask(self, progress: Progress) -> tuple[Mesh, Bools | None]:
        """Return the core's mesh of the facets, with the allowance on those to avoid, and which are milled.
        Raises MeshError."""
        progress("weld", 0.0)
        allowance = self.settings.gouge.avoid_allowance
        return convert.mesh_and_mask(self.data.stl(), self.runs, self.avoided, allowance, progress)

    def with_fixtures_meshed(self, progress: Progress) -> Task:
        """Return the same with the surfaces of its fixtures. Raises FiveAxisError."""
        return replace(self, fixtures=tuple(one.mesh(progress) for one in self.fixtures))

    def mesh_fixtures(self, progress: Progress) -> tuple[Fixture, ...]:
        """Return the core's fixtures, once they are meshed. Raises MeshError."""
        names = self.settings.gouge.fixture
        solids = [convert.mesh_of(one.stl, progress) for one in self.fixtures]
        return tuple(Fixture(name.removesuffix(".stl"), one) for name, one in zip(names, solids, strict=True))

    @property
    def fingerprint(self) -> str:
        """A hexadecimal number that any change of the input changes; another name of it does not."""
        return self._hash(self.settings)

    @property
    def blocks_fingerprint(self) -> str:
        """The same, whatever spindle speed and coolant are: of the program's blocks, without its head."""
        return self._hash(without_speed(self.settings))

    def _hash(self, settings: Settings) -> str:
        settings = replace(settings, source="")
        files = _contents(self.settings, ("against",) if self.part else ())
        inputs = repr((__version__, settings, _machine(self.settings), self.runs, *files)).encode()
        inputs += repr(self.avoided).encode() if self.avoided and settings.gouge.avoid_allowance else b""
        if settings.task == AUDIT and "cutter" not in settings.explicit:  # that of the program is looked for
            inputs += b"named cutter"
        data = self.data.digest() if isinstance(self.data, Facets) else hashlib.sha256(self.data).digest()
        data += b"".join(one.digest() for one in ((self.part,) if self.part else ()) + self.fixtures)
        return hashlib.sha256(data + inputs).hexdigest()


def runs_of(mesh: Any, settings: Settings) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Return the runs of a mesh object's facets that are milled, none: all are, and of those to avoid, which
    the settings need where there is an allowance. Raises SelectionError where they cannot be found."""
    find = getattr(getattr(mesh, "Proxy", None), "avoided_runs", None)
    off = (
        find(mesh)
        if find is not None and settings.gouge.avoid_allowance > 0.0
        else getattr(mesh, "AvoidedRuns", ())
    )
    return tuple(getattr(mesh, "FacetRuns", ())), tuple(off)


def _contents(settings: Settings, unread: tuple[str, ...] = ()) -> tuple[str, ...]:
    """Checksums of the files that the settings name beside the source, but for the options ``unread``, whose
    content is at hand. Raises FileError for a file that cannot be read."""
    groups = {type(getattr(settings, top.name)): getattr(settings, top.name) for top in fields(Settings)}
    leaves = [(cls, leaf) for cls, leaf in list_options(settings.task) if leaf.metadata["kind"] == "path"]
    named = [
        getattr(groups[cls], leaf.name) for cls, leaf in leaves if cls in groups and leaf.name not in unread
    ]
    named += curve_files(settings)
    named += [body.file for body in _machine(settings).bodies]
    return tuple(hashlib.sha256(read_bytes(name, "file")).hexdigest() for name in named if name)


def _machine(settings: Settings) -> Machine:
    try:
        return load_machine(settings.machine.machine)
    except FileError as error:
        raise FileError(
            say("{error}; choose another machine, or put the file back", error=error), error.value
        ) from error


@dataclass(frozen=True, eq=False)
class Last:
    """What a proxy remembers of the last computation."""

    fingerprint: str
    blocks_fingerprint: str
    result: Result
    figures: Figures


def result_of(obj: Any, progress: Progress | None = None) -> Result:
    """Return the result of a Toolpath or an Audit, computed anew only where something has changed.

    Raises FiveAxisError for what cannot be used, Cancelled where the listener stops the work.
    """
    return _last(obj, progress).result


def figures_of(obj: Any, progress: Progress | None = None) -> Figures:
    """Return what the report, the drawing and the markers are made from; work frame. Raises as
    :func:`result_of`."""
    return _last(obj, progress).figures


def nc_of(obj: Any, progress: Progress | None = None) -> bytes:
    """Return the NC file of a Toolpath; of an Audit the file that is audited. Raises as :func:`result_of`."""
    draft = _last(obj, progress).result.draft
    if isinstance(draft, PostedProgram):
        return draft.nc
    audited: bytes = obj.Proxy.task(obj).data
    return audited


def _last(obj: Any, progress: Progress | None) -> Last:
    proxy: Any = getattr(obj, "Proxy", None)
    if not hasattr(proxy, "make_draft"):
        label = "Nothing" if obj is None else getattr(obj, "Label", None) or repr(obj)
        raise SelectionError(
            say("{label} is no toolpath and no audit: select one of these.", label=label), label
        )
    task = proxy.task(obj)
    fingerprint = task.fingerprint
    if proxy.last is None or proxy.last.fingerprint != fingerprint:
        with listening(progress) as listener:
            whole = replace(task, part=task.part.mesh(listener)) if task.part else task
            whole = whole.with_fixtures_meshed(listener)
            proxy.last = run(
                lambda progress: _compute_result(proxy, whole, fingerprint, progress), doc=obj.Document
            )
    last: Last = proxy.last
    return last


def _compute_result(proxy: Any, task: Task, fingerprint: str, progress: Progress) -> Last:
    """Return the whole work of the core, or a new head alone where no more has changed; nothing of FreeCAD's
    is touched."""
    last, blocks = proxy.last, task.blocks_fingerprint
    if (
        last is not None
        and last.blocks_fingerprint == blocks
        and isinstance(last.result.draft, MilledProgram)
    ):
        result = change_speed(last.result, task.settings, progress)
    else:
        part = None if task.part is None else mesh_of(task.part.stl, progress)
        result = job.prove(proxy.make_draft(task, progress), progress, part)
    figures = job.figures(result)
    _ = figures.at_part  # found here, where it does not hold up the window that draws it
    return Last(fingerprint, blocks, result, figures)


def execute(obj: Any) -> None:
    """Compute a Toolpath or an Audit when the document is recomputed. An error marks the object and clears
    its numbers. Work that was stopped leaves it as it was, and out of date."""
    try:
        last = _last(obj, None)
    except Cancelled:
        mark_users(obj)
        raise
    except FiveAxisError as error:
        clear_result(obj, wording.localize(error))
        raise
    put_result(obj, last.figures, last.fingerprint)


def read_judged(obj: Any) -> tuple[float, float]:
    """Largest deviation of what makes the surface and its proven bound, mm, as the object shows them; the
    tip's where its document was last computed by a version that knew no others."""
    if obj.MaxSurfaceBound.Value > 0.0:
        return obj.MaxSurfaceDeviation.Value, obj.MaxSurfaceBound.Value
    return obj.MaxSegmentDeviation.Value, obj.MaxBound.Value


def out_of_date(obj: Any) -> str:
    """Why the object does not show the result of its base and settings; an empty text where it does."""
    old = say_old_base(obj, obj)
    if old is not None:
        return wording.localize(old)
    try:
        same = obj.Proxy.task(obj).fingerprint == obj.Fingerprint
    except FiveAxisError as error:
        return wording.localize(error)
    text = say(
        "{label} shows the result of other settings, or of another version: recompute the document",
        label=obj.Label,
    )
    return "" if same else wording.localize(text)


def say_old_base(obj: Any, *too: Any) -> Sentence | None:
    """Return why what the object is computed from waits for a recompute, None where it does not; where one of
    that, or of those named ``too``, could not be computed, why."""
    if _base_is_gone(obj):
        return say(
            "The part that {label} was made of was deleted: undo that, or choose another one in its "
            "property Base",
            label=obj.Mesh.Label,
        )
    names = ("Mesh", "Part")
    needed = (_base(obj), *(getattr(obj, name, None) for name in names), *getattr(obj, "Fixtures", ()))
    for one in (*(one for one in needed if one is not None), *too):
        if "Invalid" in one.State:
            return say("{label} could not be computed: {why}", label=one.Label, why=one.getStatusString())
        if "Touched" in one.State and one is not obj:
            return say("{label} was changed: recompute the document", label=one.Label)
    if is_moved_mesh(getattr(obj, "Mesh", None)):
        return say(
            "{label} was moved by the part that holds it: recompute the document", label=_base(obj).Label
        )
    return None


def is_moved_mesh(mesh: Any) -> bool:
    """Whether it is a tessellation whose base, or itself, was moved by what holds it since it was made."""
    return isinstance(getattr(mesh, "Proxy", None), Tessellation) and has_moved(mesh)


def renew(obj: Any) -> None:
    """Bring a Toolpath up to date where its solid, a fixture or its mesh waits for a recompute. Raises
    FiveAxisError, Cancelled."""
    if renew_base(obj):
        result_of(obj)
        obj.touch()  # FreeCAD leaves one alone whose mesh was computed in a call before
        obj.Document.recompute([obj])


def renew_base(obj: Any) -> bool:
    """Bring up to date what a Toolpath is made of, where one of that waits for a recompute; whether one did.
    Raises FiveAxisError, Cancelled."""
    base: Any = _base(obj)
    mesh: Any = getattr(obj, "Mesh", None)
    waiting = [one for one in (base, *getattr(obj, "Fixtures", ())) if one and "Touched" in one.State]
    if waiting:
        obj.Document.recompute(waiting)
    if not isinstance(getattr(mesh, "Proxy", None), Tessellation) or base is None:
        return bool(waiting)
    if base not in waiting and "Touched" not in mesh.State and not has_moved(mesh):
        return bool(waiting)
    mesh.Proxy.build(mesh)
    obj.Document.recompute([mesh])
    return True


def tells_of(obj: Any) -> bool:
    """Whether the object's properties tell of the figures that were computed last, or none are at hand: a
    file may have been replaced since, and somebody have asked for its figures without a recompute."""
    return obj.Proxy.last is None or obj.Proxy.last.fingerprint == obj.Fingerprint


def touch_other(obj: Any) -> None:
    """Have the next recompute compute an object of which FreeCAD does not know that it is old: a file of its
    own was replaced."""
    if not obj.Fingerprint or {"Touched", "Invalid"} & set(obj.State):
        return
    try:
        same = obj.Proxy.task(obj).fingerprint == obj.Fingerprint
    except FiveAxisError:  # the object says so itself
        return
    if not same:
        obj.touch()


def _base_is_gone(obj: Any) -> bool:
    mesh = getattr(obj, "Mesh", None)
    return mesh is not None and hasattr(mesh, "Base") and _base(obj) is None


def _base(obj: Any) -> Any:
    link = getattr(getattr(obj, "Mesh", None), "Base", None)
    return link[0] if isinstance(link, tuple) else link
