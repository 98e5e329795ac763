# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Audit object: a finished NC file of any origin, judged on a machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import check_readable, read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.nc.named_cutter import find_named_cutter
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.programs import ProgramDraft
from freecad_fiveaxis.core.pipeline.settings import AUDIT, build_settings, is_part
from freecad_fiveaxis.core.tool import cutter_text, parse_cutter

from . import compared, convert, results
from .plain_errors import hide_trace
from .properties import (
    CUTTER,
    HIDDEN,
    OUTPUT,
    QT_TRANSLATE_NOOP,
    WORK_ZERO,
    Property,
    list_drawn_tool,
    list_options,
    setting_properties,
)
from .result_properties import RESULTS
from .schema import Proxy, is_restored
from .selection import SelectionError

PART = Property(
    "Part", "App::PropertyLinkGlobal", "Comparison",
    QT_TRANSLATE_NOOP("App::Property", "The solid or mesh of the document that the program is compared with"),
)  # fmt: skip
FIXTURES = Property(
    "Fixtures", "App::PropertyLinkListGlobal", "Safety",
    QT_TRANSLATE_NOOP("App::Property", "Solids and meshes of the document that hold the part: the tool is "
        "checked against them"),
)  # fmt: skip
PART_LABEL = Property(
    "PartLabel", "App::PropertyString", "Comparison",
    QT_TRANSLATE_NOOP("App::Property", "The name of the part that was chosen last: one that is deleted is "
        "missed"), "",
    HIDDEN | OUTPUT,
)  # fmt: skip
FROM_PROGRAM = Property(
    "CutterFromProgram", "App::PropertyBool", "Tool",
    QT_TRANSLATE_NOOP("App::Property", "Take the cutter that the program names, or the file to compare with"),
    True,
)  # fmt: skip
NC_FILE = Property(
    "NCFile",
    "App::PropertyFile",
    "Base",
    QT_TRANSLATE_NOOP("App::Property", "The NC file that is judged"),
    "",
)
_CUTTER = {one.name for one in CUTTER}


class Audit(Proxy):
    """Proxy of an audit."""

    last: results.Last | None

    def _begin(self) -> None:
        self.last, self.seen, self.held = None, compared.Seen(), dict[str, compared.Seen]()

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the file, part and fixtures of the document, the settings of task ``audit``, shank, holder
        and work zero (where all is drawn, and where part and fixtures stand for the program) and the
        results."""
        return (
            NC_FILE,
            PART,
            PART_LABEL,
            FIXTURES,
            *setting_properties(AUDIT),
            FROM_PROGRAM,
            *list_drawn_tool(AUDIT),
            WORK_ZERO,
            *RESULTS,
        )

    def task(self, obj: Any) -> results.Task:
        """Return what the object asks of the core. Raises FiveAxisError."""
        if not obj.NCFile:
            raise FileError(
                say("{label} names no NC file: choose one in its property NCFile", label=obj.Label), ""
            )
        check_readable(obj.NCFile)
        if obj.Part is None and obj.PartLabel:
            raise part_is_gone(obj)
        fixtures, zero = check_fixtures(obj.Document, obj.Fixtures, obj.Part), tuple(obj.WorkZero)
        settings = build_settings(
            AUDIT, obj.NCFile, audit_options(convert.options_of(obj, AUDIT), obj.Part, fixtures)
        )
        part = None if obj.Part is None else compared.Part(obj.Part, zero, self.seen)
        solids = compared.find_held_parts(fixtures, zero, self.held)
        return results.Task(settings, read_bytes(obj.NCFile, "NC file"), part=part, fixtures=solids)

    def make_draft(self, task: results.Task, progress: Progress) -> ProgramDraft:
        """Return the file's program."""
        return job.make(task.settings, progress, fixtures=task.mesh_fixtures(progress))

    def onChanged(self, obj: Any, name: str) -> None:
        """Another part is remembered by its name. That it is deleted looks here as if it was taken out of the
        property: only :func:`compare_with` takes it out for good."""
        super().onChanged(obj, name)
        if not self.whole or is_restored(obj):
            return
        if name == PART.name and obj.Part is not None:
            obj.PartLabel = obj.Part.Label
        if name in _CUTTER:  # somebody has said which
            obj.CutterFromProgram = False

    def onDocumentRestored(self, obj: Any) -> None:
        """Of an earlier version only a cutter at its default was not given."""
        given = FROM_PROGRAM.name not in obj.PropertiesList and not has_default_cutter(obj)
        super().onDocumentRestored(obj)
        if given:
            obj.CutterFromProgram = False

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object. Where the program names the cutter, its properties show that one."""
        results.execute(obj)
        if obj.CutterFromProgram and self.last:
            taken = self.last.result.draft.settings.cutter.cutter
            if parse_cutter(convert.cutter_of(obj)) != taken:
                convert.put_cutter(obj, taken)
                obj.CutterFromProgram = True


def find_other_cutter(nc_path: str, than: str) -> str | None:
    """Return the cutter that a program names, as an option, where it is another one ``than`` this but for the
    length, which no program names; None where it names none, or cannot be read."""
    try:
        named = find_named_cutter(read_bytes(nc_path, "NC file")) if nc_path else None
        same = named and replace(parse_cutter(than), length=named.length) == named
    except FiveAxisError:
        return None
    return None if named is None or same else cutter_text(named)


def has_default_cutter(obj: Any) -> bool:
    """Whether an Audit shows the cutter of a new one; one that cannot be is none."""
    default = next(leaf.default for _, leaf in list_options(AUDIT) if leaf.name == "cutter")
    try:
        return bool(parse_cutter(convert.cutter_of(obj)) == default)
    except FiveAxisError:
        return False


def compare_with(obj: Any, part: Any) -> None:
    """Have an Audit compared with a part of the document, or with none."""
    if obj.Part is not part:
        obj.Part = part
    obj.PartLabel = "" if part is None else part.Label


def part_is_gone(obj: Any) -> SelectionError:
    """Return what to say of an Audit whose part was deleted: without it much of what was looked at would
    silently pass."""
    text = say(
        "{part}, which {label} is compared with, was deleted: undo that, choose another part in its property "
        "Part, or none "
        "in its panel.", part=obj.PartLabel, label=obj.Label,
    )  # fmt: skip
    return SelectionError(text, obj.Label)


def check_fixtures(doc: Any, fixtures: Any, part: Any) -> list[Any]:
    """Give the fixtures of an Audit. Raises SelectionError for what is no solid and no mesh, and for the part
    itself."""
    given = compared.check_held(doc, fixtures)
    for one in given:
        if one is part:
            text = say(
                "{label} is the part to compare with: choose what holds it, or no fixture.", label=one.Label
            )
            raise SelectionError(text, one.Label)
    return given


def audit_options(
    options: Mapping[str, Any], part: Any = None, fixtures: Sequence[Any] = ()
) -> dict[str, Any]:
    """Return what the core is asked: shank and holder are always drawn, but checked only against fixtures,
    the machine's bodies, and a part where ``gouge`` is not off. A ``part`` of the document stands in place of
    a file to compare with; ``fixtures`` of it go by their labels."""
    options = dict(options) if part is None else {**options, "against": f"{part.Label}.stl"}
    options |= compared.fixture_names(fixtures)
    if not is_part(options.get("against") or ""):
        left_out = {"gouge", "shank", "holder"}
    else:
        left_out = {"shank", "holder"} if options.get("gouge") == "off" else set()
    if "holder" in left_out and (fixtures or _has_bodies(str(options.get("machine", "")))):
        left_out -= {"shank", "holder"}
    return {name: value for name, value in options.items() if name not in left_out}


def _has_bodies(machine: str) -> bool:
    """Tell whether the file of a machine names bodies; what is wrong with the file, the core says."""
    try:
        return bool(load_machine(machine).bodies)
    except FiveAxisError:
        return False


def make(
    doc: Any, nc_path: str, options: Mapping[str, Any], extra: Mapping[str, Any], fixtures: Sequence[Any] = ()
) -> Any:
    """Return an Audit object, not yet computed. Raises SettingsError, and then leaves no object behind."""
    obj = doc.addObject("App::FeaturePython", "Audit")
    try:
        Audit(obj)
        obj.NCFile, obj.Fixtures = nc_path, list(fixtures)
        convert.put_options(obj, AUDIT, options)
        for name, value in extra.items():
            setattr(obj, name, FreeCAD.Vector(*value) if isinstance(value, (tuple, list)) else value)
    except BaseException:
        doc.removeObject(obj.Name)
        raise
    return obj
