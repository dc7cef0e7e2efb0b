# SPDX-License-Identifier: MIT
"""installed_test.py BUILD LIBRARY: the components c and python, installed under a prefix, work from there and leave nothing
else; so does the wheel with LIBRARY inside, in a fresh virtual environment."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD, LIBRARY = sys.argv[-2:]
del sys.argv[-2:]
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("BEZIERBENCH_LIBRARY", "PYTHONPATH")}
FILES = ["include/bezierbench/bezierbench.h", "lib/libbezierbench.so", "lib/libbezierbench.so.1",
         "lib/cmake/bezierbench/bezierbench-c-targets.cmake", "lib/pkgconfig/bezierbench-c.pc",
         "lib/python3/dist-packages/bezierbench/__init__.py", "lib/python3/dist-packages/bezierbench/py.typed"]
# Prints the versions and the files that the process has loaded.
INSIDE = """
import importlib.metadata, pathlib, re
import bezierbench
print(bezierbench.__version__, importlib.metadata.version("bezierbench"))
print(*re.findall("/.*", pathlib.Path("/proc/self/maps").read_text()), sep="\\n")
"""


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command[0]} ends with {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="bezierbench-installed-")
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.prefix = Path(cls.scratch.name).resolve() / "a prefix"
        for component in ("c", "python"):
            run("cmake", "--install", BUILD, "--prefix", cls.prefix, "--component", component)

    def test_files(self):
        for name in FILES:
            self.assertTrue((self.prefix / name).exists(), name)
        self.assertEqual([path for path in self.prefix.rglob("*") if "test" in path.name or path.suffix == ".pyc"], [])

    def test_python(self):
        package = self.prefix / "lib/python3/dist-packages"
        run(sys.executable, "-sB", HERE / "bezierbench_test.py", package, env=ENVIRONMENT)
        code = "import bezierbench._library as it; print(it.library._name)"
        found = run(sys.executable, "-sBc", code, env=dict(ENVIRONMENT, PYTHONPATH=str(package)))
        self.assertEqual(Path(found.strip()).parent, self.prefix / "lib")

    def test_wheel(self):
        folder = Path(self.scratch.name)
        wheel = run(sys.executable, "-sB", HERE / "wheel_of_package.py", LIBRARY, "7.8.9", folder / "wheel").strip()
        run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")  # NumPy is the system's
        python = folder / "venv/bin/python"
        run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel, env=ENVIRONMENT)
        said = run(python, "-Ic", INSIDE, env=ENVIRONMENT, cwd=folder).split()
        package = next(folder.glob("venv/lib*/python3*/site-packages/bezierbench")).resolve()
        self.assertEqual(said[:2], ["1.0.0", "7.8.9"])  # what the library says, and what pip was told
        loaded = {Path(path) for path in said[2:]}
        from_elsewhere = {path.name.split(".so")[0] for path in loaded if path.parent != package}  # those that Python uses itself
        self.assertEqual({path for path in loaded if path.parent == package},
                         {path for path in package.glob("*.so*") if path.name.split(".so")[0] not in from_elsewhere})
        self.assertIn(package / "libgmp.so.10", loaded)
        self.assertTrue((package / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
