# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the CL path to joints: branch, winding, limits, retract and re-engage."""

from .plan import JointPath, solve

__all__ = ["JointPath", "solve"]
