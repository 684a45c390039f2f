"""Budgets, spreads, JSON and tables."""

import json
import math
import unittest

from drc_lab.budget import SECONDS, SPP, parse_budgets
from drc_lab.errors import UsageError
from drc_lab.result import NOT_MEASURED, Report, Run, Scene, opponent_error, runs_of, spread_of
from drc_lab.result_json import report_json, run_from_json, run_json
from drc_lab.table import markdown
from lab_testing import seconds, spp, tasks


class Budgets(unittest.TestCase):
    def test_have_names(self):
        names = [budget.name for budget in (seconds(2.5), spp(16), tasks(256), tasks(1))]
        self.assertEqual(names, ["2.5 s", "16 spp", "256 tasks", "1 task"])

    def test_ranges_double(self):
        self.assertEqual([b.amount for b in parse_budgets(["1..5", "4", "7"], SPP, "--spp")], [1, 2, 4, 7])

    def test_bad_amounts_are_refused(self):
        for text in ("ten", "-1", "0", "1e9", "", "inf", "nan", " 1", "1_0", "1.."):
            with self.assertRaisesRegex(UsageError, "--seconds .*positive", msg=text):
                parse_budgets([text], SECONDS, "--seconds")
        with self.assertRaisesRegex(UsageError, "whole"):
            parse_budgets(["1.5"], SPP, "--spp")


class Spreads(unittest.TestCase):
    def test_few_values_spread_over_all_of_them(self):
        spread = spread_of([3, 1, NOT_MEASURED, 2, 7])
        self.assertEqual((spread.count, spread.median, spread.low, spread.high), (4, 2.5, 1, 7))
        self.assertEqual(spread_of([4]).low, 4)
        self.assertTrue(math.isnan(spread_of([NOT_MEASURED]).median))

    def test_many_values_have_the_interval_of_the_sign_test(self):
        for n, interval in ((6, (1, 6)), (8, (1, 8)), (9, (2, 8)), (12, (3, 10)), (25, (8, 18))):
            spread = spread_of(list(range(n, 0, -1)))
            self.assertEqual((spread.low, spread.high), interval, n)

    def test_failed_runs_are_none_of_the_runs(self):
        runs = [Run("s", "m", spp(4)), Run("s", "m", spp(4), failure="no"), Run("s", "m", spp(8))]
        self.assertEqual(len(runs_of(Report(runs=runs), "s", "m", spp(4))), 1)
        self.assertEqual(runs_of(Report(runs=runs), "s", "m", tasks(4)), [])

    def test_the_opponent_is_path_tracing_with_the_best_mode(self):
        report = Report(methods=["drc", "path+oidn", "path+oidn:fast-raw", "path+oidn:high", "path+oidn2"])
        errors = (
            ("drc", 0.1),
            ("path+oidn", 0.5),
            ("path+oidn", 0.7),
            ("path+oidn:fast-raw", 0.4),
            ("path+oidn2", 0.2),
        )
        report.runs = [Run("s", method, seconds(4), error=error) for method, error in errors]
        self.assertEqual(opponent_error(report, "s", seconds(4)), 0.4)
        del report.methods[2]
        self.assertAlmostEqual(opponent_error(report, "s", seconds(4)), 0.6)  # the median of its repeats
        self.assertTrue(math.isnan(opponent_error(report, "other", seconds(4))))
        for run in report.runs:
            run.error = -1e-6
        self.assertTrue(math.isnan(opponent_error(report, "s", seconds(4))))


def some_run(**values):
    run = Run("room", "drc-maps:gaussian+oidn", tasks(16), 2, picture="runs/a.exr", oidn_mode="fast-raw")
    run.measured_against, run.seconds, run.ssim, run.error, run.error_se = "state", 1.5, 0.9, 0.01, 0.002
    run.entropy, run.mean_ratio = 6.5, [1, 0.99, 1.01]
    for name, value in values.items():
        setattr(run, name, value)
    return run


class Records(unittest.TestCase):
    def test_runs_come_back_as_they_were(self):
        run = some_run()
        back = run_from_json(run_json(run, "key"), "key")
        self.assertTrue(math.isnan(back.render_seconds))
        for one in (run, back):  # NaN is not equal to itself
            one.__dict__ = {name: None if value != value else value for name, value in one.__dict__.items()}
        self.assertEqual(back, run)

    def test_failures_come_back(self):
        run = some_run(failure='it "fell" over')
        self.assertEqual(run_from_json(run_json(run, "key"), "key").failure, run.failure)

    def test_another_key_and_damage_are_no_run(self):
        text = run_json(some_run(), "key")
        self.assertIsNone(run_from_json(text, "other"))
        for i in range(0, len(text) - 2, 17):
            self.assertIsNone(run_from_json(text[:i], "key"), i)
        self.assertIsNone(run_from_json('{"key": "key"}', "key"))

    def test_reports_have_medians_of_repeats(self):
        report = Report(methods=["drc-maps:gaussian+oidn", "path"], budgets=[tasks(16)])
        report.scenes = [Scene("room", "room.pbrt")]
        report.runs = [some_run(ssim=ssim) for ssim in (0.7, 0.9, 0.8)]
        told = json.loads(report_json(report))
        self.assertEqual(len(told["runs"]), 3)
        (summary,) = told["summary"]  # none of path, which has no runs
        self.assertEqual(summary["count"], 3)
        self.assertEqual(summary["ssim"], {"median": 0.8, "low": 0.7, "high": 0.9})
        self.assertIsNone(summary["render_seconds"]["median"])
        self.assertIsNone(summary["error_by_path_oidn"])
        report.methods.append("path+oidn:high")
        report.runs.append(some_run(method="path+oidn:high", error=0.02))
        self.assertEqual(json.loads(report_json(report))["summary"][0]["error_by_path_oidn"], 0.5)


class Tables(unittest.TestCase):
    def setUp(self):
        self.report = Report(methods=["drc", "path+oidn"], budgets=[seconds(10), spp(4)])
        self.report.scenes = [Scene("room", "room.pbrt", pair=["room-1.exr", "room-2.exr"])]

    def add(self, method, error, **values):
        run = Run("room", method, seconds(10), seconds=9.96, ssim=0.9, flip=0.05, peak_mb=210.4, spp=33)
        run.error, run.error_se, run.trimmed_error, run.trimmed_error_se = error, error / 100, error / 2, error / 200
        run.block_error, run.block_error_se, run.load_seconds, run.render_seconds = error / 4, error / 400, 0.5, 9
        run.denoise_seconds, run.write_seconds, run.mean_ratio = 0, 0.25, [1, 0.999, 1.01]
        for name, value in values.items():
            setattr(run, name, value)
        self.report.runs.append(run)

    def test_have_errors_their_ratio_and_what_was_spent(self):
        for error in (0.01, 0.03, 0.02):
            self.add("drc", error)
        self.add("path+oidn", 0.04, oidn_mode="balanced-raw")
        lines = markdown(self.report).splitlines()
        self.assertEqual(lines[0], "## 10 s")
        self.assertEqual(lines[2][:60], "| scene | method    | error             | trimmed           ")
        self.assertEqual(len({len(line) for line in lines[2:6]}), 1)
        cells = [cell.strip() for cell in lines[4].split("|")[1:-1]]
        self.assertEqual(
            cells[:6], ["room", "drc", "0.02000 ± 0.00020", "0.01000 ± 0.00010", "0.00500 ± 0.00005", "0.50"]
        )
        self.assertEqual(cells[6:11], ["0.9000", "0.0500", "1.000 0.999 1.010", "33", "0.5"])
        self.assertEqual(cells[11:], ["9.0", "0.0", "0.2", "10.0", "210"])
        self.assertIn("- room, path+oidn: Open Image Denoise in the mode balanced-raw", lines)

    def test_say_what_failed_and_what_is_noise(self):
        self.add("drc", 0.01, error_se=NOT_MEASURED, trimmed_error=NOT_MEASURED)
        self.add("path+oidn", 0.02, failure="a|b")
        self.report.scenes[0].pair = []
        text = markdown(self.report)
        self.assertIn("| 0.01000 | -       | 0.00250", text)
        self.assertIn("| room  | path+oidn | -", text)
        self.assertIn("\n- room, path+oidn: a|b\n- room: one reference only; its noise is in the errors", text)
        self.assertNotIn("~", text)
        self.report.scenes[0].flip_noise = 0.02
        noisy = markdown(self.report)
        self.assertIn("| 0.9000 | ~0.0500 |", noisy)
        self.assertIn("- ~: more than 25 %", noisy)


if __name__ == "__main__":
    unittest.main()
