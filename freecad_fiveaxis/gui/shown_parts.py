# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a path is shown in the view: switches for the panel and for the menu of the object.

part    a property of the path's view. Markers belong to the Markers object where there is one: then that one
        is shown or hidden.
"""

from __future__ import annotations

from typing import Any

from . import view_providers
from .panels.wrapping import WrappingRow
from .qt import QtWidgets, translate

MARKERS = "ShowMarkers"
FOLD = "FoldLegend"


def part_names() -> dict[str, str]:
    """Return the parts that have a switch, and what they are called."""
    return {
        "ShowCuts": translate("FiveAxis", "Cuts"),
        "ShowLinks": translate("FiveAxis", "Links"),
        "ShowRapids": translate("FiveAxis", "Rapids"),
        "ShowAxes": translate("FiveAxis", "Tool axes"),
        MARKERS: translate("FiveAxis", "Markers"),
    }


def is_shown(path: Any, part: str) -> bool:
    """Whether a part of the path is shown."""
    owner = view_providers.markers_of(path) if part == MARKERS else None
    return bool(owner.ViewObject.Visibility if owner is not None else getattr(path.ViewObject, part))


def show_part(path: Any, part: str, on: bool) -> None:
    """Show a part of the path, or hide it."""
    owner = view_providers.markers_of(path) if part == MARKERS else None
    if owner is not None:
        owner.ViewObject.Visibility = on
    else:
        setattr(path.ViewObject, part, on)


def add_entries(menu: Any, path: Any) -> None:
    """Give a menu an entry for each part, with a tick where it is shown."""
    inner = menu.addMenu(translate("FiveAxis", "Shown in the view"))
    inner.setObjectName("shown_parts")
    for part, name in part_names().items():
        entry = inner.addAction(name)
        entry.setObjectName(part)
        entry.setCheckable(True)
        entry.setChecked(is_shown(path, part))
        entry.triggered.connect(lambda *_, part=part, entry=entry: show_part(path, part, entry.isChecked()))


def add_fold(menu: Any, vobj: Any) -> None:
    """Give a menu an entry that folds the legend of a view to one line, with a tick where it is."""
    entry = menu.addAction(translate("FiveAxis", "Fold the legend"))
    entry.setObjectName(FOLD)
    entry.setCheckable(True)
    entry.setChecked(bool(vobj.FoldLegend))
    entry.triggered.connect(lambda *_: setattr(vobj, FOLD, entry.isChecked()))


class ShownParts(QtWidgets.QGroupBox):
    """The switches of one path, for its panel; hidden while there is no path."""

    def __init__(self) -> None:
        super().__init__(translate("FiveAxis", "Shown in the view"))
        self.setObjectName("shown_parts")
        self.path: Any = None
        self.boxes: dict[str, Any] = {}
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 4)
        for part, name in part_names().items():
            box = QtWidgets.QCheckBox(name)
            box.setObjectName(part)
            box.clicked.connect(lambda *_, part=part, box=box: show_part(self.path, part, box.isChecked()))
            self.boxes[part] = box
        column.addWidget(WrappingRow(tuple(self.boxes.values())))
        self.show_for(None)

    def show_for(self, path: Any) -> None:
        """Show what is shown of this path; None: there is none."""
        self.path = path
        self.setVisible(path is not None)
        for part, box in self.boxes.items() if path is not None else ():
            box.setChecked(is_shown(path, part))
