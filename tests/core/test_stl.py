# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files: both kinds read and written, and every broken one refused in one line."""

import os
import struct
from io import BytesIO

import numpy as np
import pytest
from mesh_shapes import box, sphere

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError, MeshError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, join_loose, read_stl, stl, write_stl


def binary(corners, header=b"", count=None):
    """A binary STL, record by record."""
    data = header.ljust(80, b"\0") + struct.pack("<I", len(corners) if count is None else count)
    for facet in corners:
        data += struct.pack("<12fH", 0.0, 0.0, 0.0, *np.asarray(facet, np.float32).ravel().tolist(), 0)
    return data


def ascii_lines(corners, name="part"):
    lines = [f"solid {name}"]
    for facet in np.asarray(corners, float).tolist():
        lines += [
            "facet normal 0 0 0",
            "outer loop",
            *(f"vertex {x!r} {y!r} {z!r}" for x, y, z in facet),
            "endloop",
            "endfacet",
        ]
    return [*lines, f"endsolid {name}"]


@pytest.fixture
def read(tmp_path):
    def reader(data):
        path = tmp_path / "part.stl"
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return read_stl(path)

    return reader


def same_triangles(mesh, corners):
    np.testing.assert_array_equal(mesh.vertex[mesh.face], np.asarray(corners, float))


def test_a_binary_file_is_read_to_the_bit(read):
    corners = sphere(centre=(7.0, 0.1, -3.0)).astype(np.float32)
    same_triangles(read(binary(corners)), corners)


def test_a_binary_header_may_begin_with_solid(read):
    same_triangles(read(binary(box(), b"solid made by somebody")), box())
    same_triangles(read(binary(box(), b"solid facet normal 0 0 1 outer loop".ljust(80))), box())


def test_an_ascii_file_is_read_to_the_last_digit(read):
    corners = sphere(rows=6, columns=8) + 0.1
    same_triangles(read("\n".join(ascii_lines(corners))), corners)


@pytest.mark.parametrize(
    "changed",
    [
        lambda text: text.upper(),
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace("\n", "\r"),
        lambda text: text.replace("\n", "\n\n\t  "),
        lambda text: "  \n" + text + "\n\n",
        lambda text: "\ufeff" + text,
        lambda text: text.replace("1.0", "+1.0E+00").replace("0.0", "-0.0e-3"),
        lambda text: text.replace("solid part", "solid"),
        lambda text: text.replace("solid part", "solid a solid part of facet normal 1 é"),
        lambda text: text + "\n" + text.replace("1.0", "1").replace("solid part", "solid other"),
        lambda text: text[: text.index("endsolid")],
        lambda text: text.replace("\nendsolid", " endsolid").replace("endfacet\nfacet", "endfacet facet"),
    ],
)
def test_ascii_is_read_in_any_dress(read, changed):
    text = changed("\n".join(ascii_lines(box())))
    mesh = read(text)
    assert len(mesh.vertex) == 8
    same_triangles(mesh, np.concatenate([box()] * (len(mesh.face) // 12)))


def test_ascii_longer_than_one_piece_is_read_whole(read, monkeypatch):
    monkeypatch.setattr("freecad_fiveaxis.core.geometry.mesh.stl._PIECE", 1000)
    corners = sphere()
    same_triangles(read("\n".join(ascii_lines(corners))), corners)


@pytest.mark.parametrize("ascii", [False, True])
def test_what_is_written_is_read_back(tmp_path, ascii):
    mesh = from_triangles(sphere(centre=(123.456, -0.001, 9.0)).astype(np.float32))
    write_stl(mesh, tmp_path / "out.stl", ascii=ascii)
    again = read_stl(tmp_path / "out.stl")
    same_triangles(again, mesh.vertex[mesh.face])
    assert len(again.vertex) == len(mesh.vertex)
    assert os.listdir(tmp_path) == ["out.stl"]


def test_the_normals_written_are_those_of_the_facets(tmp_path):
    mesh = from_triangles(box())
    write_stl(mesh, tmp_path / "out.stl")
    data = (tmp_path / "out.stl").read_bytes()
    assert len(data) == 84 + 50 * 12
    assert not data.startswith(b"solid")
    normals = [struct.unpack_from("<3f", data, 84 + 50 * i) for i in range(12)]
    np.testing.assert_array_equal(normals, mesh.normal)


def test_a_missing_file_is_a_file_error(tmp_path):
    with pytest.raises(FileError, match=r"nowhere\.stl"):
        read_stl(tmp_path / "nowhere.stl")
    with pytest.raises(FileError):
        read_stl(tmp_path)


def test_a_folder_that_cannot_be_written_is_a_file_error_and_leaves_nothing(tmp_path):
    mesh = from_triangles(box())
    with pytest.raises(FileError, match="cannot be written"):
        write_stl(mesh, tmp_path / "no folder" / "out.stl")
    (tmp_path / "taken.stl").mkdir()
    with pytest.raises(FileError, match="is a folder"):
        write_stl(mesh, tmp_path / "taken.stl")
    assert os.listdir(tmp_path) == ["taken.stl"]


def solid_text(*changes):
    text = "\n".join(ascii_lines(box()))
    for old, new in changes:
        text = text.replace(old, new, 1)
    return text


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "empty"),
        (b" \n\t ", "empty"),
        (b" \n" * 500, "empty"),
        (b"solid", "no facets"),
        (b"solid nothing\nendsolid nothing\n", "no facets"),
        (binary([]), "no facets"),
        (binary(box())[:-1], "announces 12 facets, but the file holds 11.98"),
        (binary(box())[:400], "announces 12 facets, but the file holds 6.32"),
        (binary(box()) + b"\0\0", "announces 12 facets, but the file holds 12.04"),
        (binary(box(), count=11), "announces 11 facets, but the file holds 12"),
        (binary(box(), count=2**32 - 1), "announces 4294967295 facets"),
        (binary(box(), b"solid, and a lie", count=500), "announces 500 facets"),
        (binary(box())[:60], "no STL"),
        (b"This is a letter, not a part. " * 20, "no STL"),
        (b"%PDF-1.4 " * 20, "no STL"),
        (b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "no STL"),
        (b"solid ground under our feet\nand another line, no facet\n", "facet 1 is malformed: 'and' stands where 'facet'"),
        (solid_text(("outer loop", "outer lop")), "facet 1 is malformed: 'lop' stands where 'loop'"),
        (solid_text(("vertex 0.0", "vertex zero")), "'zero' stands where a number"),
        (solid_text(("vertex 0.0", "vertex 0.0.0")), "'0.0.0' stands where a number"),
        (solid_text(("vertex 0.0 ", "vertex ")), "malformed"),
        (solid_text(("endloop\n", "")), "'endfacet' stands where 'endloop'"),
        (solid_text()[:-300], "malformed|cut off"),
        (solid_text()[:300], "malformed|cut off"),
        (solid_text(("vertex 0.0", "vertex nan")), "finite"),
        (solid_text(("vertex 0.0", "vertex -inf")), "finite"),
        (solid_text(("vertex 0.0", "vertex 1e9")), "check the units"),
        (solid_text(("vertex 0.0", "vertex 1e999")), "finite"),
        (binary(1e9 * box()), "check the units"),
        (binary([[[np.nan] * 3] * 3]), "finite"),
        (binary(np.ones((3, 3, 3))), "has an area"),
    ],
)  # fmt: skip
def test_a_broken_file_is_refused_in_one_line_that_names_it(read, data, message):
    with pytest.raises(MeshError, match=message) as caught:
        read(data)
    text = str(caught.value)
    assert text.startswith("part.stl: ")
    assert "\n" not in text
    assert len(text) < 200


def test_the_facet_number_counts_through_all_pieces(read, monkeypatch):
    monkeypatch.setattr("freecad_fiveaxis.core.geometry.mesh.stl._PIECE", 500)
    lines = ascii_lines(box())
    lines[1 + 7 * 9 + 2] = "vertex 1 2 three"
    with pytest.raises(MeshError, match="facet 10 is malformed: 'three'"):
        read("\n".join(lines))


def test_progress_is_reported_and_may_stop_the_reading(tmp_path):
    write_stl(from_triangles(box()), tmp_path / "part.stl", ascii=True)
    heard = []
    read_stl(tmp_path / "part.stl", lambda stage, fraction: heard.append(fraction))
    assert heard == sorted(heard)
    assert heard[-1] == 1.0

    def stop(stage, fraction):
        raise FiveAxisError("stopped")

    with pytest.raises(FiveAxisError, match="stopped"):
        read_stl(tmp_path / "part.stl", stop)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="named pipes are a POSIX thing")
def test_a_pipe_is_refused_at_once(tmp_path):
    pipe = tmp_path / "pipe.stl"
    os.mkfifo(pipe)  # nobody writes: to open it would wait for ever
    with pytest.raises(FileError, match="no ordinary file"):
        read_stl(pipe)


def test_a_file_that_shrinks_while_it_is_read_is_an_error():
    whole = binary(box())
    facets = len(box())
    assert stl._binary_columns(BytesIO(whole[84:]), facets).shape == (3, 3, facets)
    with pytest.raises(MeshError, match="shorter"):
        stl._binary_columns(BytesIO(whole[84:-1]), facets)


# --------------------------------------------------------------------------------- facets that are not welded


def sheet(columns, rows, turn=0.0):
    """Corners (f, 3, 3) of a level sheet of unit squares, tilted by ``turn`` rad about X."""
    i, j = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    square = np.stack([i, j, 0 * i], axis=-1).reshape(-1, 1, 3) + np.array(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    )
    corners = np.concatenate([square[:, [0, 1, 2]], square[:, [0, 2, 3]]]).astype(float)
    return corners @ np.array([[1, 0, 0], [0, np.cos(turn), np.sin(turn)], [0, -np.sin(turn), np.cos(turn)]])


def value(mesh, code):
    return sum(finding.value for finding in mesh.findings if finding.code == code)


@pytest.mark.parametrize("turn", [0.0, 0.6])
def test_corners_a_rounding_apart_are_joined_and_counted(read, turn):
    loose = sheet(4, 3, turn) + np.random.default_rng(3).uniform(-1e-6, 1e-6, (24, 3, 3))
    mesh = read("\n".join(ascii_lines(loose)).encode())
    assert (
        len(mesh.vertex) == 20
        and value(mesh, "open-shell") == 14
        and value(mesh, "corners-joined") == 72 - 20
    )
    assert mesh.area.sum() == pytest.approx(12.0, rel=1e-4)


def test_corners_farther_apart_stay_and_are_named(read):
    loose = sheet(4, 3) + np.random.default_rng(3).uniform(-1e-2, 1e-2, (24, 3, 3))
    mesh = read("\n".join(ascii_lines(loose)).encode())
    assert len(mesh.vertex) == 72 and value(mesh, "open-shell") == 72


@pytest.mark.parametrize(
    ("side", "apart"), [(1.0, 2e-4), (0.1, 8e-6), (0.1, 2e-4), (40.0, 2e-4), (2000.0, 1e-4)]
)
def test_corners_that_a_writer_rounded_are_joined_however_small_the_facets(read, side, apart):
    """8e-6 mm is what 32 bits keep of 100 mm: a hundredth of a percent of a facet's side of 0.1 mm."""
    loose = side * sheet(4, 3) + np.random.default_rng(3).uniform(-apart, apart, (24, 3, 3))
    mesh = read("\n".join(ascii_lines(loose)).encode())
    assert len(mesh.vertex) == 20 and value(mesh, "open-shell") == 14, "as if they had been equal"


@pytest.mark.parametrize(("side", "apart"), [(40.0, 0.003), (0.1, 0.0013)])
def test_a_gap_that_is_no_rounding_stays_open(read, side, apart):
    one = side * sheet(3, 3)
    mesh = read("\n".join(ascii_lines(np.concatenate([one, one + [0.0, 3.0 * side + apart, 0.0]]))).encode())
    assert not value(mesh, "corners-joined") and value(mesh, "open-shell") == 24


def test_of_a_mesh_that_hangs_together_nowhere_it_is_stated_how_to_repair_it(read):
    loose = sheet(4, 3) + 0.1 * np.random.default_rng(3).uniform(-1.0, 1.0, (24, 3, 3))
    torn = [one for one in read("\n".join(ascii_lines(loose)).encode()).findings if one.code == "open-shell"]
    assert len(torn) == 1 and "hang together nearly nowhere" in torn[0].text and torn[0].value == 72
    whole = [
        one for one in read("\n".join(ascii_lines(sheet(4, 3))).encode()).findings if one.code == "open-shell"
    ]
    assert "Close the shell" in whole[0].text and whole[0].value == 14


@pytest.mark.parametrize("turn", [0.0, 0.6])
def test_facets_are_divided_at_t_junctions(read, turn):
    fine = sheet(8, 2, turn) * 0.5
    coarse = sheet(4, 1, turn) - [0.0, np.cos(turn), np.sin(turn)]
    mesh = read("\n".join(ascii_lines(np.concatenate([fine, coarse]))).encode())
    assert value(mesh, "t-junctions-joined") == 4 and value(mesh, "open-shell") == 8 + 2 * 2 + 4 + 2
    assert len(mesh.face) == 32 + 8 + 4 and mesh.area.sum() == pytest.approx(8.0)


def test_a_facet_with_t_junctions_on_all_its_sides_is_divided_at_each(read):
    outer = np.array([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]])
    beside = [[[2, 0, 0], [0, 0, 0], [1, -1, 0]], [[4, 0, 0], [2, 0, 0], [3, -1, 0]], [[2, 2, 0], [4, 0, 0], [4, 2, 0]],
              [[0, 4, 0], [2, 2, 0], [2, 4, 0]], [[0, 2, 0], [0, 4, 0], [-1, 3, 0]], [[0, 0, 0], [0, 2, 0], [-1, 1, 0]]]  # fmt: skip
    mesh = read("\n".join(ascii_lines(np.concatenate([[outer], beside]))).encode())
    assert (
        value(mesh, "t-junctions-joined") == 3 and len(mesh.face) == 4 + 6 and value(mesh, "open-shell") == 12
    )


def test_of_doubled_facets_one_is_kept(read):
    once = sheet(3, 3)
    mesh = read("\n".join(ascii_lines(np.concatenate([once, np.roll(once[4:6], 1, axis=1)]))).encode())
    assert len(mesh.face) == 18 and value(mesh, "doubled-facets") == 2 and value(mesh, "open-shell") == 12
    assert not value(mesh, "non-manifold-edges")


@pytest.mark.parametrize("back", [slice(None), slice(None, None, -1)])
def test_the_two_sides_of_a_thin_wall_stay_apart(read, back):
    one = sheet(3, 3)
    mesh = read("\n".join(ascii_lines(np.concatenate([one, one[:, back] + [0.0, 0.0, 1e-6]]))).encode())
    assert len(mesh.vertex) == 32 and not value(mesh, "corners-joined") and value(mesh, "open-shell") == 24


def test_a_third_facet_at_an_edge_is_not_joined_with_it(read):
    fin = np.array([[[1.0, 1.0 + 1e-7, 0.0], [2.0, 1.0 + 1e-7, 0.0], [1.5, 1.0, 1.0]]])
    mesh = read("\n".join(ascii_lines(np.concatenate([sheet(3, 2), fin]))).encode())
    assert not value(mesh, "corners-joined") and not value(mesh, "non-manifold-edges")


@pytest.mark.parametrize("wrong", [[3], [0, 5, 7], [1, 2, 3, 4, 8, 9, 10, 11]])
def test_facets_that_face_the_other_way_are_turned(read, wrong):
    corners = box()
    corners[wrong] = corners[wrong, ::-1]
    mesh, whole = read("\n".join(ascii_lines(corners)).encode()), from_triangles(box())
    turned = min(len(wrong), 12 - len(wrong))  # where most were wrong the rest is turned, and then all
    assert value(mesh, "facets-turned") == turned and not value(mesh, "inconsistent-winding")
    assert not value(mesh, "open-shell") and (mesh.coedge_face >= 0).all()
    inward = (mesh.normal * (mesh.vertex[mesh.face].mean(axis=1) - whole.vertex.mean(axis=0))).sum(axis=1)
    assert (inward > 0.0).all() and len(mesh.face) == 12


def test_of_an_open_sheet_the_smaller_part_is_turned(read):
    corners = sheet(4, 3)
    corners[:5] = corners[:5, ::-1]
    mesh = read("\n".join(ascii_lines(corners)).encode())
    assert value(mesh, "facets-turned") == 5 and (mesh.normal[:, 2] > 0.999).all()


def test_a_strip_with_one_side_only_stays_as_it_is(read):
    t = np.linspace(0.0, 2.0 * np.pi, 13)
    out, up = np.stack([np.cos(t), np.sin(t), 0.0 * t], axis=1), np.array([0.0, 0.0, 1.0])
    way = 0.3 * (np.cos(t / 2.0)[:, None] * out + np.sin(t / 2.0)[:, None] * up)
    a, b = 2.0 * out + way, 2.0 * out - way
    a[-1], b[-1] = b[0], a[0]
    strip = np.concatenate(
        [np.stack([a[:-1], b[:-1], b[1:]], axis=1), np.stack([a[:-1], b[1:], a[1:]], axis=1)]
    )
    mesh = read("\n".join(ascii_lines(strip)).encode())
    assert not value(mesh, "facets-turned") and value(mesh, "inconsistent-winding") == 1


def test_a_clean_mesh_is_the_very_same_object():
    for mesh in (from_triangles(sheet(4, 3)), from_triangles(box())):
        assert join_loose(mesh) is mesh
    loose = from_triangles(sheet(4, 3) + np.random.default_rng(3).uniform(-1e-6, 1e-6, (24, 3, 3)))
    assert join_loose(loose) is not loose
