# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document side of FreeCAD, with and without a window: five functions for macros, and the objects behind them.

Nothing is imported before it is used: numpy and scipy take their time to load.
"""

from __future__ import annotations

from typing import Any

__all__ = ["annotate", "audit", "create_toolpath", "post_process", "tessellate"]


def tessellate(obj: Any, stl_path: Any = None, *, overwrite: bool = False, **settings: Any) -> Any:
    """Mesh a solid; returns the Tessellation object.

    ``obj``: a solid, body, compound, mesh or Tessellation (then it is only written). ``stl_path``: write the mesh there as
    well; a file with content is replaced only with ``overwrite``. Settings: ``linear_deflection`` mm (0.02),
    ``angular_deflection`` deg (15), ``faces`` as ("Face3",): what a toolpath of it will mill.
    Raises SelectionError, SettingsError, FileError, Cancelled; then neither an object nor a file is left behind.
    """
    from .actions import tessellate as act

    return act(obj, stl_path, overwrite, settings)


def create_toolpath(doc: Any, base: Any, **settings: Any) -> Any:
    """A computed toolpath; returns the Toolpath object.

    ``base``: a solid, body, compound, mesh or Tessellation object, or ``(object, ["Face3"])``. Settings as in job files:
    ``machine="trunnion_ac", cutter="ball:10", scallop=0.01, feed=1000, ...``; also ``work_zero=(x, y, z)`` mm, ``faces``,
    ``linear_deflection`` mm, ``angular_deflection`` deg, ``holder_diameter`` and ``holder_length`` mm.
    Raises FiveAxisError; then the document is as it was.
    """
    from .actions import create_toolpath as act

    return act(doc, base, settings)


def post_process(toolpath: Any, nc_path: Any, overwrite: bool = False) -> Any:
    """Write the NC file; returns the NCOutput object.

    A file that is there is replaced only where asked, where it is empty, or where it still is what was written last.
    Raises FileError and what the toolpath's computation raises; then the file is as it was.
    """
    from .nc_output import post_process as act

    return act(toolpath, nc_path, overwrite)


def annotate(toolpath: Any) -> Any:
    """Markers at the places worth a look; returns the Markers object, one a path. Raises FiveAxisError."""
    from .actions import annotate as act

    return act(toolpath)


def audit(doc: Any, nc_path: Any, machine: str, **settings: Any) -> Any:
    """Judge a finished NC file on a machine; returns the Audit object, computed.

    Settings: ``controller``, ``tolerance`` mm, ``method``, ``origin``, ``tool_length``, and ``work_zero`` for the drawing.
    Raises FiveAxisError; then the document is as it was.
    """
    from .actions import audit as act

    return act(doc, nc_path, machine, settings)
