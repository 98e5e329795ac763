# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which Python files use which: read from their import statements, so that nothing has to be run for it.
Those in texts count too: many tests give code to another process.

graph      by file the files that it uses. A name taken from a package (``from ..tool import Cutter``) leads
           to the module that defines it, not to all that the package's ``__init__`` brings together.
distance   in how many steps of import a file is used: 1 where it is imported itself.
"""

import ast
import contextlib
import re
from collections import deque
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path

Graph = Mapping[Path, frozenset[Path]]
STATEMENT = re.compile(
    r"^[^\n#]*?\b(from [\w.]+ import (?:\([^)]*\)|[^\n#;'\"(]+)|import [\w., ]+)", re.MULTILINE
)


@cache
def import_statements(path: Path) -> tuple[ast.Import | ast.ImportFrom, ...]:
    """Those of a file, wherever they stand in it."""
    found = list[ast.Import | ast.ImportFrom]()
    for text in STATEMENT.findall(path.read_text(encoding="utf-8")):
        with contextlib.suppress(SyntaxError):  # a sentence that reads as one
            found += ast.parse(text.strip()).body
    return tuple(found)


def as_file(place: Path) -> Path | None:
    """The file of a module or package of that path without suffix."""
    return next(
        (file for file in (place.with_suffix(".py"), place / "__init__.py") if place.name and file.is_file()),
        None,
    )


def imports_of(path: Path, roots: Iterable[Path] = ()) -> Iterator[Path]:
    """The files that a file imports anywhere in it. ``roots``: folders in which absolute names are looked
    for, in that order."""
    for node in import_statements(path):
        if isinstance(node, ast.ImportFrom):
            places = _places(path, node, roots)
            for place in places:
                for alias in node.names:
                    yield from _taken_from(place, alias.name)
        elif isinstance(node, ast.Import):
            for alias in node.names:
                files = (as_file(root.joinpath(*alias.name.split("."))) for root in roots)
                yield from [file for file in files if file][:1]


def _places(path: Path, node: ast.ImportFrom, roots: Iterable[Path]) -> list[Path]:
    parts = (node.module or "").split(".") if node.module else []
    if node.level:
        return [path.parents[node.level - 1].joinpath(*parts)]
    places = [root.joinpath(*parts) for root in roots]
    return [place for place in places if as_file(place) or place.is_dir()][:1]


def _taken_from(place: Path, name: str) -> Iterator[Path]:
    """The files that ``from place import name`` makes use of."""
    file = as_file(place)
    if file:
        yield file
    if module := as_file(place / name):
        yield module
    elif file and file.name == "__init__.py":
        yield from _brought_together(file).get(name, ())


@cache
def _brought_together(package: Path) -> dict[str, tuple[Path, ...]]:
    """Where the names that a package's ``__init__`` imports come from."""
    found = {}
    for node in import_statements(package):
        if isinstance(node, ast.ImportFrom) and node.level:
            place = package.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            for alias in node.names:
                found[alias.asname or alias.name] = tuple(_taken_from(place, alias.name))
    return found


def build_graph(files: Iterable[Path], roots: Iterable[Path]) -> Graph:
    """What each of the files uses. What an ``__init__`` brings together is used by who takes it from
    there."""
    files, roots = list(files), list(roots)
    return {
        path: frozenset() if path.name == "__init__.py" else frozenset(set(imports_of(path, roots)) - {path})
        for path in files
    }


def distances(graph: Graph, changed: Iterable[Path]) -> dict[Path, int]:
    """In how many steps each file uses any of the changed ones; 0 for these, nothing for those that do
    not."""
    users = dict[Path, list[Path]]()
    for user, used in graph.items():
        for file in used:
            users.setdefault(file, []).append(user)
    steps = dict.fromkeys(changed, 0)
    waiting = deque(steps)
    while waiting:
        file = waiting.popleft()
        for user in users.get(file, ()):
            if user not in steps:
                steps[user] = steps[file] + 1
                waiting.append(user)
    return steps
