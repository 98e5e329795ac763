# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outputs of a job: all or none, at whatever stands at their place, and never over what the job reads."""

import os
import signal
import socket
import stat

import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import files, memory
from freecad_fiveaxis.core.base.errors import FileError, SettingsError
from freecad_fiveaxis.core.base.files import check_writable, read_bytes, write_all, write_whole
from freecad_fiveaxis.core.machine import machine_path
from freecad_fiveaxis.core.pipeline import outputs
from freecad_fiveaxis.core.pipeline.settings import build_settings

posix = pytest.mark.skipif(os.name != "posix", reason="links, modes and pipes of POSIX")


def content(folder):
    """Every file of a folder with its bytes."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@pytest.fixture
def three(tmp_path):
    """One old file, one with a second name, and one that is not there yet; with what is to be written."""
    (tmp_path / "old").write_bytes(b"was here")
    (tmp_path / "linked").write_bytes(b"a longer text than the new one")
    os.link(tmp_path / "linked", tmp_path / "second name")
    return {tmp_path / "new": b"1", tmp_path / "old": b"2", tmp_path / "linked": b"3"}


def test_all_files_are_written_and_named(three, tmp_path):
    files.written.clear()
    write_all(three)
    assert content(tmp_path) == {"new": b"1", "old": b"2", "linked": b"3", "second name": b"3"}
    assert files.written == [str(path) for path in three]


@pytest.mark.parametrize("step", ["prepare", "place"])
@pytest.mark.parametrize("at", [0, 1, 2])
def test_where_one_fails_all_is_as_it_was(three, tmp_path, monkeypatch, step, at):
    before, done = content(tmp_path), []
    inode = (tmp_path / "linked").stat().st_ino
    act = getattr(files._Output, step)

    def failing(output):
        if len(done) == at:
            raise OSError(28, "No space left on device")
        done.append(output)
        act(output)

    monkeypatch.setattr(files._Output, step, failing)
    files.written.clear()
    with pytest.raises(FileError, match="cannot be written: No space left"):
        write_all(three)
    assert content(tmp_path) == before and files.written == []
    assert (tmp_path / "linked").stat().st_ino == inode == (tmp_path / "second name").stat().st_ino


def test_a_rename_that_fails_puts_back_those_before_it_also_without_hard_links(tmp_path, monkeypatch):
    paths = [tmp_path / name for name in "abc"]
    for path in paths[:2]:
        path.write_bytes(b"old")
    rename = os.replace

    def failing(source, target):
        if os.path.basename(target) == "c":
            raise PermissionError(13, "Permission denied")
        rename(source, target)

    def unlinked(*names):
        raise OSError(1, "Operation not permitted")

    monkeypatch.setattr(os, "replace", failing)
    monkeypatch.setattr(os, "link", unlinked)
    with pytest.raises(FileError, match="c cannot be written: Permission denied"):
        write_all(dict.fromkeys(paths, b"new"))
    assert content(tmp_path) == {"a": b"old", "b": b"old"}


def test_where_putting_back_fails_too_the_old_content_is_kept_and_named(three, tmp_path, monkeypatch):
    exchange, calls = files._exchange, []

    def failing(source, target):
        calls.append(source)
        if len(calls) == 2:
            raise OSError(5, "Input/output error")
        exchange(source, target)

    def refused(source, target):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, "_exchange", failing)
    monkeypatch.setattr(os, "replace", refused)
    with pytest.raises(FileError, match="what was there before is in") as error:
        write_all(three)
    (left,) = [name for name in os.listdir(tmp_path) if name.endswith(".part")]
    assert left in str(error.value) and (tmp_path / left).read_bytes() == b"a longer text than the new one"


@posix
@pytest.mark.parametrize("mode", [0o600, 0o640, 0o755])
def test_a_file_keeps_its_mode(tmp_path, mode):
    target = tmp_path / "a.ngc"
    target.write_bytes(b"old")
    target.chmod(mode)
    write_whole(target, b"new")
    assert stat.S_IMODE(target.stat().st_mode) == mode and target.read_bytes() == b"new"


@posix
def test_links_are_followed_and_stay(tmp_path):
    (tmp_path / "far").mkdir()
    for name in ("there", "dangling"):
        (tmp_path / name).symlink_to(tmp_path / "far" / name)
    (tmp_path / "far" / "there").write_bytes(b"old")
    write_all({tmp_path / "there": b"1", tmp_path / "dangling": b"2"})
    assert content(tmp_path / "far") == {"there": b"1", "dangling": b"2"}
    assert (tmp_path / "there").is_symlink() and (tmp_path / "dangling").is_symlink()


@posix
@pytest.mark.parametrize("act", [check_writable, lambda path: write_whole(path, b"new")])
def test_what_may_not_be_replaced_is_refused_by_name(tmp_path, act):
    read_only = tmp_path / "mine.ngc"
    read_only.write_bytes(b"old")
    read_only.chmod(0o444)
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "folder").mkdir()
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "link").symlink_to("mine.ngc")
    for name, message in (("mine.ngc", "is read-only; make it writable"), ("pipe", "no ordinary file"), ("folder", "is a folder"),
                       ("loop", "levels of symbolic links; choose another name"), ("link", "is read-only"), (os.devnull, "no ordinary file"),
                       ("n" * 256, "name too long; choose another name")):  # fmt: skip
        with pytest.raises(FileError, match=message) as error:
            act(tmp_path / name)
        assert name[-8:] in str(error.value)
    assert read_only.read_bytes() == b"old" and len(os.listdir(tmp_path)) == 5


@pytest.mark.skipif(os.name == "nt", reason="a whole path may be no longer there")
def test_a_name_as_long_as_a_name_can_be_is_written(tmp_path):
    target = tmp_path / ("n" * 251 + ".ngc")
    check_writable(target)
    write_whole(target, b"new")
    assert content(tmp_path) == {target.name: b"new"}


@posix
@pytest.mark.parametrize("kind", ["pipe", "socket", "device", "folder"])
def test_what_is_no_ordinary_file_is_not_read(tmp_path, kind, monkeypatch):
    monkeypatch.chdir(tmp_path)  # a socket's name is short
    path = "/dev/zero" if kind == "device" else kind
    result = socket.socket(socket.AF_UNIX)
    {"pipe": os.mkfifo, "socket": result.bind, "folder": os.mkdir, "device": os.stat}[kind](path)
    with pytest.raises(FileError, match="is a folder" if kind == "folder" else "no ordinary file"):
        read_bytes(path, "machine file")
    result.close()


@posix
def test_a_pipe_that_takes_the_files_place_is_not_waited_for(tmp_path, monkeypatch):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "file").write_bytes(b"")
    ordinary, reported = os.stat(tmp_path / "file"), os.stat
    monkeypatch.setattr(
        os, "stat", lambda path, **how: ordinary if str(path).endswith("pipe") else reported(path, **how)
    )
    with pytest.raises(FileError, match="no ordinary file"):
        read_bytes(tmp_path / "pipe", "STL file")


def test_a_file_that_no_memory_holds_is_not_begun(tmp_path, monkeypatch):
    (tmp_path / "huge").write_bytes(bytes(1000))
    monkeypatch.setattr(memory, "free_memory", lambda: 999.0)
    with pytest.raises(SettingsError, match=r"huge: its bytes need at least 1e-06 GB"):
        read_bytes(tmp_path / "huge", "NC file")


@posix
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_waits_until_all_is_written(tmp_path, monkeypatch, name):
    number, came, rename = getattr(signal, name), [], os.replace
    before = signal.signal(number, lambda number, frame: came.append((number, len(content(tmp_path)))))

    def hit(source, target):
        signal.raise_signal(number)
        assert not came
        rename(source, target)

    monkeypatch.setattr(os, "replace", hit)
    try:
        write_all({tmp_path / "a": b"1", tmp_path / "b": b"2"})
        assert came == [(number, 2)]  # told once, when both files stood at their place and nothing else
    finally:
        signal.signal(number, before)


# ------------------------------------------------------------------------------------------- what a job reads


def job(tmp_path, task="mill", source="part.stl", **options):
    for name in ("part.stl", "faces.stl", "path.apt", "p.ngc", "m.fcm"):
        (tmp_path / name).touch()
    paths = {name: str(tmp_path / value) for name, value in options.items()}
    return build_settings(task, str(tmp_path / source), {"machine": "trunnion_ac", **paths})


@pytest.mark.parametrize(
    ("task", "options", "read"),
    [("mill", {"output": "part.stl"}, "part.stl"), ("mill", {"output": "m.fcm", "machine": "m.fcm"}, "m.fcm"),
     ("mill", {"output": "faces.stl", "faces": "faces.stl"}, "faces.stl"), ("mill", {"cl": "part.stl"}, "part.stl"),
     ("audit", {"blocks": "path.apt", "against": "path.apt"}, "path.apt"), ("audit", {"rates": "part.stl"}, "part.stl"),
     ("recover", {"machine_file": "path.apt", "program": "path.apt"}, "path.apt"),
     ("recover", {"machine_file": "m.fcm", "machine": "m.fcm", "program": "p.ngc"}, "m.fcm")],
)  # fmt: skip
def test_no_output_is_a_file_that_is_read(tmp_path, task, options, read):
    with pytest.raises(SettingsError, match=rf"{read} is the file that is read"):
        outputs.check_outputs(job(tmp_path, task, **options))


@posix
@pytest.mark.parametrize("link", [os.symlink, os.link])
def test_nor_is_it_by_another_name(tmp_path, link):
    settings = job(tmp_path, output="other.ngc", machine="m.fcm")
    link(tmp_path / "m.fcm", tmp_path / "other.ngc")
    with pytest.raises(SettingsError, match=r"other\.ngc is the file that is read"):
        outputs.check_outputs(settings)


def test_machines_to_compare_and_shipped_ones_are_read_too(tmp_path):
    shipped = machine_path("trunnion_ac")
    settings = build_settings("prove-signs", "", {"machine": "trunnion_ac", "output": str(shipped)})
    with pytest.raises(SettingsError, match="is the file that is read"):
        outputs.check_outputs(settings)
    job(tmp_path)
    report = tmp_path / "m.fcm"
    settings = build_settings(
        "compare", str(tmp_path / "part.stl"), {"machines": [f"{report}"], "report": [str(report)]}
    )
    with pytest.raises(SettingsError, match=r"m\.fcm is the file that is read"):
        outputs.check_outputs(settings)


def test_the_job_file_is_read_too(tmp_path, capsys):
    (tmp_path / "part.stl").touch()
    (tmp_path / "job.json").write_text(
        '{"task": "mill", "source": "part.stl", "machine": "trunnion_ac", "output": "a.ngc", "report": ["job.json"]}'
    )
    assert cli.main(["run", str(tmp_path / "job.json")]) == cli.UNUSABLE
    assert "job.json is the file that is read" in capsys.readouterr().err


@posix
@pytest.mark.parametrize("link", [None, os.symlink, os.link])
def test_two_outputs_are_two_files(tmp_path, link):
    settings = job(tmp_path, output="a.ngc", cl="./a.ngc" if link is None else "b.apt")
    if link is not None:
        (tmp_path / "a.ngc").touch()
        link(tmp_path / "a.ngc", tmp_path / "b.apt")
    with pytest.raises(SettingsError, match="is named for two outputs"):
        outputs.check_outputs(settings)
