# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many runs of one job compared: part positions (setup map) and corrections."""
