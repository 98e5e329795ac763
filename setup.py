# SPDX-License-Identifier: LGPL-2.1-or-later
"""The packages that are installed; all else stands in pyproject.toml.

``resources`` lies beside the package, where package.xml names its icons, and is installed inside of it. The
``packages.find`` of pyproject.toml knows no package of two folders.
"""

from setuptools import find_namespace_packages, find_packages, setup

RESOURCES = "freecad_fiveaxis.resources"

setup(
    packages=[
        *find_packages(include=["freecad_fiveaxis", "freecad_fiveaxis.*"]),
        RESOURCES,
        *(f"{RESOURCES}.{name}" for name in find_namespace_packages("resources")),
    ],
    package_dir={RESOURCES: "resources"},
)
