# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a Setup shows itself: in the tree alone. The path of this class stands in saved documents: it is
forever."""

from __future__ import annotations

from typing import Any

from .views import View


class JobSetupView(View):
    """A Setup; nothing to draw."""

    def doubleClicked(self, vobj: Any) -> bool:
        """Open the dialog."""
        from .messages import telling
        from .panels import job_setup

        with telling():
            job_setup.edit(self.obj.Document, self.obj)
        return True
