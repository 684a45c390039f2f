#!/usr/bin/env python3
"""Runs a command that needs the laboratory with this Python; skipped, with status 77, where it lacks a module."""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from drc_lab.requirements import missing_modules  # noqa: E402

if missing := missing_modules():
    print(f"skipped: Python has no module {', '.join(missing)}")
    sys.exit(77)
os.environ["DRC_PYTHON"] = sys.executable
os.execv(sys.argv[1], sys.argv[1:])
