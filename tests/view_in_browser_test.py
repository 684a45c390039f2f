#!/usr/bin/env python3
"""`drc view` in a browser and under fire: it loads, refines, follows its camera, and survives bad requests.

    tests/view_in_browser_test.py DRC [--screenshots FOLDER]

Without Chromium the tests of the page are skipped; those of the server alone are not.
"""
import argparse
import base64
import http.client
import json
import math
import pathlib
import random
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request

from browser import PATIENCE, Browser, find_browser
from live_view import SCENE, SIZE, View

def status_of(call):
    try:
        call()
        return 200
    except urllib.error.HTTPError as error:
        return error.code


class ViewServer(unittest.TestCase):
    drc = None

    @classmethod
    def setUpClass(cls):
        cls.view = View(cls.drc)
        cls.view.wait_for(lambda s: s.get("samples", 0) > 0)

    @classmethod
    def tearDownClass(cls):
        cls.view.close()

    def test_layers(self):
        # The variance needs samples in both halves of a pixel.
        layers = self.view.wait_for(lambda s: s["samples"] > 3)["layers"]
        for name in ("beauty", "unfiltered", "albedo", "normal", "depth", "variance", "samples"):
            self.assertIn(name, layers)
            width, height, channels, number, values = self.view.frame(name)
            self.assertEqual((width, height), SIZE)
            self.assertEqual(channels, 1 if name in ("depth", "samples") else 3)
            self.assertTrue(all(v == v for v in values), name)
            self.assertGreater(sum(abs(v) for v in values), 0, name)

    def test_pixels(self):
        self.view.pause()
        try:
            width, _, _, _, values = self.view.frame()
            answer = json.loads(self.view.get("pixel?x=37&y=21"))
            pixel = answer["layers"]["beauty"]
            self.assertEqual([answer["samples"]], answer["layers"]["samples"])
            self.assertEqual(answer["surface"]["shapeKind"], "plymesh")
            self.assertEqual(json.loads(self.view.get("surface?x=37&y=21"))["surface"], answer["surface"])
            for c in range(3):
                self.assertAlmostEqual(pixel[c], values[3 * (21 * width + 37) + c], delta=1e-3 * (abs(pixel[c]) + 1))
            self.assertEqual(status_of(lambda: self.view.get("pixel?x=320&y=0")), 400)
            self.assertEqual(status_of(lambda: self.view.get("pixel?x=-1&y=0")), 400)
            self.assertEqual(status_of(lambda: self.view.get("pixel?x=1e2&y=0")), 400)
        finally:
            self.view.post("pause", False)

    def test_pause(self):
        paused_at, number = self.view.pause()
        self.assertLessEqual(number, paused_at + 2)
        self.view.post("pause", False)
        self.view.wait_for(lambda s: s["number"] > number and not s["paused"])

    def test_camera(self):
        home = self.view.state()["home"]
        before = self.view.state()["view"]
        before_picture = self.view.frame()[4]
        eye = [e + 0.3 * (l - e) for e, l in zip(home["eye"], home["look"])]
        answer = json.loads(self.view.post("camera", {**home, "eye": eye}))
        for a, b in zip(answer["eye"], eye):
            self.assertAlmostEqual(a, b, places=4)
        self.assertIn("LookAt", answer["pbrt"])
        self.view.wait_for(lambda s: s["view"] > before and s["samples"] > 0)
        moved = self.view.frame()[4]
        difference = sum(abs(a - b) for a, b in zip(moved, before_picture)) / len(moved)
        self.assertGreater(difference, 0.01)
        # And back: the same picture, but for noise.
        view = self.view.state()["view"]
        self.view.post("camera", home)
        self.view.wait_for(lambda s: s["view"] > view and s["samples"] > 2)
        again = self.view.frame()[4]
        self.assertLess(sum(abs(a - b) for a, b in zip(again, before_picture)) / len(again), difference / 4)

    def test_camera_of_another_size(self):
        home, before = self.view.state()["home"], self.view.state()["view"]
        self.view.post("camera", {**home, "width": 160, "height": 90, "moving": True})
        self.view.wait_for(lambda s: s["view"] > before)
        self.assertEqual(self.view.frame()[:2], (160, 90))
        before = self.view.state()["view"]
        self.view.post("camera", home)
        self.view.wait_for(lambda s: s["view"] > before)
        self.assertEqual(self.view.frame()[:2], SIZE)

    def test_cameras_that_look_nowhere(self):
        home = self.view.state()["home"]
        for wrong in ({}, [], "x", {**home, "eye": home["look"]}, {**home, "up": [0, 0, 0]}, {**home, "eye": [1, 2]},
                      {**home, "eye": [1e30, 0, 0]}, {**home, "eye": ["a", 0, 0]}, {**home, "width": 1},
                      {**home, "width": 100000}, {**home, "height": 1.5},
                      {**home, "up": [l - e for e, l in zip(home["eye"], home["look"])]}):
            self.assertEqual(status_of(lambda: self.view.post("camera", wrong)), 400, wrong)
        self.assertEqual(status_of(lambda: self.view.post("camera", b"{\"eye\": [NaN, 0, 0]")), 400)

    def test_what_is_not_allowed(self):
        port = self.view.port
        def status(method, path, headers=None, body=None):
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=PATIENCE)
            connection.request(method, path, body, headers or {})
            code = connection.getresponse().status
            connection.close()
            return code
        good = self.view.path + "state"
        self.assertEqual(status("GET", good), 200)
        self.assertEqual(status("GET", good, {"Host": "evil.example"}), 403)
        self.assertEqual(status("GET", good, {"Host": f"evil.example:{port}"}), 403)
        self.assertEqual(status("GET", good, {"Host": f"localhost:{port}"}), 200)
        self.assertEqual(status("POST", self.view.path + "pause", {"Origin": "http://evil.example"}, "true"), 403)
        self.assertEqual(status("POST", self.view.path + "pause", {"Origin": f"http://127.0.0.1:{port}"}, "false"), 200)
        self.assertEqual(status("GET", "/state"), 403)
        self.assertEqual(status("GET", "/" + "0" * 32 + "/state"), 403)
        self.assertEqual(status("GET", self.view.path[:-1]), 403)
        self.assertEqual(status("DELETE", good), 405)
        self.assertEqual(status("GET", self.view.path + "pause"), 405)
        self.assertEqual(status("POST", good, None, "x"), 404)
        self.assertEqual(status("GET", self.view.path + "nothing"), 404)
        for path in ("../../etc/passwd", "%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "frame?layer=/etc/passwd"):
            self.assertIn(status("GET", self.view.path + path), (403, 404), path)
        self.assertEqual(status("GET", self.view.path + "frame?layer=%zz"), 400)
        self.assertEqual(status("GET", self.view.path + "frame?layer=%00"), 400)
        self.assertEqual(status("GET", self.view.path + "a" * 5000), 400)
        self.assertEqual(status("POST", self.view.path + "compare", None, b"not a picture"), 400)

    def test_tokens_that_are_none(self):
        for token in ("short", "fifteen-letters", "a" * 129, "0123456789abcdef/", "0123456789 abcdef", "0123456789abcdéf", "../../etc/passwd0"):
            result = subprocess.run([self.drc, "view", SCENE, "--token", token], capture_output=True, text=True, timeout=PATIENCE)
            self.assertNotEqual(result.returncode, 0, token)
            self.assertIn("--token: must be 16 to 128 letters, digits, - and _", result.stderr + result.stdout)

    def test_the_page_may_not_load_anything(self):
        with urllib.request.urlopen(self.view.url) as response:
            self.assertIn("default-src 'none'", response.headers["Content-Security-Policy"])
            self.assertEqual(response.headers["X-Content-Type-Options"], "nosniff")
            text = response.read().decode()
        self.assertNotIn("http://", text.replace("http://www.w3.org", ""))
        self.assertNotIn("https://", text)

    def test_saves_what_it_shows(self):
        data = self.view.get("save.exr")
        self.assertEqual(data[:4], b"\x76\x2f\x31\x01")
        self.assertIn(b"Denoising Albedo", data)
        size = json.loads(self.view.post("compare", data))
        self.assertEqual((size["width"], size["height"]), SIZE)
        self.assertEqual(self.view.frame("reference")[:3], (*SIZE, 3))

    def test_malformed_requests(self):
        generator = random.Random(1)
        good = f"GET {self.view.path}state HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n\r\n".encode()
        refused = 0
        for i in range(1000):
            data = bytearray(good)
            for _ in range(generator.randrange(1, 6)):
                kind = generator.randrange(4)
                at = generator.randrange(len(data))
                if kind == 0:
                    data[at] = generator.randrange(256)
                elif kind == 1:
                    del data[at:at + generator.randrange(1, 20)]
                elif kind == 2:
                    data[at:at] = bytes(generator.randrange(256) for _ in range(generator.randrange(1, 40)))
                else:
                    data[at:at] = generator.choice([b"Content-Length: 99999999999\r\n", b"\r\n\r\n", b"%", b"\0",
                                                    b"Transfer-Encoding: chunked\r\n", b"A" * 3000, b"HTTP/9.9"])
                if not data:
                    data = bytearray(b"x")
            with socket.create_connection(("127.0.0.1", self.view.port), PATIENCE) as s:
                try:
                    s.sendall(bytes(data))
                    s.shutdown(socket.SHUT_WR)
                    answer = s.recv(64)
                except OSError:  # it has been closed already
                    answer = b""
            refused += answer[:12] != b"HTTP/1.1 200"
        self.assertGreater(refused, 500)
        self.assertIn("number", self.view.state())

    def test_too_large(self):
        head = f"POST {self.view.path}compare HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n".encode()
        answer = self.view.raw(head + b"Content-Length: 10000000000\r\n\r\n")
        self.assertTrue(answer.startswith(b"HTTP/1.1 413"), answer[:40])
        answer = self.view.raw(b"GET / HTTP/1.1\r\nX: " + b"a" * 100000 + b"\r\n\r\n")
        self.assertTrue(answer == b"" or answer.startswith(b"HTTP/1.1 4"), answer[:40])

    def test_many_fast_requests(self):
        def ask():
            connection = http.client.HTTPConnection("127.0.0.1", self.view.port, timeout=PATIENCE)
            for _ in range(2500):
                connection.request("GET", self.view.path + "state")
                response = connection.getresponse()
                response.read()
                if response.status != 200:
                    wrong.append(response.status)
            connection.close()
        wrong = []
        threads = [threading.Thread(target=ask) for _ in range(4)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(wrong, [])

    def test_idle_connections(self):
        idle = [socket.create_connection(("127.0.0.1", self.view.port), PATIENCE) for _ in range(100)]
        try:
            self.assertIn("number", self.view.state())
            more = [socket.create_connection(("127.0.0.1", self.view.port), PATIENCE) for _ in range(60)]
            self.assertIn("number", self.view.state())
            for s in more:
                s.close()
        finally:
            for s in idle:
                s.close()
        self.assertIn("number", self.view.state())

    def test_events_by_many(self):
        # Clients that never read, beside one that does.
        deaf = []
        for _ in range(5):
            s = socket.create_connection(("127.0.0.1", self.view.port), PATIENCE)
            s.sendall(f"GET {self.view.path}events HTTP/1.1\r\nHost: 127.0.0.1:{self.view.port}\r\n\r\n".encode())
            deaf.append(s)
        with urllib.request.urlopen(self.view.url + "events", timeout=PATIENCE) as stream:
            self.view.post("camera", self.view.state()["home"])
            numbers = []
            while len(numbers) < 3:
                line = stream.readline()
                if line.startswith(b"data: "):
                    event = json.loads(line[6:])
                    if "number" in event:
                        numbers.append(event["number"])
        self.assertEqual(numbers, sorted(numbers))
        for s in deaf:
            s.close()


class ViewInBrowser(unittest.TestCase):
    drc = screenshots = program = None

    @classmethod
    def setUpClass(cls):
        if cls.program is None:
            raise unittest.SkipTest("there is no Chromium here")
        cls.view = View(cls.drc)
        cls.browser = Browser(cls.program)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.view.close()

    def setUp(self):
        self.browser.resize(1280, 800)
        # What the page of an earlier test says when its server is gone is no failure of this one.
        self.browser.open("about:blank")
        self.browser.events.clear()
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0")

    def tearDown(self):
        failures = [e for e in self.browser.events
                    if e.get("method") == "Runtime.exceptionThrown"
                    or e.get("method") == "Runtime.consoleAPICalled" and e["params"]["type"] == "error"
                    or e.get("method") == "Log.entryAdded" and e["params"]["entry"]["level"] == "error"]
        self.assertEqual(failures, [])

    def mean(self):
        """The mean of what is on the screen."""
        return self.browser.run("""(() => { const c = document.getElementById("screen");
            const d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            let s = 0; for (let i = 0; i < d.length; i += 4) s += d[i] + d[i + 1] + d[i + 2];
            return s / (d.length / 4) / 3; })()""")

    def change(self, element, value):
        self.browser.run(f"""(() => {{ const e = document.getElementById({element!r}); e.value = {value!r};
            for (const type of ["input", "change"]) e.dispatchEvent(new Event(type, {{ bubbles: true }})); }})()""")

    def settle(self):
        self.browser.run("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(r, 50))))")

    def test_refines(self):
        first = self.browser.run("Number(document.body.dataset.drawn)")
        self.browser.wait_for(f"document.body.dataset.drawn > {first + 2}")
        self.assertIn("spp", self.browser.run("document.getElementById('status').textContent"))
        self.assertGreater(self.mean(), 10)
        if self.screenshots:
            time.sleep(3)
            self.browser.screenshot(self.screenshots / "view.png", whole=False)

    def test_exposure_and_views(self):
        dark = self.mean()
        self.change("exposure", "2")
        self.settle()
        self.assertGreater(self.mean(), 1.2 * dark)
        self.change("view", "agx")
        self.settle()
        self.assertNotEqual(self.mean(), dark)
        self.browser.run("document.getElementById('auto').click()")
        self.browser.wait_for("document.getElementById('stops').textContent !== '2.0 stops'")

    def test_begins_as_the_command_line_says(self):
        view = View(self.drc, "--exposure", "1.5", "--view", "agx", "--lookat", *"0 1 -3 0 1 0 0 1 0".split(), "--fov",
                    "60", "--seed", "5", "--max-depth", "2", "--denoise", "off")
        try:
            self.assertEqual(view.state()["home"]["eye"], [0, 1, -3])
            self.browser.open(view.url)
            self.browser.wait_for("document.body.dataset.drawn > 0")
            self.browser.wait_for("document.getElementById('stops').textContent === '1.5 stops'")
            self.assertEqual(self.browser.run("document.getElementById('view').value"), "agx")
        finally:
            view.close()
            self.browser.events.clear()

    def test_views_are_those_of_png_files(self):
        """The page and `drc render --view` have the same formulas: the same bytes, up to rounding."""
        self.view.pause()
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0")
        with tempfile.TemporaryDirectory() as folder:
            exr = pathlib.Path(folder, "frame.exr")
            exr.write_bytes(self.view.get("save.exr"))
            for view in ("srgb", "filmic", "agx"):
                png = pathlib.Path(folder, view + ".png")
                subprocess.run([self.drc, "image", "convert", exr, "-o", png, "--view", view, "--exposure", "-1"],
                               check=True, stdout=subprocess.DEVNULL)
                self.change("exposure", "-1")
                self.change("view", view)
                self.settle()
                data = base64.b64encode(png.read_bytes()).decode()
                worst, mean = self.browser.run(f"""(async () => {{
                    const image = new Image();
                    image.src = "data:image/png;base64,{data}";
                    await image.decode();
                    const canvas = document.createElement("canvas");
                    canvas.width = image.width; canvas.height = image.height;
                    const pen = canvas.getContext("2d");
                    pen.drawImage(image, 0, 0);
                    const theirs = pen.getImageData(0, 0, image.width, image.height).data;
                    const ours = current.canvas.getContext("2d").getImageData(0, 0, image.width, image.height).data;
                    let worst = 0, sum = 0;
                    for (let i = 0; i < ours.length; ++i) {{
                        worst = Math.max(worst, Math.abs(ours[i] - theirs[i])); sum += theirs[i];
                    }}
                    return [worst, sum / ours.length];
                }})()""")
                self.assertLessEqual(worst, 1, view)
                self.assertGreater(mean, 64, view)
        self.change("exposure", "0")
        self.change("view", "srgb")
        self.view.post("pause", False)

    def test_layers(self):
        for name in ("normal", "albedo", "depth", "variance", "samples", "unfiltered"):
            self.change("layer", name)
            self.browser.wait_for(f"layer === {name!r} && current.channels === {1 if name in ('depth', 'samples') else 3}")
            self.settle()
            self.assertGreater(self.mean(), 1, name)

    def test_orbit_and_reset(self):
        state = self.view.wait_for(lambda s: s["samples"] > 0)
        view, eye, home = state["view"], state["camera"]["eye"], state["home"]
        x, y = self.browser.run("(() => { const p = placed(), b = screen.getBoundingClientRect();"
                                "return [(400 - b.left - p.x) / p.width, (400 - b.top - p.y) / p.height]; })()")
        point = json.loads(self.view.get(f"point?x={x:.5f}&y={y:.5f}"))["point"]
        self.browser.mouse("mousePressed", 400, 400, 1)
        for i in range(8):
            self.browser.mouse("mouseMoved", 400 + 10 * i, 400, 1)
        self.browser.mouse("mouseReleased", 480, 400)
        self.view.wait_for(lambda s: s["view"] > view and s["samples"] > 0)
        moved = self.view.state()["camera"]
        self.assertGreater(sum(abs(a - b) for a, b in zip(moved["eye"], eye)), 0.05)
        # Around the point that was under the pointer.
        self.assertAlmostEqual(math.dist(moved["eye"], point), math.dist(eye, point), delta=0.01 * math.dist(eye, point))
        self.browser.run("document.getElementById('home').click()")
        self.view.wait_for(lambda s: s["camera"]["eye"] == home["eye"] and s["samples"] > 0)
        self.assertEqual(tuple(self.view.state()["film"]), SIZE)

    def test_flies(self):
        eye = self.view.state()["camera"]["eye"]
        self.browser.run("document.getElementById('screen').focus()")
        self.browser.call("Input.dispatchKeyEvent", type="keyDown", key="w", code="KeyW")
        time.sleep(0.4)
        self.browser.call("Input.dispatchKeyEvent", type="keyUp", key="w", code="KeyW")
        self.view.wait_for(lambda s: sum(abs(a - b) for a, b in zip(s["camera"]["eye"], eye)) > 0.01)
        self.browser.run("document.getElementById('home').click()")

    def test_pause(self):
        self.browser.run("document.getElementById('pause').click()")
        self.view.wait_for(lambda s: s["paused"])
        self.browser.wait_for("document.getElementById('pause').textContent === 'Continue'")
        self.browser.run("document.getElementById('pause').click()")
        self.view.wait_for(lambda s: not s["paused"])

    def test_inspect(self):
        self.browser.run("document.getElementById('mode').click()")
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=400, y=400, deltaX=0, deltaY=-2000)
        self.browser.wait_for("zoom > 4")
        self.browser.mouse("mouseMoved", 410, 400)
        self.assertRegex(self.browser.run("document.getElementById('pixel').textContent"), r"\d+, \d+ +beauty +[\d.e-]+")
        self.browser.mouse("mousePressed", 410, 400, 1)
        self.browser.mouse("mouseReleased", 410, 400)
        self.browser.wait_for("/ normal -?[0-9.e-]+ /.test(document.getElementById('pixel').textContent)")
        self.assertEqual(self.view.state()["camera"]["eye"], self.view.state()["home"]["eye"])

    def footer(self):
        return self.browser.run("document.getElementById('pixel').textContent")

    def test_names_what_is_under_the_pointer(self):
        """In both modes, and one request at a time, however fast the pointer moves."""
        self.browser.wait_for("state.samples > 0")
        surface = r"\d+ samples? +\S+ \(\w+\), plymesh geometry/\S+\.ply,.* away, \S*scene\.pbrt:\d+"
        for mode in ("false", "true"):
            self.browser.run(f"setInspect({mode})")
            self.browser.mouse("mouseMoved", 300, 300)
            self.browser.wait_for("surface.textContent.includes('plymesh')")
            self.assertRegex(self.footer(), surface)
        self.browser.events.clear()
        start = time.monotonic()
        for i in range(200):
            self.browser.mouse("mouseMoved", 300 + i, 300 + i % 7)
        took = time.monotonic() - start
        self.browser.wait_for("!asking")
        asked = [e["params"] for e in self.browser.events if e.get("method") == "Network.requestWillBeSent"]
        names = [p["request"]["url"].split("/")[-1] for p in asked]
        names = [n for n in names if n.startswith("surface?")]
        self.assertTrue(names)
        self.assertLess(len(names), took / 0.05 + 3)
        # The last answer is of where the pointer is.
        x, y = self.browser.run("pixelAt({ clientX: 499, clientY: 303 })")
        self.assertEqual(names[-1], f"surface?x={x}&y={y}")
        # A click in the mode that inspects tells all, and the surface.
        self.browser.mouse("mousePressed", 499, 303, 1)
        self.browser.mouse("mouseReleased", 499, 303)
        self.browser.wait_for("/ normal .* plymesh /.test(document.getElementById('pixel').textContent)")

    def test_samples_a_part(self):
        """Drawn with shift held, or by a finger in the mode for it; known to the server, and so to every page."""
        self.browser.wait_for("state.samples > 0")
        eye = self.view.state()["camera"]["eye"]
        at = self.browser.run("(() => { const p = placed(), b = screen.getBoundingClientRect();"
                              "return [p.x + b.left, p.y + b.top, p.scale]; })()")
        def on_screen(x, y):
            return at[0] + x * at[2], at[1] + y * at[2]
        def drag(modifiers=0):
            for kind, x, y in (("mousePressed", 80, 40), ("mouseMoved", 120, 60), ("mouseMoved", 160, 90),
                               ("mouseReleased", 160, 90)):
                px, py = on_screen(x, y)
                self.browser.call("Input.dispatchMouseEvent", type=kind, x=px, y=py, button="left", clickCount=1,
                                  buttons=0 if kind == "mouseReleased" else 1, modifiers=modifiers)
        drag(modifiers=8)
        state = self.view.wait_for(lambda s: s["focus"] is not None and s["focusSamples"] > 8)
        for got, wanted in zip(state["focus"], (80, 40, 160, 90)):
            self.assertLessEqual(abs(got - wanted), 1)
        x0, y0, x1, y1 = state["focus"]
        width, height, _, _, counts = self.view.frame("samples")
        inside = [counts[y * width + x] for y in range(y0, y1) for x in range(x0, x1)]
        outside = [counts[y * width + x] for y in range(height) for x in range(width)
                   if not (x0 <= x < x1 and y0 <= y < y1)]
        self.assertGreater(sum(inside) / len(inside), sum(outside) / len(outside) + 8)
        # The rectangle is seen, also by a page that comes later.
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0 && state.focus !== null")
        self.settle()
        x, y = on_screen(80, 60)
        shown = self.browser.run(f"""(() => {{ const b = screen.getBoundingClientRect();
            const d = pen.getImageData({x} - b.left - 3, {y} - b.top, 6, 1).data, c = [0xe0, 0xa4, 0x58];
            let best = 999; for (let i = 0; i < d.length; i += 4)
                best = Math.min(best, Math.abs(d[i] - c[0]) + Math.abs(d[i + 1] - c[1]) + Math.abs(d[i + 2] - c[2]));
            return best; }})()""")
        self.assertLess(shown, 150)
        self.assertIn("in the part", self.browser.run("document.getElementById('status').textContent"))
        if self.screenshots:
            self.browser.screenshot(self.screenshots / "view-part.png", whole=False)
        self.browser.run("document.getElementById('screen').focus()")
        self.browser.press("Escape", 27)
        self.view.wait_for(lambda s: s["focus"] is None)
        # By touch, in the mode.
        self.browser.run("document.getElementById('part').click()")
        for kind, points in (("touchStart", [(20, 20)]), ("touchMove", [(60, 50)]), ("touchMove", [(100, 80)]), ("touchEnd", [])):
            self.browser.call("Input.dispatchTouchEvent", type=kind,
                              touchPoints=[dict(zip("xy", on_screen(*p))) for p in points])
        state = self.view.wait_for(lambda s: s["focus"] is not None)
        for got, wanted in zip(state["focus"], (20, 20, 100, 80)):
            self.assertLessEqual(abs(got - wanted), 1)
        self.assertFalse(self.browser.run("boxing"))
        self.assertEqual(self.view.state()["camera"]["eye"], eye)
        # A camera that moves ends it.
        self.browser.run("document.getElementById('home').click()")
        self.view.wait_for(lambda s: s["focus"] is None and s["samples"] > 0)

    def test_compares(self):
        self.browser.run("""(async () => {
            const data = await (await fetch("save.exr")).blob(), transfer = new DataTransfer();
            transfer.items.add(new File([data], "before.exr"));
            const input = document.getElementById("file");
            input.files = transfer.files;
            input.dispatchEvent(new Event("change")); })()""")
        self.browser.wait_for("reference !== null && !document.getElementById('split').disabled")
        self.change("split", "0.25")
        self.settle()
        self.assertGreater(self.mean(), 10)

    def test_two_viewers_and_reload(self):
        with urllib.request.urlopen(self.view.url + "events", timeout=PATIENCE) as stream:
            self.browser.open(self.view.url)
            self.browser.wait_for("document.body.dataset.drawn > 0")
            self.view.post("camera", self.view.state()["home"])
            self.assertTrue(stream.readline())

    def test_light_and_dark(self):
        """As the system is set; whatever is written can be read."""
        script = """(() => {
            const parse = c => c.match(/[\\d.]+/g).map(Number), linear = v => v <= 0.04045 * 255 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4;
            const light = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
            const behind = e => { for (; e; e = e.parentElement) { const c = parse(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0) return c; } };
            const ratios = {};
            for (const e of document.querySelectorAll("h1, h2, span, label, legend, button:enabled, select, input, output, dt, dd, kbd, #pixel")) {
                const a = light(parse(getComputedStyle(e).color)), b = light(behind(e));
                ratios[e.tagName + "#" + e.id + " " + e.textContent.slice(0, 20)] = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            }
            return [light(behind(document.body)), light(behind(screen)), ratios]; })()"""
        for theme in ("light", "dark"):
            self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": theme}])
            self.browser.run("say('it went wrong', true)")
            self.settle()
            page, around, ratios = self.browser.run(script)
            for brightness in (page, around):
                (self.assertGreater if theme == "light" else self.assertLess)(brightness, 0.2)
            self.assertGreater(len(ratios), 40)
            for element, ratio in ratios.items():
                self.assertGreaterEqual(ratio, 4.5, (theme, element))
            # What is around the picture is drawn, and follows at once.
            drawn = self.browser.run("pen.getImageData(2, screen.height - 2, 1, 1).data[0]")
            (self.assertGreater if theme == "light" else self.assertLess)(drawn, 128)
            if self.screenshots:
                self.browser.screenshot(self.screenshots / f"view-{theme}.png", whole=False)
        self.browser.call("Emulation.setEmulatedMedia", features=[])

    def test_phone(self):
        """The status and all that a click tells are to be read whole."""
        self.browser.resize(360, 740)
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0 && state.samples > 0")
        self.browser.run("setInspect(true); say('rendering, 12345 spp + 67890 in the part, 12345.6 s')")
        self.browser.mouse("mousePressed", 180, 370, 1)
        self.browser.mouse("mouseReleased", 180, 370)
        self.browser.wait_for("/ normal .* plymesh /.test(document.getElementById('pixel').textContent)")
        for element in ("status", "pixel"):
            shown = self.browser.run(f"""(() => {{ const e = document.getElementById('{element}'), b = e.getBoundingClientRect();
                const range = document.createRange(); range.selectNodeContents(e);
                return [e.scrollWidth - e.clientWidth, e.scrollHeight - e.clientHeight,
                        ...[...range.getClientRects()].flatMap(r => [b.left - r.left, r.right - b.right, b.top - r.top, r.bottom - b.bottom]),
                        -b.left, b.right - innerWidth, -b.top, b.bottom - innerHeight]; }})()""")
            self.assertLessEqual(max(shown), 1, element)
        for button in ("pause", "panel", "keys", "orbit", "look", "mode"):
            box = self.browser.run(f"(() => {{ const b = document.getElementById('{button}').getBoundingClientRect(); return [b.left, b.right, b.height]; }})()")
            self.assertGreaterEqual(box[0], 0)
            self.assertLessEqual(box[1], 360)
        if self.screenshots:
            self.browser.screenshot(self.screenshots / "view-phone.png", whole=False)

    def test_pages_of_a_render_that_has_gone(self):
        """A new render at the same port has another address, which old pages say; with --token they go on with it."""
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            port = str(s.getsockname()[1])
        view = View(self.drc, "--port", port)
        try:
            self.browser.open(view.url)
            self.browser.wait_for("document.body.dataset.drawn > 0")
            view.close()
            self.browser.wait_for("$('status').textContent.includes('does not answer')")
            view = View(self.drc, "--port", port)
            self.browser.wait_for("$('status').textContent.includes('open the new address')")
            self.assertTrue(self.browser.run("$('status').classList.contains('bad')"))
            view.close()

            token = "the-same-each-time_0"
            view = View(self.drc, "--port", port, "--token", token)
            self.assertEqual(view.path, f"/{token}/")
            self.browser.open(view.url)
            self.browser.wait_for("document.body.dataset.drawn > 0")
            run = self.browser.run("state.run")
            self.assertNotIn(token.encode(), view.get("save.exr"))
            view.close()
            view = View(self.drc, "--port", port, "--token", token)
            self.browser.wait_for(f"document.body?.dataset.drawn > 0 && state?.run && state.run !== '{run}' && state.samples > 0")
        finally:
            view.close()
            self.browser.events.clear()

    def test_narrow(self):
        self.browser.resize(360, 640)
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0")
        self.assertLessEqual(self.browser.run("document.documentElement.scrollWidth"), 360)
        self.browser.run("document.getElementById('panel').click()")
        self.assertTrue(self.browser.run("document.getElementById('controls').getBoundingClientRect().width <= 360"))
        if self.screenshots:
            self.browser.screenshot(self.screenshots / "view-narrow.png", whole=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("drc", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path, help="folder for screenshots of the page")
    parser.add_argument("tests", nargs="*", help="names of single tests, as ViewServer.test_pause")
    args = parser.parse_args()
    if args.screenshots:
        args.screenshots.mkdir(parents=True, exist_ok=True)
    ViewServer.drc = ViewInBrowser.drc = args.drc.resolve(strict=True)
    ViewInBrowser.program = find_browser()
    ViewInBrowser.screenshots = args.screenshots
    loader = unittest.defaultTestLoader
    tests = loader.loadTestsFromNames(args.tests, sys.modules[__name__]) if args.tests else unittest.TestSuite(
        map(loader.loadTestsFromTestCase, (ViewServer, ViewInBrowser)))
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
