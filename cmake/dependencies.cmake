# Libraries of the distribution. Why each one: docs/decisions.md; the packages that bring them: ./dev. The installed
# package includes this file too.
set(BENTUR_FIND_Eigen3 3.4 NO_MODULE)
set(BENTUR_FIND_Boost CONFIG)  # headers only: math (TOMS 748), random (Sobol)
set(BENTUR_FIND_TBB CONFIG)
set(BENTUR_FIND_MPI COMPONENTS CXX)

# bentur_find(PACKAGE::NAME [REQUIRED|QUIET]): the package that has this target.
macro(bentur_find target)
  if(NOT TARGET ${target})
    string(REGEX REPLACE "::.*" "" bentur_package ${target})
    find_package(${bentur_package} ${BENTUR_FIND_${bentur_package}} ${ARGN})
    if("${target}" STREQUAL "PkgConfig::netcdf" AND PKG_CONFIG_FOUND)
      pkg_check_modules(netcdf ${ARGN} IMPORTED_TARGET GLOBAL netcdf)
    endif()
  endif()
endmacro()
