"""The renderer of F12. That of an animation is one process for all frames: where they differ in the camera alone, it keeps
the scene and what it has learnt of it."""

import os
import tempfile
import time

from .program import Child, UserError
from .tev_receiver import TevReceiver

NEXT_FRAMES = ("--frames", "-")  # further frames are read from standard input


class FrameRenderer:
    """Renders one frame after the other: begin(), then poll until is_there(), then finish()."""

    _kept = None  # between the frames of an animation

    def __init__(self, command_for, key):
        """command_for(scene file, output, viewer): the renderer's command line. key: of renderers that are alike."""
        self._command_for, self.key = command_for, key
        self.receiver = TevReceiver()
        self._child = self._folder = self._output = None

    @classmethod
    def of_animation(cls, command_for):
        """The renderer that is kept, if it would be started by the same command and is running."""
        key = command_for("", "", "")
        kept, cls._kept = cls._kept, None
        if kept is not None and kept.key == key and kept.running():
            return kept
        if kept is not None:
            kept.close()
        return cls(command_for, key)

    @classmethod
    def end_animation(cls, *_):
        kept, cls._kept = cls._kept, None
        if kept is not None:
            kept.close()

    def keep(self):
        FrameRenderer._kept = self

    def begin(self, scene_file, more):
        """more: whether there will be further frames."""
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="picture-", dir=os.path.dirname(scene_file))
        self._output = os.path.join(self._folder.name, f"{time.monotonic_ns()}.exr")
        if self._child is None:
            command = self._command_for(scene_file, self._output, self.receiver.address)
            self._child = Child(command + list(NEXT_FRAMES), keep_output=True, asks=True) if more else Child(command)
        else:
            self._child.lines.clear()
            self.receiver.forget()
            self._child.ask(f"{scene_file}\t{self._output}")

    def running(self):
        return self._child is not None and self._child.running()

    def is_there(self):
        """Whether the frame's picture is there. Raises UserError if it never will be."""
        if self.running():
            return self._output in self._child.output
        if self._child.finish():
            raise UserError(self._child.failure())
        return True

    def finish(self, seconds):
        """Reads the last picture, for so long at most; returns the renderer's warnings."""
        self.receiver.drain(seconds)
        if os.path.exists(self._output):
            os.remove(self._output)
        return self._child.warnings()

    def close(self, grace=None):
        if self._child is not None:
            self._child.stop() if grace is None else self._child.stop(grace)
        self.receiver.close()
        if self._folder is not None:
            self._folder.cleanup()
