# SPDX-License-Identifier: MIT
"""The playground in headless Chromium against the native program: python3 -I check.py PROGRAM. Exit 77 where Chromium, Node,
playwright-core, axe-core or build/web/bezierbench.wasm is missing, with a line that says so.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2]))
from report.browser.check import SKIPPED, required  # noqa: E402
from report.site.playground import bundle  # noqa: E402


def main(program):
    tools = required()
    if not tools:
        return SKIPPED
    if not bundle.LIBRARY.is_file():
        print("skipped: missing: build/web/bezierbench.wasm (scripts/build web)")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        bundle.write(folder)
        return subprocess.run(["node", str(HERE / "check.mjs"), *tools, folder, program], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
