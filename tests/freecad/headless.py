# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside freecadcmd: the add-on is on the path, and the core mills a part with FreeCAD's own numpy and scipy."""

import os
import sys
import tempfile

sys.stdout = os.fdopen(os.dup(1), "w", buffering=1)
sys.path.insert(0, os.path.join(os.environ["FIVEAXIS_ROOT"], "tests", "freecad"))
import checks  # noqa: E402


def the_addon_is_found_by_freecad():
    import freecad_fiveaxis

    assert os.path.realpath(os.path.dirname(os.path.dirname(freecad_fiveaxis.__file__))) == os.environ["FIVEAXIS_ROOT"]


def loading_the_addon_imported_no_numpy_of_ours():
    assert not [name for name in sys.modules if name.startswith("freecad_fiveaxis.core")]


def the_core_mills_a_solid_that_freecad_made():
    import MeshPart
    import Part

    from freecad_fiveaxis.core.cli import main

    solid = Part.makeSphere(20).common(Part.makeBox(40, 40, 20, _vector(-20, -20, 0)))
    mesh = MeshPart.meshFromShape(Shape=solid, LinearDeflection=0.05, AngularDeflection=0.2, Relative=False)
    with tempfile.TemporaryDirectory() as folder:
        stl, nc = os.path.join(folder, "dome.stl"), os.path.join(folder, "dome.ngc")
        mesh.write(stl)
        code = main(["mill", stl, "--machine", "trunnion_ac", "--stepover", "4", "--tolerance", "50", "--quiet", "-o", nc])
        assert code == 0, code
        assert os.path.getsize(nc) > 1000


def _vector(*xyz):
    import FreeCAD

    return FreeCAD.Vector(*xyz)


checks.run_and_exit(
    [the_addon_is_found_by_freecad, loading_the_addon_imported_no_numpy_of_ours, the_core_mills_a_solid_that_freecad_made]
)
