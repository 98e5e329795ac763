# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of FreeCAD's preferences: its form is ``resources/ui/preferences.ui``, its values those of
``app.preferences``.

Each widget of the form that bears a parameter's name shows that parameter. The page is not left to FreeCAD's
own loading of forms, because the lists of machines and controllers are made when it opens.
"""

from __future__ import annotations

from typing import Any

import FreeCADGui

from freecad_fiveaxis.app import preferences

from .messages import status
from .qt import QtGui, QtWidgets, resource, translate

GROUP = "FiveAxis"
"""The page's group; its icon is ``preferences-fiveaxis.svg`` among FreeCAD's icon paths."""

VALUES = {
    "QLineEdit": "text",
    "Gui::PrefFileChooser": "fileName",
    "Gui::PrefColorButton": "color",
}
"""The property of a widget that holds its value, by its class."""


def register() -> None:
    """Add the page, its icon and the translations. Called once, when the window starts; imports nothing
    heavy."""
    FreeCADGui.addIconPath(resource("icons"))
    FreeCADGui.addLanguagePath(resource("translations"))
    FreeCADGui.updateLocale()  # FreeCAD has looked for translations before it came to the add-ons
    FreeCADGui.addPreferencePage(Page, GROUP)


class Page:
    """What FreeCAD asks of a page: a form, and to load and save it."""

    def __init__(self, _parent: Any = None) -> None:
        from .panels.fields import feed_unit
        from .preference_boxes import PreferenceBoxes

        self.form = FreeCADGui.PySideUic.loadUi(resource("ui", "preferences.ui"))
        self.boxes = PreferenceBoxes(self.form)
        self.loaded: dict[str, Any] = {}
        self.choices = {"Machine": _machines(), "Controller": _controllers(), "CutterKind": _kinds()}
        for key, choices in self.choices.items():
            self._widget(key).addItems(list(choices))
        suffix, self.feed_factor = feed_unit()
        self.boxes.by_key["Feed"].hold("feed", 1.0 / self.feed_factor, suffix)

    def loadSettings(self) -> None:
        """Show what is kept."""
        for key in preferences.DEFAULTS:
            self.show_value(key, preferences.read(key))
        self.loaded = self._all_shown()

    def saveSettings(self) -> None:
        """Keep what was changed; the boxes round, so a number that nobody touched stays as it was."""
        if self.boxes.refusal():
            status(self.boxes.refusal())
        for key, value in self._all_shown().items():
            if value != self.loaded[key]:
                preferences.write(key, value)
        self.loaded = self._all_shown()

    def resetSettingsToDefaults(self) -> None:
        """Forget what was kept (FreeCAD 1.0 and later have a button for it)."""
        preferences.reset()
        self.loadSettings()

    def _all_shown(self) -> dict[str, Any]:
        return {key: self.read_shown(key) for key in preferences.DEFAULTS}

    def show_value(self, key: str, value: Any) -> None:
        """Show a parameter's value."""
        if key in self.choices:
            labels = {kept: label for label, kept in self.choices[key].items()}
            self._widget(key).setCurrentText(labels.get(value, value))
        elif key in self.boxes.by_key:
            from .preference_boxes import show_in_box

            show_in_box(self.boxes.by_key[key], value * self.feed_factor if key == "Feed" else value)
        else:
            packed = self._property(key) == "color"
            shown = QtGui.QColor(value >> 24 & 255, value >> 16 & 255, value >> 8 & 255) if packed else value
            self._widget(key).setProperty(self._property(key), shown)

    def read_shown(self, key: str) -> Any:
        """Return the value that is shown for a parameter."""
        if key in self.choices:
            text = self._widget(key).currentText()
            return self.choices[key].get(text, text)
        if key in self.boxes.by_key:
            from .preference_boxes import read_box

            number = read_box(self.boxes.by_key[key])
            whole = isinstance(preferences.DEFAULTS[key], int)
            return int(number) if whole else number / self.feed_factor if key == "Feed" else number
        value = self._widget(key).property(self._property(key))
        return value.rgb() << 8 & 0xFFFFFF00 | 0xFF if isinstance(value, QtGui.QColor) else value

    def _widget(self, key: str) -> Any:
        return self.form.findChild(QtWidgets.QWidget, key)

    def _property(self, key: str) -> str:
        return VALUES[self._widget(key).metaObject().className()]


def _kinds() -> dict[str, str]:
    from freecad_fiveaxis.app.labels import choice_label
    from freecad_fiveaxis.core.tool import KINDS

    return {choice_label(kind): kind for kind in KINDS}


def _controllers() -> dict[str, str]:
    from freecad_fiveaxis.app.labels import controller_label
    from freecad_fiveaxis.core.controllers import DIALECTS

    return {
        translate("FiveAxis", "the machine's own"): "",
        **{controller_label(name): name for name in DIALECTS},
    }


def _machines() -> dict[str, str]:
    from freecad_fiveaxis.app.machines import choices

    by_label: dict[str, str] = {}
    for choice in choices():
        if not choice.error:
            by_label[choice.machine if choice.label in by_label else choice.label] = choice.machine
    return by_label
