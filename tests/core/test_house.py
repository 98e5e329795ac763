# SPDX-License-Identifier: LGPL-2.1-or-later
"""The house rules that a tool can check: what the core may import, in which order, and that every file names its licence."""

import ast
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
CORE = ROOT / "freecad_fiveaxis" / "core"
FOREIGN = ("FreeCAD", "FreeCADGui", "Part", "Mesh", "MeshPart", "PySide", "PySide2", "PySide6", "pivy", "Path")
MODULES = sorted(".".join(path.relative_to(ROOT).with_suffix("").parts) for path in CORE.rglob("*.py"))
STREET = [  # rooms and single modules of the core; imports only point up this list
    "sentences", "errors", "findings", "portions", "records", "progress", "quantity", "ranges", "signals", "memory", "files", "number_text", "machine",
    "kinematics", "mesh",
    "passes", "cutter", "coedge", "tool_axis", "feasible", "seating", "cl_path", "apt", "trajectory", "deviation",
    "joint_path", "minimax", "deform", "singularity", "post", "machine_import", "linearize", "program", "gouge", "faces", "part_size",
    "nc_reader", "audit", "report", "setup_map", "compare", "recover", "prove_signs", "playback", "machine_sketch",
    "option_values", "settings", "fewer_axes", "asked", "safe_start", "gouge_free", "job", "outputs", "cures", "trials", "workshop",
    "job_file", "terminal", "cli",
]  # fmt: skip
LATE = {"post/writer.py": "program", "post/start.py": "program"}  # a file that stands further down the street than its room


def test_every_core_module_imports_with_freecad_and_qt_blocked():
    block = f"import sys\nfor name in {FOREIGN!r}: sys.modules[name] = None\n"
    code = block + "\n".join(f"import {name}" for name in MODULES if not name.endswith("__main__"))
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, cwd=ROOT, timeout=60)
    assert done.returncode == 0, done.stderr


def test_the_block_would_be_noticed():
    code = "import sys\nsys.modules['FreeCAD'] = None\nimport FreeCAD"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=60).returncode != 0


def imports_of(path):
    """The files of the core that a file imports, relative or not."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            if node.level:
                base = path.parents[node.level - 1].joinpath(*(node.module or "").split("."))
            elif (node.module or "").startswith("freecad_fiveaxis.core"):
                base = ROOT.joinpath(*node.module.split("."))
            else:
                continue
            for found in [base, *(base / alias.name for alias in node.names)]:
                for file in (found.with_suffix(".py"), found / "__init__.py"):
                    if file.exists() and file != path:
                        yield file


def test_imports_in_the_core_go_one_way():
    graph = {path: set(imports_of(path)) for path in CORE.rglob("*.py") if path.name != "__init__.py"}
    seen, on_the_way = set(), []

    def visit(path):
        assert path not in on_the_way, " -> ".join(part.stem for part in [*on_the_way[on_the_way.index(path) :], path])
        if path in graph and path not in seen:
            on_the_way.append(path)
            for made in graph[path]:
                visit(made)
            on_the_way.pop()
            seen.add(path)

    for path in graph:
        visit(path)


def place(path):
    """Where on the street a file stands."""
    inside = path.relative_to(CORE)
    return STREET.index(LATE.get(inside.as_posix(), inside.with_suffix("").parts[0]))


def test_imports_follow_the_street():
    for path in CORE.rglob("*.py"):
        if path != CORE / "__init__.py":
            late = [made.stem for made in imports_of(path) if made != CORE / "__init__.py" and place(made) > place(path)]
            assert not late, f"{path.relative_to(CORE)} imports {late} from further down the street"


def test_every_room_of_the_core_is_on_the_street():
    assert {path.relative_to(CORE).with_suffix("").parts[0] for path in CORE.rglob("*.py")} - {"__init__"} == set(STREET)


def test_every_file_names_its_licence():
    files = [
        path
        for suffix in ("*.py", "*.sh")
        for path in ROOT.rglob(suffix)
        if not {".venv", ".cache", "out", "build"} & set(path.parts)
    ]
    assert len(files) > 40
    assert not [
        str(path) for path in files if "SPDX-License-Identifier: LGPL-2.1-or-later" not in path.read_text(encoding="utf-8")[:200]
    ]


@pytest.mark.parametrize("tag", ["name", "version", "date", "description", "maintainer", "license", "icon", "content", "depend"])
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
