#!/usr/bin/env python3
"""Breaks the renderer on purpose, one fault at a time, and says which of the tests of its invariants notice.

    tests/mutations.py [--build build/release] [NAME ...]

Each fault changes one place of a source file, which must be as it was committed; the file is put back whatever
happens. Exits with 1 if a fault stays unnoticed. Takes about a minute for each.
"""
import argparse
import os
import subprocess
import sys
from typing import NamedTuple

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Fault(NamedTuple):
    name: str
    file: str
    before: str
    after: str
    tests: str  # test filter; at least one of these tests must fail


FAULTS = [
    Fault("a look-up in a map returns two per cent too much", "src/cache/radiance_map.cpp",
          "lerp(fx, texel(i + n), texel(i + n + 1)));", "lerp(fx, texel(i + n), texel(i + n + 1))) * 1.02f;",
          "*Invariant1*"),
    Fault("the first surface's emission counts twice", "src/integrators/path_tracer.cpp",
          "return trace(ray, sampler, Emission::SkippedAtFirst, first);",
          "return trace(ray, sampler, Emission::Counted, first);", "*DirectPlusTracedIndirect*"),
    Fault("the glossy light traced with the direct light includes the broad lobes", "src/integrators/path_tracer.cpp",
          "along->narrow += scale * clampNonNegative(s->f - wide) * incident;",
          "along->narrow += scale * s->f * incident;", "*IndirectLightAlong*"),
    Fault("the gather forgets the BSDF's density", "src/cache/gather.cpp",
          "mapPdf + (both ? bsdf.pdf : 0)", "mapPdf", "*Oracle*"),
    Fault("directions below the horizon of a map with another normal are left out", "src/cache/gather.cpp",
          "glossy || dot(normal, site.n) < kParallel;", "glossy;", "*Invariant1*"),
    Fault("paths of glossy lobes that survive Russian roulette are not weighted up", "src/integrators/path_tracer.cpp",
          "return weight * incident(ray, sampler) * (1 / survival);", "return weight * incident(ray, sampler);",
          "*Oracle*"),
    Fault("a sampler depends on its thread", "src/cache/indirect_pass.cpp",
          "    Sampler sampler(pixelStream(x, y, kPrimary), uint32_t(index));",
          "    static thread_local uint32_t calls = 0;\n"
          "    Sampler sampler(pixelStream(x, y, kPrimary), uint32_t(index) + ++calls);", "*Invariant4*"),
    Fault("the maps of earlier passes are kept", "src/cache/indirect_pass.cpp",
          "    captureSites(maps.grid(), uint64_t(pass), 0, cancel);",
          "    captureSites(maps.grid(), uint64_t(pass), 0, cancel);\n"
          "    static std::vector<std::vector<MapSite>> kept;\n"
          "    kept.emplace_back(maps.grid().begin(), maps.grid().end());", "*Invariant5*"),
]


def failures(build, tests):
    """The names of the failing tests. Exits if the tests cannot be built or none match."""
    done = subprocess.run(["cmake", "--build", build, "--target", "pipeline_tests"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)
    out = subprocess.run([os.path.join(build, "tests/pipeline_tests"), f"--gtest_filter={tests}"],
                         capture_output=True, text=True)
    if "[ RUN" not in out.stdout:
        sys.exit(f"there are no tests {tests}")
    failed = [line.split("]")[1].split(",")[0].strip() for line in out.stdout.splitlines() if line.startswith("[  FAILED")]
    return sorted({name.split(" ")[0] for name in failed if "." in name})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="words; only faults whose name contains one of them (default: all)")
    parser.add_argument("--build", default=os.path.join(ROOT, "build/release"), help="the build folder")
    args = parser.parse_args()
    faults = [f for f in FAULTS if not args.names or any(name in f.name for name in args.names)]
    for f in faults:
        path = os.path.join(ROOT, f.file)
        if subprocess.run(["git", "-C", ROOT, "diff", "--quiet", "HEAD", "--", f.file]).returncode:
            sys.exit(f"{f.file} has changes that are not committed")
        if open(path).read().count(f.before) != 1:
            sys.exit(f"{f.file} no longer has, or has more than once: {f.before.strip()}")
    whole = failures(args.build, ":".join(sorted({f.tests for f in faults})))
    if whole:
        sys.exit(f"these tests fail on the unchanged code: {', '.join(whole)}")
    unnoticed = 0
    for f in faults:
        path = os.path.join(ROOT, f.file)
        source = open(path).read()
        try:
            open(path, "w").write(source.replace(f.before, f.after))
            failed = failures(args.build, f.tests)
        finally:
            open(path, "w").write(source)
        unnoticed += not failed
        print(f"{f.name}: " + (f"noticed by {len(failed)}: {', '.join(failed)}" if failed else "NOT NOTICED"), flush=True)
    return 1 if unnoticed else 0


sys.exit(main())
