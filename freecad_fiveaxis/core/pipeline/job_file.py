# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job files: the options of a task as JSON, with paths relative to the file."""

from __future__ import annotations

import difflib
import json
import os
import reprlib
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

from freecad_fiveaxis.core.base.curve_text import END_OF_LINE, ENDING, is_inline
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

from .settings import TASKS, WITHOUT_SOURCE, Settings, build_settings, option_fields


def read_job(path: str) -> Settings:
    """Return a job file: ``{"task": "mill", "source": "part.stl", "machine": ..., ...}``; its paths are
    relative to the file.

    Raises SettingsError where it is no such thing. A report's ``inputs`` are a job file too.
    """
    given = read_json(path)
    if isinstance(given, dict) and given.get("task") in WITHOUT_SOURCE:
        given.setdefault("source", "")
    if (
        not isinstance(given, dict)
        or given.get("task") not in TASKS
        or not isinstance(given.get("source"), str)
    ):
        text = say(
            'job file {path} needs "task" (one of {tasks}) and "source", the file to read',
            path=path,
            tasks=", ".join(TASKS),
        )
        raise SettingsError(text + _correct_job(given), path)
    options = _unique(
        [(name.replace("-", "_"), value) for name, value in given.items() if name not in ("task", "source")]
    )
    beside = beside_file(path, options)
    return build_settings(given["task"], _beside(path, given["source"]) if given["source"] else "", beside)


def _correct_job(given: Any) -> str:
    """Say which task or key of a job file was meant, where that is plain; else nothing."""
    if not isinstance(given, dict):
        return ""
    if given.get("task") not in TASKS and "task" in given:
        return suggest(str(given["task"]), TASKS)
    lacking = [key for key in ("task", "source") if key not in given]
    return next((text for key in given if (text := suggest(key, lacking))), "")


def suggest(word: str, known: Iterable[str]) -> str:
    """Return the end of a sentence that names the nearest of the ``known`` words to one that is none of
    these; nothing where none is near."""
    close = difflib.get_close_matches(word, list(known), 1)
    return (
        say("; {word} stands there, do you mean {close}?", word=repr(word), close=repr(close[0]))
        if close
        else ""
    )


def read_json(path: str) -> Any:
    """Return what a job file holds, in which no key stands twice and every number is one. Raises
    SettingsError, FileError."""
    try:
        return json.loads(
            read_bytes(path, "job file"), object_pairs_hook=_unique, parse_constant=_no_constant
        )
    except SettingsError as error:
        raise SettingsError(say("job file {path}: {error}", path=path, error=error), error.value) from error
    except (ValueError, RecursionError) as error:
        raise SettingsError(
            say(
                "job file {path} is not JSON: {error}; correct that place, or name another file",
                path=path,
                error=error,
            ),
            path,
        ) from error


def beside_file(path: str, options: Mapping[str, Any]) -> dict[str, Any]:
    """Options of a job file, their paths relative to it."""
    settings_paths = {leaf.name for _, leaf in option_fields() if leaf.metadata["kind"] in ("path", "paths")}
    beside = {
        name: _beside(path, value) if name in settings_paths else value for name, value in options.items()
    }
    for name in {"machine", "machines"} & set(beside):
        beside[name] = _machines_beside(path, beside[name])
    for name in ("from", "to"):
        if str(beside.get(name, "")).lower().endswith(ENDING):
            beside[name] = _beside(path, beside[name])
    if not is_inline(str(beside.get("boundary", END_OF_LINE))):
        beside["boundary"] = _beside(path, beside["boundary"])
    return beside


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    given = dict(pairs)
    if len(given) < len(pairs):
        twice = next(name for name, count in Counter(name for name, _ in pairs).items() if count > 1)
        raise SettingsError(
            say("key {key} stands twice in one object; remove one", key=reprlib.repr(twice)), twice
        )
    return given


def _no_constant(text: str) -> float:
    raise SettingsError(say("{text} is no usable number; write a finite one", text=text), text)


def _beside(job_file: str, value: Any) -> Any:
    if isinstance(value, list):
        return [_beside(job_file, item) if isinstance(item, str) else item for item in value]
    return os.path.join(os.path.dirname(job_file), value) if isinstance(value, str) else value


def _machines_beside(job_file: str, value: Any) -> Any:
    """Machine files relative to the job file; names of shipped machines as they are."""
    if isinstance(value, list):
        return [_machines_beside(job_file, item) if isinstance(item, str) else item for item in value]
    if not isinstance(value, str):
        return value
    return ",".join(
        _beside(job_file, name.strip()) if name.endswith(".fcm") else name for name in value.split(",")
    )
