# What `cmake --install` and `cpack` give: the component `program` (the command line, its manual and completions) and the
# component `development` (headers, static libraries, the CMake package and the pkg-config file).
# See docs/design/025-packaging.md.
include(CMakePackageConfigHelpers)

set(layers mesh verify io analysis match use report)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/quadmatch)

set_target_properties(quadmatch_all PROPERTIES EXPORT_NAME quadmatch)
install(TARGETS quadmatch_all EXPORT quadmatch COMPONENT development)
foreach(layer IN LISTS layers)
  install(TARGETS quadmatch_${layer} EXPORT quadmatch ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY include/quadmatch/${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quadmatch COMPONENT development)
endforeach()
install(FILES include/quadmatch/quadmatch.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/quadmatch COMPONENT development)
install(EXPORT quadmatch NAMESPACE quadmatch:: FILE quadmatchTargets.cmake DESTINATION ${package_folder}
        COMPONENT development)

configure_package_config_file(cmake/quadmatchConfig.cmake.in ${CMAKE_BINARY_DIR}/quadmatchConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/quadmatchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/quadmatchConfig.cmake ${CMAKE_BINARY_DIR}/quadmatchConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)

# From the folder of the pkg-config file to the prefix, so that an installed tree may be moved.
file(RELATIVE_PATH package_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(cmake/quadmatch.pc.in ${CMAKE_BINARY_DIR}/quadmatch.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/quadmatch.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/quadmatch RENAME copyright COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libquadmatch-dev RENAME copyright COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME quadmatch)
set(CPACK_PACKAGE_CONTACT "The quadmatch authors <quadmatch@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL development)
if(QUADMATCH_FRONT_ENDS)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME quadmatch)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libquadmatch-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libfmt-dev)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION} (library)")
include(CPack)
