# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by freecadcmd before the sitting: the part that the user has drawn on another day, and which FreeCAD
this is."""

import os
import sys
import traceback

import FreeCAD
import Import
import Part


def draw(path):
    """A box with a rounded edge, and a body of the same size beside it, in one file."""
    doc = FreeCAD.newDocument("Part")
    box = doc.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 30, 20, 10
    fillet = doc.addObject("Part::Fillet", "Rounded")
    fillet.Base = box
    doc.recompute()
    top = [
        at
        for at, edge in enumerate(box.Shape.Edges, 1)
        if edge.BoundBox.ZMin > 9.9 and edge.BoundBox.YLength > 19.9
    ]
    fillet.Edges = [(at, 3.0, 3.0) for at in top]
    body = doc.addObject("PartDesign::Body", "Body")
    block = doc.addObject("PartDesign::AdditiveBox", "Block")
    block.Length, block.Width, block.Height = 30, 20, 10
    body.addObject(block)
    block.Placement.Base = FreeCAD.Vector(60, 0, 0)
    doc.recompute()
    assert isinstance(fillet.Shape, Part.Shape) and fillet.Shape.isValid() and body.Shape.isValid()
    doc.saveAs(path)
    solid = doc.addObject("Part::Feature", "Imported")
    solid.Shape = fillet.Shape
    Import.export([solid], path.replace("FCStd", "step"))


try:
    draw(os.environ["FIVEAXIS_PART"])
    with open(os.environ["FIVEAXIS_VERSION"], "w", encoding="ascii") as file:
        file.write(".".join(FreeCAD.Version()[:2]))
    code = 0
except BaseException:
    traceback.print_exc()
    code = 1
sys.stdout.flush()
os._exit(code)
