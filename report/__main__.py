# SPDX-License-Identifier: MIT
"""scripts/report BUNDLE [--comparison DIR] [--out DIR] [--summary]: renders tables, figures and pages from a bundle alone."""

import argparse
import importlib.util
import sys
from pathlib import Path

from .bundle import Bundle, BundleError
from .findings.roster import find_all

FINE, USAGE, ENVIRONMENT, INPUT, INTERRUPTED = 0, 2, 3, 4, 130
PACKAGES = {"matplotlib": "python3-matplotlib", "jinja2": "python3-jinja2"}


class _Arguments(argparse.ArgumentParser):
    """One line where argparse would print two."""

    def error(self, message):
        print(f"report: {message}; usage: scripts/report BUNDLE [--comparison DIR] [--out DIR] [--summary]", file=sys.stderr)
        sys.exit(USAGE)


def _parse(arguments):
    parser = _Arguments(prog="report", allow_abbrev=False, description="Renders tables, figures and pages from a bundle alone.")
    parser.add_argument("bundle", metavar="BUNDLE", type=Path, help="the directory that `bezierbench run --out` wrote")
    parser.add_argument("--comparison", metavar="DIR", type=Path, help="the directory that `bezierbench compare --out` wrote")
    parser.add_argument("--out", metavar="DIR", type=Path, help="where to write; default: BUNDLE-report beside the bundle")
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
    from .inline import to_plain
    chapters, left_out = build_all(bundle, find_all(bundle))
    files = render.files(bundle, chapters, left_out)
    try:
        output.write(out, files)
    except OSError as error:
        raise BundleError(f"{error.filename or out}: {error.strerror}; choose another place with --out or make room") from None
    for title, lack in left_out:
        print(f"report: left out '{title}': {to_plain(lack)}", file=sys.stderr)
    kinds = {suffix: sum(name.endswith(suffix) and "/" in name for name in files) for suffix in (".csv", ".tex", ".svg", ".png")}
    print(f"report: wrote {out / 'report.html'} and report.md, tables ({kinds['.csv']} as CSV and LaTeX) and figures "
          f"({kinds['.svg']} as SVG and PNG) beside them")


def main(arguments=None):
    """Returns the exit code of the contract."""
    chosen = _parse(arguments)
    lacking = [] if chosen.summary else [p for module, p in PACKAGES.items() if importlib.util.find_spec(module) is None]
    if lacking:
        print(f"report: missing for {sys.executable}: install the Debian packages {' '.join(PACKAGES.values())}",
              file=sys.stderr)
        return ENVIRONMENT
    try:
        bundle = Bundle(chosen.bundle, chosen.comparison)
        if chosen.summary:
            from . import summary
            sys.stdout.write(summary.text(bundle, find_all(bundle)))
        else:
            _render(bundle, chosen.out)
        sys.stdout.flush()
    except BundleError as error:
        print(f"report: {error}", file=sys.stderr)
        return INPUT
    except BrokenPipeError:
        sys.stderr.close()
        return FINE
    except KeyboardInterrupt:
        print("report: interrupted; nothing half-written, run it again", file=sys.stderr)
        return INTERRUPTED
    return FINE


if __name__ == "__main__":
    sys.exit(main())
