"""The viewport's side of `drc view`: starts it, moves its camera, fetches its frames. Nothing here touches Blender.

All requests are made on one thread, so that Blender never waits for the renderer: the latest camera counts, and the
latest frame is kept.
"""

import contextlib
import http.client
import json
import threading
import time
from urllib.parse import urlsplit

import numpy as np

from .program import Child, UserError

START = 120.0  # seconds that a renderer may take to read the scene and print its address
ENDING = 2.0  # that a renderer whose connection breaks has to end
ASK_EVERY = 0.03  # seconds
MOST_BYTES = 1 << 30

# While it is set, all renderers of viewports rest, and leave the machine to a render.
resting = threading.Event()


def frame_of(data):
    """(number, height x width x channels of halves, rows from the top) of the answer to `frame`."""
    if len(data) < 16:
        raise ValueError("a frame without a head")
    width, height, channels, number = (int(n) for n in np.frombuffer(data, dtype="<u4", count=4))
    if len(data) != 16 + 2 * width * height * channels:
        raise ValueError(f"a frame of {width} x {height} x {channels} values in {len(data)} bytes")
    return number, np.frombuffer(data, dtype="<f2", offset=16).reshape(height, width, channels)


def origin_of(camera):
    """Where the renderer's world space has its origin, in that of the scene file. camera: of `state`."""
    words = camera["pbrt"].split()
    eye = [float(word) for word in words[words.index("LookAt") + 1 :][:3]]
    return tuple(e - c for e, c in zip(eye, camera["eye"]))


def progress_of(state):
    if state["samples"] == 0:
        return f"{state['share']:.0%} of the pixels"
    return f"{state['samples']} sample{'s' if state['samples'] != 1 else ''} a pixel"


class ViewClient:
    """A running `drc view`. error: a line for the user, once it has failed."""

    def __init__(self, command):
        self.error = None
        self._lock = threading.Lock()
        self._wanted, self._sent, self._rests = None, None, False
        self._frame, self._number, self._taken = None, None, None
        self.progress = "reading the scene"  # a line for the user
        self._closing = threading.Event()
        self.child = Child(command, keep_output=True)
        self._thread = threading.Thread(target=self._run, name="drc view", daemon=True)
        self._thread.start()

    def move(self, view, width, height, moving, part=None):
        """The camera from now on, and the size of its frames. part: what all samples go to, (x0, x1, y0, y1) from 0 to 1
        across the picture from its top left; None for the whole picture."""
        with self._lock:
            self._wanted = view, width, height, bool(moving), part

    def frame(self):
        """The latest frame, if it has not been taken yet, else None."""
        with self._lock:
            if self._frame is None or self._taken == self._number:
                return None
            self._taken = self._number
            return self._frame

    def has_news(self):
        with self._lock:
            return self.error is not None or (self._frame is not None and self._taken != self._number)

    def close(self):
        """Does not wait for the renderer: it ends by itself or is ended."""
        self._closing.set()
        threading.Thread(target=self.child.stop, kwargs={"grace": 1.0}, name="drc ends", daemon=True).start()

    # On the thread

    def _run(self):
        try:
            address = self._address()
            if address is None:
                return
            parts = urlsplit(address)
            self._connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=30)
            self._prefix = parts.path
            with contextlib.closing(self._connection):
                self._serve()
        except (OSError, ValueError, KeyError, http.client.HTTPException, UserError) as error:
            if not self._closing.is_set():
                if not isinstance(error, UserError) and self.child.has_ended(ENDING):
                    self.child.finish()
                    error = self.child.failure()
                self.error = str(error) or type(error).__name__

    def _serve(self):
        origin = origin_of(json.loads(self._request("GET", "state"))["camera"])
        while not self._closing.is_set():
            if not self.child.running():
                self.child.finish()
                raise UserError(self.child.failure())
            self._send_camera(origin)
            self._send_rest()
            self._ask_for_frame()
            self._closing.wait(ASK_EVERY)

    def _address(self):
        end = time.monotonic() + START
        while time.monotonic() < end and not self._closing.is_set():
            if self.child.output:
                return self.child.output[0].strip()
            if not self.child.running():
                self.child.finish()
                raise UserError(self.child.failure())
            time.sleep(0.02)
        if self._closing.is_set():
            return None
        raise UserError(f"the renderer has not begun within {START:g} seconds")

    def _request(self, method, what, body=None):
        self._connection.request(method, self._prefix + what, body=body)
        answer = self._connection.getresponse()
        data = answer.read(MOST_BYTES)
        if answer.status == 503:  # no picture yet
            return None
        if answer.status != 200:
            raise UserError(f"the renderer has refused '{what}': {data.decode('utf-8', 'replace').strip()}")
        return data

    def _send_camera(self, origin):
        with self._lock:
            wanted = self._wanted
        if wanted is None or wanted == self._sent:
            return
        view, width, height, moving, part = wanted
        camera = view.as_camera(origin) | {"width": width, "height": height, "moving": moving}
        self._request("POST", "camera", json.dumps(camera))
        if part is not None or (self._sent is not None and self._sent[-1] is not None):
            # After the camera: one that moves makes the renderer forget the part.
            edges = dict(zip(("x0", "x1", "y0", "y1"), part)) if part is not None else None
            self._request("POST", "focus", json.dumps(edges))
        self._sent = wanted

    def _send_rest(self):
        rests = resting.is_set()
        if rests != self._rests:
            self._request("POST", "pause", "true" if rests else "false")
            self._rests = rests

    def _ask_for_frame(self):
        state = json.loads(self._request("GET", "state"))
        if state.get("error"):
            raise UserError(state["error"])
        # A frame of a camera that has been left is shown until there is one of the new camera; but not of that which
        # the renderer began with.
        if self._sent is not None and state.get("view") == 0:
            return
        if state.get("number") is None or state["number"] == self._number:
            return
        data = self._request("GET", "frame?layer=beauty")
        if data is None:
            return
        number, frame = frame_of(data)
        with self._lock:
            self._number, self._frame, self.progress = number, frame, progress_of(state)
