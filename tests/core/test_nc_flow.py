# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jumps, loops and subprograms, run in bounds: by hand, and as LinuxCNC's own interpreter runs them."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rs274_judge import difference, judged, needs_rs274
from test_nc_cycles import HEAD, LINKS, errors, read

from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.nc.reader import interpreter, read_nc

EXAMPLES = [
    path
    for root in ("/usr/share/linuxcnc", "/usr/share/doc/linuxcnc")
    for path in sorted(Path(root).rglob("*.ngc"))
]
FORMS = sorted(Path("/usr/share/linuxcnc/ncfiles/ngcgui_lib").glob("*.ngc"))


def ends_x(text: str, controller: str = "linuxcnc") -> list[float]:
    """The X of the blocks after the first, of a program without errors."""
    program = read(HEAD + text, controller)
    assert not errors(program), program.findings
    return program.words[1:, 0].tolist()


O_WORDS = {
    "while": ("#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nG1 X#1\no1 endwhile\n", [1, 2, 3]),
    "do": ("#1=5\nO1 DO\nG1 X#1\n#1=[#1+1]\nO1 WHILE [#1 LT 7]\nG1 X0\n", [5, 6, 0]),
    "repeat": ("o<a> repeat [3]\nG91 G1 X2\no<a> endrepeat\n", [2, 4, 6]),
    "no repeat": ("o1 repeat [0]\nG1 X2\no1 endrepeat\nG1 X9\n", [9]),
    "break": (
        "#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 EQ 4]\no1 break\no3 endif\nG1 X#1\no1 endwhile\n",
        [1, 3],
    ),
    "if": ("o1 if [0]\nG1 X1\no1 elseif [1]\nG1 X2\no1 elseif [1]\nG1 X3\no1 else\nG1 X4\no1 endif\n", [2]),
    "else": ("o1 if [0]\nG1 X1\no1 else\nG1 X4\no1 endif\nG1 X5\n", [4, 5]),
    "sub": (
        "o1 sub\n#3=7\nG1 X[#1+#2]\no1 endsub [#1*2]\n#3=1\no1 call [3] [4]\nG1 X#3\nG1 X#<_value>\n",
        [7, 1, 6],
    ),
    "return": ("o<a> sub\nG1 X1\no<a> return [5]\nG1 X2\no<a> endsub\no<a> call\nG1 X#<_value>\n", [1, 5]),
    "names": ("o1 sub\n#<a>=2\n#<_share>=3\no1 endsub\n#<a>=1\no1 call\nG1 X[#<a> + #<_share>]\n", [4]),
    "recursion": (
        "o1 sub\no2 if [#1 GT 0]\nG1 X#1\no1 call [#1-1]\no2 endif\no1 endsub\no1 call [3]\n",
        [3, 2, 1],
    ),
    "end": ("G1 X1\nM2\nG1 X#1\n", [1]),
}


@pytest.mark.parametrize("name", O_WORDS)
def test_o_words_run_as_linuxcnc_runs_them(name: str) -> None:
    text, ends = O_WORDS[name]
    assert ends_x(text) == ends


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("name", O_WORDS)
def test_linuxcnc_runs_them_so(name: str, tmp_path: Path) -> None:
    text = HEAD + O_WORDS[name][0] + "G90 G0 X0\nM2\n"
    (tmp_path / "a.ngc").write_text(text)
    message = judged(tmp_path / "a.ngc")
    assert not message.refused and not difference(read(text).words[:, [0, 1, 2, 4, 3]], message)


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\nG1 X#1\nEND1\n", [1, 2, 3]),
        ("#1=0\nN5 #1=#1+1\nG1 X#1\nIF [#1 LT 3] GOTO 5\nG1 X9\n", [1, 2, 3, 9]),
        ("GOTO 20\nG1 X1\nN20 G1 X2\n", [2]), ("#2=1\nIF [#2 EQ 1] THEN #3=8\nG1 X#3\n", [8]),
        ("G1 X1\nM98 P1000 L2\nG90 G1 X9\nM30\nO1000\nG91 G1 X1\nM99\n", [1, 2, 3, 9]),
        ("M98 P21000\nM30\nO1000 (SUB)\nG91 G1 X1\nM99\n", [1, 2]),
        ("M98 P1000\nM30\nO1000\nG1 X1\nM98 P2000\nG1 X3\nM99\nO2000\nG1 X2\nM99\n", [1, 2, 3]),
        ("G65 P1000 A4 X2.5\nG1 X#1\nM30\nO1000\nG1 X[#1+#24]\n#1=3\nM99\n", [6.5]),
        ("#100=1\nM98 P1000\nG1 X9\nN7 G1 X8\nM30\nO1000\nM99 P7\n", [8]), ("M97 P100\nG1 X2\nM30\nN100 G1 X1\nM99\n", [1, 2]),
        ("#1=0\nWHILE [#1 LT 2] DO1\n#2=0\nWHILE [#2 LT 2] DO2\nG1 X[#1*10+#2]\n#2=#2+1\nEND2\n#1=#1+1\nEND1\n", [0, 1, 10, 11]),
    ],
)  # fmt: skip
def test_macros_and_subprograms_run_as_on_fanuc_and_haas(text: str, ends: list[float]) -> None:
    assert ends_x(text, "haas") == ends and ends_x(text, "fanuc") == ends


def test_every_block_keeps_the_line_of_the_file_that_it_comes_from() -> None:
    program = read(
        HEAD + "o1 sub\nG1 X#1\nG81 X9 Z-1 R1\no1 endsub\no1 call [1]\nG1 X3\no1 call [2]\nG2 X5 I1.5\nG123\n"
    )
    assert sorted(set(program.line.tolist()), key=program.line.tolist().index) == [2, 4, 5, 8, 10]
    assert [found.line for found in program.findings if found.code == "unknown-code"] == [11]


def test_plots_run_along_the_blocks_where_lines_come_again() -> None:
    from freecad_fiveaxis.core.report.plots import _abscissa

    assert _abscissa(read(HEAD + "o1 repeat [2]\nG1 X1\nX2\no1 endrepeat\n")).tolist() == [0, 1, 2, 3, 4]
    assert _abscissa(read(HEAD + "G81 X1 Z-1 R3\nG80\n")).tolist()[:3] == [2, 3, 3]


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("o1 while [1]\nG4 P0\no1 endwhile\n", (3, 4, 5), "does not end"), ("N1 GOTO 1\n", (3,), "does not end"),
        ("o1 sub\no1 call\no1 endsub\no1 call\n", (4,), "deeper than 100"), ("o1 repeat [900000000]\nG1 X1\no1 endrepeat\n", (3, 4, 5), "does not end"),
        ("O5\nM98 P5\n", (4,), "deeper than 100"),
    ],
)  # fmt: skip
def test_what_does_not_end_is_refused_with_its_line(
    text: str, line: tuple[int, ...], message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(interpreter, "MOST", 50_000)
    with pytest.raises(ProgramError, match=message) as caught:
        read(HEAD + text)
    assert int(re.match(r"line (\d+)", str(caught.value))[1]) in line


def test_a_loop_that_does_not_end_is_left_soon_when_the_work_is_stopped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Soon by the lines that are run before and after: how long it takes is for benchmarks/bench_stop.py."""
    step, run, looks = interpreter.Run._step, [], []

    def stop(stage: str, fraction: float) -> None:
        looks.append(len(run))
        if len(run) >= 10_000:
            raise Cancelled("enough")

    monkeypatch.setattr(interpreter.Run, "_step", lambda self, what: run.append(1) or step(self, what))
    with pytest.raises(Cancelled):
        read_nc((HEAD + "o1 while [1]\n#1=[#1+1]\no1 endwhile\n").encode(), LINKS, DIALECTS["linuxcnc"], stop)
    assert 10_000 <= looks[-1] == len(run) < 30_000


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("o<other> call", "not in this file"), ("M98 P77", "not in this file"), ("o1 if [1]", "no end"), ("o1 endif", "no begin"),
        ("GOTO 99", "N99"), ("M98", "by P alone"), ("o1 break", "no loop"), ("M72", "modes"), ("G1 X[1", "missing"), ("o1 if\no1 endif", "condition"),
        ("END1", "no begin"), ("o1 while 1\no1 endwhile", "not known here"), ("END#", "number of its loop"), ("END#1", "number of its loop"),
        ("DO#1", "number of its loop"), ("WHILE[0]DO", "number of its loop"), ("WHILE[0]", "number of its loop"),
    ],
)  # fmt: skip
def test_what_is_not_understood_is_named_with_its_line_and_the_plain_blocks_stay(
    line: str, message: str
) -> None:
    program = read(HEAD + "G1 X3\n" + line + "\nG1 X7\n")
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert message in found[0].text and found[0].line == 4
    assert program.words[-1, 0] == 7


def test_a_program_with_nothing_of_this_is_read_as_before() -> None:
    text = (HEAD + "G1 X1\nX2\n").encode()
    assert read_nc(text, LINKS, DIALECTS["linuxcnc"]).line.tolist() == [2, 3, 4]


def verdict(text: bytes, file: Path) -> str:
    """agree, refused, or where the two differ; '-' where the judge itself refuses. What goes to a machine
    position is not compared: the judge has one, the reader leaves out what follows."""
    if re.search(rb"(?i)\bG(53|28|30)(?![0-9.])", text):
        return "refused"
    try:
        program = read_nc(text, LINKS, DIALECTS["linuxcnc"])
    except FiveAxisError:
        return "refused"
    named = ("machine-position", "unknown-code", "unknown-axis", "word-not-interpreted")
    if any(
        (found.severity is Severity.ERROR and found.code != "no-feed") or found.code in named
        for found in program.findings
    ):
        return "refused"
    message = judged(file)
    return "-" if message.refused else difference(program.words[:, [0, 1, 2, 4, 3]], message) or "agree"


@pytest.mark.rs274
@needs_rs274
def test_every_example_of_linuxcnc_agrees_or_is_refused_by_name() -> None:
    message = {file: verdict(file.read_bytes(), file) for file in EXAMPLES}
    reported = {file.name: one for file, one in message.items() if one not in ("agree", "refused", "-")}
    counts = {name: sum(one == name for one in message.values()) for name in ("agree", "refused", "-")}
    print(counts)
    assert not reported and (not message or counts["agree"] >= 10)


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("file", FORMS, ids=[file.stem for file in FORMS])
def test_subprograms_of_linuxcnc_called_with_their_usual_values_agree_or_are_refused(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(interpreter, "MOST", 100_000)
    text = "".join(
        one.read_text(errors="replace") + "\n" for one in sorted((file.parent / "utilitysubs").glob("*.ngc"))
    )
    usual = re.findall(r"= *#(\d+) *\((?:=) *([-+0-9.]+)", file.read_text(errors="replace"))
    given = {int(number): value for number, value in usual}
    arguments = " ".join(f"[{given.get(k, '0')}]" for k in range(1, max(given, default=0) + 1))
    text += "".join(one.read_text(errors="replace") + "\n" for one in FORMS)
    text = re.sub(
        "#5410|#<_feature:>|#<_remaining_features:>", "#4000", text
    )  # the tool's diameter, which the machine knows
    text = re.sub(
        r"(?i)\bg4[12](\.1 *d *\S+)?(?![0-9.])|\bm110\b.*|\bg59\.3\b", "", text
    )  # compensation, a window's own code
    text += f"#4000=0.05\nF100 M3 S100\nG0 X0 Y0 Z10 A0 C0\no<{file.stem}> call {arguments}\nM2\n"
    (tmp_path / "call.ngc").write_text(text.replace("\n%\n", "\n"))
    one = verdict((tmp_path / "call.ngc").read_bytes(), tmp_path / "call.ngc")
    print(file.stem, one)
    assert one in ("agree", "refused", "-")


PIECES = [
    "o1 sub",
    "o1 endsub",
    "o1 call [1]",
    "o1 call",
    "o2 if [#1 GT 0]",
    "o2 else",
    "o2 endif",
    "o3 while [#2 LT 3]",
    "o3 endwhile",
    "#2=[#2+1]",
    "#1=#2",
    "o4 repeat [2]",
    "o4 endrepeat",
    "o3 break",
    "o3 continue",
    "o1 return [3]",
    "G1 X#1 Y[#2]",
    "G81 X1 Z-1 R2",
    "X3",
    "G80",
    "M98 P7",
    "O7",
    "M99",
    "GOTO 3",
    "N3 G1 Z1",
    "WHILE [#1 LT 2] DO1",
    "END1",
    "IF [#1 EQ 1] THEN #2=2",
    "IF [#1 EQ 1] GOTO 3",
    "G65 P7 A1",
    "M2",
    "G91",
    "G90",
    "/#1=1",
    "O<",
    "#<",
    "[",
    "]",
    "#",
    "=",
    "o1",
    "IF",
    "DO",
    "#1=[",
    "X[SIN[",
    "M97 P3",
    "O7 G83 Q1",
]


@pytest.mark.oldest
@pytest.mark.thorough
@given(st.lists(st.sampled_from(PIECES), max_size=14), st.sampled_from(["linuxcnc", "haas", "fanuc"]))
@settings(max_examples=300, deadline=None)
def test_nothing_but_clear_errors_comes_of_any_text(pieces: list[str], controller: str) -> None:
    most, interpreter.MOST = interpreter.MOST, 20_000
    try:
        program = read(HEAD + "\n".join(pieces) + "\n", controller)
        assert np.isfinite(program.words).all() and program.line.max() <= 2 + max(len(pieces), 1)
    except FiveAxisError:
        pass
    finally:
        interpreter.MOST = most
