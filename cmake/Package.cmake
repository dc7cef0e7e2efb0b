# SPDX-License-Identifier: MIT
# What `cmake --install` gives to other projects. A component X has its headers under include/bezierbench, its export
# set in lib/cmake/bezierbench/bezierbench-X-targets.cmake with the target bezierbench::X, and bezierbench-X.pc for
# pkg-config; the configuration file includes the export sets of the components that a project asks for.
# cmake/package has the files, and the components methods and reference.
if(NOT CMAKE_INSTALL_LIBDIR)
  set(CMAKE_INSTALL_LIBDIR lib CACHE PATH "where libraries are installed; a Debian package sets its own folder")
endif()
set(BEZIERBENCH_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/bezierbench)
set(BEZIERBENCH_PACKAGE_FILES ${CMAKE_CURRENT_LIST_DIR}/package)

# bezierbench_install_headers(COMPONENT target header...): the headers of the target, named from the root of the repository,
# with their includes as they are found below include/. headers.cmake.in says how. Where a project contains this one, it has
# bezierbench::COMPONENT without an installation: the headers are written when it is configured.
function(bezierbench_install_headers component target)
  set(staged ${PROJECT_BINARY_DIR}/package/${component})
  set(BEZIERBENCH_HEADERS ${ARGN})
  configure_file(${BEZIERBENCH_PACKAGE_FILES}/headers.cmake.in ${staged}.cmake @ONLY)
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:include>)
  if(NOT PROJECT_IS_TOP_LEVEL)
    include(${staged}.cmake)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
    target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${staged}>)
    return()
  endif()
  install(CODE "file(REMOVE_RECURSE \"${staged}\")" COMPONENT ${component})
  install(SCRIPT ${staged}.cmake COMPONENT ${component})
  install(DIRECTORY ${staged}/ DESTINATION include COMPONENT ${component})
endfunction()

# The headers in these folders that users may include.
function(bezierbench_headers_in result)
  set(patterns ${ARGN})
  list(TRANSFORM patterns APPEND /*.hpp)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${patterns})
  list(FILTER headers EXCLUDE REGEX "_test\\.hpp$")
  set(${result} ${headers} PARENT_SCOPE)
endfunction()

# bezierbench_install_component(COMPONENT target...): the libraries, the export set and the pkg-config file.
function(bezierbench_install_component component)
  foreach(target ${ARGN})
    get_target_property(name ${target} EXPORT_NAME)
    add_library(bezierbench::${name} ALIAS ${target})
  endforeach()
  install(TARGETS ${ARGN} EXPORT bezierbench-${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} NAMELINK_COMPONENT ${component})
  install(EXPORT bezierbench-${component} FILE bezierbench-${component}-targets.cmake NAMESPACE bezierbench::
          DESTINATION ${BEZIERBENCH_CMAKE_DIR} COMPONENT ${component})
  file(RELATIVE_PATH BEZIERBENCH_PREFIX_OF_PC /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
  set(pc ${PROJECT_BINARY_DIR}/package/bezierbench-${component}.pc)
  configure_file(${BEZIERBENCH_PACKAGE_FILES}/bezierbench-${component}.pc.in ${pc} @ONLY)
  install(FILES ${pc} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ${component})
endfunction()
