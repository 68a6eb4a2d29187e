# The installed package: libraries, their public headers, and benturConfig.cmake for find_package(bentur).
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bentur)
get_property(modules GLOBAL PROPERTY BENTUR_MODULES)
foreach(module IN LISTS modules)
  install(TARGETS bentur_${module} EXPORT bentur_${module} ARCHIVE FILE_SET HEADERS)
  install(EXPORT bentur_${module} NAMESPACE bentur:: DESTINATION ${package_dir})
  get_property(module_needs GLOBAL PROPERTY BENTUR_NEEDS_${module})
  string(APPEND needs "set(bentur_${module}_needs ${module_needs})\n")
endforeach()
configure_file(cmake/benturConfig.cmake.in ${PROJECT_BINARY_DIR}/benturConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/benturConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/benturConfig.cmake ${PROJECT_BINARY_DIR}/benturConfigVersion.cmake
  DESTINATION ${package_dir})
install(FILES cmake/dependencies.cmake DESTINATION ${package_dir} RENAME benturDependencies.cmake)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
