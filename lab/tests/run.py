#!/usr/bin/env python3
"""Runs all tests of the laboratory: lab/tests/run.py [DRC]. DRC: the program, without which tests of both are skipped.

Where Python lacks one of the modules, the tests are skipped as a whole: status 77.
"""

import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE)]

from drc_lab.requirements import missing_modules  # noqa: E402


def main():
    if missing := missing_modules():
        print(f"skipped: Python has no module {', '.join(missing)}")
        return 77
    if len(sys.argv) > 1:
        os.environ["DRC_PROGRAM"] = str(Path(sys.argv[1]).resolve(strict=True))
    tests = unittest.defaultTestLoader.discover(str(HERE), pattern="test_*.py", top_level_dir=str(HERE))
    return 0 if unittest.TextTestRunner(verbosity=1).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
