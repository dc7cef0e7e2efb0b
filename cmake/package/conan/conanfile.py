# SPDX-License-Identifier: MIT
"""The libraries for Conan 2, from a checkout: `conan create cmake/package/conan`."""
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy

ROOT = Path(__file__).resolve().parents[3]


class Bezierbench(ConanFile):
    name = "bezierbench"
    version = "1.0.0"
    license = "MIT"
    description = "Methods for Bezier curves with proved error bounds, and their true points"
    settings = "os", "arch", "compiler", "build_type"
    requires = "eigen/3.4.0", "gmp/6.3.0", "boost/1.84.0"
    default_options = {"boost/*:header_only": True, "gmp/*:enable_cxx": True}
    generators = ("CMakeDeps",)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "core/*", "reference/*"):
            copy(self, pattern, src=str(ROOT), dst=self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BEZIERBENCH_PROGRAM"] = False
        gmp = self.dependencies["gmp"].package_folder
        toolchain.cache_variables["CMAKE_PREFIX_PATH"] = gmp  # GMP is looked for by its files
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="installed")

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The configuration file of the package is the one that users of CMake get.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/bezierbench"]
