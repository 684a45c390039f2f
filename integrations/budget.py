"""What a renderer's script owes to `drc bench`: its arguments, its time, its one line of refusal."""
import argparse
import json
import os
import sys
import time

from drc_export import Refused


def arguments(about):
    parser = argparse.ArgumentParser(description=about)
    parser.add_argument("--scene", required=True)
    parser.add_argument("--output", required=True, help="linear RGB EXR")
    parser.add_argument("--width", type=int, required=True)
    parser.add_argument("--height", type=int, required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--drc", help="drc, which reads the scene")
    parser.add_argument("--timing", help="JSON file for the seconds of rendering alone")
    budget = parser.add_mutually_exclusive_group(required=True)
    budget.add_argument("--seconds", type=float, help="for the whole process")
    budget.add_argument("--spp", type=int)
    return parser


def since_start():
    """Seconds since this process began, before Python itself was loaded."""
    with open("/proc/self/stat") as f:
        ticks = int(f.read().rsplit(")", 1)[1].split()[19])
    with open("/proc/uptime") as f:
        return float(f.read().split()[0]) - ticks / os.sysconf("SC_CLK_TCK")


class Deadline:
    """The moment at which the process should have ended. Asked often, and so by a clock of its own."""

    def __init__(self, seconds):
        self.at = time.monotonic() - since_start() + seconds

    def left(self):
        return self.at - time.monotonic()


def write_timing(path, seconds):
    if path:
        with open(path, "w") as f:
            json.dump({"render_seconds": seconds}, f)


def note(text):
    """What the user should know about a picture that is made all the same."""
    print("note: " + text, file=sys.stderr, flush=True)


def run(main):
    """Runs main(). A refusal is one line on standard error and a status that is not zero."""
    try:
        main()
    except Refused as refusal:
        sys.exit(" ".join(str(refusal).split()))
