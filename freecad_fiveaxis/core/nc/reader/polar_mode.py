# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc's polar coordinate command as plain words (B-63324EN, 13.2, polar coordinate command).

G16   from here on the first axis of the plane tells the radius, the second the angle, deg, about the work
      zero; one that a line does not tell stays.
G15   ends it.

Under G91 the radius counts from where the tool stands, which is not read: those lines stay as they are, with
an error.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from . import codes
from .arcs import AXES
from .canned_cycles import NOT_IN_TEXT
from .codes import Grammar
from .lines import Lines, hold_words, last_of
from .noted import kind_findings
from .words import Words

ON, OFF = codes.POLAR_MODE, 150


def without_polar_mode(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Return the words with those of polar lines as places; without any, the same object."""
    if grammar.name != "iso" or ON not in lines.code or ON in grammar.codes:
        return words, []
    rows = _find_rows(lines, grammar)
    if not len(rows):
        return words, []
    plane, steps = lines.mode(codes.PLANES, 0)[rows], lines.mode(codes.DISTANCE, 0)[rows] == 1
    since = last_of(np.flatnonzero(_begins(lines)), lines.count)[rows]
    radius, angle = (_hold(lines.columns("XYZ"), AXES[plane, k], rows, since) for k in (0, 1))
    known = ~np.isnan(radius) & ~np.isnan(angle) & ~steps
    new = _with_places(words, rows[known], AXES[plane[known], :2], radius[known], angle[known])
    lost = rows[~known]
    named = {"G16": (int(words.in_file(lost[:1])[0]), len(lost))} if len(lost) else {}
    return new, kind_findings(codes.POLAR, named) if named else []


def _begins(lines: Lines) -> Bools:
    """Whether each line begins the polar mode, or changes the plane in it."""
    return np.asarray(lines.any_of((ON,)) | lines.any_of(codes.PLANES))


def _find_rows(lines: Lines, grammar: Grammar) -> Ints:
    """Return the lines (n,) that name an axis of the plane in the polar mode."""
    on = (lines.mode({ON: 1, OFF: 0}, 0) == 1) & ~lines.any_of(grammar.no_move)
    on[lines.m_line(grammar.machine_m)] = False
    axes = AXES[lines.mode(codes.PLANES, 0), :2]
    given = np.take_along_axis(~np.isnan(lines.columns("XYZ")), axes, axis=1)
    return np.flatnonzero(on & given.any(axis=1))


def _hold(columns: Floats, axis: Ints, rows: Ints, since: Ints) -> Floats:
    """Return the last word of each row's axis (n,) at or before it, NaN where none is as late as
    ``since``."""
    found = np.full(len(rows), np.nan)
    for k in range(3):
        column = columns[:, k]
        last = last_of(np.flatnonzero(~np.isnan(column)), len(column))[rows]
        held = np.where(last >= since, hold_words(column)[rows], np.nan)
        found = np.where(axis == k, held, found)
    return found


def _with_places(words: Words, rows: Ints, axes: Ints, radius: Floats, angle: Floats) -> Words:
    """Return the words with both axes of those rows at radius and angle."""
    way = np.column_stack([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    place = np.round(radius[:, None] * way, 9).reshape(-1)
    letters = np.array([ord(one) for one in "XYZ"], np.int8)[axes]
    own = np.zeros(len(words.letter), np.bool_)
    for k in (0, 1):
        letter = np.zeros(int(words.line.max(initial=0)) + 1, np.int8)
        letter[rows] = letters[:, k]
        own |= words.letter == letter[words.line]
    keep = ~own
    line = np.concatenate([words.line[keep], np.repeat(rows, 2)])
    order = np.argsort(line, kind="stable")
    start = (
        None
        if words.start is None
        else np.concatenate([words.start[keep], np.full(2 * len(rows), NOT_IN_TEXT)])[order]
    )
    return replace(
        words,
        letter=np.concatenate([words.letter[keep], letters.reshape(-1)])[order],
        value=np.concatenate([words.value[keep], place])[order],
        line=line[order],
        start=start,
    )
