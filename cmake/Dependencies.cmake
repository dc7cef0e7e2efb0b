# SPDX-License-Identifier: MIT
# Every third-party package. Names of the Debian packages stand in scripts/setup.
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW) # Boost's own configuration: CMake 3.30 gave up FindBoost
endif()

# Packages without a CMake configuration of their own.
function(bezierbench_system_library target header)
  add_library(${target} INTERFACE)
  find_path(${target}_INCLUDE ${header} REQUIRED)
  target_include_directories(${target} SYSTEM INTERFACE ${${target}_INCLUDE})
  foreach(name ${ARGN})
    find_library(${target}_${name} ${name} REQUIRED)
    target_link_libraries(${target} INTERFACE ${${target}_${name}})
  endforeach()
endfunction()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
bezierbench_system_library(gmp gmpxx.h gmpxx gmp)
if(NOT BEZIERBENCH_PROGRAM)
  return() # the libraries need no more
endif()
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(nlohmann_json REQUIRED)
find_package(pugixml REQUIRED)
find_package(Freetype REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(benchmark REQUIRED)
find_package(Threads REQUIRED)
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3) # it sees the Python packages that scripts/setup installs; another may be on PATH
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
if(BEZIERBENCH_TESTS)
  find_package(GTest REQUIRED)
endif()

bezierbench_system_library(random123 Random123/philox.h)
bezierbench_system_library(highway hwy/highway.h)
