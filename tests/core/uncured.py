# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests ask for that look at the path itself: nothing divided, nothing lifted, as no default of ``mill``
or ``post`` is."""

UNDIVIDED = {"linearize": "off"}
UNCURED = {**UNDIVIDED, "gouge": "off"}
