# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts within texts: a clause that goes on in the middle of a sentence, a text that begins one."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from .sentences import CONTEXT, Part, Sentence, Template, Translate

CLAUSE = re.compile(r"[.:;] ")
"""What ends a clause, where it is in no parentheses; a point within a number does not."""


ALL_SMALL = Template("words that begin with a small letter within a sentence: all")
"""In a language whose nouns have capitals its translation is the list of all other words with which a text begins."""


@dataclass(frozen=True)
class Clause(Part):
    """The first clause of a text, as it goes on in the middle of a sentence; ``small``: the words, in small letters, that lose
    their capital there, or :data:`ALL_SMALL`."""

    text: str
    small: str = ALL_SMALL

    def __str__(self) -> str:
        text = str(self.text)
        ends = (
            end.start() for end in CLAUSE.finditer(text) if text.count("(", 0, end.start()) == text.count(")", 0, end.start())
        )
        clause = text[: next(ends, len(text))].rstrip(".")
        first = clause.split(" ", 1)[0].lower()
        small = clause[1:2].islower() if self.small == ALL_SMALL else first in self.small.split()
        return clause[:1].lower() + clause[1:] if small else clause

    def rendered(self, render: Callable[[str], str], translate: Translate) -> str:
        """Give the clause in another language; that of a German text keeps the capital of a noun."""
        return str(Clause(render(self.text), translate(CONTEXT, ALL_SMALL)))


def first_clause(text: str) -> Sentence:
    """The first clause of a finding's text, in small letters, as a sentence of its own; what another file's finding is led in
    with ("CL file, line 3: ...") is left out."""
    if isinstance(text, Sentence):
        text = text.values.get("finding", text)
    return Sentence("{clause}", {"clause": Clause(text)}, translated=False)


@dataclass(frozen=True)
class Beginning(Part):
    """A text that begins a sentence: with a capital letter."""

    text: str

    def __str__(self) -> str:
        return str(self.text)[:1].upper() + str(self.text)[1:]

    def rendered(self, render: Callable[[str], str], translate: Translate) -> str:
        """Give the text in another language, with a capital letter."""
        return str(Beginning(render(self.text)))


def beginning(text: str) -> Sentence:
    """A text with a capital letter, as a sentence of its own."""
    return Sentence("{text}", {"text": Beginning(text)}, translated=False)
