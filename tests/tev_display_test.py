#!/usr/bin/env python3
"""`drc render --display-server` with viewers that behave, and with viewers that do not.

    tests/tev_display_test.py DRC [Viewers | Tevclient]

Viewers: the render ends in time, with the same file, whatever the viewer does.
Tevclient: the packets are those that tev's own Python client sends for the same pictures. Skipped without it:
`pip install tevclient`, and CMake's variable DRC_TEVCLIENT_PYTHON says which Python has it.
"""
import argparse
import pathlib
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

SKIPPED = 77
PATIENCE = 120  # seconds for a render on a busy machine
ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENE = ROOT / "scenes" / "cornell" / "scene.pbrt"
SIZE = (192, 160)
CREATE, UPDATE = 4, 6


class Viewer:
    """Listens on a port and records what comes, each connection by itself.

    stop_after: bytes of a connection after which it `then` "resets" it or "stops" reading; None: it reads all."""

    def __init__(self, port=0, stop_after=None, then="resets"):
        self.listener = socket.socket()
        self.listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        # Small, so that a render notices soon that nobody reads.
        self.listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 12)
        self.listener.bind(("127.0.0.1", port))
        self.listener.listen()
        self.port = self.listener.getsockname()[1]
        self.stop_after, self.then = stop_after, then
        self.received = []  # the bytes of each connection
        self.ended = 0  # number of connections that the other side has closed
        self.ending = threading.Event()
        self.thread = threading.Thread(target=self.serve)
        self.thread.start()

    def serve(self):
        self.listener.settimeout(0.02)
        while not self.ending.is_set():
            try:
                connection, _ = self.listener.accept()
            except TimeoutError:
                continue
            with connection:
                self.receive(connection)

    def receive(self, connection):
        data = bytearray()
        self.received.append(data)
        connection.settimeout(0.02)
        while not self.ending.is_set():
            if self.stop_after is not None and len(data) >= self.stop_after:
                if self.then == "resets":
                    connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
                    return
                self.ending.wait(0.02)
                continue
            try:
                chunk = connection.recv(1 << 16)
            except TimeoutError:
                continue
            if not chunk:
                self.ended += 1
                return
            data += chunk

    def wait_for(self, condition):
        limit = time.monotonic() + PATIENCE
        while not condition():
            if time.monotonic() > limit:
                raise TimeoutError([len(data) for data in self.received])
            time.sleep(0.01)

    def close(self):
        self.ending.set()
        self.thread.join()
        self.listener.close()


class Fields:
    """Takes the bytes of a packet apart."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def numbers(self, kind):
        values = struct.unpack_from("<" + kind, self.data, self.at)
        self.at += struct.calcsize("<" + kind)
        return values

    def text(self):
        end = self.data.index(0, self.at)
        text = self.data[self.at:end].decode()
        self.at = end + 1
        return text


def packets_of(data):
    """The packets of a connection, without a last one that is not whole."""
    packets, at = [], 0
    while len(data) - at >= 4:
        length, = struct.unpack_from("<I", data, at)
        if len(data) - at < length:
            break
        packets.append(bytes(data[at:at + length]))
        at += length
    return packets


def decoded(packet):
    """A packet's fields by name."""
    fields = Fields(packet)
    length, kind, focus = fields.numbers("IBB")
    assert length == len(packet)
    result = {"kind": kind, "focus": bool(focus), "name": fields.text()}
    if kind == CREATE:
        result["width"], result["height"], count = fields.numbers("3i")
        result["channels"] = [fields.text() for _ in range(count)]
        assert fields.at == length
    elif kind == UPDATE:
        count, = fields.numbers("i")
        result["channels"] = [fields.text() for _ in range(count)]
        result["x"], result["y"], result["width"], result["height"] = fields.numbers("4i")
        offsets, strides = fields.numbers(f"{count}q"), fields.numbers(f"{count}q")
        values = fields.numbers(f"{(length - fields.at) // 4}f")
        pixels = result["width"] * result["height"]
        result["values"] = [[values[offset + i * stride] for i in range(pixels)]
                            for offset, stride in zip(offsets, strides)]
        assert len(values) == max(o + (pixels - 1) * s + 1 for o, s in zip(offsets, strides))
    else:
        raise ValueError(f"a packet of type {kind}")
    return result


def assembled(packets):
    """What a viewer shows after these packets, a list of values for each channel, and how often it made the image."""
    image, created = {}, 0
    for packet in map(decoded, packets):
        if packet["kind"] == CREATE:
            size = packet["width"], packet["height"]
            image = {channel: [0.0] * (size[0] * size[1]) for channel in packet["channels"]}
            created += 1
            continue
        for channel, values in zip(packet["channels"], packet["values"]):
            for row in range(packet["height"]):
                to = (packet["y"] + row) * size[0] + packet["x"]
                image[channel][to:to + packet["width"]] = values[row * packet["width"]:(row + 1) * packet["width"]]
    return image, created


class RenderTest(unittest.TestCase):
    drc = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="drc-tev-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def viewer(self, *args, **options):
        viewer = Viewer(*args, **options)
        self.addCleanup(viewer.close)
        return viewer

    def start(self, port, *options, host="127.0.0.1", size=SIZE):
        process = subprocess.Popen(
            [self.drc, "render", SCENE, "--resolution", "{}x{}".format(*size), "--integrator", "path", "--denoise", "off",
             "--aovs", "-o", "out.exr", "--display-server", f"{host}:{port}", *options],
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        return process

    def end(self, process, code=0):
        """Waits for the render, which ends with this exit code; returns its messages."""
        _, messages = process.communicate(timeout=PATIENCE)
        self.assertEqual(process.returncode, code, messages)
        return messages

    def file(self):
        return (self.folder / "out.exr").read_bytes()


class Viewers(RenderTest):
    # Some seconds, so that the viewer is sent several pictures.
    SAMPLES = "--spp", "96", "--nthreads", "2"

    good = None  # what a viewer that reads everything was sent

    def setUp(self):
        super().setUp()
        if self.good is None:
            viewer = self.viewer()
            began = time.monotonic()
            messages = self.end(self.start(viewer.port, *self.SAMPLES))
            self.assertNotIn("warning", messages)
            viewer.wait_for(lambda: viewer.ended)
            viewer.close()
            # The file's metadata has the command line, so all viewers have the same port.
            Viewers.port, Viewers.expected, Viewers.good = viewer.port, self.file(), viewer.received[0]
            Viewers.usual = time.monotonic() - began
            (self.folder / "out.exr").unlink()

    def check(self, process, warnings=(1,)):
        """The render ends with the file that it would have without trouble, and soon."""
        began = time.monotonic()
        messages = self.end(process)
        self.assertTrue(self.file() == self.expected)
        self.assertIn(messages.count("warning: --display-server"), warnings, messages)
        self.assertLess(time.monotonic() - began, 2 * self.usual + 5)
        return messages

    def test_refines(self):
        packets = packets_of(self.good)
        self.assertEqual(sum(map(len, packets)), len(self.good))
        kinds = [packet[4] for packet in packets]
        self.assertEqual(kinds.count(CREATE), 1)
        self.assertEqual(kinds[0], CREATE)
        self.assertGreaterEqual(kinds.count(UPDATE), 2 * 4)  # pictures of four tiles
        self.assertEqual(decoded(packets[0])["channels"][:3], ["R", "G", "B"])

    def test_resets_in_the_middle(self):
        # In the middle of a tile of the first picture: when the last one is sent, the render could be over before it
        # hears of the reset, because the system keeps what the viewer has not read.
        *whole, cut = packets_of(self.good)[:3]
        viewer = self.viewer(self.port, stop_after=sum(map(len, whole)) + len(cut) // 2)
        self.check(self.start(self.port, *self.SAMPLES))
        self.assertGreater(len(viewer.received), 0)

    def test_resets_each_connection(self):
        viewer = self.viewer(self.port, stop_after=1000)
        self.check(self.start(self.port, *self.SAMPLES))
        self.assertGreater(len(viewer.received), 1)

    def test_never_reads(self):
        self.viewer(self.port, stop_after=0, then="stops")
        # So many pixels that the system does not keep them for the viewer.
        began = time.monotonic()
        messages = self.end(self.start(self.port, "--spp", "1", size=(1500, 1000)))
        alone = float(messages.split(" in ")[-1].split()[0])  # seconds until the file was written
        self.assertIn("does not read", messages)
        self.assertLess(time.monotonic() - began, alone + 5)

    def test_stops_reading(self):
        self.viewer(self.port, stop_after=len(self.good) // 3, then="stops")
        # The system may keep all that is not read.
        self.check(self.start(self.port, *self.SAMPLES), warnings=(0, 1))

    def test_is_not_there(self):
        self.assertIn("Connection refused", self.check(self.start(self.port, *self.SAMPLES)))

    def test_has_no_name(self):
        messages = self.end(self.start(self.port, "--spp", "1", host="no-such-host.invalid"))
        self.assertEqual(messages.count("warning: --display-server no-such-host.invalid"), 1)

    def test_goes_and_comes_back(self):
        viewer = self.viewer(self.port)
        process = self.start(self.port, *self.SAMPLES)
        viewer.wait_for(lambda: viewer.received and len(viewer.received[0]) > 1000)
        viewer.close()
        viewer = self.viewer(self.port)
        self.check(process)
        viewer.wait_for(lambda: viewer.ended)
        image, created = assembled(packets_of(viewer.received[-1]))
        self.assertEqual(created, 1)
        expected, _ = assembled(packets_of(self.good))
        self.assertEqual(image, expected)

    def test_ctrl_c(self):
        viewer = self.viewer(self.port)
        process = self.start(self.port, "--spp", "100000")
        viewer.wait_for(lambda: viewer.received and len(viewer.received[0]) > 1000)
        process.send_signal(signal.SIGINT)
        self.end(process, 128 + signal.SIGINT)
        self.assertTrue(self.file())

    def test_bad_addresses(self):
        for wrong in ("localhost", "localhost:", ":14158", "localhost:0", "localhost:65536", "localhost:x"):
            run = subprocess.run([self.drc, "render", SCENE, "--display-server", wrong], cwd=self.folder,
                                 capture_output=True, text=True)
            self.assertNotEqual(run.returncode, 0)
            self.assertIn(f"'{wrong}' is neither HOST:PORT", run.stderr)


class Tevclient(RenderTest):
    def test_same_bytes(self):
        import numpy
        import tevclient

        ours = self.viewer()
        self.end(self.start(ours.port, "--spp", "48", "--crop", ".1", "1", "0", ".9"))
        ours.wait_for(lambda: ours.ended)
        ours.close()
        packets = packets_of(ours.received[0])
        self.assertEqual(sum(map(len, packets)), len(ours.received[0]))
        theirs = self.viewer()
        with tevclient.Ipc("127.0.0.1", theirs.port) as ipc:
            for fields in map(decoded, packets):
                if fields["kind"] == CREATE:
                    ipc.create_image(fields["name"], fields["width"], fields["height"], fields["channels"],
                                     grab_focus=fields["focus"])
                else:
                    shape = fields["height"], fields["width"], len(fields["channels"])
                    tile = numpy.array(fields["values"], dtype=numpy.float32).T.reshape(shape)
                    ipc.update_image(fields["name"], tile, fields["channels"], fields["x"], fields["y"],
                                     grab_focus=fields["focus"], perform_tiling=False)
        theirs.wait_for(lambda: theirs.ended)
        self.assertEqual({packet[4] for packet in packets}, {CREATE, UPDATE})
        self.assertGreater(len(packets), 4)
        self.assertTrue(packets_of(theirs.received[0]) == packets)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("drc", type=pathlib.Path)
    parser.add_argument("tests", nargs="*", default=["Viewers", "Tevclient"],
                        help="names of classes or of single tests, as Viewers.test_never_reads")
    args = parser.parse_args()
    if args.tests == ["Tevclient"]:
        try:
            import tevclient  # noqa: F401
        except ImportError:
            print("tev_display_test: there is no tevclient (pip install tevclient); skipped")
            return SKIPPED
    RenderTest.drc = args.drc.resolve(strict=True)
    tests = unittest.defaultTestLoader.loadTestsFromNames(args.tests, sys.modules[__name__])
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
