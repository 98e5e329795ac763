# SPDX-License-Identifier: LGPL-2.1-or-later
"""What strangers install: wheel and source archive, built from a copy of this folder and used where this
folder is not at hand."""

import importlib.util
import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from importlib import metadata
from pathlib import Path

import numpy
import pytest
import scipy

from freecad_fiveaxis import __version__

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "freecad_fiveaxis"
DATA = {".fcm", ".svg", ".ui", ".qm"}
"""What the code opens at run time: machines, icons, forms and translations (the .ts are for translators)."""
LEFT_HERE = {".git", ".venv", ".cache", "out", "build", "dist", "__pycache__", ".hypothesis"} | {
    f".{tool}_cache" for tool in ("pytest", "mypy", "ruff")
}
"""What others write here at the same time among them."""
SETUPTOOLS = 77
"""The first that knows licence expressions (PEP 639), as pyproject.toml says."""


def installed_setuptools():
    try:
        return int(metadata.version("setuptools").partition(".")[0])
    except metadata.PackageNotFoundError:
        return 0


builds = pytest.mark.skipif(
    installed_setuptools() < SETUPTOOLS or not importlib.util.find_spec("pip"),
    reason=f"needs pip and setuptools >= {SETUPTOOLS} in this Python",
)


def test_every_folder_of_the_package_is_a_package():
    folders = {path.parent for path in PACKAGE.rglob("*.py")}
    assert len(folders) > 20
    assert not [str(folder) for folder in folders if not (folder / "__init__.py").is_file()]


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """A copy of this folder, as a download holds it: builders leave their files in it."""
    folder = tmp_path_factory.mktemp("download") / "freecad-fiveaxis"
    shutil.copytree(
        ROOT,
        folder,
        ignore=lambda _, names: (
            LEFT_HERE & set(names) | {name for name in names if name.endswith(".egg-info")}
        ),
    )
    return folder


def build(kind, folder, into):
    """The wheel or sdist of a source folder, made by the backend itself: no network, no environment of its
    own."""
    code = f"import sys; from setuptools.build_meta import build_{kind} as build; print(build(sys.argv[1]))"
    done = run(sys.executable, "-c", code, into, cwd=folder)
    assert "deprecated" not in (done.stdout + done.stderr).lower(), done.stderr
    return into / done.stdout.split()[-1]


def run(*words, cwd, code=0):
    """A process that knows nothing of this folder."""
    around = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run(
        [str(word) for word in words], cwd=cwd, env=around, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == code, done.stdout + done.stderr
    return done


@pytest.fixture(scope="module")
def archive(source, tmp_path_factory):
    return build("sdist", source, tmp_path_factory.mktemp("sdist"))


@pytest.fixture(scope="module")
def wheel(archive, tmp_path_factory):
    """Built from the source archive: what is missing there is missing here."""
    folder = tmp_path_factory.mktemp("wheel")
    with tarfile.open(archive) as tar:
        if hasattr(tarfile, "data_filter"):
            tar.extraction_filter = tarfile.data_filter
        tar.extractall(folder)
    return build("wheel", next(path for path in folder.iterdir() if path.is_dir()), folder)


@pytest.fixture(scope="module")
def scripts(wheel, tmp_path_factory):
    """The folder of programs of a fresh environment with the wheel in it; numpy and scipy are those that the
    tests run with."""
    folder = tmp_path_factory.mktemp("fresh")
    run(sys.executable, "-m", "venv", "--without-pip", "venv", cwd=folder)
    scripts = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", scripts / "python"]
    run(*pip, "install", "--no-deps", "--no-index", wheel, cwd=folder)
    site = run(
        scripts / "python", "-c", "import sysconfig; print(sysconfig.get_path('purelib'))", cwd=folder
    ).stdout.strip()
    (Path(site) / "borrowed.pth").write_text(
        "\n".join({str(Path(module.__file__).parents[1]) for module in (numpy, scipy)})
    )
    return scripts


@pytest.mark.thorough
@builds
def test_the_wheel_holds_every_module_and_every_file_that_the_code_opens(wheel):
    inside = {name for name in zipfile.ZipFile(wheel).namelist() if not name.startswith("freecad_fiveaxis-")}
    modules = {path.relative_to(ROOT).as_posix() for path in PACKAGE.rglob("*.py")}
    data = {
        "freecad_fiveaxis/" + path.relative_to(ROOT).as_posix()
        for path in (ROOT / "resources").rglob("*")
        if path.suffix in DATA
    }
    assert len(data) > 25
    assert inside == modules | data | {
        "freecad_fiveaxis/py.typed",
        "freecad_fiveaxis/resources/examples/make_parts.py",
    }


@builds
def test_the_source_archive_is_an_add_on_and_can_be_tested(archive):
    with tarfile.open(archive) as tar:
        inside = {name.partition("/")[2] for name in tar.getnames()}
    wanted = {
        "package.xml",
        "Init.py",
        "InitGui.py",
        "Makefile",
        "LICENSE",
        "README.md",
        "resources/icons/fiveaxis.svg",
    }
    wanted |= {path.relative_to(ROOT).as_posix() for path in (ROOT / "tests").rglob("*.py")}
    assert not wanted - inside


@pytest.mark.thorough
@builds
def test_every_module_of_the_core_is_imported_from_the_wheel(scripts, tmp_path):
    names = [
        ".".join(path.relative_to(ROOT).with_suffix("").parts) for path in (PACKAGE / "core").rglob("*.py")
    ]
    modules = "".join(f"import {name.removesuffix('.__init__')}\n" for name in names)
    done = run(
        scripts / "python",
        "-c",
        f"{modules}import freecad_fiveaxis\nprint(freecad_fiveaxis.__file__)",
        cwd=tmp_path,
    )
    assert Path(done.stdout.strip()).resolve().is_relative_to(scripts.parent.resolve())


@pytest.mark.thorough
@builds
def test_the_installed_command_lists_and_mills_in_another_folder(scripts, tmp_path):
    fiveaxis = scripts / "fiveaxis"
    assert run(fiveaxis, "--version", cwd=tmp_path).stdout.strip() == __version__
    assert "trunnion_ac" in run(fiveaxis, "machines", cwd=tmp_path).stdout
    run(scripts / "python", "-m", "freecad_fiveaxis.resources.examples.make_parts", "parts", cwd=tmp_path)
    mill = [
        "mill",
        "parts/dome.stl",
        "--machine",
        "trunnion_ac",
        "--stepover",
        "8",
        "--max-axis-angle",
        "50",
        "-o",
        "dome.ngc",
    ]
    run(
        fiveaxis,
        *mill,
        "--report",
        "dome.html",
        "--report",
        "dome.json",
        "--blocks",
        "dome.csv",
        "--cl",
        "dome.apt",
        cwd=tmp_path,
    )
    result = sorted(path.name for path in tmp_path.iterdir())
    assert result == ["dome.apt", "dome.csv", "dome.html", "dome.json", "dome.ngc", "parts"]
    assert "\nM2" in (tmp_path / "dome.ngc").read_text()
