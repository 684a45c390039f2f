#!/usr/bin/env python3
"""The page of `drc bench` in a browser: nothing is fetched, nothing fails, and the controls do what they say.

    tests/report_in_browser_test.py PAGE [--screenshots FOLDER]

PAGE has pictures of two methods or more. Chromium is driven through its DevTools protocol over two pipes. Without
Chromium, or without the page, which nobody makes where Python lacks a module, the test is skipped: it ends with status
77.
"""
import argparse
import json
import pathlib
import sys
import unittest

from browser import SKIPPED, Browser, find_browser

SHOWN = ("document.querySelector('.stage .left').naturalWidth > 0 && "
         "document.querySelector('.stage .right').naturalWidth > 0 && "
         "document.querySelector('.details .left dl').children.length > 0")
CUT = "getComputedStyle(document.querySelector('.stage .left')).clipPath"
ZOOM = "document.querySelector('.details .left .zoom').toDataURL()"
DIFFERENCE = "document.querySelector('.details .left .difference').toDataURL()"
LEFT = "document.querySelector('.stage .left').src"


class ReportInBrowser(unittest.TestCase):
    page = screenshots = program = browser = None

    @classmethod
    def setUpClass(cls):
        cls.browser = Browser(cls.program)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.call("Emulation.setScriptExecutionDisabled", value=False)
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        self.browser.resize(1400)
        self.browser.events.clear()
        self.browser.open(self.page)

    def show(self):
        self.browser.wait_for(SHOWN)

    def select(self, selector, value):
        """Chooses an option as a user does, and waits until the page shows it."""
        self.browser.run(f"""(() => {{ const s = document.querySelector({selector!r}); s.value = {value!r};
            s.dispatchEvent(new Event("change", {{ bubbles: true }})); }})()""")

    def stage(self):
        self.browser.run("document.querySelector('.stage').scrollIntoView({ block: 'center' })")
        box = self.browser.run("JSON.stringify(document.querySelector('.stage').getBoundingClientRect())")
        return json.loads(box)

    def test_nothing_is_fetched_and_nothing_fails(self):
        self.show()
        requested = [e["params"]["request"]["url"] for e in self.browser.events
                     if e.get("method") == "Network.requestWillBeSent"]
        self.assertIn(self.page, requested)
        self.assertEqual([u[:80] for u in requested if u != self.page and not u.startswith("data:")], [])
        failures = [e for e in self.browser.events
                    if e.get("method") == "Runtime.exceptionThrown"
                    or e.get("method") == "Runtime.consoleAPICalled" and e["params"]["type"] in ("error", "warning")
                    or e.get("method") == "Log.entryAdded" and e["params"]["entry"]["level"] in ("error", "warning")]
        self.assertEqual(failures, [])

    def test_scripts_leave_no_globals(self):
        self.show()
        own = self.browser.run("""(() => { const frame = document.createElement("iframe"); document.body.append(frame);
            const before = new Set(Object.getOwnPropertyNames(frame.contentWindow)); frame.remove();
            return Object.getOwnPropertyNames(window).filter(n => !before.has(n) && !/^[0-9]+$/.test(n)); })()""")
        self.assertEqual(own, [])

    def test_all_images_decode(self):
        self.show()
        sizes = self.browser.run("""Promise.all([...document.images].map(async image => {
            await image.decode(); return image.naturalWidth; }))""")
        self.assertGreater(len(sizes), 2)
        self.assertGreater(min(sizes), 0)

    def test_pointer_and_keys_move_the_wipe(self):
        self.show()
        box = self.stage()
        at = lambda share: (box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        cuts = [self.browser.run(CUT)]
        self.browser.mouse("mousePressed", *at(0.2), buttons=1)
        cuts.append(self.browser.run(CUT))
        self.assertAlmostEqual(float(self.browser.run("document.querySelector('.wipe').value")), 20, delta=1)
        self.browser.mouse("mouseMoved", *at(0.8), buttons=1)
        self.browser.mouse("mouseReleased", *at(0.8))
        cuts.append(self.browser.run(CUT))
        self.assertAlmostEqual(float(self.browser.run("document.querySelector('.wipe').value")), 80, delta=1)
        self.browser.run("document.querySelector('.wipe').focus()")
        self.browser.press("ArrowRight", 39)
        cuts.append(self.browser.run(CUT))
        self.assertEqual(len(set(cuts)), 4, cuts)

    def test_another_scene_is_another_picture(self):
        self.show()
        if self.browser.run("document.querySelector('.scene').length") == 1:
            self.skipTest("the page has one scene")
        before, difference = self.browser.run(LEFT), self.browser.run(DIFFERENCE)
        self.select(".scene", "1")
        self.browser.wait_for(f"({LEFT}) !== {before!r} && document.querySelector('.stage .left').complete")
        self.assertNotEqual(self.browser.run(DIFFERENCE), difference)
        self.assertEqual(self.browser.run("document.querySelector('.stage .left').alt.includes("
                                          "document.querySelector('.scene').selectedOptions[0].textContent)"), True)

    def test_magnified_part_follows_the_pointer(self):
        self.show()
        box = self.stage()
        zooms = set()
        for x, y in ((0.2, 0.2), (0.8, 0.2), (0.8, 0.8)):
            self.browser.mouse("mouseMoved", box["x"] + x * box["width"], box["y"] + y * box["height"])
            zooms.add(self.browser.run(ZOOM))
        self.assertEqual(len(zooms), 3)

    def test_another_method_is_another_picture(self):
        self.show()
        methods = self.browser.run("[...document.querySelectorAll('.choices .left .method option')]"
                                   ".filter(o => !o.disabled).map(o => o.value)")
        self.assertGreaterEqual(len(methods), 3)
        pictures = {self.browser.run(LEFT)}
        differences = {self.browser.run(DIFFERENCE)}
        for method in methods[1:]:
            before = self.browser.run(LEFT)
            self.select(".choices .left .method", method)
            self.browser.wait_for(f"({LEFT}) !== {before!r} && document.querySelector('.stage .left').complete")
            pictures.add(self.browser.run(LEFT))
            differences.add(self.browser.run(DIFFERENCE))
        self.assertEqual(len(pictures), len(methods))
        self.assertEqual(len(differences), len(methods))
        # The last method is the reference, which must not differ from itself.
        self.assertEqual(methods[-1], "reference")
        brightest = self.browser.run("""(() => { const c = document.querySelector(".details .left .difference");
            return c.getContext("2d").getImageData(0, 0, c.width, c.height).data
                .reduce((most, v, i) => i % 4 === 3 ? most : Math.max(most, v), 0); })()""")
        self.assertEqual(brightest, 0)

    def test_differences_are_those_that_the_figures_have(self):
        """The script's differences and the page's are of the same bytes."""
        self.show()
        apart = self.browser.run("""(async () => {
            const figure = document.querySelector(".strip figure[data-method='0']");
            const image = figure.querySelectorAll("img")[1];
            const shown = document.querySelector(".details .left .difference");
            await image.decode();
            const canvas = document.createElement("canvas");
            canvas.width = image.naturalWidth; canvas.height = image.naturalHeight;
            canvas.getContext("2d").drawImage(image, 0, 0);
            const values = c => c.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
            const a = values(canvas), b = values(shown);
            return a.reduce((most, v, i) => Math.max(most, Math.abs(v - b[i])), 0); })()""")
        self.assertEqual(apart, 0)

    def test_another_kind_of_difference(self):
        self.show()
        before = self.browser.run(DIFFERENCE)
        self.select(".kind", "sign")
        self.browser.wait_for(f"({DIFFERENCE}) !== {before!r}")

    def test_plain_pictures_without_scripts(self):
        self.browser.call("Emulation.setScriptExecutionDisabled", value=True)
        self.browser.open(self.page)
        # Scripts are enabled again for the test's own expressions, after the page has loaded without its scripts.
        self.browser.call("Emulation.setScriptExecutionDisabled", value=False)
        self.assertEqual(self.browser.run("document.querySelector('.viewer').checkVisibility()"), False)
        seen = self.browser.run("[...document.querySelectorAll('figure[data-method] img')]"
                                ".map(image => image.checkVisibility() ? image.getBoundingClientRect().width : 0)")
        self.assertGreater(len(seen), 2)
        self.assertGreater(min(seen), 50)

    def test_fits_narrow_and_wide_windows(self):
        for width in (400, 800, 1400):
            for scheme in ("light", "dark"):
                with self.subTest(width=width, scheme=scheme):
                    self.browser.call("Emulation.setEmulatedMedia",
                                      features=[{"name": "prefers-color-scheme", "value": scheme}])
                    self.browser.resize(width)
                    self.show()
                    self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), width)
                    ink, paper = (sum(map(int, self.browser.run(
                        f"getComputedStyle(document.body).{what}.match(/[0-9]+/g).slice(0, 3)")))
                        for what in ("color", "backgroundColor"))
                    self.assertEqual(ink < paper, scheme == "light")
                    if self.screenshots:
                        self.browser.screenshot(self.screenshots / f"report-{width}-{scheme}.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path, help="folder for screenshots of the page")
    args = parser.parse_args()
    program = find_browser()
    if program is None:
        print("skipped: there is no Chromium here")
        return SKIPPED
    if not args.page.exists():
        print(f"skipped: there is no {args.page}")
        return SKIPPED
    if args.screenshots:
        args.screenshots.mkdir(parents=True, exist_ok=True)
    ReportInBrowser.page = args.page.resolve(strict=True).as_uri()
    ReportInBrowser.screenshots = args.screenshots
    ReportInBrowser.program = program
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(ReportInBrowser)
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
