"""Receives the picture that `drc render --display-server` sends, by the protocol of tev, the image viewer.

A thread of its own reads packets into one numpy array; it touches nothing of Blender. Packets are their own length, a
type and a payload, all little-endian; see https://github.com/Tom94/tev.
"""

import os
import socket
import struct
import tempfile
import threading
import time
from dataclasses import dataclass

import numpy as np

CREATE, UPDATE_V3 = 4, 6
MOST_BYTES = 1 << 30  # of a packet
CALM = 0.2  # seconds without a packet after which a picture, which comes in tiles, is complete


class ProtocolError(ValueError):
    pass


class _Fields:
    """The fields of a packet, one after the other."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, kind="<i"):
        size = struct.calcsize(kind)
        if self.at + size > len(self.data):
            raise ProtocolError("a packet ends too early")
        (value,) = struct.unpack_from(kind, self.data, self.at)
        self.at += size
        return value

    def text(self):
        end = self.data.find(b"\0", self.at)
        if end < 0:
            raise ProtocolError("a name in a packet has no end")
        value = bytes(self.data[self.at : end]).decode("utf-8", "replace")
        self.at = end + 1
        return value

    def floats(self):
        rest = len(self.data) - self.at
        return np.frombuffer(self.data, dtype="<f4", count=rest // 4, offset=self.at)


@dataclass
class Picture:
    """channels: "R", "G", "B", "albedo.R" ...; planes: channels x height x width, rows from the top."""

    channels: list
    planes: np.ndarray

    def layer(self, *names):
        """A plane for each name, not copied, or None if a channel is missing."""
        if any(n not in self.channels for n in names):
            return None
        return [self.planes[self.channels.index(n)] for n in names]


class TevReceiver:
    """Listens until close(), on a socket in a folder of this user alone: what comes is trusted with memory."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="drc-")
        path = os.path.join(self._folder.name, "picture")
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(path)
        self._listener.listen()
        self.address = f"unix:{path}"
        self._lock = threading.Lock()
        self._picture, self._version, self._taken, self._came_at = None, 0, 0, 0.0
        self._quiet = threading.Event()  # nobody is connected, and nobody waits to be
        self.error = None
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._serve, name="drc picture", daemon=True)
        self._thread.start()

    def close(self):
        self._closing.set()
        self._thread.join(timeout=5)
        self._listener.close()
        self._folder.cleanup()

    def changed(self):
        """The picture, if there is a new one since the last call and no more of it has come for a moment. It is the
        receiver's own: what comes later is written into it."""
        with self._lock:
            if self._version == self._taken or time.monotonic() - self._came_at < CALM:
                return None
            self._taken = self._version
            return self._picture

    def last(self):
        """The picture, whether it has been taken before or not; None if no part of it has come."""
        with self._lock:
            return self._picture if self._version else None

    def forget(self):
        """The picture so far: what comes next is of another one."""
        with self._lock:
            self._picture, self._version, self._taken = None, 0, 0

    def drain(self, seconds):
        """After the sender has sent all: reads it, for so long at most."""
        self._quiet.clear()
        self._quiet.wait(seconds)

    # On the thread

    def _serve(self):
        self._listener.settimeout(0.05)
        while not self._closing.is_set():
            try:
                connection, _ = self._listener.accept()
            except (TimeoutError, socket.timeout):
                self._quiet.set()
                continue
            except OSError:
                return
            try:
                with connection:
                    self._read(connection)
            except (OSError, ProtocolError) as error:
                self.error = str(error)

    def _read(self, connection):
        connection.settimeout(0.05)
        while True:
            head = self._exactly(connection, 4)
            if head is None:
                return
            (length,) = struct.unpack("<I", head)
            if not 5 <= length <= MOST_BYTES:
                raise ProtocolError(f"a packet of {length} bytes")
            body = self._exactly(connection, length - 4)
            if body is None:
                return
            self._packet(body)

    def _exactly(self, connection, count):
        """count bytes; None at the connection's end or when closing."""
        data, got = bytearray(count), 0
        view = memoryview(data)
        while got < count:
            try:
                received = connection.recv_into(view[got:])
            except (TimeoutError, socket.timeout):
                if self._closing.is_set():
                    return None
                continue
            if not received:
                return None
            got += received
        return data

    def _packet(self, body):
        fields = _Fields(body)
        kind = fields.number("<b")
        if kind == CREATE:
            fields.number("<b")  # whether to select the image
            fields.text()
            width, height, count = fields.number(), fields.number(), fields.number()
            if not (
                0 < width <= 1 << 16
                and 0 < height <= 1 << 16
                and 0 < count <= 256
                and width * height * count <= MOST_BYTES
            ):
                raise ProtocolError(f"an image of {width} x {height} pixels with {count} channels")
            channels = [fields.text() for _ in range(count)]
            with self._lock:
                self._picture = Picture(channels, np.zeros((count, height, width), dtype=np.float32))
        elif kind == UPDATE_V3:
            fields.number("<b")
            fields.text()
            count = fields.number()
            if not 0 < count <= 256:
                raise ProtocolError(f"an update of {count} channels")
            names = [fields.text() for _ in range(count)]
            x, y, width, height = (fields.number() for _ in range(4))
            begins = [fields.number("<q") for _ in range(count)]
            strides = [fields.number("<q") for _ in range(count)]
            self._update(names, x, y, width, height, begins, strides, fields.floats())

    def _update(self, names, x, y, width, height, begins, strides, values):
        with self._lock:
            picture = self._picture
            if picture is None:
                raise ProtocolError("an update before there is an image")
            planes = picture.planes
            rows, columns = planes.shape[1:]
            if x < 0 or y < 0 or width <= 0 or height <= 0 or x + width > columns or y + height > rows:
                raise ProtocolError("an update outside of the image")
            for name, begin, stride in zip(names, begins, strides):
                last = begin + stride * (width * height - 1)
                if begin < 0 or stride < 1 or last >= len(values) or name not in picture.channels:
                    raise ProtocolError(f"an update of the channel '{name}' that does not fit")
                planes[picture.channels.index(name), y : y + height, x : x + width] = values[
                    begin : last + 1 : stride
                ].reshape(height, width)
            self._version += 1
            self._came_at = time.monotonic()
