# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents and small parts for the tests that run inside FreeCAD, without a window."""

import sys
from pathlib import Path

import pytest

FreeCAD = pytest.importorskip("FreeCAD")
import Mesh  # noqa: E402
import Part  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "resources" / "examples"))

PLAIN = {"passes": "planes", "tool_axis": "facet_mean"}
"""Passes and tool axes of tests that look at something else: quick, and known in closed form."""
FAST = {"machine": "trunnion_ac", "stepover": 4, "linear_deflection": 0.1, **PLAIN}
"""Settings under which a small part takes a fraction of a second."""
UNCURED = {"linearize": "off", "gouge": "off"}
"""What tests ask for that look at deviations, blocks and entries as the path has them before any cure."""


@pytest.fixture
def doc():
    """An empty document, closed afterwards."""
    result = FreeCAD.newDocument("FiveAxisTest")
    name = result.Name  # a closed document has none
    yield result
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.fixture
def reopen(tmp_path):
    """A function that saves a document, closes it, and gives the one read from the file."""
    opened = []

    def act(document):
        path = str(tmp_path / "saved.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        again = FreeCAD.openDocument(path)
        opened.append(again.Name)
        return again

    yield act
    for name in set(opened) & set(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


def half_ball(radius=20.0):
    """A half ball that stands on z = 0, a solid."""
    box = Part.makeBox(2 * radius, 2 * radius, radius, FreeCAD.Vector(-radius, -radius, 0))
    return Part.makeSphere(radius).common(box).Solids[0]


@pytest.fixture
def ball(doc):
    """A half ball of 20 mm as a Part feature."""
    obj = doc.addObject("Part::Feature", "Ball")
    obj.Shape = half_ball()
    doc.recompute()
    return obj


@pytest.fixture
def dome(doc):
    """The example dome, whose top passes the pole of trunnion_ac, as a Mesh feature."""
    import make_parts

    obj = doc.addObject("Mesh::Feature", "Dome")
    obj.Mesh = as_mesh(*make_parts.dome(rings=20, sectors=60))
    doc.recompute()
    return obj


def as_mesh(vertex, face):
    """A FreeCAD mesh of vertices (v, 3) mm and facets (f, 3)."""
    return Mesh.Mesh(vertex[face].reshape(-1, 3).tolist())
