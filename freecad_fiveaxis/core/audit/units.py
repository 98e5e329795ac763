# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a program, or the CL file beside it, is in another unit than it is read in.

radians   Rotary words are degrees. Where all of them lie within half a turn in radians, and read so the tip
          goes less than half the way that it goes by degrees, they are radians: linear words make up for
          turns that are 57 times as large. The other way round the tip would go farther, not less far.
bound     The tool axis turns by no more than both rotary words do: where a CL file's axis turns farther, they
          are no degrees.
inches    Sizes of two files that should be one, 25.4 apart; or travels that only a 25.4th of which the
          machine has.
"""

from __future__ import annotations

import re

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Angle, Length, Number, Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

INCH = 25.4
"""mm."""
HALF_TURN, LEAST_TURN = 3.15, 0.05
"""rad: no word in radians needs more; less than this of all of them turns nothing worth telling."""
SHORTER = 0.5
"""Of the way by degrees, that by radians."""
SAME_SIZE = 0.03
"""By which two sizes 25.4 apart may differ from that."""
FAR_LARGER = 12.0
"""A program that feeds so many times as far as the part is long does not mill it."""
FEWEST = 10
"""Steps of each file that sizes are compared by."""
IN_INCHES = re.compile(
    rb"(?<![A-Za-z0-9_])G0*(?:20|70|700)(?![0-9.])|^[^;\n]*BEGIN PGM [^\n]* INCH",
    re.IGNORECASE | re.MULTILINE,
)
"""Words that say inches: ISO, Siemens, klartext."""
REMARK = re.compile(rb"\([^)\n]*\)?|;[^\n]*")


def unit_findings(text: bytes, kinematics: Chain, program: Program) -> tuple[Finding, ...]:
    """Say of a program that it seems to have radians for degrees, or inches that must be mm; ``text``: of its
    file."""
    return (*_radians_by_way(kinematics, program), *_travels(text, kinematics, program))


def units_against(kinematics: Chain, program: Program, against: CLPath | Mesh) -> tuple[Finding, ...]:
    """Say that a program and the CL path or part that it is compared with seem to be in two units."""
    feeds = feed_blocks(program)
    if len(feeds) < FEWEST:
        return ()
    size = _size(forward_tip(kinematics, words_to_q(program.words[feeds])))
    if isinstance(against, Mesh):
        part = _size(against.vertex)
        return (_two_sizes(size, part, say("the part")),) if size > FAR_LARGER * part > 0.0 else ()
    return (
        *radians_by_axis(program, against),
        *_apart(size, _size(against.tip[against.motion != Motion.RAPID])),
    )


def units_of_steps(program: Program, path: CLPath) -> tuple[Finding, ...]:
    """Return the same where the machine is not known: by the steps during which nothing turns, which every
    machine makes as they are."""
    feeds = feed_blocks(program)
    still = ~(np.diff(program.words[:, 3:], axis=0) != 0.0).any(axis=1)
    moved = np.linalg.norm(np.diff(program.words[:, :3], axis=0), axis=1)[feeds - 1][still[feeds - 1]]
    held = (np.linalg.norm(np.diff(path.axis, axis=0), axis=1) < 1e-9) & (path.motion[1:] != Motion.RAPID)
    wanted = np.linalg.norm(np.diff(path.tip, axis=0), axis=1)[held]
    moved, wanted = moved[moved > 0.0], wanted[wanted > 0.0]
    found = radians_by_axis(program, path)
    if min(len(moved), len(wanted)) < FEWEST:
        return found
    return (*found, *_apart(float(np.median(moved)), float(np.median(wanted))))


def _size(place: Floats) -> float:
    """mm: the diagonal of the box around the places (n, 3)."""
    return float(np.linalg.norm(np.ptp(place, axis=0))) if len(place) else 0.0


def _apart(size: float, of_path: float) -> tuple[Finding, ...]:
    large, small = max(size, of_path), min(size, of_path)
    if small <= 0.0 or abs(large / small / INCH - 1.0) > SAME_SIZE:
        return ()
    return (_two_sizes(size, of_path, say("the CL path")),)


def _two_sizes(size: float, other: float, name: str) -> Finding:
    text = say(
        "The program goes over {size} where {name} goes over {other}, {times} times: one of them is read in "
        "inches and means mm, or the other way round. Give {option} where the file does not say its unit, "
        "else set right what it says.",
        size=Length(size, ".4g"),
        name=name,
        other=Length(other, ".4g"),
        times=Number(max(size, other) / min(size, other), ".3g"),
        option=Option("units"),
    )
    return report_finding(Code.UNIT_SUSPECTED, text, size, other, unit="mm")


def _could_be_radians(program: Program) -> bool:
    largest = float(np.abs(program.words[:, 3:]).max()) if len(program.words) else 0.0
    return LEAST_TURN <= largest <= HALF_TURN


def _radians_by_way(kinematics: Chain, program: Program) -> tuple[Finding, ...]:
    """By the tip's way over all feed blocks that turn."""
    feeds = feed_blocks(program)
    if program.guided is not None or not _could_be_radians(program):
        return ()
    turning = feeds[(program.words[feeds, 3:] != program.words[feeds - 1, 3:]).any(axis=1)]
    read_so = program.words.copy()
    read_so[:, 3:] = np.degrees(read_so[:, 3:])
    degrees, radians = (_way(kinematics, words, turning) for words in (program.words, read_so))
    if len(turning) < FEWEST or not radians < SHORTER * degrees:
        return ()
    text = say(
        "All rotary words lie within {most}, and read as radians the tip goes {radians} instead of "
        "{degrees}: they seem to be radians, where controllers take degrees. Have the post write degrees.",
        most=Number(HALF_TURN, ".3g"),
        radians=Length(radians, ".4g"),
        degrees=Length(degrees, ".4g"),
    )
    return (
        report_finding(
            Code.UNIT_SUSPECTED, text, radians, degrees, line=int(program.line[turning[0]]), unit="mm"
        ),
    )


def _way(kinematics: Chain, words: Floats, blocks: Floats | Bools) -> float:
    tip = forward_tip(kinematics, words_to_q(words))
    return float(np.linalg.norm(tip[blocks] - tip[np.asarray(blocks) - 1], axis=1).sum())


def radians_by_axis(program: Program, path: CLPath) -> tuple[Finding, ...]:
    """By how far the CL path's tool axis turns, whatever the machine."""
    feeds, axis = feed_blocks(program), path.axis[path.motion != Motion.RAPID]
    if program.guided is not None or not _could_be_radians(program) or not len(feeds) or not len(axis):
        return ()
    turned = float(np.ptp(program.words[feeds, 3:], axis=0).sum())
    wanted = 2.0 * float(np.degrees(np.arcsin(min(np.linalg.norm(axis - axis[0], axis=1).max() / 2.0, 1.0))))
    if not 1.05 * turned + 1.0 < wanted <= 1.05 * np.degrees(turned) + 1.0:
        return ()
    text = say(
        "The tool axis of the CL path turns by {wanted}, the rotary words by {turned} in all: no degrees, "
        "but radians would do. Have the post write degrees.",
        wanted=Angle(wanted, ".4g"),
        turned=Number(turned, ".4g"),
    )
    return (
        report_finding(
            Code.UNIT_SUSPECTED, text, turned, wanted, line=int(program.line[feeds[0]]), unit="deg"
        ),
    )


def _travels(text: bytes, kinematics: Chain, program: Program) -> tuple[Finding, ...]:
    """By travels beyond what the machine has, in a program that says inches."""
    feeds = feed_blocks(program)
    if not len(feeds) or program.guided is not None or not IN_INCHES.search(REMARK.sub(b"", text)):
        return ()
    goes, has = (
        np.ptp(program.words[feeds, :3], axis=0),
        np.asarray(kinematics.high[:3] - kinematics.low[:3], float),
    )
    if not (goes > has).any() or (goes > INCH * has).any():
        return ()
    k = int((goes / has).argmax())
    found = say(
        "The program says inches, and by that {letter} goes over {goes}, where the machine has {has}: its "
        "numbers seem to be mm ({mm}). Set right what the program says of its unit.",
        letter=program.letters[k],
        goes=Length(goes[k], ".4g"),
        has=Length(has[k], ".4g"),
        mm=Length(goes[k] / INCH, ".4g"),
    )
    return (
        report_finding(
            Code.UNIT_SUSPECTED,
            found,
            float(goes[k]),
            float(has[k]),
            line=int(program.line[feeds[0]]),
            unit="mm",
        ),
    )
