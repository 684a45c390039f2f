#!/usr/bin/env python3
"""Starts the laboratory: lab/start.py bench ... | evaluate-page REPORT.json ... | check."""

import signal
import sys

if sys.version_info < (3, 11):
    print(
        f"drc: error: {sys.executable} is Python {sys.version.split()[0]}: let DRC_PYTHON name one of 3.11 or later",
        file=sys.stderr,
    )
    sys.exit(1)

# Ctrl-C ends the process without a traceback, until there is something to keep.
if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.SIG_DFL)

from drc_lab.__main__ import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
