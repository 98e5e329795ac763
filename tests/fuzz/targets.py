# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is fuzzed: each target has seeds, whole files that work, and a function that reads one as a user's
command would.

A target may take the file or refuse it with an error of ours in one line. Anything else is a flaw: another
exception, a warning of numpy's, a message of several lines, or more than the time that a small file may take.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.machine_file import machine_folder
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.job_file import read_job
from freecad_fiveaxis.core.pipeline.settings import build_settings

GOLDEN = Path(__file__).parents[1] / "golden"
LINES = 60
"""Of a seed, so that one run takes some hundredths of a second."""


@dataclass(frozen=True)
class Target:
    """``seeds``: whole files; ``read``: takes the path of a spoilt one; ``ending`` of its name."""

    seeds: tuple[bytes, ...]
    read: Callable[[Path], object]
    ending: str


def _short(path: Path) -> bytes:
    return b"\n".join(path.read_bytes().split(b"\n")[:LINES]) + b"\n"


def _audit(controller: str) -> Callable[[Path], object]:
    return lambda path: job.run(
        build_settings("audit", str(path), {"machine": "trunnion_ac", "controller": controller})
    )


FOREIGN = {
    "linuxcnc": (
        b"G21 G90 G17 G94\nG0 X0 Y0 Z20 A0 C0\nF200\n#1=5\n#<depth>=-2.5\nG98 G81 X[#1*2] Y0 Z#<depth> R3\nX20\nG83 Y10 Z-8 R2 Q1.5\nG80\n"
        b"o100 while [#1 GT 0]\nG1 X#1 A[#1*2]\n#1=[#1-1]\no100 endwhile\nG2 X5 Y5 I2.5 J2.5\nG4 P0.5\nM66E0L0\n(msg, hello)\nM2\n",
        b"G21 G90 G94 F500\nG0 X0 Y0 Z50 A0 C0\nG12.1 P0\nG43.5 H1\nG1 X1 I0 J0.5 K0.8\nG13.1\nG1 Z90\nG12.1 P2\nG1 X3\nM2\n",
        b"O10 SUB\nG1 X#1 F100\nO10 ENDSUB\nG90\nG0 X0 Y0 Z5 A0 C0\nO10 CALL [7]\nO20 IF [#5 EQ 0]\nG1 C10\nO20 ELSE\nG1 C20\nO20 ENDIF\nM2\n",
    ),
    "fanuc": (b"%\nO1234 (PART)\nG90 G21 G17 G94\nG0 X0. Y0. Z20. A0. C0.\n#100=3\nWHILE[#100GT0]DO1\nG1 X#100 F200.\n#100=#100-1\nEND1\nG43.4 H1\n"
              b"G1 X5. A10. C20.\nG49\nG91 G28 Z0.\nM98 P2000\nM30\nO2000\nG90 G1 Y5.\nM99\n%\n",
              b"============\nInformation listing created by : me\nNode name : a\n============\n%\nOFinal ToolPath\n: G17\nG90 G21 G94\nG0 X0. Y0. Z20. A0. C0.\n"
              b"G1 X5. F100.\nM30\n%\n\x03",
              b"O1 (A)\nG90 G21 G94\nG0 X0. Y0. Z20. A0. C0.\nG05 P10000\nG1 X5. F100.\nG05 P0\nX15. ,R2.\nY9. ,C1.5\nX0 ,R1.\nG2 X3. Y2. R9.\nG1 X9. ,A30.\nM30\n",
              b"O1 (ROWS)\nG90 G21 G94\nG0 X0. Y0. Z20. A0. C0.\nG99 G81 X5. Y5. R2. Z-10. F100.\nG91 X10. K3\nG90 X3.\nG91 G83 X1. R-5. Z-9. Q4. K2\n"
              b"G90 G80\nM30\n"),
    "haas": (b"%\nO10 (OURS)\nG00 G17 G40 G80 G90 G94 G21\nG53 G00 Z0.\nT3 M06\nS6000 M03\nG54\nM11\nG00 A30. C40.\nM10\nG254\nG00 X7. Y3.\nG43 Z50. H03\n"
             b"G01 Z-1. F800.\nX9.\nG255\nG53 G00 Z0.\nG00 A0. C0.\nG93\nG234 H03 X0. Y0. Z60.\nG01 X5. A12. C25. F90.\nG94\nG49\nG53 G00 Z0.\nM30\n%\n",),
    "siemens840d": (b"; PART\nG710 G90 G17\nR1=5 R2=R1+1\nTRAORI\nG0 X0 Y0 Z0 A=0 C=0\nG1 X=R1 Y=R2 A=DC(10) F100\nG1 X=IC(1) A3=0 B3=0.1 C3=0.99\nTRAFOOF\n"
                    b"CYCLE800(0,\"\",0,57,0,0,0,0,0,0,0,0,0,1)\nG1 X20 RND=2\nY9 CHR=1\nX3 RND=0.5\nG2 X3 Y3 I1 J1\nG1 X9 ANG=30 CHF=0.5\nANG=100\nX0 Y9 ANG=170\nM30\n",),
    "heidenhain": (b"0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+20 A+0 C+0 FMAX\n2 M128\n3 L X+1 Y-2.5 A+3 R0 F100\n4 CC X+0 Y+0\n5 C X+2 Y+0 DR+\n6 LN X+1 Y+1 Z+1 "
                   b"TX+0.1 TY+0 TZ+0.99\n7 M129\n8 Q1 = 5\n9 L IX+1 FMAX M140 MB MAX\n10 END PGM A MM\n",
                   b"0 BEGIN PGM B MM\n1 CALL LBL 1\n2 L X+0 Y+0 Z+90 A+0 C+0 R0 FMAX\n3 PLANE SPATIAL SPA90 SPB0 SPC180 STAY SEQ- TABLE ROT\n"
                   b"4 L A+Q120 C+Q122 R0 FMAX M126\n5 L X1 Y2 Z3 F100\n6 M30\n7 LBL 1\n8 PLANE RESET STAY\n9 LBL 0\n10 END PGM B MM\n",
                   b"0 BEGIN PGM C MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n2 CYCL DEF 392 ATC~\n  Q240=0 ;MODE~\n  Q241=1\n3 M202(0.0024)\n"
                   b"4 CYCL DEF9.0 DWELL\n5 CYCL DEF9.1 DWELL2\n6 L X+1 F100\n7 END PGM C MM\n",
                   b"0 BEGIN PGM D MM\n1 ; / DM=6 CR=0\n2 TOOL CALL 5 Z S500 DL+0.1\n3 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n4 CYCL DEF 247 ~\n  Q339=+1\n"
                   b"5 CYCL DEF 208 BORE ~\n Q200=2 ~\n Q201=-9 ~\n Q206=150 ~\n Q334=5 ~\n Q203=1 ~\n Q204=30 ~\n Q335=16 ~\n Q351=1\n6 L X+5 Y+6 FMAX M99\n"
                   b"7 CYCL DEF 1.0 PECKING\n8 CYCL DEF 1.1 SET UP -2\n9 CYCL DEF 1.2 DEPTH -9\n10 CYCL DEF 1.3 PECKG -5\n11 CYCL DEF 1.5 F80\n12 CYCL CALL\n"
                   b"13 CYCL DEF 207 TAP ~\n Q200=2 ~\n Q201=-9 ~\n Q203=1 ~\n Q239=1\n14 CYCL CALL\n15 CYCL DEF 241 LIP ~\n Q200=2 ~\n Q201=-9 ~\n Q203=1 ~\n Q206=9\n"
                   b"16 CYCL CALL\n17 END PGM D MM\n",
                   b"0 BEGIN PGM E MM\n1 L X+30 Y+20 Z+20 A+0 C+0 R0 FMAX\n2 CC X+20 Y+20\n3 CP IPA+1080 IZ-9 DR+ F100\n4 LP PR+5 IPA-30\n5 CC IX+1 IY-2\n"
                   b"6 CP PA+90 DR-\n7 END PGM E MM\n",),
}  # fmt: skip
"""Programs as other systems write them, by controller; some of it is refused by name."""

CL = (
    b"PARTNO TEST\nUNITS/MM\nCUTTER/10,5\nMULTAX/ON\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,20,0,0,1\nGOTO/10,0,0,0,0.1,0.99\n"
    b"CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0,0,0,1\nGOTO/5,5,1,0.2,0,0.97\nFINI\n",
    b"TOOL PATH/A,TOOL,T\nTLDATA/MILL,10.0000,5.0000,75.0000,0.0000,0.0000\nMSYS/0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0\n$$ centerline data\nPAINT/PATH\n"
    b"LOADTL/1\nFEDRAT/MMPM,250.0\nGOTO/30.0,20.0,10.0,0.0,0.0,1.0\nCYCLE/DRILL,RAPTO,3.0,FEDTO,-10.0,RTRCTO,3.0,MMPM,100.0\nGOTO/40.0,20.0,0.0\n"
    b"CYCLE/OFF\nEND-OF-PATH\n",
    b"$$ CATIA\nUNITS / MM\nMULTAX\nTLAXIS/ 0.0, 0.0, 1.0\nFEDRAT/ 1000.0,MMPM\nGOTO  /   1.0,   2.0,   3.0, 0.000000, 0.000000, 1.000000           00010000\n"
    b"INDIRV/ 1.0, 0.0, 0.0\nTLON,GOFWD/ (CIRCLE/   2.0,   3.0,   3.0,$\n   1.0),ON,2,INTOF,(LINE/   2.0,   3.0,   3.0,   3.0,   3.0,  3.0)\nGODLTA/1,0,0\nFINI\n",
    b"UNIT/MM\nCUTTER/6.,0,3.,0,0,0,57.\nLOAD/TOOL,3\nTRNTYP/WORLD,0,0,0\nCSYS/1.,0,0,0,0,1.,0,0,0,0,1.,0\nRAPID/\nGOTO/10.,0,25.\nFEDRAT/300.,MMPM\nCUTCOM/LEFT\n"
    b"CIRCLE/0,0,25.,0,0,1.\nGOTO/0,10.,20.\nCIRCLE/0,0,0,0,0,-1,10.,0.06,0.5,8.,0.,TIMES,2\nGOTO/10.,0,0\nCYCLE/INIT\n"
    b"CYCLE/DEEP2,FEDTO,9.,1STPECK,5.,SUBPECK,2.,MMPM,90.,RAPTO,3.,RTRCTO,25.\nGOTO/5.,5.,0\nCYCLE/OFF\nGOHOME/0,0,50.\nFINI\n",
)  # fmt: skip
JOBS = tuple(
    json.dumps(one).encode()
    for one in (
        {"task": "mill", "source": "part.stl", "machine": "trunnion_ac", "output": "o.ngc", "cutter": "bull:10:2", "scallop": 0.01, "shank": [[8, 20]],
         "tolerance": 0.01, "axis": [0, 0, 1], "report": ["r.json"], "linearize": "on", "gouge": "tilt", "lead": 5},
        {"task": "audit", "source": "a.nc", "machine": "trunnion_ac", "against": "part.stl", "units": "inch", "origin": "0,0,50", "method": "so2008"},
        {"task": "compare", "source": "a.apt", "machines": ["trunnion_ac", "head_bc.fcm"], "report": ["r.html"], "tool_length": "100 mm"},
    )
)  # fmt: skip
INI = (
    b"[KINS]\nKINEMATICS = xyzac-trt-kins\nJOINTS = 5\n[TRAJ]\nCOORDINATES = XYZAC\nLINEAR_UNITS = mm\n[HAL]\nHALFILE = k.hal\n[AXIS_X]\nMIN_LIMIT = -200\n"
    b"MAX_LIMIT = 200\n[AXIS_A]\nMIN_LIMIT = -100\nMAX_LIMIT = 50\nMAX_VELOCITY = 30\n[AXIS_C]\nMIN_LIMIT = -36000\nMAX_LIMIT = 36000\n",
)  # fmt: skip
HAL = b"loadrt xyzac-trt-kins\nsetp xyzac-trt-kins.y-offset 20\nsetp xyzac-trt-kins.z-offset -10\n"
STL = (
    b"solid box\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\nvertex 0 10 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 10 0 0\n"
    b"vertex 10 10 0\nvertex 0 10 0\nendloop\nendfacet\nendsolid box\n",
)
ARGUMENTS = (
    b"mill\npart.stl\n--machine\ntrunnion_ac\n-o\no.ngc\n--stepover\n2\n--cutter\nball:6", b"audit\na.nc\n--machine\ntrunnion_ac\n--tolerance\n0.01",
    b"setup\npart.stl\n--machine\ntrunnion_ac\n--region\n10,10,10\n--grid\n2,2,1", b"machines", b"strategies", b"prove-signs\n--machine\ntrunnion_ac\n-o\np.nc",
)  # fmt: skip
"""Command lines, a word each line; no file of them exists, so that only their reading is tried."""


def _post(path: Path) -> object:
    return job.run(build_settings("post", str(path), {"machine": "trunnion_ac", "output": "unused.ngc"}))


def _mill(path: Path) -> object:
    given = {"machine": "trunnion_ac", "output": "unused.ngc", "stepover": 2, "cutter": "ball:3:10"}
    return job.run(build_settings("mill", str(path), given))


def _machine(path: Path) -> object:
    from freecad_fiveaxis.core.machine import load_machine

    return load_machine(path)


def _ini(path: Path) -> object:
    path.with_name("k.hal").write_bytes(HAL)
    return import_machine(str(path))


def _command(path: Path) -> object:
    words = path.read_bytes().decode("utf-8", "surrogateescape").split("\n")
    here = Path.cwd()
    os.chdir(path.parent)  # for a spoilt name of an output has no folder of its own
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as message:
        try:
            code = main(
                [
                    str(path.parent / word) if "." in word and not word.startswith("-") else word
                    for word in words
                ]
            )
        except SystemExit as left:  # argparse
            code = left.code
        finally:
            os.chdir(here)
    if code not in (0, 1, 2):
        raise AssertionError(f"exit code {code}: {message.getvalue()}")
    return code


def _programs(controller: str) -> Target:
    """A controller's own programs here, and some as others write them."""
    own = tuple(_short(path) for path in sorted(GOLDEN.glob(f"{controller}_g*.nc")))
    return Target(own + FOREIGN.get(controller, ()), _audit(controller), ".nc")


TARGETS = {
    **{f"nc-{controller}": _programs(controller) for controller in sorted(DIALECTS)},
    "cl": Target(CL, _post, ".apt"),
    "job": Target(JOBS, lambda path: read_job(str(path)), ".json"),
    "machine": Target(
        tuple(path.read_bytes() for path in sorted(machine_folder().glob("*.fcm"))), _machine, ".fcm"
    ),
    "ini": Target(INI, _ini, ".ini"),
    "stl": Target(STL, _mill, ".stl"),
    "command": Target(ARGUMENTS, _command, ".txt"),
}
