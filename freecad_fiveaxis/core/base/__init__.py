# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every package stands on: errors, findings, progress, record arrays, chunks and threads, quantities,
number text, files."""
