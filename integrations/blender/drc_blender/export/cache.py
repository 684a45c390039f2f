"""Files named by what they are made from: those that are there already are not written again."""

import hashlib
import os

VERSION = b"2"  # of what this add-on makes of the same input; a new one makes all files anew


def digest(*parts):
    """A name for numpy arrays, bytes and whatever has a repr."""
    sum_ = hashlib.blake2b(VERSION, digest_size=16)
    for part in parts:
        if hasattr(part, "dtype"):
            sum_.update(f"{part.dtype}{part.shape}".encode())
            sum_.update(part.data if part.flags.c_contiguous else part.tobytes())
        else:
            data = part if isinstance(part, bytes) else repr(part).encode()
            sum_.update(f"{len(data)}:".encode())
            sum_.update(data)
    return sum_.hexdigest()


class FileCache:
    """A folder of such files, beside the scene file."""

    def __init__(self, folder, name):
        self.folder, self.name = folder, name
        self.used, self.written = set(), 0
        os.makedirs(os.path.join(folder, name), exist_ok=True)

    def file(self, key, extension, make):
        """The file's path relative to the scene file; make() gives the bytes if there is no such file yet."""
        relative = f"{self.name}/{key}.{extension}"
        self.used.add(f"{key}.{extension}")
        path = os.path.join(self.folder, relative)
        if not os.path.exists(path):
            data = make()
            partial = f"{path}.{os.getpid()}.partial"
            try:
                with open(partial, "wb") as f:
                    f.write(data)
                os.replace(partial, path)
            except OSError:
                if os.path.exists(partial):
                    os.remove(partial)
                raise
            self.written += 1
        return relative

    def has(self, key, extension):
        return os.path.exists(os.path.join(self.folder, self.name, f"{key}.{extension}"))

    def remove_unused(self):
        """Removes the files that no call of file() has asked for."""
        folder = os.path.join(self.folder, self.name)
        for name in os.listdir(folder):
            if name not in self.used:
                os.remove(os.path.join(folder, name))
