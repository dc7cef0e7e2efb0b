#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The recipes for Conan and vcpkg name the version and the packages of the CMake files, and files that are there.

Neither tool is required, and neither recipe is run.
"""
import json
import re
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# What cmake/Dependencies.cmake looks for before the program's own packages, as each recipe calls it.
CONAN = {"Eigen3": "eigen", "Boost": "boost", "gmp": "gmp"}
VCPKG = {"Eigen3": "eigen3", "Boost": "boost-multiprecision", "gmp": "gmp"}


class Recipes(unittest.TestCase):
    def setUp(self):
        self.version = re.search(r"project\(\w+ VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        needs = (ROOT / "cmake/Dependencies.cmake").read_text(encoding="utf-8").split("if(NOT BEZIERBENCH_PROGRAM)")[0]
        self.needs = set(re.findall(r"^(?:find_package|bezierbench_system_library)\((\w+)", needs, re.MULTILINE))

    def test_conan(self):
        recipe = (HERE / "conan/conanfile.py").read_text(encoding="utf-8")
        words = {name: re.findall(r'"([^"]+)"', line) for name, line in re.findall(r"^    (\w+) = (.*)", recipe, re.MULTILINE)}
        self.assertEqual((words["name"], words["version"]), (["bezierbench"], [self.version]))
        self.assertEqual({name.split("/")[0] for name in words["requires"]}, {CONAN[need] for need in self.needs})
        for pattern in re.findall(r'"([^"]+)"', re.search(r"for pattern in \((.*)\)", recipe)[1]):
            self.assertTrue(list(ROOT.glob(pattern)), pattern)

    def test_vcpkg(self):
        manifest = json.loads((HERE / "vcpkg/vcpkg.json").read_text(encoding="utf-8"))
        self.assertEqual((manifest["name"], manifest["version"]), ("bezierbench", self.version))
        self.assertEqual({name for name in manifest["dependencies"] if isinstance(name, str)}, {VCPKG[need] for need in self.needs})


if __name__ == "__main__":
    unittest.main()
