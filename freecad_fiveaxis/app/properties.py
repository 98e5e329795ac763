# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of our document objects, made from the fields of the core's settings.

setting property   option ``least_interval`` is property ``LeastInterval``, in a group that bears a name of
                   the trade, the same as in the panel of a tool path: Part, Machine, Tool, Passes, Axis,
                   Safety, Output. Files to write (OutputSettings) and the file of faces (FacesSettings) are
                   no properties; other files to read are. The cutter is six properties, CUTTER: its kind and
                   its sizes, of which those count that the kind has.
result property    what the last computation found; read-only, and a change of it does not make the object out
                   of date.

FreeCAD keeps lengths in mm, angles in degrees and feeds in **mm/s**, and shows them in the user's units; a
feed has a second property for the editor, in mm/min (:mod:`.feed_per_minute`).
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.quantity import stack_text
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.orientation.strategies import STRATEGIES
from freecad_fiveaxis.core.passes import PASS_STRATEGIES
from freecad_fiveaxis.core.pipeline.settings import MILL, FacesSettings, OutputSettings, option_fields
from freecad_fiveaxis.core.tool import KINDS as CUTTER_KINDS
from freecad_fiveaxis.core.tool import SIZES as CUTTER_SIZES
from freecad_fiveaxis.core.tool import Cutter, kind_of

from .feed_per_minute import PER_MINUTE
from .option_texts import editor_text

READ_ONLY, HIDDEN, OUTPUT = 1, 4, 8
"""FreeCAD's attributes of a property. OUTPUT: setting it does not touch the object."""
RESULT = READ_ONLY | OUTPUT
MACHINES_OWN = "machine's own"
"""The first choice of Controller: what the machine's file says."""


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:
    """Mark a text for the translators; FreeCAD itself translates the documentation of properties when it
    shows them."""
    return text


@dataclass(frozen=True)
class Property:
    """One property: ``name``, FreeCAD's ``kind`` of it, ``group``, ``text`` for the user, ``default``,
    attributes, choices."""

    name: str
    kind: str
    group: str
    text: str
    default: Any = None
    attributes: int = 0
    choices: tuple[str, ...] = ()


KINDS = {
    "length": "App::PropertyLength", "angle": "App::PropertyAngle", "feed": "App::PropertySpeed",
    "choice": "App::PropertyEnumeration", "text": "App::PropertyString", "vector": "App::PropertyVector",
    "point": "App::PropertyVectorDistance", "lengths": "App::PropertyVectorDistance",
    "counts": "App::PropertyVector",
    "number": "App::PropertyFloat", "speed": "App::PropertyFloat", "count": "App::PropertyInteger",
    "path": "App::PropertyFile",
    "curve": "App::PropertyFile",
    "stack": "App::PropertyString", "height": "App::PropertyString",
    "place": "App::PropertyString",
}  # fmt: skip
"""FreeCAD's kind of property for each kind of option. A kind that is not here makes no property."""
_ENUMERATED = {
    "controller": (MACHINES_OWN, *DIALECTS),
    "tool_axis": tuple(STRATEGIES),
    "passes": tuple(PASS_STRATEGIES),
}

_GROUPS = {
    "PassSettings": QT_TRANSLATE_NOOP("App::Property", "Passes"),
    "BoundarySettings": QT_TRANSLATE_NOOP("App::Property", "Passes"),
    "CutterSettings": QT_TRANSLATE_NOOP("App::Property", "Tool"),
    "ToolAxisSettings": QT_TRANSLATE_NOOP("App::Property", "Axis"),
    "LinkSettings": QT_TRANSLATE_NOOP("App::Property", "Passes"),
    "FeedSettings": QT_TRANSLATE_NOOP("App::Property", "Tool"),
    "HeadSettings": QT_TRANSLATE_NOOP("App::Property", "Output"),
    "MachineSettings": QT_TRANSLATE_NOOP("App::Property", "Machine"),
    "CureSettings": QT_TRANSLATE_NOOP("App::Property", "Safety"),
    "GougeSettings": QT_TRANSLATE_NOOP("App::Property", "Safety"),
    "ProofSettings": QT_TRANSLATE_NOOP("App::Property", "Safety"),
    "SetupSettings": QT_TRANSLATE_NOOP("App::Property", "Setup"),
    "ReadingSettings": QT_TRANSLATE_NOOP("App::Property", "Reading"),
    "AuditSettings": QT_TRANSLATE_NOOP("App::Property", "Comparison"),
}
"""The group of the options of a settings class."""
_MOVED = {
    "coedge_tolerance": "Passes", "clearance": "Safety", "feed_mode": "Output", "tool": "Tool",
    "spindle": "Tool",
    "control_point": "Output", "shank": "Tool", "holder": "Tool", "avoid_allowance": "Part",
}  # fmt: skip
"""Options that machinists look for in another group than that of their class."""


def group_of(cls: type, leaf: dataclasses.Field[Any]) -> str:
    """Return the group of an option, by a name of the trade; of a class that is new, the class's own."""
    return _MOVED.get(leaf.name) or _GROUPS.get(cls.__name__) or cls.__name__.removesuffix("Settings")


WORK_ZERO = Property(
    "WorkZero", "App::PropertyVectorDistance", QT_TRANSLATE_NOOP("App::Property", "Part"),
    QT_TRANSLATE_NOOP("App::Property", "The place of the work zero in the document"), (0.0, 0.0, 0.0),
)  # fmt: skip
CORNER, TAPER, NECK, FLANK = 1.0, 5.0, 3.0, 85.0
"""mm, deg, mm and mm: the sizes of a new object's cutter that its kind has not, so that another kind is a
cutter at once."""
CUTTER = (
    Property(
        "CutterKind", KINDS["choice"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Cutter shape: ball, flat, bull nose, tapered ball or bull nose, "
            "lollipop, barrel"),
        choices=tuple(CUTTER_KINDS),
    ),
    Property(
        "CutterDiameter", KINDS["length"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Diameter of the cutter; of a tapered one at its round end, of a "
            "barrel the largest"),
    ),
    Property(
        "CutterCorner", KINDS["length"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Corner radius of a bull nose, or radius of a barrel's tip; other "
            "kinds have none"),
    ),
    Property(
        "CutterTaper", KINDS["angle"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Angle between the flank of a tapered cutter and its axis; other "
            "kinds have none"),
    ),
    Property(
        "CutterNeck", KINDS["length"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Diameter of a lollipop's neck, less than that of its ball; other "
            "kinds have none"),
    ),
    Property(
        "CutterFlank", KINDS["length"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Radius of a barrel's flank, more than half its diameter; other "
            "kinds have none"),
    ),
    Property(
        "CutterLength", KINDS["length"], "Tool",
        QT_TRANSLATE_NOOP("App::Property", "Length of the cutter's edge, from the tip upwards; of a lollipop "
            "with its neck"),
    ),
)  # fmt: skip
_FROM_MACHINE = QT_TRANSLATE_NOOP(
    "App::Property", "Take the work zero's place on the machine from the machine's file"
)

_PER_MINUTE = {
    "feed": QT_TRANSLATE_NOOP("App::Property", "Feed rate of the tip over the part, in mm/min"),
    "plunge_feed": QT_TRANSLATE_NOOP("App::Property", "Feed rate of the approach to the part, in mm/min"),
}
"""What the editor says of a feed in mm/min."""


_NAMED = {
    "passes": "PassStrategy",
    "from_": "PassesFrom",
    "to": "PassesTo",
    "rest": "Left",
    "nc_units": "ProgramUnits",
}
"""Options whose own name is that of a result, or Python's, or came after the property: saved documents have
it for good."""


def property_name(option: str) -> str:
    """``least_interval`` -> ``LeastInterval``."""
    if option in _NAMED:
        return _NAMED[option]
    return "".join(part[:1].upper() + part[1:] for part in option.split("_"))


def list_options(task: str) -> Iterator[tuple[type, dataclasses.Field[Any]]]:
    """Group and field of every option of the task that has properties and fields of its own: all but the
    files to write and the file of faces, which are selected instead."""
    for cls, leaf in option_fields(task):
        if cls not in (FacesSettings, OutputSettings) and leaf.metadata["kind"] in (*KINDS, "cutter"):
            yield cls, leaf


@cache
def setting_properties(task: str) -> tuple[Property, ...]:
    """Return a property for every option of the task that is not a file to write."""
    return tuple(one for cls, leaf in list_options(task) for one in _of_option(group_of(cls, leaf), leaf))


def _of_option(group: str, leaf: dataclasses.Field[Any]) -> Iterable[Property]:
    kind, text = leaf.metadata["kind"], editor_text(leaf)
    if kind == "cutter":
        cutter: Any = leaf.default
        values = cutter_values(cutter)
        return [
            dataclasses.replace(one, default=values.get(one.name, _UNUSED.get(one.name))) for one in CUTTER
        ]
    choices = _ENUMERATED.get(leaf.name, leaf.metadata["choices"])
    name, type_ = property_name(leaf.name), KINDS["choice" if choices else kind]
    properties = [Property(name, type_, group, text, default_value(leaf), choices=choices)]
    if kind == "point":
        properties.append(
            Property(name + "FromMachine", "App::PropertyBool", group, _FROM_MACHINE, leaf.default is None)
        )
    if kind == "feed":
        properties.append(
            Property(name + PER_MINUTE, "App::PropertyFloat", group, _PER_MINUTE.get(leaf.name, text))
        )
    return properties


_UNUSED = {"CutterCorner": CORNER, "CutterTaper": TAPER, "CutterNeck": NECK, "CutterFlank": FLANK}


def cutter_values(cutter: Cutter) -> dict[str, Any]:
    """Return what the properties CUTTER hold of a cutter, but for the sizes that its kind has not (mm,
    deg)."""
    kind = kind_of(cutter)
    values = {name: getattr(cutter, name) for name in CUTTER_SIZES} | {
        "taper": round(math.degrees(cutter.taper), 12)
    }
    return {"CutterKind": kind} | {
        cutter_property(size): values[size] for size in ("diameter", *CUTTER_KINDS[kind], "length")
    }


def cutter_property(size: str) -> str:
    """Return the property of a size of the cutter: ``CutterCorner`` of ``corner``."""
    return "Cutter" + size.capitalize()


def show_sizes(obj: Any) -> None:
    """Show those sizes of the cutter that its kind has in the property editor. Nothing is done to an object
    without a cutter."""
    has = CUTTER_KINDS.get(getattr(obj, "CutterKind", ""), ())
    for size in CUTTER_SIZES:
        if (name := cutter_property(size)) in _UNUSED and name in obj.PropertiesList:
            obj.setEditorMode(name, [] if size in has else ["Hidden"])


def list_drawn_tool(task: str = "") -> tuple[Property, ...]:
    """Shank and holder, as those of ``mill``, as far as they are no settings of the task but only drawn."""
    own = {one.name for one in setting_properties(task)} if task else set()
    return tuple(one for one in setting_properties(MILL) if one.name in {"Shank", "Holder"} - own)


def default_value(leaf: dataclasses.Field[Any]) -> Any:
    """Return the option's default as the property holds it: degrees, mm/s; where nothing is given 0, an empty
    text, the first choice."""
    return property_value(leaf, leaf.default)


def property_value(leaf: dataclasses.Field[Any], value: Any) -> Any:
    """Return a value of the core (rad, mm/min) as the property holds it."""
    kind = leaf.metadata["kind"]
    if value is None:
        none = {
            "height": "",
            "vector": (0.0, 0.0, 0.0),
            "point": (0.0, 0.0, 0.0),
            "counts": (0.0, 0.0, 0.0),
            "count": 0,
            "text": MACHINES_OWN,
            "path": "",
            "curve": "",
        }
        return none.get(kind, 0.0)
    if kind == "angle":
        return round(math.degrees(value), 12)
    if kind == "feed":
        return value / 60.0
    if kind == "stack":
        return stack_text(value)
    if kind == "place" and not isinstance(value, str):
        return ",".join(f"{number:.12g}" for number in value)
    if kind == "height":
        return f"{value:.12g}"
    return int(value) if kind == "count" else value


FINGERPRINT = Property(
    "Fingerprint", "App::PropertyString", "Result",
    QT_TRANSLATE_NOOP("App::Property", "Of the mesh and the settings that the result is of"), "",
    RESULT | HIDDEN,
)  # fmt: skip
FINDINGS = Property(
    "Findings", "App::PropertyStringList", "Result",
    QT_TRANSLATE_NOOP("App::Property", "What the result says about itself, in plain sentences"), [], RESULT,
)  # fmt: skip

_INSTEAD = {"App::PropertyTime": "App::PropertyFloat"}
"""FreeCAD 0.20 has no property of time: there it is a plain number of seconds."""


def add_missing(obj: Any, properties: Iterable[Property]) -> None:
    """Give the object each property that it does not have, with its default; choices, groups and texts are
    brought up to date."""
    there, known = set(obj.PropertiesList), None
    for one in properties:
        if one.name in there:
            _renew_choices(obj, one)
            _renew_words(obj, one)
            continue
        known = known or set(obj.supportedProperties())
        kind = one.kind if one.kind in known else _INSTEAD[one.kind]
        obj.addProperty(kind, one.name, one.group, one.text, one.attributes)
        _set_default(obj, one)


def _renew_words(obj: Any, one: Property) -> None:
    if obj.getGroupOfProperty(one.name) != one.group:
        obj.setGroupOfProperty(one.name, one.group)
    if obj.getDocumentationOfProperty(one.name) != one.text:
        obj.setDocumentationOfProperty(one.name, one.text)


def _set_default(obj: Any, one: Property) -> None:
    if one.choices:
        setattr(obj, one.name, list(one.choices))
    if one.default is not None:
        setattr(
            obj, one.name, FreeCAD.Vector(*one.default) if isinstance(one.default, tuple) else one.default
        )


def _renew_choices(obj: Any, one: Property) -> None:
    """Offer the choices of this version. A choice that is gone stays, so that the core can say so when it is
    used."""
    if not one.choices or tuple(obj.getEnumerationsOfProperty(one.name) or ()) == one.choices:
        return
    value = getattr(obj, one.name)
    setattr(obj, one.name, [*one.choices, *({value} - set(one.choices) - {None})])
    setattr(obj, one.name, value or one.default)
