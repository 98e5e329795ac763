# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's subprograms in files of their own: by hand, and as its own interpreter runs them."""

from __future__ import annotations

import pytest
from rs274_judge import judged, needs_rs274
from test_nc_cycles import HEAD, LINKS

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.nc.reader import Assumed, called_files, read_nc

SUB = (
    "(moves #1 along X; twice)\no<side> sub\n  G1 X#1 F100 ; there\n  o100 call [#1+1]\no<side> endsub\nM2\n"
)
DEEPER = "%\n; never run: G1 X99\nG1 X99\no100 sub\nX[2*#1]\no100 endsub\nG1 X77\n%\n"
CALLS = HEAD + "G1 X1 F100\no<Si de> call [3]\nG1 Y5\nM2\n"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "side.ngc").write_text(SUB)
    (tmp_path / "100.ngc").write_bytes(DEEPER.replace("\n", "\r\n").encode())
    (tmp_path / "main.ngc").write_text(CALLS)
    return tmp_path


def read(text, *folders, controller="linuxcnc"):
    assumed = Assumed(search=tuple(map(str, folders)))
    return read_nc(text.encode(), LINKS, DIALECTS[controller], assumed=assumed)


def errors(program):
    return [found for found in program.findings if found.severity is Severity.ERROR]


def test_a_call_runs_the_file_of_its_name_and_the_calls_in_it(folder):
    program = read(CALLS, folder)
    assert not errors(program)
    assert program.words[:, 0].tolist()[-4:] == [1, 3, 8, 8] and program.words[-1, 1] == 5
    call = HEAD.count("\n") + 2
    assert program.line[-4:].tolist() == [call - 1, call, call, call + 1]


@pytest.mark.rs274
@needs_rs274
def test_as_linuxcnc_itself_runs_it(folder):
    ends = judged(folder / "main.ngc").ends
    program = read(CALLS, folder)
    assert ends[-4:, :2].tolist() == program.words[-4:, :2].tolist()


def test_the_first_folder_that_has_the_file_counts_and_the_programs_own_sub_before_all(folder, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "side.ngc").write_text("o<side> sub\nG1 X50 F9\no<side> endsub\n")
    assert 50 in read(CALLS, other, folder).words[:, 0] and 50 not in read(CALLS, folder, other).words[:, 0]
    own = CALLS.replace("M2\n", "") + "o<side> sub\nX60\no<side> endsub\nM2\n"
    assert read(own, other).words[:, 0].tolist()[-1] == 60


def test_without_the_file_the_line_is_named_with_what_helps(folder, capsys):
    (folder / "elsewhere").mkdir()
    (folder / "side.ngc").rename(folder / "elsewhere" / "side.ngc")
    audit = ["audit", str(folder / "main.ngc"), "--machine", "trunnion_ac", "--cutter", "ball:6"]
    assert main(audit) == 1
    message = " ".join(capsys.readouterr().out.split())
    assert (
        "subprogram O<side> is not in this file, and no side.ngc that holds it was found beside it" in message
    )
    assert "give the folder of that file with --search" in message
    main([*audit, "--search", str(folder / "elsewhere")])
    assert "is not in this file" not in capsys.readouterr().out


def test_a_file_without_its_sub_is_none_and_fanuc_has_no_such_calls(folder):
    (folder / "side.ngc").write_text("G1 X50\n")
    assert "no side.ngc that holds it" in errors(read(CALLS, folder))[0].text
    (folder / "side.ngc").write_text(SUB)
    assert errors(read(CALLS, folder, controller="fanuc"))


def test_what_is_wrong_in_a_called_file_is_named_by_the_line_of_the_call(folder, monkeypatch):
    line = HEAD.count("\n") + 2
    (folder / "side.ngc").write_text("o<side> sub\no1 if\no<side> endsub\n")
    (found, *_) = errors(read(CALLS, folder))
    assert found.line == line and "has no" in found.text
    (folder / "side.ngc").write_text("o<side> sub\no<side> call\no<side> endsub\n")
    with pytest.raises(ProgramError, match=rf"^line {line}: calls are nested deeper"):
        read(CALLS, folder)
    monkeypatch.setattr(called_files, "MOST", 1)
    (folder / "side.ngc").write_text(SUB)
    (found, *_) = errors(read(CALLS, folder))
    assert found.line == line and "more than 1 programs" in found.text
