# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures in the project's own texts that count what it ships: they are those of the lists."""

import re
from pathlib import Path

import pytest

from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "Overview.md", *sorted((ROOT / "docs").rglob("*.md"))]
NUMBERS = [
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
    "thirteen",
    "fourteen",
    "fifteen",
]
OF_MACHINES = re.compile(
    r"\b([a-z]+|\d+) (?:shipped machines|machines are shipped|are shipped\b)", re.IGNORECASE
)
OF_KINEMATICS = re.compile(r"\b([a-z]+|\d+) kinematics of the [a-z]+ shipped machines", re.IGNORECASE)


def find_figures(pattern):
    """What the pages say, as (page, number)."""
    found = [
        (page.name, word) for page in PAGES for word in pattern.findall(page.read_text(encoding="utf-8"))
    ]
    words = [(name, word.lower()) for name, word in found]
    return [
        (name, int(word) if word.isdigit() else NUMBERS.index(word))
        for name, word in words
        if word.isdigit() or word in NUMBERS
    ]


def count_kinematics():
    machines = [load_machine(name) for name in list_shipped_machines()]
    return len(
        {
            (
                one.gauge_point,
                tuple((axis.letter, axis.side, axis.direction, axis.point) for axis in one.axes),
            )
            for one in machines
        }
    )


@pytest.mark.parametrize(
    ("pattern", "count", "least"),
    [(OF_MACHINES, lambda: len(list_shipped_machines()), {"README.md", "controllers.md", "recover.md"}),
     (OF_KINEMATICS, count_kinematics, {"controllers.md", "recover.md"})],
    ids=["machines", "kinematics"],
)  # fmt: skip
def test_the_texts_count_as_many_machines_as_are_shipped(pattern, count, least):
    figures = find_figures(pattern)
    assert least <= {name for name, _ in figures}
    assert {number for _, number in figures} == {count()}


def test_no_page_counts_machines_in_words_that_nobody_compares():
    """`the eight machines` without `shipped` would be read over."""
    loose = re.compile(r"\bthe (?:" + "|".join(NUMBERS[3:]) + r") machines\b")
    assert not [page.name for page in PAGES if loose.search(page.read_text(encoding="utf-8"))]
