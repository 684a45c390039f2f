#!/usr/bin/env python3
"""The camera controls of `drc view` in a browser, by what the picture shows.

    tests/view_steering_test.py DRC [NAME ...]

The scene has a red ball that is near and on the left, a green one that is far and on the right, and a blue one between
them. Each test moves the camera by mouse, touch or keys, and looks where the balls have gone in the picture; so it does
for cameras of pbrt that are mirrored or not, whose vertical is y or z, that look down, and for parallel rays. Skipped
without Chromium.
"""
import argparse
import json
import math
import pathlib
import sys
import tempfile
import time
import unittest

from browser import PATIENCE, SKIPPED, Browser, find_browser
from live_view import View

SIZE = (240, 135)
# Name: colour, place to the right, upwards and ahead of the camera, radius.
BALLS = {"red": ((1, 0, 0), (-1.1, 0.1, 4), 0.25), "green": ((0, 1, 0), (2.2, 0.3, 9), 0.5), "blue": ((0, 0, 1), (0.5, -0.4, 6), 0.2)}
# The centre of a ball's pixels, on the page, and their number.
LOOK_FOR_BALLS = """(() => {
    const w = screen.width, d = pen.getImageData(0, 0, w, screen.height).data, frame = screen.getBoundingClientRect(), found = {};
    ["red", "green", "blue"].forEach((name, c) => {
        let n = 0, x = 0, y = 0;
        for (let i = 0; i < d.length; i += 4)
            if (d[i + c] > 100 && d[i + c] > 2 * Math.max(d[i + (c + 1) % 3], d[i + (c + 2) % 3])) { ++n; x += i / 4 % w; y += Math.floor(i / 4 / w); }
        found[name] = n ? [frame.left + x / n + 0.5, frame.top + y / n + 0.5, n] : null;
    });
    return found; })()"""


def add(a, b, k=1):
    return [x + k * y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = math.hypot(*a)
    return [x / length for x in a]


def scene_of(up, ahead, mirrored, camera):
    ahead = unit(ahead)
    # pbrt's camera space is left-handed.
    right = unit(cross(up, ahead))
    top = cross(ahead, right)
    if mirrored:
        right = [-x for x in right]
    eye = [3, 2, 1]
    text = ["Scale -1 1 1"] if mirrored else []
    text += ["LookAt " + " ".join(map(str, eye + add(eye, ahead, 6) + up)), f"Camera {camera}",
             'Film "image" "integer xresolution" 240 "integer yresolution" 135', "WorldBegin"]
    for colour, (r, t, a), radius in BALLS.values():
        at = add(add(add(eye, right, r), top, t), ahead, a)
        text += ["AttributeBegin", f'AreaLightSource "diffuse" "rgb L" [{" ".join(map(str, colour))}]',
                 f"Translate {' '.join(map(str, at))}", f'Shape "sphere" "float radius" {radius}', "AttributeEnd"]
    return "\n".join(text + ["WorldEnd", ""])


class Page:
    """A tab that shows the view."""

    def __init__(self, program, view):
        self.browser, self.view = Browser(program), view
        self.browser.resize(1280, 800)
        self.open()

    def open(self):
        self.browser.open(self.view.url)
        self.browser.wait_for("document.body.dataset.drawn > 0")
        self.settle()

    def close(self):
        self.browser.close()

    def run(self, script):
        return self.browser.run(script)

    def settle(self):
        """Waits until the page shows the last picture of the camera that it has set."""
        self.browser.wait_for("!settle && !sending && !next")
        # A camera is on its way to the render, and the last picture comes after the word that all is done.
        before, shown = None, self.shown_last()
        while before != shown:
            time.sleep(0.2)
            before, shown = shown, self.shown_last()
        self.run("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))")

    def shown_last(self):
        self.browser.wait_for(f"state.done && !fetching && current.number === state.number && current.width === {SIZE[0]}")
        state = self.view.wait_for(lambda s: s["done"])
        return state["view"], state["number"], self.run("current.number")

    def balls(self):
        return self.run(LOOK_FOR_BALLS)

    def eye(self):
        return self.view.state()["camera"]["eye"]

    def reset(self, steering="orbit"):
        self.run(f"setSteering('{steering}'); reset()")
        self.settle()
        return self.balls()

    def drag(self, start, by, button="left", modifiers=0):
        buttons = {"left": 1, "right": 2, "middle": 4}[button]
        for kind, share in [("mouseMoved", 0), ("mousePressed", 0)] + [("mouseMoved", i / 8) for i in range(1, 9)] + [("mouseReleased", 1)]:
            held = kind != "mouseReleased" and not (kind == "mouseMoved" and share == 0)
            self.browser.call("Input.dispatchMouseEvent", type=kind, x=start[0] + share * by[0], y=start[1] + share * by[1],
                              button=button if held or kind == "mouseReleased" else "none", buttons=buttons if held else 0,
                              clickCount=1, modifiers=modifiers)
        self.settle()
        return self.balls()

    def touch(self, fingers, by):
        """Moves each finger from where it is by so much."""
        def points(share):
            return [{"x": x + share * dx, "y": y + share * dy, "id": i} for i, ((x, y), (dx, dy)) in enumerate(zip(fingers, by))]
        self.browser.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=points(0))
        for i in range(1, 9):
            self.browser.call("Input.dispatchTouchEvent", type="touchMove", touchPoints=points(i / 8))
        self.browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.settle()
        return self.balls()

    def key(self, kind, key, code=None, modifiers=0):
        self.browser.call("Input.dispatchKeyEvent", type=kind, key=key, code=code or key, modifiers=modifiers)

    def hold(self, key, code=None, modifiers=0):
        """Until the camera has moved by a tenth of what the picture shows, or turned by that."""
        before = self.run("structuredClone(camera)")
        self.key("keyDown", key, code, modifiers)
        self.browser.wait_for(f"""["eye", "look"].some(place =>
            Math.hypot(...add(camera[place], {json.dumps(before)}[place], -1)) > 0.1 * distanceOf(home))""")
        self.key("keyUp", key, code, modifiers)
        self.settle()
        return self.balls()


class Steering:
    """What holds for every camera."""
    drc = program = None
    up, ahead, mirrored, camera = [0, 1, 0], [0.36, -0.1, 0.93], False, '"perspective" "float fov" 50'

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        scene = pathlib.Path(cls.folder.name, "balls.pbrt")
        scene.write_text(scene_of(cls.up, cls.ahead, cls.mirrored, cls.camera))
        cls.view = View(cls.drc, "--integrator", "path", "--spp", "1", scene=scene, size=SIZE)
        cls.page = Page(cls.program, cls.view)

    @classmethod
    def tearDownClass(cls):
        cls.page.close()
        cls.view.close()
        cls.folder.cleanup()

    def moves(self, before, after):
        return {name: [after[name][i] - before[name][i] for i in range(3)] for name in BALLS}

    def check(self, values, sign, least=3):
        for value in values:
            self.assertGreater(sign * value, least, values)

    def test_the_scene_is_as_it_says(self):
        balls = self.page.reset()
        self.assertLess(balls["red"][0], balls["blue"][0])
        self.assertLess(balls["blue"][0], balls["green"][0])

    def test_keys_fly(self):
        page = self.page
        for key, axis, sign in (("d", 0, -1), ("a", 0, 1), ("e", 1, 1), ("q", 1, -1)):
            with self.subTest(key):
                before = page.reset()
                moves = self.moves(before, page.hold(key))
                self.check([m[axis] for m in moves.values()], sign)
        if "perspective" in self.camera:
            for key, sign in (("w", 1), ("s", -1)):
                with self.subTest(key):
                    before = page.reset()
                    moves = self.moves(before, page.hold(key))
                    self.check([m[2] for m in moves.values()], sign)

    def test_drag_orbits_around_the_point_under_the_pointer(self):
        page = self.page
        for by, axis in (((90, 0), 0), ((0, -60), 1)):
            with self.subTest(by):
                before = page.reset()
                moves = self.moves(before, page.drag(before["blue"], by))
                sign = 1 if by[axis] > 0 else -1
                # What is nearer goes with the hand, what is farther against it, and what the hand holds stays.
                self.check([moves["red"][axis], -moves["green"][axis]], sign)
                self.assertLess(math.hypot(*moves["blue"][:2]), 12)

    def test_drag_looks_around(self):
        page = self.page
        for by, axis in (((90, 0), 0), ((-90, 0), 0), ((0, 60), 1), ((0, -60), 1)):
            with self.subTest(by):
                before, eye = page.reset("look"), page.eye()
                after, sign = page.drag((515, 400), by), 1 if by[axis] > 0 else -1
                # The middle of the picture follows the pointer; beside it, the picture moves a little faster or slower.
                if "perspective" in self.camera:
                    moves = self.moves(before, after)
                    for move in moves.values():
                        self.assertGreater(move[axis] * sign, 0.8 * abs(by[axis]), moves)
                        self.assertLess(move[axis] * sign, 1.6 * abs(by[axis]), moves)
                for a, b in zip(page.eye(), eye):
                    self.assertAlmostEqual(a, b, places=4)

    def test_pan_moves_what_is_under_the_pointer(self):
        page = self.page
        for button, modifiers in (("right", 0), ("middle", 0), ("left", 2)):
            for steering in ("orbit", "look"):
                with self.subTest((button, steering)):
                    before = page.reset(steering)
                    moves = self.moves(before, page.drag(before["blue"], (70, -40), button, modifiers))
                    self.assertLess(math.hypot(moves["blue"][0] - 70, moves["blue"][1] + 40), 4, moves)

    def test_wheel_goes_to_what_is_under_the_pointer(self):
        page = self.page
        for turn in (-400, 400):
            with self.subTest(turn):
                before = page.reset()
                x, y, size = before["blue"]
                for _ in range(4):
                    page.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=turn / 4)
                page.settle()
                moves = self.moves(before, page.balls())
                self.assertLess(math.hypot(*moves["blue"][:2]), 6, moves)
                self.assertAlmostEqual(math.log((size + moves["blue"][2]) / size), -2 * turn * math.log(1.0015), delta=0.3)

    def test_arrows(self):
        page = self.page
        for key, axis, sign in (("ArrowRight", 0, -1), ("ArrowLeft", 0, 1), ("ArrowUp", 1, 1), ("ArrowDown", 1, -1)):
            with self.subTest(key):
                before, eye = page.reset("look"), page.eye()
                after = page.hold(key)
                if "perspective" in self.camera:
                    self.check([m[axis] for m in self.moves(before, after).values()], sign)
                self.assertLess(math.dist(page.eye(), eye), 1e-3)
                # The eye goes to that side: what is near leaves to the other one, beside what is far.
                before, eye = page.reset("orbit"), page.eye()
                moves = self.moves(before, page.hold(key))
                self.assertGreater(sign * (moves["red"][axis] - moves["green"][axis]), 3, moves)
                self.assertGreater(math.dist(page.eye(), eye), 0.1)

    def test_touch(self):
        page = self.page
        before = page.reset()
        x, y, size = before["blue"]
        moves = self.moves(before, page.touch([(x, y)], [(90, 0)]))
        self.check([moves["red"][0], -moves["green"][0]], 1)
        before = page.reset()
        moves = self.moves(before, page.touch([(x - 60, y), (x + 60, y)], [(70, -40), (70, -40)]))
        self.assertLess(math.hypot(moves["blue"][0] - 70, moves["blue"][1] + 40), 6, moves)
        before = page.reset()
        moves = self.moves(before, page.touch([(x - 60, y), (x + 60, y)], [(-30, 0), (30, 0)]))
        self.assertLess(math.hypot(*moves["blue"][:2]), 8, moves)
        self.assertGreater(moves["blue"][2], 0.5 * size)


class Upright(Steering, unittest.TestCase):
    """And what does not depend on the camera."""

    def test_keys_after_a_slider(self):
        page = self.page
        for element in ("exposure", "speed", "orbit", "pause", "layer"):
            with self.subTest(element):
                before = page.reset()
                page.run("setExposure(0)")
                x, y = page.run(f"(() => {{ const b = $('{element}').getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; }})()")
                if element == "layer":
                    # A list of the system's cannot be clicked here.
                    page.browser.mouse("mousePressed", 515, 700, 1)
                    page.browser.mouse("mouseReleased", 515, 700)
                    page.run("$('layer').focus(); $('layer').dispatchEvent(new Event('change', { bubbles: true }))")
                else:
                    for paused in ("true", "false") if element == "pause" else (None,):
                        page.browser.mouse("mousePressed", x, y, 1)
                        page.browser.mouse("mouseReleased", x, y)
                        if paused:
                            page.browser.wait_for(f"state.paused === {paused}")
                self.assertEqual(page.run("document.activeElement.id"), "screen")
                moves = self.moves(before, page.hold("d", "KeyD"))
                self.check([m[0] for m in moves.values()], -1)
        page.run("setSpeed(0)")
        # Whoever goes to it by Tab has its arrows, and the letters fly all the same.
        before = page.reset()
        page.run("$('layer').focus()")
        page.browser.press("Tab", 9)
        page.browser.press("Tab", 9)
        self.assertEqual(page.run("document.activeElement.id"), "exposure")
        page.browser.press("ArrowRight", 39)
        self.assertAlmostEqual(page.run("exposure"), 0.1)
        moves = self.moves(before, page.hold("d", "KeyD"))
        self.check([m[0] for m in moves.values()], -1)
        page.run("setExposure(0)")

    def test_other_keyboards(self):
        """Without Latin letters, and with shift held, which is quicker."""
        page = self.page
        before = page.reset()
        moves = self.moves(before, page.hold("в", "KeyD"))
        self.check([m[0] for m in moves.values()], -1)
        # As in frames of a tenth of a second.
        steps = []
        for shift in ("", "held.add('shift');"):
            page.reset()
            eye = page.eye()
            page.run(f"held.add('d'); {shift} lastFlight = 0; flight(100); release()")
            page.settle()
            steps.append(math.dist(page.eye(), eye))
        self.assertAlmostEqual(steps[1] / steps[0], 4, places=3)
        page.reset()
        moves = self.moves(before, page.hold("D", "KeyD", modifiers=8))
        self.check([m[0] for m in moves.values()], -1)

    def test_mode_is_kept(self):
        page = self.page
        page.reset()
        for key, name in (("l", "look"), ("o", "orbit"), ("l", "look")):
            page.key("keyDown", key)
            page.key("keyUp", key)
            pressed = "['orbit', 'look', 'mode'].filter(id => $(id).getAttribute('aria-pressed') === 'true').join()"
            self.assertEqual(page.run(pressed), name)
            page.open()
            self.assertEqual(page.run(pressed), name)
        page.key("keyDown", "i")
        self.assertEqual(page.run(pressed), "mode")
        page.reset()

    def test_help_lists_the_keys(self):
        page = self.page
        page.reset()
        page.key("keyDown", "h")
        self.assertTrue(page.run("$('help').open"))
        keys = page.run("[...document.querySelectorAll('#help kbd')].map(k => k.textContent.toLowerCase())")
        names = {" ": "space", "escape": "esc", "arrowleft": "←", "arrowright": "→", "arrowup": "↑", "arrowdown": "↓", "=": "+"}
        for key in page.run("[...Object.keys(flying), ...Object.keys(turning), ...Object.keys(acts)]"):
            self.assertIn(names.get(key, key), keys)
        # Nothing is steered behind it.
        eye = page.eye()
        page.browser.press("d", 68)
        time.sleep(0.3)
        self.assertEqual(page.eye(), eye)
        page.browser.press("Escape", 27)
        self.assertFalse(page.run("$('help').open"))

    def test_two_pages(self):
        page = self.page
        page.reset()
        other = Page(self.program, self.view)
        try:
            page.hold("d")
            other.settle()
            before = other.balls()
            for name, ball in page.balls().items():
                self.assertLess(math.dist(ball[:2], before[name][:2]), 1.5, name)
            # It goes on from there.
            moves = self.moves(before, other.drag(before["blue"], (70, -40), "right"))
            self.assertLess(math.hypot(moves["blue"][0] - 70, moves["blue"][1] + 40), 4, moves)
            page.settle()
            self.assertLess(math.dist(page.run("camera.eye"), other.run("camera.eye")), 1e-5)
            for paused in ("true", "false"):
                page.run("togglePause()")
                other.browser.wait_for(f"state.paused === {paused}")
            # Not while it drags itself.
            other.browser.mouse("mousePressed", 515, 400, 1)
            was = other.run("camera.eye")
            page.hold("a")
            self.assertEqual(other.run("camera.eye"), was)
            other.browser.mouse("mouseReleased", 515, 400)
            other.browser.wait_for(f"Math.hypot(...add(camera.eye, {was}, -1)) > 1e-6")
            self.assertLess(math.dist(page.run("camera.eye"), other.run("camera.eye")), 1e-5)
        finally:
            other.close()

    def test_moves_while_paused(self):
        page = self.page
        before = page.reset()
        self.view.post("pause", True)
        try:
            eye = page.eye()
            page.key("keyDown", "d")
            page.browser.wait_for(f"Math.hypot(...add(camera.eye, {eye}, -1)) > 0.1 * distanceOf(home)")
            page.key("keyUp", "d")
            page.browser.wait_for("!settle && !sending && !next")
            self.view.wait_for(lambda s: s["samples"] == 1 and s["paused"])
            page.browser.wait_for(f"!fetching && current.width === {SIZE[0]}")
            page.run("new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))")
            self.check([m[0] for m in self.moves(before, page.balls()).values()], -1)
        finally:
            self.view.post("pause", False)


class Mirrored(Steering, unittest.TestCase):
    mirrored = True


class ZUp(Steering, unittest.TestCase):
    up, ahead = [0, 0, 1], [0.8, 0.6, -0.1]


class MirroredZUp(Steering, unittest.TestCase):
    up, ahead, mirrored = [0, 0, 1], [-0.8, 0.6, 0.1], True


class LooksDown(Steering, unittest.TestCase):
    """More than halfway, where the camera's own up is nearer to another axis than to the vertical."""
    ahead = [0.35, -0.87, 0.35]


class Parallel(Steering, unittest.TestCase):
    camera = '"orthographic" "float screenwindow" [-4 4 -2.25 2.25]'


class MirroredParallel(Steering, unittest.TestCase):
    camera, mirrored = '"orthographic" "float screenwindow" [-4 4 -2.25 2.25]', True


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("drc", type=pathlib.Path)
    parser.add_argument("tests", nargs="*", help="names of single tests, as Upright.test_touch")
    args = parser.parse_args()
    Steering.drc, Steering.program = args.drc.resolve(strict=True), find_browser()
    if Steering.program is None:
        print("there is no Chromium here")
        return SKIPPED
    module, loader = sys.modules[__name__], unittest.defaultTestLoader
    suite = loader.loadTestsFromNames(args.tests, module) if args.tests else loader.loadTestsFromModule(module)
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
