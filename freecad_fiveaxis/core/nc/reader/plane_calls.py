# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one line says of a tilted working plane: where its zero is, how it is turned, and who turns the rotary
axes.

G68.2 X Y Z I J K    zero, and Euler angles: I about Z, J about the X so turned, K about the Z so turned
                     (Fanuc B-63942EN/02, 5.44, tilted working plane command; the same order as PLANE EULER).
                     G53.1 then turns the tool to its normal. P1: about X, Y, Z, where one angle alone is told
                     (Mazak VORTEX i, programming: roll, pitch and yaw angles).
PLANE SPATIAL        SPA, SPB, SPC about X, then Y, then Z of the untilted system; EULER as above; VECTOR:
                     base vector B along X, normal N; RELATIV: one angle, on from the plane that is on. The
                     zero stays (Heidenhain TNC 620, Klartext, 10/2017, 13.2; iTNC 530, 9.2, 9.4, 9.5).
CYCLE800             (FR, "TC", ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, ...): zero X0 Y0 Z0, turns one
                     after the other about axes already turned, zero X1 Y1 Z1 in the plane so turned. MODE:
                     two bits for the axis of each turn, the first lowest (27 = Z Y X, 39, 45, 30, 54, 57 = X
                     Y Z). All angles 0: back to the basic position (Siemens 840D sl, 6FC5398-7CP41, 10.6).
                     ST with 1 at its end: all of it in the plane that is on ("additive"), from there on.

Not looked up in a manual: DIR 0 leaves the axes, all angles 0 drive them back, the meaning of ST, DIST of
MOVE; and that Fanuc's angles are about Z, X, Z, as posts write them (FreeCAD CAM's too). Check them on the
control.

Other forms (three points, projection and axis angles, SYM) are not known here, and named.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say

STAY, TURN, MOVE = "stay", "turn", "move"
"""Nobody turns the rotary axes; they turn and X Y Z stand; the tip keeps its place in the work."""
FANUC, HEIDENHAIN, SIEMENS, HAAS = "fanuc", "heidenhain", "siemens", "haas"
"""Whose rule picks one of the two ways to stand; Haas' picks none (:mod:`.dynamic_offset`)."""
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
ENTRY = re.compile(rf"(SP[ABC]|EUL(?:PR|NU|ROT)|[BN][XYZ]) *({NUMBER})")
REST = re.compile(
    rf"TURN|MOVE|STAY|SEQ *[-+]|(?:TABLE|COORD) *ROT|(ABST|DIST|MB) *({NUMBER}|MAX)|F *MAX|F *AUTO|F "
    rf"*{NUMBER}"
)
ROLL_PITCH_YAW = 1.0
"""P of G68.2 for angles about X, Y, Z."""
RELATIVE = "RELATIV"
FORMS = {
    "SPATIAL": ("SPA", "SPB", "SPC"),
    "EULER": ("EULPR", "EULNU", "EULROT"),
    RELATIVE: ("SPA", "SPB", "SPC"),
    "VECTOR": ("BX", "BY", "BZ", "NX", "NY", "NZ"),
}
MOST_ARGUMENTS = 16
FARTHEST = 1e7
"""mm, deg; a value beyond this is no place of any machine."""
POLE_STATES = (0, 100_000, 200_000)
"""ST: the hundred thousands say which way the axes take at the pole, where the plane is the same."""
ON = 1
"""ST: its last digit for a plane on from the one that is on, 0 for a new one."""


@dataclass(frozen=True)
class Change:
    """What a line of Heidenhain's ``cycle`` 8, 10, 11 or 26 says: ``factors`` of X, Y and Z, ``angle`` deg,
    ``on`` from the one before; ``about`` (3,) in the program's unit."""

    cycle: str
    factors: tuple[float, float, float] = (1.0, 1.0, 1.0)
    angle: float = 0.0
    on: bool = False
    about: tuple[float, float, float] = (0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Tilt:
    """``turn`` (3, 3): the plane's axes as columns, None where the plane ends; ``origin`` (3,) in the
    program's unit, ``shift`` (3,) in the plane; ``move``: of :data:`STAY`, :data:`TURN`, :data:`MOVE`;
    ``side``: -1 or 1 for the sign of the first axis, 0 where the line does not say; ``back``: to where both
    rotary words are 0; ``relative``: on from the plane that is on; ``away``: it draws the tool back before;
    ``table``: a free axis of the table turns with the plane; ``refused``: why it is not understood; ``name``:
    how it is called; ``frame``: coordinates alone, of the tip where the control guides it, else of the
    axes; ``change``: no plane, but what :mod:`.heidenhain_frames` makes one of; ``angles`` deg of cycle 19,
    by their letters (:mod:`.old_working_plane`)."""

    rule: str
    turn: Floats | None = None
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    move: str = STAY
    side: int = 0
    dist: float = 0.0
    back: bool = False
    relative: bool = False
    away: bool = False
    table: bool = False
    refused: str = ""
    name: str = ""
    frame: bool = False
    change: Change | None = None
    angles: tuple[tuple[str, float], ...] = ()


def beyond(values: Sequence[float]) -> str:
    """Why values are none, where one of them is beyond :data:`FARTHEST`."""
    return "" if all(abs(value) <= FARTHEST for value in values) else say("a value beyond all words")


def about(axis: int, degrees: float) -> Floats:
    """Return the turn (3, 3) about X, Y or Z (0, 1, 2); exact for quarter turns."""
    quarter = degrees % 360.0 / 90.0
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    if quarter == int(quarter):
        cos, sin = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter)]
    matrix = np.eye(3)
    one, two = (axis + 1) % 3, (axis + 2) % 3
    matrix[[one, two], [one, two]] = cos
    matrix[one, two], matrix[two, one] = -sin, sin
    return matrix


def one_by_one(axes: Sequence[int], degrees: Sequence[float]) -> Floats:
    """Return turns (3, 3) one after the other, each about an axis already turned."""
    first, second, third = (about(axis, angle) for axis, angle in zip(axes, degrees, strict=True))
    return first @ second @ third


def turn_about_one(degrees: Sequence[float]) -> Floats | None:
    """Fanuc's and Mazak's G68.2 P1: I, J, K about X, Y, Z. Where one of them is not 0 its order (Q) says
    nothing; None where more are."""
    turned = [axis for axis, angle in enumerate(degrees) if angle]
    if len(turned) > 1:
        return None
    return about(turned[0], degrees[turned[0]]) if turned else np.eye(3)


def euler(degrees: Sequence[float]) -> Floats:
    """Fanuc's I J K, Heidenhain's EULPR EULNU EULROT: about Z, X, Z."""
    return one_by_one((2, 0, 2), degrees)


def by_vectors(base: Floats, normal: Floats) -> Floats | None:
    """Z along ``normal`` (3,), X along ``base`` (3,) as far as it lies in the plane; None where the two are
    no plane."""
    across = np.cross(normal, base)
    if not np.linalg.norm(across) > 1e-9:
        return None
    z, y = normal / np.linalg.norm(normal), across / np.linalg.norm(across)
    return np.column_stack([np.cross(y, z), y, z])


def heidenhain(line: str) -> Tilt:
    """Return a line that begins with PLANE, in capitals, single blanks."""
    rest = line.removeprefix("PLANE").strip()
    form, _, rest = rest.partition(" ")
    tilt = _heidenhain(form, rest)
    return replace(tilt, name=f"PLANE {form}")


def _heidenhain(form: str, rest: str) -> Tilt:
    entries = {name: float(value) for name, value in ENTRY.findall(rest)} if form != "RESET" else {}
    rest = ENTRY.sub(" ", rest)
    options = list(REST.finditer(rest))
    move = next((way for way in (MOVE, TURN) if any(found[0] == way.upper() for found in options)), STAY)
    side = next((1 if found[0][-1] == "+" else -1 for found in options if found[0].startswith("SEQ")), 0)
    values = {found[1]: found[2] for found in options if found[1]}
    dist = values.get("DIST", "0")
    left = REST.sub(" ", rest).strip()
    away, table = "MB" in values, any(found[0].startswith("TABLE") for found in options)
    if left or dist == "MAX":
        return Tilt(HEIDENHAIN, refused=say("{rest} is not known here", rest=repr((left or dist)[:20])))
    if form == "RESET":
        return Tilt(HEIDENHAIN, move=move, side=side, dist=float(dist), back=True, away=away)
    if form not in FORMS:
        return Tilt(HEIDENHAIN, refused=say("{rest} is not known here", rest=repr(f"PLANE {form}")))
    if not any(found[0] in ("TURN", "MOVE", "STAY") for found in options):
        return Tilt(HEIDENHAIN, refused=say("it says none of TURN, MOVE and STAY"))
    if (
        set(entries) != set(FORMS[form])
        if form != RELATIVE
        else len(entries) != 1 or not set(entries) <= set(FORMS[form])
    ):
        return Tilt(HEIDENHAIN, refused=say("not all its values are given, or others"))
    if why := beyond([*entries.values(), float(dist)]):
        return Tilt(HEIDENHAIN, refused=why)
    turn = _compute_rotation(form, [entries.get(name, 0.0) for name in FORMS[form]])
    if turn is None:
        return Tilt(HEIDENHAIN, refused=say("its vectors span no plane"))
    return Tilt(
        HEIDENHAIN,
        turn,
        move=move,
        side=side,
        dist=float(dist),
        relative=form == RELATIVE,
        away=away,
        table=table,
    )


def _compute_rotation(form: str, values: list[float]) -> Floats | None:
    if form in ("SPATIAL", RELATIVE):
        return one_by_one((2, 1, 0), values[::-1])
    return euler(values) if form == "EULER" else by_vectors(np.array(values[:3]), np.array(values[3:]))


def cycle800(inside: str) -> Tilt:
    """Return what stands in the brackets of CYCLE800."""
    parts = [part.strip() for part in inside.split(",")]
    name, parts[1:2] = (parts[1].strip('" ') if len(parts) > 1 else ""), ["0"] * (len(parts) > 1)
    if not any(parts[:1] + parts[2:]) or name == "0":
        return Tilt(SIEMENS)
    if len(parts) > MOST_ARGUMENTS or any(part and not re.fullmatch(NUMBER, part) for part in parts):
        return Tilt(SIEMENS, refused=say("its values are no numbers"))
    value = [float(part or 0.0) for part in parts] + [0.0] * (MOST_ARGUMENTS - len(parts))
    if why := beyond(value):
        return Tilt(SIEMENS, refused=why)
    state, mode, way = value[2], int(value[3]), int(value[13])
    on = state % 10 == ON
    order = [(mode >> bits & 3) - 1 for bits in (0, 2, 4)]
    if state - on not in POLE_STATES:
        return Tilt(SIEMENS, refused=say("{rest} is not known here", rest=f"ST={state:g}"))
    if mode >> 6 or sorted(order) != [0, 1, 2]:
        return Tilt(SIEMENS, refused=say("{rest} is not known here", rest=f"MODE={value[3]:g}"))
    first, second = (value[4], value[5], value[6]), (value[10], value[11], value[12])
    home = not any(value[7:10]) and not on
    turn = one_by_one(order, value[7:10])
    return Tilt(
        SIEMENS,
        turn,
        first,
        second,
        TURN if way else STAY,
        (way > 0) - (way < 0),
        back=home,
        relative=on,
        away=value[0] > 0,
    )
