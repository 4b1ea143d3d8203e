# SPDX-License-Identifier: MIT
#
# What a user finds after `cmake --install`: headers, libraries, a CMake package and a pkg-config file. Inline public
# headers include some of the detail folders, so these are installed with them.
include(CMakePackageConfigHelpers)

foreach(folder predicates core refine tools/io)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinkmesh/${folder}
          FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/tools/sinkmesh/sinkmesh.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinkmesh)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sinkmesh)
install(EXPORT sinkmesh NAMESPACE sinkmesh:: FILE sinkmeshTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/sinkmeshConfig.cmake.in
  ${PROJECT_BINARY_DIR}/sinkmeshConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sinkmeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sinkmeshConfig.cmake ${PROJECT_BINARY_DIR}/sinkmeshConfigVersion.cmake
        DESTINATION ${package_dir})

configure_file(${CMAKE_CURRENT_LIST_DIR}/sinkmesh.pc.in ${PROJECT_BINARY_DIR}/sinkmesh.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/sinkmesh.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
