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

UNFIT = 3  # the exit code of an unfit environment
STEP = 5  # seconds between two readings; the kernel takes one in five


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most", type=float, required=True)
    parser.add_argument("--wait", type=float, default=0)
    given = parser.parse_args()
    end = time.monotonic() + given.wait
    while (load := os.getloadavg()[0] / len(os.sched_getaffinity(0))) > given.most:
        if time.monotonic() >= end:
            print(f"load: load average of {load:.2f} for each processor over the last minute, more than {given.most:g}; "
                  "other processes are running", file=sys.stderr)
            sys.exit(UNFIT)
        time.sleep(STEP)


if __name__ == "__main__":
    main()
