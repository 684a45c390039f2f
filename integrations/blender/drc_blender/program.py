"""The renderer as a child process: where its program is, how it is started, what it says, how it ends."""

import os
import shutil
import signal
import subprocess
import sys
import threading
import time

NAME = "drc.exe" if os.name == "nt" else "drc"
GRACE = 3.0  # seconds that an interrupted renderer has to end by itself


class UserError(Exception):
    """One line for the user: what is wrong, and what would be right."""


def find_program(chosen=""):
    """The path that the user has chosen, or a program in PATH, or that of the checkout that this file is in."""
    if chosen:
        path = os.path.expanduser(chosen)
        if os.path.isdir(path):
            path = os.path.join(path, NAME)
        if not os.path.isfile(path):
            raise UserError(f"there is no program {path}: choose that of DRC in the add-on's preferences")
        if not os.access(path, os.X_OK):
            raise UserError(f"{path} cannot be executed: choose DRC's program in the add-on's preferences")
        return path
    found = shutil.which("drc")
    if found:
        return found
    checkout = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *[os.pardir] * 3))
    built = os.path.join(checkout, "build", "release", NAME)
    if os.access(built, os.X_OK):
        return built
    raise UserError("the program drc was not found in PATH: choose it in the preferences of the add-on DRC")


def ends_with_us():
    """What is put before a command so that the program ends if Blender crashes or is killed: on Linux the kernel sees to
    it, at the wish of setpriv of util-linux. The kernel looks at the thread that has started the program, so that one
    has to stay until the program's end."""
    setpriv = shutil.which("setpriv") if sys.platform == "linux" else None
    return [setpriv, "--pdeathsig", "KILL", "--"] if setpriv else []


class Child:
    """A running renderer. Its messages are read on a thread, so that it never waits for a reader."""

    MOST_LINES = 200

    def __init__(self, command, keep_output=False, asks=False):
        """asks: whether ask() will be called."""
        # A group of its own: Ctrl-C in Blender's console is Blender's.
        options = (
            {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP} if os.name == "nt" else {"start_new_session": True}
        )
        if shutil.which(command[0]) is None:
            raise UserError(f"cannot start {command[0]}: there is no such program")
        try:
            self.process = subprocess.Popen(
                [*ends_with_us(), *command],
                stdin=subprocess.PIPE if asks else subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                text=True,
                errors="replace",
                stdout=subprocess.PIPE if keep_output else subprocess.DEVNULL,
                **options,
            )
        except OSError as error:
            raise UserError(f"cannot start {command[0]}: {error.strerror or error}") from error
        self.lines, self.output = [], []
        self._threads = [self._reader(self.process.stderr, self.lines)]
        if keep_output:
            self._threads.append(self._reader(self.process.stdout, self.output))

    def _reader(self, stream, lines):
        def read():
            with stream:
                for line in stream:
                    lines.append(line.rstrip("\n"))
                    del lines[: -self.MOST_LINES]

        thread = threading.Thread(target=read, name="drc messages", daemon=True)
        thread.start()
        return thread

    def ask(self, line):
        """Writes a line to its standard input. If it has ended, nothing happens."""
        try:
            self.process.stdin.write(line + "\n")
            self.process.stdin.flush()
        except OSError:
            pass

    def running(self):
        return self.process.poll() is None

    def has_ended(self, within):
        """Whether it ends within so many seconds. The connections of a program that is killed break before it has
        ended."""
        try:
            self.process.wait(timeout=within)
        except subprocess.TimeoutExpired:
            return False
        return True

    def finish(self):
        """After its end: the exit status, with all messages read."""
        if self.process.stdin is not None:
            try:
                self.process.stdin.close()
            except OSError:
                pass
        status = self.process.wait()
        for thread in self._threads:
            thread.join(timeout=2)
        return status

    def stop(self, grace=GRACE):
        """Interrupts it as Ctrl-C would, and ends it if it does not end."""
        if self.running():
            try:
                self.process.send_signal(signal.CTRL_BREAK_EVENT if os.name == "nt" else signal.SIGINT)
            except OSError:
                pass
            end = time.monotonic() + grace
            while self.running() and time.monotonic() < end:
                time.sleep(0.02)
            if self.running():
                self.process.kill()
        return self.finish()

    def warnings(self):
        return [line.removeprefix("drc: warning: ") for line in self.lines if line.startswith("drc: warning: ")]

    def failure(self):
        """One line that says why it ended, of a status other than zero."""
        status = self.process.returncode
        errors = [line for line in self.lines if line.startswith("drc: error: ")]
        if errors:
            return errors[-1].removeprefix("drc: error: ")
        if status is not None and status < 0:
            try:
                name = signal.Signals(-status).name
            except ValueError:
                name = f"signal {-status}"
            return (
                f"the renderer was ended from outside ({name})"
                if name in ("SIGKILL", "SIGTERM", "SIGINT")
                else f"the renderer crashed ({name})"
            )
        said = [line for line in self.lines if line.strip()]
        return said[-1] if said else f"the renderer ended with status {status}"
