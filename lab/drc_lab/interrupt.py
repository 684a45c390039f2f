"""Interrupts: the first Ctrl-C asks to finish and keep what is done, the second ends the process at once."""

import os
import signal

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Cancel:
    """Raised once by a signal, or by whoever holds it; never lowered."""

    def __init__(self) -> None:
        self.signal = 0
        self.cancelled = False

    def cancel(self) -> None:
        self.cancelled = True

    def install(self) -> None:
        """From now on the first of the signals raises this. One that was ignored at the start stays ignored."""
        for number in _SIGNALS:
            if signal.getsignal(number) != signal.SIG_IGN:
                signal.signal(number, self._handle)

    def _handle(self, number: int, _frame: object) -> None:
        if self.cancelled:
            # A further SIGTERM or SIGHUP does nothing, because one request may send them twice.
            if number == signal.SIGINT:
                os._exit(128 + number)
            return
        self.signal = number
        self.cancelled = True
        asked = "interrupted, finishing; interrupt again to stop at once" if number == signal.SIGINT else ""
        os.write(2, f"\ndrc: {asked or 'asked to end, finishing'}\n".encode())
