# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all our document objects have in common: a proxy without data, and properties that grow with the
versions.

proxy           the Python object behind a document object. All data is in properties, so that a document is
                whole without us.
SchemaVersion   a hidden property: which version's properties the object has. Objects without it are of
                version 0.
migration       what brings an object of an older version up to date when its document is opened. Nothing is
                ever taken away.

The paths of the proxy classes stand in saved documents: they are forever.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD

from freecad_fiveaxis.core.base.quantity import stack_text
from freecad_fiveaxis.core.pipeline.settings import MILL

from . import feed_per_minute
from .properties import CUTTER, HIDDEN, Property, add_missing, list_drawn_tool, setting_properties, show_sizes

SCHEMA = 5
LABELS, DOUBLES = "User parameter:BaseApp/Preferences/Document", "DuplicateLabels"
"""Where FreeCAD keeps whether two objects may have one label."""
VERSION = Property(
    "SchemaVersion", "App::PropertyInteger", "Base", "The version of this object's properties", 0, HIDDEN
)  # fmt: skip


class Proxy:
    """Base of our proxies. A subclass lists its ``properties`` and knows how to ``execute``."""

    whole = False
    """Whether the object has all its properties, so that one may follow another."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        add_missing(obj, [*self.properties(), VERSION])
        obj.SchemaVersion = SCHEMA
        self._show(obj)
        give_label(obj)
        self._begin()

    def _begin(self) -> None:
        """Begin what the proxy remembers while the document is open; also called after opening."""

    @classmethod
    def properties(cls) -> Sequence[Property]:
        """Return the properties of an object of this kind, in order."""
        raise NotImplementedError(cls.__name__)

    def onDocumentRestored(self, obj: Any) -> None:
        """FreeCAD has read the object from a file, or made a copy of it."""
        self._begin()
        migrate(obj, self.properties())
        self._show(obj)

    def _show(self, obj: Any) -> None:
        """Show in the property editor what the object's own values call for."""
        show_sizes(obj)
        feed_per_minute.show(obj)
        self.whole = True

    def onChanged(self, obj: Any, name: str) -> None:
        """FreeCAD has set a property, in a document that is open or while it reads one."""
        if name == CUTTER[0].name:
            show_sizes(obj)
        if self.whole and not is_restored(obj):
            feed_per_minute.follow(obj, name)

    def dumps(self) -> None:
        """FreeCAD 0.21 and later: nothing to save but the properties."""

    def loads(self, state: Any) -> None:
        """FreeCAD 0.21 and later."""
        self._begin()

    def __getstate__(self) -> None:
        """FreeCAD 0.20 knows these two names only."""

    def __setstate__(self, state: Any) -> None:
        self._begin()


def is_restored(obj: Any) -> bool:
    """Whether FreeCAD itself puts properties back: it reads a file, or undoes or redoes a step."""
    return bool(FreeCAD.isRestoring() or obj.Document.Transacting)


def give_label(obj: Any) -> None:
    """Give the first label of its kind that no other object has: Toolpath, Toolpath001 ...

    FreeCAD 1.1 never gives a label again that an object had whose making was undone or stopped; it does so
    while doubles are allowed.
    """
    kind, taken = (
        obj.Name.rstrip("0123456789"),
        {one.Label for one in obj.Document.Objects if one.Name != obj.Name},
    )
    free = next(
        label for label in (kind, *(f"{kind}{i:03d}" for i in range(1, len(taken) + 2))) if label not in taken
    )
    if obj.Label == free:
        return
    group = FreeCAD.ParamGet(LABELS)
    allowed = {name: value for _, name, value in group.GetContents() or []}.get(DOUBLES)
    group.SetBool(DOUBLES, True)
    try:
        obj.Label = free
    finally:
        group.RemBool(DOUBLES) if allowed is None else group.SetBool(DOUBLES, allowed)


def migrate(obj: Any, properties: Sequence[Property]) -> None:
    """Bring an object up to this version: run the step of each version that it has missed; what is still
    missing is added.

    An object of a later version stays as it is but for that: what we do not know is kept for the program that
    does.
    """
    version = getattr(obj, VERSION.name, 0)
    if version > SCHEMA:
        FreeCAD.Console.PrintWarning(
            f"{obj.Label} was saved by a later version of the five-axis workbench (schema {version}, here "
            f"{SCHEMA}); "
            "properties that are not known here are kept but not used\n"
        )
    for step in range(max(version, 0), SCHEMA):  # no version is below 0, but a document may say so
        STEPS[step](obj)
    add_missing(obj, [*properties, VERSION])
    obj.SchemaVersion = max(version, SCHEMA)


def _from_0(obj: Any) -> None:
    """Version 0 had the same properties under the same names, but fewer, and no SchemaVersion: adding the
    missing is all."""


def _from_1(obj: Any) -> None:
    """Version 1 had no cure but Linearize, which could only be ``off``: more choices, and properties that are
    added."""


def _from_2(obj: Any) -> None:
    """Version 2 had joint output only, three controllers, and no files to read but the audited one:
    properties are added."""


def _from_3(obj: Any) -> None:
    """Version 3 had ball cutters only, no cure of gouges, and a holder of one cylinder that was only drawn:
    HolderDiameter and HolderLength. It becomes the text of Holder; the two stay where they are, out of sight.
    What was cured by default only later stays off: the path is what it was."""
    if "LeastInterval" in obj.PropertiesList:  # a toolpath
        lacking = [
            one
            for one in setting_properties(MILL)
            if one.name in ("Linearize", "Gouge") and not hasattr(obj, one.name)
        ]
        add_missing(obj, lacking)
        for one in lacking:
            setattr(obj, one.name, "off")
    old = [name for name in ("HolderDiameter", "HolderLength") if name in obj.PropertiesList]
    if len(old) < 2 or "Holder" in obj.PropertiesList:
        return
    add_missing(obj, list_drawn_tool())
    diameter, length = (
        float(f"{getattr(obj, name).Value:.12g}") for name in old
    )  # files keep no more digits
    if min(diameter, length) > 0.0:
        obj.Holder = stack_text(((diameter, length),))
    for name in old:
        obj.setEditorMode(name, ["Hidden"])


def _from_4(obj: Any) -> None:
    """Version 4 went over the part between all passes, and had planes only, once without a choice: so it
    stays, the path is what it was."""
    if "LeastInterval" not in obj.PropertiesList:  # no toolpath
        return
    for name, value in (("Links", "over"), ("PassStrategy", "planes"), ("ToolAxis", "facet_mean")):
        if not hasattr(obj, name):
            add_missing(obj, [one for one in setting_properties(MILL) if one.name == name])
            setattr(obj, name, value)


STEPS: dict[int, Callable[[Any], None]] = {0: _from_0, 1: _from_1, 2: _from_2, 3: _from_3, 4: _from_4}
"""From each version to the next: what the plain adding of missing properties would lose, as the value of a
renamed one."""
