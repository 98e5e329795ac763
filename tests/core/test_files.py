# SPDX-License-Identifier: LGPL-2.1-or-later
import os

import pytest

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.files import check_readable, check_writable, is_name, read_bytes, write_whole


def test_a_file_is_written_whole_and_nothing_stays_beside_it(tmp_path):
    target = tmp_path / "part.ngc"
    target.write_bytes(b"old")
    write_whole(target, b"new")
    assert target.read_bytes() == b"new"
    assert os.listdir(tmp_path) == ["part.ngc"]


@pytest.mark.skipif(os.name != "posix", reason="modes of POSIX")
def test_a_new_file_may_be_read_by_others_as_the_umask_says(tmp_path):
    old = os.umask(0o022)
    try:
        write_whole(tmp_path / "a", b"")
    finally:
        os.umask(old)
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o644


def test_a_failed_write_leaves_the_old_file_and_nothing_else(tmp_path):
    target = tmp_path / "taken"
    target.mkdir()
    (target / "child").write_bytes(b"")
    with pytest.raises(FileError, match="is a folder"):
        write_whole(target, b"new")
    assert os.listdir(tmp_path) == ["taken"]


@pytest.mark.parametrize("name", ["missing/part.ngc", "file/part.ngc", "folder"])
def test_an_impossible_target_is_refused_before_the_work(tmp_path, name):
    (tmp_path / "file").write_bytes(b"")
    (tmp_path / "folder").mkdir()
    with pytest.raises(FileError) as error:
        check_writable(tmp_path / name)
    assert name.split("/")[0] in str(error.value)


def test_a_dash_is_no_file_but_may_be_named_in_its_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileError, match="standard output"):
        check_writable("-")
    check_writable("./-")


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(FileError, match=r"STL file .*gone\.stl cannot be read: No such file"):
        read_bytes(tmp_path / "gone.stl", "STL file")


@pytest.mark.parametrize("name", ["a\0b", "a\ud800b"])
def test_a_name_that_no_file_can_have_is_an_error_of_ours(tmp_path, name):
    assert not is_name(name)
    path = os.path.join(tmp_path, name)
    for act in (
        check_readable,
        check_writable,
        lambda one: read_bytes(one, "file"),
        lambda one: write_whole(one, b""),
    ):
        with pytest.raises(FileError, match="cannot be the name of a file"):
            act(path)
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("name", [b"bad\xff", "Stück".encode()])
def test_a_name_of_any_other_bytes_is_written_and_read(tmp_path, name):
    path = os.fsdecode(os.path.join(os.fsencode(tmp_path), name))
    assert is_name(path)
    try:
        write_whole(path, b"new")
    except FileError:
        pytest.skip("this file system takes Unicode names only")
    check_readable(path)
    assert read_bytes(path, "file") == b"new"


def test_what_is_no_file_to_read_is_named_for_what_it_is(tmp_path):
    for path, message in (
        (tmp_path, "is a folder"),
        (tmp_path / "gone", "does not exist"),
        (os.devnull, "no ordinary file"),
    ):
        with pytest.raises(FileError, match=message):
            check_readable(path)
