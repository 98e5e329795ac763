# SPDX-License-Identifier: LGPL-2.1-or-later
"""A URDF file (ROS) as a machine: three prismatic joints and one or two that turn, in a tree that ends in a
table and in a tool.

frame      the machine's is that of the root link, in mm: the tool must stand upright in it, along Z.
sign       a joint's value is the axis's: of the table a positive one moves the table along or about the
           joint's axis, so that the direction by ISO 841, in which the tool moves relative to the work, is
           the reverse.
letter     by the joint's name (``x``, ``axis_x``, ``A-axis``, ``jointC``); where the names do not say it, by
           the direction: X, Y and Z of linear axes, A, B and C of those that turn about these.
places     gauge point and usual work zero are taken where the frames of the tool and of the table have their
           origins.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Point, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Axis, Machine, Vector
from freecad_fiveaxis.core.machine.bodies import BASE, SPINDLE, MachineBody
from freecad_fiveaxis.core.machine.bodies_file import read_bodies, write_bodies

from .urdf_bodies import MM, make_bodies
from .urdf_file import Joint, Robot, read_robot, wrong
from .urdf_tree import Tree, find_ends, grow, sides

LETTERS = {False: "XYZ", True: "ABC"}
ALONG = 0.9
"""Cosine of 26 deg: a joint whose axis leans less than that from X, Y or Z is named after it."""
UPRIGHT = 1e-4
"""rad: a tool that leans by more does not stand along Z."""
MANY = 8
"""So many joints are named at most."""


def machine_of_urdf(path: Path) -> tuple[Machine, tuple[Finding, ...], dict[str, Mesh]]:
    """Make the machine of a URDF file, and the meshes, mm, of its bodies of the shape ``file`` by their
    names. Raises MachineError that names what cannot be read, FileError."""
    robot = read_robot(path)
    tree = grow(robot, path)
    table, tool = find_ends(tree, path)
    under, over = sides(tree, table, tool, path)
    _check_kinds([*under, *over], path)
    _check_upright(tree.place[tool], tool, path)
    letters = {**_letters([*under, *over], tree, False, path), **_letters([*under, *over], tree, True, path)}
    axes = [_axis(joint, letters[joint.name], joint in under, tree, path) for joint in (*under, *over)]
    carriers = {link: _carrier(tree, link, tool, letters) for link in tree.place}
    bodies, meshes = make_bodies(robot, tree.place, carriers, path)
    _check_bodies(bodies, path)
    machine = Machine(
        robot.name.strip() or path.stem, tuple(axes), _point(tree, tool), _point(tree, table),
        description=f"from {path.name}", bodies=bodies,
    )  # fmt: skip
    return machine, tuple(_findings(robot, tree, table, tool, letters, bodies)), meshes


def _check_bodies(bodies: Sequence[MachineBody], path: Path) -> None:
    """Refuse what the machine's file could not be read with."""
    try:
        read_bodies(
            write_bodies([replace(body, file=body.file or body.name) for body in bodies]), "bodies", 1.0
        )
    except MachineError as error:
        raise wrong(path, error.text) from error


def _check_kinds(joints: Sequence[Joint], path: Path) -> None:
    linear, rotary = ([joint.name for joint in joints if joint.rotary is kind] for kind in (False, True))
    if len(linear) != 3 or len(rotary) > 2:
        text = say(
            "between table and tool {linear} run straight and {rotary} turn; it needs three and at most two, "
            "make others fixed",
            linear=", ".join(linear[:MANY]) or say("none"),
            rotary=", ".join(rotary[:MANY]) or say("none"),
        )
        raise wrong(path, text)


def _check_upright(place: Floats, tool: str, path: Path) -> None:
    if abs(place[2, 2]) < math.cos(UPRIGHT):
        lean = math.degrees(math.acos(min(abs(place[2, 2]), 1.0)))
        raise wrong(
            path,
            say(
                "the Z axis of {tool} leans {lean} deg from that of the root; turn the root so that the tool "
                "stands along Z",
                tool=tool,
                lean=round(lean, 3),
            ),
        )


def _letters(joints: Sequence[Joint], tree: Tree, rotary: bool, path: Path) -> dict[str, str]:
    """Return the letters of the joints of one kind: by name where each has one of its own there, else by
    direction."""
    kind = [joint for joint in joints if joint.rotary is rotary]
    by_name = {joint.name: _letter_in(joint.name, LETTERS[rotary]) for joint in kind}
    if all(by_name.values()) and len(set(by_name.values())) == len(kind):
        return by_name
    found = {joint.name: _letter_along(joint, tree, path) for joint in kind}
    for letter in LETTERS[rotary]:
        if len(alike := [name for name in found if found[name] == letter]) > 1:
            text = say("{joints} would all be {letter} by their directions; call them by their letters, as "
                "axis_{small}",
                       joints=", ".join(alike), letter=letter, small=letter.lower())  # fmt: skip
            raise wrong(path, text)
    return found


def _letter_in(name: str, letters: str) -> str:
    """Return the one letter that stands for itself in a joint's name, or behind "axis" or "joint"; empty for
    none, or several."""
    words = re.split(r"[^A-Za-z0-9]+|(?<=axis)(?=[A-Z])|(?<=joint)(?=[A-Z])", name)
    found = {word.upper() for word in words if len(word) == 1 and word.upper() in letters}
    return found.pop() if len(found) == 1 else ""


def _letter_along(joint: Joint, tree: Tree, path: Path) -> str:
    direction = np.abs(_direction(joint, tree, path))
    at = int(direction.argmax())
    if direction[at] < ALONG:
        text = say("joint {joint} runs along none of X, Y, Z; call it by its letter, as axis_{letter}",
                   joint=joint.name, letter=LETTERS[joint.rotary][at].lower())  # fmt: skip
        raise wrong(path, text)
    return LETTERS[joint.rotary][at]


def _direction(joint: Joint, tree: Tree, path: Path) -> Floats:
    """Return the joint's axis in the root's frame, of length 1."""
    axis = tree.place[joint.child][:3, :3] @ np.array(joint.axis)
    length = float(np.linalg.norm(axis))
    if not 0.0 < length < math.inf:
        raise wrong(path, say("joint {joint} has the axis 0 0 0; give its direction", joint=joint.name))
    return np.asarray(axis / length + 0.0)


def _axis(joint: Joint, letter: str, table: bool, tree: Tree, path: Path) -> Axis:
    x, y, z = (-1.0 if table else 1.0) * _direction(joint, tree, path) + 0.0
    scale = 1.0 if joint.rotary else MM
    point = tuple((MM * tree.place[joint.child][:3, 3]).tolist()) if joint.rotary else (0.0, 0.0, 0.0)
    side: Literal["table", "head"] = "table" if table else "head"
    try:
        return Axis(
            letter,
            joint.rotary,
            side,
            (x, y, z),
            point,
            scale * joint.low,
            scale * joint.high,
            60.0 * scale * joint.rate,
        )
    except MachineError as error:
        raise wrong(path, say("joint {joint}, {error}", joint=joint.name, error=error)) from error


def _point(tree: Tree, link: str) -> Vector:
    x, y, z = (MM * tree.place[link][:3, 3] + 0.0).tolist()
    return x, y, z


def _carrier(tree: Tree, link: str, tool: str, letters: Mapping[str, str]) -> str:
    """Return what carries a link: the spindle for the tool's and what hangs from it, the axis of its last
    joint, or the base."""
    if tree.is_under(link, tool):
        return SPINDLE
    group = tree.group(link)
    return letters[group] if group else BASE


def _findings(
    robot: Robot, tree: Tree, table: str, tool: str, letters: Mapping[str, str], bodies: Sequence[MachineBody]
) -> list[Finding]:
    named = ", ".join(f"{letter} {name}" for name, letter in letters.items())
    taken = say(
        "Taken of {name}: the axes {letters}; the gauge point {gauge} mm, the origin of {tool}; the usual "
        "work zero {zero} mm, that of {table}. Neither controller nor height of the table's face is known. "
        "Correct what is otherwise in the machine file.",
        name=robot.name,
        letters=named,
        gauge=Point(_point(tree, tool), "g", bare=True),
        tool=tool,
        zero=Point(_point(tree, table), "g", bare=True),
        table=table,
    )
    signs = say(
        "A positive word is taken for a positive value of its joint, which moves table or tool along or "
        "about its axis. Prove the signs before cutting."
    )
    found = [report_finding(Code.MACHINE_DEFAULT, taken), report_finding(Code.SIGN_UNPROVEN, signs)]
    if not bodies:
        text = say(
            "No link has a collision or visual shape: the machine has no bodies that the tool must not hit."
        )
        found.append(report_finding(Code.MACHINE_DEFAULT, text))
    return found
