# SPDX-License-Identifier: LGPL-2.1-or-later
"""Findings of one cause are one finding, the cause first; what has another cause stays beside it."""

from __future__ import annotations

from test_nc_cycles import errors, read

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.nc.reader.causes import fold

HEAD = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n"
HYPERMILL = (
    "2 CALL LBL 1\n3 FN 0:Q2=50\n4 PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\n5 L A+{} C+Q122 R0 FMAX\n6 CYCL DEF 200 DRILLING ~\n"
    "Q200=5 ~\nQ201=-5 ~\nQ206=Q2 ~\nQ202=5 ~\nQ203=0\n7 L X+1 Y+2 R0 FMAX M99\n8 L X+3 FQ2\n9 M30\n10 LBL 1\n11 PLANE RESET STAY\n12 LBL 0\n"
    "13 LBL 2\n14 FN 9: IF +Q1900 EQU +1 GOTO LBL 3\n15 FN 0: Q1901=4\n16 LBL 0\n"
)


def test_a_program_that_is_not_run_has_one_error_for_it() -> None:
    program = read(HEAD + HYPERMILL.format("Q99"), "heidenhain")
    assert errors(program) == ["macro-not-interpreted"] and program.findings[0].line == 6
    text = program.findings[0].text
    assert "Q99 was never set" in text
    for code in ("call-not-interpreted", "cycle-not-interpreted", "plane-not-taken", "feed-by-parameter"):
        assert code in text and code not in errors(program)
    assert not errors(read(HEAD + HYPERMILL.format("Q120"), "heidenhain"))


def test_what_has_another_cause_stays() -> None:
    program = read(HEAD + "2 WHATEVER 3\n3 RND R5\n4 L U+5 F100\n" + HYPERMILL.format("Q99"), "heidenhain")
    assert errors(program)[0] == "macro-not-interpreted"
    assert {"arc-not-interpreted", "unknown-axis", "unknown-code"} <= {
        found.code for found in program.findings
    }


def test_without_a_cause_or_with_nothing_under_it_all_stays() -> None:
    cause = Finding(Severity.ERROR, "macro-not-interpreted", "Why.", line=4)
    call, note = (
        Finding(Severity.ERROR, "call-not-interpreted", "Call.", line=2),
        Finding(Severity.NOTE, "read-as", "So."),
    )
    assert fold([call, note], None) == (call, note)
    assert fold([note, cause], cause) == (note, cause)
    folded = fold([call, note, cause], cause)
    assert [found.code for found in folded] == [
        "macro-not-interpreted",
        "read-as",
    ] and "call-not-interpreted (2)" in folded[0].text


def test_polar_circles_are_one_finding_whatever_their_numbers() -> None:
    text = "CC X+0 Y+0\n" + "".join(f"CP IPA+{angle} IZ-0.5 DR+ F100\n" for angle in range(10, 60, 10))
    program = read(HEAD + text + "L X+1\n", "heidenhain")
    found = [one for one in program.findings if one.code == "arc-not-interpreted"]
    assert len(found) == 1 and found[0].value == 5


def test_names_of_one_reason_are_one_finding_with_their_first_lines() -> None:
    iso = read("G90\nG0 X0 Y0 Z9 A0 C0\nG16\nG1 X1 F100\nG51 X2\nG16\nX3\nM30\n", "haas")
    (found,) = [one for one in iso.findings if one.code == "offset-not-interpreted"]
    assert (found.value, found.line) == (3.0, 3) and "G16 (3), G51 (5)" in found.text
    siemens = read(
        "G90 G710\nG0 X0 Y0 Z9 A0 C0\nMIRROR X0\nSCALE X2\nAMIRROR X0\nMIRROR Y0\nG1 X1 F100\nM30\n",
        "siemens840d",
    )
    (found,) = [one for one in siemens.findings if one.code == "offset-not-interpreted"]
    assert (found.value, found.line) == (4.0, 3)
    assert "MIRROR (3), SCALE (4), AMIRROR (5)" in found.text


def test_what_is_not_known_keeps_a_finding_each() -> None:
    program = read("G90 G710\nG0 X0 Y0 Z9 A0 C0\nX1 FOOBAR=2\nX2 BARFOO=3\nM30\n", "siemens840d")
    assert [one.code for one in program.findings].count("unknown-code") == 2


def test_a_program_of_siemens_or_iso_that_is_not_run_has_one_error_for_it() -> None:
    siemens = read(
        "G90 G710\nG0 X0 Y0 Z9 A0 C0\nIF NOBODY>2 GOTOF ENDE\nMYSUB2(1)\nMCALL CYCLE81(5,0,1,-3)\nX5\nENDE:\nG1 X1\nM30\n",
        "siemens840d",
    )
    assert errors(siemens)[0] == "macro-not-interpreted" and "call-not-interpreted" not in errors(siemens)
    iso = read("G90 G21\nG0 X0 Y0 Z9 A0 C0\nG1 X[#NOBODY] F100\nM98 P77\nX5\nM30\n", "haas")
    assert errors(iso) == ["macro-not-interpreted"]


def test_first_lines_are_those_of_the_file_where_a_program_is_written_out() -> None:
    text = "G90 G710\nG0 X0 Y0 Z9 A0 C0\nR1=0\nAGAIN:\nX=R1\nR1=R1+1\nIF R1<5 GOTOB AGAIN\nMIRROR X0\nSCALE X2\nX9\nM30\n"
    (found,) = [one for one in read(text, "siemens840d").findings if one.code == "offset-not-interpreted"]
    assert found.line == 8 and "MIRROR (8), SCALE (9)" in found.text
    iso = read(
        "G90\nG0 X0 Y0 Z9 A0 C0\n#1=0\nWHILE[#1LT5]DO1\n#1=#1+1\nG1 X#1 F9\nEND1\nG50.1 X0\nG51 X2\nX3\nM30\n",
        "fanuc",
    )
    (found,) = [one for one in iso.findings if one.code == "offset-not-interpreted"]
    assert found.line == 8 and "G50.1 (8), G51 (9)" in found.text
