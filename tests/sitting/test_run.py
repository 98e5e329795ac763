# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sitting itself, from outside: it fails, and says why, where the add-on fails as a user would meet
it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[1]
NEEDED = ("freecad", "freecadcmd", "Xvfb", "openbox", "xdotool", "import", "dbus-run-session")
needs_a_desk = pytest.mark.skipif(
    not all(map(shutil.which, NEEDED)), reason="no FreeCAD, or no desk to sit at"
)
PARTS = ("freecad_fiveaxis", "resources", "scripts", "tests/sitting", "Init.py", "InitGui.py", "package.xml")

BROKEN = {
    "a slot raises": (
        "freecad_fiveaxis/gui/panels/path_panel.py",
        'whether that went well. Otherwise the document is\n        as before."""\n',
        "        raise RuntimeError('broken on purpose')\n",
        "Esc while it works|Calculate",
        "broken on purpose",
    ),
    "fields die": (
        "freecad_fiveaxis/gui/panels/fields.py",
        '        """mm or degrees."""\n        shown',
        "        raise RuntimeError('Internal C++ object already deleted')\n",
        "Tool path|Esc while it works|Calculate",
        "already deleted",
    ),
    "the window sleeps": (
        "freecad_fiveaxis/gui/panels/path_panel.py",
        'whether that went well. Otherwise the document is\n        as before."""\n',
        "        import time\n        time.sleep(8)\n",
        "Esc while it works|Calculate",
        r"silent for [5-9]\.\d\d s",
    ),
}
"""What is broken: the file, the text after which a line is put in, that line, the step that fails, and what
is said of it."""


def copy_of_the_add_on(folder):
    for part in PARTS:
        copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy
        (folder / part).parent.mkdir(parents=True, exist_ok=True)
        copy(ROOT / part, folder / part)
    return folder


@needs_a_desk
@pytest.mark.parametrize("kind", BROKEN)
def test_a_broken_add_on_fails_where_a_user_would_meet_it(kind, tmp_path):
    file, after, line, step, message = BROKEN[kind]
    path = copy_of_the_add_on(tmp_path / "copy") / file
    text = path.read_text()
    assert after in text, "the code has changed: put the fault elsewhere"
    at = text.index(after) + after.index('"""\n') + 4
    path.write_text(text[:at] + line + text[at:])
    done = subprocess.run(
        ["bash", tmp_path / "copy/tests/sitting/run", "short"], capture_output=True, text=True, timeout=600, check=False
    )  # fmt: skip
    assert done.returncode == 1, done.stdout
    steps = re.findall(r"^sitting: (.*?) +\d+ clicks", done.stdout, re.MULTILINE)
    assert re.fullmatch(step, steps[-1]), done.stdout
    assert re.search("FAILED: .*" + message, done.stdout), done.stdout


def test_without_freecad_it_says_that_it_skipped(tmp_path):
    for tool in ("bash", "dirname", "pwd"):
        (tmp_path / tool).symlink_to(shutil.which(tool))
    done = subprocess.run(
        ["bash", HERE / "run"],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "SKIPPED" in done.stdout


def test_what_freecad_says_by_itself_is_no_error_of_ours():
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); from sitting import wrong\nassert wrong('Addon "
        "Manager Warning: ImportError, no QtWebEngine') == []\nassert wrong('all is well') == []\nassert "
        "wrong('a\\nRuntimeError: Internal C++ object already deleted\\nb') != []\nassert "
        "wrong('QMainWindow::resizeDocks: all sizes need to be larger than 0') != []\n"
    )
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    if subprocess.run([python, "-c", "import gi"], check=False, capture_output=True).returncode:
        pytest.skip("there is no python3-gi")
    subprocess.run([python, "-c", code, str(HERE)], check=True, timeout=60)
