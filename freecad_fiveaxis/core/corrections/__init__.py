# SPDX-License-Identifier: LGPL-2.1-or-later
"""What changes a path against deviation, singularity or overcut."""
