# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CL file of a path, in the plainest form that every reader knows.

``PPRINT/MOTION,LINK`` and ``PPRINT/MOTION,CUT`` are this program's marks for moves off and on the part; to
others they are text. So is ``PPRINT/NECK,d,h``: diameter and upper end of a lollipop's neck, for which CUTTER
has no word; CUTTER says its ball.
"""

from __future__ import annotations

import re

import numpy as np

from freecad_fiveaxis.core.base.number_text import Choice, Column, table
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.tool import Cutter, apt_numbers, flank_numbers, neck_numbers
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .head import ClHead

POSITION_DECIMALS, AXIS_DECIMALS, FEED_DECIMALS = 6, 9, 4


def write_apt(
    path: CLPath, cutter: Cutter, title: str, progress: Progress = silent, head: ClHead | None = None
) -> bytes:
    """Return the CL file of a path: positions with 6 decimals, mm, axes with 9, feeds mm/min. ASCII, lines
    end in LF.

    ``head``: what it says of tool, spindle and coolant (None: tool 1); the cutter's size is ``cutter``'s.
    """
    begin, end = _frame(cutter, title, head or ClHead(tool=1))
    rapid, link = path.motion == Motion.RAPID, path.motion == Motion.LINK
    feed_stated = _new_value(path.feed, ~rapid)
    link_stated = _new_value(link.astype(np.float64), ~rapid)
    if len(link_stated):
        link_stated[:1] &= link[:1]
    axes = [Column(b",", path.axis[:, k], AXIS_DECIMALS) for k in range(3)]
    rows = table(
        [
            Choice(
                np.where(link_stated, 1 + link, 0), (b"", b"PPRINT/MOTION,CUT\n", b"PPRINT/MOTION,LINK\n")
            ),
            Column(b"FEDRAT/", path.feed, FEED_DECIMALS, feed_stated),
            Choice(feed_stated.view(np.int8), (b"", b",MMPM\n")),
            Choice(rapid.view(np.int8), (b"GOTO/", b"RAPID\nGOTO/")),
            *(Column(b"," if k else b"", path.tip[:, k], POSITION_DECIMALS) for k in range(3)),
            *axes,
        ],
        progress=progress,
    )
    return begin + rows + end


def _frame(cutter: Cutter, title: str, head: ClHead) -> tuple[bytes, bytes]:
    """Return what stands before and after the path."""
    plain = re.sub(r"[^A-Za-z0-9 ._+-]", "-", title)[:60]
    begin = [
        f"PARTNO {plain}",
        "UNITS/MM",
        "CUTTER/" + ",".join(f"{number:.4f}" for number in apt_numbers(cutter)),
    ]
    begin += (
        ["PPRINT/NECK," + ",".join(f"{number:.4f}" for number in neck)]
        if (neck := neck_numbers(cutter))
        else []
    )
    begin += (
        ["PPRINT/FLANK," + ",".join(f"{number:.4f}" for number in flank)]
        if (flank := flank_numbers(cutter))
        else []
    )
    begin += [] if head.tool is None else [f"LOADTL/{head.tool}"]
    begin += [f"SPINDL/RPM,{head.speed:.10g},CLW"] if head.speed > 0.0 else []
    begin += ["COOLNT/ON"] if head.coolant else []
    end = ["COOLNT/OFF"] if head.coolant else []
    end += ["SPINDL/OFF"] if head.speed > 0.0 else []
    return "\n".join([*begin, "MULTAX/ON", ""]).encode("ascii"), "\n".join([*end, "END", "FINI", ""]).encode(
        "ascii"
    )


def _new_value(value: Floats, rows: Bools) -> Bools:
    """Where, among the chosen rows, the value differs from that of the chosen row before."""
    at = np.flatnonzero(rows)
    stated = np.zeros(len(value), np.bool_)
    stated[at] = np.diff(value[at], prepend=np.nan) != 0.0
    return stated
