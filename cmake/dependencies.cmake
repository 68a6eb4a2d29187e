# Libraries of the distribution. Why each one: docs/decisions.md; the packages that bring them: ./dev. The installed
# package includes this file too.
set(BENTUR_FIND_Eigen3 3.4 NO_MODULE)
set(BENTUR_FIND_Boost CONFIG)  # headers only: math (TOMS 748), random (Sobol)
set(BENTUR_FIND_TBB CONFIG)
set(BENTUR_FIND_MPI COMPONENTS CXX)
set(BENTUR_PKG_netcdf netcdf)
set(BENTUR_PKG_nlopt nlopt)
set(BENTUR_PKG_utf8proc libutf8proc)

# bentur_find(PACKAGE::NAME [REQUIRED|QUIET]): the package that has this target.
macro(bentur_find target)
  if(NOT TARGET ${target})
    string(REGEX REPLACE "::.*" "" bentur_package ${target})
    find_package(${bentur_package} ${BENTUR_FIND_${bentur_package}} ${ARGN})
    if("${target}" MATCHES "^PkgConfig::(.*)" AND PKG_CONFIG_FOUND)
      set(bentur_name ${CMAKE_MATCH_1})
      pkg_check_modules(${bentur_name} ${ARGN} IMPORTED_TARGET GLOBAL ${BENTUR_PKG_${bentur_name}})
    endif()
  endif()
endmacro()
