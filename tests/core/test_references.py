# SPDX-License-Identifier: LGPL-2.1-or-later
"""What docstrings and pages refer to is there: modules, classes, functions and data by their names, files by
their paths."""

import re
from functools import cache
from pathlib import Path

import pytest
from references import Package

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "commands").glob("*.md")]
"""Without the decisions: these say what was."""
FILE = re.compile(r"`((?:[\w.-]+/)*[a-z_]+\.py)`")
HISTORY = {"CHANGELOG.md"}


@cache
def package_here():
    return Package(ROOT / "freecad_fiveaxis")


def test_what_docstrings_refer_to_is_there():
    package = package_here()
    assert len(package.docstrings) > 5000
    assert list(package.dead()) == []


TOY = {
    "__init__.py": '"""A toy."""\n',
    "wheel.py": """from .base import Part
LEAST = 1
\"\"\"mm; as {0}.\"\"\"
class Wheel(Part):
    \"\"\"See {0}.\"\"\"
    spokes: int
    def turn(self, part):
        self.angle = 0
def wheel_of(part):
    \"\"\"Take {0}.\"\"\"
""",
    "base/__init__.py": "from .parts import Part\n",
    "base/parts.py": "class Part:\n    weight: float\n",
}


def dead_in_toy(folder, reference):
    """How often, of the three places where the toy names it, a reference is found dead."""
    for name, text in TOY.items():
        (folder / "toy" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "toy" / name).write_text(text.replace("{0}", reference), encoding="utf-8")
    found = list(Package(folder / "toy").dead())
    assert all(line.partition(": ")[2] in reference for line in found)
    return len(found)


@pytest.mark.parametrize(
    "reference",
    [":func:`wheel_of`", ":class:`Wheel`", ":data:`LEAST`", ":meth:`Wheel.turn`", ":attr:`Wheel.angle`", ":attr:`Wheel.weight`",
     ":class:`.Part`", ":mod:`.parts`", ":class:`~toy.base.Part`", ":class:`~.base.parts.Part`", ":mod:`os.path`", "``Wheel.spokes``",
     "``base.parts.Part``", "``parts.Part``", "``numpy.float64``", "``wheel.json``", "``LEAST.real``"],
)  # fmt: skip
def test_a_reference_to_what_is_there_is_taken(tmp_path, reference):
    assert dead_in_toy(tmp_path, reference) == 0


@pytest.mark.parametrize(
    "reference",
    [":func:`wheel_off`", ":meth:`Wheel.stop`", ":attr:`Wheel.height`", ":class:`.Port`", ":mod:`.pieces`", ":class:`~toy.base.Port`",
     ":class:`~.base.pieces.Part`", ":mod:`oss.path`", ":mod:`pieces`", ":func:wheel_of", ":func:``wheel_of``", "``Wheel.height``",
     "``base.pieces.Part``", "``parts.Port``"],
)  # fmt: skip
def test_a_dead_reference_is_found_wherever_it_stands(tmp_path, reference):
    assert dead_in_toy(tmp_path, reference) == 3


def test_a_parameter_is_no_module(tmp_path):
    assert dead_in_toy(tmp_path, "``part.weight``") == 0


def missing_files(text, files):
    """The Python files that a page names and that are not there, wherever they may be."""
    return [
        name
        for name in FILE.findall(text)
        if not any(file == name or file.endswith("/" + name) for file in files)
    ]


def test_the_files_that_pages_name_are_there():
    files = [
        path.relative_to(ROOT).as_posix()
        for folder in ("freecad_fiveaxis", "tests", "benchmarks", "docs", "examples", "resources")
        for path in (ROOT / folder).rglob("*.py")
    ]
    missing = {
        page.name: missing_files(page.read_text(encoding="utf-8"), files)
        for page in PAGES
        if page.name not in HISTORY
    }
    assert len(PAGES) > 40
    assert {page: names for page, names in missing.items() if names} == {}


def test_a_missing_file_would_be_noticed():
    assert missing_files("see `a/b.py`, `b.py` and `c.py`", ["core/a/b.py"]) == ["c.py"]


USERS = ("benchmarks", "scripts", "examples", "resources", "docs")
"""Folders with code that uses the package and that no type checker reads."""


def python_files(folder):
    """The Python files in a folder, those too that only their first line tells of."""
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix in (".py", ""):
            text = path.read_bytes()
            if path.suffix or b"python" in text.partition(b"\n")[0]:
                yield path, text.decode("utf-8")


def test_what_is_taken_from_the_package_outside_of_it_is_there():
    package = package_here()
    files = dict(one for folder in USERS for one in python_files(ROOT / folder))
    assert len(files) > 40 and ROOT / "scripts" / "pages" in files
    assert [
        f"{path.relative_to(ROOT)}:{line}" for path, text in files.items() for line in package.missing(text)
    ] == []


@pytest.mark.parametrize(
    ("source", "missing"),
    [("from toy.wheel import Wheel, wheel_off", ["1: toy.wheel.wheel_off"]), ("import toy.wheels", ["1: toy.wheels"]),
     ("def late():\n    from toy.base import Part, Port as Part2", ["2: toy.base.Port"]), ("from toy.wheels import LEAST", ["1: toy.wheels.LEAST"]),
     ("from toy import base, wheel as w\nw.wheel_of(w.LEAST, w.MOST)\nbase.Part.any", ["2: toy.wheel.MOST"]),
     ("import os.path\nfrom toy.base.parts import Part\nimport toy.wheel\nfrom toy import wheel\nwheel.LEAST", []),
     ("from toy import wheel\nfor wheel in wheel.LEAST: wheel.turn()", [])],
)  # fmt: skip
def test_a_missing_name_would_be_noticed(tmp_path, source, missing):
    dead_in_toy(tmp_path, ":class:`Wheel`")
    assert list(Package(tmp_path / "toy").missing(source)) == missing
