# SPDX-License-Identifier: LGPL-2.1-or-later
"""recover, prove-signs and import-machine for macros: no document, the same bytes as the command line,
nothing replaced."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import editing, importing, machines, preferences, recovering, results, signs
from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError, SettingsError
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.pipeline import options
from freecad_fiveaxis.core.toolpath.apt import write_apt

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def folder(tmp_path):
    """The user's folder of machines, which is not there yet."""
    kept = preferences.read("MachineFolder")
    preferences.write("MachineFolder", str(tmp_path / "machines"))
    yield tmp_path / "machines"
    preferences.write("MachineFolder", kept)


@pytest.fixture
def pair(doc, ball, tmp_path):
    """A CL file and the program made of it."""
    path = app.create_toolpath(doc, ball, **{**FAST, "stepover": 8, "origin": (10, -5, 20)})
    result = results.result_of(path).draft
    (tmp_path / "ball.apt").write_bytes(
        write_apt(result.path, result.settings.cutter.cutter, "ball", head=options.cl_head(result.settings))
    )
    app.post_process(path, tmp_path / "ball.ngc")
    return tmp_path / "ball.apt", tmp_path / "ball.ngc"


def run(*words):
    return cli.main([str(word) for word in words])


def test_a_recovered_machine_goes_to_the_user_s_folder_and_stands_in_the_list(pair, folder):
    before = [one.machine for one in machines.choices()]
    done = app.recover(*pair, origin=(10, -5, 20), machine="trunnion_ac")
    assert done.settings.recover.machine_file == str(folder / "ball.fcm") and (folder / "ball.fcm").exists()
    assert [one.machine for one in machines.choices() if one.machine not in before] == [
        str(folder / "ball.fcm")
    ]
    found, truth = load_machine(str(folder / "ball.fcm")), load_machine("trunnion_ac")
    assert [axis.letter for axis in found.rotary] == [axis.letter for axis in truth.rotary]
    assert not any(one.code == "post-and-machine-differ" for one in done.findings)
    assert app.recover(*pair).settings.recover.machine_file == str(folder / "ball-2.fcm")


def test_it_is_the_file_that_the_command_line_writes(pair, folder, tmp_path):
    app.recover(*pair, tmp_path / "mine.fcm", origin=(10, -5, 20))
    (tmp_path / "cli").mkdir()
    assert (
        run("recover", *pair, "--origin", "10,-5,20", "-o", tmp_path / "cli" / "mine.fcm", "--quiet")
        == cli.DONE
    )
    assert (tmp_path / "cli" / "mine.fcm").read_bytes() == (tmp_path / "mine.fcm").read_bytes()


def test_what_is_there_is_not_replaced_and_what_cannot_be_used_is_stated(pair, folder, tmp_path):
    (tmp_path / "mine.fcm").write_text("mine")
    with pytest.raises(FileError, match="exists already"):
        app.recover(*pair, tmp_path / "mine.fcm")
    with pytest.raises(SettingsError, match=r"does not end in \.fcm"):
        app.recover(*pair, tmp_path / "mine.txt")
    with pytest.raises(FileError, match="does not exist"):
        app.recover(*pair, tmp_path / "nowhere" / "mine.fcm")
    with pytest.raises(FiveAxisError):
        app.recover(pair[1], pair[0])
    assert (tmp_path / "mine.fcm").read_text() == "mine" and not folder.exists()


def test_the_report_is_written_as_its_name_says(pair, folder, tmp_path):
    done = recovering.recover(*pair, None, {})
    assert not folder.exists(), "nothing is written before write"
    recovering.write_report(done, tmp_path / "r.html")
    recovering.write_report(done, tmp_path / "r.json")
    assert "certain within" in (tmp_path / "r.html").read_text(encoding="utf-8")
    assert json.loads((tmp_path / "r.json").read_text(encoding="utf-8"))["layout"]["kind"] == "table-table"
    with pytest.raises(FileError, match="exists"):
        recovering.write_report(done, tmp_path / "r.html")
    with pytest.raises(FileError, match="endings"):
        recovering.write_report(done, tmp_path / "r.pdf")


def test_a_stopped_recovery_leaves_nothing(pair, folder):
    def stop(stage, fraction):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        recovering.recover(*pair, None, {}, stop)
    assert not folder.exists()


@pytest.mark.parametrize(
    ("controller", "suffix"), [("linuxcnc", ".ngc"), ("heidenhain", ".h"), ("siemens840d", ".mpf")]
)
def test_the_proof_of_signs_is_what_the_command_line_makes(controller, suffix, tmp_path):
    nc, sheet = tmp_path / f"signs{suffix}", tmp_path / "signs.html"
    done = app.prove_signs(nc, "trunnion_bc", sheet, controller=controller, mark=(40, 25, 10), gap=30)
    assert len(done.plan.stops) >= 8
    words = ("--machine", "trunnion_bc", "--controller", controller, "--mark", "40,25,10", "--gap", "30")
    other = tmp_path / f"cli{suffix}"
    assert run("prove-signs", *words, "-o", other, "--report", tmp_path / "cli.html", "--quiet") == cli.DONE
    assert (
        other.read_bytes() == nc.read_bytes() and (tmp_path / "cli.html").read_bytes() == sheet.read_bytes()
    )


def test_a_proof_replaces_nothing_unasked(tmp_path):
    nc, sheet = tmp_path / "signs.ngc", tmp_path / "signs.html"
    sheet.write_text("mine")
    with pytest.raises(FileError, match="exists"):
        app.prove_signs(nc, "trunnion_ac", sheet)
    assert sheet.read_text() == "mine" and not nc.exists()
    app.prove_signs(nc, "trunnion_ac", sheet, overwrite=True)
    assert nc.exists() and "Proving the signs" in sheet.read_text(encoding="utf-8")
    with pytest.raises(SettingsError, match="tool-length"):
        signs.prove(tmp_path / "b.ngc", {"machine": "fork_head_bc"})


def test_a_machine_of_freecad_s_editor_is_imported(folder, tmp_path):
    source = tmp_path / "theirs.fcm"
    data = json.loads((ROOT / "resources" / "machines" / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    data.pop("fiveaxis", None)
    source.write_text(json.dumps(data))
    found = importing.read(source)
    assert {one.code for one in found.findings} >= {"sign-unproven"}
    result = app.import_machine(source)
    assert Path(result).parent == folder and load_machine(result).axes == found.machine.axes
    (tmp_path / "cli").mkdir()
    run("import-machine", source, "-o", tmp_path / "cli" / "m.fcm", "--quiet")
    assert (tmp_path / "cli" / "m.fcm").read_bytes() == Path(result).read_bytes()
    with pytest.raises(FileError, match="exists already"):
        importing.write(found, result)
    with pytest.raises(SettingsError, match="does not end"):
        importing.write(found, tmp_path / "m.ini")


def test_a_name_that_no_file_can_have_is_built_one_and_none_is_taken_twice(folder):
    assert machines.free_file("a/b:c") == str(folder / "a_b_c.fcm") and machines.free_file("..") == str(
        folder / "machine.fcm"
    )
    folder.mkdir()
    (folder / "a_b_c.fcm").write_text("")
    assert machines.free_file("a/b:c") == str(folder / "a_b_c-2.fcm")


def test_an_edited_machine_goes_to_the_user_s_folder_and_over_no_file(folder):
    draft = replace(editing.open_draft("trunnion_ac"), name="mine")
    names = editing.list_known_names()
    machine, problems = editing.check(draft, names)
    assert machine is not None and not problems
    _, problems = editing.check(editing.open_draft("trunnion_ac"), names)
    assert ["a name of its own" in one.text for one in problems] == [True]
    assert (
        editing.write(draft) == str(folder / "mine.fcm")
        and load_machine(str(folder / "mine.fcm")).name == "mine"
    )
    assert editing.write(draft) == str(folder / "mine-2.fcm"), "the next free name"
    with pytest.raises(FileError, match="exists already"):
        editing.write(draft, folder / "mine.fcm")
    with pytest.raises(SettingsError, match=r"\.fcm"):
        editing.write(draft, folder / "mine.txt")
    with pytest.raises(FiveAxisError, match="name is empty"):
        editing.write(replace(draft, name=""), folder / "none.fcm")
    assert sorted(one.name for one in folder.iterdir()) == ["mine-2.fcm", "mine.fcm"]
