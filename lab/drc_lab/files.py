"""Files that are written whole or not at all, and what tells that a file was changed."""

import os
import tempfile
from pathlib import Path

from .errors import Error, reason_of

# Records of earlier versions have file times by a clock that starts in the year 2174. Its numbers are kept, so that
# their pictures and references are found again.
_FILE_CLOCK_EPOCH = 6437664000 * 10**9


def write_whole(path: Path, data: "bytes | str") -> None:
    """Writes a temporary file beside the target and renames it: a crash or a full disk leaves the old file."""
    content = data.encode("utf-8") if isinstance(data, str) else data
    target = Path(os.path.realpath(path))
    temporary = None
    try:
        if target.exists() and not target.is_file():
            target.write_bytes(content)  # a pipe or a device cannot be replaced
            return
        mode = target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_umask()
        # Hidden, and without the target's extension, so that no "*.exr" picks up a half-written file.
        handle, temporary = tempfile.mkstemp(prefix=f".{target.name[:200]}.", suffix=".tmp", dir=target.parent)
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(temporary, mode)
        os.replace(temporary, target)
    except OSError as error:
        raise Error(f"cannot write {path}: {reason_of(error)}") from None
    finally:
        if temporary is not None and os.path.exists(temporary):
            os.unlink(temporary)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def check_writable(option: str, path: Path) -> None:
    """Raises Error if the file could not be written: an error before long work is better than one after it."""
    if path.is_dir():
        raise Error(f"{option} {path}: is a folder; name a file")
    if path.exists() and not os.access(path, os.W_OK):
        raise Error(f"{option} {path}: cannot be written: its permissions forbid it")
    folder = path.absolute().parent
    if not folder.is_dir():
        raise Error(f"{option} {path}: there is no folder {path.parent}")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise Error(f"{option} {path}: cannot be written: the permissions of {path.parent} forbid it")


def read_text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise Error(f"cannot read {path}: {reason_of(error)}") from None


def make_folder(path: Path) -> None:
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Error(f"cannot make the folder {path}: {reason_of(error)}") from None


def state_of(path: "str | Path") -> str:
    """The size and time of a file, which tell that it was changed; empty if there is no such file."""
    try:
        stat = os.stat(path)
    except OSError:
        return ""
    return f"{stat.st_size}:{stat.st_mtime_ns - _FILE_CLOCK_EPOCH}"


def file_name(name: str) -> str:
    """The name as a part of a path; different names stay different."""
    safe, hashed = "", 2166136261  # FNV-1a
    for byte in name.encode("utf-8", "surrogateescape"):
        c = chr(byte)
        safe += c if byte < 128 and (c.isalnum() or c in "+-.") else "_"
        hashed = ((hashed ^ byte) * 16777619) & 0xFFFFFFFF
    return safe if safe == name and not name.startswith(".") else f"_{safe}-{hashed:08x}"
