# SPDX-License-Identifier: LGPL-2.1-or-later
"""What needs no numbers waits for no numpy: the command line's lists and helps, and the settings that they
are made from."""

import subprocess
import sys

import pytest

HEAVY = ("numpy", "scipy", "matplotlib", "tqdm")
COMMAND = "import sys; from freecad_fiveaxis.core.cli import main; main(sys.argv[1:])"


def loaded(code, *words):
    """The modules that a fresh Python holds after ``code``, which may end it."""
    reported = f"import atexit, sys\natexit.register(lambda: print(*sys.modules, file=sys.stderr))\n{code}"
    done = subprocess.run(
        [sys.executable, "-c", reported, *words], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0 and done.stdout, done.stderr
    return done.stderr.split()


@pytest.mark.parametrize(
    "words", ["--version", "--help", "machines", "controllers", "mill --help", "audit --help"]
)
def test_lists_and_helps_load_no_engine(words):
    modules = loaded(COMMAND, *words.split())
    assert not set(HEAVY) & set(modules)
    assert not [
        name
        for name in modules
        if name.startswith(
            ("freecad_fiveaxis.core.orientation.minimax", "freecad_fiveaxis.core.orientation.past_pole")
        )
    ]
    assert sum(name.startswith("freecad_fiveaxis") for name in modules) < 45


def test_settings_are_checked_without_the_engine():
    build = "build_settings('mill', 'a.stl', {'machine': 'trunnion_ac', 'cutter': 'bull:10:2', 'max_tilt': '3deg', 'origin': '1,2,3'})"
    modules = loaded(f"from freecad_fiveaxis.core.pipeline.settings import build_settings\nprint({build})")
    assert not set(HEAVY) & set(modules)


PARTS_OF_SCIPY = ("scipy.spatial", "scipy.sparse", "scipy.optimize", "scipy.special")


def test_scipys_parts_are_loaded_where_they_are_used():
    """Half of what it takes to begin a post or an audit, which use none of them."""
    assert not set(PARTS_OF_SCIPY) & set(loaded("from freecad_fiveaxis.core.pipeline import job\nprint(job)"))


def test_a_part_of_scipy_would_be_noticed():
    assert "scipy.spatial" in loaded("from scipy.spatial import cKDTree\nprint(cKDTree)")


def test_what_computes_would_be_noticed():
    assert set(loaded("from freecad_fiveaxis.core.toolpath import cl_offset\nprint(cl_offset)")) >= {
        "numpy",
        "freecad_fiveaxis.core.tool.contact",
    }


def test_the_ranges_of_the_options_are_those_of_the_work():
    """The least change leaves room to lead in: above what is kept off the pole."""
    from freecad_fiveaxis.core.base.ranges import (
        LARGEST_CHANGE,
        LEAST_CHANGE,
        LEAST_TILT,
        MOST_TILT,
        OFF_POLE,
    )
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    rules = {leaf.name: leaf.metadata for _, leaf in option_fields()}
    assert (rules["max_tilt"]["least"], rules["max_tilt"]["most"]) == (LEAST_TILT, MOST_TILT)
    assert (rules["max_axis_change"]["least"], rules["max_axis_change"]["most"]) == (
        LEAST_CHANGE,
        LARGEST_CHANGE,
    )
    assert 0 < OFF_POLE < LEAST_CHANGE < LARGEST_CHANGE
