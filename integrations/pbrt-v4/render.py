#!/usr/bin/env python3
"""Renders a scene with pbrt-v4: our size, samples, integrator and longest path, everything else as in the file."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))

import budget
import pbrt_program

if __name__ == "__main__":
    budget.run(lambda: pbrt_program.main(4, __doc__))
