# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel in which a machine is edited."""

from .panel import EditorPanel, create

__all__ = ["EditorPanel", "create"]
