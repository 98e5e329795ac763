# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files in and out, binary and ASCII.

binary  80 bytes of header, a 32-bit count of facets, then 50 bytes a facet: normal and three corners as
        32-bit floats, and a 16-bit attribute. The header may well begin with "solid"; the count tells the two
        kinds apart.
ASCII   ``solid``, then ``facet normal x y z / outer loop / vertex x y z (three times) / endloop / endfacet``,
        ``endsolid``.

The normals of a file are not used: those of a mesh follow from its vertices. (Source: the StereoLithography
Interface Specification, 3D Systems, 1989, as described in M. Burns, Automated Fabrication, 1993, section
6.5.)
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from io import BufferedReader, BytesIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.errors import FileError, MeshError
from freecad_fiveaxis.core.base.files import open_file, write_whole
from freecad_fiveaxis.core.base.memory import check_memory
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Number, say

from .triangles import Mesh, from_columns, join_loose

HEADER = 84  # bytes: header text and count
BOM = b"\xef\xbb\xbf"  # with which editors of Windows begin a text
RECORD = np.dtype([("normal", "<f4", (3,)), ("corner", "<f4", (3, 3)), ("attribute", "<u2")])

_BYTES = 190
"""Of memory for each facet at least, from its record to the welded mesh: measured, 195 at two million
facets."""

_ASCII_BYTES = 400
"""Of an ASCII file for each facet, at most: with all digits of its twelve numbers, and indented."""

_PIECE = 1 << 22  # bytes of ASCII read at a time; its words take about ten times that
_ROWS = 4096  # facets read or written at a time
_CONTROL = re.compile(rb"[\0-\x08\x0e-\x1f\x7f-\xff]")  # bytes that no text holds
_SOLID = re.compile(rb"\b(?:end[ \t]*)?solid\b[^\r\n]*")
_WORDS = {0: b"facet", 1: b"normal", 5: b"outer", 6: b"loop", 19: b"endloop", 20: b"endfacet"}
_WORDS |= dict.fromkeys((7, 11, 15), b"vertex")
_PER_FACET = 21  # words
_CORNER_WORDS = (8, 9, 10, 12, 13, 14, 16, 17, 18)
_ASCII_VERTEX = "  vertex %r %r %r\n"  # the shortest digits that give back the number
_ASCII_FACET = "facet normal %.6f %.6f %.6f\n outer loop\n" + 3 * _ASCII_VERTEX + " endloop\nendfacet\n"


def read_stl(path: str | os.PathLike[str], progress: Progress = silent, unit: float = 1.0) -> Mesh:
    """Read a binary or ASCII STL file, whose coordinates count ``unit`` mm each, into a welded mesh, mm;
    facets that ought to hang together are joined where that is safe.

    Raises FileError where the file cannot be read, MeshError where it is empty, cut off, no STL, or holds no
    usable facet (see :func:`~freecad_fiveaxis.core.geometry.mesh.from_triangles`).
    """
    progress("read STL", 0.0)
    try:
        columns = _columns(path, progress)
        mesh = join_loose(from_columns(columns if unit == 1.0 else columns * np.float64(unit)))
    except MeshError as problem:
        raise MeshError(
            say("{name}: {problem}", name=Path(path).name, problem=problem), problem.value
        ) from problem
    progress("weld", 1.0)
    return mesh


def read_corners(path: str | os.PathLike[str], progress: Progress = silent) -> Floats:
    """Read the facets (f, 3, 3) of an STL file as they stand in it, in whatever unit: nothing is welded.
    Raises as :func:`read_stl` for a file that is no STL."""
    try:
        return np.asarray(_columns(path, progress).T, dtype=np.float64)
    except MeshError as problem:
        raise MeshError(
            say("{name}: {problem}", name=Path(path).name, problem=problem), problem.value
        ) from problem


def stl_bytes(mesh: Mesh) -> bytes:
    """Give a mesh as the content of a binary STL file, coordinates in mm as 32-bit floats."""
    return b"".join(_binary_pieces(mesh))


def write_stl(mesh: Mesh, path: str | os.PathLike[str], ascii: bool = False) -> None:
    """Write a mesh as a binary STL file, coordinates in mm as 32-bit floats, or as an ASCII one with all
    digits.

    The file is written beside its place and then renamed, so there is never half a file. Raises FileError
    where the folder cannot be written.
    """
    write_whole(path, b"".join(_ascii_pieces(mesh)) if ascii else stl_bytes(mesh))


def _columns(path: str | os.PathLike[str], progress: Progress) -> NDArray[np.float32] | Floats:
    """Corners (3, 3, f): x y z, corner, facet."""
    content = _content(path)
    columns = (
        np.ascontiguousarray(_ascii_corners(content, progress).T) if isinstance(content, bytes) else content
    )
    progress("weld", 0.5)
    return columns


def _content(path: str | os.PathLike[str]) -> NDArray[np.float32] | bytes:
    """Return the corner columns of a binary file, or the text of an ASCII one."""
    try:
        with open_file(path) as stream:
            facets = int.from_bytes(stream.read(HEADER)[80:], "little")
            size = stream.seek(0, os.SEEK_END)
            if size == HEADER + RECORD.itemsize * facets:
                _check_room(facets)
                stream.seek(HEADER)
                return _binary_columns(stream, facets)
            stream.seek(0)
            _check_room(size // _ASCII_BYTES)
            data = stream.read().removeprefix(BOM)
    except FileError:
        raise
    except OSError as problem:
        raise FileError(
            say(
                "STL file {path} cannot be read: {strerror}; check its name, its folder and your "
                "right to read it",
                path=os.fspath(path),
                strerror=problem.strerror or problem,
            ),
            path,
        ) from problem
    _check_text(data, facets, len(data))
    return data


def check_stl_beginning(start: bytes, size: int) -> None:
    """Check that a file of ``size`` bytes, of which these are the first, may be an STL file; its facets are
    not looked at. Raises MeshError."""
    facets = int.from_bytes(start[80:HEADER], "little")
    if size != HEADER + RECORD.itemsize * facets:
        _check_text(start.removeprefix(BOM), facets, size)


def _check_room(facets: int) -> None:
    """Raise SettingsError, before any work, where so many facets cannot be held."""
    what = say("{count} facets", count=facets)
    check_memory(_BYTES * facets, what, say("export the part with a coarser tolerance, or free memory"))


def _check_text(data: bytes, facets: int, size: int) -> None:
    """Raise MeshError for what cannot be ASCII, by the beginning of a file of ``size`` bytes; ``facets`` is
    what it would announce as a binary file."""
    if not data[:HEADER].strip() and not data.strip():
        raise MeshError(say("the file is empty; export the part again"), size)
    if data[:HEADER].lstrip()[:5].lower() == b"solid" and b"\0" not in data:
        return
    if size < HEADER or not _CONTROL.search(data[:1024]):
        raise MeshError(
            say(
                "this is no STL file: its {size} bytes neither begin with 'solid' nor hold a binary header; "
                "export the part as STL",
                size=size,
            ),
            size,
        )
    held = (size - HEADER) / RECORD.itemsize
    raise MeshError(
        say(
            "the header announces {facets} facets, but the file holds {held}: it is cut off, damaged or no "
            "STL; export it again",
            facets=facets,
            held=Number(held),
        ),
        facets,
    )


# ------------------------------------------------------------------------------------------------ binary


def _binary_columns(stream: BufferedReader | BytesIO, facets: int) -> NDArray[np.float32]:
    """Corners (3, 3, f): x y z, corner, facet.

    Read in portions that stay in the cache. Each is first copied to aligned memory: the records are 50 bytes
    long, and numpy is slow on odd addresses.
    """
    packed = np.dtype([("normal", "V12"), ("corner", "V36"), ("attribute", "V2")])
    portion, aligned = np.empty(_ROWS, dtype=packed), np.empty(_ROWS, dtype="V36")
    corner = aligned.view("<f4").reshape(-1, 3, 3).T
    column = np.empty((3, 3, facets), dtype=np.float32)
    for first in range(0, facets, _ROWS):
        rows = min(_ROWS, facets - first)
        if stream.readinto(portion[:rows].data.cast("B")) != rows * RECORD.itemsize:
            raise MeshError(say("the file became shorter while it was read; export it again"), first)
        aligned[:rows] = portion["corner"][:rows]
        column[:, :, first : first + rows] = corner[:, :, :rows]
    return column


def _binary_pieces(mesh: Mesh) -> Iterator[bytes]:
    """Header and facets of a binary file."""
    yield b"binary STL, mm".ljust(80) + len(mesh.face).to_bytes(4, "little")
    for first in range(0, len(mesh.face), _ROWS):
        rows = slice(first, first + _ROWS)
        record = np.zeros(len(mesh.face[rows]), dtype=RECORD)
        record["normal"] = mesh.normal[rows]
        record["corner"] = mesh.vertex[mesh.face[rows]]
        yield record.tobytes()


# ------------------------------------------------------------------------------------------------ ASCII


def _ascii_corners(data: bytes, progress: Progress) -> Floats:
    """Corners (f, 3, 3) of an ASCII file, any number of solids, any case and white space."""
    text = data.lower()
    found: list[Floats] = []
    begin = facets = 0
    while begin < len(text):
        cut = text.find(b"endfacet", begin + _PIECE)
        end = len(text) if cut < 0 else cut + len(b"endfacet")
        found.append(_ascii_piece(text[begin:end], facets))
        facets += len(found[-1])
        begin = end
        progress("read STL", 0.5 * end / len(text))
    return np.concatenate(found)


def _ascii_piece(text: bytes, before: int) -> Floats:
    """Corners of a whole number of facets; ``before`` facets went before them."""
    word = (_SOLID.sub(b" ", text) if b"solid" in text else text).split()
    facets = len(word) // _PER_FACET
    if len(word) % _PER_FACET or any(word[at::_PER_FACET].count(key) != facets for at, key in _WORDS.items()):
        raise _ascii_error(word, before)
    try:
        # numpy reads numbers from bytes; one word after another would take a Python loop
        number = np.array([word[at::_PER_FACET] for at in _CORNER_WORDS], dtype=np.float64)
    except ValueError:
        raise _ascii_error(word, before) from None
    return number.T.reshape(-1, 3, 3)


def _ascii_error(word: list[bytes], before: int) -> MeshError:
    """Return what is wrong with the first word that does not fit."""
    for i, given in enumerate(word):
        facet, at = before + i // _PER_FACET + 1, i % _PER_FACET
        wanted = _WORDS.get(at)
        if given != wanted if wanted else at in _CORNER_WORDS and not _is_number(given):
            odd = given[:20].decode("ascii", "backslashreplace")
            need = f"'{wanted.decode()}'" if wanted else "a number"
            return MeshError(
                say(
                    "facet {facet} is malformed: '{odd}' stands where {need} belongs; export the file again",
                    facet=facet,
                    odd=odd,
                    need=need,
                ),
                odd,
            )
    return MeshError(
        say(
            "the file ends within facet {facet}: it is cut off; export it again",
            facet=before + len(word) // _PER_FACET + 1,
        ),
        len(word),
    )


def _is_number(word: bytes) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _ascii_pieces(mesh: Mesh) -> Iterator[bytes]:
    """Lines of an ASCII file."""
    yield b"solid part\n"
    for first in range(0, len(mesh.face), _ROWS):
        rows = slice(first, first + _ROWS)
        corner = mesh.vertex[mesh.face[rows]].reshape(-1, 9)
        number = np.concatenate([mesh.normal[rows], corner], axis=1)
        yield ((_ASCII_FACET * len(number)) % tuple(number.ravel().tolist())).encode("ascii")
    yield b"endsolid part\n"
