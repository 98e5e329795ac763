# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine as it is: recovered from programs of its post, proven by its signs."""
