"""The page of a comparison: its tables, plots and pictures."""

import io
import math
import re
import unittest

import numpy as np
import PIL.Image
from drc_lab.budget import SPP
from drc_lab.curves import error_curves, error_series, growth_of, memory_curves, memory_series
from drc_lab.equal_time import equal_time_tables
from drc_lab.errors import Error
from drc_lab.exr_file import write_exr
from drc_lab.measures import ERROR
from drc_lab.number_text import p_value, significant
from drc_lab.page import bench_page
from drc_lab.paper_table import paper_tables, ssim_after
from drc_lab.pictures import difference_png, page_pictures
from drc_lab.plots import Box, box_limits, box_plot, tick_text
from drc_lab.result import NOT_MEASURED
from lab_testing import (
    FolderTest, ReportBuilder, between, broken_nesting, picture_of, seconds, spp, tasks, the_program,
)  # fmt: skip

SECTIONS = ("equal-time", "pictures", "tasks-and-samples", "curves", "memory", "figures", "made")


class Numbers(unittest.TestCase):
    def test_three_digits_count(self):
        times = "&#8201;&#215;&#8201;10<sup>"
        for x, text in (
            (0, "0"), (0.00123456, "0.00123"), (0.5, "0.500"), (9.996, "10.0"), (-12.34, "-12.3"), (123.4, "123"),
            (12345, "12345"), (1.23456e-5, f"1.23{times}&#8722;5</sup>"), (2.5e7, f"2.50{times}7</sup>"),
            (math.inf, "&#8734;"), (math.nan, "&#8211;"),
        ):  # fmt: skip
            self.assertEqual(significant(x), text)

    def test_p_values_keep_two_digits(self):
        times = "&#8201;&#215;&#8201;10<sup>&#8722;"
        for p, text in (
            (1, "1.0"), (0.5, "0.50"), (0.0409, "0.041"), (1.33e-82, f"1.3{times}82</sup>"),
            (9.96e-5, f"1.0{times}4</sup>"), (0, "&lt;&#8201;10<sup>&#8722;300</sup>"), (math.nan, "&#8211;"),
        ):  # fmt: skip
            self.assertEqual(p_value(p), text)

    def test_ticks_are_short(self):
        for value, text in (
            (0, "0"),
            (0.001, "0.001"),
            (1000, "1000"),
            (1e-5, "10⁻⁵"),
            (2e-11, "2·10⁻¹¹"),
            (5e6, "5·10⁶"),
        ):
            self.assertEqual(tick_text(value), text)


def best_cells(report):
    return [(row.method, str(cell.html)) for table in equal_time_tables(report) for _, rows in table.blocks
            for row in rows for cell in row.cells if cell.is_best]  # fmt: skip


class EqualTime(unittest.TestCase):
    def setUp(self):
        self.b = ReportBuilder()

    def test_has_a_table_a_budget_and_a_block_a_scene(self):
        for amount in (30, 2):
            for scene in ("box", "hall"):
                self.b.add(scene, "drc", seconds(amount), 0.1)
        self.b.add("box", "drc-maps", tasks(4), 0.1)
        tables = equal_time_tables(self.b.report)
        self.assertEqual([table.budget.name for table in tables], ["2 s", "30 s"])
        self.assertEqual([scene for scene, _ in tables[0].blocks], ["box", "hall"])

    def test_best_of_a_scene(self):
        for method, error, ssim in (("a", 0.2, 0.9), ("b", 0.1, 0.8), ("c", 0.4, 0.9)):
            self.b.add("box", method, seconds(2), error, ssim)
        best = best_cells(self.b.report)
        self.assertEqual(sorted(best), [("a", "0.9000"), ("b", "0.0500"), ("b", "0.100"), ("c", "0.9000")])

    def test_the_best_is_better_by_more_than_its_error(self):
        for error, count in ((0.001, 1), (0.015, 0), (0.013, 1)):  # 0.015: 0.021 of both together
            b = ReportBuilder()
            for method, value in (("a", 0.10), ("b", 0.12)):
                b.add("box", method, seconds(2), value, 0.9, error_se=error)
            self.assertEqual(sum(text.startswith("0.100<small>") for _, text in best_cells(b.report)), count, error)

    def test_the_best_of_repeats_has_an_interval_of_its_own(self):
        for lowest, count in ((0.15, 1), (0.105, 0)):
            b = ReportBuilder()
            for method, values in (("a", (0.09, 0.10, 0.11)), ("b", (lowest, 0.20, 0.25))):
                for error in values:
                    b.add("box", method, seconds(2), error)
            self.assertEqual(sum(text.startswith("0.100<small>") for _, text in best_cells(b.report)), count, lowest)

    def test_one_method_is_not_the_best(self):
        self.b.add("box", "a", seconds(2), 0.2)
        self.b.add("box", "b", seconds(2), NOT_MEASURED, NOT_MEASURED)
        self.assertEqual(best_cells(self.b.report), [])

    def test_repeats_have_a_median_and_an_interval(self):
        for error in (0.3, 0.1, 0.2):
            self.b.add("box", "a", seconds(2), error, error_se=0.01)
        cell = equal_time_tables(self.b.report)[0].blocks[0][1][0].cells[0]
        self.assertEqual(cell.html, "0.200<small>&#177;&#8202;0.0100; 0.100&#8202;&#8211;&#8202;0.300</small>")

    def test_displayed_metrics_that_are_mostly_noise_are_marked(self):
        self.b.add("box", "a", seconds(2), 0.2, 0.9)
        self.b.add("box", "b", seconds(2), 0.2, 0.99)
        self.b.report.scenes[0].ssim_noise = 0.01
        cells = [str(row.cells[4].html) for row in equal_time_tables(self.b.report)[0].blocks[0][1]]
        self.assertEqual(cells, ["0.9000", "~0.9900"])
        self.assertNotIn(("b", "~0.9900"), best_cells(self.b.report))

    def test_failures_say_why(self):
        self.b.add("box", "a", seconds(2), 0.2)
        self.b.add_failure("box", "a", seconds(2), "no memory")
        self.b.add_failure("box", "b", seconds(2), "killed")
        rows = equal_time_tables(self.b.report)[0].blocks[0][1]
        self.assertEqual([row.failure for row in rows], ["1 of 2 failed: no memory", "killed"])
        self.assertEqual([bool(row.cells) for row in rows], [True, False])

    def test_geometric_means_are_relative_to_the_first_method(self):
        """Over the scenes that both have: ratios of 2 and 8 in two, none in the third."""
        for scene, base, other in (("box", 0.1, 0.2), ("hall", 0.01, 0.08), ("yard", 0.3, None)):
            self.b.add(scene, "base", seconds(2), base)
            if other:
                self.b.add(scene, "other", seconds(2), other)
        (table,) = equal_time_tables(self.b.report)
        self.assertEqual(table.base, "base")
        means = [(mean.method, str(mean.ratio), mean.scenes) for mean in table.means]
        self.assertEqual(means, [("base", "1.00", 3), ("other", "4.00", 2)])

    def test_the_opponent_is_what_others_are_measured_by(self):
        for method, error in (("drc", 0.1), ("path+oidn", 0.4), ("path+oidn:fast-raw", 0.2)):
            self.b.add("box", method, seconds(2), error)
        (table,) = equal_time_tables(self.b.report)
        self.assertEqual(table.base, "the best path+oidn")
        self.assertEqual([str(mean.ratio) for mean in table.means], ["0.500", "2.00", "1.00"])
        self.assertEqual([str(row.cells[1].html) for row in table.blocks[0][1]], ["0.50", "2.00", "1.00"])

    def test_no_means_without_the_first_method(self):
        self.b.add_failure("box", "base", seconds(2), "no")
        self.b.add("box", "other", seconds(2), 0.2)
        self.assertEqual(equal_time_tables(self.b.report)[0].means, [])


class PaperTables(unittest.TestCase):
    def setUp(self):
        self.b = ReportBuilder()
        for method, budget, time, ssim in (
            ("drc-maps", tasks(1), 2, 0.7), ("drc-maps", tasks(16), 10, 0.93), ("drc-maps", tasks(256), 90, 0.96),
            ("bdpt", spp(1), 1, 0.3), ("bdpt", spp(16), 20, 0.6), ("bdpt", spp(64), 80, 0.84),
        ):  # fmt: skip
            self.b.add("box", method, budget, 0.1, ssim, seconds=time, png_kb=40.5)

    def test_have_a_row_an_amount_and_all_methods_beside_each_other(self):
        self.b.add_failure("box", "drc-maps", tasks(4), "out & over")
        (table,) = paper_tables(self.b.report)
        self.assertEqual(
            [(column.method, column.unit) for column in table.columns], [("drc-maps", "tasks"), ("bdpt", "spp")]
        )
        rows = dict(table.rows)
        self.assertEqual(
            [cell for group in rows["16"] for cell in group.cells],
            ["10.00", "0.9300", "40.5", "20.00", "0.6000", "40.5"],
        )
        self.assertEqual(rows["256"][1].cells, ["", "", ""])  # was not run
        self.assertEqual(rows["4"][0].failure, "out & over")

    def test_stand_beside_the_paper(self):
        for budget, time in ((spp(1), 1), (spp(16), 9)):  # not as long as 16 tasks took
            self.b.add("box", "path", budget, 0.1, 0.5, seconds=time)
        (beside,) = paper_tables(self.b.report)[0].beside
        # After 10 s: 0.3 + 0.3 log(10) / log(20); after 40 s half way from 0.6 to 0.84.
        self.assertEqual(
            (beside.ours, beside.other, beside.ssim, beside.last, beside.last_budget, beside.same_time, beside.later),
            ("drc-maps", "bdpt", "0.93", "0.96", "at 256 tasks", "0.53", "0.72"),
        )

    def test_ssim_between_runs_is_linear_in_the_logarithm_of_time(self):
        after = lambda time: ssim_after(self.b.report, "box", "bdpt", SPP, time)  # noqa: E731
        for time, ssim in ((20, 0.6), (40, 0.72), (math.sqrt(20), 0.45)):
            self.assertAlmostEqual(after(time), ssim, 12)
        self.assertTrue(all(math.isnan(after(time)) for time in (0.9, 81, math.nan)))

    def test_scenes_without_tasks_or_samples_are_left_out(self):
        self.b.add("hall", "drc-maps", seconds(2), 0.1)
        self.assertEqual([table.scene for table in paper_tables(self.b.report)], ["box"])


class Curves(unittest.TestCase):
    def setUp(self):
        self.b = ReportBuilder()

    def test_points_are_error_against_seconds_of_the_process(self):
        for amount, error, ssim in ((1, 1, 0), (10, 0.1, 0.9), (100, 0.01, 0.99)):
            self.b.add("box", "drc", seconds(amount), error, ssim)
        (curves,) = error_curves(self.b.report)
        self.assertEqual(len(curves.plots), 3)
        self.assertIn("<title>drc, 10 s: error 0.1 in 10.00 s</title>", curves.plots[0])
        self.assertIn("<title>drc, 100 s: 1 − SSIM 0.01 in 100.00 s</title>", curves.plots[1])
        self.assertEqual(
            [(p.x, p.y) for p in error_series(self.b.report, "box", "error", ERROR)[0].points],
            [(1, 1), (10, 0.1), (100, 0.01)],
        )
        for plot in curves.plots:
            self.assertEqual(broken_nesting(plot), "")
            self.assertNotIn("nan", plot)

    def test_each_unit_has_a_line_and_a_mark(self):
        for n in (1, 4):
            self.b.add("box", "a", seconds(n), 1 / n)
            self.b.add("box", "a", tasks(n), 1 / n, seconds=n)
            self.b.add("box", "b", spp(n), 1 / n, seconds=n)
        series = error_series(self.b.report, "box", "error", ERROR)
        self.assertEqual(
            [(one.label, one.marker, len(one.points)) for one in series], [("a", "o", 2), ("a", "D", 2), ("b", "s", 2)]
        )
        self.assertEqual([name for name, _ in error_curves(self.b.report)[0].legend], ["a", "b"])

    def test_repeats_are_one_point_with_a_bar(self):
        for error in (0.1, 0.2, 0.4):
            self.b.add("box", "a", seconds(1), error)
        self.b.add("box", "a", seconds(5), 0.05)
        first, second = error_series(self.b.report, "box", "error", ERROR)[0].points
        self.assertEqual((first.y, first.low, first.high), (0.2, 0.1, 0.4))
        self.assertTrue(math.isnan(second.low))
        plot = error_curves(self.b.report)[0].plots[0]
        self.assertEqual((plot.count('class="tip"'), len(re.findall(r'id="plot\d+-bar-', plot))), (2, 1))

    def test_no_line_no_plot(self):
        self.b.add("box", "a", seconds(1), 0.1, NOT_MEASURED)
        self.b.add("box", "b", seconds(1), 0.2)
        self.assertEqual(error_curves(self.b.report), [])
        self.b.add("box", "a", seconds(2), 0.05, NOT_MEASURED)  # without SSIM the other two are left
        self.assertEqual(len(error_curves(self.b.report)[0].plots), 2)

    def test_memory_stands_over_tasks(self):
        for amount, megabytes in ((1, 200), (4, 210), (16, 250)):
            self.b.add("<box>", "drc-maps", tasks(amount), 0.1, peak_mb=megabytes)
        self.b.add("<box>", "path", seconds(2), 0.1)
        curves, ((scene, (growth,)),) = memory_curves(self.b.report)
        self.assertEqual((scene, growth.fewest, growth.change), ("<box>", ("200", "1 task"), "+25.0"))
        for tick in (1, 4, 16):
            self.assertRegex(curves.plots[0], rf">{tick}</text>")
        self.assertIn("&lt;box&gt;, peak MB", curves.plots[0])
        self.assertEqual([name for name, _ in curves.legend], ["drc-maps"])
        self.assertEqual(growth_of(memory_series(self.b.report, "<box>")[0]), growth)

    def test_no_memory_curve_of_one_number_of_tasks(self):
        self.b.add("box", "drc-maps", tasks(4), 0.1)
        self.b.add("box", "drc-maps", tasks(8), 0.1, peak_mb=NOT_MEASURED)
        self.assertIsNone(memory_curves(self.b.report))


def summary(scale):
    return {"mean": 3.5 * scale, "median": 3 * scale, "q1": 2 * scale, "q3": 4 * scale, "p5": scale, "p95": 7 * scale}


class BoxPlots(unittest.TestCase):
    def test_axes_are_around_all_values(self):
        boxes = [
            Box("a", 0, summary(0.1)),
            Box("b", 1, summary(0.13)),
            Box("none", 0, dict.fromkeys(summary(1), math.nan)),
        ]
        low, high, logarithmic = box_limits(boxes, False)
        self.assertEqual((low, logarithmic), (0, False))
        self.assertTrue(0.91 < high < 1)
        low, high, logarithmic = box_limits(boxes, True)
        self.assertTrue(logarithmic and 0.09 < low < 0.1 and high > 0.91)
        self.assertFalse(box_limits([Box("zero", 0, dict.fromkeys(summary(1), 0.0))], True)[2])
        self.assertEqual(box_limits([], True), (0, 1, False))

    def test_draw_a_box_a_row(self):
        boxes = [Box("a<b", 0, summary(0.1)), Box("a name of far more letters", 3, summary(0.05))]
        boxes.append(Box("none", 0, dict.fromkeys(summary(1), math.nan)))
        svg = box_plot("L1 & more", boxes, box_limits(boxes, False))
        self.assertEqual(broken_nesting(svg), "")
        self.assertEqual(svg.count('class="tip"'), 2)
        self.assertIn("a&lt;b: median 0.3, quartiles 0.2 and 0.4", svg)
        self.assertIn("L1 &amp; more", svg)
        self.assertIn(">a name of far mor…</text>", svg)
        self.assertIn("var(--c3)", svg)
        self.assertNotIn("#2f8456", svg)


class Pictures(FolderTest):
    def setUp(self):
        super().setUp()
        self.program, self.b = the_program(), ReportBuilder(self.folder)

    def pictures(self):
        return page_pictures(self.b.report, self.folder, self.program)

    def test_figures_are_of_the_largest_common_budget(self):
        for budget in (seconds(2), seconds(8), spp(64)):
            for method in ("drc", "path"):
                self.b.add("box", method, budget, 0.1)
        self.b.add("box", "drc", seconds(30), 0.1)
        (scene,) = self.pictures()
        self.assertEqual(scene.budget, "8 s")
        places = [(figure.method, figure.budget) for figure in scene.strip]
        self.assertEqual(places, [("reference", None), ("0", 1), ("1", 1)])
        self.assertEqual(len(scene.gallery), 5)
        uris = [figure.picture.uri for figure in scene.strip + scene.gallery]
        self.assertEqual(len(set(uris)), 8)  # each picture is there once

    def test_differences_are_four_times_as_large(self):
        def png(values):
            file = io.BytesIO()
            PIL.Image.fromarray(np.array(values, dtype=np.uint8)).save(file, "PNG")
            return file.getvalue()

        apart = difference_png(png([[[10, 20, 30], [0, 0, 0]]]), png([[[15, 20, 28], [255, 3, 64]]]))
        self.assertEqual(np.asarray(PIL.Image.open(io.BytesIO(apart))).tolist(), [[[20, 0, 8], [255, 12, 255]]])

    def test_the_first_repeat_is_shown(self):
        self.b.add_failure("box", "drc", seconds(2), "no")
        self.b.add("box", "drc", seconds(2), 0.125)
        self.b.add("box", "drc", seconds(2), 0.375)
        (scene,) = self.pictures()
        self.assertEqual(scene.strip, [])
        self.assertEqual([figure.method for figure in scene.gallery], ["reference", "0"])
        self.assertIn(("error", "0.125"), scene.gallery[1].facts)

    def test_scenes_without_pictures_need_no_reference(self):
        self.b.add_failure("box", "drc", seconds(2), "no")
        self.b.report.scenes[0].reference = "is-not-there.exr"
        self.assertEqual(self.pictures(), [])

    def test_errors_name_the_file(self):
        for method in ("drc", "path"):
            self.b.add("box", method, seconds(2), 0.1)
        write_exr(self.folder / "small.exr", picture_of(1, 5, 5), {})
        for name in ("small.exr", "gone.exr"):
            self.b.report.runs[1].picture = name
            self.assert_error(self.pictures, f"{name}: ")
        self.b.report.scenes[0].reference = "lost.exr"
        with self.assertRaisesRegex(Error, "lost.exr"):
            self.pictures()


class Page(FolderTest):
    def setUp(self):
        super().setUp()
        self.b = ReportBuilder(self.folder)
        self.program = the_program()

    def page(self):
        return bench_page(self.b.report, self.folder, self.program.path)

    def add_all(self, scene="box"):
        """Adds something for every section."""
        for method in ("drc-maps", "path & <i>", "bdpt"):
            for amount in (2, 8):
                self.b.add(scene, method, seconds(amount), 0.1 / amount)
        for amount in (1, 16, 64):
            self.b.add(scene, "drc-maps", tasks(amount), 0.1 / amount, seconds=amount)
            self.b.add(scene, "bdpt", spp(amount), 0.2 / amount, seconds=amount)

    def test_is_one_well_formed_file_that_fetches_nothing(self):
        self.add_all()
        page = self.page()
        self.assertEqual(broken_nesting(page), "")
        for fetched in ("http:", "https:", "//www", "url(", "@import", "<link", "<iframe", "<script src", "import("):
            self.assertTrue(fetched not in page, fetched)
        self.assertEqual(page.count(" src="), 13 + 3)  # 12 pictures and the reference; three differences
        self.assertEqual(page.count(" src="), page.count(' src="data:image/png;base64,iVBORw0K'))
        self.assertEqual(page.count(" href="), page.count(' href="#'))
        for nan in (">nan", "nan<", '"nan', " nan"):
            self.assertTrue(nan not in page, nan)
        ids = re.findall(r' id="([^"]*)"', page)
        self.assertEqual(len(ids), len(set(ids)))

    def test_has_every_section_in_order(self):
        self.add_all()
        page = self.page()
        self.assertEqual(tuple(re.findall(r'<section id="([^"]*)">', page)), SECTIONS)
        self.assertEqual(tuple(re.findall(r'href="#([a-z-]*)"', between(page, '"contents"', "</p>"))), SECTIONS)

    def test_escapes_names(self):
        hostile = '<b>"x"</b>'
        self.add_all(hostile)
        self.b.add_failure(hostile, "it's </td>", seconds(2), '<script>no()</script> & "so"')
        self.b.report.processor, self.b.report.version = "<u>chip</u>", "1 & 2"
        self.b.report.scenes[0].file, self.b.report.scenes[0].reference_origin = "a<b>.pbrt", "<em>given</em>"
        page = self.page()
        self.assertEqual(broken_nesting(page), "")
        for raw in ('<b>"x', "& <i>", "</td>s", "<script>no", "<u>", "a<b>", "<em>", "1 & 2"):
            self.assertTrue(raw not in page, raw)
        for escaped in ("path &amp; &lt;i&gt;", "&lt;script&gt;no()&lt;/script&gt; &amp; ", "&lt;u&gt;chip",
                        "1 &amp; 2", "a&lt;b&gt;.pbrt", "&lt;em&gt;given"):  # fmt: skip
            self.assertTrue(escaped in page, escaped)
        self.assertEqual(page.count("<script>"), 1)

    def test_leaves_out_sections_without_data(self):
        self.b.add("box", "drc-maps", seconds(2), 0.1)
        page = self.page()
        self.assertEqual(re.findall(r'<section id="([^"]*)">', page), ["equal-time", "pictures", "made"])
        self.assertTrue("#figures" not in page, "#figures")

    def test_all_failed_has_no_pictures_and_no_script(self):
        self.b.add_failure("box", "drc-maps", seconds(2), "out of memory")
        page = self.page()
        self.assertIn("out of memory", page)
        self.assertIn("of which 1 failed", page)
        self.assertTrue("<script" not in page, "<script")
        self.assertTrue("<img" not in page, "<img")

    def test_nothing_at_all_is_a_page_too(self):
        self.assertEqual(re.findall(r'<section id="([^"]*)">', self.page()), ["made"])

    def test_says_how_it_was_made(self):
        self.add_all()
        self.b.add("box", "drc-maps", seconds(2), 0.3)
        self.b.report.scenes[0].reference_origin = "path tracing, 60 s"
        page = self.page()
        made = between(page, '<section id="made"', "</section>")
        for part in (">drc 9.8.7<", ">some processor<", ">3<", ">2, 8 s; 1, 16, 64 spp; 1, 16, 64 tasks<", ">1 to 2<",
                     ">one, path tracing, 60 s<", "<code>scene.pbrt</code>", ">16&#8201;&#215;&#8201;12<"):  # fmt: skip
            self.assertIn(part, made)
        self.assertIn(
            "1&#160;scene, 3&#160;methods, 13&#160;runs. By drc 9.8.7 on some processor, 3&#160;threads.", page
        )

    def test_the_viewer_offers_all_scenes_methods_and_budgets(self):
        """The script asks for what the page has, by the names that it has."""
        self.add_all()
        self.b.add("hall", "drc-maps", seconds(2), 0.1)
        page = self.page()
        choices = between(page, '<div class="viewer"', '<div class="details"')
        self.assertIn('<option value="1">hall</option>', choices)
        for option in ('"1">path &amp; &lt;i&gt;', '"reference">reference', '"1">8 s'):
            self.assertEqual(choices.count(f"<option value={option}</option>"), 2, option)
        self.assertIn('data-scene="0" data-method="1" data-budget="1"', page)
        self.assertIn('<div class="viewer" hidden="hidden">', page)
        self.assertIn('<details class="all" open="open">', page)


if __name__ == "__main__":
    unittest.main()
