"""Measured processes."""

import threading
import time
import unittest
from pathlib import Path

from drc_lab.errors import Error
from drc_lab.interrupt import Cancel
from drc_lab.process import last_line, run_measured


def shell(script, limit=None, cancel=None):
    return run_measured(["sh", "-c", script], limit, cancel)


class MeasuredProcess(unittest.TestCase):
    def test_gives_the_exit_code_and_what_was_written(self):
        use = shell("echo out; echo err >&2; exit 7")
        self.assertEqual(use.exit_code, 7)
        self.assertEqual(use.output, "out\nerr\n")
        self.assertFalse(use.stopped)

    def test_arguments_arrive_as_they_are(self):
        self.assertEqual(run_measured(["printf", "%s|", "a b", "$HOME", ""]).output, "a b|$HOME||")

    def test_nothing_is_read_from_the_terminal(self):
        self.assertEqual(shell("cat; echo end").output, "end\n")

    def test_sleep_takes_wall_clock_and_no_processor(self):
        use = shell("sleep 0.3")
        self.assertGreaterEqual(use.seconds, 0.3)
        self.assertLess(use.cpu_seconds, 0.2)

    def test_work_of_children_counts(self):
        use = shell("sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'; true")
        self.assertGreater(use.cpu_seconds, 0.02)
        self.assertLess(use.cpu_seconds, use.seconds + 0.05)  # one thread

    def test_peak_memory_is_that_of_the_program(self):
        ours = bytearray(300_000_000)  # does not count
        # dd's block is its memory, and is written to.
        small = shell("dd if=/dev/zero of=/dev/null bs=1k count=1 2>&1").peak_mb
        large = shell("dd if=/dev/zero of=/dev/null bs=100M count=1 2>&1").peak_mb
        del ours
        self.assertLess(small, 30)
        self.assertGreater(large, 104.8)
        self.assertLess(large, 115)

    def test_the_limit_ends_whole_groups(self):
        use = shell("sleep 60 & echo $!; sleep 60; true", 0.3)
        self.assertTrue(use.stopped)
        self.assertLess(use.seconds, 30)
        self.assertNotEqual(use.exit_code, 0)
        background = Path("/proc", use.output.strip(), "stat")
        limit = time.monotonic() + 5
        while background.exists() and ") Z " not in background.read_text() and time.monotonic() < limit:
            time.sleep(0.02)
        self.assertLess(time.monotonic(), limit)

    def test_what_ignores_the_request_is_killed(self):
        self.assertEqual(shell("trap '' TERM; while :; do sleep 0.05; done", 0.1).exit_code, 128 + 9)

    def test_can_be_cancelled(self):
        cancel = Cancel()
        threading.Timer(0.1, cancel.cancel).start()
        use = shell("sleep 60", None, cancel)
        self.assertTrue(use.stopped)
        self.assertLess(use.seconds, 30)

    def test_long_output_keeps_its_end(self):
        use = shell("i=0; while [ $i -lt 30000 ]; do echo line $i; i=$((i+1)); done")
        self.assertLessEqual(len(use.output), 1 << 16)
        self.assertEqual(last_line(use.output), "line 29999")

    def test_background_children_that_keep_the_output_open_are_not_waited_for(self):
        begin = time.monotonic()
        shell("sleep 60 & echo $!; exit 0")
        self.assertLess(time.monotonic() - begin, 30)

    def test_unknown_programs_are_an_error(self):
        with self.assertRaisesRegex(Error, "drc-no-such-program: cannot be started: No such file"):
            run_measured(["drc-no-such-program"])
        with self.assertRaises(Error):
            run_measured([])


class LastLine(unittest.TestCase):
    def test_of_blank_ends_and_carriage_returns(self):
        for output, line in (("", ""), (" \n \n", ""), ("one", "one"), ("one\n  two \n\n", "two"),
                             ("10%\r20%\r99% \n", "99%")):  # fmt: skip
            self.assertEqual(last_line(output), line)

    def test_is_the_message_where_text_with_a_caret_follows(self):
        output = 'loading\nroom.pbrt:1:1: no such shape\n    Shape "cube"\n          ^\n'
        self.assertEqual(last_line(output), "room.pbrt:1:1: no such shape")
        self.assertEqual(last_line("one\n^\n"), "^")


if __name__ == "__main__":
    unittest.main()
