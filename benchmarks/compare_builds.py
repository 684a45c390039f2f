#!/usr/bin/env python3
"""Whether two builds of drc have the same expectation, and which is faster.

    benchmarks/compare_builds.py OLD_DRC NEW_DRC SCENE... [--integrator path,drc,drc-maps,bdpt,direct]
                                 [--resolution 160x90] [--spp 16] [--seeds 4] [--nthreads 0] [--speed]

Renders each scene with each integrator, --seeds pictures a build, no two of the same seed, in the order old new new old,
and compares the means of blocks of 8x8 pixels, each channel for itself. Nothing is denoised; the correction of
maps by path-traced samples is left on, so the rows of drc-maps compare what a user gets.

z is the difference of both builds' means over its standard error, which the scatter among the pictures of each build
gives. It follows Student's t with the degrees of freedom of Welch and Satterthwaite; Wallace's approximation (1959)
makes a normal deviate of it wherever the table says normal. A row differs by any of three, each of which chance
exceeds in about one row of a thousand or fewer:

- block: the worst normal |z|, against Sidak's bound for as many tests. Finds a local error much larger than the noise.
- share: how many of the |z| are above 3, against what Student's t predicts and, of as many independent tests as the
  correlation of blocks and channels leaves, the binomial distribution allows. Finds errors of many blocks.
- mean: the worst normal |z| of the whole picture's channels. Finds errors too small for any block.

"agree" says that no difference was found that is larger than the noise: the standard error of the mean ratio says how
small that is. With 4 seeds, 6 degrees of freedom, the mean must be off by 7.4 standard errors to be found, with 16 seeds
by 4.1. Fireflies widen the errors of the pictures that have them and so hide differences; they do not make any.

--speed adds wall-clock and user processor time of the whole process, reading and writing included, from the same runs:
medians, and the ratio of them with the least and greatest ratio of a pair. One uncounted run of each build goes before.
Short runs measure the start of the program; the machine has to be idle.

Prints a Markdown table, progress on stderr. The status is 1 if a row differs or a run fails. --self-test compares
synthetic pictures, with differences and without; the status is 77 if it cannot run. Needs numpy and OpenEXR.
"""
import argparse
import dataclasses
import importlib.util
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from common import table

np = None  # numpy, imported by need()

BLOCK = 8
CHANCE = 1e-3     # by which a row differs although the builds agree, for each of the three reasons
ROUNDING = 1e-5   # of a mean: what the order of sums in single precision may change where there is no noise
HIGH = 3
SKIPPED = 77


class Failure(Exception):
    """Says in one line why a row has no verdict."""


def need(*modules):
    """Imports them, or says all that are missing and what to do."""
    missing = [m for m in modules if importlib.util.find_spec(m) is None]
    if missing:
        print(f"compare_builds.py: missing {' and '.join(missing)}: python3 -m pip install {' '.join(missing)}",
              file=sys.stderr)
        sys.exit(SKIPPED if "--self-test" in sys.argv[1:] else 2)
    global np
    np = importlib.import_module("numpy")


# Statistics


def normal_deviate(t, freedom):
    """Of |t| by Wallace's approximation. Too small in the far tail of few degrees of freedom, which is the safe side."""
    return (8 * freedom + 1) / (8 * freedom + 3) * np.sqrt(freedom * np.log1p(t * t / freedom))


def beyond(x):
    """The probability that a normal deviate's absolute value exceeds x."""
    return math.erfc(x / math.sqrt(2))


def sidak_bound(tests):
    """Which the largest of so many normal |z| exceeds with probability CHANCE, if they are independent or, like the
    channels of a pixel, positively correlated: then it is generous."""
    return -statistics.NormalDist().inv_cdf(-math.expm1(math.log1p(-CHANCE) / tests) / 2)


def binomial_bound(count, p):
    """The least k that a binomial variable of `count` trials reaches with a probability below CHANCE."""
    tail, k = 1.0, 0
    while tail >= CHANCE and k <= count:
        tail -= math.exp(math.lgamma(count + 1) - math.lgamma(k + 1) - math.lgamma(count - k + 1) + k * math.log(p) +
                         (count - k) * math.log1p(-p))
        k += 1
    return k


def independent_tests(old, new):
    """How many independent tests scatter as much as those of the columns of old and new, [seeds, columns].

    With correlations r it is columns^2 over the sum of r^2 of all pairs of columns. Of n degrees of freedom, the mean of
    the measured r^2 is 1/n where the true r is 0 and 1 where it is 1: (n r^2 - 1) / (n - 1) is right at both ends.
    """
    def unit(columns):
        lengths = np.sqrt((columns ** 2).sum(0))
        return columns / np.where(lengths > 0, lengths, 1)

    # Each build to the same variance first: the noisier one alone would have half the degrees of freedom.
    residuals = unit(np.concatenate([unit(old - old.mean(0)), unit(new - new.mean(0))]))
    residuals = residuals[:, (residuals != 0).any(0)]
    freedom = len(residuals) - 2
    columns = residuals.shape[1]
    if columns == 0:
        return 1
    # The sum over pairs of columns, from the much smaller product of pictures.
    squares = (freedom * ((residuals @ residuals.T) ** 2).sum() - columns ** 2) / (freedom - 1)
    return max(1, min(columns, round(columns ** 2 / max(squares, columns))))


@dataclasses.dataclass
class Welch:
    """Tests of columns, [seeds, columns] of each build."""
    old: object
    new: object
    old_variance: object  # of the mean
    new_variance: object
    t: object
    freedom: object       # of t; inf where only rounding makes the pictures differ
    tested: object        # False where both builds are black in all pictures


def welch(old, new):
    mean_old, mean_new = old.mean(0), new.mean(0)
    v_old, v_new = old.var(0, ddof=1) / len(old), new.var(0, ddof=1) / len(new)
    # Where there is no noise, as on a light of even radiance, rounding alone is no difference, and all else is one.
    variance = v_old + v_new + (ROUNDING * np.maximum(abs(mean_old), abs(mean_new))) ** 2
    tested = variance > 0
    spread = v_old ** 2 / (len(old) - 1) + v_new ** 2 / (len(new) - 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        # Beyond 1e6 Student's t is the normal distribution, and quotients may overflow.
        freedom = np.where(spread > 0, np.minimum(variance ** 2 / spread, 1e6), 1e6)
        t = np.where(tested, (mean_new - mean_old) / np.sqrt(variance), 0)
    return Welch(mean_old, mean_new, v_old, v_new, t, freedom, tested)


def block_means(pictures):
    """[seeds, height, width, 3] to [seeds, blocks down, blocks across, 3]; blocks at the far edges may be smaller."""
    def along(values, axis):
        size = values.shape[axis]
        starts = np.arange(0, size, BLOCK)
        counts = np.minimum(starts + BLOCK, size) - starts
        return np.add.reduceat(values, starts, axis) / counts.reshape([-1 if i == axis else 1 for i in range(4)])
    return along(along(pictures.astype(np.float64), 1), 2)


@dataclasses.dataclass
class Comparison:
    ratio: list           # new / old of the whole picture, by channel; nan where old is black
    ratio_error: list     # standard error of it
    mean: float           # worst normal |z| of the whole picture's channels
    mean_bound: float
    worst: float          # worst normal |z| of a block and channel
    worst_bound: float
    worst_at: str
    share: float          # of |z| above HIGH
    predicted: float
    allowed: float

    def reasons(self):
        # Written so that NaN differs.
        return ([] if self.worst <= self.worst_bound else ["block"]) + \
               ([] if self.share < self.allowed else ["share"]) + ([] if self.mean <= self.mean_bound else ["mean"])

    def verdict(self):
        return f"DIFFER: {', '.join(self.reasons())}" if self.reasons() else "agree"


def compare(old, new):
    """Of pictures, [seeds, height, width, 3] of each build."""
    whole = welch(*(p.astype(np.float64).mean((1, 2)) for p in (old, new)))
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = whole.new / whole.old
        ratio_error = np.sqrt(whole.new_variance + ratio ** 2 * whole.old_variance) / abs(whole.old)
    blocks_old, blocks_new = block_means(old), block_means(new)
    down, across, channels = blocks_old.shape[1:]
    columns_old, columns_new = (b.reshape(len(b), -1) for b in (blocks_old, blocks_new))
    blocks = welch(columns_old, columns_new)
    tests = int(blocks.tested.sum())
    if tests == 0:
        raise Failure("nothing to compare: all pictures are black")
    z = normal_deviate(blocks.t, blocks.freedom)
    y, x, channel = np.unravel_index(int(np.argmax(z)), (down, across, channels))
    thresholds = normal_deviate(np.full(z.shape, float(HIGH)), blocks.freedom)[blocks.tested]
    predicted = float(np.mean([beyond(threshold) for threshold in thresholds]))
    independent = independent_tests(columns_old, columns_new)
    return Comparison(list(ratio), list(ratio_error), float(normal_deviate(whole.t, whole.freedom).max()),
                      sidak_bound(3), float(z.max()), sidak_bound(tests), f"{'RGB'[channel]} {x * BLOCK},{y * BLOCK}",
                      float((abs(blocks.t) > HIGH).sum() / tests), predicted,
                      binomial_bound(independent, predicted) / independent)


# Runs


def render(drc, scene, integrator, seed, spp, args, picture):
    """Wall-clock and user processor seconds of the whole process."""
    command = [drc, "render", scene, "-o", picture, "--integrator", integrator, "--spp", spp, "--seed", seed,
               "--resolution", args.resolution, "--nthreads", args.nthreads, "--denoise", "off", "--quiet"]
    with tempfile.TemporaryFile() as log:
        start = time.monotonic()
        process = subprocess.Popen(list(map(str, command)), stdout=log, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)  # the one call that has the times of this process alone
        wall = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            log.seek(0)
            lines = log.read().decode(errors="replace").split("\n")
            raise Failure(next((line for line in reversed(lines) if line.strip()),
                               f"status {process.returncode}, without a word"))
    return wall, usage.ru_utime


def read_picture(path):
    import OpenEXR
    with OpenEXR.File(path) as file:
        pixels = file.channels()["RGB"].pixels
    bad = int((~np.isfinite(pixels)).any(2).sum())
    if bad:
        raise Failure(f"{bad} pixels are not finite")
    return np.array(pixels)


def run_row(scene, integrator, args):
    """Renders all pictures of a row: the comparison, and of each build the [wall, user] seconds of each picture."""
    pictures, seconds = {"old": [], "new": []}, {"old": [], "new": []}
    programs = {"old": args.old, "new": args.new}
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.exr")

        def run(build, seed, spp):
            try:
                times = render(programs[build], scene, integrator, seed, spp, args, picture)
                return times, read_picture(picture)
            except Failure as failure:
                raise Failure(f"{build}, seed {seed}: {failure}") from None

        if args.speed:  # The first run of all finds neither programs nor scene in memory.
            for build in programs:
                run(build, 0, 1)
        for i in range(1, args.seeds + 1):
            for build in ("old", "new") if i % 2 else ("new", "old"):
                times, pixels = run(build, i if build == "old" else 1000 + i, args.spp)
                seconds[build].append(times)
                pictures[build].append(pixels)
                print(f"{name_of(scene)} {integrator}: {build} {i} of {args.seeds}, {times[0]:.2f} s", file=sys.stderr)
    old, new = np.array(pictures["old"]), np.array(pictures["new"])
    if old.shape != new.shape:
        raise Failure(f"the builds' pictures have different sizes, {old.shape[2]}x{old.shape[1]} and "
                      f"{new.shape[2]}x{new.shape[1]}")
    return compare(old, new), seconds


def name_of(scene):
    folder, file = os.path.split(os.path.abspath(scene))
    return os.path.basename(folder) if file == "scene.pbrt" else os.path.splitext(file)[0]


def comparison_cells(c):
    ratios = " ".join(f"{r:.4f}±{e:.4f}" if math.isfinite(r) else "-" for r, e in zip(c.ratio, c.ratio_error))
    return [ratios, f"{c.mean:.2f} ({c.mean_bound:.2f})", f"{c.worst:.2f} ({c.worst_bound:.2f}) {c.worst_at}",
            f"{c.share:.2%}, {c.predicted:.2%} ({c.allowed:.2%})"]


def speed_cells(seconds):
    cells = []
    for clock in 0, 1:
        old, new = ([times[clock] for times in seconds[build]] for build in ("old", "new"))
        if min(old) <= 0:
            cells.append("too short")
            continue
        pairs = [n / o for o, n in zip(old, new)]
        cells.append(f"{statistics.median(old):.3f} {statistics.median(new):.3f} "
                     f"{statistics.median(new) / statistics.median(old):.3f} ({min(pairs):.3f} to {max(pairs):.3f})")
    return cells


# What is tested with pictures that are made up


def self_test():
    import unittest

    class Test(unittest.TestCase):
        SEEDS, HEIGHT, WIDTH = 4, 92, 160  # the lowest blocks are half as high
        EXPECTED = None

        def setUp(self):
            self.rng = np.random.default_rng(1)
            self.EXPECTED = self.rng.uniform(.2, 2, (self.HEIGHT, self.WIDTH, 3))

        def pictures(self, change=1, noise="gamma"):
            """Pictures of expectation EXPECTED * change, their noise as skewed as that of few paths a pixel."""
            shape = (self.SEEDS, self.HEIGHT, self.WIDTH, 1)
            factor = {"gamma": lambda: self.rng.gamma(.5, 2, shape),
                      "fireflies": lambda: 1 + 1000 * (self.rng.random(shape) < 1e-4) - .1,
                      # As if a few maps lit all of the picture: 20x20 pixels have the same noise.
                      "maps": lambda: self.rng.gamma(5, .2, (self.SEEDS, 5, 8, 1)).repeat(20, 1).repeat(20, 2)[:, :92],
                      "none": lambda: np.ones(shape)}[noise]()
            return (self.EXPECTED * change * factor).astype(np.float32)

        def difference(self, change, noise="gamma"):
            return compare(self.pictures(noise=noise), self.pictures(change, noise)).reasons()

        def test_same_expectations_agree(self):
            for noise in "gamma", "fireflies", "maps", "none":
                wrong = [r for _ in range(40) for r in self.difference(1, noise)]
                # Three chances of one in a thousand each: more than two of 40 have a probability of .0002.
                self.assertLessEqual(len(wrong), 2, (noise, wrong))

        def test_share_is_as_predicted(self):
            results = [compare(self.pictures(), self.pictures()) for _ in range(20)]
            share, predicted = (statistics.mean(getattr(r, k) for r in results) for k in ("share", "predicted"))
            self.assertGreater(share, .7 * predicted)
            self.assertLess(share, 1.2 * predicted)

        def test_small_shift_of_everything_is_found_by_the_mean(self):
            self.SEEDS = 16
            self.assertEqual(self.difference(1.03), ["mean"])

        def test_shift_of_one_block_is_found(self):
            self.SEEDS = 16
            change = np.ones((self.HEIGHT, self.WIDTH, 1))
            change[40:48, 80:88] = 4
            result = compare(self.pictures(), self.pictures(change))
            self.assertEqual(result.reasons(), ["block"])
            self.assertEqual(result.worst_at[2:], "80,40")

        def test_shifts_that_cancel_are_found_by_the_share(self):
            change = 1 + .8 * np.sign(np.sin(np.arange(self.WIDTH) * math.pi / 16 + .01)).reshape(1, -1, 1)
            self.assertIn("share", self.difference(change))

        def test_without_noise_only_rounding_may_differ(self):
            self.assertEqual(self.difference(1 + 1e-6, "none"), [])
            self.assertIn("block", self.difference(1 + 1e-3, "none"))

        def test_black_against_light_is_found(self):
            self.assertIn("mean", self.difference(0))
            self.assertRaises(Failure, compare, self.pictures(0), self.pictures(0))

        def test_blocks_at_the_far_edges_are_means_too(self):
            blocks = block_means(np.arange(20.).reshape(1, 20, 1, 1) * np.ones((1, 20, 12, 3)))
            np.testing.assert_allclose(blocks[0, :, :, 0], [[3.5, 3.5], [11.5, 11.5], [17.5, 17.5]])

        def test_independent_tests_are_counted(self):
            blocks = math.ceil(self.HEIGHT / BLOCK) * self.WIDTH // BLOCK
            for noise, least, most in ("gamma", .9 * blocks, 1.1 * blocks), ("maps", 25, 100):
                old, new = (block_means(self.pictures(noise=noise)).reshape(self.SEEDS, -1) for _ in range(2))
                for scale in 1, .01:  # of the noise of one build
                    count = independent_tests(old, scale * new)
                    self.assertTrue(least < count < most, (noise, scale, count))

        def test_bounds_are_those_of_tables(self):
            self.assertAlmostEqual(sidak_bound(1), 3.2905, 4)
            self.assertAlmostEqual(float(normal_deviate(np.float64(5.959), 6)), 3.2905, 1)  # of t, two-sided .001
            # P(X >= 6) of 100 trials of .01 is .00053, of 5 it is .0034.
            self.assertEqual(binomial_bound(100, .01), 6)

    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Test)
    return 0 if unittest.TextTestRunner().run(suite).wasSuccessful() else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", metavar="OLD_DRC", nargs="?")
    parser.add_argument("new", metavar="NEW_DRC", nargs="?")
    parser.add_argument("scenes", metavar="SCENE", nargs="*")
    parser.add_argument("--integrator", default="path,drc,drc-maps,bdpt,direct", help="one or more, with commas between")
    parser.add_argument("--resolution", default="160x90")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--seeds", type=int, default=4, help="pictures of each build, 2 to 1000")
    parser.add_argument("--nthreads", type=int, default=0, help="0: one a core")
    parser.add_argument("--speed", action="store_true", help="also say which is faster")
    parser.add_argument("--self-test", action="store_true", help="test the comparison itself")
    args = parser.parse_args()
    if args.self_test:
        need("numpy")
        return self_test()
    if not args.scenes:
        parser.error("give two builds of drc and one scene or more")
    if not 2 <= args.seeds <= 1000:
        parser.error("--seeds must be 2 to 1000")
    for program in args.old, args.new:
        if shutil.which(program) is None:
            parser.error(f"{program} is no program")
    need("numpy", "OpenEXR")

    heads = ["scene", "integrator", "mean new/old RGB", "mean, normal z (bound)", "worst block, normal z (bound)",
             f"z above {HIGH}, predicted (allowed)"]
    heads += ["wall s old, new, ratio", "user s old, new, ratio"] if args.speed else []
    rows = []
    for scene in args.scenes:
        for integrator in args.integrator.split(","):
            try:
                comparison, seconds = run_row(scene, integrator, args)
                cells = comparison_cells(comparison) + (speed_cells(seconds) if args.speed else [])
                verdict = comparison.verdict()
            except Failure as failure:
                cells, verdict = ["-"] * (len(heads) - 2), f"FAILED: {failure}"
            rows.append([name_of(scene), integrator, *cells, verdict])
            print("  ".join(rows[-1]), file=sys.stderr, flush=True)
    print(f"{args.resolution}, {args.spp} spp, {args.seeds} seeds, blocks of {BLOCK}x{BLOCK}\n")
    print(table(heads + ["verdict"], rows))
    return 1 if any(row[-1] != "agree" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
