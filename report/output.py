# SPDX-License-Identifier: MIT
"""Writes files so that nothing is ever half-written: all under a temporary name first, then moved to their places.

Into a new directory all files come at once. In one that has files each is replaced whole, the pages last, so that no page names a
table that is not there; a signal waits until all are in place. What a killed writer left is removed by the next.
"""

import errno
import fcntl
import os
import re
import shutil
import signal
import tempfile
from contextlib import contextmanager
from pathlib import Path

STAGING = ".report-"  # in the names of temporary directories
_NAME = re.compile(r"([a-z]+/)?[A-Za-z0-9][A-Za-z0-9._-]*")
_WAITING = {signal.SIGINT, signal.SIGTERM, signal.SIGHUP}


def write(directory, files):
    """Writes {relative path: bytes}. On any error the directory keeps what it had."""
    for name in files:
        if not _NAME.fullmatch(name):
            raise ValueError(f"{name!r} is no name for a file of a report")
    directory = Path(directory).absolute()
    if not directory.exists():
        directory.parent.mkdir(parents=True, exist_ok=True)
        with _alone(directory.parent):
            if not directory.exists():
                return _create(directory, files)
    with _alone(directory):
        _replace(directory, files)


def _create(directory, files):
    with _staged(directory.parent, f".{directory.name[:100]}{STAGING}", files) as staging:
        staging.chmod(0o777 & ~_umask())
        os.rename(staging, directory)


def _replace(directory, files):
    with _staged(directory, STAGING, files) as staging, _signals_wait():
        for name in sorted(files, key=lambda name: "/" not in name):
            target = directory / name
            target.parent.mkdir(exist_ok=True)
            os.replace(staging / name, target)


@contextmanager
def _staged(place, prefix, files):
    """A temporary directory that holds the files; what a killed process left under such a name is removed before."""
    for left in place.iterdir():
        if left.name.startswith(prefix) and left.is_dir() and not left.is_symlink():
            shutil.rmtree(left, ignore_errors=True)
    staging = Path(tempfile.mkdtemp(prefix=prefix, dir=place))
    try:
        for name, data in files.items():
            path = staging / name
            path.parent.mkdir(exist_ok=True)
            path.write_bytes(data)
        yield staging
    finally:
        shutil.rmtree(staging, ignore_errors=True)


@contextmanager
def _alone(directory):
    """While no other report writes into it: what is temporary then belongs to nobody. A killed process holds no lock."""
    handle = os.open(directory, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX)
        except OSError as error:
            if error.errno not in (errno.ENOLCK, errno.ENOTSUP, errno.EINVAL):  # file systems without locks
                raise
        yield
    finally:
        os.close(handle)


@contextmanager
def _signals_wait():
    before = signal.pthread_sigmask(signal.SIG_BLOCK, _WAITING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _umask():
    """What a directory made in the ordinary way would lack."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
