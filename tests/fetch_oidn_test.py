#!/usr/bin/env python3
"""scripts/fetch-oidn where there is no network, or not what it expects: one line, no failure, nothing half-written."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

SCRIPTS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scripts")


def requirement():
    with open(os.path.join(SCRIPTS, "oidn-requirement.txt")) as f:
        return re.search(r"^(\S+)==(\S+) --hash=sha256:[0-9a-f]{64}$", f.read(), re.MULTILINE).groups()


class FetchOidn(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.build = os.path.join(self.folder.name, "build")
        self.addCleanup(self.folder.cleanup)

    def fetch(self, **environment):
        run = subprocess.run([os.path.join(SCRIPTS, "fetch-oidn"), self.build], capture_output=True, text=True,
                             env={**os.environ, "PIP_NO_INDEX": "1", **environment})
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr, "")
        self.assertEqual(len(run.stdout.splitlines()), 1, run.stdout)
        return run.stdout

    def test_without_a_network_the_renderer_does_without(self):
        self.assertIn("could not be fetched; unless another is installed, pictures will be noisy", self.fetch())
        self.assertEqual(os.listdir(self.build), [])

    def test_another_file_of_the_same_name_is_refused(self):
        package, version = requirement()
        with zipfile.ZipFile(os.path.join(self.folder.name, f"{package}-{version}-py3-none-any.whl"), "w") as wheel:
            wheel.writestr(f"{package}/oidn/lib/libOpenImageDenoise.so.2", "not what was meant")
            wheel.writestr(f"{package}-{version}.dist-info/METADATA", f"Name: {package}\nVersion: {version}\n")
        self.assertIn("could not be fetched", self.fetch(PIP_FIND_LINKS=self.folder.name))
        self.assertEqual(os.listdir(self.build), [])

    def test_one_that_is_there_is_kept(self):
        os.makedirs(os.path.join(self.build, "oidn"))
        with open(os.path.join(SCRIPTS, "oidn-requirement.txt")) as f, \
                open(os.path.join(self.build, "oidn", "requirement.txt"), "w") as copy:
            copy.write(f.read())
        self.assertIn("is there", self.fetch())
        # Of another version: kept until there is a newer one.
        with open(os.path.join(self.build, "oidn", "requirement.txt"), "w") as copy:
            copy.write("older")
        self.assertIn("could not be fetched", self.fetch())
        self.assertEqual(os.listdir(os.path.join(self.build, "oidn")), ["requirement.txt"])


if __name__ == "__main__":
    if subprocess.run([sys.executable, "-m", "pip", "--version"], capture_output=True).returncode != 0:
        print("skipped: Python has no pip")
        sys.exit(77)
    unittest.main()
