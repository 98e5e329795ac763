# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Audit object: a finished NC file of any origin, judged on a machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.files import check_readable, read_bytes
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.programs import ProgramDraft
from freecad_fiveaxis.core.pipeline.settings import AUDIT, build_settings, is_part

from . import compared, convert, results
from .plain_errors import hide_trace
from .properties import (
    HIDDEN,
    OUTPUT,
    QT_TRANSLATE_NOOP,
    WORK_ZERO,
    Property,
    list_drawn_tool,
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
NC_FILE = Property(
    "NCFile",
    "App::PropertyFile",
    "Base",
    QT_TRANSLATE_NOOP("App::Property", "The NC file that is judged"),
    "",
)


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
        if self.whole and name == PART.name and obj.Part is not None and not is_restored(obj):
            obj.PartLabel = obj.Part.Label

    @hide_trace
    def execute(self, obj: Any) -> None:
        """FreeCAD recomputes the object."""
        results.execute(obj)


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


def check_fixtures(doc: Any, fixtures: Sequence[Any], part: Any) -> list[Any]:
    """Give the fixtures of an Audit. Raises SelectionError for what is no solid and no mesh, and for the part
    itself."""
    for one in fixtures:
        compared.check_part(doc, one)
        if one is part:
            text = say(
                "{label} is the part to compare with: choose what holds it, or no fixture.", label=one.Label
            )
            raise SelectionError(text, one.Label)
    return list(fixtures)


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
