# SPDX-License-Identifier: LGPL-2.1-or-later
"""The house rules that a tool can check: what the core may import, in which order, and that every file names
its licence."""

import ast
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

import import_graph
import pytest
from sources import parse_source

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
CORE = ROOT / "freecad_fiveaxis" / "core"
FOREIGN = (
    "FreeCAD",
    "FreeCADGui",
    "Part",
    "Mesh",
    "MeshPart",
    "PySide",
    "PySide2",
    "PySide6",
    "pivy",
    "Path",
)
MODULES = sorted(".".join(path.relative_to(ROOT).with_suffix("").parts) for path in CORE.rglob("*.py"))
# packages of the core in the order of the process; a lower line may import from any above it, never from
# below
LAYERS = (
    "base", "geometry", "tool", "controllers", "machine", "passes", "toolpath", "motion", "nc", "gouge", "orientation", "links", "audit",
    "report", "pipeline", "studies", "calibration", "batch", "cli",
)  # fmt: skip


def test_every_core_module_imports_with_freecad_and_qt_blocked():
    block = f"import sys\nfor name in {FOREIGN!r}: sys.modules[name] = None\n"
    code = block + "\n".join(f"import {name}" for name in MODULES if not name.endswith("__main__"))
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, cwd=ROOT, timeout=60
    )
    assert done.returncode == 0, done.stderr


def test_the_block_would_be_noticed():
    code = "import sys\nsys.modules['FreeCAD'] = None\nimport FreeCAD"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=60).returncode != 0


@cache
def imports_of(path):
    """The files of the core that a file imports, relative or not."""
    return frozenset(file for file in import_graph.imports_of(path, [ROOT]) if file.is_relative_to(CORE)) - {
        path
    }


def test_imports_in_the_core_go_one_way():
    graph = {path: set(imports_of(path)) for path in CORE.rglob("*.py") if path.name != "__init__.py"}
    seen, on_the_way = set(), []

    def visit(path):
        assert path not in on_the_way, " -> ".join(
            part.stem for part in [*on_the_way[on_the_way.index(path) :], path]
        )
        if path in graph and path not in seen:
            on_the_way.append(path)
            for one in graph[path]:
                visit(one)
            on_the_way.pop()
            seen.add(path)

    for path in graph:
        visit(path)


def layer(path):
    """The place in LAYERS of the package that a file of the core belongs to."""
    return LAYERS.index(path.relative_to(CORE).with_suffix("").parts[0])


def upward_imports(path):
    """What a file of the core imports from a layer below its own."""
    return [one for one in imports_of(path) if one != CORE / "__init__.py" and layer(one) > layer(path)]


def test_no_layer_imports_from_one_below_it():
    files = [path for path in CORE.rglob("*.py") if path != CORE / "__init__.py"]
    assert {
        path.relative_to(CORE).as_posix(): upward_imports(path) for path in files if upward_imports(path)
    } == {}


def test_an_import_from_below_would_be_noticed(monkeypatch):
    monkeypatch.setattr(sys.modules[__name__], "LAYERS", (*LAYERS[1:], LAYERS[0]))
    assert upward_imports(CORE / "geometry" / "mesh" / "triangles.py")


def test_every_package_of_the_core_is_a_layer():
    assert {path.relative_to(CORE).with_suffix("").parts[0] for path in CORE.rglob("*.py")} - {
        "__init__"
    } == set(LAYERS)


def sources():
    """Every Python and shell file of the project. Folders that are not its own are never entered: while other
    tests run, a chroot is built in .cache, and what was listed there is gone before it is read."""
    for folder, inner, names in os.walk(ROOT):
        inner[:] = [name for name in inner if name not in (".git", ".venv", ".cache", "out", "build")]
        yield from (Path(folder) / name for name in names if name.endswith((".py", ".sh")))


def test_every_file_names_its_licence():
    files = list(sources())
    assert len(files) > 40
    assert not [
        str(path)
        for path in files
        if "SPDX-License-Identifier: LGPL-2.1-or-later" not in path.read_text(encoding="utf-8")[:200]
    ]


@pytest.mark.parametrize(
    "tag", ["name", "version", "date", "description", "maintainer", "license", "icon", "content", "depend"]
)
def test_the_package_has_what_the_addon_manager_needs(tag):
    space = "{https://wiki.freecad.org/Package_Metadata}"
    root = ET.parse(ROOT / "package.xml").getroot()
    assert root.find(space + tag) is not None
    assert (ROOT / root.findtext(space + "icon")).is_file()


def test_the_version_is_the_same_wherever_it_stands():
    from freecad_fiveaxis import __version__

    space = "{https://wiki.freecad.org/Package_Metadata}"
    assert ET.parse(ROOT / "package.xml").getroot().findtext(space + "version") == __version__
    assert f'version = "{__version__}"' in (ROOT / "pyproject.toml").read_text()
    assert f"## [{__version__}]" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


PRIVATE = frozenset(["said", "told", "led", "laid", "sat", "stood", "asked", "made", "lent", "foretold"])
"""Past participles that once stood for findings, texts, axes, rows and records; the trade has words for all
of these."""

PACKAGE = ROOT / "freecad_fiveaxis"


TREES = PACKAGE, ROOT / "tests", ROOT / "benchmarks", ROOT / "docs"


def packages():
    """The folders of the whole tree in which Python modules lie, the tests' too."""
    return sorted({path.parent.relative_to(ROOT).as_posix() for tree in TREES for path in tree.rglob("*.py")})


CODES = frozenset(["AXIS_LED_PAST_POLE", "CYCLE_STEP_NOT_SAID", "UNITS_NOT_SAID"])
"""The codes by which reports and scripts know some findings are as they were."""


LONG, SHORT = r"{0}(?:\\.|[^\\])*?{0}", r"{0}(?:\\.|[^{0}\\\n])*{0}"
TEXT_OR_NAME = re.compile(
    "|".join(
        [
            *(LONG.format(3 * quote) for quote in "\"'"),
            *(SHORT.format(quote) for quote in "\"'"),
            "#.*",
            r"[^\W\d]\w*",
        ]
    )
)
"""Python's tokenizer reads the whole tree in ten times as long."""


def private_names(source):
    """The names of a source, with their lines, that are made of such words."""
    found = [
        (one.start(), one[0])
        for one in TEXT_OR_NAME.finditer(source)
        if one[0].isidentifier() and PRIVATE & set(one[0].lower().split("_")) and one[0] not in CODES
    ]
    return [(1 + source.count("\n", 0, at), name) for at, name in found]


def private_words_in(folder):
    """The files of a folder, by their names, that carry such a word in their own name or in a name within,
    with its line."""
    found = {
        path.name: private_names(path.stem + "\n" + path.read_text(encoding="utf-8"))
        for path in folder.glob("*.py")
    }
    return {name: [(line - 1, word) for line, word in names] for name, names in found.items() if names}


@pytest.mark.parametrize("package", packages())
def test_names_are_words_of_the_trade(package):
    assert private_words_in(ROOT / package) == {}


def test_all_of_the_tree_is_read_for_private_words():
    parts = ["core/passes", "app", "gui", "gui/panels", "gui/scene", "gui/play", "gui/commands"]
    assert {*(f"freecad_fiveaxis/{one}" for one in parts), "tests/core", "tests/gui", "benchmarks"} <= set(
        packages()
    )


def test_a_private_word_would_be_noticed():
    assert private_names("offset, said = close(path)\nled_axis = said\n") == [
        (1, "said"),
        (2, "led_axis"),
        (2, "said"),
    ]
    assert private_names("# said\nsaid_so = 'told'") == [(2, "said_so")] and not private_names(
        "solid = 'told'"
    )


def test_a_private_word_in_a_file_would_be_noticed(tmp_path):
    (tmp_path / "told.py").write_text("")
    (tmp_path / "panel.py").write_text("import told as wording\n\nMADE_HERE = True\n")
    (tmp_path / "clean.py").write_text("wording = 'told'\n")
    assert private_words_in(tmp_path) == {
        "told.py": [(0, "told")],
        "panel.py": [(1, "told"), (3, "MADE_HERE")],
    }


REGULAR = re.compile(r"[a-z]{2,}ed")
NO_PARTICIPLES = frozenset(["bleed", "embed", "exceed", "feed", "heed", "need", "proceed", "seed", "speed"])
"""Words that only end like one."""
PARTICIPLES = frozenset(
    ["begun", "bent", "bought", "broken", "brought", "built", "caught", "chosen", "done", "drawn", "driven", "fallen", "felt", "flown",
     "forgotten", "found", "frozen", "given", "gone", "grown", "held", "hidden", "hung", "kept", "known", "laid", "led", "left", "lent",
     "lost", "made", "meant", "met", "paid", "proven", "said", "seen", "sent", "shown", "sold", "spent", "spun", "stood", "struck",
     "stuck", "sunk", "swept", "swung", "taken", "taught", "thought", "thrown", "told", "torn", "understood", "woken", "won", "worn",
     "wound", "woven", "written"]
)  # fmt: skip
"""Irregular ones. Not ``bound``: a function may bound a value."""
STILL_PARTICIPLES = {
    "app/__init__.py: left_map": "macros call it",
    "app/tessellation.py: Tessellation.avoided_runs": "looked up by its name in a document's object",
    "core/orientation/strategies.py: fixed": "an entry of STRATEGIES, called as users call it",
}
"""Functions that keep such a name, with the reason."""
FUNCTIONS = ast.FunctionDef | ast.AsyncFunctionDef


def is_participle(name):
    """Whether the first word of a name is a past participle: it says what is given, not what is done."""
    first = name.lstrip("_").partition("_")[0]
    return first in PARTICIPLES or bool(REGULAR.fullmatch(first) and first not in NO_PARTICIPLES)


def participles_in(node, around=""):
    """The functions and methods in a tree, those in others too, that are called so; properties may be."""
    for inner in ast.iter_child_nodes(node):
        if isinstance(inner, FUNCTIONS | ast.ClassDef):
            is_plain = isinstance(inner, FUNCTIONS) and not any(
                "property" in ast.unparse(one) for one in inner.decorator_list
            )
            if is_plain and is_participle(inner.name):
                yield around + inner.name
            yield from participles_in(inner, f"{around}{inner.name}.")
        else:
            yield from participles_in(inner, around)


def test_functions_are_called_by_what_they_do():
    found = {
        f"{path.relative_to(PACKAGE).as_posix()}: {name}"
        for path in PACKAGE.rglob("*.py")
        for name in participles_in(parse_source(path))
    }
    assert found == set(STILL_PARTICIPLES)


def test_a_function_called_by_a_participle_would_be_noticed():
    source = """
def moved(path): ...
def move(path):
    def shifted(row): ...
    if path:
        def _kept_rows(row): ...
class Path:
    def taken(self, rows): ...
    @functools.cached_property
    def turned(self):
        def sorted_out(): ...
    @property
    def left(self): ...
def feed_blocks(red, bounded): ...
def _bound_depth(): ...
def write_divided(): ...
"""
    assert list(participles_in(ast.parse(source))) == [
        "moved", "move.shifted", "move._kept_rows", "Path.taken", "Path.turned.sorted_out",
    ]  # fmt: skip
