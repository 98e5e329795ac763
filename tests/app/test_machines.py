# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine chooser lists every file, those of no use with their error."""

import shutil
import sys
from types import SimpleNamespace

import FreeCAD
import pytest

from freecad_fiveaxis.app import machines, preferences
from freecad_fiveaxis.app.machines import FREECAD, SHIPPED, USER, choices
from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine
from freecad_fiveaxis.core.machine.machine_file import machine_folder


@pytest.fixture
def folder(tmp_path):
    """The user's machine folder, empty."""
    result = tmp_path / "mine"
    result.mkdir()
    preferences.write("MachineFolder", str(result))
    yield result
    preferences.reset()


def copy_machine(name, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    return shutil.copy(machine_folder() / f"{name}.fcm", target)


def of(source):
    return [choice for choice in choices() if choice.source == source]


def test_shipped_machines_come_by_name_and_all_load(folder):
    assert [choice.machine for choice in of(SHIPPED)] == list(list_shipped_machines())
    assert not [choice.error for choice in choices() if choice.source == SHIPPED and choice.error]


def test_the_users_files_come_by_path_and_load(folder):
    copy_machine("trunnion_ac", folder / "my mill.fcm")
    (folder / "notes.txt").write_text("no machine")
    (one,) = of(USER)
    assert (one.label, one.machine, one.error) == ("trunnion_ac", str(folder / "my mill.fcm"), "")
    assert load_machine(one.machine).rotary


@pytest.mark.parametrize("content", [b"", b"{}", b"\x00\xff", b'{"version": 9}'])
def test_a_broken_file_is_listed_with_its_error(folder, content):
    (folder / "broken.fcm").write_bytes(content)
    copy_machine("trunnion_bc", folder / "good.fcm")
    broken, good = of(USER)
    assert broken.label == "broken" and "broken.fcm" in broken.error
    assert good.error == ""


def test_a_folder_that_is_not_there_offers_nothing(folder):
    folder.rmdir()
    assert of(USER) == []
    assert len(of(SHIPPED)) == len(list_shipped_machines())


def test_without_a_preference_the_folder_is_in_freecads_user_data(folder):
    preferences.reset()
    assert str(machines.user_folder()).startswith(FreeCAD.getUserAppDataDir())
    assert machines.user_folder().parts[-2:] == ("FiveAxis", "machines")


def test_freecads_own_folder_counts_where_there_is_a_machine_editor(folder, tmp_path, monkeypatch):
    assets = SimpleNamespace(getAssetPath=lambda: tmp_path / "assets")
    monkeypatch.setitem(sys.modules, "Path.Preferences", assets)
    monkeypatch.setattr(FreeCAD, "getHomePath", lambda: str(tmp_path / "home"))
    copy_machine("trunnion_ac", tmp_path / "assets" / "Machines" / "saved.fcm")
    assert of(FREECAD) == []  # this FreeCAD has no editor, so the folder is none of its own
    copy_machine("trunnion_bc", tmp_path / "home" / "Mod" / "CAM" / "Machine" / "machines" / "Template.fcm")
    assert [choice.label for choice in of(FREECAD)] == ["trunnion_ac", "trunnion_bc"]


def test_a_file_in_two_folders_is_listed_once(folder, tmp_path, monkeypatch):
    copy_machine("trunnion_ac", folder / "one.fcm")
    monkeypatch.setattr(machines, "freecad_folders", lambda: [folder])
    assert [choice.source for choice in choices() if choice.label == "trunnion_ac"] == [SHIPPED, USER]
