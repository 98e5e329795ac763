# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the sliders and number fields of a LinuxCNC screen start with: the file of ``[DISPLAY] PYVCP``.

A ``scale`` with ``<halpin>"name"</halpin>`` feeds the pin pyvcp.name-f, a ``spinbox`` pyvcp.name;
``<initval>`` is where it starts (0 where that is missing). Nothing else of the file is read, and a file that
cannot be read says nothing.
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.errors import FiveAxisError

from .ini_file import IniFile, Value, text_lines

WIDGET = re.compile(r"<(scale|spinbox)>(.*?)</\1>", re.DOTALL)
PIN = re.compile(r"<halpin>\s*[\"']?([\w.-]+)[\"']?\s*</halpin>")
START = re.compile(r"<initval>\s*([^<\s]+)\s*</initval>")
SUFFIX = {"scale": "-f", "spinbox": ""}


def panel_values(ini: IniFile) -> dict[str, Value]:
    """Read the values that pins of the panel start with, by the pin's whole name; empty where there is no
    panel."""
    named = ini.get("DISPLAY", "PYVCP")
    if named is None or not named.text:
        return {}
    path = ini.path.parent / named.text
    try:
        text = "\n".join(line for line, _ in text_lines(path, "panel"))
    except FiveAxisError:
        return {}
    return {f"pyvcp.{pin}": Value(start, path.name) for pin, start in _widgets(text)}


def _widgets(text: str) -> list[tuple[str, str]]:
    """Pins and starting values; comments are left out."""
    found = []
    for kind, inner in WIDGET.findall(re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)):
        if pin := PIN.search(inner):
            start = START.search(inner)
            found.append((pin[1] + SUFFIX[kind], start[1] if start else "0"))
    return found
