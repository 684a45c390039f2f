"""The number of threads that a program is given if the user names none."""

from __future__ import annotations

import math
import os
from pathlib import Path


def _quota(group: Path) -> float:
    """Cores that a control group of version 2 may use at once."""
    try:
        quota, period = (group / "cpu.max").read_text().split()
        return float(quota) / float(period) if quota != "max" else math.inf
    except (OSError, ValueError, ZeroDivisionError):
        return math.inf


def _quota_v1(group: Path) -> float:
    try:
        quota = float((group / "cpu.cfs_quota_us").read_text())
        period = float((group / "cpu.cfs_period_us").read_text())
        return quota / period if quota > 0 and period > 0 else math.inf
    except (OSError, ValueError):
        return math.inf


def available_cores(groups: Path = Path("/proc/self/cgroup"), mount: Path = Path("/sys/fs/cgroup")) -> int:
    """One for each core that the affinity mask and the control groups give; the groups around our own count as well."""
    least = math.inf
    try:
        lines = groups.read_text().splitlines()
    except OSError:
        lines = []
    for line in lines:
        _, controllers, path = line.split(":", 2)
        if not controllers:
            roots, quota_of = [mount], _quota
        elif "cpu" in controllers.split(","):
            roots, quota_of = [mount / "cpu", mount / controllers], _quota_v1
        else:
            continue
        for root in roots:
            # In a container the path may be that of the host, and the container's own group appears as the root.
            parts = Path(path.lstrip("/")).parts
            least = min([least, *(quota_of(root.joinpath(*parts[:n])) for n in range(len(parts) + 1))])
    most = len(os.sched_getaffinity(0))
    return int(max(1, min(most, math.ceil(least) if math.isfinite(least) else most)))
