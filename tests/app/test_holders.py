# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that hold solids, meshes, fixtures and paths: what they move is not cut where it stood before."""

import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import convert, rest, results, wording
from freecad_fiveaxis.core.base.errors import FiveAxisError

pytestmark = pytest.mark.usefixtures("kept")
OPTIONS = {**FAST, **UNCURED, "stepover": 8}


@pytest.fixture
def holder(doc):
    """A part that stands aside."""
    part = doc.addObject("App::Part", "Holder")
    part.Placement.Base.x = 30
    return part


@pytest.fixture
def held(doc, ball, holder):
    """A toolpath over the ball in the part."""
    holder.addObject(ball)
    doc.recompute()
    return app.create_toolpath(doc, ball, **OPTIONS)


def low(mesh):
    """The least x of what is cut, mm in the document."""
    return convert.mesh_of(convert.stl_bytes(mesh), lambda *_: None).vertex[:, 0].min()


def move(part, x):
    """Let a part stand there, mm."""
    place = part.Placement
    place.Base.x = x
    part.Placement = place


def test_a_part_that_is_moved_with_its_solid_puts_the_path_out_of_date(held, holder):
    before, x = results.nc_of(held), low(held.Mesh)
    assert results.out_of_date(held) == ""
    move(holder, 50)
    assert results.out_of_date(held) == "Ball was moved by the part that holds it: recompute the document"
    held.Document.recompute()
    assert results.out_of_date(held) == "" and low(held.Mesh) == pytest.approx(x + 20, abs=1e-3)
    assert results.nc_of(held) != before


def test_a_reopened_path_over_a_held_solid_is_up_to_date(held, reopen):
    path = reopen(held.Document).Toolpath
    assert results.out_of_date(path) == "" and not path.Mesh.MustExecute


def test_a_mesh_that_is_put_into_a_part_is_cut_where_its_solid_stands(held, holder):
    x, (mesh, doc) = low(held.Mesh), (held.Mesh, held.Document)
    holder.addObject(mesh)
    assert results.out_of_date(held)
    doc.recompute()
    assert low(mesh) == pytest.approx(x, abs=1e-3) and results.out_of_date(held) == ""


def test_of_an_earlier_version_it_is_not_known(held, holder):
    held.Mesh.HolderPlaces = []
    move(holder, 50)
    assert not held.Mesh.MustExecute


def test_what_is_posted_is_of_the_part_as_it_stands(doc, ball, holder, tmp_path):
    path = app.create_toolpath(doc, ball, **OPTIONS)
    before = results.nc_of(path)
    move(ball, 10)
    app.post_process(path, tmp_path / "moved.ngc")
    moved = (tmp_path / "moved.ngc").read_bytes()
    assert moved != before
    move(ball, 0)
    holder.addObject(ball)
    move(holder, 10)
    app.post_process(path, tmp_path / "held.ngc")
    assert (tmp_path / "held.ngc").read_bytes() == moved
    assert results.out_of_date(path) == "", "what is shown is of that place, too"


def test_machines_are_not_compared_on_a_part_that_has_moved_since(held, holder, ball):
    move(holder, 40)
    with pytest.raises(FiveAxisError, match="Ball was moved by the part that holds it"):
        app.compare(held, ["trunnion_bc"], ["none"])
    move(ball, 1)
    with pytest.raises(FiveAxisError, match="Ball was changed: recompute the document"):
        app.compare(held, ["trunnion_bc"], ["none"])


def test_settings_that_change_take_the_part_as_it_stands(doc, ball, holder):
    path = app.create_toolpath(doc, ball, **OPTIONS)
    x = low(path.Mesh)
    move(ball, 10)
    app.changes.change_toolpath(path, {**OPTIONS, "stepover": 9})
    assert low(path.Mesh) == pytest.approx(x + 10, abs=1e-3) and results.out_of_date(path) == ""


def test_a_map_of_what_is_left_says_that_it_is_old_in_the_users_language(doc, ball, monkeypatch):
    found = app.left_map(app.create_toolpath(doc, ball, **OPTIONS))
    found.UpToDate = False
    monkeypatch.setattr(wording, "localize", lambda text: f"localized: {text}")
    assert rest.out_of_date(found) == f"localized: {found.Label} is old: recompute the document"
