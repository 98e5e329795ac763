# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a URDF file says, as records: links with their shapes, and joints between them. Lengths in m, angles
in rad, as there.

place      4x4, from the frame of a shape or a joint into that of the link around it; of a joint with its
           value at zero.
collision  what a link has of it counts, its visual shapes only where it has none.
right      angles within RIGHT of a quarter turn are one: 1.5708 is what files write for it.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import plural, say
from freecad_fiveaxis.core.base.vectors import turn_about_fixed_axes
from freecad_fiveaxis.core.machine import Vector

PRISMATIC, ROTARY, FIXED = ("prismatic",), ("revolute", "continuous"), ("fixed",)
SHAPES = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",), "mesh": ("filename",)}
"""The shapes of URDF and what each must say."""
RIGHT, MOST = 1e-5, 1e30


@dataclass(frozen=True, eq=False)
class Shape:
    """``kind``: a key of SHAPES; ``sizes``: m, of a box (3,), of a cylinder radius and length, of a sphere
    its radius, of a mesh the scales (3,) of its ``file``."""

    kind: str
    place: Floats
    sizes: tuple[float, ...]
    file: str = ""


@dataclass(frozen=True)
class Joint:
    """``axis`` (3,) in the joint's frame; ``low`` and ``high`` m or rad, ``rate`` m/s or rad/s."""

    name: str
    kind: str
    parent: str
    child: str
    place: Floats
    axis: Vector = (1.0, 0.0, 0.0)
    low: float = -math.inf
    high: float = math.inf
    rate: float = math.inf

    @property
    def rotary(self) -> bool:
        """Whether it turns."""
        return self.kind in ROTARY

    @property
    def moves(self) -> bool:
        """Whether it moves at all."""
        return self.kind not in FIXED


@dataclass(frozen=True)
class Robot:
    """``links``: the shapes of each link by its name."""

    name: str
    links: dict[str, tuple[Shape, ...]]
    joints: tuple[Joint, ...]


def read_robot(path: Path) -> Robot:
    """Read a URDF file. Raises MachineError that names what cannot be read, FileError."""
    root = _parse(path)
    links = {_attribute(link, "name", path): link for link in root.iterfind("link")}
    joints = tuple(_joint(joint, path) for joint in root.iterfind("joint"))
    for names in (
        [_attribute(link, "name", path) for link in root.iterfind("link")],
        [joint.name for joint in joints],
    ):
        if len(set(names)) < len(names):
            twice = next(name for name in names if names.count(name) > 1)
            raise wrong(
                path, say("two links or joints are called {name}; give each a name of its own", name=twice)
            )
    if not links:
        raise wrong(path, say("it has no link; give the URDF of a machine"))
    return Robot(
        root.get("name") or path.stem, {name: _shapes(link, path) for name, link in links.items()}, joints
    )


def _parse(path: Path) -> Element:
    data = read_bytes(path, "URDF file")
    if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
        raise wrong(
            path, say("it defines entities of its own, which are not read; write it without <!DOCTYPE")
        )
    if b"xacro:" in data:
        raise wrong(path, say("it is a xacro file; run xacro on it first, and give the URDF that it writes"))
    try:
        root = ET.fromstring(data)
    except (ET.ParseError, ValueError, LookupError) as error:
        raise wrong(path, say("it is no XML that can be read ({error}); correct it", error=error)) from error
    if root.tag != "robot":
        raise wrong(path, say("its root is <{tag}>, not <robot>; give a URDF file", tag=root.tag[:40]))
    return root


def _joint(joint: Element, path: Path) -> Joint:
    name = _attribute(joint, "name", path)
    where = say("joint {name}", name=name)
    kind = _attribute(joint, "type", path, where)
    if kind not in (*PRISMATIC, *ROTARY, *FIXED):
        known = ", ".join((*PRISMATIC, *ROTARY, *FIXED))
        raise wrong(
            path,
            say("{where} is of the type {kind}; known are {known}", where=where, kind=kind[:40], known=known),
        )
    parent, child = (
        _attribute(_need(joint, tag, path, where), "link", path, where) for tag in ("parent", "child")
    )
    place = _place(joint, path, where)
    if kind in FIXED:
        return Joint(name, kind, parent, child, place)
    if joint.find("mimic") is not None:
        raise wrong(
            path, say("{where} follows another one (mimic), as no axis does; make it fixed", where=where)
        )
    axis = joint.find("axis")
    direction = (1.0, 0.0, 0.0) if axis is None else _vector(axis, "xyz", path, where)
    return Joint(name, kind, parent, child, place, direction, *_limits(joint, kind, path, where))


def _limits(joint: Element, kind: str, path: Path, where: str) -> tuple[float, float, float]:
    """Low, high and rate. A continuous joint has no ends."""
    limit = _need(joint, "limit", path, where)
    low, high = -math.inf, math.inf
    if kind != "continuous":
        low, high = (_number(limit, key, path, where) for key in ("lower", "upper"))
    return low, high, _number(limit, "velocity", path, where)


def _shapes(link: Element, path: Path) -> tuple[Shape, ...]:
    where = say("link {name}", name=link.get("name"))
    found = link.findall("collision") or link.findall("visual")
    return tuple(_shape(one, path, where) for one in found)


def _shape(holder: Element, path: Path, where: str) -> Shape:
    geometry = _need(holder, "geometry", path, where)
    kinds = [one for one in geometry if isinstance(one.tag, str)]
    if len(kinds) != 1 or kinds[0].tag not in SHAPES:
        tags = ", ".join(str(one.tag)[:40] for one in kinds) or "nothing"
        known = ", ".join(SHAPES)
        raise wrong(
            path,
            say("{where} has the geometry {tags}; give one of {known}", where=where, tags=tags, known=known),
        )
    (one,), place = kinds, _place(holder, path, where)
    if one.tag == "box":
        return Shape("box", place, _vector(one, "size", path, where))
    if one.tag == "mesh":
        scale = _vector(one, "scale", path, where) if "scale" in one.attrib else (1.0, 1.0, 1.0)
        return Shape("mesh", place, scale, _attribute(one, "filename", path, where))
    return Shape(str(one.tag), place, tuple(_number(one, key, path, where) for key in SHAPES[str(one.tag)]))


def _place(holder: Element, path: Path, where: str) -> Floats:
    """Return the 4x4 matrix of an origin, the identity where there is none."""
    origin = holder.find("origin")
    found = np.eye(4)
    if origin is None:
        return found
    found[:3, :3] = turn_about_fixed_axes(*_vector(origin, "rpy", path, where, "0 0 0"), right=RIGHT)
    found[:3, 3] = _vector(origin, "xyz", path, where, "0 0 0")
    return found


# ---------------------------------------------------------------------------------- values, and what is wrong


def _need(holder: Element, tag: str, path: Path, where: str) -> Element:
    found = holder.find(tag)
    if found is None:
        raise wrong(path, say("{where} has no <{tag}>; add it", where=where, tag=tag))
    return found


def _attribute(one: Element, key: str, path: Path, where: str = "") -> str:
    found = (one.get(key) or "").strip()
    if not found:
        raise wrong(path, say("{where} lacks {key}=; add it", where=f"{where} <{one.tag}>".strip(), key=key))
    return found


def _number(one: Element, key: str, path: Path, where: str) -> float:
    return _numbers(_attribute(one, key, path, where), 1, key, path, where)[0]


def _vector(one: Element, key: str, path: Path, where: str, otherwise: str = "") -> Vector:
    text = one.get(key) or otherwise or _attribute(one, key, path, where)
    x, y, z = _numbers(text, 3, key, path, where)
    return x, y, z


def _numbers(text: str, count: int, key: str, path: Path, where: str) -> list[float]:
    found = list(_floats(text))
    if len(found) != count or not all(abs(one) < MOST for one in found):
        shown = repr(text[:40])
        wanted = plural(count, "a finite number", "{count} finite numbers")
        raise wrong(
            path,
            say("{where}: {key} is {text}; give {wanted}", where=where, key=key, text=shown, wanted=wanted),
        )
    return found


def _floats(text: str) -> Iterator[float]:
    for word in text.split():
        try:
            yield float(word)
        except ValueError:
            yield math.nan


def wrong(path: Path, problem: str) -> MachineError:
    """Return what to raise of a ``problem`` with the file."""
    return MachineError(say("{path}: {problem}", path=path, problem=problem), str(path))
