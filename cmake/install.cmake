# The installed package: libraries, their public headers, and benturConfig.cmake for find_package(bentur).
include(CMakePackageConfigHelpers)

get_property(modules GLOBAL PROPERTY BENTUR_MODULES)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bentur)
install(TARGETS ${modules} EXPORT bentur ARCHIVE FILE_SET HEADERS)
install(EXPORT bentur NAMESPACE bentur:: FILE benturTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(cmake/benturConfig.cmake.in ${PROJECT_BINARY_DIR}/benturConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/benturConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/benturConfig.cmake ${PROJECT_BINARY_DIR}/benturConfigVersion.cmake
  DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
