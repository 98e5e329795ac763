# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another spindle speed, or coolant, for a program that is made and proven: only its head is written anew.

The head has as many lines as before, so blocks keep their line numbers, and every figure of the proof stands.
"""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.nc.writer import write_nc

from .options import nc_title, post_options
from .programs import MilledProgram, Result
from .safe_start import find_spindle_off
from .settings import Settings


def without_speed(settings: Settings) -> Settings:
    """Return the settings with spindle and coolant as if neither was given: two jobs that agree in these
    differ in their heads only."""
    return replace(settings, head=replace(settings.head, spindle=None, coolant="off"))


def change_speed(result: Result, settings: Settings, progress: Progress = silent) -> Result:
    """Give the milled ``result`` the spindle speed and coolant of ``settings``, which are its own but for
    these two."""
    draft = result.draft
    assert isinstance(draft, MilledProgram)
    head = replace(draft.settings.head, spindle=settings.head.spindle, coolant=settings.head.coolant)
    settings = replace(draft.settings, head=head)
    draft = replace(draft, settings=settings)
    nc = write_nc(
        draft.program,
        draft.dialect,
        nc_title(settings, draft.machine),
        post_options(settings),
        progress,
        draft.plane.z or 0.0,
    )
    old, new = find_spindle_off(result.draft.settings), find_spindle_off(settings)
    kept = tuple(one for one in draft.findings if one not in old)
    others = tuple(one for one in result.findings if one not in old)
    draft = replace(draft, nc=nc, findings=kept + new)
    return replace(result, draft=draft, findings=_insert_findings(others, kept, new))


def _insert_findings(
    others: tuple[Finding, ...], kept: tuple[Finding, ...], new: tuple[Finding, ...]
) -> tuple[Finding, ...]:
    """Put the ``new`` one about the spindle among the ``others`` of the whole job, behind those ``kept`` of
    the making of the program, of which the proof may have dropped some."""
    draft = {id(one) for one in kept}
    first = next((at for at, one in enumerate(others) if id(one) not in draft), len(others))
    return (*others[:first], *new, *others[first:])
