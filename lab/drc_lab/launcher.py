"""Starts one program, waits for its end and reports what it used. Usage: launcher.py FD PROGRAM ...

The system counts the memory of the process that a program is started from as the program's own peak. The bench reads
pictures and draws plots, and is larger than many renders; this script imports next to nothing and stays at some 10 MB.
It writes lines of JSON to the descriptor FD: {"pid"} or {"errno"} at the start, then {"seconds", "cpu_seconds",
"peak_mb", "status"}.
"""

import json
import os
import sys
import time


def main() -> None:
    report, command = int(sys.argv[1]), sys.argv[2:]
    os.set_inheritable(report, False)
    failed, tell_failure = os.pipe()  # closed by a successful start
    begin = time.monotonic()
    pid = os.fork()
    if pid == 0:
        os.setpgid(0, 0)
        try:
            os.execvp(command[0], command)
        except OSError as error:
            os.write(tell_failure, str(error.errno).encode())
        os._exit(127)
    try:
        os.setpgid(pid, pid)  # here as well: whoever comes first
    except OSError:
        pass  # it runs another program already, and so has its group
    os.close(tell_failure)
    if reason := os.read(failed, 32):
        os.waitpid(pid, 0)
        os.write(report, json.dumps({"errno": int(reason)}).encode() + b"\n")
        return
    os.write(report, json.dumps({"pid": pid}).encode() + b"\n")
    _, status, usage = os.wait4(pid, 0)
    use = {
        "seconds": time.monotonic() - begin,
        "cpu_seconds": usage.ru_utime + usage.ru_stime,
        "peak_mb": usage.ru_maxrss * 1024e-6,
        "status": os.waitstatus_to_exitcode(status),
    }
    os.write(report, json.dumps(use).encode() + b"\n")


if __name__ == "__main__":
    main()
