# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which layouts could have made the rotary words: every order, direction and sign, judged by the tool axes
alone.

The tool axis depends on the rotary words and their zeros only, so what is discrete is mostly decided before
any offset is known. At given directions both zeros follow in closed form: ``a1 . k = D + H cos(w2 - q* -
z2)`` is linear in cos z2 and sin z2, and z1 is then the mean turn about a1 from ``R2 ez`` to k. Rows are
weighted down by their distance (iteratively reweighted to the least sum of distances), so that a few wrong
ones do not count.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import Machine, Vector
from freecad_fiveaxis.core.machine.kinematics import RotaryPair

from .model import HEAD_HEAD, HEAD_TABLE, TABLE_TABLE, XYZ, Layout, turns
from .pairs import Pairs

LEAN = math.sqrt(0.5)
REWEIGHTINGS = 6
PASSES = 8.0
"""A layout whose tool axes are off by so many times what the best one's are is out."""
AXIS_NOISE = 3e-6
"""rad; axes within so much are equally good: four decimals of a degree."""
MOST = 24
"""Layouts of the axes that are tried on the tips."""
PLAIN = 0.25
"""Layouts of the machine that is given count as so much plainer than others as good."""

Zeros = tuple[float, float]


@dataclass(frozen=True)
class Guess:
    """A layout (its kind still open), the zeros of its rotary words rad, and how far the axes are off, rad
    (the median)."""

    layout: Layout
    zeros: Zeros
    off: float


def guesses(pairs: Pairs, start: Machine | None = None, zeros: bool = True) -> list[Guess]:
    """Return the layouts that explain the tool axes, the plainest first; ``zeros``: with shifted rotary zeros
    too."""
    found = [
        guess for layout in every_layout(pairs.letters, start) for guess in _try_zeros(layout, pairs, zeros)
    ]
    best = min(guess.off for guess in found)
    passed = [
        guess for guess in found if guess.off <= max(PASSES * best, AXIS_NOISE + PASSES * pairs.steps.axis)
    ]
    passed.sort(key=lambda guess: (guess.layout.strange + any(guess.zeros), guess.off))
    return passed[:MOST]


def kinds(guess: Guess, start: Machine | None = None) -> Iterator[Guess]:
    """Yield the same axes as table-table, head-table and head-head; the machine that is given keeps its
    own."""
    if start is not None and guess.layout.strange < 0.0:
        yield guess
        return
    for slot in (TABLE_TABLE, HEAD_TABLE, HEAD_HEAD):
        yield replace(guess, layout=replace(guess.layout, slot=slot))


def start_layout(machine: Machine) -> Layout:
    """Return the layout of a machine that is given."""
    linear = sorted(machine.linear, key=lambda axis: axis.letter)
    first, second = machine.rotary
    places = [machine.axes.index(axis) for axis in machine.rotary]
    x, y, z = (sum(machine.axes.index(axis) > at for at in places) for axis in linear)
    moves = (linear[0].direction, linear[1].direction, linear[2].direction)
    return Layout((x, y, z), first.letter + second.letter, first.direction, second.direction, moves, -PLAIN)


def every_layout(letters: str, start: Machine | None) -> Iterator[Layout]:
    """Yield the machine that is given, then both orders with every direction of both axes; all as
    table-table."""
    if start is not None and set(letters) == {axis.letter for axis in start.rotary}:
        yield start_layout(start)
    for order in (letters, letters[::-1]):
        choices = [list(_directions(letter)) for letter in order]
        for (one, strange1), (two, strange2) in itertools.product(*choices):
            layout = Layout(TABLE_TABLE, order, one, two, XYZ, strange1 + strange2)
            if _turns_the_tool(layout):
                yield layout


def _directions(letter: str) -> Iterator[tuple[Vector, float]]:
    """Along the axis of the letter, leaning 45 degrees from it, along another one."""
    named = "ABC".index(letter)
    for x, y, z in itertools.product((-1.0, 0.0, 1.0), repeat=3):
        size, own = abs(x) + abs(y) + abs(z), (x, y, z)[named]
        if size == 1.0:
            yield (x, y, z), 0.0 if own else 2.0
        elif size == 2.0 and own:
            yield (LEAN * x, LEAN * y, LEAN * z), 1.0


def _turns_the_tool(layout: Layout) -> bool:
    first, second = np.array(layout.direction1), np.array(layout.direction2)
    return bool(np.linalg.norm(np.cross(first, second)) > 1e-6 and math.hypot(second[0], second[1]) > 1e-6)


def _try_zeros(layout: Layout, pairs: Pairs, shifted: bool) -> Iterator[Guess]:
    """With both zeros 0, and with the zeros that fit best where those are better by far."""
    order = [pairs.letters.index(letter) for letter in layout.letters]
    words = pairs.rotary[:, order]
    plain = _off(layout, words, pairs.axis, (0.0, 0.0))
    yield Guess(layout, (0.0, 0.0), plain)
    if shifted and layout.strange < 2.0 and plain > AXIS_NOISE:
        zeros = _zeros(layout, words, pairs.axis)
        off = _off(layout, words, pairs.axis, zeros)
        if off < 0.3 * plain:
            far = (abs(zeros[0]) + abs(zeros[1])) / math.pi
            yield Guess(replace(layout, strange=layout.strange + far), zeros, off)


def _distances(layout: Layout, words: Floats, axis: Floats, zeros: Zeros) -> Floats:
    tool = turns(layout.direction2, words[:, 1] - zeros[1])[:, :, 2]
    reached = np.einsum("nij,nj->ni", turns(layout.direction1, words[:, 0] - zeros[0]), tool)
    return np.asarray(np.linalg.norm(axis - reached, axis=1))


def _off(layout: Layout, words: Floats, axis: Floats, zeros: Zeros) -> float:
    return float(np.median(_distances(layout, words, axis, zeros)))


def _zeros(layout: Layout, words: Floats, axis: Floats) -> Zeros:
    first, second = np.array(layout.direction1), np.array(layout.direction2)
    pair = RotaryPair.of(first, second)
    along = axis @ first * pair.sign - (pair.cos_g * float(second[2]))
    swing = words[:, 1] - pair.best
    columns = pair.reach * np.column_stack([np.cos(swing), np.sin(swing)])
    weight, zeros = np.ones(len(axis)), (0.0, 0.0)
    for _ in range(REWEIGHTINGS):
        cos, sin = np.linalg.lstsq(columns * weight[:, None], along * weight, rcond=1e-9)[0]
        z2 = math.atan2(sin, cos)
        tool = turns(layout.direction2, words[:, 1] - z2)[:, :, 2]
        back = np.einsum("nij,nj->ni", turns(layout.direction1, -words[:, 0]), axis)
        sines, cosines = (
            np.cross(tool, back) @ first,
            (tool * back).sum(axis=1) - (tool @ first) * (back @ first),
        )
        z1 = -math.atan2(float(weight**2 @ sines), float(weight**2 @ cosines))
        zeros = (z1, z2)
        off = _distances(layout, words, axis, zeros)
        weight = 1.0 / np.sqrt(np.maximum(off, max(1e-9, 1e-3 * float(np.median(off)))))
        weight /= weight.max()
    return zeros
