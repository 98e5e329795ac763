# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens 840D programs with R parameters and jumps: their lines said again as the O-words that :mod:`.interpreter` runs.

R1=R2*2+SIN(30)   an R parameter; X=R1 F=R4    words of one letter with values. One that was never set only the control knows.
CYCLE81(R1,0,2,-R2)   the values of drilling cycles.
IF .. ELSE .. ENDIF, WHILE, LOOP, REPEAT .. UNTIL;   IF .. GOTOF LABEL, GOTOB, GOTO, to LABEL: or a block number.

Source: 840D sl, Programming Manual Job Planning (arithmetic parameters; program jumps; control structures).
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .siemens_cycles import split_arguments

MARK = re.compile(rb"(?<![A-Z_$])R *[0-9\[]|(?<![A-Z_$])(?:IF|WHILE|FOR|LOOP|UNTIL|GOTO[FB]?)\b")
"""What shows that a text has R parameters or jumps."""
HEAD = re.compile(r"(?:N([0-9]+))?(?:([A-Z_]{2}[A-Z0-9_]*):)?")
PARAMETER = re.compile(r"(?<![A-Z_$])R([0-9]+)")
USED = re.compile(r"(?<![A-Z_$])R[0-9\[]")
KEYWORD = re.compile(r"(ENDIF|ENDWHILE|ENDLOOP|ELSE|IF|WHILE|FOR(?=R[0-9])|ENDFOR|LOOP|REPEAT|UNTIL|GOTO[FB]?)")
JUMP = re.compile(r"(.*)GOTO([FB]?)([A-Z0-9_]+)$")
ADDRESS = re.compile(r"(?<![A-Z_$])(?=[A-QS-Z](?:=|[-+]?[0-9.]))")
"""Before each word of a block."""
SIGN = re.compile(rb"R *[0-9\[]")
"""What each text with R parameters has, searched faster than :data:`MARK`."""
CYCLE = re.compile(r"((?:MCALL)?CYCLE(?:8[1-9]|840))\((.*)\)$")
ENDS = re.compile(r"M(?:0*2|17|30)(?![0-9=])")
RELATIONS = (("==", "EQ"), ("<>", "NE"), (">=", "GE"), ("<=", "LE"), (">", "GT"), ("<", "LT"))
OPENS = {"IF": "IF", "WHILE": "WHILE", "LOOP": "WHILE", "REPEAT": "DO"}
CLOSES = {
    "ENDIF": ("IF", "ENDIF"),
    "ENDWHILE": ("WHILE", "ENDWHILE"),
    "ENDLOOP": ("LOOP", "ENDWHILE"),
    "UNTIL": ("REPEAT", "WHILE"),
}
UNKNOWN = re.compile(r"DIV|NOT|B_|TRUNC|ATAN2|POT|CR=|[ABC][0-9]=|[AID]C\[|R\[|\$|,")


def said_again(lines: list[str]) -> tuple[list[str], list[bool]]:
    """The lines, without blanks and in capitals, as O-words, and which are no more than blocks as they stand.

    Raises Unread for what is not known."""
    labels = {found[2]: 900_000 + at for at, line in enumerate(lines) if (found := HEAD.match(line)) and found[2]}
    again, plain, opened = list[str](), list[bool](), list[tuple[str, int]]()
    for at, line in enumerate(lines):
        try:
            new = _again(line, at, labels, opened)
        except Unread as refused:
            raise Unread(refused.reason, at) from None
        again.append(line if new is None else new)
        plain.append(new is None)
    if opened:
        raise Unread(say("{word} has no end", word=opened[-1][0]), opened[-1][1])
    return again, plain


def _again(line: str, at: int, labels: dict[str, int], opened: list[tuple[str, int]]) -> str | None:
    """One line as O-words; None where it stays as it is."""
    head = HEAD.match(line)
    number, rest = (head[1], line[head.end() :]) if head else (None, line)
    mark = f"N{labels[head[2]]}" if head and head[2] else f"N{number}" if number else ""
    found = KEYWORD.match(rest)
    if found and (jump := JUMP.match(rest)):
        return mark + _jump(jump, labels)
    if found:
        return _keyword(found[1], rest[found.end() :], at, opened)
    if USED.search(rest) and (cycle := CYCLE.match(rest)):
        return mark + cycle[1] + "(" + ",".join(_expression(part) for part in split_arguments(cycle[2])) + ")"
    if USED.search(rest):
        return mark + (_set(rest) if rest.startswith("R") else _words(rest))
    if ENDS.fullmatch(rest):
        return "M30"
    return mark + rest if head and head[2] and not rest else None


def _expression(text: str) -> str:
    """Relations, brackets and parameters in the other way of writing."""
    text = text.replace("(", "[").replace(")", "]")
    if found := UNKNOWN.search(text):
        raise Unread(say("{rest} is not known here", rest=repr(found[0])))
    if "AND" in text and "OR" in text:
        raise Unread(say("AND beside OR without a line of its own"))
    for one, other in RELATIONS:
        text = text.replace(one, other)
    return PARAMETER.sub(r"#<R\1>", text)


def _words(rest: str) -> str:
    """G1X=R1*2F100: values in brackets."""
    told = []
    for part in ADDRESS.split(rest):
        letter, given, value = part.partition("=")
        if (given and len(letter) != 1) or (not given and USED.search(part)):
            raise Unread(say("{rest} is not known here", rest=repr(part[:20])))
        told.append(f"{letter}[{_expression(value)}]" if given else part)
    return "".join(told)


def _set(rest: str) -> str:
    """R1=R2*2 R3=5: each value in brackets of its own."""
    parts = re.split(r"(?<![-+*/(=A-Z])(?=R[0-9]+=)", rest)
    told = [part.split("=", 1) for part in parts if part]
    if any(len(one) != 2 or (len(told) > 1 and USED.search(one[1])) for one in told):
        raise Unread(say("{rest} is not known here", rest=repr(rest[:20])))
    return "".join(f"{_expression(name)}=[{_expression(value)}]" for name, value in told)


def _jump(jump: re.Match[str], labels: dict[str, int]) -> str:
    condition, target = jump[1], jump[3]
    to = labels.get(target, int(target[1:]) if re.fullmatch("N[0-9]+", target) else None)
    if to is None:
        raise Unread(say("{label} stands in no line of this program", label=target))
    return (f"IF[{_expression(condition[2:])}]" if condition else "") + f"GOTO{to}"


def _keyword(word: str, rest: str, at: int, opened: list[tuple[str, int]]) -> str:
    if word in OPENS:
        opened.append((word, at))
        condition = {"LOOP": "[1]", "REPEAT": ""}.get(word)
        return f"O{at + 1}{OPENS[word]}" + (f"[{_expression(rest)}]" if condition is None else condition)
    if word == "ELSE" and opened and opened[-1][0] == "IF":
        return f"O{opened[-1][1] + 1}ELSE"
    if word not in CLOSES or not opened or opened[-1][0] != CLOSES[word][0]:
        raise Unread(say("{rest} is not known here", rest=repr(word)))
    begin = opened.pop()[1]
    return f"O{begin + 1}{CLOSES[word][1]}" + (f"[[{_expression(rest)}]EQ0]" if word == "UNTIL" else "")
