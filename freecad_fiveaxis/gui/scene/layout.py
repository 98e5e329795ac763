# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the legend and the labels stand on the screen, so that none lies over another. Plain arrays, no view.

box     left, bottom, right, top in pixels from the view's lower left corner; a row of (n, 4).
anchor  the pixel of the place that a label speaks of; a line leads there from the label.
slot    one of the places about its anchor that a label may take, nearest first.
"""

from __future__ import annotations

import numpy as np

EDGE = 12.0
"""Pixels from the legend to the view's edge."""
CLEAR, MARK = 3.0, 7.0
"""Pixels: between two labels, and half the side of a marker that no label covers."""
MOST = 12
"""At most so many labels are shown at a time: more are not read."""
MIDDLE = 0.6
"""Of the width and the height of a part: that of its middle, which labels stand beside."""
_WAYS = np.array([(1, 1), (1, -1), (-1, 1), (-1, -1), (0, 1), (0, -1), (1, 0), (-1, 0)], float)
_FAR = np.array([14.0, 32.0, 56.0, 88.0, 128.0, 180.0, 240.0])
SLOTS = (_FAR[:, None, None] * _WAYS / np.linalg.norm(_WAYS, axis=1)[:, None]).reshape(-1, 2)
"""From the anchor to the nearest corner or the middle of the nearest edge, (56, 2) pixels."""
_SIDE = np.tile(_WAYS, (len(_FAR), 1))
NONE = np.zeros((0, 4))


def overlap(box: np.ndarray, others: np.ndarray, apart: float = 0.0) -> np.ndarray:
    """Which boxes (k, 4) come nearer than ``apart`` pixels to any of ``others`` (n, 4); bool (k,)."""
    first, second = box[:, None], others[None]
    hits = (first[..., :2] < second[..., 2:] + apart) & (first[..., 2:] > second[..., :2] - apart)
    return np.asarray(np.any(np.all(hits, axis=2), axis=1))


def legend_place(size: tuple[int, int], view: tuple[int, int]) -> tuple[float, float]:
    """Return the lower left corner of a legend of ``size`` in a ``view`` (width and height): in the upper
    left corner of that."""
    return EDGE, float(view[1] - EDGE - size[1])


def label_places(
    anchor: np.ndarray,
    size: np.ndarray,
    view: tuple[int, int],
    taken: np.ndarray,
    before: np.ndarray,
    middle: np.ndarray = NONE,
) -> tuple[np.ndarray, np.ndarray]:
    """Boxes (n, 4) of labels of ``size`` (n, 2) that speak of ``anchor`` (n, 2), the most important first,
    and their slots (n,); -1 and NaN where a label has no room, or its anchor is out of the ``view``.

    No box covers another, nor one of those ``taken`` (k, 4), nor another label's marker. ``before`` (n,): the
    slots of the last picture, which are kept where they still have room, so that labels do not jump while the
    view is turned. ``middle`` (m, 4): the middles of parts, over which a label lies only where there is no
    other room.
    """
    box, slot = np.full((len(anchor), 4), np.nan), np.full(len(anchor), -1)
    inside = ((anchor >= 0.0) & (anchor <= view)).all(axis=1)
    marks = np.concatenate([anchor[inside] - MARK, anchor[inside] + MARK], axis=1)
    obstacles = np.concatenate([taken, marks])
    for row in np.flatnonzero(inside)[:MOST]:  # each one's place depends on those before it
        half = 0.5 * size[row]
        centre = (anchor[row] + SLOTS + _SIDE * half).round()
        tried = np.concatenate([centre - half, centre + half], axis=1)
        within = np.all((tried[:, :2] >= 0.0) & (tried[:, 2:] <= view), axis=1)
        free, last = within & ~overlap(tried, obstacles, CLEAR), int(before[row])
        beside = ~overlap(tried, middle) if len(middle) else np.ones(len(tried), bool)
        keeps = last >= 0 and within[last] and not overlap(tried[last : last + 1], obstacles)[0]
        chosen = _slot(free, beside, last if keeps else -1)
        if chosen >= 0:
            slot[row] = chosen
        else:
            continue
        box[row] = tried[slot[row]]
        obstacles = np.concatenate([obstacles, box[row : row + 1]])
    return box, slot


def _slot(free: np.ndarray, beside: np.ndarray, last: int) -> int:
    """Return the slot of a label, of those that are ``free`` one ``beside`` the parts where there is one; the
    ``last`` (-1: it has no room any more) where that is no worse; -1: none."""
    some = bool((free & beside).any())
    if last >= 0 and (beside[last] or not some):
        return last
    best = free & beside if some else free
    return int(best.argmax()) if best.any() else -1


def middle_of(pixels: np.ndarray) -> np.ndarray:
    """Return the middle (1, 4) of what is drawn between the corners ``pixels`` (n, 2) of a box; none where
    one is behind the eye."""
    if not len(pixels) or not np.isfinite(pixels).all():
        return NONE
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    inset = 0.5 * (1.0 - MIDDLE) * (high - low)
    return np.concatenate([low + inset, high - inset])[None]


def leader_ends(anchor: np.ndarray, box: np.ndarray) -> np.ndarray:
    """Return the point (n, 2) of each box (n, 4) at which the line from its anchor (n, 2) ends: the nearest
    one."""
    return np.clip(anchor, box[:, :2], box[:, 2:])


def project_places(places: np.ndarray, clip_from_place: np.ndarray, view: tuple[int, int]) -> np.ndarray:
    """Return the pixels (n, 2) of places (n, 3); NaN behind the eye. Rows are multiplied by
    ``clip_from_place`` (4, 4), as Coin does."""
    clip = np.concatenate([places, np.ones((len(places), 1))], axis=1) @ clip_from_place
    depth = np.where(clip[:, 3] > 1e-9, clip[:, 3], np.nan)[:, None]
    return np.asarray((0.5 + 0.5 * clip[:, :2] / depth) * view)


def depths(places: np.ndarray, clip_from_place: np.ndarray) -> np.ndarray:
    """How far away places (n, 3) are drawn: 0 at the view's near end, 1 at its far one; NaN behind the
    eye."""
    clip = np.concatenate([places, np.ones((len(places), 1))], axis=1) @ clip_from_place
    return np.asarray(0.5 + 0.5 * clip[:, 2] / np.where(clip[:, 3] > 1e-9, clip[:, 3], np.nan))
