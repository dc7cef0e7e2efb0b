# SPDX-License-Identifier: MIT
"""The playground in headless Chromium against the native program: python3 -I check.py PROGRAM. Exit 77 where Chromium, Node,
playwright-core, axe-core or build/web/bezierbench.wasm is missing, with a line that says so.
"""
import importlib.util
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SKIPPED = 77


def _module(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def main(program):
    bundle = _module(HERE / "bundle.py")
    playwright = _module(HERE.parent.parent / "browser/check.py")._playwright()
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    axe = Path(playwright or "", "../axe-core/axe.min.js")
    absent = [name for name, there in (("chromium", chromium), ("node", shutil.which("node")), ("playwright-core", playwright), ("axe-core", axe.is_file()),
                                       ("build/web/bezierbench.wasm (scripts/build web)", bundle.LIBRARY.is_file())) if not there]
    if absent:
        print(f"skipped: missing: {', '.join(absent)}")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        bundle.write(folder)
        return subprocess.run(["node", str(HERE / "check.mjs"), playwright, str(axe), chromium, folder, program], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
