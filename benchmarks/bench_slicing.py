# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel planes through a mesh into ordered polylines: this project, VTK and meshlib in one run.

Ours gives every segment its entry and exit with normal, facet, co-edge, polyline and pass; VTK's contour
filter and stripper give points and polylines, once as they come and once with the scalar tree that a user may
switch on; meshlib gives the polylines plane by plane. Building the peers' own meshes and trees is not
counted. Peers are optional: ``pip install vtk meshlib``.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import SIDE, bumpy
from benchmarks.timing import median_seconds, print_table
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes import slice_mesh

ANGLE = 0.3  # rad; planes along x or y would lie on grid lines of the part
GROWING = (20_000, 60_000, 200_000, 600_000, 2_000_000)  # facets


def planes(number: int) -> Floats:
    """Offsets of ``number`` planes over the part's width."""
    return np.linspace(-0.499 * SIDE, 0.4987 * SIDE, number)


def vtk_slicer(mesh: Mesh, offsets: Floats, tree: bool) -> Callable[[], int]:
    """VTK's contour filter and stripper; returns the number of polylines."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(mesh.vertex), deep=1))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(mesh.face).reshape(-1), deep=1))
    data.SetPoints(points)
    data.SetPolys(cells)
    across = np.cos(ANGLE) * mesh.vertex[:, 1] - np.sin(ANGLE) * mesh.vertex[:, 0]
    data.GetPointData().SetScalars(numpy_to_vtk(across, deep=1))

    def run() -> int:
        contour, strip = vtk.vtkContourFilter(), vtk.vtkStripper()
        contour.SetInputData(data)
        contour.ComputeNormalsOff()
        contour.ComputeScalarsOff()
        contour.SetUseScalarTree(tree)
        for i, offset in enumerate(offsets):
            contour.SetValue(i, offset)
        strip.SetInputConnection(contour.GetOutputPort())
        strip.SetMaximumLength(10_000_000)
        strip.Update()
        return int(strip.GetOutput().GetNumberOfLines())

    return run


def meshlib_slicer(mesh: Mesh, offsets: Floats) -> Callable[[], int]:
    """meshlib's plane sections; returns the number of polylines."""
    from meshlib import mrmeshnumpy, mrmeshpy

    other = mrmeshnumpy.meshFromFacesVerts(
        np.ascontiguousarray(mesh.face, dtype=np.int32), np.ascontiguousarray(mesh.vertex)
    )
    other.getAABBTree()
    part, across = mrmeshpy.MeshPart(other), mrmeshpy.Vector3f(-np.sin(ANGLE), np.cos(ANGLE), 0.0)
    return lambda: sum(
        len(mrmeshpy.extractPlaneSections(part, mrmeshpy.Plane3f(across, float(o)))) for o in offsets
    )


def compare(facets: int, number: int) -> None:
    """Ours and the peers on the same mesh and planes."""
    mesh, offsets = bumpy(facets), planes(number)
    path = slice_mesh(mesh, offsets, ANGLE)
    own = median_seconds(lambda: slice_mesh(mesh, offsets, ANGLE), 7)
    rows = [["this project", f"{int(path.polyline[-1]) + 1}", f"{1e3 * own:.1f}", "1.0"]]
    makers: dict[str, Callable[[], Callable[[], int]]] = {
        "VTK contour + stripper": lambda: vtk_slicer(mesh, offsets, tree=False),
        "VTK with scalar tree": lambda: vtk_slicer(mesh, offsets, tree=True),
        "meshlib plane sections": lambda: meshlib_slicer(mesh, offsets),
    }
    for name, make in makers.items():
        try:
            run = make()
        except ImportError:
            print(f"{name}: not installed, left out")
            continue
        taken = median_seconds(run, 3)
        rows.append([name, f"{run()}", f"{1e3 * taken:.1f}", f"{taken / own:.1f}"])
    print_table(
        f"{facets:,} facets x {number} planes, {len(path.face) // 2:,} segments",
        ("by", "polylines", "ms", "times ours"),
        rows,
    )


def grow() -> None:
    """Cost a segment as parts grow, planes in proportion to the rows of facets."""
    rows = []
    for facets in GROWING:
        mesh, offsets = bumpy(facets), planes(round(0.5 * np.sqrt(facets)))
        segments = len(slice_mesh(mesh, offsets, ANGLE).face) // 2
        taken = median_seconds(lambda mesh=mesh, offsets=offsets: slice_mesh(mesh, offsets, ANGLE), 3)
        rows.append(
            [
                f"{facets:,}",
                len(offsets),
                f"{segments:,}",
                f"{1e3 * taken:.1f}",
                f"{1e9 * taken / segments:.0f}",
            ]
        )
    print_table("slicing, this project", ("facets", "planes", "segments", "ms", "ns a segment"), rows)


if __name__ == "__main__":
    keep_freed_memory()  # as on the command line; the peers in this process have the same
    compare(200_000, 200)
    compare(1_000_000, 500)
    grow()
