# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python that the pages print: every name in it is there, and what needs no files of other programs runs as
it stands."""

import ast
import builtins
import importlib
import re
from pathlib import Path

import FreeCAD
import Mesh
import Part
import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app

ROOT = Path(__file__).parents[2]
PAGES = sorted(
    [ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "commands").glob("*.md")]
)
BLOCKS = {
    f"{page.stem}-{row}": text
    for page in PAGES
    for row, text in enumerate(
        re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    )
}
NEEDS_FILES = {"FiveAxis_ImportMachine-0", "FiveAxis_Recover-0"}
FRAGMENTS = {"compare-0": "freecad_fiveaxis.core.studies.corrections"}
"""Lines of a table in a module, whose names are that module's."""
OURS = {"app": "freecad_fiveaxis.app"}
HANDED = {"doc", "path", "body", "solid", "executor", "my_function", "my_correction"}
"""What the text around the blocks speaks of."""


def unknown_names(text, module=""):
    """Names of a block that nothing gives: imported, read, or asked of a module of ours."""
    tree = ast.parse("{" + text + "}" if module else text)
    modules, known = dict(OURS), {*HANDED, *OURS, *dir(builtins)}
    known |= set(dir(importlib.import_module(module))) if module else set()
    wrong = []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            wrong += _missing(node, modules, known)
        elif isinstance(node, ast.Import):
            known |= {one.name for one in node.names if importlib.import_module(one.name)}
        elif isinstance(node, ast.arg):
            known.add(node.arg)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            known.add(node.id)
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and node.id not in known:
            wrong.append(node.id)
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
            there = importlib.import_module(modules[node.value.id])
            wrong += [] if hasattr(there, node.attr) else [f"{node.value.id}.{node.attr}"]
    return wrong


def _missing(node, modules, known):
    """What an import does not find; what it finds is known from now on."""
    wrong = []
    for one in node.names:
        known.add(one.asname or one.name)
        try:
            importlib.import_module(f"{node.module}.{one.name}")
            modules[one.asname or one.name] = f"{node.module}.{one.name}"
        except ImportError:
            wrong += [] if hasattr(importlib.import_module(node.module), one.name) else [one.name]
    return wrong


@pytest.mark.parametrize("name", BLOCKS)
def test_every_name_of_a_printed_macro_is_there(name):
    assert not unknown_names(BLOCKS[name], FRAGMENTS.get(name, ""))


def test_a_name_that_is_gone_would_be_noticed():
    text = "from freecad_fiveaxis.app import reach, nothing\nprint(reach.found_of(made), app.reached)"
    assert set(unknown_names(text)) == {"nothing", "made", "reach.found_of", "app.reached"}
    assert unknown_names('"none": lambda made: solved_path', FRAGMENTS["compare-0"]) == ["solved_path"]


@pytest.fixture
def handed(doc, tmp_path, monkeypatch):
    """A document as the pages have it, also as a file, and a folder of parts, where the macros run."""
    monkeypatch.chdir(tmp_path)
    for name, size, at in (("Body", (12, 12, 4), (0, 0, 0)), ("Vise", (4, 12, 3), (14, 0, 0))):
        box = doc.addObject("Part::Feature", name)
        box.Shape = Part.makeBox(*size, FreeCAD.Vector(*at))
    doc.recompute()
    doc.saveCopy(str(tmp_path / "part.FCStd"))
    (tmp_path / "PARTS").mkdir()
    Mesh.Mesh(doc.Body.Shape.tessellate(0.1)).write(str(tmp_path / "PARTS" / "a.stl"))
    path = app.create_toolpath(doc, doc.Body, **FAST, **UNCURED)
    opened = set(FreeCAD.listDocuments())
    yield {"doc": doc, "path": path, "body": doc.Body, "solid": doc.Body, "executor": None, "app": app}
    for name in set(FreeCAD.listDocuments()) - opened:
        FreeCAD.closeDocument(name)


@pytest.mark.parametrize("name", [one for one in BLOCKS if one not in NEEDS_FILES and one not in FRAGMENTS])
def test_a_printed_macro_runs(name, handed, capsys):
    exec(compile(BLOCKS[name], name, "exec"), handed)
    printed = capsys.readouterr().out
    assert "cannot be" not in printed and "Error" not in printed
