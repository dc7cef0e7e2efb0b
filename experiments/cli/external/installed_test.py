#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""installed_test.py PREFIX: the examples of external methods, built and run against what is installed there. Skipped
(code 77) where the program or the harness is not."""
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parents[1] / "examples/cpp/mine.cpp"
PROJECT = f"""cmake_minimum_required(VERSION 3.22)
project(own_method CXX)
find_package(bezierbench 1 CONFIG REQUIRED COMPONENTS harness)
add_executable(mine {EXAMPLE})
target_compile_options(mine PRIVATE -Wall -Wextra -Wconversion -Werror)
target_link_libraries(mine PRIVATE bezierbench::harness)
"""


def main():
    prefix = pathlib.Path(sys.argv[1]).resolve()
    program = prefix / "bin/bezierbench"
    if not program.exists() or not list(prefix.glob("lib/**/bezierbench-harness-targets.cmake")):
        print(f"skipped: {prefix} has no program or no harness")
        return 77
    with tempfile.TemporaryDirectory(prefix="bezierbench-own-") as name:
        folder = pathlib.Path(name)
        (folder / "CMakeLists.txt").write_text(PROJECT, encoding="utf-8")
        subprocess.run(["cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
                        "-DCMAKE_BUILD_TYPE=Release"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", folder / "build"], check=True, stdout=subprocess.DEVNULL)
        return subprocess.run([sys.executable, "-EsB", HERE / "external_test.py", program, "Ways"], check=False,
                              env={**os.environ, "BEZIERBENCH_OWN": str(folder / "build/mine")}).returncode


if __name__ == "__main__":
    sys.exit(main())
