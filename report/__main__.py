# SPDX-License-Identifier: MIT
"""scripts/report BUNDLE [--comparison DIR] [--out DIR] [--summary]: renders tables, figures and pages from a bundle alone."""

import argparse
import importlib.util
import os
import signal
import sys
from pathlib import Path

from .bundle import Bundle, BundleError, made_of
from .findings.roster import find_all
from .inline import visible

FINE, USAGE, ENVIRONMENT, INPUT, INTERRUPTED = 0, 2, 3, 4, 130
PACKAGES = {"matplotlib": "python3-matplotlib", "jinja2": "python3-jinja2"}
USE = "scripts/report BUNDLE [--comparison DIR] [--out DIR] [--summary]"


def _complain(message):
    print(f"report: {visible(str(message))}", file=sys.stderr)


class _Arguments(argparse.ArgumentParser):
    """One line where argparse would print two."""

    def error(self, message):
        _complain(f"{message}; usage: {USE}")
        sys.exit(USAGE)


def _parse(arguments):
    parser = _Arguments(prog="report", allow_abbrev=False, description="Renders tables, figures and pages from a bundle alone.")
    parser.add_argument("bundle", metavar="BUNDLE", type=Path, help="the directory that `bezierbench run --out` wrote")
    parser.add_argument("--comparison", metavar="DIR", type=Path, help="the directory that `bezierbench compare --out` wrote")
    parser.add_argument("--out", metavar="DIR", type=Path, help="the output directory; default: BUNDLE-report next to the bundle")
    parser.add_argument("--summary", action="store_true", help="print scorecard and findings as plain text, write nothing")
    chosen = parser.parse_args(arguments)
    if chosen.summary and chosen.out:
        parser.error("--summary writes nothing, so --out has no meaning with it")
    whole = chosen.bundle.resolve()
    chosen.out = chosen.out or whole.with_name(whole.name + "-report")
    if chosen.out.resolve() == whole:
        parser.error(f"--out {chosen.out} is the bundle itself; choose another directory")
    return chosen


def _render(bundle, out):
    from . import output, render
    from .chapters.roster import build_all
    chapters, left_out = build_all(bundle, find_all(bundle))
    with made_of(bundle, "the page"):
        files = render.files(bundle, chapters, left_out)
    try:
        output.write(out, files)
    except OSError as error:
        raise BundleError(f"{error.filename or out}: {error.strerror}; choose another place with --out or make room") from None
    kinds = {suffix: sum(name.endswith(suffix) and "/" in name for name in files) for suffix in (".csv", ".svg")}
    without = f"; {len(left_out)} chapters without data are named at the end of the page" if left_out else ""
    print(visible(f"report: wrote {out / 'report.html'} and report.md, tables ({kinds['.csv']} as CSV and LaTeX) and figures "
                  f"({kinds['.svg']} as SVG and PNG) beside them{without}"))


def _run(chosen):
    bundle = Bundle(chosen.bundle, chosen.comparison)
    if chosen.summary:
        from . import summary
        found = find_all(bundle)
        with made_of(bundle, "the summary"):
            print(summary.text(bundle, found), end="")
    else:
        _render(bundle, chosen.out)
    sys.stdout.flush()


def _output_failed(why):
    """The exit code where standard output cannot be written. Its buffer is dropped, so that Python does not write it again at the end."""
    _complain(f"standard output: {why}; free space or choose another place")
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return INPUT


def main(arguments=None):
    """Returns the exit code of the contract."""
    chosen = _parse(arguments)
    if not chosen.summary and any(importlib.util.find_spec(module) is None for module in PACKAGES):
        _complain(f"missing for {sys.executable}: install the Debian packages {' '.join(PACKAGES.values())}")
        return ENVIRONMENT
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    if sys.stdout is None:
        return _output_failed("it is closed")
    try:
        _run(chosen)
    except BundleError as error:
        _complain(error)
        return INPUT
    except BrokenPipeError:
        sys.stderr.close()
        return FINE
    except OSError as error:  # files that cannot be read or written are BundleErrors
        return _output_failed(error.strerror)
    except KeyboardInterrupt:
        _complain("interrupted; nothing half-written, run it again")
        return INTERRUPTED
    return FINE


if __name__ == "__main__":
    sys.exit(main())
