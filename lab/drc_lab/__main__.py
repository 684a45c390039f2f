"""python3 -m drc_lab bench ... | evaluate-page REPORT.json ... | check

`drc bench` and `drc evaluate --html` start these commands.
"""

import sys

from . import log
from .errors import USAGE_EXIT_STATUS, Error, UsageError
from .requirements import require_modules


def _run(name: str, words: list[str]) -> int:
    if name == "bench":
        from .bench_command import bench

        return bench(words)
    if name == "evaluate-page":
        from .evaluation_command import evaluate_page

        return evaluate_page(words)
    if name == "check":
        require_modules()
        return 0
    raise UsageError(f"the laboratory has no command '{name}'; it has bench, evaluate-page and check")


def main(words: list[str]) -> int:
    try:
        return _run(words[0] if words else "", words[1:])
    except UsageError as error:
        log.error(str(error))
        return USAGE_EXIT_STATUS
    except Error as error:
        log.error(str(error))
        return 1
    except MemoryError:
        log.error("out of memory")
        return 1
    except BrokenPipeError:  # whoever read the table has gone
        return 1
    except OSError as error:
        log.error(f"{error.filename or 'the system'}: {error.strerror}")
        return 1
    except KeyboardInterrupt:  # before the interrupt handler was there: nothing has been written
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
