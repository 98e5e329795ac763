# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one line of a program with variables and jumps means: parsed when it is run for the first time.

block     words with numbers or values (X[#1+2]), and settings of variables (#1=5), which take effect after
          the words were read.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from freecad_fiveaxis.core.base.sentences import say

from .expressions import NUMBER, Expression, Parser, Unread, Value, Variables, number
from .flow import DO, END, O_WORD, without_number

SPECIAL = re.compile(
    r"[#\[\]=<>@^]|O[0-9]|M0*(?:2|30|7[0-3]|9[789])(?![0-9])|G0*6[567](?![0-9])|GOTO|IF|WHILE|END|DO|THEN"
)
"""A line without any of these is a block of words with numbers."""
VALUES = re.compile(r"\{([^{}]*)\}")
TEXT = '"'
"""Before a line of Siemens' that stays text, with values in braces."""
LARGEST = 1e12
ARGUMENTS = dict(
    zip("ABCIJKDEFHMQRSTUVWXYZ", (1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, *range(17, 27)), strict=True)
)
"""Where G65 puts its words (Fanuc B-63324EN, 15.6: argument specification I)."""
Setting = Callable[[Variables, Value], None]


@dataclass(frozen=True, eq=False)
class Block:
    """``words``: letter, text as it stands, or value; ``settings``: of variables. ``calls``: M97, M98, M99,
    G65 or ''."""

    words: tuple[tuple[str, str, Expression | None], ...]
    settings: tuple[tuple[Setting, Expression], ...] = ()
    calls: str = ""
    ends: bool = False

    def row(self, known: Variables, without: str = "") -> tuple[str, dict[str, Value]]:
        """Return the line with numbers for values, without the words of the letters ``without``, whose values
        come beside it."""
        text, values = [], dict[str, Value]()
        for letter, literal, value in self.words:
            what = float(literal) if value is None else value(known)
            values[letter] = what
            if what is not None and letter not in without:
                text.append(letter + (literal if value is None else write_number(what)))
        return " ".join(text), values

    def set(self, known: Variables) -> None:
        """Set its variables, all from the values that were there before."""
        values = [(setting, value(known)) for setting, value in self.settings]
        for setting, value in values:
            setting(known, value)


@dataclass(frozen=True, eq=False)
class OWord:
    """``value``: the condition, count or result; ``arguments``: of a call."""

    name: str
    word: str
    value: Expression | None = None
    arguments: tuple[Expression, ...] = ()


@dataclass(frozen=True, eq=False)
class Macro:
    """WHILE (``do``: its line ends in DO), IF ... GOTO or THEN, GOTO, DO, END."""

    word: str
    condition: Expression | None = None
    to: Expression | None = None
    then: Block | None = None


@dataclass(frozen=True, eq=False)
class Text:
    """A line of Siemens': ``parts`` as they stand, with a value between each two of them."""

    parts: tuple[str, ...]
    values: tuple[Expression, ...]

    def row(self, known: Variables) -> str:
        """Return the line with numbers for its values."""
        numbers = [*(write_number(number(value(known))) for value in self.values), ""]
        return "".join(part + value for part, value in zip(self.parts, numbers, strict=True))


Statement = Block | OWord | Macro | Text


def write_number(value: float) -> str:
    """Return a number as words have it: with a decimal point, for it means what it says whatever the least
    increment."""
    if not abs(value) < LARGEST:
        raise Unread(say("a value beyond all words"))
    return f"{value:.10f}"


def statement(line: str, words: tuple[str, str] | None, fanuc: bool) -> Statement:
    """Return what a line means, without blanks and in capitals; ``words``: name and keyword where it is an
    O-word line.

    Raises Unread for what is not known."""
    line = without_number(line)
    if words is not None:
        return _o_word(line, *words, fanuc)
    if line[:1] == TEXT:
        parts = VALUES.split(line[1:])
        return Text(tuple(parts[::2]), tuple(_whole(part, fanuc) for part in parts[1::2]))
    parser = Parser(line, fanuc)
    if parser.takes("WHILE["):
        condition = parser.parse_bracket()
        _needs_number(DO.match(parser.rest()), line)
        return Macro("WHILE", condition)
    if parser.takes("IF["):
        condition = parser.parse_bracket()
        if parser.takes("THEN"):
            return Macro("THEN", condition, then=_block(parser, fanuc))
        parser.needs("GOTO")
        return Macro("GOTO", condition, _last(parser))
    if parser.takes("GOTO"):
        return Macro("GOTO", None, _last(parser))
    if line[:2] == "DO" or line[:3] == "END":
        _needs_number((END if line[:3] == "END" else DO).match(line), line)
        return Macro("END" if line[:3] == "END" else "DO")
    return _block(parser, fanuc)


def _needs_number(found: re.Match[str] | None, line: str) -> None:
    """Raise Unread for a DO or END that pairs with none: only with a number behind it is it one."""
    if not found:
        raise Unread(say("{line} lacks the number of its loop: DO1 ... END1", line=repr(line[:20])))


def _whole(text: str, fanuc: bool) -> Expression:
    parser = Parser(text, fanuc)
    value = parser.expression()
    if parser.rest():
        raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
    return value


def _last(parser: Parser) -> Expression:
    value = parser.value()
    if parser.rest():
        raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
    return value


def _o_word(line: str, name: str, word: str, fanuc: bool) -> OWord:
    found = O_WORD.match(line)
    parser, values = Parser(line, fanuc, found.end() if found else 0), []
    while parser.takes("["):
        values.append(parser.parse_bracket())
    if parser.rest():
        raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
    if word in ("IF", "ELSEIF", "WHILE", "UNTIL", "REPEAT") and len(values) != 1:
        raise Unread(say("{word} has no condition in brackets", word=word))
    return OWord(name, word, values[0] if values else None, tuple(values))


def _block(parser: Parser, fanuc: bool) -> Block:
    words, settings = list[tuple[str, str, Expression | None]](), list[tuple[Setting, Expression]]()
    while rest := parser.rest():
        if parser.takes("#"):
            setting = parser.variable()[1]
            parser.needs("=")
            settings.append((setting, parser.expression() if fanuc else parser.value()))
        elif rest[0].isalpha():  # a small one is a private word
            parser.at += 1
            words.append(_word(parser, rest[0]))
        else:
            raise Unread(say("{rest} is not known here", rest=repr(rest[:20])))
    return Block(tuple(words), tuple(settings), *_kind(words, fanuc))


def _word(parser: Parser, letter: str) -> tuple[str, str, Expression | None]:
    begin = parser.at
    sign = parser.rest()[:1] in ("+", "-")
    parser.at += sign
    if parser.match(NUMBER):
        return letter, parser.text[begin : parser.at], None
    parser.at = begin
    return letter, "", parser.value()


def _kind(words: list[tuple[str, str, Expression | None]], fanuc: bool) -> tuple[str, bool]:
    """Return the call that a block of words is, if any, and whether it ends the program."""
    codes = {(letter, float(text)) for letter, text, value in words if value is None and letter in "GM"}
    if not fanuc and codes & STATES:
        raise Unread(say("M70 to M73 keep and restore modes"))
    if ("G", 66.0) in codes or ("G", 66.1) in codes:
        raise Unread(say("G66 calls a program after each block"))
    call = next((f"{letter}{code:g}" for letter, code in sorted(codes) if (letter, code) in CALLS), "")
    return call, bool(codes & {("M", 2.0), ("M", 30.0)})


STATES = {("M", 70.0), ("M", 71.0), ("M", 72.0), ("M", 73.0)}
CALLS = {("M", 97.0), ("M", 98.0), ("M", 99.0), ("G", 65.0)}
__all__ = [
    "ARGUMENTS",
    "SPECIAL",
    "TEXT",
    "Block",
    "Macro",
    "OWord",
    "Statement",
    "Text",
    "number",
    "statement",
]
