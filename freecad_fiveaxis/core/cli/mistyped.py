# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a word of the command line that is not known was meant to be: the nearest word, or the commands that
know it."""

from __future__ import annotations

import argparse
import difflib
import re
from collections.abc import Iterable, Mapping, Sequence

from freecad_fiveaxis.core.base.sentences import Task, say

UNKNOWN = re.compile(r"unrecognized arguments: .*?(?P<flag>--[\w-]+)")
CHOICE = re.compile(r"invalid choice: '(?P<word>.*)' \(choose from (?P<known>.*)\)")
"""As argparse says it."""


def correct(message: str, commands: Mapping[str, argparse.ArgumentParser], words: Sequence[str]) -> str:
    """Return the end of the message in which argparse refuses ``words``: what was meant, where that is plain,
    else nothing. ``commands``: their parsers by name."""
    choice = CHOICE.search(message)
    if choice is not None:
        known = [one.strip(" '\"") for one in choice["known"].split(",")]
        return _name_nearest(choice["word"], known)
    unknown = UNKNOWN.search(message)
    command = next((word for word in words if word in commands), None)
    if unknown is None or command is None:
        return ""
    flag, own = unknown["flag"], _flags_of(commands[command])
    others = [name for name, parser in commands.items() if flag in _flags_of(parser)]
    return _name_nearest(flag, own) if not others else _name_commands(flag, others)


def find_commands(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """Return the parsers of a parser's commands by their names."""
    return {
        name: one
        for action in parser._actions
        if isinstance(action, argparse._SubParsersAction)
        for name, one in action.choices.items()
    }


def _flags_of(parser: argparse.ArgumentParser) -> list[str]:
    return [flag for action in parser._actions for flag in action.option_strings]


def _name_nearest(word: str, known: Iterable[str]) -> str:
    close = difflib.get_close_matches(word, list(known), 1)
    return say("; did you mean {close}?", close=close[0]) if close else ""


def _name_commands(flag: str, commands: Sequence[str]) -> str:
    names = ", ".join(str(Task(name)) for name in commands)
    return say("; {option} is for {commands}; leave it out here", option=flag, commands=names)
