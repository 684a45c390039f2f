#!/usr/bin/env python3
"""That drc ends with one line on a processor without its instructions, which qemu-user imitates; status 77 without it.

    tests/old_processor_test.py DRC
"""
import shutil
import subprocess
import sys

qemu = shutil.which("qemu-x86_64") or shutil.which("qemu-x86_64-static")
if qemu is None:
    print("skipped: there is no qemu-x86_64 (Debian's qemu-user)")
    sys.exit(77)


def version_on(processor):
    return subprocess.run([qemu, "-cpu", processor, sys.argv[1], "--version"], capture_output=True, text=True)


old, new = version_on("Nehalem"), version_on("Haswell")
lines = [line for line in old.stderr.splitlines() if not line.startswith("qemu")]
assert old.returncode == 1 and old.stdout == "", old
assert len(lines) == 1 and lines[0].startswith("drc: error: this processor lacks AVX2"), old
assert new.returncode == 0 and new.stdout.startswith("drc "), new
