# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes over which the tool is free but never gets away again: how long they are, and why."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import Length, Point, Template
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.hollows import find_hollow_facets
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

_HOLLOW = Template(
    "{length} of the passes, the first at {place}, lie in a closed hollow of the part, which no tool can "
    "enter; they are left out."
)
_TURN = Template(
    "On {length} of the passes, the first at {place}, the tool is free, but the part is over it, and it "
    "cannot get out along its axis; they are left out. Turn the part, or cut this side in another setup."
)
_HOLDER = Template(
    "On {length} of the passes, the first at {place}, the tool is free, but the part is over it, and it "
    "cannot get out along its axis; they are left out. Turn the part or, where it is the holder that is "
    "held, use a smaller holder."
)


def report_no_way_out(path: OffsetPath, rows: Ints, mesh: Mesh, reacher: Reacher) -> tuple[Finding, ...]:
    """Say over which length of ``path`` over ``mesh`` the tool of the ``reacher`` does not get out along its
    axis, where ``rows`` (k,) are all that is kept: first of closed hollows, then of the rest."""
    out = np.ones(len(path.point), np.bool_)
    out[rows] = False
    if not out.any():
        return ()
    hollow = out & find_hollow_facets(mesh)[path.face]
    held = _HOLDER if reacher.holder or reacher.cutter.holder else _TURN
    return (*_report(path, hollow, _HOLLOW), *_report(path, out & ~hollow, held))


def _report(path: OffsetPath, out: Bools, text: Template) -> tuple[Finding, ...]:
    steps, joined = np.linalg.norm(np.diff(path.point, axis=0), axis=1), np.diff(path.polyline) == 0
    length = float(steps[joined & (out[1:] | out[:-1])].sum())
    if not length:
        return ()
    x, y, z = path.point[int(out.argmax())].tolist()
    sentence = text.say(length=Length(length, ".4g"), place=Point((x, y, z)))
    return (report_finding(Code.NO_WAY_OUT, sentence, length, 0.0, place=(x, y, z)),)
