# SPDX-License-Identifier: LGPL-2.1-or-later
"""A CAM Job of the FreeCAD that is running, made without a window."""

import importlib
from pathlib import Path

import FreeCAD


def make_job(doc, base):
    """A Job of ``base`` with FreeCAD's default tool (an end mill) and, as number 3, the 6 mm ball end that
    comes with FreeCAD."""
    FreeCAD.setActiveDocument(doc.Name)  # FreeCAD 0.20 makes tools in the active document
    job = _module("Path.Main.Job", "PathScripts.PathJob").Create("Job", [base], None)
    controller = _module("Path.Tool.Controller", "PathScripts.PathToolController").Create(
        "Ball", _ball(doc), 3
    )
    controller.HorizFeed, controller.VertFeed, controller.SpindleSpeed = "1000 mm/min", "200 mm/min", 12000
    job.Proxy.addToolController(controller)
    doc.recompute()
    return job


def _module(new, old):
    try:
        return importlib.import_module(new)
    except ImportError:
        return importlib.import_module(old)


def _ball(doc):
    mods = Path(FreeCAD.getHomePath()) / "Mod"
    file = next(
        path for name in ("CAM", "Path") for path in (mods / name / "Tools" / "Bit").glob("6mm_Ball_End.fctb")
    )
    try:
        from Path.Tool.toolbit import ToolBit
    except ImportError:
        return _module("Path.Tool.Bit", "PathScripts.PathToolBit").Factory.CreateFrom(str(file))
    return ToolBit.from_file(file).attach_to_doc(doc)
