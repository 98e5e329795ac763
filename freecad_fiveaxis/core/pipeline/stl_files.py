# SPDX-License-Identifier: LGPL-2.1-or-later
"""The STL files of a job, read in the unit that its settings name for all of them."""

from __future__ import annotations

from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.quantity import LENGTHS
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.gouge.fixtures import Fixture, read_fixtures

from .settings import Settings


def read_mesh(settings: Settings, path: str, progress: Progress) -> Mesh:
    """Read an STL file of the job into a welded mesh, mm. Raises FileError and MeshError as
    :func:`~freecad_fiveaxis.core.geometry.mesh.read_stl`."""
    return read_stl(path, progress, LENGTHS[settings.faces.stl_units])


def read_job_fixtures(settings: Settings, progress: Progress) -> tuple[Fixture, ...]:
    """Read the fixtures of the job and put them where they stand. Raises FiveAxisError as
    :func:`~freecad_fiveaxis.core.gouge.fixtures.read_fixtures`."""
    return read_fixtures(settings.gouge.fixture, progress, LENGTHS[settings.faces.stl_units])
