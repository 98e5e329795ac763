# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the player says of the moment: NC line, joints, deviation, time; in the user's units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.app.units import INCH, inches
from freecad_fiveaxis.core.base.findings import Finding, Hit
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.motion.program import find_unknown_ways
from freecad_fiveaxis.core.report import Figures
from freecad_fiveaxis.core.report.playback import NCLines, Pose
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.gui.panels.triple import Wide
from freecad_fiveaxis.gui.qt import QtGui, QtWidgets, translate
from freecad_fiveaxis.gui.scene.units import length_text

LEAST = 1e-6
"""mm; less than that is rounding, of words that are given to a ten-thousandth."""

HEADING = 88
"""Pixels of the words before a value."""

ROUND_UP = 1.0 + 5e-5
"""A bound must not become less by being shown with five digits."""


class Readout:
    """A form of labels; ``widget`` goes into the panel."""

    def __init__(self, figures: Figures, lines: NCLines) -> None:
        self.widget = Wide()
        self.rows = QtWidgets.QFormLayout(self.widget)
        self.widget.widened.connect(self._keep_height)
        self.rows.setContentsMargins(0, 0, 0, 0)
        self.rows.setVerticalSpacing(2)
        self.hit = _label("hit")
        font = self.hit.font()
        font.setBold(True)
        self.hit.setFont(font)
        self.hit.setWordWrap(True)
        self.rows.addRow(self.hit)
        self.line, self.text = self._row("line", translate("FiveAxis", "NC line")), _code("nc")
        self.rows.addRow(self.text)
        self.block = self._row("block", translate("FiveAxis", "Block"))
        self.clock = self._row("clock", translate("FiveAxis", "Time"))
        letters = figures.program.letters
        self.joints = {
            at: self._row(f"joint_{letters[at]}", letters[at]) for at in find_physical_columns(letters)
        }
        self.gap = self._row("gap", translate("FiveAxis", "Tip off its segment"))
        self.most = self._row("most", translate("FiveAxis", "Most in block"))
        self.bound = self._row("bound", translate("FiveAxis", "Proven below"))
        self.most.setToolTip(translate("FiveAxis", "The largest distance in this block"))
        self.bound.setToolTip(
            translate("FiveAxis", "What the distance is proven to stay below, all through this block")
        )
        self.note = _label("note")
        self.note.setWordWrap(True)
        self.rows.addRow(self.note)
        self.use(figures, lines)

    def use(self, figures: Figures, lines: NCLines) -> None:
        """Speak of another result of the same path."""
        self.figures, self.lines = figures, lines
        self.hit.setVisible(any(one.hit or one.near for one in figures.findings))
        self._name_point(figures.surface is not None)
        for at, label in self.joints.items():
            self.rows.labelForField(label).setText(figures.program.letters[at])

    def _name_point(self, ball: bool) -> None:
        """Say whose distances these are: a ball's centre's, or the tip's."""
        centre, tip = (
            translate("FiveAxis", "Centre off its segment"),
            translate("FiveAxis", "Tip off its segment"),
        )
        of_centre = translate(
            "FiveAxis",
            "How far the ball's centre, which makes the surface, is now from its commanded segment",
        )
        of_tip = translate("FiveAxis", "How far the tip is now from the segment that the block commands")
        self.rows.labelForField(self.gap).setText(centre if ball else tip)
        self.gap.setToolTip(of_centre if ball else of_tip)

    def show(self, pose: Pose, whole: float, met: Sequence[Finding] = ()) -> None:
        """Say where a single moment stands; ``whole`` s: the time of the program; ``met``: what collides in
        its block, or nearly does."""
        block, program = int(pose.block), self.figures.program
        line = int(program.line[block])
        self.hit.setText("; ".join(describe_hit(one) for one in met))
        self.hit.setToolTip("\n".join(wording.localize(one.text) for one in met))
        self.line.setText(str(line))
        self.text.setText(self.lines[line])
        self.text.setCursorPosition(0)
        self.block.setText(_of(block, len(program.words) - 1, program.motion[block]))
        self.clock.setText(
            translate("FiveAxis", "{now} of {whole}").format(
                now=_clock(float(pose.seconds)), whole=_clock(whole)
            )
        )
        for at, label in self.joints.items():
            label.setText(joint_text(float(pose.words[at]), at >= 3))
        self.gap.setText(_distance(float(pose.to_chord)))
        self._show_deviation(block)
        if self._is_guided(block):
            for label in (self.gap, self.most, self.bound):
                label.setText("–")
        self._keep_height()

    def _keep_height(self) -> None:
        """Ask for the height of all lines at this width: FreeCAD else takes that of the texts in one line,
        and lays them over each other."""
        height = self.rows.heightForWidth(self.widget.width())
        if height != self.widget.minimumHeight():
            self.widget.setMinimumHeight(height)

    def _is_guided(self, block: int) -> bool:
        """Whether the controller guides the tip in a block: it has no deviation of ours then."""
        guided = self.figures.program.guided
        return guided is not None and bool(guided.on[block])

    def _show_deviation(self, block: int) -> None:
        deviation, tolerance = self.figures.judged, self.figures.tolerance
        most, over = float(deviation.segment[block]), not deviation.segment[block] <= tolerance
        feeds = self.figures.program.motion[block] != Motion.RAPID and block > 0
        self.most.setText(_distance(most))
        bound = float(deviation.bound[block])
        self.bound.setText(length_text(ROUND_UP * bound if bound > LEAST else LEAST, 5))
        font = self.most.font()
        font.setBold(bool(over and feeds))
        self.most.setFont(font)
        self.note.setText(self._note(block, bool(over and feeds)))

    def _note(self, block: int, over: bool) -> str:
        notes = []
        if block == 0:
            notes.append(translate("FiveAxis", "First position: where the machine comes from is not known."))
        elif find_unknown_ways(self.figures.program)[block - 1]:
            notes.append(
                translate("FiveAxis", "Comes from a position of the machine: the way to here is not known.")
            )
        if self._is_guided(block):
            notes.append(
                translate(
                    "FiveAxis",
                    "The controller guides the tip (RTCP); shown is the tip on its straight way while the "
                    "rotary axes turn evenly.",
                )
            )
        if over:
            tip = translate(
                "FiveAxis", "The tip leaves its segment by more than the {tolerance} that are allowed."
            )
            ball = translate(
                "FiveAxis",
                "The ball's centre leaves its segment by more than the {tolerance} that are allowed.",
            )
            allowed = tip if self.figures.surface is None else ball
            notes.append(allowed.format(tolerance=length_text(self.figures.tolerance)))
        if self.figures.singularity.singular[block]:
            near = translate("FiveAxis", "Near the pole: {letter} turns far while the tool hardly leans.")
            notes.append(near.format(letter=self.figures.program.letters[3]))
        return " ".join(notes)

    def _row(self, name: str, title: str) -> Any:
        label, heading = _label(name), QtWidgets.QLabel(title)
        for one in (label, heading):
            one.setWordWrap(True)  # the panel may be too narrow for both in one line
        heading.setFixedWidth(HEADING)
        self.rows.addRow(heading, label)
        return label


def describe_hit(finding: Finding) -> str:
    """Return what is in what, or how near to what, in a few words."""
    near = finding.near
    if near is None:
        return "" if finding.hit is None else collision_text(finding.hit)
    text, distance = (
        translate("FiveAxis", "Near: {enters} within {distance} of {body}"),
        length_text(finding.value or 0.0),
    )
    return text.format(enters=wording.localize(near.enters), distance=distance, body=near.entered)


def collision_text(hit: Hit) -> str:
    """Return what is in what, in a few words."""
    entered = hit.entered or wording.localize(say("part"))
    return translate("FiveAxis", "Collision: {enters} in {entered}").format(
        enters=wording.localize(hit.enters), entered=entered
    )


def joint_text(word: float, rotary: bool) -> str:
    """Return a joint in degrees, or in the user's unit of length, with the digits that the machine is
    told."""
    if rotary:
        return write_number(f"{word:.4f}") + "°"
    number, unit = (f"{word / INCH:.5f}", "in") if inches() else (f"{word:.4f}", "mm")
    return f"{write_number(number)} {unit}"


def _distance(mm: float) -> str:
    return length_text(mm if mm > LEAST else 0.0)


def motion_name(motion: int) -> str:
    """Return what a block does, in a word."""
    return {
        Motion.CUT: translate("FiveAxis", "cut"),
        Motion.FILL: translate("FiveAxis", "around an edge"),
        Motion.LINK: translate("FiveAxis", "link"),
        Motion.RAPID: translate("FiveAxis", "rapid"),
    }[Motion(motion)]


def _of(block: int, last: int, motion: int) -> str:
    return translate("FiveAxis", "{block} of {last}, {motion}").format(
        block=block, last=last, motion=motion_name(motion)
    )


def _clock(seconds: float) -> str:
    minutes, rest = divmod(round(seconds, 2), 60.0)
    hours, minutes = divmod(int(minutes), 60)
    return f"{hours}:{minutes:02d}:{rest:05.2f}" if hours else f"{minutes}:{rest:05.2f}"


def _label(name: str) -> Any:
    label = QtWidgets.QLabel()
    label.setObjectName(name)
    label.setSizePolicy(QtWidgets.QSizePolicy.Ignored, QtWidgets.QSizePolicy.Preferred)
    return label


def _code(name: str) -> Any:
    """Return a line of NC text that can be selected and copied."""
    field = QtWidgets.QLineEdit()
    field.setObjectName(name)
    field.setReadOnly(True)
    field.setMinimumWidth(60)
    field.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.FixedFont))
    return field
