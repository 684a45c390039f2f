#!/usr/bin/env python3
"""Starts the laboratory: lab/start.py bench ... | evaluate-page REPORT.json ... | check."""

import os
import signal
import subprocess
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
from drc_lab.requirements import missing_modules  # noqa: E402

# Debian's packages belong to Debian's Python, which is not the first one in PATH where there is a pyenv or a conda.
DEBIANS = "/usr/bin/python3"
CHECK = "import sys; sys.path.insert(0, sys.argv[1]); from drc_lab.requirements import missing_modules as m; sys.exit(bool(m()))"


def would_serve(python):
    command = [python, "-c", CHECK, os.path.dirname(os.path.abspath(__file__))]
    return os.path.exists(python) and subprocess.run(command, capture_output=True).returncode == 0


if missing_modules() and not os.environ.get("DRC_PYTHON") and sys.executable != DEBIANS and would_serve(DEBIANS):
    os.execv(DEBIANS, [DEBIANS, *sys.argv])

sys.exit(main(sys.argv[1:]))
