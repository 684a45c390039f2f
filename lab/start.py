#!/usr/bin/env python3
"""Starts the laboratory: lab/start.py bench ... | evaluate-page REPORT.json ... | check."""

import sys

if sys.version_info < (3, 11):
    print(
        f"drc: error: {sys.executable} is Python {sys.version.split()[0]}: let DRC_PYTHON name one of 3.11 or later",
        file=sys.stderr,
    )
    sys.exit(1)

from drc_lab.__main__ import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
