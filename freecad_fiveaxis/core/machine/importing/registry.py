# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinematics of LinuxCNC that can be read, by the name of their module."""

from __future__ import annotations

from .heads import HEADS
from .nutating import NUTATING
from .record import Kinematics
from .tables import TABLES
from .trivial import TRIVIAL

KINEMATICS: dict[str, Kinematics] = {kind.name: kind for kind in (*TABLES, *HEADS, *NUTATING, *TRIVIAL)}
