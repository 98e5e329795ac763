# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts, and what the pipeline makes of them, each made once."""

import subprocess
import sys
from pathlib import Path

import engines
import pytest
from one_field import keep_fields
from plain import build_settings
from uncured import UNCURED

from freecad_fiveaxis.core.pipeline import job

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def parts(tmp_path_factory):
    """A folder with the example parts, made by the project's own script."""
    folder = tmp_path_factory.mktemp("parts")
    script = ROOT / "resources" / "examples" / "make_parts.py"
    subprocess.run([sys.executable, str(script), str(folder)], check=True, capture_output=True, timeout=120)
    return folder


@pytest.fixture(scope="session")
def milled(parts):
    """Results by part, machine and controller, each made once; without a cure, unless the options ask for
    one."""
    result = {}

    def mill(part, machine, controller="linuxcnc", **options):
        key = (part, machine, controller, *sorted(options.items()))
        if key not in result:
            given = {
                "machine": machine,
                "controller": controller,
                "stepover": 5,
                "tool_length": 120,
                **UNCURED,
                **options,
            }
            result[key] = job.run(build_settings("mill", str(parts / f"{part}.stl"), given))
        return result[key]

    return mill


@pytest.fixture(scope="session")
def processes():
    """A pool of two processes, for all whose tasks leave them alive."""
    with engines.processes() as pool:
        yield pool


@pytest.fixture(scope="module")
def loky():
    """As ``processes``, of another package."""
    with engines.loky() as pool:
        yield pool


@pytest.fixture(scope="module")
def dask():
    """A client of two workers, for those who kill some of them too."""
    with engines.dask_client() as client:
        yield client


@pytest.fixture(scope="module")
def living(request):
    """living(name): an executor of that engine, whose workers serve all tests of a file."""

    def find(name):
        result = request.getfixturevalue(name)
        return result.get_executor() if name == "dask" else result

    return find


@pytest.fixture(scope="module", params=engines.ENGINES)
def engine(request, living):
    """Each engine that may be given work."""
    name = request.param
    if name in engines.SHARED:
        yield engines.Engine(name, living(name), True)
        return
    with engines.OPEN[name]() as result:
        yield engines.Engine(name, result, name in engines.APART)


@pytest.fixture(scope="module")
def fields_kept():
    """Runs of a file find the field of tool axes of a part and tool once; ask for it only where no test
    breaks how the field is found."""
    with pytest.MonkeyPatch.context() as patch:
        keep_fields(patch)
        yield
