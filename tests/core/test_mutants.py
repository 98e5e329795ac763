# SPDX-License-Identifier: LGPL-2.1-or-later
"""``make mutants`` on a toy package: what its tests notice, what they do not, and what no longer applies."""

import subprocess
import sys
from pathlib import Path

import pytest

tomllib = pytest.importorskip("tomllib")  # Python 3.11; the tool is for whoever works on the project
ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "tests" / "mutation" / "mutate.py"
ROWS = tomllib.loads(SCRIPT.with_name("mutants.toml").read_text(encoding="utf-8"))["mutant"]
SOURCE = "def twice(x):\n    return 2 * x\n\n\ndef thrice(x):\n    return 3 * x\n"
TEST = "from toy import twice\n\n\ndef test_twice():\n    assert twice(2) == 4\n"
HANGS = "[None for _ in iter(int, 1)]"


def entry(old, new, more="tests = ['test_toy.py']"):
    return f"[[mutant]]\nfile = 'toy.py'\nold = '{old}'\nnew = '{new}'\n{more}\n"


def tried(folder, table, *words):
    """The exit code and the lines of the script, for a toy package and this table."""
    for name, text in (("toy.py", SOURCE), ("test_toy.py", TEST), ("mutants.toml", table)):
        (folder / name).write_text(text)
    words = ("--root", folder, "--table", folder / "mutants.toml", "--all", *words)
    done = subprocess.run([sys.executable, SCRIPT, *words], capture_output=True, text=True, timeout=60)
    assert (folder / "toy.py").read_text() == SOURCE  # only the copy is changed
    return done.returncode, done.stdout.splitlines()


def test_a_survivor_and_a_text_that_is_gone_are_failures(tmp_path):
    table = (
        entry("2 * x", "5 * x")
        + entry("3 * x", "4 * x")
        + entry("9 * x", "")
        + entry("3 *", "4 *", "equivalent = 'unused'")
    )
    code, lines = tried(tmp_path, table)
    assert code == 1 and [line.split(" ")[0] for line in lines] == [
        "killed",
        "SURVIVED",
        "no",
        "equivalent:",
        "mutants:",
    ]


@pytest.mark.thorough
def test_a_mutant_that_hangs_is_killed_by_the_limit(tmp_path):
    code, lines = tried(tmp_path, entry("2 * x", HANGS), "--limit", "3")
    assert code == 0 and lines[0].startswith("killed by the limit of 3 s")


def applies(row):
    """Whether the old text of a row occurs once in its file, and the tests that it names exist."""
    named = [words.split("[")[0].split("::") for words in row.get("tests", ())]
    held = all(f"def {name}(" in (ROOT / file).read_text(encoding="utf-8") for file, name in named)
    return held and (ROOT / row["file"]).read_text(encoding="utf-8").count(row["old"]) == 1


def test_each_row_of_the_table_applies_to_the_package_as_it_is():
    assert [row["old"] for row in ROWS if not applies(row)] == []


def test_a_row_whose_text_is_gone_or_whose_test_has_another_name_does_not_apply():
    row = next(row for row in ROWS if row.get("tests"))
    assert not applies({**row, "old": row["old"] + " gone"})
    assert not applies({**row, "tests": [row["tests"][0] + "_of_another_name"]})
