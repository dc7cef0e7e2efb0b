# SPDX-License-Identifier: MIT
"""Reading the files of a folder that somebody else may have made: regular files of a bounded size, and no links."""

import errno
import os
import stat

LARGEST = 64 << 20  # bytes; the tables of the shipped suites are smaller by a factor of ten


class Refused(OSError):
    """The file is there and is not read; `strerror` says why and what to do."""


def _refuse(path, why):
    raise Refused(errno.EINVAL, why, str(path))


def read(path):
    """The bytes of the file. FileNotFoundError where there is none; another OSError where it cannot or must not be read.

    A pipe would be waited for, a device has no end, and a link may lead to what the bundle's reader can see and its writer
    cannot.
    """
    try:
        # O_NONBLOCK: opening a pipe that nobody writes to returns at once.
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError as error:
        if error.errno in (errno.ELOOP, errno.EMLINK):
            _refuse(path, "is a link, which is not followed; put the file itself there")
        raise
    try:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            _refuse(path, "is no regular file; put the file that was written there")
        data = _bounded(handle) if status.st_size <= LARGEST else None
    finally:
        os.close(handle)
    if data is None:
        _refuse(path, f"is larger than {LARGEST >> 20} MiB, which is all that a report reads; run fewer studies into one bundle")
    return data


def _bounded(handle):
    """All bytes; None where there are too many, whatever the size was said to be."""
    with open(handle, "rb", closefd=False) as file:
        data = file.read(LARGEST + 1)
    return data if len(data) <= LARGEST else None
