"""Faults that the user can mend. Each is one line: what is wrong, and what would be right."""

USAGE_EXIT_STATUS = 64  # EX_USAGE of sysexits.h


class Error(Exception):
    """A fault in a file or of the machine."""


class UsageError(Error):
    """A command line that cannot be meant."""


def reason_of(error: OSError) -> str:
    return error.strerror or str(error)
