# SPDX-License-Identifier: MIT
# CPack: the Debian packages libbezierbench-dev, with the components that are for compiling, and bezierbench, with all
# others. `scripts/check package` makes, installs and removes them.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the bezierbench authors <bezierbench@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "methods for Bezier curves, with their errors and times")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/bezierbench RENAME copyright COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/libbezierbench-dev RENAME copyright COMPONENT methods)
get_cmake_property(CPACK_COMPONENTS_ALL COMPONENTS)
set(for_compiling methods reference harness)
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} upper)
  if(component IN_LIST for_compiling)
    set(CPACK_COMPONENT_${upper}_GROUP development)
  else()
    set(CPACK_COMPONENT_${upper}_GROUP program)
  endif()
endforeach()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME bezierbench)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-jinja2, python3-matplotlib") # of `bezierbench report`
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "The program: it judges methods against exact values, times them against each other and reports.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libbezierbench-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libgmp-dev")
if(c IN_LIST CPACK_COMPONENTS_ALL) # it lies in the other package, whose Python module needs its library
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", bezierbench (= ${PROJECT_VERSION})")
endif()
if(harness IN_LIST CPACK_COMPONENTS_ALL) # what it links
  set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
      "libbenchmark-dev, libfmt-dev, libssl-dev, libtbb-dev, libtomlplusplus-dev")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "For C++: header-only methods with proved error bounds, and correctly rounded points.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
