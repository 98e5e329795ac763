# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens 840D programs with R parameters and jumps: their lines said again as the O-words that
:mod:`.interpreter` runs.

R1=R2*2+SIN(30)   an R parameter. DEF REAL _A, B=5: variables of the program, 0 where no value is told; _A=2
                  without a DEF: of the control. One that was never set only the control knows.
X=R1 CR=_A Y=IC(B)    a value after an address; CYCLE81(R1,0,2,-R2): values in brackets. Numbers take their
                      place in the text.
IF .. ELSE .. ENDIF, WHILE, LOOP, REPEAT .. UNTIL;   IF .. GOTOF LABEL, GOTOB, GOTO, to LABEL: or a block
number.

Source: 840D sl, Programming Manual Job Planning (arithmetic parameters; program jumps; control structures).
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .siemens import HARMLESS, MACROS, shifts, without_strings
from .siemens_calls import Whole, find_units, put_unit
from .siemens_cycles import split_arguments
from .siemens_loops import write_loops
from .siemens_names import SETS, by_names, definition, mark_names, unmark_names, value_end
from .statements import TEXT

MARK = re.compile(
    rb"(?<![A-Z_$])R *[0-9\[]|(?<![A-Z0-9_$])(?:DEF|IF|WHILE|FOR|LOOP|UNTIL|REPEATB?|GOTO[FB]?)\b"
    rb"|(?<![A-Z0-9_$])_[A-Z0-9_]+ *="
)
"""What shows that a text has variables or jumps."""
SIGN = re.compile(rb"R *[0-9\[]|_[A-Z0-9_]+ *=")
"""What each text with variables but those of DEF has, searched faster than :data:`MARK`."""
HEAD = re.compile(r"(?:N([0-9]+))?(?:([A-Z_]{2}[A-Z0-9_]*):)?")
PARAMETER = re.compile(r"(?<![A-Z_$])R([0-9]+)")
USED = re.compile(r"(?<![A-Z_$])R[0-9\[]|\xab")
KEYWORD = re.compile(
    r"(ENDIF|ENDWHILE|ENDLOOP|ELSE|IF|WHILE|FOR(?=R[0-9])|ENDFOR|LOOP|REPEAT|UNTIL|GOTO[FB]?)"
)
JUMP = re.compile(r"(.*)GOTO([FB]?)([A-Z0-9_]+)$")
VALUE = re.compile(r"= *(?:(?:AC|IC|DC|ACP|ACN) *\()?")
"""Before a value in a line with variables."""
WORKED_OUT = re.compile(
    r"=[-+]*(?:(?!(?:AC|IC|DC|ACP|ACN)\()[A-Z_]*[0-9]?\(|(?:[ADI]C[PN]?\([-+]?)?[0-9.]+[-+*/])"
)
"""A value to work out, without variables."""
EXPRESSION = re.compile(
    rb"= *[-+]* *(?:[0-9.]+ *[-+*/]|\(|(?:SIN|COS|TAN|ASIN|ACOS|ATAN2|SQRT|ABS|POT|LN|EXP|ROUND|TRUNC) *\("
    rb"|[ADI]C[PN]? *\( *[-+]? *[0-9.]+ *[-+*/])"
)
"""What shows that a text without variables has a value to work out."""
PLAIN = re.compile(r"[-+]?[0-9.]*")
CALLED = re.compile(r"(?<![A-Z0-9_$])([A-Z_][A-Z_][A-Z0-9_]*) *\((.*)\) *$")
SUB = 90_000_000
"""Before the number of a subprogram, as an O-word."""
BY_NUMBER = re.compile(r" *@([0-9]+)(SUB|ENDSUB)?(?:\((.*)\))? *$")
BACK = re.compile(r" *(?:N *[0-9]+)? *(?:RET|M *(?:0*2|17|30)) *")
NUMBERED = re.compile(r"^ *(?:N *[0-9]+)? *(?:[A-Z_]{2}[A-Z0-9_]* *:)?")
ENDS = re.compile(r"M(?:0*2|17|30)(?![0-9=])")
RELATIONS = (("==", "EQ"), ("<>", "NE"), (">=", "GE"), ("<=", "LE"), (">", "GT"), ("<", "LT"))
OPENS = {"IF": "IF", "WHILE": "WHILE", "LOOP": "WHILE", "REPEAT": "DO"}
CLOSES = {
    "ENDIF": ("IF", "ENDIF"),
    "ENDWHILE": ("WHILE", "ENDWHILE"),
    "ENDLOOP": ("LOOP", "ENDWHILE"),
    "UNTIL": ("REPEAT", "WHILE"),
}
UNKNOWN = re.compile(r"DIV|NOT|B_|TRUNC|ATAN2|POT|[AID]C\[|R\[|\$|,|[A-Z_]{2}[A-Z0-9_]*=")


def with_calls(rows: list[bytes], called: list[bytes], search: tuple[str, ...]) -> Whole:
    """Return the rows with the programs that they call behind them; ``called``: the rows with their strings.
    Raises Unread."""
    main = [row.decode("latin-1") for row in rows]
    texts = [row.decode("latin-1") for row in called] if len(called) == len(rows) else main
    units = find_units(texts, search, HARMLESS | MACROS)
    whole = Whole([], [], [])
    put_unit(whole, 0, main, texts, list(range(len(main))), units)
    for k, unit in enumerate(units.values(), 1):
        own = [shifts(without_strings(row.encode("latin-1"))).decode("latin-1") for row in unit.rows]
        head = [f"@{k}SUB", *(f"DEF REAL {name}" for name, _ in unit.parameters)]
        head += [f"{name}=#{i}" for i, (name, _) in enumerate(unit.parameters, 1)]
        rows_of = [*head, *own, f"@{k}ENDSUB"]
        put_unit(whole, k, rows_of, [*head, *unit.rows, ""], [unit.source[0]] * len(rows_of), units)
    write_loops(whole)
    return whole


def to_o_words(whole: Whole) -> tuple[list[str], list[bool]]:
    """Return the rows, in capitals, as O-words, and which are no more than blocks as they stand.

    Raises Unread for what is not known."""
    rows = mark_names(whole.rows)
    lines = [row.replace(" ", "") for row in rows]
    labels: dict[int, dict[str, int]] = {unit: {} for unit in whole.unit}
    for at, line in enumerate(lines):
        if (found := HEAD.match(line)) and found[2]:
            labels[whole.unit[at]][found[2]] = 900_000 + at
    again, plain, opened = list[str](), list[bool](), list[tuple[str, int]]()
    for at, (row, line) in enumerate(zip(rows, lines, strict=True)):
        try:
            new = _rewrite_call(row, whole.unit[at]) or _again(row, line, at, labels[whole.unit[at]], opened)
        except Unread as refused:
            raise Unread(refused.reason, whole.source[at]) from None
        again.append(line if new is None else new)
        plain.append(new is None)
    if opened:
        raise Unread(say("{word} has no end", word=opened[-1][0]), whole.source[opened[-1][1]])
    return again, plain


def _rewrite_call(row: str, unit: int) -> str | None:
    """Return a call, the head or the end of a subprogram, or the way back from it, as O-words; None for any
    other row."""
    if found := BY_NUMBER.match(row):
        inside = found[3] or ""
        values = (
            [_expression(part.replace(" ", "")) for part in split_arguments(inside)] if inside.strip() else []
        )
        return f"O{SUB + int(found[1])}{found[2] or 'CALL'}" + "".join(f"[{value}]" for value in values)
    if BACK.fullmatch(row):
        return f"O{SUB + unit}RETURN" if unit else "M30"
    return None


def _again(row: str, line: str, at: int, labels: dict[str, int], opened: list[tuple[str, int]]) -> str | None:
    """One line as O-words; None where it stays as it is."""
    head = HEAD.match(line)
    number, rest = (head[1], line[head.end() :]) if head else (None, line)
    mark = f"N{labels[head[2]]}" if head and head[2] else f"N{number}" if number else ""
    found = KEYWORD.match(rest)
    if found and (jump := JUMP.match(rest)):
        return mark + _jump(jump, labels)
    if found:
        return mark + _keyword(found[1], rest[found.end() :], at, opened)
    if rest.startswith("DEF"):
        return mark + definition(rest)
    if USED.search(rest) or WORKED_OUT.search(rest):
        return mark + (_set(rest) if SETS.match(rest) else _with_values(row))
    if ENDS.fullmatch(rest):
        return mark + "M30"
    if not (head and head[2]):
        return None
    return mark + (_with_values(row) if rest else "")


def _expression(text: str) -> str:
    """Relations, brackets and variables in the other way of writing."""
    text = text.replace("(", "[").replace(")", "]")
    if found := UNKNOWN.search(text):
        raise Unread(say("{rest} is not known here", rest=repr(unmark_names(found[0]))))
    if "AND" in text and "OR" in text:
        raise Unread(say("AND beside OR without a line of its own"))
    for one, other in RELATIONS:
        text = text.replace(one, other)
    return by_names(PARAMETER.sub(r"#<_R\1>", text))


def _with_values(row: str) -> str:
    """Return a row whose values in variables stand in braces: numbers take their place when it is run."""
    row = NUMBERED.sub("", row)
    if (found := CALLED.search(row)) and row[: found.start()].rstrip()[-1:] not in (*"=+-*/(,<>",):
        inside = ",".join("{" + _expression(part.replace(" ", "")) + "}" if USED.search(part) else part
                          for part in split_arguments(found[2]))  # fmt: skip
        if found[1].encode() in HARMLESS:
            inside = ""
        row = row[: found.start(2)] + inside + row[found.end(2) :]
        return TEXT + (
            row if "{" in row or not USED.search(row.replace(" ", "")) else _rewrite_addresses(row)
        )
    return TEXT + _rewrite_addresses(row)


def _rewrite_addresses(row: str) -> str:
    """Return the same for values after addresses."""
    parts, begin = list[str](), 0
    while found := VALUE.search(row, begin):
        end = value_end(row, found.end())
        value = row[found.end() : end].replace(" ", "")
        parts.append(
            row[begin : found.end()] + (value if PLAIN.fullmatch(value) else "{" + _expression(value) + "}")
        )
        begin = end
    rest = row[begin:]
    if USED.search(rest.replace(" ", "")):
        raise Unread(say("{rest} is not known here", rest=repr(unmark_names(rest.strip())[:20])))
    return "".join(parts) + rest


def _set(rest: str) -> str:
    """R1=R2*2 R3=5: each value in brackets of its own."""
    parts = re.split(r"(?<![-+*/(=A-Z])(?=(?:R[0-9]+|\xab[^\xbb]*\xbb)=(?!=))", rest)
    settings = [part.split("=", 1) for part in parts if part]
    if any(len(one) != 2 or (len(settings) > 1 and USED.search(one[1])) for one in settings):
        raise Unread(say("{rest} is not known here", rest=repr(unmark_names(rest)[:20])))
    return "".join(f"{_expression(name)}=[{_expression(value)}]" for name, value in settings)


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
