# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python -m freecad_fiveaxis ...``: the command line of :mod:`freecad_fiveaxis.core.cli`."""

import sys

if __name__ == "__main__":
    try:
        from freecad_fiveaxis.core import signals

        signals.watch()
        from freecad_fiveaxis.core.cli import main

        code = main()
    except KeyboardInterrupt as stop:  # before main could take care of it
        if sys.stderr is not None:
            print("stopped; nothing was written", file=sys.stderr, flush=True)
        code = 128 + getattr(stop, "number", 2)
    sys.exit(code)
