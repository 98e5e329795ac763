# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Setup object: machine, controller, work zero and cutters that several toolpaths share.

linked    a toolpath whose property Setup names one. It keeps the shared values in properties of its own,
          which follow those of its setup and cannot be edited meanwhile; where the setup is deleted, they
          stay as they are.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline.options import dialect_for
from freecad_fiveaxis.core.pipeline.settings import MILL, build_settings
from freecad_fiveaxis.core.tool import cutter_text, parse_cutter

from . import cam, convert, tool_bit, wording
from .arguments import names, place, refuse
from .plain_errors import hide_trace
from .properties import QT_TRANSLATE_NOOP, WORK_ZERO, Property, property_name, setting_properties
from .schema import Proxy, is_restored
from .selection import SelectionError

OPTIONS = ("machine", "controller", "origin", "tool_length", "work_offset")
"""The options that are shared."""
SHARED = (*(property_name(option) for option in OPTIONS), "OriginFromMachine", WORK_ZERO.name)
"""The properties that are shared."""
LINK = Property(
    "Setup", "App::PropertyLinkGlobal", "Machine",
    QT_TRANSLATE_NOOP("App::Property", "The setup whose machine, controller and work zero the path takes; "
        "empty: its own"),
)  # fmt: skip
TOOLS = Property(
    "Tools", "App::PropertyStringList", "Tool",
    QT_TRANSLATE_NOOP("App::Property", "The cutters of the setup, one a line: number, shape with its sizes, "
        "name"), [],
)  # fmt: skip
DEFAULT_MACHINE = "trunnion_ac"


class JobSetup(Proxy):
    """Proxy of a setup."""

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return what is shared, and the list of cutters."""
        return (*(one for one in setting_properties(MILL) if one.name in SHARED), WORK_ZERO, TOOLS)

    def onChanged(self, obj: Any, name: str) -> None:
        """Let the linked toolpaths follow, and wait to be computed."""
        if name in SHARED and not is_restored(obj):
            for path in paths_of(obj):
                copy_shared(obj, path, (name,))

    @hide_trace
    def execute(self, obj: Any) -> None:
        """Nothing is computed."""


def is_setup(obj: Any) -> bool:
    """Whether the object is a Setup."""
    return isinstance(getattr(obj, "Proxy", None), JobSetup)


def setups_of(doc: Any) -> list[Any]:
    """Return the Setups of a document."""
    return [obj for obj in doc.findObjects("App::FeaturePython") if is_setup(obj)]


def only_setup(doc: Any) -> Any | None:
    """Return the document's Setup where it has just one."""
    there = setups_of(doc)
    return there[0] if len(there) == 1 else None


def paths_of(setup: Any) -> list[Any]:
    """Return the toolpaths that are linked to a setup."""
    return [one for one in setup.InList if getattr(one, LINK.name, None) is setup]


def copy_shared(setup: Any, path: Any, names: Iterable[str] = SHARED) -> None:
    """Give the path the setup's values; one that is the same already does not touch it."""
    for name in names:
        if hasattr(setup, name) and hasattr(path, name):
            value = getattr(setup, name)
            if convert.plain(getattr(path, name)) != convert.plain(value):
                setattr(path, name, FreeCAD.Vector(value) if isinstance(value, FreeCAD.Vector) else value)


def follow(path: Any) -> None:
    """Take the values of the setup that a toolpath was linked to; let it be edited again where it is none."""
    setup = getattr(path, LINK.name, None)
    for name in SHARED:
        if name in path.PropertiesList:
            path.setEditorMode(name, ["ReadOnly"] if setup is not None else [])
    if setup is not None and not is_restored(path):
        copy_shared(setup, path)


def options_of(setup: Any) -> dict[str, Any]:
    """Return what the setup says, as ``create_toolpath`` takes it (mm)."""
    options = {"machine": setup.Machine, "work_offset": setup.WorkOffset, "work_zero": tuple(setup.WorkZero)}
    options |= (
        {"controller": setup.Controller}
        if setup.Controller != setup.getEnumerationsOfProperty("Controller")[0]
        else {}
    )
    options |= {"tool_length": setup.ToolLength.Value} if setup.ToolLength.Value else {}
    return options | ({} if setup.OriginFromMachine else {"origin": tuple(setup.Origin)})


def create(doc: Any, settings: Mapping[str, Any], job: Any = None) -> Any:
    """See :func:`freecad_fiveaxis.app.create_setup`."""
    options = {"machine": DEFAULT_MACHINE} | {
        name: value for name, value in settings.items() if value is not None
    }
    zero, tools = options.pop("work_zero", None), options.pop("tools", None)
    lines = None if tools is None else list(names(tools))
    obj = doc.addObject("App::FeaturePython", "Setup")
    try:
        JobSetup(obj)
        put(obj, options, zero)
        obj.Tools = (
            lines if lines is not None else [line for one in _jobs(doc, job) for line in tools_of(one)]
        )
    except BaseException:
        doc.removeObject(obj.Name)
        raise
    doc.recompute([obj])
    return obj


def put(setup: Any, options: Mapping[str, Any], zero: Any = None) -> None:
    """Give a setup these options; one that is missing goes back to its default. Raises SettingsError, and
    then has set none."""
    check(options)
    at = None if zero is None else place(zero, "work_zero")
    for one in JobSetup.properties():
        if one.name in SHARED and one.name not in ("Machine", WORK_ZERO.name):
            value = one.default
            setattr(setup, one.name, FreeCAD.Vector(*value) if isinstance(value, tuple) else value)
    convert.put_options(setup, MILL, options)
    if at is not None:
        setup.WorkZero = FreeCAD.Vector(*at)


def check(options: Mapping[str, Any]) -> None:
    """Look at options that a setup is to get. Raises SettingsError, MachineError."""
    settings = build_settings(MILL, "part", options)
    if unknown := sorted(set(options) - set(OPTIONS)):
        text = say(
            "{unknown}: no setting of a setup; known: {known}", unknown=", ".join(unknown),
            known=", ".join((*OPTIONS, "work_zero", "tools")),
        )  # fmt: skip
        raise SettingsError(text, unknown[0])
    dialect = dialect_for(settings.machine.controller, load_machine(settings.machine.machine))
    dialect.check_offset(settings.head.work_offset)


def check_setup(doc: Any, given: Any) -> Any:
    """Return a Setup of the document. Raises SelectionError for anything else."""
    if not is_setup(given):
        raise refuse(given, say("a setup, as create_setup gives it"))
    if given.Document.Name != doc.Name:
        text = say(
            "{label} is in another document: select something in {document}.", label=given.Label,
            document=doc.Label,
        )  # fmt: skip
        raise SelectionError(text, given.Label)
    return given


def tools_of(job: Any) -> list[str]:
    """Return the tools of a CAM Job that are of use here, as ``T3 ball:6.0:30.0 Name``."""
    return [
        f"T{tool.number} {cutter_text(tool.cutter)} {tool.label}"
        for tool in tool_bit.cutters_of_job(job)
        if tool.cutter
    ]


def cutters_of(setup: Any) -> list[tool_bit.JobTool]:
    """Return the tools that a setup lists; a line that cannot be read is a tool of no use, which says why."""
    return [_tool(line) for line in setup.Tools if line.strip()]


def _tool(line: str) -> tool_bit.JobTool:
    number, text, label = [*line.split(maxsplit=2), "", ""][:3]
    try:
        if not number[1:].isdecimal():
            raise SettingsError(
                say("{line} is no tool; write number, cutter and name, as T3 ball:6:30 Finisher", line=line),
                line,
            )
        return tool_bit.JobTool(label or text, int(number[1:]), parse_cutter(text))
    except SettingsError as error:
        return tool_bit.JobTool(
            label or line, int(number[1:]) if number[1:].isdecimal() else 0, None, wording.localize(error)
        )


def _jobs(doc: Any, job: Any) -> list[Any]:
    return [job] if job is not None else cam.jobs_of(doc)[:1]
