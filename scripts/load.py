#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Is this machine's load its own? What times that others will compare with are recorded on.

load.py --most L [--wait SECONDS]    exits 3 where the load average of the last minute is above L for each processor, after
                                     waiting as long as SECONDS for it to fall: what ran before leaves a load of its own.

Runs of suites do not ask: a busy machine makes times noisy, says so beside them, and changes no accuracy.
"""
import argparse
import os
import sys
import time
from pathlib import Path

UNFIT = 3  # the exit code of an unfit environment
LOADAVG = Path("/proc/loadavg")
STEP = 5  # seconds between two readings; the kernel takes one in five


def load_per_processor(path=LOADAVG):
    """None where it cannot be read."""
    try:
        return float(path.read_text(encoding="ascii").split()[0]) / len(os.sched_getaffinity(0))
    except (OSError, ValueError, IndexError):
        return None


def fault(most, wait=0, read=load_per_processor, sleep=time.sleep):
    """Why the machine is not quiet; None where it is."""
    waited = 0
    while True:
        load = read()
        if load is None:
            return f"{LOADAVG}: cannot be read, so other processes may be running"
        if load <= most:
            return None
        if waited >= wait:
            return f"load average of {load:.2f} for each processor over the last minute, more than {most:g}; other processes are running"
        sleep(STEP)
        waited += STEP


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most", type=float, required=True)
    parser.add_argument("--wait", type=float, default=0)
    given = parser.parse_args()
    if why := fault(given.most, given.wait):
        print(f"load: {why}", file=sys.stderr)
        sys.exit(UNFIT)


if __name__ == "__main__":
    main()
