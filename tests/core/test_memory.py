# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process of its own keeps what it frees, so that the next column costs no new pages."""

import struct
import subprocess
import sys

import numpy as np
import pytest

from freecad_fiveaxis.core.base import memory
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, read_stl
from freecad_fiveaxis.core.passes import slice_mesh, slicing

linux = pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="limits and page faults as Linux tells them"
)

FAULTS = """
import resource, sys
import numpy as np
from freecad_fiveaxis.core.base.memory import keep_freed_memory
if sys.argv[1] == "keep" and not keep_freed_memory():
    sys.exit(3)
np.ones(4_000_000)
before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
for _ in range(8):
    np.ones(4_000_000)
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


def new_pages(mode: str) -> int:
    environment = {"NUMPY_MADVISE_HUGEPAGE": "0", "OPENBLAS_NUM_THREADS": "1"}  # small pages: each one counts
    done = subprocess.run(
        [sys.executable, "-c", FAULTS, mode], capture_output=True, text=True, env=environment
    )
    if done.returncode == 3:
        pytest.skip("this system's C library has no mallopt")
    return int(done.stdout)


@linux
def test_a_freed_column_is_used_again() -> None:
    assert new_pages("keep") < new_pages("leave") / 10


LIMITED = """
import resource, sys
resource.setrlimit(resource.RLIMIT_AS, (2_000_000_000, 2_000_000_000))
from freecad_fiveaxis.core.cli import main
sys.exit(main(["mill", sys.argv[1], "--machine", "trunnion_ac", "-o", sys.argv[2], "--quiet"]))
"""


@pytest.mark.thorough
@linux
def test_ten_million_facets_under_two_gigabytes_are_refused_before_they_are_read(tmp_path) -> None:
    part, out = tmp_path / "part.stl", tmp_path / "part.ngc"
    with open(part, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", 10_000_000))
        file.truncate(84 + 50 * 10_000_000)  # a sparse file: nothing of it is read
    environment = {"OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run(
        [sys.executable, "-c", LIMITED, part, out],
        capture_output=True,
        text=True,
        env=environment,
        timeout=60,
    )
    assert done.returncode == 2 and "10000000 facets need at least 1.9 GB" in done.stderr.replace(",", ""), (
        done.stderr
    )
    assert "coarser" in done.stderr and len(done.stderr.splitlines()) == 1 and not out.exists()


@linux
def test_free_memory_is_what_the_limit_of_the_process_leaves() -> None:
    code = (
        "import resource\nfrom freecad_fiveaxis.core.base.memory import free_memory\nbefore = free_memory()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (10**9, 10**9))\nprint(before, free_memory())"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    before, after = map(float, done.stdout.split())
    assert 0 < after < 1e9 and after < before


def square() -> object:
    return from_faces(
        np.array([(0.0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]), np.array([(0, 1, 2), (0, 2, 3)])
    )


def test_more_segments_than_can_be_held_are_refused_before_they_are_built(monkeypatch) -> None:
    monkeypatch.setattr(memory, "free_memory", lambda: 1000.0)
    with pytest.raises(SettingsError, match="larger stepover or scallop"):
        slice_mesh(square(), np.linspace(0.1, 0.9, 50), 0.0)


def test_more_segments_than_any_job_wants_are_refused(monkeypatch) -> None:
    monkeypatch.setattr(slicing, "MOST_SEGMENTS", 99)
    with pytest.raises(SettingsError, match="100 times, more than 99"):
        slice_mesh(square(), np.linspace(0.1, 0.9, 50), 0.0)
    monkeypatch.setattr(slicing, "MOST_SEGMENTS", 100)
    assert len(slice_mesh(square(), np.linspace(0.1, 0.9, 50), 0.0).point) == 200


def test_a_file_of_text_is_held_against_the_memory_as_well(tmp_path, monkeypatch) -> None:
    part = tmp_path / "part.stl"
    part.write_text("solid\n" + " " * 5000 + "endsolid\n")
    monkeypatch.setattr(memory, "free_memory", lambda: 1000.0)
    with pytest.raises(SettingsError, match="facets need at least"):
        read_stl(part)
