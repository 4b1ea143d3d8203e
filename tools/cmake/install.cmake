# SPDX-License-Identifier: MIT
#
# What a user finds after `cmake --install`: headers, libraries, a CMake package and a pkg-config file. The detail folders
# stay at home, but for the containers of core, which its inline functions use.
include(CMakePackageConfigHelpers)

foreach(folder predicates core refine tools/io)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinkmesh/${folder}
          FILES_MATCHING PATTERN "*.h" PATTERN detail EXCLUDE)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/core/detail/pod_array.h ${PROJECT_SOURCE_DIR}/core/detail/pages.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinkmesh/core/detail)
install(FILES ${PROJECT_SOURCE_DIR}/tools/sinkmesh/sinkmesh.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sinkmesh)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/sinkmesh)
install(EXPORT sinkmesh NAMESPACE sinkmesh:: FILE sinkmeshTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/sinkmeshConfig.cmake.in
  ${PROJECT_BINARY_DIR}/sinkmeshConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sinkmeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sinkmeshConfig.cmake ${PROJECT_BINARY_DIR}/sinkmeshConfigVersion.cmake
        DESTINATION ${package_dir})

# Relative to the file, so that it is right wherever the package is put.
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pkgconfig_to_prefix /prefix/${pkgconfig_dir} /prefix)
if(SINKMESH_CHECKED)
  set(pkgconfig_definitions " -DSINKMESH_CHECKED")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/sinkmesh.pc.in ${PROJECT_BINARY_DIR}/sinkmesh.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/sinkmesh.pc DESTINATION ${pkgconfig_dir})
