# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a tool path: a new one over a selected part, or one that is there already."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from freecad_fiveaxis.gui.qt import translate

from .fields import QuantityField
from .form import SPACING, Form, group_sections
from .path_panel import PathPanel, show
from .picking import PointField


class ToolpathPanel(PathPanel):
    """``base`` and ``faces`` of a new path, or the Toolpath ``obj`` to change."""

    def __init__(self, doc: Any, base: Any = None, faces: tuple[str, ...] = (), obj: Any = None) -> None:
        self.base, self.faces = base, faces
        meshed = _tessellation(obj) is None if obj else hasattr(base, "Mesh")
        form = Form("mill", doc, _sections(), self._extras(not meshed))
        super().__init__(doc, translate("FiveAxis", "Tool path"), form, obj)

    @staticmethod
    def _extras(tessellated: bool) -> list[Any]:
        point = PointField("work_zero", translate("FiveAxis", "The point of the part that is the program's zero"))
        if not tessellated:
            return [point]
        return [
            point,
            QuantityField("linear_deflection", "length", translate("FiveAxis", "How far the mesh may leave the solid")),
            QuantityField("angular_deflection", "angle", translate("FiveAxis", "How far two neighbouring facets may lean apart")),
        ]

    def compute(self) -> Any:
        """A new Toolpath, or the one that is there with other settings."""
        from freecad_fiveaxis import app
        from freecad_fiveaxis.app import changes

        settings = self.options.said()
        if self.obj is None:
            return app.create_toolpath(self.doc, self.base, faces=self.faces, **settings)
        return changes.change_toolpath(self.obj, settings)


def create(base: Any, faces: tuple[str, ...] = (), settings: Mapping[str, Any] | None = None) -> ToolpathPanel:
    """Open the panel for a new path over ``base``; its first values are the user's preferences, and above them ``settings``."""
    from freecad_fiveaxis.app import changes
    from freecad_fiveaxis.app.tessellation import ANGULAR, LINEAR

    panel = ToolpathPanel(base.Document, base, faces)
    meshing = {"linear_deflection": LINEAR, "angular_deflection": ANGULAR}
    panel.fill(changes.default_options("mill") | preferred() | meshing | dict(settings or {}))
    return show(panel)


def preferred() -> dict[str, Any]:
    """What the user's preferences say of a new path."""
    from freecad_fiveaxis.app import preferences

    return {
        "machine": preferences.machine(), "controller": preferences.controller(), "scallop": preferences.scallop(),
        "cutter": preferences.cutter(), "tolerance": preferences.tolerance(), "feed": preferences.feed(),
    } | {name: text for name, text in (("shank", preferences.shank()), ("holder", preferences.holder())) if text}  # fmt: skip


def edit(obj: Any) -> ToolpathPanel:
    """Open the panel for a Toolpath that is there."""
    from freecad_fiveaxis.app import changes

    panel = ToolpathPanel(obj.Document, obj=obj)
    values = changes.shown_options(obj, "mill") | {"work_zero": tuple(obj.WorkZero)}
    mesh = _tessellation(obj)
    if mesh is not None:
        values |= {"linear_deflection": mesh.LinearDeflection.Value, "angular_deflection": mesh.AngularDeflection.Value}
    panel.fill(values)
    return show(panel)


def _tessellation(obj: Any) -> Any:
    """The Tessellation that a Toolpath is made of, where it is one of a solid; None for any other mesh."""
    base = getattr(obj.Mesh, "Base", None)
    return obj.Mesh if base and hasattr(obj.Mesh, "LinearDeflection") and not hasattr(base[0], "Mesh") else None


def _sections() -> list[tuple[str, str, list[str]]]:
    return [
        ("machine", translate("FiveAxis", "Machine"), ["machine", "controller", "rtcp", "high_speed", "tool_length"]),
        ("cutter", translate("FiveAxis", "Cutter"), ["cutter"]),
        ("passes", translate("FiveAxis", "Passes"), [SPACING, "direction", "tolerance"]),
        ("axis", translate("FiveAxis", "Tool axis"), ["tool_axis", "axis", "lead", "tilt", "max_tilt"]),
        ("cure", translate("FiveAxis", "Against deviation"), ["linearize", "singularity", "max_axis_change"]),
        *group_sections("mill", only="GougeSettings"),
        ("feeds", translate("FiveAxis", "Feeds"), ["feed", "plunge_feed", "feed_mode"]),
        ("zero", translate("FiveAxis", "Work zero"), ["work_zero"]),
    ]
