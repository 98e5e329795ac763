# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a path came to, in the user's units: the verdict as a traffic light, then passes, blocks, time,
deviation, poor blocks."""

from __future__ import annotations

import html
from typing import Any

from freecad_fiveaxis.app import wording
from freecad_fiveaxis.app.decimal_sign import write_number
from freecad_fiveaxis.app.results import read_judged
from freecad_fiveaxis.app.units import length_text
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets, translate
from freecad_fiveaxis.gui.verdict_label import VerdictLabel

from .panel_widget import TextArea


def summary_lines(obj: Any) -> list[tuple[str, str]]:
    """Label and value of each line, from the result properties of a Toolpath or an Audit."""
    lines = [(translate("FiveAxis", "Passes"), str(obj.Passes))] if obj.Passes else []
    largest, bound = read_judged(obj)
    measured = [
        (translate("FiveAxis", "Largest deviation"), length(largest)),
        (translate("FiveAxis", "Proven bound"), length(bound)),
    ]
    if largest != obj.MaxSegmentDeviation.Value:
        of_centre, of_tip = (
            translate("FiveAxis", "{length} (centre)"),
            translate("FiveAxis", "Deviation of the tip"),
        )
        measured = [(name, of_centre.format(length=value)) for name, value in measured]
        measured.append((of_tip, length(obj.MaxSegmentDeviation)))
    if (
        obj.GuidedBlocks
    ):  # between their ends nothing is known of those blocks: their zeros are no measurements
        ends_only = translate("FiveAxis", "{count}, verified at their end points only").format(
            count=obj.GuidedBlocks
        )
        guided = (translate("FiveAxis", "Tip guided (RTCP)"), ends_only)
        others = [
            (translate("FiveAxis", "{name}, other blocks").format(name=name), value)
            for name, value in measured
        ]
        measured = [guided, *(others if bound > 0.0 else [])]
    return [
        *lines,
        (translate("FiveAxis", "Blocks"), str(obj.Blocks)),
        (translate("FiveAxis", "Time"), clock(float(getattr(obj.Time, "Value", obj.Time)))),
        *measured,
        (translate("FiveAxis", "Singular blocks"), str(obj.SingularBlocks)),
        (translate("FiveAxis", "Blocks over tolerance"), str(obj.OverTolerance)),
        (translate("FiveAxis", "Worst NC line"), str(obj.WorstLine or translate("FiveAxis", "none"))),
    ]


CURES = (
    "linearized", "rotary-words-even", "axis-led-past-pole", "axis-left-near-pole", "tilted", "lifted",
    "left-out", "uncut",
)  # fmt: skip
"""Codes of what linearize, deform and the cures of gouges say of their work."""


def list_cures(obj: Any) -> list[str]:
    """Return what was done against deviation and gouges, in sentences; after opening a document only once it
    is computed again."""
    last = getattr(obj.Proxy, "last", None)
    return (
        []
        if last is None
        else [wording.localize(one.text) for one in last.figures.findings if one.code in CURES]
    )


def gravest(obj: Any) -> str:
    """Return the gravest finding of an object that was computed since its document was opened, else the first
    one."""
    last = getattr(obj.Proxy, "last", None)
    if last is not None and last.figures.findings:
        return wording.localize(max(last.figures.findings, key=lambda finding: finding.severity).text)
    return obj.Findings[0] if obj.Findings else ""


def length(value: Any) -> str:
    """Return a length (quantity, or mm) in the user's units with four digits."""
    return length_text(float(getattr(value, "Value", value)))


def clock(seconds: float) -> str:
    """Seconds as ``1:02:03``, or as ``4.2 s`` below a minute."""
    if seconds < 60.0:
        return translate("FiveAxis", "{} s").format(write_number(f"{seconds:.1f}"))
    whole = round(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02d}:{whole % 60:02d}"


class Summary(QtWidgets.QGroupBox):
    """A box that shows the last calculation, or says that there is none of these settings."""

    def __init__(self) -> None:
        super().__init__(translate("FiveAxis", "Summary"))
        self.verdict = VerdictLabel("verdict")
        self.text = QtWidgets.QLabel()
        self.text.setObjectName("summary")
        self.text.setWordWrap(True)
        self.text.setAlignment(QtCore.Qt.AlignTop)
        self.area = TextArea(self.text)
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(self.verdict)
        column.addWidget(self.area)
        self.forget()

    def tell(self, text: str) -> None:
        """Show a text (HTML) from its beginning."""
        self.text.setText(text)
        self.area.verticalScrollBar().setValue(0)
        self.area.updateGeometry()

    def forget(self) -> None:
        """Forget the figures: the settings have changed since the last calculation."""
        self.verdict.show_verdict(None)
        self.tell(translate("FiveAxis", "Press Calculate to see what these settings come to."))

    def show_result(self, obj: Any) -> None:
        """Show the figures of the object's last computation, and the gravest of its findings."""
        cells = "".join(
            f"<tr><td>{label}&nbsp;</td><td><b>{html.escape(value)}</b></td></tr>"
            for label, value in summary_lines(obj)
        )
        sentences = dict.fromkeys((*list_cures(obj), gravest(obj)))
        found = "".join(f"<p>{html.escape(text)}</p>" for text in sentences if text)
        self.verdict.show_verdict(obj)
        self.tell(f"<table>{cells}</table>{found}")
