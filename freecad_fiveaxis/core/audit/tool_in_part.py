# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep the whole tool enters the part (STL) along a program: any cutter, shank and holder, rapids too, by
the gouge check.

A ball cutter alone is measured by :mod:`.against_part`, which knows how far it stays clear as well; where the
check is made for a ball, that gives the numbers of each block and the check the findings.
"""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.sentences import Option, join_sentences, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import check_program
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body

from .against_part import AgainstPart, against_part

REMEDY = say(
    "Are {cutter}, {origin} and the machine those of the program, and does the STL stand at the work zero? "
    "If they are, the part is spoilt.",
    cutter=Option("cutter"),
    origin=Option("origin"),
)


def tool_in_part(
    kinematics: Chain, program: Program, mesh: Mesh, cutter: Cutter, body: Body, tolerance: float,
    progress: Progress = silent,
    rapids: str = INTERPOLATED,
) -> AgainstPart:  # fmt: skip
    """Every block of the program, rapids too, against the part, in the work frame; the rows are those of its
    feed blocks.

    ``body``: cutter, shank and holder; ``rapids``: one of :data:`~.base.rapids.RAPIDS`. Of a cutter that is
    no ball the depth is never below 0, ``clearance`` not known (NaN) and ``place`` that of the part's deepest
    point.
    """
    check = check_program(
        mesh, body, kinematics, program, tolerance, progress=progress, remedy="", rapids=rapids
    )
    findings = _with_remedy(check.findings)
    if is_ball(cutter):
        return replace(
            against_part(kinematics, program, mesh, cutter.radius, tolerance, progress), findings=findings
        )
    rows, entries = feed_blocks(program), check.cutter
    depth, u, place, bound = (
        column[rows - 1] for column in (entries.depth, entries.u, entries.place, entries.bound)
    )
    return AgainstPart(rows, depth, u, place, bound, float("nan"), findings)


def is_ball(cutter: Cutter) -> bool:
    """Whether what it cuts with is one ball."""
    return cutter.touches_as_ball and cutter.taper == 0.0


def _with_remedy(findings: tuple[Finding, ...]) -> tuple[Finding, ...]:
    """Return the first of them asks whether part and program belong together; not where the tool enters on no
    commanded way."""
    if not findings or findings[0].code == Code.INDEPENDENT_RAPID:
        return findings
    first, *others = findings
    return (replace(first, text=join_sentences((first.text, REMEDY))), *others)
