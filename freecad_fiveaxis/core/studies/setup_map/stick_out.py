# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shortest stick-out of the tool with which shank, holder and spindle meet nothing in a setup.

enough     the length that is proposed. With it every block of the program is **proven**, on the machine's
           real way, to keep shank, holder and spindle out of part, fixtures, table and machine; with a length
           shorter by a STEP something was found to be met, so no more than a STEP could be saved.
tried      lengths are multiples of a STEP, but for the present one. It is halved between one that is free and
           one that is not; where the present one is not free, ever longer ones are tried first.

path       proven is the path that was made for the tool as it is set. Where tool axes are chosen by what is
           free of the holder, ``mill`` makes another for another tool, and there less may be enough: no
           length is told to be the shortest of all paths, and one is told to try.

A longer tool is not always the freer one: what is higher above the tip may meet an overhang, or the axes
leave their limits. So the length that is proposed is proven by itself, and says nothing of others.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import (
    Choice,
    Length,
    Option,
    Point,
    Sentence,
    Task,
    join_sentences,
    say,
)
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.tool.stick_out import Stack, clamp_tool
from freecad_fiveaxis.core.tool.text import cutter_text

from .standing import LIMITS, PART, TABLE, Met, Run, Standing, deepest_met, first_entries

STEP = 0.1
"""mm; nobody clamps a tool more exactly."""

LONGER = 80.0
"""mm by which a tool may be longer than it is, within reason, as in the reach map."""

LESS = 10.0
"""mm by which a tool is to be tried shorter where it is given other axes."""

FIRST = 2.5
"""mm by which it is tried to be longer first; then twice as much, and so on."""


Options = tuple[tuple[str, str], ...]
"""Names and values of options."""


@dataclass(frozen=True)
class StickOut:
    """``present`` mm: as it is set; ``enough`` mm: the shortest that is free, None where none up to
    ``longest`` mm is. ``met``: with the present one (None: nothing); ``shorter``: with a length that is
    shorter by a STEP than is enough (None: it cannot be clamped shorter), or where none is free with the one
    of those tried with which the least is met. ``options``: names and values of the options that state the
    length that is enough, those alone that change; an empty value: the option is left out. ``axes_by``: the
    option by which another tool is given another path (None: it is not), and ``to_try``: the options of a
    shorter tool that may do there."""

    present: float
    enough: float | None
    longest: float
    met: Met | None = None
    shorter: Met | None = None
    options: Options = ()
    axes_by: Choice | None = None
    to_try: Options = ()


def find_stick_out(stand: Standing, progress: Progress = silent) -> StickOut | None:
    """Find the shortest stick-out that is free; None where no holder is given, or the part is not known (a CL
    file): then there is nothing that it could be told by. Raises FiveAxisError for the file of a body that
    cannot be used."""
    if not stand.stack.holder or stand.part is None:
        return None
    lengths = _Lengths(stand, progress)
    found, shorter = lengths.search()
    present, longest = stand.stack.stick_out, lengths.at(lengths.last)
    met = lengths.describe(lengths.present)
    if found is None:
        return StickOut(present, None, longest, met, shorter, axes_by=stand.axes_by)
    options = tuple(_options(stand, lengths.at(found)))
    less = max(found - round(LESS / STEP), lengths.first)
    other = stand.axes_by is not None and met is None and less < found
    to_try = tuple(_options(stand, lengths.at(less))) if other else ()
    return StickOut(present, lengths.at(found), longest, met, shorter, options, stand.axes_by, to_try)


class _Meeting(NamedTuple):
    """``blocks`` (k,) that meet what is called so, or of which the contrary is not proven."""

    name: str
    tree: FacetTree
    blocks: Ints


@dataclass(eq=False)
class _Lengths:
    """``met`` of the lengths that were looked at, by their number of STEPs: how deep it is takes longer to
    find than that it is, and is asked of two of them; ``suspects`` of each obstacle: blocks that met it at
    one of them."""

    stand: Standing
    progress: Progress
    met: dict[int, Met | _Meeting | None] = field(default_factory=dict)
    suspects: dict[str, Ints] = field(default_factory=dict)
    run: Run | None = None

    @property
    def present(self) -> int:
        """The present length in STEPs, rounded up."""
        return math.ceil(self.stand.stack.stick_out / STEP - 1e-9)

    @property
    def first(self) -> int:
        """The shortest that there is, and that leaves the tool a length."""
        stand, least = self.stand, self.stand.stack.shortest
        if stand.known:
            least = max(least, stand.stack.stick_out - stand.base.tool_length - stand.back)
        return min(math.ceil(least / STEP - 1e-9), self.present)

    @property
    def last(self) -> int:
        """The longest within reason."""
        return self.present + round(LONGER / STEP)

    def at(self, step: int) -> float:
        """Return a length in mm."""
        return self.stand.stack.stick_out if step == self.present else round(step * STEP, 6)

    def search(self) -> tuple[int | None, Met | None]:
        """Find the shortest free length, and what is met with one that is shorter by a STEP; or None, and the
        least that is met."""
        free = self._free_above()
        if free is None:
            met = filter(None, map(self.describe, self.met))
            return None, min(met, key=lambda one: (not one.depth, one.depth))
        below = [step for step, met in self.met.items() if step < free and met is not None]
        low = max(below, default=self.first - 1)
        if low < self.first and self.is_free(self.first):
            return self.first, None
        low = max(low, self.first)
        while free - low > 1:
            middle = (free + low) // 2
            low, free = (low, middle) if self.is_free(middle) else (middle, free)
        return free, self.describe(low)

    def _free_above(self) -> int | None:
        """Return the present length, or the first free one of those that are tried above it."""
        step, more = self.present, round(FIRST / STEP)
        while not self.is_free(step):
            if step == self.last:
                return None
            step, more = min(self.present + more, self.last), 2 * more
        return step

    def is_free(self, step: int) -> bool:
        """Tell whether it is proven that nothing is met with this length."""
        if step not in self.met:
            self.progress("stick-out", len(self.met) / 24.0)
            self.met[step] = self._look(step)
        return self.met[step] is None

    def describe(self, step: int) -> Met | None:
        """Return what is met with this length; None: nothing, or it was not looked at."""
        met = self.met.get(step)
        if isinstance(met, _Meeting):
            run = self._run(step)
            assert isinstance(run, Run)  # as it was when this was met
            met = self.met[step] = deepest_met(met.name, met.tree, run, met.blocks)
        return met

    def _look(self, step: int) -> Met | _Meeting | None:
        run = self._run(step)
        if isinstance(run, Met):
            return run
        if (beyond := run.leaves_limits) is not None:
            return beyond
        for name, tree in self._obstacles(run):
            none = np.empty(0, np.int64)
            _, body = run.bodies_beside(name)
            blocks = first_entries(
                tree, body, run.swept, self.stand.tolerance, self.suspects.get(name, none), self._quiet
            )
            if len(blocks):
                self.suspects[name] = blocks
                return _Meeting(name, tree, blocks)
        return run.meets_machine(self._quiet)

    def _run(self, step: int) -> Run | Met:
        more = self.at(step) - self.stand.stack.stick_out
        if self.run is None or self.stand.known or self.run.rewinds:  # a rewind retracts the whole tool
            try:
                self.run = self.stand.run(more, self._quiet)
            except (ReachError, SettingsError):  # no cutter is as long as that
                return Met("", LIMITS, 0.0)
            return self.run
        return self.run.with_tool(more)

    def _obstacles(self, run: Run) -> Iterator[tuple[str, FacetTree]]:
        """Yield what is in the way where the machine has no bodies, too; what is met most often comes
        first."""
        if (part := self.stand.turned_part) is not None:
            yield PART, facet_tree(part)
        for one in self.stand.turned_fixtures:
            yield one.name, facet_tree(one.mesh)
        height = self.stand.table_in_work
        if height is not None and (slab := run.table_tree(height)) is not None:
            yield TABLE, slab

    def _quiet(self, stage: str, share: float) -> None:
        self.progress("stick-out", len(self.met) / 24.0)


def _options(stand: Standing, length: float) -> Iterator[tuple[str, str]]:
    """Yield the options of ``mill`` that state a length, and their values."""
    old, new = stand.stack, _tidy(clamp_tool(stand.stack, length))
    if new.cutter != old.cutter:
        yield "cutter", re.sub(r"\.0(?=:|$)", "", cutter_text(new.cutter))
    if new.shank != old.shank:
        yield "shank", ",".join(f"{diameter:.12g}x{long:.12g}" for diameter, long in new.shank)
    if stand.known and length != old.stick_out:
        changed = stand.base.tool_length + stand.back + length - old.stick_out
        yield "tool_length", f"{round(changed, 6):.12g}"


def _tidy(stack: Stack) -> Stack:
    """Return the stack without the last digits that come of adding."""
    shank = tuple((diameter, round(length, 6)) for diameter, length in stack.shank)
    return stack._replace(cutter=replace(stack.cutter, length=round(stack.cutter.length, 6)), shank=shank)


def stick_out_findings(found: StickOut | None) -> Iterator[Finding]:
    """Tell the shortest stick-out, and how it is stated."""
    if found is None:
        return
    if found.enough is None:
        present, met = Length(found.present, ".6g"), found.shorter
        text = say(
            "Tool stick-out: {present} are set, and no length from that up to {longest} keeps shank, holder "
            "and spindle free in the recommended setup.",
            present=present, longest=Length(found.longest, ".6g"),
        )  # fmt: skip
        last = say("Use a smaller holder, lean the tool otherwise, or clamp the part otherwise.")
        yield report_finding(
            Code.NO_STICK_OUT_FREE,
            join_sentences((text, _say_met(met), _say_path(found), last)),
            found.longest,
        )
        return
    yield _enough_finding(found, found.enough)


def _enough_finding(found: StickOut, least: float) -> Finding:
    enough, present = Length(least, ".6g"), Length(found.present, ".6g")
    given = _give_words(found.options)
    if found.met is not None:
        text = say("Tool stick-out: {enough} are needed, {present} are set.", enough=enough, present=present)
        text = join_sentences((text, _say_met(found.met), given, _say_path(found)))
        return report_finding(Code.STICK_OUT_TOO_SHORT, text, least, found.present)
    if given:
        text = say("Tool stick-out: {enough} are enough, {present} are set.", enough=enough, present=present)
    else:
        text = say("Tool stick-out: the {present} that are set are the least.", present=present)
    text = join_sentences((text, given, _shorter_words(found), _say_path(found), _say_what_to_try(found)))
    return report_finding(Code.STICK_OUT_ENOUGH, text, least)


def _say_path(found: StickOut) -> Sentence | str:
    """Tell of which path that is proven; nothing where every tool has the same."""
    if found.axes_by is None:
        return ""
    return say(
        "This is told of the path as it was made for {present}: by {axes_by} another tool is given another "
        "path.",
        present=Length(found.present, ".6g"), axes_by=found.axes_by,
    )  # fmt: skip


def _say_what_to_try(found: StickOut) -> Sentence | str:
    if not found.to_try:
        return ""
    return say(
        "A shorter one may then do: to try it, run {task} with {options}; it says whether that is free.",
        task=Task("mill"), options=_option_words(found.to_try),
    )  # fmt: skip


def _give_words(options: Options) -> Sentence | str:
    """Return the options to give, as a sentence; empty where nothing changes."""
    return say("Give {options}.", options=_option_words(options)) if options else ""


def _option_words(options: Options) -> Sentence:
    """Return options in words."""
    parts = [
        say("{option} {value}", option=Option(name), value=value)
        if value
        else say("no {option}", option=Option(name))
        for name, value in options
    ]
    return join_sentences(parts, ", ")


def _shorter_words(found: StickOut) -> Sentence | str:
    if found.shorter is None:
        return say("It cannot be clamped shorter.")
    return say("Shorter by {step}: {met}", step=Length(STEP), met=_say_met(found.shorter))


def _say_met(met: Met | None) -> Sentence | str:
    """Return what is met, as a sentence."""
    if met is None:
        return ""
    if met.entered == LIMITS:
        over = Length(met.depth, ".3g")
        beyond = say("The axes leave their limits by {over}.", over=over)
        return beyond if met.depth else say("The machine cannot take the tool along the path.")
    if met.near:
        return say(
            "The {part} comes nearer to {name} than the clearance.", part=met.enters, name=name_met(met)
        )
    if met.depth == 0.0:
        return say(
            "It is not proven that the {part} stays out of {name}.", part=met.enters, name=name_met(met)
        )
    words = say(
        "The {part} goes at least {depth} into {name}.",
        part=met.enters, depth=Length(met.depth, ".3g"), name=name_met(met),
    )  # fmt: skip
    if met.place is None:
        return words
    return say(
        "The {part} goes at least {depth} into {name} at {at}.",
        part=met.enters, depth=Length(met.depth, ".3g"), name=name_met(met), at=Point(met.place, ".4g"),
    )  # fmt: skip


def stick_out_record(found: StickOut | None) -> dict[str, object] | None:
    """Return the same for scripts, mm; ``options`` as ``mill`` takes them, null: the option is left out."""
    if found is None:
        return None
    return {
        "present": found.present, "enough": found.enough, "longest": found.longest,
        "met": record_met(found.met), "shorter": record_met(found.shorter),
        "options": {name: value or None for name, value in found.options},
        "axes_by": None if found.axes_by is None else str(found.axes_by),
        "to_try": {name: value or None for name, value in found.to_try},
    }  # fmt: skip


def record_met(met: Met | None) -> dict[str, object] | None:
    """Return what is met, for scripts."""
    return None if met is None else met._asdict()


def name_met(met: Met) -> Sentence | str:
    """Return what is entered, as it is called."""
    names = {PART: say("the part"), TABLE: say("the table")}
    return names.get(met.entered, met.entered)
