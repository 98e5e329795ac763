# SPDX-License-Identifier: LGPL-2.1-or-later
"""``scripts/install``: links, twice without harm, never over anything that is not ours. Run in an empty
home."""

import os
import shutil
import stat
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TOOLS = (
    "bash",
    "dirname",
    "mkdir",
    "ln",
    "rm",
    "find",
    "readlink",
    "sed",
    "sort",
    "head",
    "cat",
    "mktemp",
    "timeout",
)

pytestmark = pytest.mark.skipif(os.name != "posix", reason="a shell script")


@pytest.fixture
def home(tmp_path):
    """A home, and a PATH that holds no FreeCAD."""
    tools = tmp_path / "tools"
    tools.mkdir()
    for tool in TOOLS:
        if shutil.which(tool):  # macOS has no timeout
            (tools / tool).symlink_to(shutil.which(tool))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def install(home, *arguments):
    environment = {"HOME": str(home), "PATH": str(home.parent / "tools"), "LANG": "C.UTF-8"}
    return subprocess.run(
        ["bash", ROOT / "scripts" / "install", *arguments],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
    )


def has_freecad(home, data):
    """A freecadcmd that answers as FreeCAD does: noise, then the folder, whatever the script is."""
    command = home.parent / "tools" / "freecadcmd"
    command.write_text(f"#!{shutil.which('bash')}\necho FreeCAD, Libs\necho; echo 'DATA={data}/'\n")
    command.chmod(command.stat().st_mode | stat.S_IXUSR)


def test_it_links_into_the_folder_that_freecad_names(home):
    data = home / "somewhere" / "v1-1"
    has_freecad(home, data)
    done = install(home)
    assert done.returncode == 0, done.stderr
    assert (data / "Mod" / "FiveAxis").resolve() == ROOT
    assert [path.name for path in home.iterdir()] == ["somewhere"]


def test_it_links_for_freecads_that_cannot_be_requested(home):
    folders = [home / ".local/share/FreeCAD/v1-1", home / ".var/app/org.freecad.FreeCAD/data/FreeCAD"]
    for folder in folders:
        folder.mkdir(parents=True)
    assert install(home).returncode == 0
    assert all((folder / "Mod" / "FiveAxis").resolve() == ROOT for folder in folders)
    assert not (home / ".local/share/FreeCAD/Mod").exists()  # 1.1 does not look there


def test_without_any_freecad_the_usual_folder_is_prepared(home):
    done = install(home)
    assert done.returncode == 0 and "no FreeCAD" in done.stdout
    assert (home / ".local/share/FreeCAD/Mod/FiveAxis").resolve() == ROOT


def test_twice_does_no_harm(home):
    install(home)
    again = install(home)
    assert again.returncode == 0 and "already" in again.stdout
    assert [path.name for path in (home / ".local/share/FreeCAD/Mod").iterdir()] == ["FiveAxis"]


@pytest.mark.parametrize("kind", ["folder", "file", "link", "broken link"])
@pytest.mark.parametrize("arguments", [(), ("remove",)], ids=["install", "remove"])
def test_what_is_not_our_link_stays(home, kind, arguments):
    link = home / ".local/share/FreeCAD/Mod/FiveAxis"
    link.parent.mkdir(parents=True)
    other = home / "other"
    if kind == "folder":
        link.mkdir()
        (link / "mine.txt").write_text("mine")
    elif kind == "file":
        link.write_text("mine")
    else:
        if kind == "link":
            other.mkdir()
        link.symlink_to(other)
    done = install(home, *arguments)
    assert done.returncode == 1 and str(link) in done.stderr
    assert link.is_symlink() == ("link" in kind)
    assert kind != "folder" or (link / "mine.txt").read_text() == "mine"
    assert "link" not in kind or os.readlink(link) == str(other)


def test_remove_takes_our_link_only(home):
    install(home)
    assert install(home, "remove").returncode == 0
    assert not list((home / ".local/share/FreeCAD/Mod").iterdir())
    assert (ROOT / "package.xml").is_file()


def test_an_unknown_word_is_refused(home):
    assert install(home, "sideways").returncode == 2
