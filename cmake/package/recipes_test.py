#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""recipes_test.py [--build]: the recipes for Conan and vcpkg against the CMake files.

Neither tool is required: stand-ins for what the recipes call do as its documentation says, with the packages of this machine.
So the recipes run to their end, on the files that they take along, and a project finds what they install; whether Conan
and vcpkg have the packages that they name is not tried. Without --build nothing is compiled: every source must be there,
and the configuration files that the build would install.
"""
import fnmatch
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COMPILES = "--build" in sys.argv
# What cmake/Dependencies.cmake looks for before the program's own packages, as each recipe calls it.
CONAN = {"Eigen3": "eigen", "Boost": "boost", "gmp": "gmp"}
VCPKG = {"Eigen3": "eigen3", "Boost": "boost-multiprecision", "gmp": "gmp"}
USER = """cmake_minimum_required(VERSION 3.22)
project(user CXX)
find_package(bezierbench 1 CONFIG REQUIRED COMPONENTS methods reference)
"""
VCPKG_FUNCTIONS = """
function(vcpkg_cmake_configure)
  cmake_parse_arguments(A "" "SOURCE_PATH" "OPTIONS" ${ARGN})
  execute_process(COMMAND ${CMAKE_COMMAND} -G Ninja -S ${A_SOURCE_PATH} -B ${BUILD} -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}
                          -DCMAKE_BUILD_TYPE=Release ${A_OPTIONS} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_build)
  cmake_parse_arguments(A "" "TARGET" "" ${ARGN})
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${A_TARGET} -- ${NINJA} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_install)
  if(NOT NINJA)
    execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(A "" "PACKAGE_NAME;CONFIG_PATH" "" ${ARGN})
  if(NOT NINJA AND NOT EXISTS ${CURRENT_PACKAGES_DIR}/${A_CONFIG_PATH}/${A_PACKAGE_NAME}-config.cmake)
    message(FATAL_ERROR "no configuration file in ${A_CONFIG_PATH}")
  endif()
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(A "" "" "FILE_LIST" ${ARGN})
  file(COPY ${A_FILE_LIST} DESTINATION ${CURRENT_PACKAGES_DIR}/share)
endfunction()
"""


def run(*command):
    done = subprocess.run([str(word) for word in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command[0]} ends with {done.returncode}\n{done.stdout}")
    return done.stdout


def conan_modules(folder):
    """Modules as conan's, whose recipes build in `folder`."""
    ninja = [] if COMPILES else ["-n"]

    class CMakeToolchain:
        def __init__(self, recipe):
            self.recipe, self.cache_variables = recipe, {}

        def generate(self):
            self.recipe.given = [f"-D{key}={'OFF' if value is False else value}" for key, value in self.cache_variables.items()]

    class CMake:
        def __init__(self, recipe):
            self.recipe = recipe

        def configure(self):
            run("cmake", "-G", "Ninja", "-S", folder / "export", "-B", folder / "build", "-DCMAKE_BUILD_TYPE=Release",
                f"-DCMAKE_INSTALL_PREFIX={folder / 'prefix'}", *self.recipe.given)

        def build(self, target):
            run("cmake", "--build", folder / "build", "--target", target, "--", *ninja)

        def install(self):
            if COMPILES:
                run("cmake", "--install", folder / "build")

    class ConanFile:
        export_sources_folder = folder / "export"
        dependencies = {"gmp": types.SimpleNamespace(package_folder="/usr")}
        cpp_info = types.SimpleNamespace(set_property=lambda *_: None)

    def copy(_recipe, pattern, src, dst):
        for file in Path(src).rglob("*"):
            name = file.relative_to(src).as_posix()
            if fnmatch.fnmatch(name, pattern) and file.is_file():
                (Path(dst) / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, Path(dst) / name)

    cmake = types.SimpleNamespace(CMake=CMake, CMakeToolchain=CMakeToolchain, cmake_layout=lambda _: None)
    return {"conan": types.SimpleNamespace(ConanFile=ConanFile), "conan.tools": types.SimpleNamespace(),
            "conan.tools.cmake": cmake, "conan.tools.files": types.SimpleNamespace(copy=copy)}


class Recipes(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="bezierbench-recipes-"))
        self.addCleanup(shutil.rmtree, self.folder)
        self.cmake = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        self.version = re.search(r"project\(\w+ VERSION (\S+)", self.cmake)[1]
        needs = (ROOT / "cmake/Dependencies.cmake").read_text(encoding="utf-8").split("if(NOT BEZIERBENCH_PROGRAM)")[0]
        self.needs = set(re.findall(r"^(?:find_package|bezierbench_system_library)\((\w+)", needs, re.MULTILINE))

    def assert_found(self, prefix):
        if not COMPILES:
            return
        (self.folder / "user").mkdir()
        (self.folder / "user/CMakeLists.txt").write_text(USER, encoding="utf-8")
        run("cmake", "-G", "Ninja", "-S", self.folder / "user", "-B", self.folder / "user/build", f"-DCMAKE_PREFIX_PATH={prefix}")

    def test_conan(self):
        modules = conan_modules(self.folder)
        sys.modules.update(modules)
        self.addCleanup(lambda: [sys.modules.pop(name) for name in modules])
        spec = importlib.util.spec_from_file_location("conanfile", HERE / "conan/conanfile.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        recipe = module.Bezierbench()
        self.assertEqual((recipe.name, recipe.version), ("bezierbench", self.version))
        self.assertEqual({name.split("/")[0] for name in recipe.requires}, {CONAN[need] for need in self.needs})
        for step in (recipe.export_sources, recipe.layout, recipe.generate, recipe.build, recipe.package, recipe.package_info):
            step()
        for folder in recipe.cpp_info.builddirs:
            self.assertTrue(not COMPILES or (self.folder / "prefix" / folder / "bezierbench-config.cmake").exists())
        self.assert_found(self.folder / "prefix")

    def test_vcpkg(self):
        manifest = json.loads((HERE / "vcpkg/vcpkg.json").read_text(encoding="utf-8"))
        self.assertEqual((manifest["name"], manifest["version"]), ("bezierbench", self.version))
        named = {name for name in manifest["dependencies"] if isinstance(name, str)}
        self.assertEqual(named, {VCPKG[need] for need in self.needs})
        prefix = self.folder / "prefix"
        (self.folder / "port.cmake").write_text(f"{VCPKG_FUNCTIONS}\ninclude({HERE}/vcpkg/portfile.cmake)\n", encoding="utf-8")
        run("cmake", f"-DBUILD={self.folder / 'build'}", f"-DCURRENT_PACKAGES_DIR={prefix}", f"-DNINJA={'' if COMPILES else '-n'}",
            "-P", self.folder / "port.cmake")
        self.assertTrue((prefix / "share/LICENSE").exists())
        self.assert_found(prefix)


if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "--build"])
