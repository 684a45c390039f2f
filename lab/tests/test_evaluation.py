"""The page of an evaluation, from the JSON of `drc evaluate`."""

import json
import math
import re
import unittest

from drc_lab.evaluation import MEASURES, description, read_evaluation
from drc_lab.evaluation_command import evaluate_page
from drc_lab.evaluation_page import evaluation_page
from drc_lab.evaluation_tables import across_table, score_table, test_table
from lab_testing import FolderTest, between, broken_nesting

PNG = b"\x89PNG\r\n\x1a\n"


def per_measure(value):
    told = {}
    for measure in MEASURES:
        told.setdefault(measure.group, {})[measure.key] = value(measure)
    return told


def summary(x):
    return {"mean": x, "median": x, "q1": x / 2, "q3": 2 * x, "p5": x / 4, "p95": 4 * x}


def comparison(first, second, **means):
    cell = {"first_better": 0.8, "wilcoxon": {"p": 0.0409}, "kruskal_wallis": {"h": 1, "p": 1e-300, "p_is_bound": True}}
    return {"first": first, "second": second, **per_measure(lambda _: {**means, **cell})}


def group(name, methods, samples=0):
    """methods: names with the median of every measure."""
    shown = [{"name": m, "picture": "p.png", "error": "p.png", "l1": 0.25, "ssim": None, "irradiance_relmse": 0.125}
             for m in methods]  # fmt: skip
    sample = {"scene": "<b>&\"two'", "viewpoint": 7, "pixel": [3.0, 4.0], "distance": "p.png", "normals": "p.png",
              "albedo": "p.png", "methods": shown, "reference": "p.png", "white": 1.25}  # fmt: skip
    names = list(methods)
    return {
        "name": name, "projection": name, "map_size": 32, "examples": 5,
        "files": [{"path": "one.examples", "scene": "<b>&\"two'", "examples": 5, "inputs": 1}],
        "methods": {m: per_measure(lambda _, x=x: summary(x)) for m, x in methods.items()},
        "all_methods": {"kruskal_wallis": per_measure(lambda _: {"h": 2, "p": 0.5})},
        "comparisons": [comparison(names[-1], names[0])],
        "samples": [sample] * samples,
    }  # fmt: skip


def evaluation(samples=0):
    networks = [{"name": n, "path": f"{n}.safetensors", "content": "c0ffee",
                 "metadata": {"commit": "abc<def", "seed": "1"}} for n in ("<i>&", "b")]  # fmt: skip
    return {
        "version": "9.8.7", "examples": 10, "files": 2, "skipped_files": 1, "networks": networks,
        "projections": [group("equal-area", {"none": 0.4, "gaussian": 0.3, "<i>&": 0.2}, samples),
                        group("latlong", {"none": 0.4, "gaussian": 0.3, "b": math.nan}, samples)],
        "across_projections": [{"first": "equal-area", "second": "latlong", "viewpoints": 3,
                                "comparisons": [comparison("<i>&", "b", first_mean=0.25, second_mean=0.5)]}],
        "samples": {"seed": 3, "error_scale": "p.png"},
    }  # fmt: skip


class Tables(unittest.TestCase):
    def test_the_best_of_each_block_is_bold(self):
        mean, median, quartiles = score_table(group("g", {"none": 0.4, "gaussian": 0.3}))
        self.assertEqual(
            [[cell.is_best for cell in row.cells[:2]] for row in mean.rows], [[False, True], [True, False]]
        )
        self.assertEqual((median.title, str(median.rows[0].cells[0].html)), ("Median", "0.4000"))
        self.assertEqual(quartiles.rows[0].cells[0].html, "0.2000 &#8211; 0.8000")

    def test_tests_have_their_p(self):
        everything, pair = test_table(group("g", {"none": 0.4, "gaussian": 0.3}))
        self.assertEqual(everything.rows[0].cells[0].html, "0.50")
        self.assertEqual(pair.title, "gaussian against none")
        texts = [str(row.cells[3].html) for row in pair.rows]
        self.assertEqual(texts, ["80.0 %", "0.041", "&lt;&#8201;10<sup>&#8722;300</sup>"])

    def test_means_across_projections_compare(self):
        (block,) = across_table(evaluation()["across_projections"][0])
        self.assertEqual([row.name for row in block.rows[:2]], ["mean, equal-area", "mean, latlong"])
        self.assertEqual([cell.is_best for cell in block.rows[0].cells[:2]], [True, False])  # L1, SSIM

    def test_descriptions_count(self):
        told = group("equal-area", {"none": 1})
        self.assertEqual(description(told), "equal-area maps of 32x32 texels, 5 examples of 1 file, one input each")
        told["files"] *= 2
        told["files"][0] = {**told["files"][0], "inputs": 4}
        self.assertIn("5 examples of 2 files, up to 4 inputs each", description(told))


class Page(FolderTest):
    def setUp(self):
        super().setUp()
        (self.folder / "p.png").write_bytes(PNG)

    def page(self, samples=0):
        return evaluation_page(evaluation(samples), self.folder)

    def test_is_one_well_formed_file_that_fetches_nothing(self):
        page = self.page(2)
        self.assertEqual(broken_nesting(page), "")
        for fetched in ("http:", "https:", "//www", "url(", "@import", "<link", "<script", "<iframe"):
            self.assertTrue(fetched not in page, fetched)
        # Distance, normals, albedo, three methods with their errors, the reference, the scale of the error.
        self.assertEqual(page.count("<img "), 2 * 2 * 11)
        self.assertEqual(page.count(" src="), page.count(' src="data:image/png;base64,iVBORw0K'))
        self.assertTrue(">nan" not in page, ">nan")

    def test_escapes_names_of_scenes_networks_and_metadata(self):
        page = self.page(1)
        for raw in ("<i>", "<b>&", "abc<def"):
            self.assertTrue(raw not in page, raw)
        for escaped in ("&lt;i&gt;&amp;", "&lt;b&gt;&amp;&#34;two&#39;", "abc&lt;def"):
            self.assertTrue(escaped in page, escaped)

    def test_shows_every_method_and_measure_of_every_projection(self):
        page = self.page()
        plots = re.findall(r"<svg .*?</svg>", page, re.DOTALL)
        self.assertEqual(len(plots), 12)
        # A box for each method in each plot but for the one that has no numbers.
        self.assertEqual([plot.count('class="tip"') for plot in plots], [3] * 6 + [2] * 6)
        self.assertEqual(page.count('<table class="measures">'), 5)  # scores, tests, and both projections
        for part in ("10 examples of 2 files (1 skipped), by drc 9.8.7", "&lt;i&gt;&amp; against none", "3 viewpoints",
                     "<h2>Latlong maps</h2>", "<h2>Equal-area against latlong</h2>", ">c0ffee<"):  # fmt: skip
            self.assertTrue(part in page, part)
        rest = between(page, "The rest of their metadata", "</details>")
        self.assertIn(">seed<", rest)
        self.assertNotIn(">commit<", rest)

    def test_shows_as_many_examples_as_there_are(self):
        self.assertNotIn("<img", self.page())
        page = self.page(3)
        self.assertEqual(page.count('class="example"'), 2 * 3)
        self.assertIn("viewpoint 7, pixel 3, 4", page)
        self.assertIn("<dt>L1</dt><dd>0.2500</dd><dt>SSIM</dt><dd>&#8211;</dd>", page)

    def test_a_picture_that_is_not_there_is_an_error_that_names_it(self):
        (self.folder / "p.png").unlink()
        self.assert_error(lambda: self.page(1), f"cannot read {self.folder}/p.png: No such file")


class Command(FolderTest):
    def test_writes_the_page(self):
        (self.folder / "p.png").write_bytes(PNG)
        told = evaluation(1)
        told["projections"].pop()  # JSON has no NaN
        report, page = self.write("report.json", json.dumps(told)), self.folder / "page.html"
        self.assertEqual(evaluate_page([report, "-o", str(page)]), 0)
        self.assertIn("Radiance maps, evaluated", page.read_text())

    def test_what_is_no_evaluation_is_an_error(self):
        page = ["-o", str(self.folder / "page.html")]
        self.assert_error(lambda: evaluate_page([self.write("a.json", "{")] + page), "a.json: not JSON")
        self.assert_error(lambda: evaluate_page([self.write("b.json", "{}")] + page), "b.json: not what drc evaluate")
        self.assert_error(lambda: read_evaluation(self.folder / "none.json"), "none.json")
        self.assert_error(lambda: evaluate_page(["b.json", "-o", str(self.folder / "no/page.html")]), "no folder")
        self.assertFalse((self.folder / "page.html").exists())


if __name__ == "__main__":
    unittest.main()
