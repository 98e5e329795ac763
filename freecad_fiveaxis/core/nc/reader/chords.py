# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs and corners of the motion lines, divided into chords."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding

from . import codes, corners
from .arcs import Arcs, Chords, divide_arcs
from .lines import hold_words
from .positions import Moves, check_near
from .source import Source


def divide_moves(source: Source, motions: Moves) -> tuple[Chords | None, list[Finding]]:
    """Return the moves with their arcs and corners as chords; None where they have neither."""
    chords, findings = None, list[Finding]()
    if (motions.mode == codes.ARC).any():
        arcs = _find_arcs(source, motions)
        chords, findings = divide_arcs(arcs, motions.before, motions.programmed, motions.at)
    if corners.LETTER in source.lines.letters:
        found = _find_corners(source, motions)
        chords, lost = corners.with_corners(found, motions.before, motions.programmed, chords, motions.at)
        findings += lost
    return chords, findings


def _find_arcs(source: Source, motions: Moves) -> Arcs:
    lines, row = source.lines, np.flatnonzero(motions.mode == codes.ARC)
    line = motions.at[row]
    scale = lines.unit(source.grammar)[line]
    columns = {letter: lines.column(letter) for letter in ("I", "J", "K", "R", *codes.CENTRE)}
    is_arc = np.zeros(lines.count, np.bool_)
    is_arc[line] = True
    for letter, column in columns.items():
        check_near(lines, letter, np.where(is_arc, column, np.nan))
    offset = np.stack([columns[letter][line] for letter in "IJK"], axis=1) * scale[:, None]
    hold = np.asarray if source.grammar.name == "siemens" else hold_words  # I=AC() is of its own line
    centre = np.stack([hold(columns[letter])[line] for letter in codes.CENTRE], axis=1) * scale[:, None]
    sense = lines.mode({codes.CLOCKWISE: 0, codes.COUNTER: 1}, 0)[line]
    return Arcs(
        row, lines.mode(codes.PLANES, 0)[line], sense == 1, offset, lines.mode(codes.CENTRES, 0)[line] == 1,
        columns["R"][line] * scale, centre,
        lines.column(codes.TURNS)[line] if codes.TURNS in lines.letters else None,
    )  # fmt: skip


def _find_corners(source: Source, motions: Moves) -> corners.Corners:
    lines, at = source.lines, motions.at
    size, length, modal = corners.sizes(lines.column(corners.LETTER), at)
    size *= lines.unit(source.grammar)[at]
    plane = lines.mode(codes.PLANES, 0)[at]
    return corners.Corners(size, length, modal, plane, motions.mode != codes.RAPID)
