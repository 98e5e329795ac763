# SPDX-License-Identifier: LGPL-2.1-or-later
"""No finding and no error of the core or the documents is a text that nobody can translate: each is made by
``say``."""

import ast
import re

import pytest
from sources import parse_source
from translation_script import ROOT

OUR_OWN = re.compile(
    r"(?!ValueError|NotImplementedError|RuntimeError|TypeError|KeyError|PrintError)\w+Error|Cancelled"
)
"""Errors that a user reads; the builtins tell programmers of a wrong call."""


def has_words(node):
    """Whether an expression is a bare text, or puts one together."""
    if isinstance(node, ast.JoinedStr):
        return any(has_words(part) for part in node.values)
    if isinstance(node, ast.BinOp):
        return has_words(node.left) or has_words(node.right)
    if isinstance(node, ast.IfExp):
        return has_words(node.body) or has_words(node.orelse)
    return isinstance(node, ast.Constant) and bool(re.search(r"[A-Za-z]{2}", str(node.value)))


def message_of(call):
    """What a call tells the user, or None: the text of a Finding, the message of an error, the text of a
    replaced Finding."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    if name == "Finding" and len(call.args) > 2:
        return call.args[2]
    if OUR_OWN.fullmatch(name) and call.args:
        return call.args[0]
    return next(
        (one.value for one in call.keywords if name in ("replace", "Finding") and one.arg == "text"), None
    )


def bare_sentences(tree):
    """Line and text of every finding and error that is given a bare text, or a name that the same function
    gave one."""
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for function in [tree, *functions]:
        given = {}
        for node in ast.walk(function):
            if (
                isinstance(node, ast.Assign)
                and isinstance(node.targets[0], ast.Name)
                and function is not tree
            ):
                given.setdefault(node.targets[0].id, []).append(node.value)
        for node in ast.walk(function):
            if isinstance(node, ast.Call) and (message := message_of(node)) is not None:
                values = given.get(message.id, []) if isinstance(message, ast.Name) else [message]
                yield from ((node.lineno, ast.unparse(value)) for value in values if has_words(value))


def test_every_finding_and_every_error_can_be_repeated():
    bare = []
    for path in sorted((ROOT / "freecad_fiveaxis").rglob("*.py")):
        if "gui" not in path.parts:
            found = sorted(set(bare_sentences(parse_source(path))))
            bare += [f"{path.relative_to(ROOT)}:{line}: {text}" for line, text in found]
    assert not bare, "said without say():\n" + "\n".join(bare)


@pytest.mark.parametrize(
    "source",
    [
        'raise MeshError("the file is empty", 0)',
        'raise SettingsError(f"{name} is {value:g} mm", value)',
        'def f():\n    text = f"{count} blocks " + rest\n    return Finding(NOTE, "code", text)',
        'one = Finding(NOTE, "code", say("a {b}", b=1) + " more words")',
        'one = replace(finding, text="another text")',
        'raise errors.FileError("a folder" if folder else say("no file"), path)',
    ],
)
def test_a_bare_sentence_would_be_noticed(source):
    assert list(bare_sentences(ast.parse(source)))


@pytest.mark.parametrize(
    "source",
    [
        'raise MeshError(say("the file is empty"), 0)',
        'def f():\n    text = say("{count} blocks", count=3)\n    return Finding(NOTE, "code", text)',
        'raise ValueError("a text of the table holds a byte 0")',
        'raise MachineError(error.text, error.value)',
    ],
)  # fmt: skip
def test_what_is_stated_is_not_bare(source):
    assert not list(bare_sentences(ast.parse(source)))
