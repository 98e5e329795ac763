# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by freecadcmd before the pictures are made: a block with a groove, a dome and a knob, each in a file
beside FIVEAXIS_PART."""

import os
import sys
import traceback

import FreeCAD
import Part
from FreeCAD import Vector


def save(shape, name):
    """One solid in a document of its own."""
    doc = FreeCAD.newDocument(name)
    solid = doc.addObject("Part::Feature", name)
    solid.Shape = shape
    assert shape.isValid()
    doc.recompute()
    doc.saveAs(os.path.join(os.path.dirname(os.environ["FIVEAXIS_PART"]), name.lower() + ".FCStd"))


def groove():
    """48 x 16 x 12 mm, a V groove of 90 deg and 6 mm deep along Y in its top."""
    outline = [(-24, -6), (24, -6), (24, 6), (6, 6), (0, 0), (-6, 6), (-24, 6), (-24, -6)]
    return Part.Face(Part.makePolygon([Vector(x, -8, z) for x, z in outline])).extrude(Vector(0, 16, 0))


def dome():
    """A cap of 20 mm radius on a foot of 5 mm, its top at the pole of every machine with an upright rotary
    axis."""
    return Part.makeSphere(20, Vector(0, 0, -5)).common(Part.makeCylinder(16, 20)).removeSplitter()


def knob():
    """A ball of 13 mm radius, cut off at Z 40, on a stem of 6 mm on a foot of 18 mm; across its top a slot of
    4 mm."""
    parts = [Part.makeCylinder(6, 24, Vector(0, 0, 6)), Part.makeSphere(13, Vector(0, 0, 32))]
    whole = Part.makeCylinder(18, 8).fuse(parts).removeSplitter()
    corners = [one for one in whole.Edges if abs(one.CenterOfMass.z - 8) < 0.1 and one.BoundBox.XLength < 20]
    return (
        whole.makeFillet(4, corners)
        .cut(Part.makeBox(60, 60, 20, Vector(-30, -30, 40)))
        .cut(Part.makeBox(4, 60, 9, Vector(-2, -30, 36)))
    )


try:
    save(groove(), "Groove")
    save(knob(), "Knob")
    save(dome(), "Dome")
    code = 0
except BaseException:
    traceback.print_exc()
    code = 1
sys.stdout.flush()
os._exit(code)
