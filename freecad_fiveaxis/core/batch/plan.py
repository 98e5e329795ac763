# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which jobs a batch is made of: parts times options, each checked and named before any of them begins.

table     a JSON file ``{"parts": ["a.stl"], "options": {"machine": ["trunnion_ac", "head_bc"], "scallop":
          0.01}}``: an option with a list of values is tried with each of them; paths are relative to the
          file.
name      of a job's files: the part's, and behind it the options that have several values:
          ``a.machine=trunnion_ac``.
"""

from __future__ import annotations

import itertools
import os
import re
import reprlib
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeGuard

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.pipeline.inputs import InputFile, check_files, list_inputs
from freecad_fiveaxis.core.pipeline.job_file import beside_file, read_json, suggest
from freecad_fiveaxis.core.pipeline.options import machine_of
from freecad_fiveaxis.core.pipeline.outputs import WRITTEN
from freecad_fiveaxis.core.pipeline.settings import MILL, build_settings, option_fields, with_current_names

from .solids import ENDINGS, find_freecad, read_part
from .task import SHARD, BatchJob

TRIPLES = ("point", "lengths", "vector", "place")
"""Kinds of options whose one value may be a list of numbers."""
LONGEST = 40
"""Characters of a value in a name."""
KEYS = ("parts", "options")
"""What a table may hold."""
OWN_NAME = re.compile(r"batch(-\d+-of-\d+)?", re.IGNORECASE)
"""The names of the report over all."""

Ways = Sequence[tuple[Mapping[str, Any], str]]
"""Options, and what they add to a name."""


def read_jobs(source: str, options: Mapping[str, Any], out: str, overwrite: bool = False) -> list[BatchJob]:
    """All jobs of a folder of parts or of a table, in a stable order. ``options``: of every job, in place of
    the table's; ``out``: the folder to write to. Raises FiveAxisError, before any work, for what cannot be
    used."""
    parts, ways = (
        (_of_folder(source), [(options, "")]) if os.path.isdir(source) else _of_table(source, options)
    )
    if any(read_part(part).is_meshed_first for part in parts):
        find_freecad()
    chosen = [(part, *way) for part in parts for way in ways]
    names = _unique_names([name + more for name in _part_names(parts) for _, more in ways])
    labels = _labels(parts)
    return [
        BatchJob(part, given, os.path.join(out, name), _suffix(part, given), overwrite, label=labels[part])
        for (part, given, _), name in zip(chosen, names, strict=True)
    ]


def check_files_of(jobs: Sequence[BatchJob], source: str) -> None:
    """Check that the files of the jobs are there, and that parts and fixtures which a table names begin as
    STL files do; parts that only lie in a folder may be anything, and fail by themselves. Raises
    FiveAxisError that names the first that cannot be used."""
    named = not os.path.isdir(source)
    check_files(dict.fromkeys(one for job in jobs for one in _files_of(job, named)))


def _files_of(job: BatchJob, named: bool) -> Iterator[InputFile]:
    for one in list_inputs(build_settings(job.task, job.part, job.options)):
        if one.option:
            yield one
        else:
            part = read_part(one.path)
            yield InputFile("", part.file, one.kind if named and not part.is_meshed_first else "")


def of_shard(jobs: Sequence[BatchJob], shard: tuple[int, int]) -> list[BatchJob]:
    """Every n-th job from the i-th on, of ``shard`` i/n."""
    first, step = shard
    return list(jobs[first - 1 :: step])


def read_shard(text: str) -> tuple[int, int]:
    """Return the numbers of ``i/n``. Raises SettingsError."""
    found = re.fullmatch(r"(\d{1,9})/(\d{1,9})", text)
    first, step = map(int, found.groups()) if found else (0, 0)
    if not 1 <= first <= step:
        raise SettingsError(
            say("{shard} {given} is not as 1/4, the first of four", shard=SHARD, given=text), text
        )
    return first, step


def _of_folder(folder: str) -> list[str]:
    names = sorted(name for name in os.listdir(folder) if name.lower().endswith((".stl", *ENDINGS)))
    if not names:
        raise SettingsError(
            say("no part (STL, STEP, FCStd) is in the folder {folder}; name another", folder=folder), folder
        )
    return [os.path.join(folder, name) for name in names]


def _of_table(path: str, more: Mapping[str, Any]) -> tuple[list[str], Ways]:
    given = read_json(path)
    table = given if isinstance(given, dict) else {}
    parts, options = table.get("parts"), table.get("options", {})
    if not _are_texts(parts) or not isinstance(options, dict) or set(table) - set(KEYS):
        text = say(
            '{path} needs "parts", a list of files (STL, STEP, FCStd), may have "options", and nothing else',
            path=path,
        )
        other = [key for key in table if key not in KEYS]
        near = next((end for key in other if (end := suggest(key, KEYS))), "")
        unknown = say("; {key} is not known", key=reprlib.repr(other[0])) if other else ""
        raise SettingsError(text + (near or unknown), path)
    tried = with_current_names({name.replace("-", "_"): value for name, value in options.items()}) | dict(
        more
    )
    beside = [os.path.join(os.path.dirname(path), part) for part in parts]
    return beside, [(beside_file(path, way) | dict(more), name) for way, name in _product(tried)]


def _are_texts(parts: Any) -> TypeGuard[list[str]]:
    return isinstance(parts, list) and bool(parts) and all(isinstance(part, str) and part for part in parts)


def _product(options: Mapping[str, Any]) -> Ways:
    """Every combination of the options' values."""
    several = {name: _values(name, value) for name, value in options.items()}
    wanted = [name for name, values in several.items() if len(values) > 1]
    return [
        (way, "".join(f".{name.replace('_', '-')}={_readable(way[name])}" for name in wanted))
        for values in itertools.product(*several.values())
        for way in [dict(zip(several, values, strict=True))]
    ]


def _values(name: str, value: Any) -> list[Any]:
    """Return the values of an option to try. Raises SettingsError for an empty list."""
    if value == []:
        raise SettingsError(
            say("{name} has an empty list of values; give one, or leave it out", name=name), name
        )
    kinds = {leaf.name.rstrip("_"): leaf.metadata["kind"] for _, leaf in option_fields(MILL)}
    numbers = isinstance(value, list) and all(isinstance(one, int | float) for one in value)
    one_value = not isinstance(value, list) or (numbers and kinds.get(name) in TRIPLES)
    return [value] if one_value else list(value)


def _readable(value: Any) -> str:
    """Return a value as part of a name for files."""
    text = f"{value:g}" if isinstance(value, float) else str(value).strip("[]").replace(" ", "")
    text = Path(text).stem if text.lower().endswith((".fcm", ".csv", ".stl")) else text
    return re.sub(r"[^\w.+,-]", "-", text)[:LONGEST]


def _part_names(parts: Sequence[str]) -> list[str]:
    """Return the parts' names; where they are those of others too, with their folder."""
    stems = [_stem(part) for part in parts]
    count = Counter(map(str.casefold, stems))
    return [
        stem if count[stem.casefold()] == 1 else f"{Path(read_part(part).file).resolve().parent.name}-{stem}"
        for part, stem in zip(parts, stems, strict=True)
    ]


def _stem(part: str) -> str:
    solid = read_part(part)
    return Path(solid.file).stem + f"-{_readable(solid.named)}" * bool(solid.named)


def _labels(parts: Sequence[str]) -> dict[str, str]:
    """Return what the report calls each part: nothing where its file's name tells it from the others, else
    its path from the folder that those of this name share."""
    paths = {part: Path(part).resolve() for part in parts}
    same = {
        name: {path for path in paths.values() if path.name == name}
        for name in {path.name for path in paths.values()}
    }
    return {
        part: "" if len(same[path.name]) == 1 else _apart(path, same[path.name])
        for part, path in paths.items()
    }


def _apart(path: Path, others: Iterable[Path]) -> str:
    try:
        return path.relative_to(os.path.commonpath(others)).as_posix()
    except ValueError:  # on several drives of Windows
        return path.as_posix()


def _unique_names(names: Iterable[str]) -> list[str]:
    """Return the same names, with a number behind one that another has, in whatever letters, or that the
    report over all has."""
    stems, taken = list[str](), set[str]()
    for name in names:
        tries = itertools.chain(
            [name] * (not OWN_NAME.fullmatch(name)), (f"{name}~{count}" for count in itertools.count(2))
        )
        stems.append(next(one for one in tries if one.casefold() not in taken))
        taken.add(stems[-1].casefold())
    return stems


def _suffix(part: str, options: Mapping[str, Any]) -> str:
    """How the NC file ends. Raises FiveAxisError where these options are no job."""
    named = [name for name in options if name.replace("-", "_") in WRITTEN]
    if named:
        raise SettingsError(
            say("{option} names a file of one job; leave it out: a batch names them", option=named[0]),
            named[0],
        )
    return machine_of(build_settings(MILL, part, options))[2].suffix
