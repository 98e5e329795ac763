# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs named checks inside FreeCAD, prints a line each, and leaves with a true exit code.

FreeCAD itself exits with 0 after an uncaught exception, so that only os._exit tells.
"""

import os
import sys
import traceback


def run_and_exit(checks):
    """Run the functions; exit 0 if none of them raises."""
    failed = 0
    for check in checks:
        try:
            check()
            print(f"freecad: {check.__name__} passed")
        except BaseException:
            failed += 1
            print(f"freecad: {check.__name__} FAILED")
            traceback.print_exc()
    print(f"{len(checks) - failed} passed, {failed} failed")
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(1 if failed else 0)
