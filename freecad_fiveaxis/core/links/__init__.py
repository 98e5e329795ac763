# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ways between passes: links near the part, lead-ins, rapids clear of the part whichever way a controller
takes."""
