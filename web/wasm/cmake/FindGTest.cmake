# GoogleTest for WebAssembly, from the sources that Debian installs beside its library.
find_path(GTEST_SOURCES src/gtest-all.cc PATHS /usr/src/googletest/googletest NO_CMAKE_FIND_ROOT_PATH)
if(GTEST_SOURCES AND NOT TARGET GTest::gtest_main)
  add_library(bentur_gtest STATIC ${GTEST_SOURCES}/src/gtest-all.cc ${GTEST_SOURCES}/src/gtest_main.cc)
  target_include_directories(bentur_gtest SYSTEM PUBLIC ${GTEST_SOURCES}/include PRIVATE ${GTEST_SOURCES})
  target_compile_features(bentur_gtest PUBLIC cxx_std_20)
  # Tests read and write files of the machine, through node, and are compiled and linked for their own short lives.
  target_compile_options(bentur_gtest INTERFACE -O1)
  target_link_options(bentur_gtest INTERFACE -O1 -sNODERAWFS=1)
  add_library(GTest::gtest_main ALIAS bentur_gtest)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GTest DEFAULT_MSG GTEST_SOURCES)
