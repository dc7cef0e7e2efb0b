# SPDX-License-Identifier: MIT
# The libraries that experiments/peers compares with. Each is optional: where something of one is missing there is no
# target peer::NAME but the reason in PEER_NAME_MISSING. PEER_NAME_VERSION is what the bundle says of it. PEER_NAME_COPYLEFT
# is the licence that a program takes on by linking it, empty where it keeps its own; docs/peers.md says what that means.

# The version of the Debian package that owns a file: it names the patches, too.
function(bezierbench_debian_version file result)
  set(${result} unknown PARENT_SCOPE)
  execute_process(COMMAND dpkg-query --search ${file} OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE failed)
  if(failed OR NOT owner MATCHES "^([^:]+):")
    return()
  endif()
  execute_process(COMMAND dpkg-query --show --showformat=\${Version} ${CMAKE_MATCH_1} OUTPUT_VARIABLE version ERROR_QUIET)
  if(version)
    set(${result} ${version} PARENT_SCOPE)
  endif()
endfunction()

# bezierbench_peer_library(NAME HEADER [HINTS folder...] [SUFFIXES folder...] [LIBRARIES name...] [COPYLEFT licence])
function(bezierbench_peer_library name header)
  cmake_parse_arguments(PEER "" "COPYLEFT" "HINTS;SUFFIXES;LIBRARIES" ${ARGN})
  set(PEER_${name}_COPYLEFT "${PEER_COPYLEFT}" PARENT_SCOPE)
  find_path(PEER_${name}_INCLUDE ${header} HINTS ${PEER_HINTS} PATH_SUFFIXES ${PEER_SUFFIXES})
  set(missing "")
  if(NOT EXISTS ${PEER_${name}_INCLUDE}/${header}) # nor where it was found once and is gone
    set(missing "header ${header}")
  endif()
  set(libraries "")
  foreach(library ${PEER_LIBRARIES})
    find_library(PEER_${name}_${library} ${library})
    if(EXISTS ${PEER_${name}_${library}})
      list(APPEND libraries ${PEER_${name}_${library}})
    else()
      set(missing "library ${library}")
    endif()
  endforeach()
  set(PEER_${name}_MISSING ${missing} PARENT_SCOPE)
  if(missing)
    return()
  endif()
  add_library(peer_${name} INTERFACE)
  add_library(peer::${name} ALIAS peer_${name})
  target_include_directories(peer_${name} SYSTEM INTERFACE ${PEER_${name}_INCLUDE})
  target_link_libraries(peer_${name} INTERFACE ${libraries})
  bezierbench_debian_version(${PEER_${name}_INCLUDE}/${header} version)
  set(PEER_${name}_VERSION ${version} PARENT_SCOPE)
endfunction()

file(GLOB headers_of_2geom /usr/include/2geom-* /usr/local/include/2geom-*)
bezierbench_peer_library(2geom 2geom/bezier.h HINTS ${headers_of_2geom}
                         LIBRARIES 2geom gsl gslcblas # it integrates with GSL
                         COPYLEFT "GPL-3.0-or-later (of GSL)")
bezierbench_peer_library(occt opencascade/BSplCLib.hxx LIBRARIES TKGeomBase TKG3d TKG2d TKMath TKernel)
bezierbench_peer_library(occt_models opencascade/STEPControl_Reader.hxx LIBRARIES TKSTEP TKIGES TKXSBase TKBRep TKG3d TKMath TKernel)
foreach(part occt occt_models) # its headers include each other by name alone
  if(TARGET peer_${part})
    target_include_directories(peer_${part} SYSTEM INTERFACE ${PEER_${part}_INCLUDE}/opencascade)
  endif()
endforeach()
bezierbench_peer_library(sisl sisl.h LIBRARIES sisl COPYLEFT AGPL-3.0-or-later)
bezierbench_peer_library(gsl gsl/gsl_bspline.h LIBRARIES gsl gslcblas COPYLEFT GPL-3.0-or-later)
bezierbench_peer_library(eigen unsupported/Eigen/Splines SUFFIXES eigen3)

# Boost has bezier_polynomial since 1.78. Where the system's is older, scripts/setup --peers unpacks the headers of a newer
# one here. The program then holds two versions of Boost, so the names of this one begin with another word than `boost`.
set(unpacked_boost ${PROJECT_SOURCE_DIR}/build/debian/libboost1.81-dev/usr/include)
bezierbench_peer_library(boost boost/math/interpolators/bezier_polynomial.hpp HINTS ${unpacked_boost})
if(TARGET peer_boost AND PEER_boost_INCLUDE STREQUAL unpacked_boost)
  target_compile_definitions(peer_boost INTERFACE boost=boost_of_peers)
  file(STRINGS ${unpacked_boost}/boost/version.hpp line REGEX "define BOOST_LIB_VERSION")
  string(REGEX REPLACE "[^0-9]*([0-9]+)_([0-9]+).*" "\\1.\\2" PEER_boost_VERSION "${line}")
endif()
