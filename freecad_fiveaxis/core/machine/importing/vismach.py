# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a LinuxCNC machine from the vismach model that HAL moves by its joints.

frame     the model's, moved so that the capture of the tool's tip, with every joint and the tool's length at
          zero, stands in the gauge point. The tool must stand along Z there.
pin       moves with an axis where a signal joins it with the joint's position; where no HAL file says
          anything of it, where its name is one of an axis (``jx``, ``tilt-a``). With
          ``motion.tooloffset.z`` it is the tool's length, and what it moves is the tool. Others stand where
          HAL sets them.
sides     what moves the capture of the work is on the table's side: kinematics alone do not say which linear
          axes are.
agree     order and sides of the rotary axes must be those of the kinematics. Directions and lines that are
          others in the model are told; the machine moves as the kinematics say.
"""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Number, Point, join_sentences, plural, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.bodies import BASE

from .hal_files import HalValues
from .ini_file import LONGEST, IniFile
from .vismach_bodies import make_bodies
from .vismach_file import read_model, wrong
from .vismach_tree import SAME, Joint, Meaning, Placed, Tree, grow

POSITION = re.compile(r"joint\.(\d{1,2})\.(?:motor-)?pos-(?:fb|cmd)")
AXIS = re.compile(r"axis\.([a-cx-z])\.pos-cmd")
LETTER = re.compile(
    r"(?:(?:axis|joint|table|saddle|knee|ram|head|spindle|tilt|rotate|rotary)[-_.]?|j)?([a-cx-z])"
)
"""Pins that are an axis by their names. Offsets end in such letters, too (``pivot_y``)."""
NEAR = 0.001
"""mm; lines of rotary axes that are farther apart are told."""
MOST_NAMED = 12
"""So many parts that are left out are named."""


@dataclass(frozen=True)
class Configuration:
    """What a LinuxCNC configuration says of its ``machine``: HAL, the letters of the joints in their
    ``order``, mm and degrees in its units."""

    machine: Machine
    hal: HalValues
    order: str
    length: float
    angle: float


def add_bodies(given: Configuration, path: Path) -> tuple[Machine, tuple[Finding, ...], dict[str, Mesh]]:
    """Give the machine with the bodies of a vismach model, what is to be said of them, and the meshes, mm, of
    those of the shape ``file`` by their names. Raises MachineError for what does not fit, FileError."""
    pins = _Pins(given)
    tree = grow(read_model(path, _settings(given.hal, path)), pins.meaning, given.angle)
    if tree.full:
        raise wrong(path, say("it has too many parts; give a simpler model"))
    tip, work = _ends(tree, path)
    table, head = _sides(tip, work, path)
    axes = _axes(given.machine, table, head, path)
    frame = _frame(given, tip, path)
    shapes = [one._replace(place=frame @ one.place) for one in tree.shapes if not one.tool]
    carriers = _Carriers(table, head, frame)
    bodies, meshes, flat = make_bodies(shapes, carriers.of, given.machine.gauge_point, path)
    machine = replace(given.machine, axes=axes, bodies=bodies)
    found = [
        _report_taken(machine, frame, path),
        *_differing(machine, (*table, *head), frame, path),
        *_report_left([*tree.left, *flat], path),
        *_tool(sum(one.tool for one in tree.shapes), path),
        *_unset(pins.unset, path),
    ]
    return machine, tuple(found), meshes


@dataclass
class _Pins:
    """What the pins of the model are; ``unset``: those that no HAL file sets, and that move nothing."""

    given: Configuration
    unset: list[str] = field(default_factory=list)

    def meaning(self, pin: str) -> Meaning:
        """Say what moves by a pin."""
        hal, near = self.given.hal, {pin, *self.given.hal.with_signal(pin)}
        letters = {letter for one in near for letter in self._letter(one)}
        if not letters and not hal.is_set(pin) and (found := LETTER.fullmatch(pin.rpartition(".")[2])):
            letters = {found[1].upper()}
        if len(letters) > 1:
            return Meaning(
                problem=say("its pin is joined with several axes: {axes}", axes=", ".join(sorted(letters)))
            )
        if letters:
            letter = letters.pop()
            return Meaning(letter) if letter in self.given.machine.letters else Meaning()
        if any(one.startswith("motion.tooloffset.") for one in near):
            return Meaning(tool=True)
        return self._constant(pin)

    def _letter(self, pin: str) -> str:
        """Return the letter of the axis whose position a pin is, or nothing."""
        if found := POSITION.fullmatch(pin):
            return self.given.order[int(found[1]) :][:1]
        return found[1].upper() if (found := AXIS.fullmatch(pin)) else ""

    def _constant(self, pin: str) -> Meaning:
        try:
            number = self.given.hal.value(pin)
        except MachineError as error:
            return Meaning(problem=error.text)
        if number is None and pin not in self.unset:
            self.unset.append(pin)
        return Meaning(number=number or 0.0)


def find_model(ini: Path) -> Path | None:
    """Return the vismach model that the HAL files of a LinuxCNC configuration start, from the ini file's
    folder or where commands are installed; None where there is none. Raises FiveAxisError for a configuration
    that cannot be read."""
    for started in HalValues(IniFile(ini)).programs:
        for word in started.text.split():
            file = ini.parent / word
            if not word.startswith("-") and not os.path.isfile(file):  # of a name that is too long, too
                file = Path(shutil.which(word) or file)
            if (
                not word.startswith("-")
                and os.path.isfile(file)
                and os.path.getsize(file) <= LONGEST
                and b"vismach" in read_bytes(file, "vismach model")
            ):
                return file
    return None


def _settings(hal: HalValues, path: Path) -> list[str]:
    """Return the ``name=number`` that HAL starts the model with."""
    for words in (value.text.split() for value in hal.programs):
        for at, word in enumerate(words):
            if Path(word).stem == path.stem:
                return words[at + 1 :]
    return []


def _ends(tree: Tree, path: Path) -> tuple[Placed, Placed]:
    if tree.tip is not None and tree.work is not None:
        return tree.tip, tree.work
    problem = say(
        "the captures at tool and work, which main is given, do not stand in what can be read of the model"
    )
    if tree.left:
        problem = say("{problem}; left out is {parts}", problem=problem, parts=_parts(tree.left))
    raise wrong(path, problem)


def _sides(tip: Placed, work: Placed, path: Path) -> tuple[tuple[Joint, ...], tuple[Joint, ...]]:
    """Return the joints from the base to work and to tool. Raises MachineError for one that moves both."""
    both = [*work.path, *tip.path]
    for at, joint in enumerate(both):
        if again := next((one for one in both[:at] if one.letter == joint.letter), None):
            text = say(
                "lines {line} and {other} both move tool or work by {letter}; one of them can be right",
                line=again.line, other=joint.line, letter=joint.letter,
            )  # fmt: skip
            raise wrong(path, text)
    return work.path, tip.path


def _axes(machine: Machine, table: Sequence[Joint], head: Sequence[Joint], path: Path) -> tuple[Axis, ...]:
    """Return the machine's axes on the sides that the model has them on. Raises MachineError where order or
    sides of the rotary ones are not those of the kinematics."""
    model = "".join(joint.letter for joint in (*table[::-1], *head))
    missing = [axis.letter for axis in machine.fitted if axis.letter not in model]
    if missing:
        text = say("nothing in it moves tool or work by {letters}", letters=", ".join(missing))
        raise wrong(path, text)
    place: dict[str, Literal["table", "head"]] = {joint.letter: "table" for joint in table}
    by_letter = {axis.letter: axis for axis in machine.fitted}
    axes = tuple(replace(by_letter[letter], side=place.get(letter, "head")) for letter in model)
    if _turning(axes) != _turning(machine.fitted):
        text = say(
            "from work to tool it has {model}, the kinematics {kinematics}; one of them can be right",
            model=" ".join(_turning(axes)), kinematics=" ".join(_turning(machine.fitted)),
        )  # fmt: skip
        raise wrong(path, text)
    return axes


def _turning(axes: Sequence[Axis]) -> list[str]:
    """Return the order of the axes from work to tool: the rotary ones by letter and side, linear ones as
    one."""
    words = [f"{axis.letter} ({axis.side})" if axis.rotary else "XYZ" for axis in axes]
    return [word for at, word in enumerate(words) if at == 0 or word != words[at - 1] or word != "XYZ"]


def _frame(given: Configuration, tip: Placed, path: Path) -> Floats:
    """Return the 4x4 that makes mm of the machine frame of the model's units and frame."""
    if not np.allclose(tip.place[:3, 2], (0.0, 0.0, 1.0), atol=SAME):
        raise wrong(path, say("its tool does not stand along Z with every joint at zero; turn the model so"))
    found = np.diag([given.length, given.length, given.length, 1.0])
    found[:3, 3] = np.array(given.machine.gauge_point) - given.length * tip.place[:3, 3]
    return found


@dataclass(frozen=True)
class _Carriers:
    """The joints from the base to ``table`` and ``head``."""

    table: tuple[Joint, ...]
    head: tuple[Joint, ...]
    frame: Floats

    def of(self, shape: Placed) -> tuple[str, bool]:
        """Return what carries a shape, and whether that carries the tool, too. Raises MachineError for joints
        that carry neither table nor tool."""
        for side in (self.head, self.table):
            first = len(shape.path)
            if _alike(shape.path, side[:first]):
                return (side[first - 1].letter if first else BASE), first == len(self.head) and (
                    side is self.head
                )
        moved = ", ".join(joint.letter for joint in shape.path)
        raise MachineError(say("it moves by {axes} as neither table nor tool do", axes=moved), moved)


def _alike(path: Sequence[Joint], side: Sequence[Joint]) -> bool:
    """Tell whether two rows of joints move alike; linear ones, which all stand before those that turn, in any
    order."""
    if len(path) != len(side):
        return False
    pairs = zip(_sort_joints(path), _sort_joints(side), strict=True)
    return all(_same(one, other) for one, other in pairs)


def _sort_joints(path: Sequence[Joint]) -> list[Joint]:
    linear = [joint for joint in path if joint.letter in "XYZ"]
    return [*sorted(linear, key=lambda joint: joint.letter), *path[len(linear) :]]


def _same(one: Joint, other: Joint) -> bool:
    if one.letter != other.letter or not np.allclose(one.direction, other.direction, atol=SAME):
        return False
    return one.letter in "XYZ" or _apart(one.point, other.point, one.direction) <= NEAR


def _apart(one: Floats, other: Floats, direction: Floats) -> float:
    """Return the distance of two points across a unit direction."""
    return float(np.linalg.norm(np.cross(one - other, direction)))


# ----------------------------------------------------------------------------------------- what is to be said


def _report_taken(machine: Machine, frame: Floats, path: Path) -> Finding:
    sides = {
        side: ", ".join(axis.letter for axis in machine.fitted if axis.side == side) or say("none")
        for side in ("table", "head")
    }
    text = say(
        "{count} bodies of {name} are taken, moved by {shift} so that its tool's tip stands in the gauge "
        "point. By it the table moves with {table}, the tool with {head}. Take out what is only drawn there "
        "(marks, a workpiece) with the machine editor.",
        count=Number(len(machine.bodies)), name=path.name, shift=Point(tuple(frame[:3, 3].tolist())), **sides,
    )  # fmt: skip
    return report_finding(Code.MACHINE_DEFAULT, text)


def _differing(machine: Machine, joints: Sequence[Joint], frame: Floats, path: Path) -> list[Finding]:
    """Tell the joints that the model moves otherwise than the kinematics do."""
    by_letter = {axis.letter: axis for axis in machine.fitted}
    return [found for joint in joints for found in _difference(by_letter[joint.letter], joint, frame, path)]


def _difference(axis: Axis, joint: Joint, frame: Floats, path: Path) -> list[Finding]:
    ours = np.array(axis.direction) * (-1.0 if axis.side == "table" else 1.0)
    point = frame[:3, :3] @ joint.point + frame[:3, 3]
    apart = _apart(point, np.array(axis.point), ours) if axis.rotary else 0.0
    name, letter = path.name, axis.letter
    if not np.allclose(ours, joint.direction, atol=SAME):
        text = say(
            "{name} line {line} moves {letter} along or about {model}, the kinematics {ours}; the machine is "
            "that of the kinematics. Which is right?",
            name=name, line=joint.line, letter=letter,
            model=_direction(joint.direction), ours=_direction(ours),
        )  # fmt: skip
        return [report_finding(Code.MODEL_DIFFERS, text)]
    if apart <= NEAR:
        return []
    text = say(
        "{name} line {line} turns {letter} about a line that is {apart} from that of the kinematics; the "
        "machine is that of the kinematics. Which is right?",
        name=name, line=joint.line, letter=letter, apart=Length(apart, ".6g"),
    )  # fmt: skip
    return [report_finding(Code.MODEL_DIFFERS, text, apart)]


def _direction(vector: Floats) -> Point:
    x, y, z = (vector + 0.0).tolist()
    return Point((x, y, z), ".6g", bare=True)


def _report_left(left: Sequence[tuple[int, str]], path: Path) -> list[Finding]:
    if not left:
        return []
    text = say("Left out of {name} is what is not plain: {parts}", name=path.name, parts=_parts(left))
    return [report_finding(Code.MODEL_LEFT_OUT, text, float(len(set(left))))]


def _parts(left: Sequence[tuple[int, str]]) -> str:
    """Name what is left out by its lines."""
    lines = sorted(set(left))
    named = [say("line {line}: {text}", line=line, text=text) for line, text in lines[:MOST_NAMED]]
    if (more := len(lines) - MOST_NAMED) > 0:
        named.append(plural(more, "one more", "{count} more"))
    return join_sentences(named, "; ")


def _tool(count: int, path: Path) -> list[Finding]:
    if not count:
        return []
    text = plural(
        count,
        "One shape of {name} moves with the tool's length; it is taken for the tool, not for a body.",
        "{count} shapes of {name} move with the tool's length; they are taken for the tool, not for bodies.",
        name=path.name,
    )
    return [report_finding(Code.MACHINE_DEFAULT, text)]


def _unset(pins: Sequence[str], path: Path) -> list[Finding]:
    if not pins:
        return []
    text = say(
        "No HAL file sets {pins} of {name}; LinuxCNC has 0 there then. Is that so?",
        pins=", ".join(pins), name=path.name,
    )  # fmt: skip
    return [report_finding(Code.OFFSET_NOT_SET, text)]
