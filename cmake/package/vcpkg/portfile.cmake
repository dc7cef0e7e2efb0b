# SPDX-License-Identifier: MIT
# The libraries as an overlay port, from the checkout that this file is in:
# vcpkg install bezierbench --overlay-ports=cmake/package/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DBEZIERBENCH_PROGRAM=OFF)
vcpkg_cmake_build(TARGET installed)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME bezierbench CONFIG_PATH lib/cmake/bezierbench)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
