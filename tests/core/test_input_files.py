# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are missing, damaged or of another kind: refused before the work in one line that names file,
option and remedy, whatever the command."""

import json
import os

import pytest
from roofs import write_roof

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import ProgramError, naming_file
from freecad_fiveaxis.core.pipeline.inputs import find_kind

NC = "%\nN10 G21 G90\nN20 G0 X1 Y2 Z3 A4 C5\nN30 G1 X2 F100\nM2\n"
HEIDENHAIN = "0 BEGIN PGM A MM\n1 L X+1 Y+2 Z+3 A+4 C+5 FMAX\n2 L X+2 F100\n3 END PGM A MM\n"
SIEMENS = "; a program\nG710 G90\nN10 G1 X1 Y2 Z3 A4 C5 F=500\nM30\n"
APT = "PARTNO/A\n$$ made by hand\nMULTAX/ON\nGOTO/1,2,3,0,0,1\nGOTO/4,5,6,0,0,1\n"
MACHINE = ("--machine", "trunnion_ac")
TRIED = ("--machines", "trunnion_ac")


@pytest.fixture
def files(tmp_path, monkeypatch):
    """A folder, in which the command runs, with a file of each kind."""
    monkeypatch.chdir(tmp_path)
    write_roof(tmp_path / "part.stl")
    for name, text in (("a.ngc", NC), ("a.apt", APT), ("words.stl", "hello"), ("a.json", "{}")):
        (tmp_path / name).write_text(text)
    (tmp_path / "empty.stl").touch()
    (tmp_path / "folder.stl").mkdir()
    return tmp_path


def refused(capsys, *words):
    """The one line of a command that is refused; nothing may be written."""
    before = sorted(os.listdir())
    assert cli.main([str(word) for word in words]) == cli.UNUSABLE
    line = capsys.readouterr().err
    assert line.count("\n") == 1 and sorted(os.listdir()) == before
    return line


MILL = ("mill", "part.stl", *MACHINE, "--stepover", "5", "-o", "o.ngc")
WRONG = {
    "source missing": (("mill", "gone.stl", *MILL[2:]), "gone.stl does not exist; name the file to read"),
    "source another": (("mill", "a.ngc", *MILL[2:]), "a.ngc is an NC program, needed is an STL file; name another file (`audit` takes NC programs)"),
    "source no mesh": (("mill", "words.stl", *MILL[2:]), "words.stl: this is no STL file: its 5 bytes neither begin with 'solid' nor hold a binary header; export the part as STL"),
    "fixture missing": ((*MILL, "--fixture", "gone.stl"), "--fixture: gone.stl does not exist; name the file to read"),
    "fixture in its place": ((*MILL, "--fixture", "gone.stl@1,2,3"), "--fixture: gone.stl does not exist"),
    "fixture empty": ((*MILL, "--fixture", "empty.stl"), "--fixture: empty.stl: the file is empty; export the part again"),
    "fixture folder": ((*MILL, "--fixture", "folder.stl"), "--fixture: folder.stl is a folder; name the file to read"),
    "fixture another": ((*MILL, "--fixture", "a.apt"), "--fixture: a.apt is a CL file (APT), needed is an STL file; name another file"),
    "faces": ((*MILL, "--faces", "gone.stl"), "--faces: gone.stl does not exist; name the file to read"),
    "avoid": ((*MILL, "--avoid", "a.json"), "--avoid: a.json is JSON text, needed is an STL file; name another file"),
    "curve": ((*MILL, "--from", "gone.csv"), "--from: gone.csv does not exist; name the file to read"),
    "machine": (("mill", "part.stl", "--machine", "gone.fcm", *MILL[4:]), "--machine: gone.fcm does not exist; name the file to read"),
    "post": (("post", "part.stl", *MACHINE, "-o", "o.ngc"), "part.stl is an STL file, needed is a CL file (APT); name another file (`mill` takes parts)"),
    "audit": (("audit", "a.apt", *MACHINE), "a.apt is a CL file (APT), needed is an NC program; name another file (`post` takes CL files)"),
    "against": (("audit", "a.ngc", *MACHINE, "--against", "gone.apt"), "--against: gone.apt does not exist; name the file to read"),
    "against another": (("audit", "a.ngc", *MACHINE, "--against", "words.stl"), "--against: words.stl: this is no STL file"),
    "setup": (("setup", "part.stl", *MACHINE, "--fixture", "gone.stl"), "--fixture: gone.stl does not exist"),
    "compare": (("compare", "a.ngc", *TRIED), "a.ngc is an NC program, needed is a CL file (APT)"),
    "compare machines": (("compare", "part.stl", "--machines", "gone.fcm"), "--machines: gone.fcm does not exist"),
    "reach": (("reach", "part.stl", *MACHINE, "--fixture", "gone.stl"), "--fixture: gone.stl does not exist"),
    "exchanged": (("recover", "a.ngc", "a.apt", "-o", "q.fcm"), "a.ngc is an NC program and a.apt is a CL file (APT): the two are exchanged; name a.apt first"),
    "recover the same": (("recover", "a.apt", "a.apt", "-o", "q.fcm"), "a.apt is a CL file (APT), needed is an NC program"),
    "job file": (("run", "gone.json"), "gone.json does not exist; name the file to read"),
    "no job file": (("run", "a.ngc"), "job file a.ngc is not JSON: Expecting value: line 1 column 1 (char 0); correct that place, or name another file"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_file_is_named_with_its_option_and_the_remedy(case, files, capsys):
    words, message = WRONG[case]
    assert f"fiveaxis: {message}" in refused(capsys, *words)


def test_a_job_file_says_it_by_the_same_option(files, capsys):
    job = {"task": "mill", "source": "part.stl", "machine": "trunnion_ac", "output": "o.ngc"}
    (files / "job.json").write_text(json.dumps(job | {"fixture": ["gone.stl"]}))
    line = refused(capsys, "run", files / "job.json")
    assert line.startswith("fiveaxis: --fixture: ") and "gone.stl does not exist" in line


@pytest.mark.parametrize(
    ("name", "text"), [("b.ngc", "G21\nG1 X1 Y2 \x7f\nG1 X2\nM2\n"), ("b.apt", "GOTO/1,2\n")]
)
def test_text_that_cannot_be_read_is_reported_behind_its_file(name, text, files, capsys):
    (files / name).write_text(text)
    words = ("audit", name) if name == "b.ngc" else ("post", name, "-o", "o.ngc")
    assert refused(capsys, *words, *MACHINE).startswith(f"fiveaxis: {name}: line ")


def test_an_error_keeps_the_file_that_was_read_first():
    with pytest.raises(ProgramError) as caught, naming_file("whole.ngc"), naming_file("part.ngc"):
        raise ProgramError("line 1")
    assert caught.value.name_file() == "part.ngc: line 1" and str(caught.value) == "line 1"


@pytest.mark.parametrize(
    ("text", "kind"),
    [(NC, "nc"), (HEIDENHAIN, "nc"), (SIEMENS, "nc"), (APT, "cl"), ('{"task": "mill"}', "json"),
     ("solid a\nfacet normal 0 0 1\n", "stl"), ("hello\nworld\n", ""), ("1,2,3\n4,5,6\n", ""),
     ("(UNITS/MM as the CL file says)\nG1 X1\nG1 X2\n", "nc"), ("", "")],
)  # fmt: skip
def test_the_beginning_tells_the_kind(text, kind, tmp_path):
    (tmp_path / "file").write_text(text)
    assert find_kind(str(tmp_path / "file")) == kind


def test_a_binary_part_is_known_by_its_size_and_no_facet_is_read(tmp_path):
    path = tmp_path / "large.stl"
    with path.open("wb") as file:  # two million facets of nothing, of which no disk keeps a byte
        file.write(b"\0" * 80 + (2_000_000).to_bytes(4, "little"))
        file.truncate(84 + 50 * 2_000_000)
    assert find_kind(str(path)) == "stl"
    with path.open("r+b") as file:
        file.truncate(84 + 50 * 1_999_999)
    assert find_kind(str(path)) == ""


# What a batch reads


def batch(capsys, parts, **options):
    options = {"machine": "trunnion_ac", "stepover": 5} | options
    with open("jobs.json", "w", encoding="utf-8") as file:
        json.dump({"parts": parts, "options": options}, file)
    return refused(capsys, "batch", "jobs.json", "--out", "out", "--executor", "serial")


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        (["part.stl", "gone.stl"], "gone.stl does not exist; name the file to read"),
        (["part.stl", "words.stl"], "words.stl: this is no STL file"),
        (["part.stl", "empty.stl"], "empty.stl: the file is empty"),
        (["part.stl", "a.ngc"], "a.ngc is an NC program, needed is an STL file"),
    ],
)
def test_a_part_that_a_table_names_is_looked_at_before_any_is_milled(parts, message, files, capsys):
    assert message in batch(capsys, parts)
    assert not (files / "out").exists()


def test_so_are_the_other_files_of_a_batch(files, capsys):
    assert "--fixture: " in (line := batch(capsys, ["part.stl"], fixture=["gone.stl"])) and "gone.stl" in line
    assert "--faces: " in batch(capsys, ["part.stl"], faces=["part.stl", "words.stl"])
