# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the five functions of the package do. Each one leaves the document as it was where it raises."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.files import check_writable, write_whole
from freecad_fiveaxis.core.base.quantity import (
    parse_length,
    parse_stack,
    stack_text,
)
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.pipeline.settings import AUDIT, MILL, build_settings

from . import (
    auditing,
    compared,
    convert,
    guides,
    job_setup,
    markers,
    previewing,
    selection,
    tessellation,
    toolpath,
)
from .arguments import deflections, names, place
from .convert import stl_bytes
from .long_work import take_back
from .properties import list_drawn_tool, property_name
from .results import result_of, tells_of
from .tessellation import Tessellation

DEFAULT_MACHINE = "trunnion_ac"


def tessellate(obj: Any, stl_path: Any, overwrite: bool, settings: Mapping[str, Any]) -> Any:
    """See :func:`freecad_fiveaxis.app.tessellate`."""
    mesh = deflections(settings)
    if unknown := set(settings) - _OF_MESH:
        raise SettingsError(
            say(
                "{unknown}: no setting of a tessellation; known: {known}",
                unknown=", ".join(sorted(unknown)),
                known=", ".join(sorted(_OF_MESH)),
            )
        )
    base, faces, avoid = _base(obj, settings)
    if stl_path is not None:
        _check_new(stl_path, overwrite)
    with _all_or_nothing(base.Document) as added:
        ready = _is_tessellation(base) and not settings
        mesh_object = base if ready else tessellation.make(base.Document, base, faces, **mesh, avoid=avoid)
        added += [mesh_object] * (mesh_object is not base)
        if stl_path is not None:
            write_whole(stl_path, stl_bytes(mesh_object))
    return mesh_object


def create_toolpath(doc: Any, base: Any, settings: Mapping[str, Any]) -> Any:
    """See :func:`freecad_fiveaxis.app.create_toolpath`."""
    settings, setup = _with_setup(doc, _with_holder(settings))
    fixtures = compared.check_held(doc, settings.pop("fixtures", None))
    picked = settings.pop("picked", None) or {}
    extra = _extra(settings, _EXTRA)
    options = {name: value for name, value in settings.items() if name not in _OF_MESH and name not in _EXTRA}
    options["machine"] = options.get("machine") or DEFAULT_MACHINE
    build_settings(MILL, "mesh", options)
    chosen, faces, avoid = _base(base, settings)
    if chosen.Document.Name != doc.Name:
        raise selection.SelectionError(
            say(
                "{label} is in another document: select something in {document}.",
                label=chosen.Label,
                document=doc.Label,
            ),
            chosen.Label,
        )
    with _all_or_nothing(doc) as added:
        mesh = chosen
        if not selection.is_mesh(chosen) or faces or avoid:
            mesh = tessellation.make(doc, chosen, faces, **deflections(settings), avoid=avoid)
            added.append(mesh)
        elif unused := {"linear_deflection", "angular_deflection"} & set(settings):
            raise SettingsError(
                say(
                    "{label} is a mesh already: leave out {unused}",
                    label=chosen.Label,
                    unused=", ".join(sorted(unused)),
                ),
                chosen.Label,
            )
        path = toolpath.make(doc, mesh, options, extra)
        added.append(path)
        path.Setup, path.Fixtures = setup, fixtures
        guides.put(path, picked)
        _compute(path)
    return path


def preview_passes(base: Any, settings: Mapping[str, Any]) -> Any:
    """See :func:`freecad_fiveaxis.app.preview_passes`."""
    if isinstance(getattr(base, "Proxy", None), toolpath.Toolpath):
        doc, given = base.Document, dict(settings) or convert.options_of(base, MILL)
        given = _with_setup(doc, given)[0] if given.get("setup") is not None else given
        part, zero = previewing.part_of(base, settings), tuple(base.WorkZero)
    else:
        chosen, faces, avoid = _base(base, settings)
        doc, (given, _) = chosen.Document, _with_setup(chosen.Document, _with_holder(settings))
        part, zero = previewing.Part(chosen, faces, avoid, **deflections(settings)), (0.0, 0.0, 0.0)
    compared.check_held(doc, settings.get("fixtures"))
    apart = (*_OF_MESH, *_EXTRA, "setup", "fixtures", "picked")
    options = {name: value for name, value in given.items() if name not in apart and value is not None}
    options["machine"] = options.get("machine") or DEFAULT_MACHINE
    zero, links = (
        _extra(given, _EXTRA).get("WorkZero", zero),
        guides.links_of(base) if given is not settings else {},
    )
    return previewing.lay(doc, part, options | guides.options_of(given.get("picked", links), zero), zero)


def annotate(path: Any) -> Any:
    """See :func:`freecad_fiveaxis.app.annotate`."""
    result_of(path)
    if not tells_of(path):
        path.touch()  # its numbers stand in the label of the markers
    markers_object = markers.of(path)
    with _all_or_nothing(path.Document) as added:
        if markers_object is None:
            markers_object = markers.make(path)
            added.append(markers_object)
        markers_object.touch()
        path.Document.recompute([path, markers_object])
    return markers_object


def audit(doc: Any, nc_path: Any, machine: str, settings: Mapping[str, Any]) -> Any:
    """See :func:`freecad_fiveaxis.app.audit`."""
    settings = _with_holder(settings)
    fixtures = settings.pop("fixtures", None)
    drawn = _EXTRA | {"part"} | {one.name.lower() for one in list_drawn_tool(AUDIT)}
    options = {name: value for name, value in settings.items() if name not in drawn} | {"machine": machine}
    part = compared.check_part(doc, settings.get("part"))
    fixtures = auditing.check_fixtures(doc, fixtures, part)
    build_settings(AUDIT, os.fspath(nc_path), auditing.audit_options(options, part, fixtures))
    with _all_or_nothing(doc) as added:
        audit_object = auditing.make(
            doc, os.path.abspath(nc_path), options, _extra(settings, drawn), fixtures
        )
        added.append(audit_object)
        _compute(audit_object)
    return audit_object


_OF_MESH = {"linear_deflection", "angular_deflection", "faces", "avoid"}
_EXTRA = {"work_zero"}
_OLD_HOLDER = {"holder_diameter": 40.0, "holder_length": 60.0}
"""mm; one cylinder, as macros gave the holder before there were stacks, with what the other of them was if
one was given."""


def _with_setup(doc: Any, settings: Mapping[str, Any]) -> tuple[dict[str, Any], Any]:
    """Return the settings with those of the Setup, and that. Where none is given and nothing that it says,
    the document's only one."""
    rest = {name: value for name, value in settings.items() if name != "setup"}
    shared = {name for name in (*job_setup.OPTIONS, "work_zero") if rest.get(name) is not None}
    setup = settings.get("setup") if "setup" in settings or shared else job_setup.only_setup(doc)
    if setup is None:
        return rest, None
    return rest | job_setup.options_of(job_setup.check_setup(doc, setup)), setup


def _with_holder(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Return the settings with a holder of one cylinder as a stack. Raises SettingsError where the holder is
    given twice."""
    rest = {name: value for name, value in settings.items() if name not in _OLD_HOLDER}
    given = {name: settings[name] for name in _OLD_HOLDER if settings.get(name) is not None}
    if given and rest.get("holder") is not None:
        raise SettingsError(
            say("holder and {given} say the same; give holder", given=", ".join(given)), rest["holder"]
        )
    row = tuple(parse_length(given.get(name, size), name) for name, size in _OLD_HOLDER.items())
    return {**rest, "holder": stack_text((row,))} if given else rest  # type: ignore[arg-type]


def _extra(settings: Mapping[str, Any], names: Collection[str]) -> dict[str, Any]:
    """Return the properties that are no settings of the core's task, mm."""
    given = {name: settings[name] for name in names if settings.get(name) is not None}
    return {property_name(name): _read(value, name) for name, value in given.items()}


def _read(given: Any, name: str) -> Any:
    if name == "part":
        return given
    return place(given, name) if name == "work_zero" else _stack(given, name)


def _stack(given: Any, name: str) -> str:
    return stack_text(parse_stack(given, name))


def _base(given: Any, settings: Mapping[str, Any]) -> tuple[Any, tuple[str, ...], tuple[str, ...]]:
    """Return the base, its faces and those to avoid, recomputed where it waits for that. Raises
    SelectionError."""
    base, named = (
        (given[0], given[1]) if isinstance(given, (tuple, list)) and len(given) == 2 else (given, ())
    )
    if base is None or not hasattr(base, "Document"):
        raise selection.SelectionError(say("Nothing is selected: {what}.", what=selection.WHAT), None)
    if base.State != ["Up-to-date"] or base.MustExecute:
        base.Document.recompute([base])
    faces = names(settings.get("faces") or named or ())
    avoid = names(settings.get("avoid") or ())
    if not selection.is_mesh(base):  # a mesh is looked at where its facets are taken
        selection.solids(base, faces, avoid)
    return base, faces, avoid


def _is_tessellation(obj: Any) -> bool:
    return isinstance(getattr(obj, "Proxy", None), Tessellation)


def _compute(obj: Any) -> None:
    """Compute, so that errors reach the caller; the recompute then finds the work done."""
    result_of(obj)
    obj.Document.recompute([obj])


def _check_new(path: Any, overwrite: bool) -> None:
    """Raise FileError where the file cannot be written, or has content that nobody allowed to replace."""
    check_writable(path)
    if not overwrite and os.path.exists(path) and os.path.getsize(path):
        raise FileError(
            say("{path} is there already: name another file, or ask for it to be replaced", path=path), path
        )


@contextmanager
def _all_or_nothing(doc: Any) -> Iterator[list[Any]]:
    """Yield what is put into the list is taken out of the document again where an error, or the user, ends
    the work."""
    added: list[Any] = []
    try:
        yield added
    except BaseException:
        take_back(doc, *added)
        raise
