# SPDX-License-Identifier: MIT
"""Nothing in the current folder, in a bundle or in the environment is run."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from . import fixture

ROOT = Path(__file__).resolve().parent.parent
TRAPPED = "import pathlib\npathlib.Path(__file__).with_suffix('.trapped').touch()\n"
TRAPS = ("report", "tomllib", "csv", "json", "argparse", "matplotlib", "jinja2", "sitecustomize", "usercustomize", "isolated")


def _lay_traps(folder):
    """Modules that say so when they run, and settings that would change every figure."""
    for name in TRAPS:
        (folder / f"{name}.py").write_text(TRAPPED)
    (folder / "matplotlibrc").write_text("font.size: 40\nno such key: 1\n")


class Isolation(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def files(self, folder):
        return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def render(self, script, bundle, **more):
        done = subprocess.run([script, bundle, "--out", self.place / "out"], capture_output=True, text=True, check=False, **more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rendered = self.files(self.place / "out")
        shutil.rmtree(self.place / "out")
        return rendered

    def test_the_current_folder_and_the_environment_run_nothing(self):
        bundle = fixture.write(self.place / "bundle", without=[f for f in fixture.FILES if f != "scorecard.csv"])
        plain = self.render(ROOT / "scripts/report", bundle, cwd=self.place)
        _lay_traps(bundle)
        trapped = self.render(ROOT / "scripts/report", bundle, cwd=bundle, env={**os.environ, "PYTHONPATH": f":.:{bundle}"})
        self.assertEqual([p.name for p in bundle.glob("*.trapped")], [])
        self.assertEqual(trapped, plain)

    def test_every_script_starts_python_isolated(self):
        """A file run by its path has its own folder first on the module path; -c, -m and standard input have the current one."""
        starts = re.compile(r"(?:python3?\b\"?|_PYTHON\}|_EXECUTABLE\})\s+(-\S*|\")")
        texts = [path for folder in ("scripts", "report", "experiments", "core", "cmake", ".ci") for path in (ROOT / folder).rglob("*")
                 if path.is_file() and (path.name == "CMakeLists.txt" or path.suffix in (".cmake", ".sbatch", ""))]
        self.assertGreater(len(texts), 20)
        loose, found = [], 0
        for path in texts:
            for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                for start in starts.finditer(line):
                    found += 1
                    if not re.fullmatch(r"-I|-[BEs]*E[BEs]*", start[1]):
                        loose.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
        self.assertGreater(found, 8)
        self.assertEqual(loose, [])


if __name__ == "__main__":
    unittest.main()
