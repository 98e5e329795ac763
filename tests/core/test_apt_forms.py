# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files in the forms that other CAM systems print, in the encodings that other systems write, and spoilt
at random."""

from __future__ import annotations

import contextlib
import re

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core.base.errors import FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClHead, ClReading, read_apt, read_cl_file, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

RAPID, CUT = Motion.RAPID, Motion.CUT

CATIA = b"""$$ -----------------------------------------------------------------
$$     CATIA APT VERSION 1.0
$$*CATIA0
$$ Manufacturing Program.1
$$    1.00000    0.00000    0.00000    0.00000
PARTNO Part Operation.1
COOLNT/ON
CUTCOM/OFF
PPRINT OPERATION NAME : Tool Change.1, COSTS 5$
$$ TOOLCHANGEBEGINNING
CUTTER/ 12.000000,  2.000000,  4.000000,  2.000000,  0.000000,  0.000000, 50.000000
TOOLNO/1,MILL,   12.000000
TPRINT/T1 End Mill D 12,,T1 End Mill D 12
LOADTL/1,1
MULTAX
FEDRAT/  300.0000,MMPM
SPINDL/   70.0000,RPM,CLW
RAPID
GOTO  /   10.00000,   20.00000,   30.00000, 0.000000, 0.000000, 1.000000
GOTO  /   10.00000,   20.00000,    5.00000, 0.000000, 0.600000, 0.800000
FEDRAT/ 1000.0000,MMPM
GOTO  /   11.00000,   20.00000,    5.00000, 0.000000, 0.600000, 0.800000
$$ End of generation of : Multi-Axis.1
SPINDL/OFF
REWIND/0
END
"""
NX = b"""TOOL PATH/VARIABLE_CONTOUR,TOOL,BALL_MILL
TLDATA/MILL,12.0000,2.0000,75.0000,0.0000,0.0000
MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000
$$ centerline data
PAINT/PATH
PAINT/SPEED,10
LOAD/TOOL,1
SELECT/TOOL,1
SPINDL/RPM,70,CLW
COOLNT/ON
PAINT/COLOR,186
RAPID
GOTO/10.0000,20.0000,30.0000,0.0000000,0.0000000,1.0000000
PAINT/COLOR,42
FEDRAT/MMPM,300.0000
GOTO/10.0000,20.0000,5.0000,0.0000000,0.6000000,0.8000000
FEDRAT/1000.0000
GOTO/11.0000,20.0000,5.0000
PAINT/SPEED,10
END-OF-PATH
"""
CREO = b"""$$*         Pro/CLfile  Version 7.0 - H03
$$-> MFGNO / PART
PARTNO / PART
$$-> FEATNO / 25
MACHIN / UNCX01, 1
$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER
UNITS / MM
LOADTL / 1
$$-> CUTTER / 12.000000
$$-> CSYS / 1.0000000000, 0.0000000000, 0.0000000000, 0.0000000000, $
            0.0000000000, 1.0000000000, 0.0000000000, 0.0000000000, $
            0.0000000000, 0.0000000000, 1.0000000000, 0.0000000000
MULTAX / ON
SPINDL / RPM, 70.000000,  CLW
COOLNT / ON
RAPID
GOTO / 10.0000000000, 20.0000000000, 30.0000000000, $
0.0000000000, 0.0000000000, 1.0000000000
FEDRAT / 300.000000,  MMPM
GOTO / 10.0000000000, 20.0000000000, 5.0000000000, $
0.0000000000, 0.6000000000, 0.8000000000
FEDRAT / 1000.000000,  MMPM
GOTO / 11.0000000000, 20.0000000000, 5.0000000000
SPINDL / OFF
FINI
"""
MASTERCAM = b"""$$ MASTERCAM APT
PARTNO PART
MACHIN/POST,1
UNITS/INCHES
CLPRNT
INTOL/ .001
OUTTOL/ .001
LOADTL/ 1, LENGTH, 0
CUTTER/ .47244094488, .0787401574803
SPINDL/ 70, RPM, CLW
COOLNT/ FLOOD
MULTAX/ ON
RAPID
FROM/ .393700787402, .787401574803, 1.18110236220, 0, 0, 1
FEDRAT/ 11.8110236220, IPM
GOTO/ .393700787402, .787401574803, .196850393701, 0, .6, .8
FEDRAT/ 39.3700787402
GODLTA/ .0393700787402, 0, 0
FINI
"""
FORMS = {"catia": CATIA, "nx": NX, "creo": CREO, "mastercam": MASTERCAM}
EVERY = pytest.mark.parametrize("text", FORMS.values(), ids=FORMS)


@EVERY
def test_the_same_path_comes_out_of_every_systems_form(text: bytes) -> None:
    file = read_cl_file(text)
    assert np.allclose(file.path.tip, [[10, 20, 30], [10, 20, 5], [11, 20, 5]], atol=1e-9)
    assert np.allclose(file.path.axis, [[0, 0, 1], [0, 0.6, 0.8], [0, 0.6, 0.8]])
    assert file.path.motion.tolist() == [RAPID, CUT, CUT]
    assert np.allclose(file.path.feed, [0, 300, 1000], atol=1e-6)
    assert file.path.findings == ()
    assert (file.head.tool, file.head.speed, file.head.coolant) == (1, 70.0, True)


def test_the_cutter_is_stated_in_mm_where_it_is_stated() -> None:
    assert [read_cl_file(FORMS[name]).head.diameter for name in ("catia", "creo")] == [12.0, 0.0]
    assert read_cl_file(MASTERCAM).head.diameter == pytest.approx(12.0)
    assert read_cl_file(MASTERCAM).head.corner == pytest.approx(2.0)


ENCODINGS = {
    "windows": lambda text: text.replace(b"\n", b"\r\n"),
    "mac": lambda text: text.replace(b"\n", b"\r"),
    "bom": lambda text: b"\xef\xbb\xbf" + text,
    "latin-1": lambda text: text.replace(b"PARTNO", b"PARTNO D\xfcse \xb5 \xff"),
    "utf-8": lambda text: text.replace(b"PARTNO", "PARTNO Düse 日本".encode()),
    "utf-16": lambda text: text.decode().encode("utf-16"),
    "utf-16-be": lambda text: b"\xfe\xff" + text.decode().encode("utf-16-be"),
    "tabs": lambda text: re.sub(rb"([,/]) *", rb"\1\t ", text.replace(b"GOTO", b"\tGOTO")),
    "lower case": bytes.lower,
    "no blanks": lambda text: re.sub(
        rb"(?m)^((?:GOTO|FEDRAT|SPINDL|UNITS).*)", lambda line: line[0].replace(b" ", b""), text
    ),
    "leading zeros": lambda text: re.sub(rb"(?<![\d.])(\d+\.\d)", rb"000\1", text),
    "control-z": lambda text: text + b"\x1a",
}


@EVERY
@pytest.mark.parametrize("changed", ENCODINGS.values(), ids=ENCODINGS)
def test_the_system_that_wrote_the_file_does_not_matter(text: bytes, changed) -> None:
    assert changed(text) != text or b"\t" not in changed(text)
    path, plain = read_apt(changed(text)), read_apt(text)
    for name in ("tip", "axis", "motion", "feed", "pass_"):
        assert np.array_equal(getattr(path, name), getattr(plain, name))
    assert path.findings == plain.findings


def test_a_text_that_ends_in_a_dollar_does_not_swallow_the_next_line() -> None:
    assert len(read_apt(b"FEDRAT/9\nPPRINT COSTS 5$\nGOTO/1,2,3\n").tip) == 1
    assert len(read_apt(b"FEDRAT/9\nGOTO/1,2,$ 5$\n3\n").tip) == 1


def test_steps_add_up_from_the_last_place() -> None:
    text = b"FEDRAT/9\nGOTO/1,2,3\nGODLTA/1,0,0\nGODLTA/0,1,-1\nGOTO/5,5,5,0,0.6,0.8\nGODLTA/10\nGODLTA/1,1,1,1,0,0\nGODLTA/-2\n"
    path = read_apt(text)
    assert np.allclose(
        path.tip, [[1, 2, 3], [2, 2, 3], [2, 3, 2], [5, 5, 5], [5, 11, 13], [6, 12, 14], [4, 12, 14]]
    )
    assert np.allclose(path.axis[[0, 4, 5, 6]], [[0, 0, 1], [0, 0.6, 0.8], [1, 0, 0], [1, 0, 0]])
    inches = read_apt(b"UNITS/INCHES\n" + text.replace(b"FEDRAT/9", b"FEDRAT/9,MMPM"))
    assert np.allclose(inches.tip, 25.4 * path.tip)


def test_many_steps_agree_with_places() -> None:
    random = np.random.default_rng(3)
    place = np.round(random.uniform(-500, 500, (2000, 3)), 4)
    step = random.random(2000) < 0.7
    step[0] = False
    change = np.diff(place, axis=0, prepend=0)
    lines = [
        ("GODLTA/" if s else "GOTO/") + ",".join(f"{v:.4f}" for v in (d if s else p))
        for s, d, p in zip(step, change, place, strict=True)
    ]
    assert np.abs(read_apt("FEDRAT/5\n" + "\n".join(lines)).tip - place).max() < 1e-9


def test_tlaxis_holds_until_the_next_axis() -> None:
    path = read_apt(
        b"FEDRAT/9\nGOTO/0,0,0\nTLAXIS/0,0.6,0.8\nGOTO/1,0,0\nGOTO/2,0,0,1,0,0\nGOTO/3,0,0\nTLAXIS/0,0,1\nGOTO/4,0,0\n"
    )
    assert np.allclose(path.axis, [[0, 0, 1], [0, 0.6, 0.8], [1, 0, 0], [1, 0, 0], [0, 0, 1]])


def test_a_feed_per_turn_takes_the_spindles_speed() -> None:
    text = b"SPINDL/RPM,500,CLW\nFEDRAT/0.2,MMPR\nGOTO/0,0,0\nSPINDL/ON\nFEDRAT/0.01,IPR\nGOTO/1,0,0\nSPINDL/1000,CLW\nFEDRAT/PERREV,.1\nGOTO/2,0,0\n"
    assert np.allclose(read_apt(text).feed, [100, 127, 100])
    with pytest.raises(ProgramError, match=r"line 2, .*spindle"):
        read_apt(b"SPINDL/OFF\nFEDRAT/0.2,MMPR\nGOTO/0,0,0\n")


@pytest.mark.parametrize(
    ("statements", "code", "severity", "line"),
    [
        (b"CIRCLE/1,2,3,0,0,1,5\nGOTO/2,2,3", "arc-does-not-fit", Severity.ERROR, 3),
        (b"CIRCLE/1,2,3,5\nGOTO/2,2,3", "statement-not-interpreted", Severity.ERROR, 3),
        (b"INDIRV/1,0,0\nTLON,GOFWD/ (CIRCLE/ 1,2,3,$\n5),ON,(LINE/1,2,3,4,5,6)", "arc-does-not-fit", Severity.ERROR, 3),
        (b"INDIRV/1,0,0\nTLON,GOFWD/ (CYLNDR/ 1,2,3,$\n5),ON,(LINE/1,2,3,4,5,6)", "statement-not-interpreted", Severity.ERROR, 3),
        (b"LOADTL/2\nGOTO/2,2,3\nLOADTL/3\nGOTO/2,2,4\nLOADTL/2", "several-tools", Severity.ERROR, 5),
        (b"MSYS/0,0,0,1,0,0,0,1,0\nGOTO/2,2,3\nMSYS/0,0,9,1,0,0,0,1,0", "several-coordinate-systems", Severity.ERROR, 5),
        (b"GOTO/2,2,3,0,1,0\nMULTAX/OFF\nGOTO/2,2,4", "axis-carried-on", Severity.WARNING, 5),
        (b"ORIGIN/0,0,5\nGOTO/2,2,4", "statement-not-interpreted", Severity.ERROR, 3),
        (b"CHECK THIS OUT", "statement-not-interpreted", Severity.WARNING, 3),
        (b"FINI\nGOTO/1,1,1", "text-after-end", Severity.NOTE, 4),
    ],
)  # fmt: skip
def test_what_may_spoil_the_part_is_reported_with_its_line(
    statements: bytes, code: str, severity: Severity, line: int
) -> None:
    found = read_apt(b"FEDRAT/9\nGOTO/1,2,3\n" + statements + b"\n").findings
    assert (code, severity, line) in [(one.code, one.severity, one.line) for one in found]


@pytest.mark.parametrize(
    "statement",
    [
        "ORIGIN/0,0,0",
        "CYCLE/OFF",
        "MULTAX/OFF",
        "LOADTL/1",
        "MSYS/0,0,0,1,0,0,0,1,0",
        "TRACUT/NOMORE",
        "FINISH/3",
    ],
)
def test_what_changes_nothing_is_not_reported(statement: str) -> None:
    found = read_apt(f"FEDRAT/9\n{statement}\nGOTO/1,2,3\n{statement}\nGOTO/1,2,4\n").findings
    assert [one.code for one in found] == (["statement-not-interpreted"] if statement == "FINISH/3" else [])


def test_the_lines_of_a_statement_that_is_not_interpreted_are_listed() -> None:
    text = "FEDRAT/9\n" + "GOTO/1,2,3\nFOO/1\n" * 7
    (found,) = read_apt(text).findings
    assert "7 statements, lines 3, 5, 7, 9, 11 ..." in found.text and found.value == 7
    many = read_apt(
        "FEDRAT/9\nGOTO/1,2,3\n"
        + "\n".join(f"W{letter}{other}/1" for letter in "ABCDEF" for other in "ABCDEF")
    ).findings
    assert len(many) == 21 and "16 further words" in many[-1].text


@pytest.mark.parametrize(
    ("text", "where"),
    [
        (b"GOTO/1,2,3\nGODLTA/1,2\n", "line 2"), (b"GODLTA/1,2,3\n", "line 1, column 1"), (b"GOTO 1,2,3\nGOTO/1,2,3\n", "line 1, column 1"),
        (b"PARTNO\nGOTO/1,2,3,0,1\n", "line 2"), (b"GOTO/P1\n", "line 1, column 6"), (b"GOTO/1,2,3\n\n\tGOTO/1,2,\t1..2\n", "line 3, column 12"),
        (b"GOTO/1,2,3\r\nGOTO/1,\0002,3\r\n", "line 2, column 8"), (b"\x89PNG\r\n\x1a\n\0\0IHDR", "line 2, column 1"),
        (b"GOTO/1,2,3\nFEDRAT/\n", "line 2"), (b"TLAXIS/0,0,0\nGOTO/1,2,3\n", "line 2"), (b"", "line 1, column 1"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_names_line_and_column(text: bytes, where: str) -> None:
    with pytest.raises(ProgramError) as caught:
        read_apt(text)
    assert where in str(caught.value) and "\n" not in str(caught.value)


def test_tool_spindle_and_coolant_are_written_and_read_back() -> None:
    head = ClHead(tool=7, speed=12000.0, coolant=True, diameter=6.0, corner=3.0)
    tip, axis = np.array([[0.0, 0, 5], [1, 0, 0]]), np.tile((0.0, 0.6, 0.8), (2, 1))
    motion, none = np.array([RAPID, CUT], np.int8), np.full(2, -1)
    path = CLPath(tip, axis, motion, np.array([0.0, 500.0]), tip, axis, none, none, none)
    text = write_apt(path, Cutter(6.0), "part", head=head)
    assert read_cl_file(text).head == head and read_cl_file(text).path.findings == ()
    assert read_cl_file(write_apt(path, Cutter(6.0), "part", head=ClHead())).head.tool is None


def big(lines: int) -> bytes:
    """A CL file as chatty as they come: a feed and a remark of its own at every place."""
    numbers = np.random.default_rng(1).uniform(-100, 100, (lines // 3, 3))
    rows = [
        f"PPRINT MOVE {k}\nFEDRAT/{500 + k % 7},MMPM\nGOTO/{x:.4f},{y:.4f},{z:.4f},0,0.6,0.8"
        for k, (x, y, z) in enumerate(numbers)
    ]
    return "\n".join(rows).encode()


def test_reading_gives_what_splitting_and_converting_in_plain_python_gives() -> None:
    """How long either takes: benchmarks/bench_apt.py."""
    text = big(99_000)
    path = read_apt(text)
    plain = [
        [float(part) for part in line[5:].split(b",")]
        for line in text.split(b"\n")
        if line.startswith(b"GOTO/")
    ]
    assert np.array_equal(np.array(plain)[:, :3], path.tip)


WORDS = ["GOTO/", "GODLTA/", "FROM/", "FEDRAT/", "UNITS/", "SPINDL/", "TLAXIS/", "LOADTL/", "CUTTER/", "MULTAX", "RAPID", "FINI", "MSYS/",
         "PPRINT", "REMARK ", "$", "$$", "$$->", "\n", "\r\n", "\r", ",", "/", "1", "-2.5", "1E5", "1E999", ".", "INCHES", "MMPR", "OFF", "\0",
         "\x1a", "é", "\u2028", " ", "\t", "(", "CIRCLE/"]  # fmt: skip
STATEMENTS = [
    "GOTO/1,2,3", "GOTO/10,0,0,0,.6,.8", "GOTO/0,10,0", "GOTO/10,0,0", "GODLTA/1,2,3", "GODLTA/-2", "FROM/0,0,9", "RAPID", "FEDRAT/9", "FEDRAT/.1,IPR",
    "SPINDL/90", "UNIT/INCHES", "UNITS/MM", "CIRCLE/0,0,0,0,0,1,10", "CIRCLE/0,0,0,0,0,-1,10,1,1,1,1", "CIRCLE/0,0,0,0,0,0,1", "CIRCLE/0,0,0,1E200,0,1,1E300",
    "INDIRV/0,1,0", "INDIRV/1,0,0\nTLON,GOFWD/(CIRCLE/0,0,0,$\n10),ON,2,INTOF,(LINE/0,0,0,10,0,0)", "TLON,GOFWD/(CIRCLE/0,0,0,10),ON,(LINE/0,0,0,.,1,0)",
    "INDIRV/.,1,0\nTLON,GOFWD/(CIRCLE/-,0,0,10),ON,(LINE/0,0,0,0,0,1E999)", "CYCLE/DEEP,DEPTH,5,STEP,2,CLEAR,1,IPM,3", "CYCLE/DRILL,RAPTO,3,FEDTO,-3,RTRCTO,AUTO",
    "CYCLE/TAP,3", "CYCLE/OFF", "CYCLE/REAM,DEPTH,1E300,CLEAR,1E300,RETURN,1E308", "LOADTL/1", "LOADTL/2", "TOOLNO/-1E999", "TLDATA/MILL,1,1,1,1,1", "TLDATA/MILL,1E999,0,-1,90,1",
    "TOOL PATH/A,TOOL,B", "END-OF-PATH", "MULTAX/OFF", "TLAXIS/0,1,0", "FINI",
]  # fmt: skip


@settings(max_examples=300, deadline=None)
@given(
    st.lists(st.sampled_from(STATEMENTS), max_size=20).map("\n".join), st.sampled_from([None, None, 0, 1, 2])
)
def test_no_string_of_statements_gives_a_traceback(given_text: str, tool: int | None) -> None:
    with contextlib.suppress(ProgramError):
        path = read_apt(given_text, ClReading(feed=1.0, units="inch", tool=tool))
        assert np.allclose(np.linalg.norm(path.axis, axis=1), 1.0) and (path.feed >= 0.0).all()


@pytest.mark.thorough
@settings(max_examples=400, deadline=None)
@given(st.lists(st.sampled_from(WORDS), max_size=40).map("".join))
def test_no_string_of_words_gives_a_traceback(text: str) -> None:
    for given_text in (text, text.encode("latin-1", "replace"), "GOTO/1,2,3\n" + text, text.encode("utf-16")):
        try:
            read_apt(given_text, ClReading(feed=1.0))
        except FiveAxisError as error:
            assert "\n" not in str(error) and re.match(r"line \d+, column \d+", str(error))


@settings(max_examples=300, deadline=None)
@given(
    st.sampled_from(list(FORMS.values())),
    st.lists(st.tuples(st.floats(0, 1), st.binary(max_size=4)), min_size=1, max_size=6),
)
def test_no_spoilt_file_gives_a_traceback(text: bytes, spots: list[tuple[float, bytes]]) -> None:
    for where, piece in spots:
        at = int(where * len(text))
        text = text[:at] + piece + text[at + len(piece) :]
    try:
        read_apt(text, ClReading(feed=1.0))
    except FiveAxisError as error:
        assert "\n" not in str(error) and re.match(r"line \d+, column \d+", str(error))


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200))
def test_no_bytes_give_a_traceback(data: bytes) -> None:
    try:
        read_apt(data, ClReading(feed=1.0))
    except FiveAxisError as error:
        assert "\n" not in str(error)


def test_the_nc_head_takes_tool_speed_and_coolant_from_the_file_unless_the_options_say_otherwise(
    tmp_path,
) -> None:
    (tmp_path / "a.apt").write_bytes(CREO)
    given = {"machine": "trunnion_ac", "cutter": "ball:12", "output": str(tmp_path / "a.ngc")}
    draft = job.make(build_settings("post", str(tmp_path / "a.apt"), given))
    assert {b"T1", b"M6", b"H1", b"S70", b"M3", b"M8"} <= set(draft.nc.split())
    other = job.make(
        build_settings(
            "post", str(tmp_path / "a.apt"), given | {"tool": "5", "spindle": "9000", "cutter": "ball:10"}
        )
    )
    assert {b"T5", b"S9000", b"M8"} <= set(other.nc.split())
    assert "cutter-differs" not in {
        found.code for found in other.findings
    }  # this file says it in a comment only
    (tmp_path / "a.apt").write_bytes(CATIA)
    third = job.make(build_settings("post", str(tmp_path / "a.apt"), given | {"cutter": "ball:10"}))
    assert [found.value for found in third.findings if found.code == "cutter-differs"] == [12.0]


def test_a_path_through_the_cl_file_and_back_gives_the_same_program(tmp_path) -> None:
    (tmp_path / "a.apt").write_bytes(CATIA)
    given = {"machine": "trunnion_ac", "cutter": "ball:12", "output": str(tmp_path / "a.ngc")}
    draft = job.make(build_settings("post", str(tmp_path / "a.apt"), given))
    (tmp_path / "b.apt").write_bytes(
        write_apt(draft.path, Cutter(12.0), "again", head=read_cl_file(CATIA).head)
    )
    assert job.make(build_settings("post", str(tmp_path / "b.apt"), given)).nc == draft.nc
