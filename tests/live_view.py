"""A running `drc view`, for tests of its server and its page."""
import json
import pathlib
import signal
import socket
import struct
import subprocess
import time
import urllib.parse
import urllib.request

from browser import PATIENCE

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENE = ROOT / "scenes" / "quickstart" / "scene.pbrt"
SIZE = (320, 180)


class View:
    """A running `drc view`."""

    def __init__(self, drc, *options, scene=SCENE, size=SIZE):
        self.process = subprocess.Popen([drc, "view", scene, "--resolution", f"{size[0]}x{size[1]}", *options],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.url = self.process.stdout.readline().strip()
        parts = urllib.parse.urlsplit(self.url)
        self.port, self.path = parts.port, parts.path

    def close(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
        self.process.wait(PATIENCE)
        self.process.stdout.close()

    def get(self, what, **options):
        with urllib.request.urlopen(self.url + what, timeout=PATIENCE, **options) as response:
            return response.read()

    def post(self, what, body):
        return self.get(what, data=body if isinstance(body, bytes) else json.dumps(body).encode())

    def state(self):
        return json.loads(self.get("state"))

    def wait_for(self, condition):
        limit = time.monotonic() + PATIENCE
        while not condition(state := self.state()):
            if time.monotonic() > limit:
                raise TimeoutError(state)
            time.sleep(0.02)
        return state

    def pause(self):
        """Waits until what has been sampled is shown as well, however long the machine takes for it.

        Returns the numbers of the pictures before and after that; then nothing moves."""
        self.post("pause", True)
        paused_at = self.wait_for(lambda s: s["paused"])["number"]
        shown, number = None, paused_at
        while shown != number:
            time.sleep(1.5)
            shown, number = number, self.state()["number"]
        return paused_at, number

    def frame(self, layer="beauty"):
        data = self.get("frame?layer=" + layer)
        width, height, channels, number = struct.unpack("<4I", data[:16])
        values = struct.unpack(f"<{width * height * channels}e", data[16:])
        return width, height, channels, number, values

    def raw(self, data, timeout=20):
        """What the server answers to these bytes."""
        with socket.create_connection(("127.0.0.1", self.port), timeout) as s:
            s.sendall(data)
            answer = b""
            try:
                while chunk := s.recv(65536):
                    answer += chunk
            except (ConnectionError, TimeoutError):
                pass
            return answer
